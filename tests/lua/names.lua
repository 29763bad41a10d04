-- Tests the names of numeric settings, which are the same for studies, samples, fits and sensitivities.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- which would only slow it down.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails = tap.ok, tap.is, tap.near, tap.fails

local mesh = { size = 0.03, height = 0.03, zone = { cylinder = 0.6, plate = 0.6 } }

-- Returns the definition of a pair with a layer. If `k` is given, the bodies have their own coefficients.
local function pair(E, thickness, k)
  return { mesh = mesh, upper = body.cylinder{ name = "pin", k = k },
    lower = body.block{ E = E or 2e5, k = k and 2 * k, layers = { { thickness = thickness or 0.05,
      material = material{ E = 5e4, k = k } } } } }
end
local usual = { cylinder = { k = 1e-8 }, plate = { k = 2e-8 }, mesh = mesh }

-- Tests which field of a definition is changed by each name of a setting.
local function varied(given) return tostring(study(given)):match("varied: (.*)$") end
for _, case in ipairs{
  { "lower.E", "model.lower.E" }, { "plate.E", "model.lower.E" }, { "block.nu", "model.lower.nu" },
  { "pin.E", "model.upper.E" }, { "cylinder.E", "model.upper.E" }, { "model.upper.radius", "model.upper.radius" },
  { "lower.layer1.E", "model.lower.layers.1.material.E" }, { "lower.layers.1.E", "model.lower.layers.1.material.E" },
  { "model.lower.layer1.thickness", "model.lower.layers.1.thickness" }, { "radius", "model.radius" },
  { "E", "model.lower.E, model.upper.E" }, { "load", "load" },
} do
  is(varied{ base = { model = pair() }, vary = { [case[1]] = { 11, 12 } } }, case[2], case[1] .. " in a study")
  if case[1] ~= "E" then
    is(varied{ base = { model = pair() }, sample = { [case[1]] = uniform{ 11, 12 } }, n = 2 }, case[2],
      case[1] .. " in a sample")
  end
end
is(varied{ vary = { ["upper.E"] = { 1e5, 2e5 } } }, "model.cylinder.E",
  "the default pair has the names cylinder and plate")
is(varied{ cases = { {}, { model = { plate = { E = 1e5 } }, E = 2e5 } } }, "model.cylinder.E, model.plate.E",
  "E changes both bodies")
fails(function() study{ sample = { E = uniform{ 1e5, 2e5 } } } end, { "'sample.E'", "model.cylinder.E or model.plate.E" },
  "a name of two settings in a sample")
fails(function() study{ sample = { ["plate.E"] = uniform{ 1, 2 }, ["lower.E"] = uniform{ 1, 2 } } } end,
  { "'sample.lower.E'", "'sample.plate.E'", "model.plate.E" }, "two names of one setting in a sample")
for _, given in ipairs{ { vary = { ["lower.EE"] = { 1, 2 } } }, { sample = { ["lower.EE"] = uniform{ 1, 2 } } } } do
  given.base = { model = pair() }
  fails(function() study(given) end, { "'model.lower.EE'", "did you mean 'E'" },
    "a misspelt setting of a body")
end

-- --- fits ----------------------------------------------------------------------------------------
local base = { jump = 20, geometry = "frozen", k = 1e-8, distance = 100 }
local function with(model)
  local given = { model = model }
  for name, value in pairs(base) do given[name] = value end
  return given
end
local function depths(model)
  local run <close> = wear(with(model)):run{ progress = false }
  local x, y = {}, {}
  for i = 2, #run.history.distance do x[i - 1], y[i - 1] = run.history.distance[i], run.history.depth_plate[i] end
  return { { of = "depth_plate", distance = x, value = y, relative = 0.01 } }
end
for name, found in pairs{ ["model.lower.E"] = { 2e5, 1.5e5, pair(1.5e5) }, ["lower.layer1.thickness"] = { 0.05, 0.06, pair(nil, 0.06) } } do
  local f = fit{ base = with(pair()), unknown = { [name] = found[1] }, data = depths(found[3]) }
  near(f.value[name], found[2], 1e-6, name .. " is fitted")
  f.wear:close()
end
local d = fit.design{ base = with(pair()), unknown = { E = 2e5, ["upper.radius"] = 10, ["lower.layers.1.material.nu"] = 0.3 },
  measure = { { of = "depth_plate", distance = 100, relative = 0.001 } } }
ok(d.all["upper.radius"] < d.prior_error["upper.radius"], "a design with a named setting")
fails(function() fit{ model = pair(), unknown = { ["lower.E"] = 1e5, ["plate.E"] = 1e5 }, data = {} } end,
  { "'unknown.lower.E'", "'unknown.plate.E'", "model.lower.E" }, "two names of one setting as unknowns")
fails(function() fit{ model = pair(), unknown = { ["upper.kind"] = 1 }, data = {} } end,
  { "unknown.upper.kind", "number" },
  "an unknown that is a text")
fails(function() fit{ model = pair(), unknown = { ["lower.layer1.thicknes"] = 1 }, data = {} } end,
  { "thicknes'", "did you mean 'thickness'" }, "a misspelt unknown of a layer")

-- --- sensitivities -------------------------------------------------------------------------------

-- Tests bodies with their own coefficients: the plate's volume depends on the plate's coefficient and on the
-- load.
local function worn(given)
  given.distance, given.jump = 22, 50
  return wear(given):run{ progress = false }
end
local w = worn{ model = usual }
local s = w:sensitivity{ of = "volume_plate" }.volume_plate
near(s["plate.k"].elasticity[1], 1, 1e-10, "sensitivity of the plate's volume to k of the plate")
near(s["cylinder.k"].elasticity[1], 0, 1e-10, "sensitivity of the plate's volume to k of the cylinder")
near(s.load.elasticity[1], 1, 1e-10, "sensitivity of the plate's volume to the load")
fails(function() w:sensitivity{ to = "k" } end, { "'to'", "k follows from", "cylinder.k, plate.k" },
  "sensitivity to k if the bodies have their own coefficients")
w:close()
w = worn{ model = pair(nil, nil, 1e-8) }
s = w:sensitivity{ of = { "depth_pin", "volume_lower" }, to = { "lower.layer1.k", "lower.layer1.thickness", "pin.E", "E" } }
near(s.volume_lower["lower.layer1.k"].elasticity[1], 1, 1e-10, "sensitivity to k of a layer")
ok(s.depth_pin.E.elasticity[1] > s.depth_pin["pin.E"].elasticity[1],
  "sensitivity to E of both bodies and of one body")
ok(s.depth_pin["lower.layer1.thickness"].elasticity[1] < 0, "sensitivity to the thickness of a layer")
fails(function() w:sensitivity{ of = "depth_pen" } end, { "'of'", "depth_pen" },
  "sensitivity of an unknown result")
w:close()
w = worn{ k_cylinder = 1e-8, k_plate = 2e-8 }
s = w:sensitivity{ of = "volume_plate", to = { "k_cylinder", "k_plate", "k" } }.volume_plate
near(s.k_cylinder.elasticity[1], 0, 1e-10, "k_cylinder does not affect the volume of the plate")
near(s.k_plate.elasticity[1], 1, 1e-10, "the volume of the plate is proportional to k_plate")
near(s.k.derivative[1], 2 / 3 * s.k_plate.derivative[1], 1e-10, "k changes the coefficients of both bodies")
-- Tests that a message never suggests a name that is refused.
for _, name in ipairs{ "cylinder.G", "upper.layer1.E", "increments", "model.lower.width" } do
  local refused = fails(function() w:sensitivity{ to = name } end, "'to'", name .. " has no sensitivity")
  ok(not tostring(refused):find("mean '" .. name .. "'", 1, true), name .. " is not suggested")
end
is(require "archard.lib.check".hint("load", { "load" }), " (known: )",
  "a refused name is not suggested from any list")
w:close()

-- Tests continuity: results vary smoothly over sweeps of the input, and inputs that differ by rounding give
-- the same result.

-- Long
local here = arg[0]:match("^(.*)/") or "."
local figures = dofile(here .. "/lib/figures.lua")
local sweep = dofile(here .. "/lib/sweep.lua")(2e-3, 1e-9)

local function worn(definition)
  return function(x)
    local d = { load = 100, stroke = 0.11, distance = 220 }
    for name, value in pairs(definition(x)) do d[name] = value end
    if d.tangential then d.stroke, d.distance = nil, nil end
    local w = wear(d):run()
    return { V = w.volume.total, depth_cylinder = w.depth.cylinder, depth_plate = w.depth.plate, p_center = w.p_center,
      half_width = w.half_width }
  end
end
local function pressed(definition)
  return function(x)
    local c = contact(definition(x))
    return { p_center = c.p_center, p_max = c.p_max, half_width = c.half_width, approach = c.approach }
  end
end
local function fretted(more)
  return worn(function(x)
    local d = { friction = 0.6, tangential = 30, k = 1e-7, cycles = 1000 }
    for name, value in pairs(more(x)) do d[name] = value end
    return d
  end)
end

local of_contact = { "p_center", "p_max", "half_width", "approach" }
local of_run = { "V", "depth_cylinder", "depth_plate", "p_center", "half_width" }
local steel = model{}
sweep("the load of a contact on one mesh", 90, 110, of_contact, pressed(function(x) return { model = steel, load = x } end))
sweep("the load of a contact, automatic meshes", 90, 110, of_contact,
  pressed(function(x) return { load = x } end))
sweep("the plate's position", 0, 0.02, of_contact,
  pressed(function(x) return { model = steel, load = 100, x = x } end))
sweep("the load of a run", 90, 110, of_run, worn(function(x) return { load = x } end))
sweep("the load of an explicit run", 90, 110, of_run, worn(function(x) return { load = x, scheme = "explicit" } end))
sweep("alpha", 0.2, 0.8, { "V", "depth_cylinder", "depth_plate" }, worn(function(x) return { alpha = x } end))
sweep("the plate's E", 200e3, 260e3, of_run, worn(function(x) return { model = { plate = { E = x } } } end))
sweep("the plate's nu", 0.25, 0.4, of_run, worn(function(x) return { model = { plate = { nu = x } } } end))
sweep("fineness", 0.8, 1.6, { "V", "depth_cylinder", "depth_plate" },
  worn(function(x) return { model = { mesh = { fineness = x } } } end))
-- The slip annuli determine the element sizes. The half width of a worn contact therefore varies by 0.15 of
-- an element, and the largest depth, a nodal value, varies too: both are excluded from these sweeps.
sweep("a tangential force", 20, 40, { "V", "p_center" }, fretted(function(x) return { tangential = x } end))
sweep("the plate's E, with friction", 380e3, 450e3, { "V", "p_center" }, fretted(function(x) return { model = { plate = { E = x } } } end))

-- Tests that a load that varies by rounding gives the same result as a constant load.
local function under(load)
  local loading = { tangential = function(t) return 24 * math.sin(2 * math.pi * t) end, load = load, increments = 40 }
  return wear{ friction = 0.6, k = 1e-7, cycles = 1000, jump = "auto", loading = loading }:run().volume.total
end
local steady, rounded = under(function() return 100 end), under(function(t) return 100 * (math.sin(7 * t)^2 + math.cos(7 * t)^2) end)
figures.below(math.abs(rounded / steady - 1), 1e-5,
  "relative change of V by a load with noise of its last bit")

-- Tests contact{}: solutions, pressures, stresses, and worn shapes given as functions, lists and runs.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

-- Returns the integral of p dx over the nodes, which equals the load divided by the thickness.
local function load_of(pressure)
  local sum = 0
  for i = 2, #pressure.x do
    sum = sum + (pressure.p[i] + pressure.p[i - 1]) / 2 * (pressure.x[i] - pressure.x[i - 1])
  end
  return sum
end

local c = contact{}
local h = hertz{}
is(c.load, 100, "default load")
is(c.x, 0, "default position")
near(c.p_center, h.p_max, 5e-3, "the centre pressure agrees with Hertz theory")
near(c.half_width, h.half_width, 3e-2, "the half width agrees with Hertz theory")
ok(c.approach > 0, "approach")
ok(c.iterations >= 1 and math.type(c.iterations) == "integer", "iterations")
near(c.edges.right - c.edges.left, 2 * c.half_width, 1e-12,
  "the distance of the edges is twice the half width")
near(c.edges.left, -c.edges.right, 1e-9, "the edges are symmetric")
for _, body in ipairs{ "cylinder", "plate" } do
  local pressure = c:pressure(body)
  is(#pressure.x, #pressure.p, body .. ": a pressure for each node")
  near(load_of(pressure), 100, 5e-3, body .. ": the pressure carries the load")
end
holds(tostring(c), { "load 100 N", "MPa", "half" }, "print(contact)")

-- Tests stresses.
local s = c:stress()
is(s.contact, c, "a stress object refers to its contact")
for body, field in pairs(s) do
  local nodes = c.model.mesh[body].nodes
  for _, name in ipairs{ "x", "y", "ux", "uy", "sxx", "syy", "szz", "sxy", "mises", "shear" } do
    is(#field[name], nodes, body .. ": " .. name .. " at every node")
  end
  is(#field.elements, 4 * c.model.mesh[body].elements_count, body .. ": elements")
  local largest, at = 0, 0
  for i, value in ipairs(field.mises) do
    if value > largest then largest, at = value, i end
  end
  near(largest, 0.5575 * h.p_max, 3e-2, body .. ": largest von Mises stress")
  near(math.abs(field.y[at]), 0.704 * h.half_width, 0.25, body .. ": depth of the largest von Mises stress")
end
holds(tostring(s), { "cylinder", "plate", "mises up to" }, "print(stress)")

-- Tests definitions.
near(contact{ load = 25 }.half_width, h.half_width / 2, 6e-2, "a quarter of the load halves the half width")
ok(contact{ load = 100 }.model.mesh.plate.nodes == c.model.mesh.plate.nodes,
  "equal loads give equal default meshes")
near(contact{ load = 25 }.model.mesh.size, 0.01, 1e-12,
  "the element size is proportional to the contact width")
near(contact{ load = 25, model = { mesh = { fineness = 2 } } }.model.mesh.size, 0.005, 1e-12,
  "fineness = 2 halves the elements")
is(contact{ x = 0.1 }.x, 0.1, "position")
near(contact{ model = { radius = 5 } }.half_width, hertz{ radius = 5 }.half_width, 8e-2,
  "a model given as a table")
ok(contact{ load = 3000 }.model.mesh.zone.plate > 1.2, "a heavy load widens the meshed zone")
near(contact{ model = model{}, load = 5000 }.p_max, contact{ load = 5000 }.p_max, 0.01,
  "a model object is meshed again with wider zones")
do -- the zone sizes that the message suggests are sufficient
  local narrow = { size = 0.02, zone = { cylinder = 0.2, plate = 0.3 } }
  local why = fails(function() contact{ model = { mesh = narrow }, load = 1000, x = 0.1 } end, "this contact needs mesh.zone",
    "the message names the required zones")
  narrow.zone.cylinder, narrow.zone.plate = why.message:match("{cylinder = ([%d.]+), plate = ([%d.]+)} mm")
  narrow.zone = { cylinder = tonumber(narrow.zone.cylinder), plate = tonumber(narrow.zone.plate) }
  ok(math.abs(contact{ model = { mesh = narrow }, load = 1000, x = 0.1 }.p_max / 1871.3 - 1) < 1e-3,
    "the suggested zones contain the contact")
end
is(fails(function() contact{ model = { mesh = { zone = { cylinder = 0.4, plate = 0.4 } } }, load = 5000 } end, "zone", "once more").code, "ZONE",
  "error code of a zone that is too small")

-- Tests the contact of bodies whose worn shape is given by functions, lists or runs.
local function scar(x) return math.max(0, 1e-3 * (1 - (x / 0.3) ^ 2)) end
local worn = contact{ worn = { cylinder = scar } }
ok(worn.p_center < 0.9 * c.p_center, "a worn cylinder lowers the pressure")
local x, depth = {}, {}
for i = -400, 400 do
  x[#x + 1] = i / 1000
  depth[#depth + 1] = scar(i / 1000)
end
local sampled = contact{ worn = { cylinder = { x = x, h = depth } } }
near(sampled.p_center, worn.p_center, 1e-3, "the same profile as a list of points")
local short = contact{ worn = { cylinder = { x = { -0.02, 0.02 }, h = { 1e-3, 1e-3 } } } }
ok(short.p_center < 100, "the surface is unworn beyond the ends of a profile")
local even = contact{ worn = { plate = function() return 0.01 end } }
near(even.p_center, c.p_center, 1e-9, "uniform wear of the plate does not change the pressure")

local w = wear{}
w:step(3)
is(contact{ worn = w }.p_center, w.p_center, "the worn shape of a run gives the same bits")
ok(contact{ worn = w }.model == w.model, "the contact uses the model of the run")
local other = contact{ model = { mesh = { height = 0.02 } }, worn = w }
near(other.p_center, w.p_center, 2e-2, "the worn shape of a run on another mesh")
local copy = contact{ worn = { cylinder = w:profile("cylinder"), plate = w:profile("plate") } }
near(copy.p_center, w.p_center, 2e-3, "profiles of a run as worn shapes")

-- Tests that invalid worn shapes are refused.
fails(function() contact{ worn = { pin = scar } } end, "unknown field 'worn.pin'",
  "a worn shape of an unknown body")
fails(function() contact{ worn = { plate = 1 } } end, "field 'worn.plate': expected a function",
  "a number instead of a profile")
fails(function() contact{ worn = { plate = { x = { 1, 2 } } } } end,
  "field 'worn.plate.h': expected an array of numbers, got nil", "a profile without depths")
fails(function() contact{ worn = { plate = { x = { 0, 1, 2 }, h = { 0, 0 } } } } end,
  "equal length", "a profile with fewer depths than points")
fails(function() contact{ worn = { plate = { x = { 0, 0 }, h = { 0, 0 } } } } end,
  "field 'worn.plate.x[2]': expected increasing x", "a profile whose x does not increase")
fails(function() contact{ worn = { plate = { x = { 0, 1 }, h = { 0, 0 / 0 } } } } end,
  "field 'worn.plate.h[2]': expected a finite number", "NaN in a profile")
fails(function() wear{ geometry = "frozen", worn = { plate = { x = { -9, 9 }, h = { 0, 1e40 } } } } end,
  "wear: the plate's wear at x = -0.58 mm is 1.11111e+37 mm, at most 1e+06 mm are allowed",
    "a depth too large for accurate gaps")
fails(function() contact{ worn = { plate = { x = { 0, 1 }, h = { 0, -1 } } } } end,
  "field 'worn.plate.h[2]': expected a depth >= 0", "a negative depth in a profile")
local err = fails(function() contact{ worn = { plate = function(at) return at.y end } } end,
  { "worn.plate(", "attempt to index" }, "an error in the function of a worn shape")
is(err.code, "CALLBACK", "error code of a failed function")
holds(err.cause, { "attempt to index", "stack traceback" }, "the cause of a failed function has a traceback")
fails(function() contact{ worn = { plate = function() return "deep" end } } end,
  'expected a depth >= 0 in mm, got "deep"', "a worn shape function that returns a text")
fails(function() contact{ worn = { plate = function() return -1 end } } end, "got -1",
  "a worn shape function that returns a negative depth")

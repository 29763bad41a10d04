-- Tests user-defined bodies: definitions, refusals, studies and run files.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails = tap.ok, tap.is, tap.near, tap.fails

local coarse = { size = 0.1, height = 0.1, far = 2, zone = { cylinder = 4, plate = 5 } }
local pin = { upper = body.disc{ radius = 9.5, k = 1e-8 }, lower = body.ring{ inner = 10, outer = 15, E = 20e3, nu = 0.4 }, mesh = coarse }

-- Tests that bodies of all kinds can be defined.
local m = model(pin)
is(m.upper.kind, "disc", "kind of the upper body")
is(m.lower.outer, 15.0, "outer radius of the lower body")
is(m.plate.E, 20e3, "the material of the lower body is the plate's material")
is(model{ mesh = coarse }.upper, nil, "the default pair has no user-defined body")
is(contact{ model = { upper = m.upper, lower = m.lower, mesh = coarse }, load = 10 }.p_max, contact{ model = m, load = 10 }.p_max,
  "bodies of a model give the same model again")
local layered = model{ lower = body.block{ layers = { { thickness = 0.05, material = material{ E = 1e5, k = 1e-9 } } } }, mesh = coarse }
is(layered.lower.layers[1].E, 1e5, "material of a layer")
is(layered.lower.layers[1].thickness, 0.05, "thickness of a layer")
local listed = model{ upper = body.profile{ x = { -1, 0, 1 }, y = { 0, 0.01, 0 } , width = 10 }, mesh = coarse }
near(listed.upper.y[2], 0.01, 1e-15, "heights of a profile given as a list")
local trace = { x = {}, z = {} }
for i = 1, 21 do trace.x[i], trace.z[i] = (i - 11) / 10, 1e-3 * math.cos(i) end
local traced = body.profile(profile(trace))
ok(traced.x[3] == trace.x[3] and traced.y[3] == trace.z[3], "points of a profile given as a measured trace")
local soft = body.profile{ y = profile(trace), E = 3e3, width = 10 }
ok(soft.y[3] == trace.z[3] and soft.x[21] == 1 and soft.E == 3e3, "a measured trace as field y beside other fields")
is(model{ geometry = "plane", mesh = { size = 0.2, height = 0.2 } }.geometry, "plane strain",
  "geometry plane means plane strain")

-- Tests that bodies are addressed by their name, role or kind.
local called = model{ upper = body.disc{ radius = 9.5, k = 1e-8, name = "pin" },
  lower = body.ring{ inner = 10, outer = 15, name = "bush" }, mesh = coarse }
local run_of = wear{ model = called, load = 20, stroke = 0.5, distance = 40, jump = 10 }
run_of:run{ depth = { pin = 1e-7 } }
near(run_of.depth.pin, 1e-7, 1e-8, "an end condition and a result by the name of a body")
for _, word in ipairs{ "upper", "disc", "cylinder" } do is(run_of.depth[word], run_of.depth.pin,
  "depth of the upper body by " .. word) end
for _, word in ipairs{ "lower", "ring", "plate" } do is(run_of.volume[word], run_of.volume.bush,
  "volume of the lower body by " .. word) end
local keys = {}
for key in pairs(run_of.depth) do keys[#keys + 1] = key end
table.sort(keys)
is(table.concat(keys, " "), "bush pin", "a loop over depths visits only the names of the bodies")
is(run_of:profile("bush").x[1], run_of:profile("lower").x[1], "methods accept all names of a body")
is(run_of.history.depth_pin[#run_of.history.p_max], run_of.depth.pin,
  "a history has columns by the names of the bodies")
is(run_of.history.volume_lower[2], run_of.history.volume_plate[2],
  "a history has columns by the roles of the bodies")
fails(function() return run_of.history.depth_bash end, "no field 'depth_bash'", "an unknown column")
local zones = model{ upper = called.upper, lower = called.lower, mesh = { size = 0.1, height = 0.1, zone = { pin = 4, lower = 5 } } }.mesh.zone
ok(zones.cylinder == 4 and zones.plate == 5, "zones of a mesh by the names of the bodies")
is(called.mesh.pin.body, "pin", "a mesh has the name of its body")
is(called.bodies.ring, "bush", "model.bodies contains the names")
is(called.upper.name, "pin", "name of the upper body")
ok(tostring(run_of):find("pin (disc of radius ", 1, true) and tostring(run_of):find("bush 0.0000e+00 mm3", 1, true),
  "print of a run uses the names of the bodies")
ok(tostring(contact{ model = called, load = 20 }:stress()):find("\n  bush ", 1, true),
  "print of stresses uses the names of the bodies")
local dug = contact{ model = called, load = 20, worn = { bush = function(x) return x * x * 1e-4 end } }
ok(dug.p_center > contact{ model = called, load = 20 }.p_center, "a worn shape by the name of a body")
local turned = model{ upper = body.block{}, lower = body.cylinder{ radius = 10 }, mesh = { size = 0.2, height = 0.2 } }
is(turned.bodies.lower, "lower", "a lower cylinder is not called by its kind")
fails(function() contact{ model = turned }:pressure("cylinder") end, { "'body'", "block" }, "a name that could mean both bodies")
fails(function() return run_of.depth.bash end, "did you mean 'bush'", "an unknown name")
fails(function() run_of:profile("hip") end, { '"pin" or "bush"', "hip" }, "a profile of an unknown body")

-- Tests that the stresses in a ring have the magnitude of the contact pressure.
local c = contact{ model = m, load = 50 }
local worst = 0
local field = c:stress()
for _, v in ipairs(field.plate.mises) do worst = math.max(worst, v) end
ok(worst > 0.3 * c.p_max and worst < c.p_max, "stresses in a ring have the magnitude of the contact pressure")

-- Tests that run files contain the bodies, and that runs saved halfway and opened again have results
-- identical to the bit with runs without a break.
local file = os.tmpname()
os.remove(file)
local function run(distance) return wear{ model = m, load = 20, stroke = 0.5, distance = distance, jump = 10 } end
local whole = run(400)
whole:run()
local part = run(400)
part:run{ cycles = 200 }
part:save(file)
local later = wear.open(file)
later:run()
is(("%a %a"):format(later.depth_cylinder, later.p_center), ("%a %a"):format(whole.depth_cylinder, whole.p_center),
  "a pin in a ring, opened from a run file, continues with the same results to the bit")
os.remove(file)
local waves = wear{ model = { upper = body.profile{ width = 10, y = function(x) return 1e-3 * math.cos(x) end }, mesh = coarse },
  load = 50, stroke = 0.5, distance = 20, k = 1e-8 }
waves:run()
waves:save(file)
is(wear.open(file).model.upper.y[7], waves.model.upper.y[7], "a profile is stored in the run file")
os.remove(file)
run_of:save(file)
is(wear.open(file).depth.pin, run_of.depth.pin, "names of bodies are stored in the run file")
os.remove(file)

-- Tests a study that varies a body of an existing model.
local varied = study{ base = { model = layered, load = 1000, distance = 1 }, vary = { ["model.lower.E"] = { 1e5, 2e5 } } }
local of_both = varied:run{ file = file, workers = 1, progress = false }:cases()
ok(of_both[1].last.p_center < of_both[2].last.p_center, "a study varies E of a body")
varied:close()
os.remove(file)

-- Tests rotations, and loads at an angle.
local function swinging(distance)
  return wear{ model = m, load = 20, distance = distance, jump = 10, load_angle = 2, loading = {
    rotation = function(t) return 2 * math.sin(2 * math.pi * t) end, load_angle = function(t) return 1 + t - t * t end } }
end
whole = swinging(400)
near(whole.stroke, 4 * math.rad(10), 1e-3, "the stroke of a rotation is a distance along the hole")
near(whole.loading[1].rotation[26], 2, 1e-12, "rotation of a loading in degrees")
near(whole.loading[1].load_angle[51], 1.25, 1e-12, "angle of the load in degrees")
whole:run()
near(whole.volume.upper, whole.k * whole.load_distance, 1e-12,
  "V is k times the integral of the normal force over the distance")
part = swinging(400)
part:step(5)
part:save(file)
later = wear.open(file)
later:run()
is(("%a %a"):format(later.depth_cylinder, later.p_center), ("%a %a"):format(whole.depth_cylinder, whole.p_center),
  "a rotating pin, opened from a run file, continues with identical bits")
os.remove(file)
local list = { 0, 1, 2, 1, 0, -1, -2, -1, 0 }
is(#wear{ model = m, load = 20, loading = { rotation = list, load_angle = list },
  distance = 3 }.loading[1].rotation, 9,
  "rotation and load angle given as lists")
local again = swinging(400)
is(wear{ model = m, load = 20, distance = 400, jump = 10, load_angle = 2, loading = again.loading }.loading[1].load_angle[7],
  again.loading[1].load_angle[7], "the loading of a run used for another run")

local coat = contact{ load = 50, model = { lower = body.block{ layers = { { thickness = 0.3, E = 1e5, nu = 0.2 } } },
  mesh = { size = 0.1, height = 0.1, far = 2, zone = { cylinder = 4, plate = 5 } } } }
local f = coat:stress().plate
local top, deep = 1, 1
for i, y in ipairs(f.y) do
  if f.mises[i] > f.mises[top] and y > -0.2 then top = i end
  if y < f.y[deep] then deep = i end
end
near(f.szz[top], 0.2 * (f.sxx[top] + f.syy[top]), 1e-12, "stress out of the plane uses nu of the layer")
near(f.szz[deep], 0.3 * (f.sxx[deep] + f.syy[deep]), 1e-12, "stress out of the plane uses nu of the base")

-- Near the axis of a body of revolution, the hoop stress approaches the radial stress, in a layer as well.
local hard = contact{ load = 50, model = { geometry = "axisymmetric", lower = body.block{ layers = { { thickness = 0.1, E = 6e5 } } } } }
f = hard:stress().plate
local next_to_axis
for i, x in ipairs(f.x) do
  if f.y[i] == 0 and x > 0 and (not next_to_axis or x < f.x[next_to_axis]) then next_to_axis = i end
end
near(f.szz[next_to_axis], f.sxx[next_to_axis], 0.005, "hoop stress in a layer, next to the axis")

-- Tests exported input decks: layers have their own materials, and bodies their names.
local lined = contact{ load = 50, x = 1, model = { upper = body.disc{ radius = 9.5, name = "pin" }, mesh = coarse,
  lower = body.ring{ inner = 10, outer = 15, name = "bush", layers = { { thickness = 0.3, E = 1e5 } } } } }
export.inp(lined, file .. ".inp")
local deck = assert(io.open(file .. ".inp")):read("a")
for i, line in ipairs{ "pin on bush", "ELSET=plate-layer-1, MATERIAL=plate-layer-1", "ELSET=plate-base, MATERIAL=plate-base",
  "MATERIAL, NAME=plate-layer-1\n*ELASTIC\n100000, 0.3" } do
  ok(deck:find(line, 1, true), "a deck contains bodies and layers, line " .. i)
end
os.remove(file .. ".inp")

fails(function() export.inp(contact{ model = m, load = 50, load_angle = 3 }, file .. ".inp") end, { "'load_angle'", "deck" },
  "a deck of a load at an angle")

-- Tests pictures of a pair with a hole, unrolled along the circumference.
local unrolled = file .. ".txt"
plot.mesh(called, { unrolled = true, file = unrolled })
plot.stress(lined, { unrolled = true, body = "bush", file = unrolled })
os.remove(unrolled)
fails(function() plot.mesh(listed, { unrolled = true }) end, { "'unrolled'", "hole" },
  "an unrolled picture without a hole")

-- Tests that invalid definitions of bodies are refused.
local function refused(parts, what, f) fails(f, parts, what) end
refused({ "body.cylinder", "'width'", "radius" }, "a field of another body", function() body.cylinder{ width = 3 } end)
refused({ "'radius'", "> 0 mm", "-1" }, "a negative radius", function() body.cylinder{ radius = -1 } end)
refused({ "'name'", "letters", '"3s"' },
  "a name that starts with a digit", function() body.disc{ radius = 9, name = "3s" } end)
refused({ "'name'", "letters", "got 3" },
  "a number as a name", function() body.disc{ radius = 9, name = 3 } end)
refused({ "'name'", "letters" }, "a name that is too long", function() body.disc{ radius = 9, name = ("x"):rep(32) } end)
for _, word in ipairs{ "upper", "plate", "total", "ring", "size" } do
  refused({ "'name'", "other than a kind of body", word },
    "a name with another meaning", function() body.disc{ radius = 9, name = word } end)
end
refused({ "'lower.name'", '"a"' }, "two bodies with the same name", function()
  model{ upper = body.disc{ radius = 9, name = "a" }, lower = body.ring{ inner = 10, outer = 20, name = "a" } }
end)
refused({ "'worn.", "twice" }, "a worn shape given twice for one body", function()
  local h = function() return 0 end
  contact{ model = called, worn = { bush = h, lower = h } }
end)
refused({ "inner", "outer", "12 and 10" },
  "a ring whose inner radius is larger than the outer", function() body.ring{ inner = 12, outer = 10 } end)
refused({ "'flat'" }, "a punch without a flat", function() body.punch{ radius = 1 } end)
local usual_punch = model{ upper = body.punch{ flat = 1 }, lower = body.block{ width = 30 }, mesh = { size = 0.2 } }
is(usual_punch.upper.flat, 1.0, "the default height of a punch contains its rounded edges")
refused({ "'height'", "radius / 0.9" },
  "a punch lower than its rounded edges", function() body.punch{ flat = 1, radius = 2, height = 1 } end)
local sharp = contact{ load = 500, model = { upper = body.punch{ flat = 10, radius = 1, height = 10 }, lower = body.block{ width = 30, height = 15 },
  mesh = { size = 0.1 } } }
ok(sharp.half_width > 5 and sharp.half_width < 5.11,
  "a punch with small edge radii touches over its whole flat")
near(sharp.p_center, 39.24, 5e-3, "the pressure agrees with elements a seventh as large")
local zoned, why = pcall(model, { upper = body.punch{ flat = 10, radius = 0.5, height = 10 }, mesh = { size = 0.1, zone = { cylinder = 11, plate = 12 } } })
ok(not zoned and tostring(why):find("flat + 1.6 radius = 10.8 mm", 1, true),
  "a zone that ends within the rounded edges is refused")
refused({ "larger than the bodies allow", "28 mm", "80 degrees to either side" },
  "a pin that rotates beyond its zone", function()
  wear{ model = { upper = body.disc{ radius = 9.95 }, lower = body.ring{ inner = 10, outer = 20 } }, load = 1000, k = 1e-7,
    distance = 20, scheme = "explicit", loading = { rotation = function(t) return 75 * math.sin(2 * math.pi * t) end } }
end)
refused({ "'y'" }, "a profile without heights", function() body.profile{ width = 3 } end)
refused({ "'x'" }, "heights without positions", function() body.profile{ y = { 1, 2 } } end)
refused({ "x", "increasing", "1 after 1" },
  "equal positions of a profile", function() body.profile{ x = { 1, 1 }, y = { 0, 0 } } end)
refused({ "within half" },
  "a profile higher than half of its body", function() body.profile{ x = { 0, 1 }, y = { 0, 9 } } end)
refused({ "'layers'", "at most 4" }, "too many layers", function() body.block{ layers = { {}, {}, {}, {}, {} } } end)
refused({ "layers[1].thickness", "nil" },
  "a layer without a thickness", function() body.block{ layers = { { E = 3 } } } end)
refused({ "layers[1]", "nue" },
  "an unknown field of a layer", function() body.block{ layers = { { thickness = 1, nue = 3 } } } end)
refused({ "did you mean 'thickness'" }, "a misspelt field of a layer", function() body.block{ layers = { { thicknes = 1 } } } end)
refused({ "did you mean 'radius'" }, "a symbol instead of a name", function() body.cylinder{ R = 6 } end)
refused({ "layers", "0.9" }, "layers thicker than the body", function() body.block{ layers = { { thickness = 30, E = 3 } } } end)
refused({ "layers'", "a list", "not a list" },
  "a layer instead of a list of layers", function() body.block{ layers = { thickness = 1, E = 3 } } end)
refused({ "layers'", "not a list" },
  "a list of layers with a gap", function() body.block{ layers = { [2] = { thickness = 1, E = 3 } } } end)
refused({ "'layers[1].material'", "got nil" }, "a layer without a material", function() body.block{ layers = { { thickness = 1, k = 1e-9 } } } end)
refused({ "'layers[1].material'", "'layers[1].k'", "both" }, "k beside the material of a layer", function()
  body.block{ layers = { { thickness = 1, k = 1e-9, material = material{ E = 3 } } } }
end)
refused({ "'material'", "'E'", "both" }, "E beside a material", function() body.block{ E = 1e3, material = material{} } end)
refused({ "'upper'", "'cylinder'", "both" }, "a material beside a body", function() model{ upper = body.cylinder{ E = 1 }, cylinder = { E = 2 } } end)
refused({ "'model.lower'", "'model.plate'" },
  "a material beside a lower body", function() contact{ model = { lower = body.block{},
    plate = { k = 1e-9 } } } end)
refused({ "upper", "a body" }, "a number instead of a body", function() model{ upper = 3 } end)
refused({ "upper.kind", "body.cylinder" },
  "a table instead of a body", function() model{ upper = { radius = 3 } } end)
-- --- supports of a pin ---------------------------------------------------------------------------

local function held(hold)
  local m = model{ upper = hold == "disc" and body.disc{ radius = 9.95 } or body.cylinder{ radius = 9.95, hold = hold },
    lower = body.ring{ inner = 10, outer = 20 }, mesh = { size = 0.4, height = 0.2, far = 2, zone = { cylinder = 15, plate = 15 } } }
  return contact{ model = m, load = 1000 }
end
local rigid, hub, free = held "fixed", held "hub", held "free"
is(hub.p_center, held "disc".p_center, "a pin held at its hub gives the pressure of a disc")
ok(free.p_center < 0.995 * rigid.p_center and free.half_width > rigid.half_width,
  "a pin that is free sideways has a wider contact in its hole")
is(rigid.model.upper.hold, "fixed", "the default support is fixed")
is(free.model.upper.hold, "free", "the model contains the given support")
refused({ "'hold'", '"fixed", "hub" or "free"' },
  "an unknown support", function() body.cylinder{ hold = "loose" } end)
local deck_name = os.tmpname()
export.inp(contact{ load = 50, model = { upper = body.cylinder{ hold = "free" }, lower = body.block{}, mesh = { size = 0.2, height = 0.2 } } },
  deck_name .. ".inp")
local deck = assert(io.open(deck_name .. ".inp")):read "a"
ok(deck:find("cylinder-fixed, 2, 2", 1, true) and not deck:find("cylinder-fixed, 1, 1", 1, true) and deck:find("\n%d+, 1, 1\n"),
  "a deck of a free pin fixes only the middle of its flat along x")
os.remove(deck_name)
os.remove(deck_name .. ".inp")
refused({ "hole's radius 10", "got 10" },
  "a pin as wide as its hole", function() model{ upper = body.disc{ radius = 10 },
    lower = body.ring{ inner = 10, outer = 20 } } end)
refused({ "got a block" }, "a block in a hole", function() model{ upper = body.block{}, lower = body.ring{ inner = 10, outer = 20 } } end)
refused({ "'load_angle'", "hole", "got 3" },
  "a load at an angle on a plate", function() contact{ load_angle = 3 } end)
refused({ "'load_angle'", "hole", "got 3" },
  "a run with a load at an angle on a plate", function() wear{ load_angle = 3 } end)
refused({ "rotation'", "ring" }, "a rotation of a plate", function() wear{ loading = { rotation = list }, distance = 1 } end)
refused({ "load_angle'", "ring" },
  "a loading with a load angle on a plate",
    function() wear{ loading = { x = list, load_angle = 4 }, distance = 1 } end)
refused({ "load_angle", "(-90, 90) degrees", "got 120" }, "a load angle of 120 degrees", function()
  wear{ model = m, loading = { rotation = list, load_angle = 120 }, distance = 1 }
end)
refused({ "'load_angle'", "(-90, 90) degrees", "got 90" },
  "a load angle of 90 degrees", function() contact{ model = m, load_angle = 90 } end)
refused({ "'loading.x'", "'loading.rotation'" },
  "positions and rotation together", function() wear{ model = m, loading = { x = list, rotation = list },
    distance = 1 } end)
refused({ "moves", "degrees" },
  "a constant rotation", function() wear{ model = m, loading = { rotation = { 1, 1, 1 } }, distance = 1 } end)
refused({ "loading.rotation'", "got nil" }, "a load angle without a rotation", function()
  wear{ model = m, loading = { load_angle = function(t) return t end }, distance = 1 }
end)
refused({ "zone.", "given twice" }, "a zone given twice", function() model{ mesh = { zone = { upper = 4, cylinder = 2 } } } end)
refused({ "'friction'", "in a hole" }, "a run with friction in a hole", function() wear{ model = m, friction = 0.3, load = 10, stroke = 0.1 } end)
refused({ "'friction'", "in a hole" }, "friction in a hole", function() contact{ model = m, friction = 0.1, load = 10 } end)

-- Tests that names of bodies are also used in functions of the state, in studies and in pictures of the
-- history.
local hip = { upper = body.disc{ radius = 9.95, name = "pin" }, lower = body.ring{ inner = 10, outer = 20, name = "bush" },
  mesh = { size = 0.5, height = 0.3, zone = { cylinder = 20, plate = 20 } } }
local of_hip = { model = hip, load = 1000, stroke = 1, cycles = 2, jump = 1, increments = 10 }
local depths = {}
wear{ model = hip, load = 1000, stroke = 1, cycles = 2, jump = 1, increments = 10, k = function(state)
  depths = { state.depth.pin, state.depth.upper, state.depth.cylinder, state.volume.bush, state.volume.total }
  return 1e-7
end }:run()
ok(depths[1] > 0 and depths[1] == depths[2] and depths[1] == depths[3], "state.depth by name, role and kind")
ok(depths[4] > 0 and depths[5] > depths[4], "state.volume by name")
local file = os.tmpname()
os.remove(file)
local hips = study{ base = of_hip, vary = { alpha = { 0.3, 0.5 } } }:run{ file = file, workers = 1, progress = false }
local case = hips:cases()[2]
ok(case.depth.pin > 0 and case.depth.pin == case.last.depth_cylinder, "depth of a case by name")
is(case.volume.bush, case.last.volume_plate, "volume of a case by name")
is(case.volume.total, case.volume.pin + case.volume.lower, "total volume of a case")
is(#case:profile("bush").h, #case:profile("lower").h, "profile of a case by name")
is(case.model.bodies.upper, "pin", "case.model.bodies")
fails(function() case:profile("plug") end, '"pin" or "bush"', "profile of a case by an unknown name")
fails(function() return case.depth.plug end, "plug", "unknown body in the depths of a case")
local picture = file .. ".txt"
plot.history(case, "depth_pin", "depth_bush", { file = picture, term = "dumb" })
local drawn = io.open(picture):read("a")
ok(drawn:find(" pin ", 1, true) and drawn:find(" bush", 1, true), "plot.history and its key use the bodies' names")
fails(function() plot.history(case, "depth_plug") end, "no column 'depth_plug'",
  "plot.history of an unknown column")
os.remove(picture)
hips:close()
os.remove(file)

-- Tests that the help of a body names the fields of its constructor.
local describe = require "archard.help"
for _, kind in ipairs{ "cylinder", "ball", "block", "punch", "profile", "disc", "ring" } do
  local _, problem = pcall(body[kind], { zork = 1 })
  local known = tostring(problem):match "%(known: (.-), name,"
  local shown = tostring(describe.text("body." .. kind)):gsub("%s+", " ")
  ok(known and shown:find("Fields: " .. known, 1, true), ("help of body.%s names %s"):format(kind, tostring(known)))
end

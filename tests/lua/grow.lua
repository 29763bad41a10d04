-- Tests runs that need a larger mesh: a wider or deeper mesh is built, and the worn surfaces are transferred.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local is, ok = tap.is, tap.ok
local warnings = require "archard.warnings"

local function off(a, b) return math.abs(a / b - 1) end

-- A growing contact is computed on a small mesh and on a mesh that is large enough from the start.
local fields = { alpha = 1, k = 3e-8, load = 100, jump = 40 }
local function mesh(cylinder, plate, rows)
  return model{ mesh = { size = 0.04, height = rows and 0.02, zone = { cylinder = cylinder, plate = plate }, rows = rows } }
end
local function run_on(m, more)
  local given = { model = m }
  for name, value in pairs(fields) do given[name] = value end
  for name, value in pairs(more or {}) do given[name] = value end
  return wear(given)
end

local small, large = mesh(0.8, 1), mesh(2, 2.2)
local w, held = run_on(small), run_on(large)
local before = w.model
local changed
while not w.done do
  local at = w.p_center
  w:step()
  held:step()
  if not changed and w.model.mesh.zone.cylinder > 0.8 then changed = { at, w.p_center, held.p_center } end
end
ok(changed, "the contact becomes wider than the zone")
ok(changed and off(changed[2], changed[3]) < 0.002, "the enlargement changes the pressure by less than 0.2 %")
ok(off(w.volume.total, 3e-8 * 100 * 1320) < 1e-9, "the volume is exact")
ok(off(w.depth.cylinder, held.depth.cylinder) < 1e-3, "the depth equals the depth on the large mesh")
ok(off(w.p_center, held.p_center) < 0.002, "the pressure equals the pressure on the large mesh")
local elements = w.history.elements
ok(elements[1] < elements[#elements] and held.history.elements[1] == held.elements, "the history contains the number of elements")
is(before.mesh.zone.cylinder, 0.8, "the model of the user is unchanged")

-- Tests that symmetric runs remain exactly symmetric, so that half of the contact solutions of a stroke are
-- sufficient.
local function unevenness(run)
  local uneven = 0
  for _, body in ipairs{ "cylinder", "plate" } do
    local p = run:profile(body)
    for i = 1, #p.h do
      local image = #p.h + 1 - i
      uneven = math.max(uneven, math.abs(p.h[i] - p.h[image]), math.abs(p.worn_x[i] + p.worn_x[image]))
    end
  end
  return uneven
end
local both = wear{ k = 1e-5, distance = 50 }:run()
ok(both.model.mesh.size > model{}.mesh.size, "the elements of a moving contact grow with it")
is(unevenness(both), 0.0, "a symmetric run remains exactly symmetric on the larger mesh")
for name, given in pairs{ ["alpha = 1"] = { alpha = 1, k = 1e-7, distance = 300 }, ["slide = z"] = { slide = "z", k = 1e-7, distance = 440 },
  ["explicit steps"] = { slide = "z", scheme = "explicit", distance = 440 },
  ["a ball on a track"] = { load = 50, distance = 300, track = 20, slide = "z", model = { geometry = "axisymmetric" } } } do
  is(unevenness(wear(given):run()), 0.0, "a symmetric contact at rest remains exactly symmetric: " .. name)
end
ok(unevenness(wear{ slide = "z", distance = 100, load_angle = 20, load = 500, model = { upper = body.disc{ radius = 9.95 },
  lower = body.ring{ inner = 10, outer = 20 } } }:run()) > 1e-5, "an oblique load wears asymmetrically")

-- Tests a wear box with too few rows of elements: the run adds rows.
local flat = run_on(mesh(2, 2.2, 1), { k = 2e-7, distance = 800, jump = 4 })
local deep = run_on(mesh(2, 2.2, 3), { k = 2e-7, distance = 800, jump = 4 })
flat:run()
deep:run()
ok(flat.model.mesh.rows > 1, "rows are added to the wear box")
local rows = flat.history.box_rows
is(rows[1] .. " " .. rows[#rows], "1.0 " .. flat.model.mesh.rows .. ".0", "the history contains the number of rows")
ok(off(flat.volume.total, deep.volume.total) < 1e-9, "a wear box with added rows: volume")
ok(off(flat.p_center, deep.p_center) < 0.002, "a wear box with added rows: pressure")

-- Tests that a run saved before or after the enlargement of its mesh continues with identical bits.
local path = os.tmpname()
os.remove(path)
local a = run_on(small)
a:run{ distance = 300 }
a:save(path)
local b = wear.open(path)
a:run()
b:run()
is(b.p_center, a.p_center, "a run saved before the enlargement continues with identical bits")
ok(b.model.mesh.zone.cylinder == a.model.mesh.zone.cylinder and b.model.mesh.zone.cylinder > 0.8,
  "a run saved before the enlargement has the same final mesh")
a:save(path)
local c = wear.open(path)
c:run{ distance = 1500 }
a:run{ distance = 1500 }
is(c.p_center, a.p_center, "a run saved after the enlargement continues with identical bits")
is(c.model.mesh.zone.cylinder, a.model.mesh.zone.cylinder,
  "a run saved after the enlargement has its enlarged mesh")
os.remove(path)

-- Tests w:set with values that need a larger mesh.
local s = wear{}
s:run{ distance = 100 }
local volume = s.volume.total
warnings.keep()
s:set{ stroke = 1.2, scheme = "explicit", jump = "auto" }
ok((warnings.take() or ""):find("the contact outgrows its mesh", 1, true),
  "the enlargement by w:set is reported")
ok(s.model.mesh.zone.plate > 1.3, "a longer stroke widens the plate's zone")
is(s.volume.total, volume, "w:set of a longer stroke does not change the volume")
s:run{ distance = 120 }
ok(off(s.volume.total, 1e-8 * 100 * 120) < 1e-9, "a longer stroke: the run continues")
local light = wear{ scheme = "explicit" }
light:step()
volume = light.volume.total
light:set{ load = 2 }
is(light.model.mesh.size, 0.02, "a lighter load does not change the mesh")
light:set{ mesh = { fineness = 2 }, load = 50 }
ok(off(light.model.mesh.size, 0.01 / math.sqrt(2)) < 1e-9, "w:set of the fineness changes the element size")
ok((warnings.take() or ""):find("the user changed the mesh", 1, true),
  "a mesh changed by the user is reported")
ok(light.model.mesh.rows * light.model.mesh.height >= 0.075, "the wear box is at least as deep as before")
is(light.volume.total, volume, "w:set of the mesh does not change the volume")
light:step()
ok(light.volume.total > volume, "a lighter load: the run continues")
light:set{ mesh = { size = 0.02, rows = 4, zone = { plate = 1.6 } } }
local mesh_now = light.model.mesh
is(mesh_now.size .. " " .. mesh_now.rows .. " " .. mesh_now.zone.plate, "0.02 4 1.6",
  "w:set of element size, rows and zone")
light:save(path)
local again = wear.open(path)
is(again:step() and again.p_center, light:step() and light.p_center,
  "a run saved after w:set of the mesh continues with identical bits")
os.remove(path)
local stays = tostring(light)
for fields, said in pairs{ [{ mesh = 3 }] = "field 'mesh': expected a table",
  [{ mesh = { size = 0.1, fineness = 2 } }] = "expected one of them", [{ mesh = { sise = 1 } }] = "'mesh.sise'",
  [{ load = 7, mesh = { zone = { plate = 0.01 } } }] = "mesh.zone.plate" } do
  local set, why = pcall(light.set, light, fields)
  ok(not set and tostring(why):find(said, 1, true), said)
end
is(tostring(light), stays, "a refused change leaves the run unchanged")

-- Tests the error for a contact that becomes as wide as the bodies.
local soft = { radius = 7.3, cylinder = { E = 1e6, nu = 0.1 }, plate = { E = 5, nu = 0.49 } }
ok(pcall(model, soft), "the rounded number of rows is not reduced")
local _, why = pcall(contact, { model = soft })
ok(tostring(why):find("too small for this contact: the zones can be at most 11.68 mm (cylinder) and 11.68 mm (plate) wide", 1,
  true),
  "the message for a contact wider than the bodies")

-- Tests the errors of contacts that reach the end of a zone: they name the body, the width and its limit.
_, why = pcall(contact, { model = { mesh = { size = 0.02, height = 0.025, zone = { cylinder = 0.1, plate = 0.2 } } }, load = 100 })
ok(tostring(why):find("end of the contact zone of the cylinder; use mesh.zone.cylinder > 0.1 mm (at most 16 mm)", 1, true),
  "a zone that can be wider")
local worn_edge = wear{ model = { upper = body.punch{ flat = 2, radius = 0.5 }, mesh = { size = 0.1 } }, alpha = 1, k = 1e-6,
  stroke = 0.5, scheme = "implicit", distance = 1e5 }
_, why = pcall(worn_edge.run, worn_edge)
why = tostring(why)
local message = "end of the contact zone of the punch, whose width of 2.8 mm is the largest (flat + 1.6 radius)"
ok(why:find(message, 1, true) and not why:find("use mesh", 1, true) and select(2, why:gsub("contact zone", "")) == 1,
  "a punch worn to the end of its edge: the message gives the limit once, and no larger zone")
ok(worn_edge.depth.punch < 0.4 * 0.5, "its depth is less than 0.4 of the radius of the edge")

-- Tests a model whose mesh was sized for another load.
warnings.take()
contact{ model = model{}, load = 0.1 }
ok((warnings.take() or ""):find("chosen for another load: give the model's fields", 1, true),
  "the message for a mesh sized for another load suggests a remedy")

-- Tests that the run is unchanged if no larger mesh is possible.
local full = wear{ model = { radius = 1, mesh = { size = 0.05, zone = { cylinder = 1.6, plate = 1.6 } } },
  alpha = 1, k = 4e-6, scheme = "explicit" }
local fine, message = pcall(full.run, full)
local at, pressure = full.distance, full.p_center
tap.holds(message, { "of its wear box of 4 rows of 0.0625 mm, the largest number that fits; use smaller steps",
  "at most 1.6 mm (cylinder) and 1.6 mm (plate) wide, the wear boxes at most 0.25 mm deep" },
    "the message states the limits of the mesh and suggests no deeper box")
ok(not fine, "without a larger mesh the run ends")
ok(not pcall(full.step, full), "a second step fails, too")
ok(full.distance == at and full.p_center == pressure and full:contact().p_center == pressure, "the run is unchanged")

-- Tests a wear box with as many rows as layers, which are much thinner than the rows: each layer wears by its
-- own k, and finally the base carries the contact.
local function on_layers(rows)
  local layers = {}
  for i, k in ipairs{ 4e-9, 1e-9, 8e-9 } do layers[i] = { thickness = 1e-4 * i, material = { E = 200e3, nu = 0.3, k = k } } end
  return wear{ model = { upper = body.cylinder{ k = 0 }, lower = body.block{ k = 2e-8, layers = layers },
    mesh = { size = 0.04, rows = rows } }, load = 100, stroke = 0.2, distance = 6000, scheme = "explicit" }
end
local few, many = on_layers():run{ depth = { plate = 12e-4 } }, on_layers(10):run{ depth = { plate = 12e-4 } }
ok(off(few.p_center, many.p_center) < 1e-3 and off(few.distance, many.distance) < 1e-3,
  ("three thin layers in boxes of three and of ten rows; differences %.2g, %.2g"):format(off(few.p_center,
  many.p_center), off(few.distance, many.distance)))

-- Tests that automatic steps do not become short near the edge of a zone, because the mesh is enlarged before
-- the contact reaches the edge.
local function pin_in_hole()
  -- model{} is called without the wear settings, so its mesh is too small for this run
  return wear{ model = model{ upper = body.disc{ radius = 9.95 }, lower = body.ring{ inner = 10, outer = 20 } }, load = 1000,
    stroke = 0.1, alpha = 1, k = 1e-7, distance = 1000, scheme = "explicit", geometry = "frozen" }
end
local function ball(zone)
  return wear{ model = model{ geometry = "axisymmetric", radius = 10, mesh = { size = 0.02, zone = zone } }, load = 50,
    slide = "z", alpha = 1, k = 1e-7, distance = 100, scheme = "explicit" }
end
local pin = pin_in_hole():run()
ok(pin.done and pin.update < 50, "a pin in a hole wears beyond the edge of its zone")
ok(off(pin.volume.cylinder, 1e-7 * pin.load_distance) < 1e-12, "the volume of a pin in a hole is exact")
local narrow, wide = ball{ cylinder = 0.5, plate = 0.5 }:run(), ball{ cylinder = 1.2, plate = 1.2 }:run()
ok(narrow.model.mesh.zone.cylinder > 0.5 and narrow.update < 60, "a ball wears beyond the edge of its zone")
ok(off(narrow.depth.cylinder, wide.depth.cylinder) < 5e-3,
  "the depth of the ball equals the depth on a large mesh")
local halfway = pin_in_hole()
for _ = 1, 14 do halfway:step() end -- the run is saved during the shortened steps at the edge
halfway:save(path)
halfway = wear.open(path):run()
is(halfway.p_center, pin.p_center, "a run saved at the edge continues with identical bits")
is(halfway.update, pin.update, "a run saved at the edge has the same number of updates")
os.remove(path)

-- Tests that steps so short that the run would never end are refused.
local endless = wear{ jump = function() return 1e-14 end, distance = 2000 }
local ended, because = pcall(endless.run, endless)
ok(not ended and endless.update < 50, "extremely short steps are refused")
tap.holds(because, { "field 'jump'", "the last 30 steps", "remain, so the run would not end", "use longer steps" }, "the error shows the last steps")

-- Tests uniform wear over the whole plate. It changes the contact only where layers become thinner; automatic
-- steps take this into account.
local function over_plate(fields)
  fields.stroke, fields.distance = 20, 1e5
  return wear(fields):run()
end
for what, steps in pairs{ ["automatic steps"] = { jump = "auto" }, ["implicit ones"] = { scheme = "implicit", tolerance = 1e-3 } } do
  steps.load, steps.alpha, steps.k = 100, 0, 1e-8
  local even = over_plate(steps)
  ok(even.done and even.update < 60,
    ("%s in uniform wear of the plate: %d updates"):format(what, even.update))
  ok(off(even.depth.plate, 1e-8 * 100 * 1e5 / 20) < 1e-12,
    "the depth is k times load times distance over the width")
end
local soft = over_plate{ load = 10, scheme = "explicit", model = { upper = body.cylinder{ radius = 10, E = 1e9, k = 0 },
  lower = body.block{ width = 20, height = 10, E = 1e9, k = 0, layers = { { thickness = 0.1, material = material{ E = 1000, k = 1e-6 } } } } } }
ok(soft.done and soft.update < 150, ("a soft layer on rigid bodies: %d steps"):format(soft.update))
local rise, depth, pressure = 0, soft.history.depth_plate, soft.history.p_center
for i = 2, #pressure do rise = math.max(rise, pressure[i] / pressure[i - 1]) end
ok(rise < 1.05 and pressure[#pressure] > 1.1 * pressure[1], "the pressure rises by less than 5 % in a step")
ok(off(depth[#depth], 0.05) < 1e-12, "half of the soft layer is worn")

-- Tests worn surfaces that touch over a larger width than unworn surfaces: the mesh of the run is large
-- enough from the start.
local conformal = { k = 1e-6, distance = 660, scheme = "explicit", worn = { plate = function(x) return math.max(0, (0.81 - x * x) / 20) end } }
local wide = wear(conformal)
ok(wide.half_width > 0.8, ("a conformal worn surface: half width %.2f mm"):format(wide.half_width))
ok(wide:run{ progress = false }.done, "a run from a conformal worn surface ends at its distance")

-- Tests wear with friction: steady cycles and their results, the energy law, files and copies, refused input.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails = tap.ok, tap.is, tap.near, tap.fails

local m = model{ mesh = { size = 0.02, height = 0.025 } }
local function run(fields)
  local all = { model = m, friction = 0.6, load = 100, k = 1e-7, jump = 20, cycles = 400, increments = 24 }
  for name, value in pairs(fields) do all[name] = value end
  if all.stroke == false then all.stroke, all.tangential = nil, all.tangential or 30 end
  return wear(all)
end

-- Tests gross slip: the slip is the stroke minus the elastic displacement, and the force is the friction
-- force.
local gross = run{ stroke = 0.1 }
is(gross.energy, 0, "no energy is dissipated before the first step")
gross:run{ progress = false }
is(gross.gross, 1, "the contact is in gross slip")
is(gross.stick_width, 0, "no part of the contact sticks")
near(gross.largest_shear, 60, 0.02, "the largest tangential force is the friction force")
local loop = gross:loop()
is(#loop.x, 25, "the loop has a point for each increment")
is(loop.energy, gross.cycle_energy, "the energy of the loop equals the energy in the record")
near(loop.x[1], loop.x[25], 1e-12, "the loop is closed")
local area = 0
for i = 2, #loop.x do
  area = area + (loop.x[i] - loop.x[i - 1]) * (loop.tangential[i] + loop.tangential[i - 1]) / 2
end
near(area, loop.energy, 0.05,
  "the area of the loop is the dissipated energy, except for the length of the increments")
local ideal = 1e-7 * 100 * gross.distance
ok(gross.volume.total < ideal and gross.volume.total > 0.9 * ideal,
  "wear uses the slip, which is smaller than the stroke")
near(gross.volume.total, 1e-7 * gross.energy / 0.6, 1e-9, "the ratio of volume to energy is k / mu")
near(gross.volume.cylinder, gross.volume.plate, 1e-9, "both bodies lose the same volume")

-- Tests the energy law, in which wear is proportional to the dissipated energy.
for _, jump in ipairs{ 50, "auto" } do
  local w = run{ stroke = 0.1, law = "energy", jump = jump }
  w:run{ progress = false }
  near(w.volume.total, 1e-7 * w.energy, 1e-9, "V = k E, jump " .. jump)
end
for label, fields in pairs{ ["gross slip"] = { stroke = 0.1 }, ["partial slip"] = { stroke = false } } do
  local function to_end(more)
    for name, value in pairs(fields) do more[name] = value end
    return run(more):run{ progress = false }
  end
  local short = to_end{ law = "energy", jump = 10 }
  for order, off in ipairs{ 0.01, 1e-3 } do
    local w = to_end{ law = "energy", scheme = "implicit", jump = 100, order = order }
    label = ("implicit steps of order %d, %s"):format(order, label)
    near(w.volume.total, 1e-7 * w.energy, 1e-9, label .. ": V = k E")
    near(w.volume.total, short.volume.total, off, label .. ": the volume of short explicit steps")
    near(w.depth.plate, short.depth.plate, 2 * off, label .. ": the depth of short explicit steps")
    is(w.stick_width, short.stick_width, label .. ": width of the stick zone")
    near(w.cycle_energy, w:loop().energy, 1e-12, label ..
      ": the record contains the energy of the last cycle")
  end
end
local over_plate = run{ stroke = 20, law = "energy", alpha = 0.4, scheme = "implicit", cycles = 2 }:run{ progress = false }
near(over_plate.volume.total, 1e-7 * over_plate.energy, 1e-12, "V = k E of implicit steps over the whole plate")
local table_of_mu = run{ stroke = 0.1, law = "energy", friction = { distance = { 0, 80 }, value = { 0.3, 0.9 } } }
table_of_mu:run{ progress = false }
near(table_of_mu.volume.total, 1e-7 * table_of_mu.energy, 1e-9, "V = k E if friction changes with distance")
near(table_of_mu.largest_shear, 90, 0.05, "the friction force is computed with the last coefficient")
local short = run{ stroke = 0.1, law = "energy", jump = 10, friction = table_of_mu.friction }:run{ progress = false }
for label, fields in pairs{ ["jump 50"] = { jump = 50 }, ["jump auto"] = { jump = "auto" },
  implicit = { scheme = "implicit", jump = 100 } } do
  fields.stroke, fields.law, fields.friction = 0.1, "energy", table_of_mu.friction
  near(run(fields):run{ progress = false }.volume.total, short.volume.total, 1e-3, label ..
    ": friction that changes within an update")
end
-- Tests a coefficient of friction with a step or a decrease during the run: the volume agrees within 0.04 %
-- with short updates. The errors would be 12, 6.6 and 1.3 % if an update used a single coefficient.
local function step_up(state) return state.distance < 4 and 0.3 or 0.9 end
local function falling(state) return 0.9 - 1.1 * math.min(state.distance, 0.5) end
for label, case in pairs{
  jump = { { distance = { 0, 4, 4, 8 }, value = { 0.3, 0.3, 0.9, 0.9 } }, step_up, stroke = 4e-3, cycles = 1000 },
  fall = { { distance = { 0, 0.5 }, value = { 0.9, 0.35 } }, falling, stroke = false, cycles = 2000 } } do
  local function to_end(fields)
    fields.stroke, fields.cycles, fields.k, fields.increments = case.stroke, case.cycles, 1e-6, 40
    fields.friction = fields.friction or case[1]
    return run(fields):run{ progress = false }
  end
  local truth = to_end{ jump = 2 }
  for what, friction in pairs{ table = case[1], ["function"] = case[2] } do
    local automatic = to_end{ jump = "auto", friction = friction }
    local implicit = to_end{ jump = nil, scheme = "implicit", tolerance = 1e-3, friction = friction }
    near(automatic.volume.total, truth.volume.total, 1e-3,
      ("%s of friction by a %s: volume, jump auto"):format(label, what))
    near(automatic.depth.plate, truth.depth.plate, 5e-3,
      ("%s of friction by a %s: depth, jump auto"):format(label, what))
    near(implicit.volume.total, truth.volume.total, 1e-3,
      ("%s of friction by a %s: volume, implicit"):format(label, what))
    near(implicit.depth.plate, truth.depth.plate, 1e-3,
      ("%s of friction by a %s: depth, implicit"):format(label, what))
  end
  near(to_end{ jump = 30 }.volume.total, truth.volume.total, 5e-3,
    ("%s of friction: volume, jump 30"):format(label))
end
local by_function = run{ stroke = 0.1, friction = function(state) return state.cycle < 200 and 0.6 or 0.2 end }
by_function:run{ progress = false }
near(by_function.largest_shear, 20, 0.05, "friction given as a function of the state")

-- Tests a stroke over the whole plate with one pass per cycle: the plate stays flat, and the slip is the
-- stroke minus the elastic displacement.
for _, alpha in ipairs{ 0, 0.5, 1 } do
  local label = ("stroke over the whole plate, alpha %g: "):format(alpha)
  local w = run{ stroke = 20, cycles = 10, jump = "auto", alpha = alpha, law = "energy", k = 1e-8 }
  w:run{ progress = false }
  is(w.procedure, "NSP", label .. "procedure")
  near(w.volume.total, 1e-8 * w.energy, 1e-9, label .. "V = k E")
  near(w.volume.cylinder, alpha * w.volume.total, 1e-12, label ..
    "alpha is the cylinder's fraction of the volume")
  -- the plate starts to slide after 2.677 um, and after twice this distance at a reversal; until then the force
  -- increases less than linearly
  near(0.6 * 100 * 20 - w.cycle_energy, 0.6 * 100 * 2 * 2.677e-3, 0.1, label ..
    "energy stored elastically at both reversals [N mm]")
  near(w:loop().energy, 2 * w.cycle_energy, 1e-12, label .. "the loop contains two passes")
  local lowest, highest = math.huge, 0
  for _, h in ipairs(w:profile("plate").h) do lowest, highest = math.min(lowest, h), math.max(highest, h) end
  is(lowest, highest, label .. "the plate wears uniformly")
  near(highest, w.volume.plate / 20, 1e-9, label .. "the depth is the volume divided by the area")
end

-- Tests wear in partial slip under a prescribed tangential force.
local partial = run{ stroke = false, cycles = 200 }
partial:run{ progress = false }
is(partial.cycle, 200, "number of cycles")
is(partial.gross, 0, "a part of the contact sticks")
ok(math.abs(partial.stick_width - 2 * hertz{}.half_width * math.sqrt(0.5)) < 2 * 0.02,
  "the stick width agrees with Cattaneo and Mindlin within two elements")
near(partial.largest_shear, 30, 1e-9, "the largest tangential force is the given force")
tap.holds(tostring(partial), { "force up to 30 N, sticks on 0.18 mm", "N mm a cycle" }, "print(w)")
tap.holds(tostring(gross), "gross slip", "print(w) in gross slip")
local held = run{ stroke = false, tangential = 3, cycles = 50 }:run{ progress = false }
near(held.stick_width, 2 * held.half_width, 1e-6, "the stick width is at most the contact width")
local block = run{ stroke = nil, cycles = 20,
  loading = { tangential = function(t) return 30 * math.sin(2 * math.pi * t) end, load = 100, increments = 24 } }
block:run{ progress = false }
near(block.cycle_energy, run{ stroke = false }:loop().energy, 0.02, "a tangential force given as a loading")
local pulsating = run{ stroke = nil, cycles = 20,
  loading = { tangential = function(t) return 40 * math.sin(math.pi * t) ^ 2 end, load = 100, increments = 24 } }
pulsating:run{ progress = false }
ok(math.abs(pulsating.stick_width / 2 - hertz{}.half_width * math.sqrt(1 - 40 / 120)) < 0.02,
  "a force between 0 and F gives the stick zone of a force between -F/2 and F/2")
local phase = run{ stroke = nil, cycles = 20, loading = {
  x = function(t) return 0.05 * math.sin(2 * math.pi * t) end,
  load = function(t) return 100 + 40 * math.sin(2 * math.pi * t + 1) end } }
phase:run{ progress = false }
ok(phase.gross == 1 and phase.energy > 0, "a normal load that changes during the motion")
ok(#block.loading[1].tangential == 25 and #phase.loading[1].x == 101, "loadings contain the driving motion or force")

-- Tests a contact that is pressed and moved like the run: its steady cycle has the energy of the run's loop,
-- whether or not friction acts during pressing.
local function steady_energy(of, force, press)
  local c = contact{ model = of.model, friction = of.friction, load = of.load, press = press }
  local before
  c = c:move{ tangential = -force, increments = 20 }
  for _ = 1, 2 do
    before = c.energy
    c = c:move{ tangential = force, increments = 40 }:move{ tangential = -force, increments = 40 }
  end
  return c.energy - before
end
local unlike = { [0.117] = { E = 70e3, nu = 0.33, friction = 0.5 }, [0.318] = { E = 20e3, nu = 0.2, friction = 0.9 } }
for beta, of in pairs(unlike) do
  of.model = model{ cylinder = { E = of.E, nu = of.nu }, plate = { E = beta > 0.2 and 200e3 or 210e3 }, mesh = { fineness = 2 } }
  for _, share in ipairs{ 0.4, 0.8 } do
    local energy, force = {}, share * of.friction * 50
    for _, press in ipairs{ "friction", "frictionless" } do
      local w = run{ model = of.model, friction = of.friction, load = 50, stroke = false, tangential = force, press = press,
        increments = 80 }
      energy[press] = w:loop().energy
      near(energy[press], steady_energy(w, force, press), 1e-12,
        ("energy of loop and contact: beta %g, force %g mu L, press %s"):format(beta, share, press))
    end
    -- in the four cases the energies differ by 2.5, 0.6, 2.2 and 0.4 % on fine elements; on these coarse
    -- elements, of which few slip, they differ by 0.35 % or more
    ok(math.abs(energy.friction / energy.frictionless - 1) > 1e-3, "friction during pressing changes the energy")
  end
end
is(run{ stroke = false }:loop().energy, run{ stroke = false, press = "frictionless" }:loop().energy,
  "equal bodies: friction during pressing has no effect")
is(run{ stroke = false }.press, "friction", "the default of press is friction")

-- Tests that motions and forces give the same result: pairs of sticking points stay together, and splitting a
-- motion changes nothing.
local still = contact{ model = { mesh = { size = 0.01 } }, friction = 0.6 }
local out = still:move{ x = 1e-3, increments = 10 }
local back = out:move{ x = -1e-3, increments = 20 }
local again = back:move{ x = 0, increments = 10 }:move{ x = 1e-3, increments = 10 }
local pulled = still:move{ tangential = out.tangential, increments = 10 }
near(pulled.x, 1e-3, 1e-6, "the tangential force of a motion leads to the same position")
near(out.energy, pulled.energy, 1e-4, "energy of the first motion, by position and by force")
near(again.energy - back.energy, back.energy - out.energy, 1e-4,
  "a repeated motion dissipates the same energy")
pulled = pulled:move{ tangential = back.tangential, increments = 20 }
near(back.energy, pulled.energy, 1e-4, "energy of the second half of the cycle")

-- Tests that almost equal bodies behave like equal bodies. A sum over the nodes alone would have up to 44 %
-- less energy.
local cycle_of = {}
for _, E in ipairs{ 200e3, 200e3 * (1 + 1e-6), 202e3 } do
  local pair = hertz{ plate = { E = E } }
  local pressed = contact{ model = { plate = { E = E }, mesh = { size = 0.01 } }, friction = 0.6 }:move{ tangential = 12 }
  local exact = 4 * 0.36 * 1e4 / (math.pi * pair.E_star) * (0.8 * math.log(0.8) + 0.2 - 0.02)
  cycle_of[#cycle_of + 1] = pressed:move{ tangential = -12 }:move{ tangential = 12 }.energy - pressed.energy
  near(cycle_of[#cycle_of], exact, 0.01,
    ("energy of a cycle of bodies with E = %.9g and 200 GPa"):format(E / 1e3))
end
near(cycle_of[2], cycle_of[1], 1e-4, "almost equal bodies dissipate the energy of equal bodies")

-- Tests that a run with very small friction wears like a run without friction and with rigid sliding.
local plain, slight = run{ friction = 0, stroke = 0.2, jump = 10 }, run{ friction = 1e-6, stroke = 0.2, jump = 10 }
plain:run{ progress = false } slight:run{ progress = false }
near(slight.volume.total, plain.volume.total, 1e-3, "with very small friction the slip is almost the stroke")
near(slight.depth.plate, plain.depth.plate, 5e-3,
  "with very small friction the depth is the depth without friction")
is(plain.energy, 0, "no energy is dissipated without friction")
fails(function() plain:loop() end, { "field 'friction'", "without friction" },
  "a run without friction has no loop")

-- Tests that copies of a run, and runs opened from files, continue with identical results.
local name = os.tmpname()
os.remove(name)
local soft = model{ cylinder = { E = 20e3, nu = 0.2 }, mesh = { size = 0.02, height = 0.025 } }
for label, fields in pairs{ stroke = { stroke = 0.1, jump = "auto" }, pressed = { stroke = false, model = soft },
  loose = { stroke = false, model = soft, press = "frictionless" },
  table = { stroke = 0.1, jump = "auto", friction = { distance = { 0, 80 }, value = { 0.3, 0.9 } } },
  implicit = { stroke = 0.1, scheme = "implicit", tolerance = 1e-3, jump = nil }, force = { stroke = false },
  block = { stroke = nil, cycles = 400, loading = { tangential = { -20, 30, -20 }, load = { 80, 100, 80 } } } } do
  local w = run(fields)
  w:step(2)
  local file = name .. label .. ".arc"
  w:save(file)
  local copy, stored = w:clone(), wear.open(file)
  os.remove(file)
  w:step(2) copy:step(2) stored:step(2)
  for _, field in ipairs{ "energy", "cycle_energy", "largest_shear", "stick_width", "distance", "p_center" } do
    is(copy[field], w[field], label .. ": copy, " .. field)
    is(stored[field], w[field], label .. ": from a file, " .. field)
  end
  is(stored.depth.plate, w.depth.plate, label .. ": the depth is identical to the bit")
  is(stored.press, w.press, label .. ": the setting press")
end

-- Tests the warning for materials so different that the solution may not be unique.
local heard = require "archard.warnings"
heard.keep()
local uneven = wear{ model = { mesh = { size = 0.04, height = 0.05 }, plate = { E = 2e3, nu = 0.1 } }, friction = 1.2,
  load = 20, stroke = 0.4, k = 1e-9, cycles = 1, increments = 20 }
heard.take()
uneven:step()
tap.holds(heard.take() or "", { "wear: friction 1.2 times Dundurs' beta" },
  "a warning that the solution may not be unique")

-- Tests the warning for slip annuli narrower than two elements.
run{ stroke = false, cycles = 100 }:run{ progress = false }
tap.holds(heard.take() or "", { "the surfaces slip over", "elements of 0.02 mm", "mesh.size = " },
  "a warning for slip annuli of few elements")
run{ stroke = false, cycles = 100, jump = 100, model = { mesh = { fineness = 4 } } }:run{ progress = false }
is((heard.take() or ""):find "the surfaces slip over", nil, "no warning for slip annuli of many elements")
run{ stroke = 0.1, cycles = 100 }:run{ progress = false }
is((heard.take() or ""):find "the surfaces slip over", nil, "no warning in gross slip")

-- Tests that the slip annuli determine the size of default elements, under a force and under a stroke, and that
-- element sizes set by the user are not changed.
local function automatic(fields, mesh)
  local all = { friction = 0.6, load = 100, k = 1e-7, cycles = 100, increments = 24, model = { mesh = mesh } }
  for name, value in pairs(fields) do all[name] = value end
  return wear(all)
end
local a, under_force = hertz{}.half_width, automatic{ tangential = 42 }
local rim, size = a * (1 - math.sqrt(1 - 0.7)), under_force.model.mesh.size
ok(rim / size >= 5 and rim / size < 6, "a slip annulus has five elements")
near((a - rim) / size % 1, 0.5, 0.01, "the stick zone ends halfway between two nodes")
under_force:run{ progress = false }
is((heard.take() or ""):find "the surfaces slip over", nil, "no warning with elements sized by the slip annulus")
near(under_force.stick_width, 2 * (a - rim), 1e-3, "the stick width agrees with Cattaneo and Mindlin")
local x = under_force:loop().x
local under_stroke = automatic{ stroke = math.max(table.unpack(x)) - math.min(table.unpack(x)) }
near(under_stroke.model.mesh.size, size, 0.1, "a stroke with the same force gives the same element size")
near(automatic({ tangential = 42 }, { size = 0.02 }).model.mesh.size, 0.02, 1e-12,
  "an element size set by the user is not changed")
near(automatic{ stroke = 0.1 }.model.mesh.size, 0.02, 1e-3, "in gross slip the mesh is the default mesh")
local unresolved = automatic({ tangential = 6, jump = "auto", cycles = 2000 }, { size = 0.01 }):run{ progress = false }
ok(unresolved.update < 400, ("slip annuli of a quarter of an element: %d updates"):format(unresolved.update))
fails(function() automatic{ tangential = 61 } end, { "expected less than friction times the load" },
  "a tangential force above the friction limit")

-- Tests pictures.
local function picture(draw)
  local stem = os.tmpname()
  draw(stem .. ".gp")
  local file = io.open(stem .. ".gp")
  local text = file and file:read("a") or ""
  if file then file:close() end
  os.remove(stem .. ".gp")
  os.remove(stem)
  return text
end
local text = picture(function(file) plot.loop(gross, partial:loop(), { file = file, titles = { "one", "two" } }) end)
tap.holds(text, { "tangential force / N", "fretting loops", "one, ", "two, ", "N mm per loop" }, "plot.loop")
text = picture(function(file) plot.loop(gross, partial, { file = file }) end)
tap.holds(text, { "s = 0.1 mm, ", "30 N tangential, " }, "titles of runs show the settings that differ")
ok(not text:find "s = 0 mm" and not text:find "[^3]0 N tangential", "titles show only the motion or force that drives the plate")
text = picture(function(file) plot.loop(partial:loop(), { x = { 0, 1e-3 }, tangential = { 0, 1 }, energy = 1e-4, cycle = 0 }, { file = file }) end)
tap.holds(text, { ("after %.6g cycles, "):format(partial.cycle), "unworn, " }, "loops of one run are named by their cycles")
tap.holds(tostring(partial), "slip of each point", "slip of a run with friction")
fails(function() plot.loop(plain) end, "without friction", "plot.loop of a run without friction")
fails(function() plot.loop() end, "expected wear runs with friction", "plot.loop without an argument")
fails(function() plot.loop(m) end, "expected wear runs with friction", "plot.loop of a model")

-- Tests the fretting map (verify/fretting_map.lua checks its borders).
local map = study.fretting_map{ load = { 50, 100 }, motion = { 1e-4, 1e-3, 4e-3 }, model = m }
is(table.concat(map.regime[1], " "), "stick partial gross", "regimes from stick to gross slip")
ok(map.gross_from[1] < map.gross_from[2] and map.partial_from[2] < map.gross_from[2],
  "the transitions are in the right order")
ok(study.fretting_map{ load = { 50 }, motion = { 1e-3 }, model = m, annulus = 0.3 }.partial_from[1] > map.partial_from[1],
  "a wider slip annulus needs a larger motion")
tap.holds(tostring(map), { "load / N", "0.1 um", "stick", "partial", "gross", "partial from / um" }, "print(map)")
text = picture(function(file) plot.fretting_map(map, { file = file }) end)
tap.holds(text, { "running condition fretting map", "load / N", "amplitude of the motion / µm", "filledcurves closed",
  'title "10 % slips"', 'title "computed"' }, "plot.fretting_map of two loads")
text = picture(function(file) plot.fretting_map(study.fretting_map{ load = { 50 }, motion = { 1e-3 }, model = m }, { file = file }) end)
tap.holds(text, { "partial slip" }, "plot.fretting_map of a single load")
fails(function() plot.fretting_map(m) end, "expected a result of study.fretting_map{}",
  "plot.fretting_map of a model")
for label, case in pairs{ ["no motions"] = { {}, { "field 'motion'", "increasing numbers > 0 in mm", "got nil" } },
  ["a number"] = { { motion = 1 }, { "field 'motion'", "increasing numbers > 0 in mm", "got 1" } },
  ["loads that fall"] = { { load = { 100, 50 }, motion = { 1 } }, { "field 'load[2]'", "a number > 100 N", "got 50" } },
  ["a load below 0"] = { { load = { -5, 50 }, motion = { 1 } }, { "field 'load[1]'", "a number > 0 N", "got -5" } },
  ["no motion"] = { { motion = { 0, 5e-4 } }, { "field 'motion[1]'", "a number > 0 mm", "got 0" } },
  ["no friction"] = { { motion = { 1 }, friction = 0 }, { "field 'friction'", "a number > 0", "got 0" } },
  ["a table of friction"] = { { motion = { 1 }, friction = { value = { 0.6 } } }, { "field 'friction'", "got a table" } },
  ["a whole annulus"] = { { motion = { 1 }, annulus = 1 }, { "field 'annulus'", "(0, 1)" } },
  ["a stroke"] = { { motion = { 1 }, stroke = 1 }, "unknown field 'stroke'" } } do
  case[1].load = case[1].load or { 100 }
  fails(function() study.fretting_map(case[1]) end, case[2], "refused input of the fretting map: " .. label)
end

-- Tests a friction force that falls below the tangential force during the run.
for _, thickness in ipairs{ 1, 5 } do
  local w = wear{ model = { thickness = thickness, mesh = { size = 0.04, height = 0.05, far = 2 } }, load = 100 * thickness,
    tangential = 30 * thickness, friction = { distance = { 0, 0.1 }, value = { 0.6, 0.1 } }, k = 1e-7, cycles = 1e5, jump = 100,
    increments = 8 }
  local err = fails(function() w:run{ progress = false } end, { "field 'friction'", "expected more than 0.3",
    ("a force of %d N"):format(30 * thickness), ("a load of %d N"):format(100 * thickness), "got 0.1 at a distance of", "mm" },
    ("friction that falls below the tangential force, thickness %d"):format(thickness))
  is(err.code, "ARGUMENT", "error code of friction that is too small")
  is(w.update, 0, "the run is unchanged after the error")
end
local later = run{ stroke = 0.1, cycles = 100, jump = 20, friction = function(state) return state.cycle < 20 and 0.6 or 0 end }
later:run{ progress = false }
is(later.gross, 0, "no gross slip is reported when friction has vanished")
is(later.cycle_energy, 0, "no energy is dissipated when friction has vanished")

-- Tests a slip annulus narrower than an element: no node slips, but the slip between the nodes causes wear.
for _, law in ipairs{ "archard", "energy" } do -- the reference is the energy of a cycle by Cattaneo and Mindlin
  local w = run{ tangential = 12, law = law }:run{ progress = false }
  near(w.energy, 400 * 6.1948e-5, 0.1, law .. ": the energy of partial slip narrower than an element")
  near(w.volume.total, 1e-7 * w.energy / (law == "energy" and 1 or 0.6), 1e-9,
    "the wear volume is k times the energy")
  near(w.volume_cylinder, w.volume_plate, 1e-9, "both bodies wear by the same volume")
end

-- Tests that invalid friction settings are refused.
local function refused(fields, words, label) fails(function() run(fields) end, words, label) end
refused({ friction = -0.1 }, { "field 'friction'", ">= 0", "-0.1" }, "friction below 0")
refused({ friction = 0, tangential = 10 }, { "field 'tangential'", "friction" },
  "a tangential force without friction")
refused({ tangential = 60 }, { "field 'tangential'", "less than friction times the load, 60 N" },
  "a tangential force equal to the friction limit")
refused({ tangential = 10, stroke = 0.1 }, { "'stroke' and 'tangential'", "both" },
  "stroke and tangential force together")
refused({ loading = { x = { 0, 1, 0 }, tangential = { 0, 1, 0 } } }, { "'loading.x' and 'loading.tangential'", "both" },
  "positions and tangential forces together")
refused({ loading = { tangential = { 0, 50, 0 }, load = { 100, 80, 100 } } },
  { "loading[1].tangential[2]", "48 N", "50 N" }, "a force above the friction limit in a loading")
refused({ friction = { distance = { 0, 1 }, value = { 0.6, 0.5 } },
  loading = { tangential = { 0, 5, 0 }, load = { 100, 0, 100 } } },
    { "loading[1].tangential[2]", "0 N", "5 N" },
    "a tangential force at zero load")
refused({ friction = 0, loading = { tangential = { 0, 5, 0 } } }, "loading[1].tangential",
  "a tangential force in a loading without friction")
refused({ loading = { x = { 0, 0.1 } } }, { "ends where it begins", "by 0.1 mm" }, "a loading that does not end at its start")
refused({ loading = { tangential = { 0, 10, -10, 1e-5 }, load = { 100, 90, 100, 100 - 1e-6 } } }, { "by 1e-05 N", "by -1e-06 N" },
  "a loading that nearly ends at its start")
refused({ stroke = 0.1, press = "hard" }, { "field 'press'", "\"frictionless\"", "hard" }, "an unknown value of press")
refused({ stroke = 0.1, update = "increment" }, "field 'update'", "friction with updates within a cycle")
refused({ stroke = 0.1, slide = "z" }, "field 'slide'", "friction with sliding out of the plane")
refused({ stroke = 0.1, slip = "total" }, "field 'slip'", "friction with total slip")
refused({ stroke = 0.1, procedure = "NSP", alpha = 1 }, "field 'procedure'",
  "friction with a plate that does not move")
refused({ stroke = 0.1, friction = 0, law = "energy" }, { "field 'law'", "friction" },
  "energy law without friction")


-- --- cycles of the normal load without motion ------------------------------------------------------

-- Tests that dissimilar bodies slip under a changing load alone and that equal bodies do not.
local unlike = { cylinder = { E = 4e5, nu = 0.22 }, plate = { E = 7e4, nu = 0.33 }, mesh = { size = 0.02, height = 0.025 } }
local function breathing(bodies, strength)
  local w = run{ model = model(bodies), loading = { tangential = function() return 0 end,
    load = function(t) return 100 * (1 + strength * math.sin(2 * math.pi * t)) end } }
  return w:run{ progress = false }
end
local strong, alike = breathing(unlike, 0.5), breathing({ mesh = unlike.mesh }, 0.5)
is(strong.cycle, 400.0, "a varying load alone defines cycles")
ok(strong.energy > 0 and strong.volume_plate > 0,
  "bodies of different materials slip and wear under a varying load")
ok(alike.energy <= 1e-9 * strong.energy, "bodies of one material do not slip under a changing load")
ok(math.abs(strong.largest_shear) < 1e-6 * 100, "there is no tangential force")
local weak = breathing(unlike, 0.25)
ok(weak.energy > 0 and weak.energy < strong.energy / 2,
  "half the load variation dissipates less than half of the energy")
refused({ loading = { tangential = { 1, 1, 1 } } }, "a force or a load that changes",
  "neither the force nor the load varies")

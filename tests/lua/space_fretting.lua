-- Tests fretting wear in three dimensions: exchange of bodies, mirror images, energies, files, loops, gross
-- slip.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- which would make it too slow.

-- Long
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

local steel = material{ E = 200e3, nu = 0.3 }
local soft = material{ E = 50e3, nu = 0.4 }
local function pair(upper, lower, size, ball_below)
  local ball, block = body.ball{ radius = 10, material = upper }, body.block{ material = lower }
  if ball_below then ball, block = body.block{ material = upper }, body.ball{ radius = 10, material = lower } end
  return model{ geometry = "3-D", upper = ball, lower = block, mesh = { size = size or 0.011 } }
end
local function fret(changes)
  local all = { model = pair(steel, steel), load = 10, friction = 0.5, tangential = 3.5, k = 1e-6, alpha = 0.3, cycles = 500 }
  for name, value in pairs(changes or {}) do all[name] = value or nil end
  return wear(all)
end

-- --- partial slip ----------------------------------------------------------------------------------
local w = fret():run{ progress = false }
is(w.gross, 0, "the contact is in partial slip")
near(w.stick_width / 2, 0.0880442 * 0.3 ^ (1 / 3), 0.1, "the radius of the stick zone agrees with Mindlin's")
near(w.largest_shear, 3.5, 1e-12, "the largest tangential force is the given force")
near(w.volume.cylinder / w.volume.total, 0.3, 1e-9, "alpha is the ball's fraction of the volume")
ok(w.volume.total > 0 and w.cycle_energy > 0, "partial slip causes wear and dissipates energy")
near(2e-6 * w.energy, w.volume.total, 1e-9, "the volume is k times the energy divided by friction")

-- Tests the mirror symmetry of the map of depths in x and z.
local map = w:map("ball", "depth")
for _, at in ipairs{ { 0.07, 0.02 }, { 0.075, -0.011 }, { 0.03, 0.077 } } do
  local x, z = at[1], at[2]
  near(map:at(-x, z), map:at(x, z), 1e-9, ("the depth at -x equals the depth at x = %g mm"):format(x))
  near(map:at(x, -z), map:at(x, z), 1e-9, ("the depth at -z equals the depth at z = %g mm"):format(z))
end
ok(map:at(0, 0) == 0, "the stick zone does not wear")

-- Tests the exchange of bodies: with the ball as the lower body, the flat wears by the fraction alpha.
local other = fret{ model = pair(steel, steel, nil, true), alpha = 0.7 }:run{ progress = false }
near(other.volume.plate, w.volume.cylinder, 1e-6, "exchanged bodies: volume of the ball")
near(other.volume.cylinder, w.volume.plate, 1e-6, "exchanged bodies: volume of the block")
near(other:map("block", "depth"):at(0.07, 0), w:map("block", "depth"):at(0.07, 0), 1e-6,
  "exchanged bodies: depth of the block")

-- Tests a short stroke, for which the middle of the contact sticks, along x and along z.
local stroke = fret{ stroke = 6e-4, tangential = false, cycles = 200 }:run{ progress = false }
is(stroke.gross, 0, "a short stroke causes partial slip")
ok(stroke.largest_shear > 2 and stroke.largest_shear < 5,
  "the largest force is below friction times load: " .. stroke.largest_shear)
local across = fret{ stroke = 6e-4, tangential = false, cycles = 200, slide = "z" }:run{ progress = false }
near(across.volume.total, stroke.volume.total, 1e-9, "a stroke along z has the volume of a stroke along x")

-- Tests that the number of increments has almost no effect on the volume.
near(fret{ increments = 8 }:run{ progress = false }.volume.total, w.volume.total, 2e-3,
  "eight increments per cycle")

-- --- laws ------------------------------------------------------------------------------------------
local energy = fret{ law = "energy" }:run{ progress = false }
near(energy.volume.total, 1e-6 * energy.energy, 1e-9, "V = k E in partial slip")
local power = fret{ law = "power", law_pressure = 400, law_exponent = 1 }:run{ progress = false }
ok(power.volume.total > 0 and power.volume.total < 1.5 * w.volume.total,
  "volume by a power law in partial slip")

-- --- files -----------------------------------------------------------------------------------------
local half = fret():run{ cycles = 200, progress = false }
local file = os.tmpname()
os.remove(file)
half:save(file)
local opened, copy = wear.open(file), half:clone()
os.remove(file)
for _, run in ipairs{ half, opened, copy } do run:run{ progress = false } end
for _, name in ipairs{ "depth_cylinder", "energy", "stick_width", "cycle_energy", "error" } do
  is(opened.history[name][opened.update + 1], half.history[name][half.update + 1],
    "a run opened from a file continues with identical bits: " .. name)
  is(copy.history[name][copy.update + 1], half.history[name][half.update + 1],
    "a cloned run continues with identical bits: " .. name)
end

-- --- loops -----------------------------------------------------------------------------------------
local loop = fret():loop()
near(math.max(table.unpack(loop.tangential)), 3.5, 1e-3, "the largest force of the loop")
ok(#loop.x > 30, "the loop has more than 30 points")
local function area_of(l)
  local area = 0
  for i = 2, #l.x do area = area + (l.tangential[i] + l.tangential[i - 1]) / 2 * (l.x[i] - l.x[i - 1]) end
  return area
end
near(area_of(loop), loop.energy, 0.02, "the area of the loop is its energy")
for _, stroke in ipairs{ 0.002, 0.04, 0.2 } do
  local gross = fret{ stroke = stroke, tangential = false, cycles = 10 }:loop()
  near(area_of(gross), gross.energy, 0.005, ("the area of a loop in gross slip, stroke %g mm"):format(stroke))
end
near(loop.energy, 0.9 * 0.25 * 100 / 0.0880442 * 4 * 1.7 * 1.3 / 200e3 * (1 - 0.3 ^ (5 / 3) - 5 * 0.7 / 6 * (1 + 0.3 ^ (2 / 3))), 0.03,
  "the energy of the loop agrees with Mindlin")

-- --- gross slip ------------------------------------------------------------------------------------
local a = 0.0880442
local function slide(changes)
  local all = { tangential = false, stroke = 0.4 * a, k = 1e-8, alpha = 0.5, cycles = 1e4, model = pair(steel, steel, a / 10) }
  for name, value in pairs(changes or {}) do all[name] = value end
  return fret(all):run{ progress = false }
end
local g = slide()
is(g.gross, 1, "gross slip")
near(g.depth.cylinder, 7.2099e-4, 1e-3, "depth of the ball")
near(g.depth.plate, 7.0987e-4, 1e-3, "depth of the block")
near(g.volume.plate, 3.4761e-5, 1e-3, "the elastic displacement reduces the wear by 1.3 % of k P s")
near(g.volume.cylinder, g.volume.plate, 1e-9, "both bodies lose the same volume in gross slip")
near(2e-8 * g.energy, g.volume.total, 1e-9,
  "the volume in gross slip is k times the energy divided by friction")
local gross_energy = slide{ law = "energy" }
near(gross_energy.volume.total, 1e-8 * gross_energy.energy, 1e-9, "V = k E in gross slip")
local alone = slide{ alpha = 1 }
near(alone.depth.cylinder, 1.43323e-3, 1e-3, "depth of a ball that wears alone")
near(alone.volume.total, 6.9563e-5, 1e-3, "volume of a ball that wears alone")
local turned = slide{ slide = "z", cycles = 500 }
local along = slide{ cycles = 500 }
near(turned.volume.total, along.volume.total, 1e-9, "gross slip along z has the volume of gross slip along x")

-- --- unlike bodies ---------------------------------------------------------------------------------
local function unlike(below, changes)
  local all = { model = below and pair(soft, steel, 0.016, true) or pair(steel, soft, 0.016), cycles = 100,
    alpha = below and 0.7 or 0.3 }
  for name, value in pairs(changes or {}) do all[name] = value end
  return fret(all):run{ progress = false }
end
local u, v = unlike(false), unlike(true)
ok(u.volume.total > 0 and u.gross == 0, "bodies of different materials are in partial slip")
near(v.volume.plate, u.volume.cylinder, 1e-4, "exchanged bodies of different materials: volume of the ball")
near(v.volume.cylinder, u.volume.plate, 1e-4, "exchanged bodies of different materials: volume of the block")
local broad = { tangential = false, stroke = 0.1, cycles = 20 }
u, v = unlike(false, broad), unlike(true, broad)
is(u.gross, 1, "bodies of different materials are in gross slip")
near(v.volume.plate, u.volume.cylinder, 1e-3, "exchanged bodies of different materials in gross slip: ball")
near(v.volume.cylinder, u.volume.plate, 1e-3, "exchanged bodies of different materials in gross slip: block")

-- --- loading ---------------------------------------------------------------------------------------
local breathing = fret{ cycles = false, tangential = false, distance = false,
  loading = { load = { 10, 12, 8, 10 }, tangential = { 0, 3, -3, 0 }, cycles = 200 } }:run{ progress = false }
ok(breathing.volume.total > 0 and breathing.gross == 0, "a normal load that varies with the tangential force")

-- --- refused ---------------------------------------------------------------------------------------
fails(function() fret{ tangential = 5 } end, "less than friction times the load",
  "a force above the friction limit")
fails(function() fret{ update = "increment" } end, "field 'update'", "friction with updates within a cycle")
fails(function()
  fret{ model = model{ geometry = "3-D", upper = body.ball{ radius = 10 }, lower = body.block{ height = 1 } } }
end, { "field 'friction'", "rigid base" }, "friction on a rigid base")
fails(function() fret{ track = 5, tangential = false, stroke = false } end, "field 'friction'",
  "friction of a pin on a disc")
holds(tostring(w), { "force of +-3.5 N", "sticks on" }, "print(run)")

-- Tests the warning that the slip annulus has too few cells for accurate wear and energy.
for _, case in ipairs{ { 0.5, true }, { 3.5, false } } do
  local warnings = require "archard.warnings"
  warnings.keep()
  fret{ tangential = case[1] }:step()
  local given = (warnings.take() or ""):find("slip annulus, [%d.]+ mm wide, has [%d.]+ cells: with fewer") ~= nil
  is(given, case[2], "a force of " .. case[1] .. " N: warning that the slip annulus has few cells")
end

-- --- the map of stick, partial slip and gross slip ----------------------------------------------------
do
  local modulus = 200e3 / (2 * (1 - 0.3 ^ 2))
  local half = (3 * 10 * 10 / (4 * modulus)) ^ (1 / 3)
  local limit = 3 * 0.5 * 10 * 2 * 1.7 * 2.6 / 200e3 / (16 * half) -- gross slip by Mindlin [mm]
  local warnings = require "archard.warnings"
  warnings.keep()
  local map = study.fretting_map{ friction = 0.5, load = { 10 }, motion = { 5e-5, 2e-4, 6e-4 },
    model = { geometry = "3-D", upper = body.ball{ radius = 10 }, lower = body.block{}, mesh = { size = half / 14 } } }
  warnings.take()
  near(map.gross_from[1], limit, 0.01, "map in 3-D: amplitude at the transition to gross slip")
  near(map.partial_from[1], limit * (1 - 0.9 ^ 2), 0.06,
    "map in 3-D: amplitude at the transition to partial slip")
  is(table.concat(map.regime[1], " "), "stick partial gross", "map in 3-D: regimes")
end

-- Tests that a force under which all of the contact slips is refused: one increment does not resolve its slip.
do
  local w = wear{ model = { geometry = "3-D", upper = body.ball{ radius = 10 }, lower = body.block{}, mesh = { size = 0.0126 } },
    load = 10, friction = 0.5, tangential = 5 * (1 - 2e-5), k = 1e-9, cycles = 1 }
  fails(function() w:run{ progress = false } end, { "field 'tangential'", "0.99998 of friction times the load", "stroke" },
    "wear under a force close to full slip")
end

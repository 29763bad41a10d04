-- Tests contact and wear in three dimensions against closed forms, tables, other solvers of this program
-- (axisymmetric and plane-strain finite elements) and other step lengths, and tests the order of
-- convergence.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, below, above = figures.within, figures.below, figures.above

local function even(from, to, count)
  local list = {}
  for i = 1, count do list[i] = from + (to - from) * (i - 1) / (count - 1) end
  return list
end

-- --- contacts on the default grid -------------------------------------------------------------------
local m = model{ geometry = "3-D" }
local c = contact{ model = m, load = 10 }
within(c.p_center, 615.942, 0.003, "ball, 10 N: centre pressure [MPa]")
within(c.approach, 7.75179e-4, 0.002, "ball: approach [mm]")
within(c.half_width, 0.0880442, 0.02, "ball: half width, to a cell [mm]")
local roller = contact{ model = model{ geometry = "3-D", upper = body.ball{ radius = 5, radius_z = 20 }, lower = body.block{} }, load = 20 }
within(roller.p_center, 816.46, 0.003, "ellipse: centre pressure [MPa]")
within(roller.approach, 1.19891e-3, 0.002, "ellipse: approach [mm]")
within(roller.half_width_z, 0.171021, 0.02, "ellipse: half width along z [mm]")

-- Tests a cone of slope t, given as a map: contact radius a = sqrt(2 P / (pi E* t)), approach pi a t / 2, and
-- p(a / 2) = E* t acosh(2) / 2. The pressure at the apex is unbounded.
local slope, a = 0.01, 0.0761133
local cone = map{ x = even(-0.3, 0.3, 301), z = even(-0.3, 0.3, 301), y = function(x, z) return -slope * math.sqrt(x * x + z * z) end }
local pointed = contact{ load = 10, model = { geometry = "3-D", upper = body.map{ y = cone }, lower = body.block{}, mesh = { size = a / 32 } } }
within(pointed.approach, math.pi / 2 * a * slope, 0.003, "cone: approach [mm]")
within(pointed.half_width, a, 0.02, "cone: half width [mm]")
local line = pointed:pressure{ z = 0 }
for i = 2, #line.x do
  if line.x[i - 1] < a / 2 and line.x[i] >= a / 2 then
    local share = (a / 2 - line.x[i - 1]) / (line.x[i] - line.x[i - 1])
    within((1 - share) * line.p[i - 1] + share * line.p[i], 723.603, 0.003,
      "cone: pressure at x = a / 2 [MPa]")
  end
end

-- Tests a rigid ball on layers bonded to a rigid base against results of another, independent program.
for _, row in ipairs{ { 1, 0.3, 29.190, 0.4059, 0.012998 }, { 0.1, 0.3, 64.59, 0.2994, 4.887e-3 }, { 1, 0.45, 31.985, 0.3875, 0.011474 } } do
  local thick, nu, p, half, approach = table.unpack(row)
  local d = contact{ load = 10, model = { geometry = "3-D", upper = body.ball{ radius = 10, E = 1e12 },
    lower = body.block{ height = thick, E = 1000, nu = nu } } }
  local name = ("layer of %g mm, nu %g: "):format(thick, nu)
  within(d.p_center, p, 0.003, name .. "centre pressure [MPa]")
  within(d.half_width, half, 0.03, name .. "half width [mm]")
  within(d.approach, approach, 0.002, name .. "approach [mm]")
end

-- Tests three coatings against axisymmetric finite elements of this program: one of the material of the base,
-- which must not change the contact, a hard one and a soft one.
for _, row in ipairs{ { 0.05, 200e3 }, { 0.05, 400e3 }, { 0.02, 100e3 } } do
  local coated = body.block{ layers = { { thickness = row[1], E = row[2] } } }
  local d = contact{ load = 50, model = { geometry = "3-D", upper = body.ball{ radius = 10 }, lower = coated } }
  local elements = contact{ load = 50, model = { geometry = "axisymmetric", lower = coated } }
  local name = ("coating of %g mm, E = %g MPa: "):format(row[1], row[2])
  if row[2] == 200e3 then within(d.approach, contact{ model = m, load = 50 }.approach, 1e-5,
    name .. "approach without a coating [mm]") end
  within(d.p_center, elements.p_center, 0.01, name .. "centre pressure by elements of revolution [MPa]")
  within(d.half_width, elements.half_width, 0.02, name .. "half width by elements of revolution [mm]")
end

-- Tests a flat round punch of radius c, given as a map of heights with a step at its edge. Exact values:
-- approach P / (2 E* c), p(0) = P / (2 pi c^2). The convergence is of first order because cells approximate
-- the edge by a staircase.
for _, row in ipairs{ { 41, 1.83020e-3 }, { 81, 1.82612e-3 }, { 161, 1.82197e-3 } } do
  local size, half = 2.2 * 0.25 / row[1], 0.3
  local reach = math.floor(half / size)
  local grid = even(-reach * size, reach * size, 2 * reach + 1)
  local punch = map{ x = grid, z = grid, y = function(x, z) return math.sqrt(x * x + z * z) <= 0.25 and 0 or -1 end }
  local d = contact{ load = 100, model = { geometry = "3-D", upper = body.map{ y = punch }, lower = body.block{}, mesh = { size = size } } }
  within(d.approach, row[2], 1e-4, ("flat punch, %d cells: approach [mm]"):format(row[1]))
  within(d.p_center, 254.648, 0.012, "flat punch: centre pressure [MPa]")
end

-- Tests waves D cos(2 pi x / l) cos(2 pi z / l). Contact is full above the mean pressure p* = sqrt(2) pi E* D
-- / l; then the pressure is the mean pressure plus a wave of the amplitude p*. Below p* the fraction of the
-- area in contact is compared with results of another, independent program, whose first cell is on a crest.
local length, modulus = 0.1, 200e3 / (1 - 0.09) / 2
local q, points = 2 * math.pi / length, even(0, length * 127 / 128, 128)
local crests = map{ x = points, z = points, y = function(x, z) return 1e-4 * math.cos(q * x) * math.cos(q * z) end }
local waves = model{ geometry = "3-D", periodic = true, upper = body.map{ y = crests }, lower = body.block{} }
local full = math.sqrt(2) * math.pi * modulus * 1e-4 / length
for _, row in ipairs{ { 0.1, 0.19397 }, { 0.2, 0.341431 }, { 0.4, 0.622437 }, { 0.6, 0.778198 }, { 0.8, 0.898804 }, { 0.9, 0.952026 } } do
  local d = contact{ model = waves, load = row[1] * full * length ^ 2 }
  figures.about(d.area / length ^ 2, row[2], 1e-3,
    ("waves under %g p*: fraction of the area in contact"):format(row[1]))
end
within(contact{ model = waves, load = 1.2 * full * length ^ 2 }.p_max, 2.2 * full, 1e-3, "waves in full contact: largest pressure [MPa]")
-- Tests the wear of waves in full contact: they decay as exp(-sqrt(2) pi k E* d / l).
local worn = wear{ model = waves, load = 1.5 * full * length ^ 2, stroke = 0.05, alpha = 1, distance = 20, k = 1e-8 }
worn:run()
within(worn.p_max / full - 1.5, math.exp(-1e-8 * modulus * math.sqrt(2) * math.pi / length * 20), 0.003,
  "worn waves: remaining amplitude")
within(worn.volume.total, 1e-8 * worn.load * 20, 1e-9, "worn waves: volume [mm3]")

-- --- order in the grid --------------------------------------------------------------------------------

-- Returns the depths with cells of a/4, a/8 or a/16 (fineness 0.5, 1, 2) after the same six steps with stroke
-- a, when both bodies wear.
local function depths(fineness)
  local w = wear{ model = { geometry = "3-D", mesh = { fineness = fineness } }, load = 10, stroke = 0.0880442, alpha = 0.5, distance = 600,
    scheme = "implicit", jump = 600 / (2 * 0.0880442) / 6 }
  w:run()
  return w.depth
end
local coarse, usual_grid, fine = depths(0.5), depths(1), depths(2)
for _, name in ipairs{ "ball", "block" } do
  below(math.abs(usual_grid[name] / fine[name] - 1), 0.005,
    "cells of a/8 against a/16: error of the depth, " .. name)
  above((coarse[name] - usual_grid[name]) / (usual_grid[name] - fine[name]), 2.5,
    "cells of a/4, a/8, a/16: ratio of differences (4 for second order), " .. name)
end

-- --- steps ---------------------------------------------------------------------------------------------
local function run(changes)
  local all = { model = m, load = 30, stroke = 0.12, alpha = 0.5, distance = 3000 }
  for name, value in pairs(changes) do all[name] = value end
  local w = wear(all)
  w:run()
  return w
end
local usual = run{}
local explicit = run{ scheme = "explicit" }
within(explicit.depth.ball, usual.depth.ball, 0.001,
  "automatic explicit against implicit steps: depth of the ball [mm]")
within(explicit.depth.block, usual.depth.block, 0.001,
  "automatic explicit against implicit steps: depth of the flat [mm]")
local tight = run{ scheme = "implicit", tolerance = 1e-4 }
within(usual.depth.ball, tight.depth.ball, 0.001, "tolerance 1e-3 against 1e-4: depth of the ball [mm]")
within(usual.depth.block, tight.depth.block, 0.001, "tolerance 1e-3 against 1e-4: depth of the flat [mm]")
local few = run{ scheme = "implicit", jump = 3000 / (2 * 0.12) / 8 }
within(few.depth.ball, tight.depth.ball, 0.001,
  "8 equal steps against steps with tolerance 1e-4: depth of the ball [mm]")
within(few.depth.block, tight.depth.block, 0.001,
  "8 equal steps against steps with tolerance 1e-4: depth of the flat [mm]")

-- --- other solvers ---------------------------------------------------------------------------------------

-- Tests wear of the ball alone against axisymmetric finite elements. The bodies of finite elements are 10 mm
-- high, so their approach is 0.9 % smaller than for half-spaces.
local spot = { load = 50, alpha = 1, distance = 2000, k = 1e-8 }
local revolved = wear{ load = spot.load, alpha = 1, distance = spot.distance, slide = "z", scheme = "implicit", tolerance = 1e-3,
  model = { geometry = "axisymmetric", mesh = { size = 0.01, height = 0.01, zone = { cylinder = 1.2, plate = 1.2 } } } }
local here = wear{ model = m, load = spot.load, alpha = 1, distance = spot.distance }
within(contact{ model = m, load = 50 }.approach, contact{ model = revolved.model, load = 50 }.approach, 0.01, "ball: approach by elements of revolution [mm]")
within(contact{ model = m, load = 50 }.p_center, contact{ model = revolved.model, load = 50 }.p_center, 0.005,
  "ball: centre pressure by elements of revolution [MPa]")
revolved:run()
here:run()
within(here.depth.ball, revolved.depth.cylinder, 0.01,
  "ball that wears alone: depth by elements of revolution [mm]")
within(here.p_center, revolved.p_center, 0.02,
  "ball that wears alone: centre pressure by elements of revolution [MPa]")

-- Tests the wear in the middle of a long crowned roller against the plane model under the same load per
-- length. This load is the area that both bodies have lost in the section z = 0, divided by k times the
-- distance.
local long = model{ geometry = "3-D", upper = body.ball{ radius = 10, radius_z = 1000 }, lower = body.block{} }
local rolled = wear{ model = long, load = 270, stroke = 0.11, alpha = 0.5, distance = 400, k = 1e-8 }
rolled:run()
local area = 0
for _, name in ipairs{ "ball", "block" } do
  local section = rolled:profile(name, { z = 0 })
  for i = 2, #section.x do area = area + (section.h[i] + section.h[i - 1]) / 2 * (section.x[i] - section.x[i - 1]) end
end
local plane = wear{ load = area / (1e-8 * 400), stroke = 0.11, alpha = 0.5, distance = 400, k = 1e-8, scheme = "implicit", tolerance = 1e-3 }
plane:run()
within(rolled.depth.ball, plane.depth.cylinder, 0.01,
  "long roller: depth in its middle by the plane model [mm]")
within(rolled.depth.block, plane.depth.plate, 0.01, "flat under it [mm]")

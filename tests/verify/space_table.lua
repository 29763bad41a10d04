-- Contact and wear in three dimensions by scripts: closed forms and tables, order of convergence, other solvers of this
-- program (finite elements of revolution and of plane strain), other steps.
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
within(c.half_width, 0.0880442, 0.02, "ball: half width, a staircase of cells [mm]")
local roller = contact{ model = model{ geometry = "3-D", upper = body.ball{ radius = 5, radius_z = 20 }, lower = body.block{} }, load = 20 }
within(roller.p_center, 816.46, 0.003, "ellipse: centre pressure [MPa]")
within(roller.approach, 1.19891e-3, 0.002, "ellipse: approach [mm]")
within(roller.half_width_z, 0.171021, 0.02, "ellipse: half width across [mm]")

-- A cone as a map: a = sqrt(2 P / (pi E* t)), approach pi a t / 2, p(a / 2) = E* t acosh(2) / 2; p(0) is unbounded.
local slope, a = 0.01, 0.0761133
local cone = map{ x = even(-0.3, 0.3, 301), z = even(-0.3, 0.3, 301), y = function(x, z) return -slope * math.sqrt(x * x + z * z) end }
local pointed = contact{ load = 10, model = { geometry = "3-D", upper = body.map{ y = cone }, lower = body.block{}, mesh = { size = a / 32 } } }
within(pointed.approach, math.pi / 2 * a * slope, 0.003, "cone: approach [mm]")
within(pointed.half_width, a, 0.02, "cone: half width [mm]")
local line = pointed:pressure{ z = 0 }
for i = 2, #line.x do
  if line.x[i - 1] < a / 2 and line.x[i] >= a / 2 then
    local share = (a / 2 - line.x[i - 1]) / (line.x[i] - line.x[i - 1])
    within((1 - share) * line.p[i - 1] + share * line.p[i], 723.603, 0.003, "cone: pressure halfway [MPa]")
  end
end

-- A rigid ball on layers bonded to a rigid base.
for _, row in ipairs{ { 1, 0.3, 29.190, 0.4059, 0.012998 }, { 0.1, 0.3, 64.59, 0.2994, 4.887e-3 }, { 1, 0.45, 31.985, 0.3875, 0.011474 } } do
  local thick, nu, p, half, approach = table.unpack(row)
  local d = contact{ load = 10, model = { geometry = "3-D", upper = body.ball{ radius = 10, E = 1e12 },
    lower = body.block{ height = thick, E = 1000, nu = nu } } }
  local name = ("layer of %g mm, nu %g: "):format(thick, nu)
  within(d.p_center, p, 0.003, name .. "centre pressure [MPa]")
  within(d.half_width, half, 0.03, name .. "half width [mm]")
  within(d.approach, approach, 0.002, name .. "approach [mm]")
end

-- --- order in the grid --------------------------------------------------------------------------------
-- Depths with cells of a/4, a/8 and a/16 after the same six steps, stroke a, both bodies worn.
local function depths(fineness)
  local w = wear{ model = { geometry = "3-D", mesh = { fineness = fineness } }, load = 10, stroke = 0.0880442, alpha = 0.5, distance = 600,
    scheme = "implicit", jump = 600 / (2 * 0.0880442) / 6 }
  w:run()
  return w.depth
end
local coarse, usual_grid, fine = depths(0.5), depths(1), depths(2)
for _, name in ipairs{ "ball", "block" } do
  below(math.abs(usual_grid[name] / fine[name] - 1), 0.005, "a/8 off from a/16, depth of the " .. name)
  above((coarse[name] - usual_grid[name]) / (usual_grid[name] - fine[name]), 2.5, "ratio of the differences, order two is 4: " .. name)
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
local explicit = run{ jump = "auto" }
within(explicit.depth.ball, usual.depth.ball, 0.001, "explicit with auto steps against implicit: ball")
within(explicit.depth.block, usual.depth.block, 0.001, "flat")
local tight = run{ scheme = "implicit", tolerance = 1e-4 }
within(usual.depth.ball, tight.depth.ball, 0.001, "tolerance 1e-3 against 1e-4: ball")
within(usual.depth.block, tight.depth.block, 0.001, "flat")
local few = run{ scheme = "implicit", jump = 3000 / (2 * 0.12) / 8 }
within(few.depth.ball, tight.depth.ball, 0.001, "8 equal steps against graded ones: ball")
within(few.depth.block, tight.depth.block, 0.001, "flat")

-- --- other solvers ---------------------------------------------------------------------------------------
-- Only the ball wears, compared with finite elements of revolution: bodies of 10 mm are stiffer by .9 % in the
-- approach.
local spot = { load = 50, alpha = 1, distance = 2000, k = 1e-8 }
local revolved = wear{ load = spot.load, alpha = 1, distance = spot.distance, slide = "z", scheme = "implicit", tolerance = 1e-3,
  model = { geometry = "axisymmetric", mesh = { size = 0.01, height = 0.01, zone = { cylinder = 1.2, plate = 1.2 } } } }
local here = wear{ model = m, load = spot.load, alpha = 1, distance = spot.distance }
within(contact{ model = m, load = 50 }.approach, contact{ model = revolved.model, load = 50 }.approach, 0.01, "ball: approach by elements of revolution [mm]")
within(contact{ model = m, load = 50 }.p_center, contact{ model = revolved.model, load = 50 }.p_center, 0.005, "ball: centre pressure by them [MPa]")
revolved:run()
here:run()
within(here.depth.ball, revolved.depth.cylinder, 0.01, "ball worn alone: depth by them [mm]")
within(here.p_center, revolved.p_center, 0.02, "its centre pressure [MPa]")

-- Tests wear in three dimensions against an independent computation of the same problem, and its exact
-- symmetries: volumes, exchange of bodies, and mirror symmetry across the motion.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, below = figures.within, figures.below

local m, finer = model{ geometry = "3-D" }, model{ geometry = "3-D", mesh = { fineness = 2 } }
local function run(load, stroke, alpha, distance, changes)
  local all = { model = m, load = load, stroke = stroke, alpha = alpha, distance = distance, k = 1e-8 }
  for name, value in pairs(changes or {}) do all[name] = value end
  local w = wear(all)
  w:run()
  return w
end

-- --- ball of 10 mm, 10 N, 1320 mm: depths of both bodies [mm] --------------------------------------

-- A stroke of half a contact width is integrated with four positions, with an error of 1 %.
local short = {
  [0] = { 0, 1.97333e-3 }, [0.25] = { 5.1384e-4, 1.47537e-3 }, [0.5] = { 1.01401e-3, 9.8532e-4 },
  [0.75] = { 1.50853e-3, 4.9526e-4 }, [1] = { 2.00459e-3, 0 },
}
local runs = {}
for alpha, depth in pairs(short) do
  local w = run(10, 0.04, alpha, 1320)
  runs[alpha] = w
  if alpha > 0 then within(w.depth.ball, depth[1], 0.01,
    ("stroke 0.04 mm, alpha %g: depth of the ball [mm]"):format(alpha)) end
  if alpha < 1 then within(w.depth.block, depth[2], 0.01,
    ("stroke 0.04 mm, alpha %g: depth of the flat [mm]"):format(alpha)) end
  within(w.volume.total, 1e-8 * 10 * 1320, 1e-9, ("stroke 0.04 mm, alpha %g: volume [mm3]"):format(alpha))
  if alpha > 0 then within(w.volume.ball, alpha * 1e-8 * 10 * 1320, 1e-9,
    ("stroke 0.04 mm, alpha %g: volume of the ball [mm3]"):format(alpha)) end
end

local halved = run(10, 0.04, 0.5, 1320, { model = finer })
within(halved.depth.ball, 1.01279e-3, 0.0015, "stroke 0.04 mm on cells of a/16: depth of the ball [mm]")
within(halved.depth.block, 9.8716e-4, 0.0015, "stroke 0.04 mm on cells of a/16: depth of the flat [mm]")

-- --- 30 N, 3000 mm -----------------------------------------------------------------------------------
for _, case in ipairs{
  { 0.12, 0.5, 2.7963e-3, 2.3964e-3, 0.53850 }, { 0.12, 0, 0, 5.0166e-3 },
  { 0.36, 0.5, 3.1105e-3, 1.8247e-3, 0.63027 }, { 0.36, 0, 0, 4.3547e-3 }, { 0.36, 1, 5.2699e-3, 0 },
} do
  local w = run(30, case[1], case[2], 3000)
  local name = ("30 N, stroke %g, alpha %g: "):format(case[1], case[2])
  if case[3] > 0 then within(w.depth.ball, case[3], 0.005, name .. "depth of the ball [mm]") end
  if case[4] > 0 then within(w.depth.block, case[4], 0.005, name .. "depth of the flat [mm]") end
  if case[5] then figures.about(w.depth_partition, case[5], 0.003, name .. "depth partition") end
  within(w.volume.total, 9e-4, 1e-9, name .. "volume [mm3]")
end
local early = run(30, 0.12, 0.5, 500)
within(early.depth.ball, 1.0568e-3, 0.005, "30 N, stroke 0.12 mm, after 500 mm: depth of the ball [mm]")
within(early.depth.block, 9.642e-4, 0.005, "30 N, stroke 0.12 mm, after 500 mm: depth of the flat [mm]")
local fine = run(30, 0.12, 0.5, 3000, { model = finer })
within(fine.depth.ball, 2.7949e-3, 0.0015, "30 N, stroke 0.12 mm on cells of a/16: depth of the ball [mm]")
within(fine.depth.block, 2.3987e-3, 0.0015, "30 N, stroke 0.12 mm on cells of a/16: depth of the flat [mm]")
figures.about(fine.depth_partition, 0.53815, 0.001, "30 N, stroke 0.12 mm on cells of a/16: depth partition")

-- --- long strokes: all positions, and the track as a groove -----------------------------------------

-- The two computations agree within 3 % in the depth of the groove's middle (except near its ends) and within
-- 0.5 % in the ball's depth.
for _, case in ipairs{ { 0, 0, 7.3231e-4 }, { 0.25, 8.5054e-4, 4.6460e-4 }, { 0.5, 1.31788e-3, 2.8773e-4 }, { 0.75, 1.68647e-3, 1.3841e-4 } } do
  local w = wear{ model = m, load = 10, stroke = 1, alpha = case[1], distance = 1320, procedure = "NSP" }
  w:run()
  local name = ("stroke 1 as a groove, alpha %g: "):format(case[1])
  if case[2] > 0 then within(w.depth.ball, case[2], 0.005, name .. "depth of the ball [mm]") end
  within(w.depth.block, case[3], 0.03, name .. "depth of the groove [mm]")
  within(w.volume.total, 1.32e-4, 1e-9, name .. "volume [mm3]")
  local all = run(10, 1, case[1], 1320)
  name = ("stroke 1, all positions, alpha %g: "):format(case[1])
  if case[2] > 0 then within(all.depth.ball, case[2], 0.005, name .. "depth of the ball [mm]") end
  within(all:map("block"):at(0, 0), case[3], 0.005, name .. "depth in the middle of the flat [mm]")
end

-- Tests bodies a thousand times as stiff as steel against rigid bodies, whose depths follow from an
-- integration over the distance. If only the flat wears, the area of the groove's middle section is 4/3
-- sqrt(2 R) h^(3/2), the volume divided by the stroke.
local rigid = model{ geometry = "3-D", upper = body.ball{ radius = 10, E = 2e8 }, lower = body.block{ E = 2e8 }, mesh = { size = 0.0125 } }
local both = run(10, 1, 0.5, 1320, { model = rigid, procedure = "NSP" })
within(both.depth.ball, 1.3621e-3, 0.002, "nearly rigid bodies, stroke 1 mm: depth of the ball [mm]")
within(both.depth.block, 2.9974e-4, 0.002, "nearly rigid bodies, stroke 1 mm: depth of the groove [mm]")
-- The edge of the pressure between rigid bodies is located to one cell only, and rounding errors of another
-- BLAS can move it by a cell. The tolerance is therefore one cell, 0.076 of the half width.
within(both.half_width, 0.16505, 0.076, "nearly rigid bodies: half width along the motion, to a cell [mm]")
within(both.half_width_z, 0.18231, 0.076, "nearly rigid bodies: half width across the motion, to a cell [mm]")
within(run(10, 1, 0, 1320, { model = rigid }):map("block"):at(0, 0), (0.75 * 1.32e-4 / math.sqrt(20)) ^ (2 / 3), 0.005,
  "nearly rigid bodies, only the flat wears: depth of the groove [mm]")

-- --- a power law after much wear --------------------------------------------------------------------

-- Tests a power law against the closed form of rigid bodies at one position. The pressure p = P / (pi c^2),
-- the law dh = k p (p / p0)^n dd and the cap h = c^2 / 2R yield c^(4 + 2n) = (4 + 2n) R k P^(1 + n) d /
-- (pi^(1 + n) p0^n). Elasticity widens the contact and reduces the depth by 1.5 to 2.7 % (n = 0 to 2).
local function cap(n, p0)
  return ((4 + 2 * n) * 10 * 1e-8 * 30 ^ (1 + n) * 3000 / (math.pi ^ (1 + n) * p0 ^ n)) ^ (1 / (2 + n)) / 20
end
for _, n in ipairs{ 0.5, 1, 2 } do
  local w = wear{ model = m, load = 30, stroke = 0.36, alpha = 1, distance = 3000, law = "power", law_exponent = n, law_pressure = 100 }
  w:run()
  within(w.depth.ball, cap(n, 100), 0.03, ("power law, exponent %g: depth of the cap [mm]"):format(n))
end
for _, stroke in ipairs{ 0.04, 0.2 } do
  local law = { model = m, load = 10, stroke = stroke, alpha = 0.5, distance = 1320, law = "power", law_exponent = 1, law_pressure = 300 }
  local implicit = wear(law)
  implicit:run()
  law.scheme = "explicit"
  local explicit = wear(law)
  explicit:run()
  within(implicit.depth.ball, explicit.depth.ball, 1e-3,
    ("power law, stroke %g: explicit against implicit, depth of the ball [mm]"):format(stroke))
  within(implicit.depth.block, explicit.depth.block, 1e-3,
    "power law: explicit against implicit, depth of the flat [mm]")
  within(implicit.volume.total, explicit.volume.total, 1e-3,
    "power law: explicit against implicit, volume [mm3]")
end

-- --- symmetries ------------------------------------------------------------------------------------

-- Tests the mirror symmetry of the depths across the motion, cell by cell.
local function asymmetry(t)
  local nx, nz, most, largest = #t.x, #t.z, 0, 0
  for i = 1, nx do
    for j = 1, nz do
      most = math.max(most, math.abs(t.y[(i - 1) * nz + j] - t.y[(i - 1) * nz + nz + 1 - j]))
      largest = math.max(largest, t.y[(i - 1) * nz + j])
    end
  end
  return most / largest
end
below(asymmetry(runs[0.25]:map "ball"), 1e-9, "asymmetry across the motion: ball")
below(asymmetry(runs[0.25]:map "block"), 1e-9, "asymmetry across the motion: flat")

-- Tests that two rough bodies and their mirror images across the motion wear by the same depths.
local function rough(side)
  local x, up, low = {}, {}, {}
  for i = 1, 121 do x[i] = 0.005 * (i - 61) end
  for _, u in ipairs(x) do
    for _, z in ipairs(x) do
      local v = side * z
      up[#up + 1] = 4e-4 * (math.sin(70 * u + 1) * math.cos(43 * v + 0.5) + 0.5 * math.sin(100 * v + 0.2))
      low[#low + 1] = 4e-4 * (math.cos(57 * u + 0.3) * math.sin(37 * v + 0.9) + 0.3 * math.cos(33 * (u + v)))
    end
  end
  local w = wear{ model = { geometry = "3-D", upper = body.map{ x = x, z = x, y = up, radius = 5 },
    lower = body.map{ x = x, z = x, y = low } }, load = 5, stroke = 0.1, distance = 200, k = 1e-7 }
  w:run{ progress = false }
  return w
end
local one, other = rough(1), rough(-1)
for _, name in ipairs{ "upper", "lower" } do
  local a, b, most = one:map(name), other:map(name), 0
  local nz = #a.z
  for i = 1, #a.x do
    for j = 1, nz do most = math.max(most, math.abs(a.y[(i - 1) * nz + j] - b.y[i * nz + 1 - j])) end
  end
  below(most / one.depth[name], 1e-9, "mirror images of two rough bodies: depths of the " .. name .. " body")
end

-- Tests the exchange of bodies, with the flat as the upper body: both bodies wear by the same amounts in the
-- same motion.
local turned = model{ geometry = "3-D", upper = body.block{}, lower = body.ball{ radius = 10 } }
-- fixed steps, because error-controlled steps would differ
local even = { scheme = "implicit", jump = 1320 / 0.08 / 16 }
local straight = run(10, 0.04, 0.25, 1320, even)
even.model = turned
local w = run(10, 0.04, 0.75, 1320, even)
within(w.volume.ball, straight.volume.ball, 1e-9, "exchange of bodies: volume of the ball [mm3]")
within(w.depth.ball, straight.depth.ball, 1e-9, "exchange of bodies: depth of the ball [mm]")
within(w.depth.block, straight.depth.block, 1e-9, "exchange of bodies: depth of the flat [mm]")

-- Tests the exchange of bodies if only the flat wears, for a stroke as long as the contact and for a long
-- stroke.
for _, stroke in ipairs{ 0.2, 1 } do
  local function run(upper, lower, alpha)
    local made = wear{ model = { geometry = "3-D", upper = upper, lower = lower }, stroke = stroke, k = 2e-8, load = 6, distance = 200, alpha = alpha }
    return made:run{ progress = false } or made
  end
  local flat_below, flat_above = run(body.ball{ radius = 4 }, body.block{}, 0), run(body.block{}, body.ball{ radius = 4 }, 1)
  within(flat_above.depth.upper, flat_below.depth.lower, 5e-4,
    "exchange of bodies, stroke " .. stroke .. " mm: depth of the flat [mm]")
  within(flat_above.p_max, flat_below.p_max, 5e-4,
    "exchange of bodies, stroke " .. stroke .. " mm: pressure [MPa]")
end

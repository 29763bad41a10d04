-- A steel ball on a steel flat under an oscillating force below the friction limit: the middle of the contact sticks,
-- and an annulus around it slips and wears. Mindlin's displacement and loop beside the computed ones, then the wear of
-- 10 000 cycles.
--   archard examples/42_fretting_ball.lua

local radius, load, friction, share = 10, 10, 0.5, 0.6 -- mm, N, -, force over friction times load
local m = model{ geometry = "3-D", upper = body.ball{ radius = radius }, lower = body.block{} }
local h = hertz{ geometry = "3-D", radius = radius, load = load }
local nu = 0.3
local G = 200e3 / (2 * (1 + nu))

-- --- one loop -----------------------------------------------------------------------------------
local yield = 2 * (2 - nu) / G -- of both bodies, (2 - nu) / G each
local stick = (1 - share) ^ (1 / 3)
local motion = 3 * friction * load / (16 * h.half_width) * yield * (1 - stick ^ 2)
local energy = 9 * (friction * load) ^ 2 / (10 * h.half_width) * yield *
  (1 - stick ^ 5 - 5 * share / 6 * (1 + stick ^ 2))

local force = share * friction * load
local c = contact{ model = m, load = load, friction = friction }:move{ tangential = force }
local back = c:move{ tangential = -force }
local round = back:move{ tangential = force }
print(("displacement %.4f um (Mindlin %.4f), stick radius %.4f mm (%.4f), energy of the loop %.3e N mm (%.3e)"):format(
  1e3 * c.x, 1e3 * motion, h.half_width * math.sqrt(c.stick), stick * h.half_width, round.energy - c.energy, energy))
plot.shear(c)

-- --- wear ---------------------------------------------------------------------------------------
local began = os.clock()
local w = wear{ model = m, load = load, friction = friction, tangential = force, k = 1e-6, alpha = 0.5, cycles = 1e4 }
w:run()
print(w)
print(("%d updates in %.1f s"):format(w.update, os.clock() - began))
plot.map(w)

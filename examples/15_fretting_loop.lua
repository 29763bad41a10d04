-- Fretting loops of a cylinder on a plate with friction 0.6 under 100 N, for strokes from partial to gross
-- slip. In partial slip the loop is narrow, and the middle of the contact sticks. In gross slip the loop is
-- a parallelogram of height 2 mu L, and its area is the friction energy of the cycle.
--   archard examples/15_fretting_loop.lua

local bodies = model{ mesh = { size = 0.01, height = 0.0125 } }
local loops, titles = {}, {}
for i, stroke in ipairs{ 0.002, 0.005, 0.010, 0.020 } do -- mm
  local w = wear{ model = bodies, friction = 0.6, load = 100, stroke = stroke, cycles = 100, increments = 80 }
  w:step() -- the fields printed below describe the cycle after this step
  loops[i], titles[i] = w:loop(), ("stroke %g µm"):format(1e3 * stroke)
  print(("stroke %4.0f um: %-12s %.4f mm stick, force up to %5.2f N, %.3e N mm a cycle"):format(1e3 * stroke,
    w.gross == 1 and "gross slip," or "partial slip,", w.stick_width, w.largest_shear, w.cycle_energy))
end
print()

plot.loop(loops[1], loops[2], loops[3], loops[4], { titles = titles })

-- A ball that slides to and fro on a flat in three dimensions. Both bodies wear, and their scars are shown
-- as maps and sections.
--   archard examples/31_ball_on_flat.lua

local m = model{ geometry = "3-D", upper = body.ball{ radius = 10 }, lower = body.block{} }
local h = hertz{ geometry = "3-D", radius = 10, load = 10 }
local c = contact{ model = m, load = 10 }
print(("unworn: %.1f MPa in the centre, Hertz %.1f MPa; half width %.4f mm, Hertz %.4f mm"):format(
  c.p_center, h.p_max, c.half_width, h.half_width))

local began = os.clock()
local w = wear{ model = m, load = 10, stroke = 0.2, alpha = 0.5, k = 1e-8, distance = 1320 }
w:run()
print(w)
print(("%d updates in %.1f s"):format(w.update, os.clock() - began))

local along, across = w:profile("block", { z = 0 }), w:profile("block", { x = 0 })
local function um(depths)
  local result = {}
  for i, h in ipairs(depths) do result[i] = 1e3 * h end
  return result
end
plot{ title = "Scar of the flat", xlabel = "x or z / mm", ylabel = "wear depth / µm", ydown = true,
  { x = along.x, y = um(along.h), title = "along the motion, z = 0" },
  { x = across.x, y = um(across.h), title = "across it, x = 0" } }

-- A ball on a coated flat in three dimensions: pressures with a hard and a soft coating, and the thickness
-- of coating that remains in the middle of the scar. The model uses the compliance of the unworn coating;
-- the results are therefore valid only while little of the coating is worn.
--   archard examples/38_coating_3d.lua

local radius, load, thickness = 5, 10, 0.02 -- mm, N, mm
local function pair(E)
  local layers = E and { { thickness = thickness, E = E } } or nil
  return model{ geometry = "3-D", upper = body.ball{ radius = radius }, lower = body.block{ layers = layers } }
end

local curves = {}
for _, coat in ipairs{ { "none" }, { "hard, 600 GPa", 600e3 }, { "soft, 10 GPa", 10e3 } } do
  local c = contact{ model = pair(coat[2]), load = load }
  print(("coat %-14s %6.1f MPa in the centre, half width %.4f mm, approach %.3f um"):format(coat[1] .. ":", c.p_center, c.half_width,
    1e3 * c.approach))
  local line = c:pressure{ z = 0 }
  curves[#curves + 1] = { x = line.x, y = line.p, title = coat[1] }
end

-- The coat wears a tenth as fast as the ball.
local w = wear{ model = pair(600e3), load = load, stroke = 0.2, k_cylinder = 1e-8, k_plate = 1e-9, distance = 400 }
w:run()
print(("after %g mm: ball worn by %.3f um, coat by %.3f of %g um"):format(w.distance, 1e3 * w.depth.ball, 1e3 * w.depth.block,
  1e3 * thickness))
plot.map(w, { body = "block" })
curves.title, curves.xlabel, curves.ylabel = "Pressure under a ball on coats of 20 µm", "x / mm", "p / MPa"
plot(curves)

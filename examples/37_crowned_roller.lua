-- A crowned roller that slides to and fro on a flat: an elliptic contact in which both bodies wear. The
-- scar across the roller is compared with the line contact of a plane model at the middle of the roller.
--   archard examples/37_crowned_roller.lua

local radius, crown, load = 5, 60, 40 -- mm along and across the motion, N
local m = model{ geometry = "3-D", upper = body.ball{ radius = radius, radius_z = crown, name = "roller" }, lower = body.block{} }
local h = hertz{ geometry = "3-D", radius = radius, radius_z = crown, load = load }
local c = contact{ model = m, load = load }
print(("unworn: %.1f MPa, half widths %.4f and %.4f mm; Hertz' ellipse: %.1f MPa, %.4f and %.4f mm"):format(c.p_center, c.half_width,
  c.half_width_z, h.p_max, h.half_width, h.half_width_z))

local w = wear{ model = m, load = load, stroke = 0.3, alpha = 0.3, k = 1e-8, distance = 1000 }
local sections = {}
for _, distance in ipairs{ 100, 400, 1000 } do
  w:run{ distance = distance }
  local line, depths = w:profile("roller", { x = 0 }), {}
  for i, depth in ipairs(line.h) do depths[i] = 1e3 * depth end
  sections[#sections + 1] = { x = line.x, y = depths, title = ("%g mm"):format(distance) }
  print(("%4g mm: %.0f MPa, scar %.2f mm across; roller %.3f um, flat %.3f um deep"):format(distance, w.p_center, 2 * w.half_width_z,
    1e3 * w.depth.roller, 1e3 * w.depth.block))
end

-- Load per length in the middle of the roller: the area worn there, divided by k times the distance. A
-- plane model is run under this load.
local area = 0
for _, name in ipairs{ "roller", "block" } do
  local line = w:profile(name, { z = 0 })
  for i = 2, #line.x do area = area + (line.h[i] + line.h[i - 1]) / 2 * (line.x[i] - line.x[i - 1]) end
end
local plane = wear{ model = { radius = radius }, load = area / (1e-8 * w.distance), stroke = 0.3, alpha = 0.3, k = 1e-8, distance = w.distance }
plane:run()
print(("a line contact with the %.1f N/mm of its middle: %.3f and %.3f um"):format(plane.load, 1e3 * plane.depth.cylinder,
  1e3 * plane.depth.plate))
plot{ title = "Scar of a crowned roller, across the motion", xlabel = "z / mm", ylabel = "wear depth / µm", ydown = true, table.unpack(sections) }

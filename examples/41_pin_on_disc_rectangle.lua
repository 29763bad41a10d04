-- Pin-on-disc tests along rectangles of sides a and b, whose cross-shear is exactly b / (a + b).
-- Polyethylene pins are moved along rectangles because they wear much less along a line. Here a ball in a
-- socket that rotates by a few degrees follows the same paths. The cross-shear under the load has the value
-- b / (a + b), and the volume shows the effect of a coefficient that grows with cross-shear.
--   archard examples/41_pin_on_disc_rectangle.lua
-- The coefficient is an example with a magnitude seen in pin-on-disc tests. The model does not include
-- lubrication and the reorientation of molecules.

local function k(s) return 1e-9 * math.min(0.2 + 3.2 * s.cross_shear, 1) end
local seat = joint{ foundation = "winkler", mesh = { size = 4 },
  cup = { clearance = 0.1, layers = { { thickness = 8, material = material{ E = 1000, nu = 0.4 } } } } }

-- Returns a gait that moves along a rectangle at constant speed. a, b: sides as angles of flexion and
-- adduction [degree].
local function rectangle(a, b)
  local turn = a / (2 * (a + b))
  return gait{ t = { 0, turn, 0.5, 0.5 + turn, 1 }, flexion = { 0, a, a, 0, 0 }, adduction = { 0, 0, b, b, 0 }, load = 1000, increments = 48 }
end

print("  sides     b / (a + b)  cross-shear  mm3 a million cycles  mm3 / (N m)")
for _, b in ipairs{ 0.5, 1, 2, 3, 4, 5, 6 } do
  local a = 12 - b -- all paths have the same length
  local w = wear{ model = seat, loading = rectangle(a, b), k = k, alpha = 0, cycles = 1e5, updates = 4 }:run()
  local map = w:map "cross shear"
  local n = #map.theta
  local under_load = map.values[(n // 2) * 2 * n + n] -- the cell beside the direction of the load
  local volume = w.volume.cup / w.cycle * 1e6
  print(("%5.1f x %.1f %9.4f %12.4f %16.3f %16.3g"):format(a, b, b / 12, under_load, volume, 1000 * w.volume.cup / w.cycle / w.loading.work))
end
plot.track(rectangle(9, 3)) -- paths of points of the pin over the plate

-- A steel pin in a liner of UHMWPE, in a plane section. Only the liner wears, and the contact widens until
-- the pressure follows the cosine of the angle. x is the length along the liner's arc.
--   archard examples/27_pin_in_bush.lua

local R, clearance, load = 14, 0.1, 100 -- mm, mm, N for each mm
local joint = model{
  upper = body.disc{ radius = R - clearance },
  lower = body.ring{ inner = R, outer = R + 8, E = 850, nu = 0.46, k = 1e-6 },
  mesh = { size = 0.4, height = 0.2, rows = 4, far = 2, zone = { cylinder = 38, plate = 38 } } }
local new = contact{ model = joint, load = load }
print(("new: %.2f MPa, contact over %.1f degrees on either side, %.1f N along the normals"):format(new.p_center,
  math.deg(new.half_width / R), new.normal_force))

local w = wear{ model = joint, load = load, stroke = 0.1, distance = 2e4 } -- oscillating rotation
w:run()
print(("after %g m: %.2f MPa, liner worn by %.1f um and %.3f mm3"):format(w.distance / 1e3, w.p_center, 1e3 * w.depth_plate,
  w.volume_plate))
print(("k times the normal force times the distance: %.3f mm3"):format(1e-6 * w.load_distance))
plot.pressure(new, w:contact(), { titles = { "new", "worn" }, title = "A joint in its liner" })

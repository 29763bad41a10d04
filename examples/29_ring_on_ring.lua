-- A copper ring of circular section that rotates on a flat steel ring. The radius of the section is 30 mm,
-- and its centre is 100 mm from the axis. The load is high enough for elastic effects to be visible. First
-- only the copper wears, then both rings. The slip grows with the distance from the axis.
--   archard examples/29_ring_on_ring.lua

local load, seconds = 150796320, 3 -- N, s; at one turn a second, copper loses 6.283e-5 mm per second and MPa
local k, turn = 1e-7, 2 * math.pi * 100 -- mm2/N, mm at the mean radius
local rings = model{ geometry = "axisymmetric", axis = 100,
  upper = body.cylinder{ radius = 30, E = 120e3, nu = 0.34 }, lower = body.block{ width = 100, height = 40 },
  mesh = { size = 0.8, height = 0.8, rows = 7, far = 4, zone = { cylinder = 44, plate = 44 } } }

warn "@off" -- copper would yield at these pressures, which causes a warning
local new = contact{ model = rings, load = load }
print(("new: %.0f MPa at the mean radius, %.0f MPa at most, %.2f mm wide"):format(new.p_center, new.p_max, 2 * new.half_width))

local contacts, titles = { new }, { "new" }
for _, case in ipairs{ { "copper alone", k, 0 }, { "both", k, k } } do
  local what, copper, steel = table.unpack(case)
  local began = os.clock()
  local w = wear{ model = rings, load = load, slide = "z", spin = 100, k_cylinder = copper, k_plate = steel,
    distance = seconds * turn }
  w:run()
  print(("%s, %g s: %.0f MPa, worn by %.3f and %.3f mm, %.0f and %.0f mm3, in %.0f updates and %.1f s"):format(what, seconds,
    w.p_center, w.depth_cylinder, w.depth_plate, w.volume_cylinder, w.volume_plate, w.update, os.clock() - began))
  contacts[#contacts + 1], titles[#titles + 1] = w:contact(), what
end
plot.pressure(contacts[1], contacts[2], contacts[3], { titles = titles,
  title = "A copper ring on a steel ring, both elastic however high the pressure" })

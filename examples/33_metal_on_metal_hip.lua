-- A metal-on-metal hip of 28 mm over a million cycles of walking; head and cup both wear. The head's share
-- of the wear coefficient (alpha) determines the depths of both scars, but not their shapes: the scar of
-- the head is wider.
--   archard examples/33_metal_on_metal_hip.lua
-- The angles and the load of walking have the ranges of the standard; the curves between these ranges are
-- approximate. The model does not include edge loading, microseparation and lubrication, which cause many
-- clinical failures.

local j = joint{ head = { radius = 14, material = material{ E = 230e3, nu = 0.3 } }, cup = { clearance = 0.06 } }
local c = contact{ model = j, load = 3000 }
print(("unworn, 3 kN: %.1f MPa on %.0f mm2; 47 MPa and 74 mm2 are published for a hip of this kind"):format(c.p_max, c.area))

local walk = gait "iso"
print(walk)
print(" alpha  cup [um]  head [um]  both [mm3]  head's share of depth")
local last
for _, alpha in ipairs{ 0, 0.25, 0.75, 1, 0.5 } do
  last = wear{ model = j, loading = walk, k = 3e-11, alpha = alpha, cycles = 1e6 }
  last:run()
  print(("%6g %9.2f %10.2f %11.4f %12.3f"):format(alpha, 1000 * last.depth.cup, 1000 * last.depth.head, last.volume.total,
    last.depth_partition))
end
print(last)
plot.map(last, "cup")

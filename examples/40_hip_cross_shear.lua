-- Wear of a polyethylene hip whose k grows with cross-shear. Cross-shear is the share of the friction work
-- across the main direction of sliding (0: motion along one line, 0.5: no main direction). Flexion alone
-- wears the liner much less than walking along a path of the same length.
--   archard examples/40_hip_cross_shear.lua
-- The coefficient is a function of the user; this one is an example with a magnitude seen in pin-on-disc
-- tests. The angles and the load of walking have the ranges of the standard; the curves between these
-- ranges are approximate. The model does not include edge loading, microseparation and lubrication.

local liner = joint{ foundation = "winkler", mesh = { size = 3 },
  cup = { clearance = 0.1, layers = { { thickness = 8, material = material{ E = 1000, nu = 0.4 } } } } }
local function k(s) return 1e-9 * math.min(0.2 + 3.2 * s.cross_shear, 1) end

print("loading   track [mm]  k 1e-9: volume [mm3]  k(cross-shear)  ratio")
local last
for _, row in ipairs{ { "rocking", gait.rocking{ load = 1250 } }, { "flexion", gait.flexion{ load = 1250 } }, { "prosim", gait "prosim" },
  { "walk", gait "iso" } } do
  local plain = wear{ model = liner, loading = row[2], k = 1e-9, alpha = 0, cycles = 1e6, updates = 10 }:run()
  last = wear{ model = liner, loading = row[2], k = k, alpha = 0, cycles = 1e6, updates = 10 }:run()
  print(("%-8s %10.2f %19.2f %17.2f %9.3f"):format(row[1], row[2].track, plain.volume.cup, last.volume.cup, last.volume.cup / plain.volume.cup))
end
plot.map(last, "cross shear")

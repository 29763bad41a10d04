-- Fit of k to published depths of a steel cylinder on a flat (radius 6 mm, 18.5 N/mm, amplitude 25 um). The
-- depths of the flat after 1000 to 18000 cycles were computed by a level-set program with a coefficient of
-- friction of 0.9 and with k = 2.9e-8 mm2/N of the flat and 1.9e-8 mm2/N of the cylinder. The fit is
-- without friction: elastic tangential displacements then do not shorten the stroke, and the fitted k is
-- 2.5 % smaller.
--   archard examples/23_fit_published.lua

local cycles, depth = { 1000, 5000, 10000, 18000 }, { 0.3784e-3, 1.1311e-3, 1.8145e-3, 2.7130e-3 }
local distance = {}
for i, count in ipairs(cycles) do distance[i] = count * 4 * 0.025 end

local k_cylinder, k_flat = 1.9e-8, 2.9e-8
local f = fit{
  model = { radius = 6, mesh = { size = 0.01, height = 0.0125, zone = { cylinder = 0.6, plate = 0.7 } } },
  base = { alpha = k_cylinder / (k_cylinder + k_flat), load = 18.5, stroke = 0.05, scheme = "implicit",
    tolerance = 2e-3, increments = 40 },
  unknown = { k = 4e-8 },
  data = { { of = "depth_plate", distance = distance, value = depth, relative = 0.005 } },
}
print(f)
print(("k %.3e mm2/N without friction, %.3e published: %+.1f %%"):format(f.value.k, k_cylinder + k_flat,
  100 * (f.value.k / (k_cylinder + k_flat) - 1)))
plot.fit(f)

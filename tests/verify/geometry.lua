-- Tests the effect of a run's options: moving or frozen geometry, rigid or total slip, number of increments,
-- and element height.
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, below = figures.within, figures.below

local function run(definition)
  local w = wear(definition)
  w:run()
  return w
end

local function compare(w, other, share, what)
  within(w.depth.cylinder, other.depth.cylinder, share, what .. ": depth of the cylinder [mm]")
  within(w.depth.plate, other.depth.plate, share, what .. ": depth of the plate [mm]")
  within(w.p_center, other.p_center, share, what .. ": centre pressure [MPa]")
end

local reference = run{}
local frozen = run{ geometry = "frozen" }
compare(frozen, reference, 1e-3, "frozen against moving geometry")
figures.ok(frozen.p_center ~= reference.p_center, "frozen and moving geometry differ")

compare(run{ refresh = 0 }, reference, 1e-4, "stiffness recomputed at every update")

local total = run{ slip = "total" }
compare(total, reference, 0.01, "total against rigid slip")
within(total.volume.total, reference.volume.total, 0.01, "total slip: volume by the work actually done [mm3]")

compare(run{ increments = 200 }, reference, 1e-3, "200 against 100 increments per cycle")

-- Tests that a mesh twice as fine changes the results by less than 1 %.
local fine = run{ model = { mesh = { size = 0.01, height = 0.0125, rows = 6 } } }
compare(reference, fine, 0.01, "20 um against 10 um")

-- Tests that the element type CPE4I changes the results by less than 1 %.
compare(run{ model = { mesh = { element = "CPE4I" } } }, reference, 0.01, "CPE4I against CPE4")

-- Tests the first cycle against its closed form with Hertz' pressure. At x = 0 the cylinder wears by k_c p_H
-- times the sliding distance of a cycle, 0.22 mm.
local first = wear{ alpha = 0.5, jump = 1 }
first:step()
within(first.depth.cylinder, 0.5e-8 * hertz{}.p_max * 0.22, 5e-3,
  "depth of the cylinder in the first cycle [mm]")
-- In a cycle of stroke s the part |x| <= s/2 of Hertz' pressure p_H sqrt(1 - x^2/a^2) passes twice over the
-- plate's middle.
local a, s = hertz{}.half_width, 0.11
local t = s / 2 / a
local passed = hertz{}.p_max * a * (t * math.sqrt(1 - t * t) + math.asin(t))
within(first.depth.plate, 0.5e-8 * 2 * passed, 5e-3, "depth of the plate in the first cycle [mm]")

-- Tests pressures at the edge of a scar: the largest nodal pressure increases with finer meshes, and the mean
-- pressure over a fixed length converges.
local peaks, means = {}, {}
for i, size in ipairs{ 0.02, 0.01, 0.005 } do
  local w = run{ alpha = 0.75, geometry = "frozen", jump = 5e3 * size,
    model = { mesh = { size = size, height = 1.25 * size, zone = { cylinder = 1.2, plate = 1.6 } } } }
  peaks[i], means[i] = w.p_max, w.p_average
  within(contact{ worn = w, model = w.model, average = 0 }.p_average, w.p_max, 1e-12,
    "the mean over a length of zero is p_max [MPa]")
  within(contact{ worn = w, model = w.model, average = 1 }.p_average, 100, 1e-9,
    "the mean over 1 mm is the load per mm [MPa]")
end
figures.above(peaks[3] / peaks[1], 1.08, "p_max on elements of 5 um divided by p_max on 20 um")
within(means[1], means[2], 0.05, "p_average at 20 um against 10 um [MPa]")
within(means[2], means[3], 0.01, "p_average at 10 um against 5 um [MPa]")

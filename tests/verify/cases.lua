-- Tests the 20 cases of the reference paper with its jump N-bar: volumes, symmetry and smoothness of all
-- cases, final values of some cases against an independent solution, and the findings of the paper.
local paper = require "archard.study.paper"
local here = arg[0]:match("^(.*)/") or "."
local figures = dofile(here .. "/lib/figures.lua")
local within, about, below, ok = figures.within, figures.about, figures.below, figures.ok

local load, k, distance = 100, 1e-8, 1320

local function name(alpha, stroke) return ("s = %g, alpha = %g"):format(stroke, alpha) end

local case = {}
for _, settings in ipairs(paper.cases()) do
  local w = wear(settings)
  w:run()
  case[settings.alpha] = case[settings.alpha] or {}
  case[settings.alpha][settings.stroke] = w
end

-- --- all cases -----------------------------------------------------------------------------------

local function off_volume(w, alpha)
  local total = k * load * distance
  return math.max(math.abs(w.volume.cylinder - alpha * total),
    math.abs(w.volume.plate - (1 - alpha) * total)) / total
end

local function off_line(w)
  local worst, h = 0, w.history
  for i, d in ipairs(h.distance) do
    local v = h.volume_cylinder[i] + h.volume_plate[i]
    worst = math.max(worst, math.abs(v - k * load * d) / (k * load * distance))
  end
  return worst
end

-- Returns the load on a body: the sum of pressure times tributary width.
local function carried(w, body)
  local p, sum = w:pressure(body), 0
  for i = 2, #p.x - 1 do sum = sum + p.p[i] * (p.x[i + 1] - p.x[i - 1]) / 2 end
  return sum
end

for _, alpha in ipairs(paper.alphas) do
  for _, stroke in ipairs(paper.strokes) do
    local w, what = case[alpha][stroke], name(alpha, stroke)
    ok(w.distance == distance, what .. ": the run ends exactly at its distance")
    below(off_volume(w, alpha), 1e-9, what .. ": error of the final volumes, fraction of k L d")
    below(off_line(w), 1e-9, what .. ": error of the volume over the distance, fraction of k L d")
    local skew = 0
    for _, body in ipairs{ "cylinder", "plate" } do
      skew = math.max(skew, figures.asymmetry(w:profile(body).h), figures.asymmetry(w:pressure(body).p))
    end
    below(skew, 1e-9, what .. ": asymmetry of profiles and pressures")
    below(math.max(w:roughness("cylinder"), w:roughness("plate")), 5e-4, what .. ": roughness")
    below(math.abs(carried(w, "cylinder") / carried(w, "plate") - 1), 1e-4,
      what .. ": difference of the forces on both bodies")
  end
end

-- --- Final values ---------------------------------------------------------------------------------

local function depth(got, expected, what)
  if expected == 0 then
    ok(got == 0, what .. ": no wear")
  else
    within(1000 * got, expected, 3e-3, what .. " [um]")
  end
end

for _, row in ipairs(dofile(here .. "/lib/finals.lua")) do
  local stroke, alpha, h_c, h_p, p, first, mean, last = table.unpack(row)
  local w, what = case[alpha][stroke], name(alpha, stroke)
  depth(w.depth.cylinder, h_c, what .. ": depth of the cylinder")
  depth(w.depth.plate, h_p, what .. ": depth of the plate")
  within(w.p_center, p, 0.01, what .. ": centre pressure [MPa]")
  if first then
    local partition = w.history.depth_partition -- the first value, before any wear, is NaN
    about(partition[2], first, 1e-3, what .. ": first depth partition")
    about(figures.mean(partition, 2), mean, 1e-3, what .. ": mean depth partition")
    about(partition[#partition], last, 1e-3, what .. ": last depth partition")
  end
end

-- --- findings -------------------------------------------------------------------------------------

local function partition_range(w)
  local low, high = math.huge, -math.huge
  for i, v in ipairs(w.history.depth_partition) do
    if i > 1 then low, high = math.min(low, v), math.max(high, v) end
  end
  return low, high
end

local reference = case[0.5][0.11]
about(1 - reference.p_center / hertz{}.p_max, 0.66, 0.03,
  "s = a, alpha = 0.5: relative decrease of the centre pressure")
about(1000 * reference.depth.cylinder, 2, 0.35, "s = a, alpha = 0.5: depth of the cylinder [um]")
about(1000 * reference.depth.plate, 2, 0.35, "s = a, alpha = 0.5: depth of the plate [um]")

local shallow = case[0.25][0.11].history.depth_partition
local low, high = partition_range(case[0.25][0.11])
within(figures.mean(shallow, 2), 0.266, 0.01, "s = a, alpha = 0.25: mean depth partition")
about((high - low) / figures.mean(shallow, 2), 0.045, 0.005,
  "s = a, alpha = 0.25: relative variation of the depth partition")
for _, alpha in ipairs{ 0.25, 0.5, 0.75 } do
  low, high = partition_range(case[alpha][0.11])
  below(math.max(math.abs(low / alpha - 1), math.abs(high / alpha - 1)), 0.09,
    ("s = a, alpha = %g: relative difference of depth partition and alpha"):format(alpha))
  low = partition_range(case[alpha][20])
  figures.above(low, 0.96, ("s = 2R, alpha = %g: smallest depth partition"):format(alpha))
end
low, high = partition_range(case[0.25][0.22])
within(high / 0.25, 1.30, 0.02, "s = 2a, alpha = 0.25: largest depth partition / alpha")
low, high = partition_range(case[0.25][0.44])
within(high / 0.25, 1.83, 0.02, "s = 4a, alpha = 0.25: largest depth partition / alpha")
local falling, wide = true, case[0.25][0.44].history.depth_partition
for i = 3, #wide do falling = falling and wide[i] < wide[i - 1] end
ok(falling, "s = 4a, alpha = 0.25: the depth partition decreases with distance")

local function total_depth(alpha)
  local depth = case[alpha][0.11].depth
  return 1000 * (depth.cylinder + depth.plate)
end

for _, alpha in ipairs{ 0, 0.25, 0.75, 1 } do
  within(total_depth(alpha), total_depth(0.5), 0.03,
    ("s = a, alpha = %g: sum of depths against alpha = 0.5 [um]"):format(alpha))
end

-- Returns the largest distance of the centre pressure from the straight line between its first and last
-- value, as a share of the total decrease.
local function bend(w)
  local p, d, worst = w.history.p_center, w.history.distance, 0
  for i = 1, #p do
    local line = p[1] + (p[#p] - p[1]) * d[i] / d[#d]
    worst = math.max(worst, math.abs(p[i] - line))
  end
  return worst / (p[1] - p[#p])
end
below(bend(case[0][0.44]), 0.1, "s = 4a, alpha = 0: deviation of the pressure from a straight line")
figures.above(bend(case[0.5][0.44]), 0.3,
  "s = 4a, alpha = 0.5: deviation of the pressure from a straight line")

about(1000 * case[0.25][20].depth.plate, 0.0495, 1e-9,
  "2R: depth of uniform wear of the plate after 66 passes [um]")

-- Tests the edges of the contact against Hertz theory, and in worn contacts against runs on elements of 5 um
-- over the whole distance. Smooth edges are located between the nodes by the asymptotic law of forces and
-- gaps; edges at kinks of scars are less accurate.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local below, within = figures.below, figures.within

for _, size in ipairs{ 0.02, 0.01 } do
  local m, worst = model{ mesh = { size = size, height = 1.25 * size } }, 0
  for load = 60, 140, 2 do
    local off = contact{ model = m, load = load }.half_width - hertz{ load = load }.half_width
    worst = math.max(worst, math.abs(off) / size)
  end
  below(worst, 0.035,
    ("unworn, 41 loads, elements of %g um: largest error of the half width in elements"):format(1000 * size))
end

-- Returns the half widths of the contact [mm] at multiples of 60 mm of distance.
local function course(case, size)
  local w = wear{ alpha = case.alpha, stroke = case.stroke, scheme = "explicit", geometry = "frozen",
    model = { mesh = { size = size, zone = { cylinder = 1.2, plate = 1.2 + case.stroke } } } }
  local widths = {}
  for distance = 60, 1320, 60 do
    w:run{ distance = distance }
    widths[#widths + 1] = w.half_width
  end
  return widths
end

for _, case in ipairs{ { alpha = 0, stroke = 0.22, mean = 0.04, most = 0.08 },
  { alpha = 0, stroke = 0.44, mean = 0.04, most = 0.08 }, { alpha = 0.5, stroke = 0.11, mean = 0.25, most = 0.62 },
  { alpha = 1, stroke = 0.11, mean = 0.35, most = 0.62 } } do
  local coarse, fine, sum, worst = course(case, 0.02), course(case, 0.005), 0, 0
  for i, width in ipairs(coarse) do
    local off = math.abs(width - fine[i]) / 0.02
    sum, worst = sum + off * off, math.max(worst, off)
  end
  local what = ("alpha = %g, s = %g, 20 um: error of the half width in elements, "):format(case.alpha,
    case.stroke)
  below(math.sqrt(sum / #coarse), case.mean, what .. "r.m.s. over the run")
  below(worst, case.most, what .. "largest")
end

-- Tests that the meshes that follow the wear of a pin stay fine enough for its rounded edges. The values are those of
-- elements of 0.02 mm.
do
  local w = wear{ load = 100, slide = "z", track = 20, distance = 20e6, model = { geometry = "axisymmetric", lower = body.block{ width = 40, height = 10, k = 0 },
    upper = body.punch{ flat = 4, radius = 0.5, height = 10, material = material{ E = 3600, nu = 0.4, k = 1e-9 } } } }:run()
  within(w.half_width, 2.3166, 0.01, "worn pin with rounded edges: half width [mm]")
  within(w.p_center, 5.866, 0.003, "worn pin with rounded edges: pressure in the centre [MPa]")
  within(w.depth_cylinder, 0.12810, 0.001, "worn pin with rounded edges: depth [mm]")
end

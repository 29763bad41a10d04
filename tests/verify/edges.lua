-- Tests the edges of the contact against Hertz theory, and in worn contacts against runs on elements of 5 um
-- over the whole distance. Smooth edges are located between the nodes by the asymptotic law of forces and
-- gaps; edges at kinks of scars by the gaps outside the contact.

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

local all, runs = 0, 0
for _, case in ipairs{ { alpha = 0, stroke = 0.22, rms = 0.04, most = 0.08 },
  { alpha = 0, stroke = 0.44, rms = 0.04, most = 0.08 }, { alpha = 0.5, stroke = 0.11, rms = 0.2, most = 0.35 },
  { alpha = 1, stroke = 0.11, rms = 0.09, most = 0.2 }, { alpha = 0.2, stroke = 0.22, rms = 0.3, most = 0.45 },
  { alpha = 0.8, stroke = 0.22, rms = 0.1, most = 0.2 }, { alpha = 0.5, stroke = 0.44, rms = 0.2, most = 0.35 },
  { alpha = 0.5, stroke = 0.02, rms = 0.07, most = 0.15 } } do
  local coarse, fine, mean, squares, worst = course(case, 0.02), course(case, 0.005), 0, 0, 0
  for i, width in ipairs(coarse) do
    local off = (width - fine[i]) / 0.02
    mean, squares, worst = mean + off / #coarse, squares + off * off / #coarse, math.max(worst, math.abs(off))
  end
  local what = ("alpha = %g, s = %g, 20 um: error of the half width in elements, "):format(case.alpha,
    case.stroke)
  below(math.sqrt(squares), case.rms, what .. "r.m.s. over the run")
  below(worst, case.most, what .. "largest")
  below(math.abs(mean), 0.12, what .. "mean")
  all, runs = all + mean, runs + 1
end
below(math.abs(all / runs), 0.03, "mean error of the half widths of all these runs, in elements")

-- A ball that wears to a flat on a disc. Rigid bodies are in contact up to the edge of the flat, at (2 R d - d^2)^(1/2).
do
  local R, worst = 10, 0
  local w = wear{ model = { geometry = "axisymmetric", radius = R }, load = 50, slide = "z", track = 20, k_cylinder = 1e-7,
    k_plate = 2e-8 }
  for distance = 1e4, 8e4, 5e3 do
    w:run{ distance = distance }
    local d = w.depth_cylinder
    worst = math.max(worst, math.abs(w.half_width / math.sqrt(2 * R * d - d * d) - 1))
  end
  below(worst, 0.005, "ball on disc: radius of the contact and of the worn flat")
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

-- Tests a plate that stays flat: the wear of the cylinder depends only on k_c d, the product of its wear
-- coefficient and the sliding distance, and tends to a flat scar under uniform pressure.
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within = figures.within

local p_h = hertz{}.p_max

-- Reference values: k_c d [mm2/N mm], centre pressure / p_H, depth [um].
local rows = {
  { 1.1e-6, 0.7222, 0.5498 }, { 3.3e-6, 0.5048, 1.3195 },
  { 6.6e-6, 0.3962, 2.1816 }, { 1.32e-5, 0.3132, 3.5407 },
}

local function check(w, row, what)
  what = ("%s, k_c d = %g"):format(what, row[1])
  within(w.p_center / p_h, row[2], 0.01, what .. ": centre pressure / p_H")
  within(1000 * w.depth.cylinder, row[3], 3e-3, what .. ": depth [um]")
end

-- Computes one run with all rows, whose steps are short compared with the distance of the first row.
local w = wear{ alpha = 1, stroke = 0.11, jump = 5 }
for _, row in ipairs(rows) do
  w:run{ distance = row[1] / 1e-8 }
  check(w, row, "alpha = 1")
end

-- Tests that other values of alpha, k and stroke with equal products k_c d give equal results.
w = wear{ alpha = 0.5, stroke = 20, jump = 0.1, distance = 2640 }
for _, row in ipairs(rows) do
  w:run{ distance = row[1] / 0.5e-8 }
  check(w, row, "s = 2R, alpha = 0.5")
end
w = wear{ alpha = 0.8, k = 5e-8, stroke = 20, jump = 0.0125, distance = 330 }
for _, row in ipairs(rows) do
  w:run{ distance = row[1] / 4e-8 }
  check(w, row, "s = 2R, alpha = 0.8, k = 5e-8")
end

-- Tests a long run against the limit of a flat scar: b = (3 R k_c L d / 2)^(1/3), h = b^2 / (2 R), p = L / (2 b).
local last_off
for _, times in ipairs{ 1, 4, 16 } do
  local distance = 1320 * times
  w = wear{ alpha = 1, stroke = 0.11, jump = 100, distance = distance }
  w:run()
  local b = (1.5 * 10 * 1e-8 * 100 * distance) ^ (1 / 3)
  local off = math.abs(w.depth.cylinder / (b * b / 20) - 1)
  within(w.p_center, 100 / (2 * b), 0.01, ("d = %g mm: centre pressure [MPa]"):format(distance))
  within(1000 * w.depth.cylinder, 1000 * b * b / 20, 0.035, ("d = %g mm: depth [um]"):format(distance))
  within(w.half_width, b, 0.05, ("d = %g mm: half width [mm]"):format(distance))
  if last_off then
    figures.below(off, 0.7 * last_off,
      ("d = %g mm: relative difference of the depth and the flat scar's"):format(distance))
  end
  last_off = off
end

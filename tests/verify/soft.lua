-- Tests soft bodies. Elements do not lock for nu near 1/2. Hertzian pressures depend only on the contact
-- modulus, and so do pressures after wear if the plate stays flat.
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, below = figures.within, figures.below

local steel = { E = 200e3, nu = 0.3 }
local pairs_of = {
  { "both nu = .41", { E = 3000, nu = 0.41 }, { E = 3000, nu = 0.41 } },
  { "both nu = .45", { E = 200e3, nu = 0.45 }, { E = 200e3, nu = 0.45 } },
  { "nu = .49 on .45", { E = 2000, nu = 0.49 }, { E = 500, nu = 0.45 } },
  { "steel on nu = .4999", steel, { E = 10, nu = 0.4999 } },
  { "nu = .499 on steel", { E = 1000, nu = 0.499 }, steel },
  { "both nu = .4999", { E = 10, nu = 0.4999 }, { E = 10, nu = 0.4999 } },
}

-- Returns the contact modulus of the pair divided by the contact modulus of steel. Loads in this ratio give
-- equal contact widths.
local function modulus(pair)
  return hertz{ cylinder = pair[2], plate = pair[3] }.E_star / hertz{}.E_star
end

local function model_of(pair, size, element)
  return model{ cylinder = pair[2], plate = pair[3],
    mesh = { size = size, height = 1.25 * size, far = 1, zone = { cylinder = 1, plate = 1.2 }, element = element } }
end

-- Returns the root mean square and the largest error of the centre pressure over contacts of at least 5
-- elements of 20 um in the half width.
local function centre_errors(pair, size)
  local m, scale, sum, worst, count = model_of(pair, size), modulus(pair), 0, 0, 0
  for load = 100, 1200, size < 0.02 and 220 or 55 do
    local h = hertz{ cylinder = pair[2], plate = pair[3], load = scale * load }
    local off = contact{ model = m, load = scale * load }.p_center / h.p_max - 1
    sum, worst, count = sum + off * off, math.max(worst, math.abs(off)), count + 1
  end
  return math.sqrt(sum / count), worst
end

for _, pair in ipairs(pairs_of) do
  for _, size in ipairs{ 0.02, 0.01 } do
    local rms, worst = centre_errors(pair, size)
    below(worst, 3e-3, ("%s, %g um: largest error of the centre pressure"):format(pair[1], 1000 * size))
    below(rms, 1.5e-3, ("%s, %g um: r.m.s. error of the centre pressure"):format(pair[1], 1000 * size))
  end
end

-- Returns the relative change of the approach when mesh.far, the size of the elements far from the contact,
-- is 1 mm instead of 0.125 mm. The approach depends on all elements of the bodies, including the triangles.
-- For nu near 1/2 the change must be below 1.2 times the change for steel.
local function approach_change(pair)
  local function approach(far)
    return contact{ load = 100 * modulus(pair), model = { cylinder = pair[2], plate = pair[3],
      mesh = { far = far } } }.approach
  end
  return math.abs(approach(1) / approach(0.125) - 1)
end
below(approach_change(pairs_of[6]), 1.2 * approach_change{ "", steel, steel },
  "both nu = .4999: error of the approach by coarse elements")

-- Tests the wear of the cylinder on a plate that stays flat against boundary elements (see flat_plate.lua).
-- Each row: distance on steel [mm], centre pressure / p_H, depth [um].
for _, at in ipairs{ 4, 5, 6 } do
  local pair, scale = pairs_of[at], modulus(pairs_of[at])
  local w = wear{ model = model_of(pair, 0.02), alpha = 1, stroke = 0.11, load = 100 * scale,
    k = 1e-8 / scale, jump = 5 }
  for _, row in ipairs{ { 110, 0.7222, 0.5498 }, { 330, 0.5048, 1.3195 }, { 660, 0.3962, 2.1816 },
    { 1320, 0.3132, 3.5407 } } do
    w:run{ distance = row[1] }
    within(w.p_center / (scale * hertz{}.p_max), row[2], 0.01,
      ("%s, worn over %g mm: centre pressure / p_H"):format(pair[1], row[1]))
    within(1000 * w.depth.cylinder, row[3], 3e-3, ("%s: depth [um]"):format(pair[1]))
  end
end

-- Tests that elements that lock give a warning for nu above 0.45 and that "auto" gives no warning.
local warnings = require "archard.warnings"
warnings.keep()
local function warned(element, nu)
  contact{ model = { plate = { E = 200e3, nu = nu }, mesh = { element = element } } }
  return warnings.take()
end
figures.ok((warned("CPE4", 0.49) or ""):find("lock at nu = 0.49 of the plate", 1, true),
  "CPE4 at nu = 0.49 gives a warning")
for _, quiet in ipairs{ { "CPE4", 0.45 }, { "auto", 0.49 }, { "CPE4I", 0.49 } } do
  figures.ok(warned(quiet[1], quiet[2]) == nil, ("%s at nu = %g: no warning"):format(quiet[1], quiet[2]))
end

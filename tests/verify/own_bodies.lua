-- Tests user-defined bodies against closed forms and independent results: a rounded punch.
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, below = figures.within, figures.below

local function hexes(c) return ("%a %a %a"):format(c.p_max, c.half_width, c.approach) end

-- --- the paper's pair as bodies -----------------------------------------------------------------

figures.ok(hexes(contact{ model = { upper = body.cylinder{ radius = 10 }, lower = body.block{ width = 20, height = 10 } } })
  == hexes(contact{}), "body.cylinder on body.block is the reference pair to the bit")

-- --- rounded punch ------------------------------------------------------------------------------

-- Half-planes have the half width a = 0.530577 mm, from 4 P R / (E* a^2) = pi - 2 f - sin 2f with sin f = b/a
-- and the flat half width b = 0.5 mm. Bodies 10 mm high have p(0) = 123.70 MPa and p_max = 644.46 MPa by
-- another program with finite elements of 5 um.
local punch = model{ upper = body.punch{ flat = 1, radius = 2, height = 10 }, lower = body.block{ width = 20, height = 10 },
  mesh = { size = 0.01, height = 0.0125, zone = { cylinder = 1.4, plate = 1.4 } } }
local c = contact{ model = punch, load = 200 }
within(c.p_center, 123.70, 0.005, "rounded punch: centre pressure [MPa]")
within(c.p_max, 644.46, 0.02, "rounded punch: largest pressure [MPa]")
below(math.abs(c.half_width - 0.530577), 0.01,
  "rounded punch: error of the half width, below an element [mm]")
local p = c:pressure("cylinder").p
local lopsided = 0
for i = 1, #p do lopsided = math.max(lopsided, math.abs(p[i] - p[#p + 1 - i]) / c.p_max) end
below(lopsided, 1e-9, "rounded punch: asymmetry of the pressure")
local below_it = contact{ model = { upper = body.block{ width = 20, height = 10 },
  lower = body.punch{ flat = 1, radius = 2, height = 10 }, mesh = { size = 0.01, height = 0.0125,
    zone = { cylinder = 1.4, plate = 1.4 } } }, load = 200 }
within(below_it.p_center, c.p_center, 1e-3, "rounded punch as the lower body: centre pressure [MPa]")

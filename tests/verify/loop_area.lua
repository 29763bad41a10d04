-- Tests that the area of a fretting loop in gross slip exceeds the dissipated energy (shear times slip) by the
-- expected amount. The pressure p strains the surface by (1 + nu)(1 - 2 nu) p / E along x. Linear elasticity
-- refers the slip to the undeformed length, so the plate moves farther than the slip. The mean strain follows
-- from the mean of the Hertzian pressure, weighted by the pressure, 8 / (3 pi) p_max. It does not depend on
-- the mesh and on friction.
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")

local function area_of(loop)
  local area = 0
  for i = 2, #loop.x do
    area = area + (loop.x[i] - loop.x[i - 1]) * (loop.tangential[i] + loop.tangential[i - 1]) / 2
  end
  return area
end

for _, case in ipairs{ { load = 25, mu = 0.6 }, { load = 100, mu = 0.6 }, { load = 100, mu = 0.2 }, { load = 400, mu = 0.6 } } do
  local pair = hertz{ load = case.load }
  local stroke = 2 * pair.half_width
  local loop = wear{ model = { mesh = { fineness = 1 } }, load = case.load, friction = case.mu, stroke = stroke, increments = 3200 }:loop()
  local strain = 1.3 * 0.4 / 200e3 * 8 / (3 * math.pi) * pair.p_max
  local label = ("%g N, friction %g: "):format(case.load, case.mu)
  figures.within(area_of(loop) - loop.energy, strain * loop.energy, 0.1, label ..
    "difference of the loop's area and the energy [N mm]")
end

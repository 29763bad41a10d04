-- Tests pressures of layered and coated bodies against integral transforms.
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, below = figures.within, figures.below

-- --- layers -------------------------------------------------------------------------------------

local function layered(upper_E, base_E, thickness, E, nu, load, size, rows, zone)
  return contact{ load = load, model = { upper = body.cylinder{ radius = 10, E = upper_E },
    lower = body.block{ width = 20, height = 10, E = base_E, layers = { { thickness = thickness, E = E, nu = nu } } },
    mesh = { size = size, height = size, rows = rows, far = 1, zone = { cylinder = zone, plate = zone } } } }
end
local function check_layer(what, solved, p0, half, element)
  within(solved.p_center, p0, 0.01, what .. ": centre pressure [MPa]")
  if half then below(math.abs(solved.half_width - half), element,
    what .. ": error of the half width, below an element [mm]") end
end
check_layer("rigid cylinder, layer of 0.1", layered(1e9, 1e9, 0.1, 1000, 0.3, 10, 0.01, 3, 0.7), 33.257, 0.2102, 0.01)
check_layer("rigid cylinder, layer of 1", layered(1e9, 1e9, 1, 1000, 0.3, 10, 0.02, 3, 1), 19.412, 0.3283, 0.02)
check_layer("rigid cylinder, nu = 0.49", layered(1e9, 1e9, 1, 1000, 0.49, 10, 0.02, 3, 1), 21.372, 0.298, 0.02)
check_layer("coat of 0.1", layered(210e3, 210e3, 0.1, 400e3, 0.3, 100, 0.005, 3, 0.5), 663.00, 0.096, 0.005)
check_layer("coat of 0.005", layered(210e3, 210e3, 0.005, 400e3, 0.3, 100, 0.0025, 2, 0.4), 608.88)
local alike = layered(200e3, 200e3, 0.05, 200e3, 0.3, 100, 0.02, 3, 1)
within(alike.p_center, contact{ model = { mesh = { size = 0.02, height = 0.02, zone = { cylinder = 1, plate = 1 } } } }.p_center,
  2e-3, "a layer of the same material does not change the pressure")

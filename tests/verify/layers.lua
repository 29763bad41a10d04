-- Tests scars in soft layers on the default mesh against another program, which remeshes its finite elements
-- during wear, treats the interface exactly and has errors below 0.1 %. The case is a steel cylinder with R =
-- 10 mm and E = 200 GPa under 200 N/mm on a plate of 210 GPa, with a stroke of 0.02 mm.
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within = figures.within

local function coat(E, nu, thickness) return { { thickness = thickness, material = material{ E = E, nu = nu } } } end
local function on_plate(E, nu, thickness)
  return { upper = body.cylinder{ radius = 10, E = 200e3, nu = 0.3 },
    lower = body.block{ E = 210e3, nu = 0.3, layers = coat(E, nu, thickness) } }
end
local function on_cylinder(E, nu, thickness)
  return { upper = body.cylinder{ radius = 10, E = 200e3, nu = 0.3, layers = coat(E, nu, thickness) },
    lower = body.block{ E = 210e3, nu = 0.3 } }
end

-- Each row: distance [mm], centre pressure [MPa] and largest depth [um] of the other program.
local cases = {
  { "3 GPa, 100 um", on_plate(3e3, 0.35, 0.1), 0.2, 1e-7,
    { { 40, 335.8, 1.102 }, { 100, 311.8, 2.655 }, { 200, 276.7, 5.003 }, { 400, 224.6, 8.983 } } },
  { "3 GPa, 50 um", on_plate(3e3, 0.35, 0.05), 0.2, 1e-7, { { 40, 394.1 }, { 100, 344.0 }, { 200, 282.2 }, { 400, 214.0 } } },
  { "500 MPa, nu = .46, 20 um", on_plate(500, 0.46, 0.02), 0.2, 1e-7,
    { { 40, 412.0 }, { 100, 357.1 }, { 200, 286.8 }, { 400, 212.8 } } },
  { "3 GPa, 100 um on the cylinder", on_cylinder(3e3, 0.35, 0.1), 0.8, 1e-7, { { 300, 247.84, 7.098 } } },
  { "3 GPa, 4 um, worn through", on_plate(3e3, 0.35, 0.004), 0.2, 1e-8,
    { { 400, 469.3 }, { 1100, 319.6, 3.973 }, { 1200, 303.2, 4.221 }, { 1600, 273.0, 5.137 } } },
}

local function check(case, way, more)
  local name, pair, alpha, k, points = table.unpack(case)
  local d = { model = pair, load = 200, stroke = 0.02, alpha = alpha, k = k, distance = points[#points][1] }
  for field, value in pairs(more) do d[field] = value end
  local w = wear(d)
  for _, point in ipairs(points) do
    w:run{ distance = point[1] }
    local of = ("layer of %s, %s, after %g mm: "):format(name, way, point[1])
    within(w.p_center, point[2], 0.01, of .. "centre pressure [MPa]")
    if point[3] then within(1e3 * math.max(w.depth.cylinder, w.depth.plate), point[3], 0.004, of .. "depth [um]") end
  end
end
for _, case in ipairs(cases) do
  check(case, "automatic updates", { scheme = "explicit" })
  check(case, "implicit", { scheme = "implicit", tolerance = 1e-3 })
end

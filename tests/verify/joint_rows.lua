-- Tests a ball in a socket: exchange of head and cup, convergence in cells, instants and updates, cross-shear
-- against closed forms, the law of deep wear, and rocking of a metal joint. man/accuracy.md shows the table
-- of convergence.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within = figures.within

local cocr, pe = material{ E = 230e3, nu = 0.3 }, material{ E = 1000, nu = 0.4 }
local function metal(size) return joint{ mesh = { size = size } } end
local springs = joint{ head = { material = material{ E = 1e15, nu = 0.3 } }, foundation = "winkler", mesh = { size = 2 },
  cup = { clearance = 0.1, layers = { { thickness = 8, material = pe } } } }
local function run(j, loading, k, alpha, cycles, updates)
  return wear{ model = j, loading = loading, k = k, alpha = alpha, cycles = cycles, updates = updates }:run{ progress = false }
end
local in_the_middle = figures.in_the_middle

-- --- exchange of head and cup: alpha, rotation R and load F become 1 - alpha, R' and R' F -------------
local function exchanged(g)
  local list = {}
  for at = 0, 15 * (g.increments - 1), 15 do
    local function entry(i) return g.instants[at + i] end
    for a = 1, 3 do
      local omega, load = 0, 0
      for b = 1, 3 do
        list[at + 3 * (a - 1) + b] = entry(3 * (b - 1) + a)
        omega, load = omega + entry(3 * (b - 1) + a) * entry(9 + b), load + entry(3 * (b - 1) + a) * entry(12 + b)
      end
      list[at + 9 + a], list[at + 12 + a] = -omega, load
    end
  end
  return { name = "exchanged", instants = list }
end
for _, row in ipairs{ { 3, 0.01 }, { 1.5, 0.004 } } do
  local size, share = row[1], row[2]
  local one = run(metal(size), gait "iso", 3e-11, 0.5, 2e5, 8)
  local two = run(metal(size), exchanged(gait "iso"), 3e-11, 0.5, 2e5, 8)
  within(two.depth.head, one.depth.cup, share, ("exchange, %g degrees: depth of the head"):format(size))
  within(two.depth.cup, one.depth.head, share, ("exchange, %g degrees: depth of the cup"):format(size))
  within(two.volume.total, one.volume.total, 1e-4, ("exchange, %g degrees: volume"):format(size))
end

-- --- convergence: cells, instants, updates; depths of cup and head in um, volume of each in mm3 -------
local nodes = { { 0, 300 }, { 0.12, 3000 }, { 0.32, 1500 }, { 0.5, 3000 }, { 0.62, 300 }, { 1, 300 } }
local function load(t)
  for i = 1, 5 do
    local a, b = nodes[i], nodes[i + 1]
    if t <= b[1] then return a[2] + (b[2] - a[2]) * (1 - math.cos(math.pi * (t - a[1]) / (b[1] - a[1]))) / 2 end
  end
end
local function turn(middle, range, phase)
  return function(t) return middle + range * math.cos(2 * math.pi * (t - phase)) end
end
local function walk(n)
  return gait{ increments = n, flexion = turn(3.5, 21.5, 0), adduction = turn(1.5, 5.5, 0.21), rotation = turn(-4, -6, 0), load = load }
end
within(walk(20).track, gait("iso").track, 1e-12, "track of the ISO gait defined by functions")
for _, row in ipairs{ { 3, 20, 20, 5.276, 3.580, 0.43228 }, { 2, 20, 20, 5.288, 3.581, 0.43229 }, { 1.5, 20, 20, 5.292, 3.586, 0.43229 },
  { 2, 10, 20, 5.278, 3.560, 0.43008 }, { 2, 40, 20, 5.295, 3.585, 0.43342 }, { 2, 20, 5, 5.355, 3.617, 0.43215 },
  { 2, 20, 10, 5.278, 3.577, 0.43232 }, { 2, 20, 40, 5.290, 3.582, 0.43229 } } do
  local size, instants, updates = row[1], row[2], row[3]
  local w = run(metal(size), walk(instants), 3e-11, 0.5, 1e6, updates)
  local name = ("%g degrees, %d instants, %d updates: "):format(size, instants, updates)
  within(1000 * w.depth.cup, row[4], 3e-4, name .. "depth of the cup [um]")
  within(1000 * w.depth.head, row[5], 3e-4, name .. "depth of the head [um]")
  within(w.volume.cup, row[6], 5e-5, name .. "volume of each body [mm3]")
end

-- --- cross-shear in the direction of the load ----------------------------------------------------------
local function cross_shear(g) return in_the_middle(run(springs, g, 1e-12, 0, 1, 1):map "cross shear") end
local function rectangle(a, b) -- a rectangular path with the sides a > b has the cross-shear b / (a + b)
  local turn_at = a / (2 * (a + b))
  return gait{ t = { 0, turn_at, 0.5, 0.5 + turn_at, 1 }, flexion = { 0, a, a, 0, 0 }, adduction = { 0, 0, b, b, 0 }, load = 2000, increments = 20 * (a + b) }
end
within(cross_shear(gait.rocking{ increments = 60 }), 0.5, 4e-4, "cross-shear of the rocking gait")
within(1 + cross_shear(gait.flexion()), 1, 1e-12, "1 + cross-shear of flexion, which is zero")
within(cross_shear(rectangle(2, 1)), 1 / 3, 1e-3, "cross-shear of a rectangle of 2 x 1")
within(cross_shear(rectangle(3, 1)), 1 / 4, 1e-3, "cross-shear of a rectangle of 3 x 1")
within(1 + cross_shear(gait "iso"), 1.1063, 2e-3, "1 + cross-shear of the ISO gait")

-- --- deep wear of the cup --------------------------------------------------------------------------
-- By the closed form the pressure at the angle t from the load is p = D cos t / (k s(t)), where s is the
-- sliding distance and D = k F / (integral of cos(t)^2 / s dA).
local deep = run(springs, gait.rocking{ increments = 40 }, 1e-9, 0, 4e6, 60)
local angle, R, many = math.rad(23), 14, 400
local function sliding(t)  -- returns the sliding distance of a cycle [mm]
  local sum = 0
  for i = 1, many do
    local along = math.sin(angle) * math.sin(t) * math.cos(2 * math.pi * (i - 0.5) / many) + (math.cos(angle) - 1) * math.cos(t)
    sum = sum + math.sqrt(math.sin(angle) ^ 2 + (1 - math.cos(angle)) ^ 2 - along ^ 2)
  end
  return 2 * math.pi * R * sum / many
end
local edge, integral = math.acos(0.1 / deep:penetration()[3]), 0
for i = 1, many do
  local t = edge * (i - 0.5) / many
  integral = integral + math.cos(t) ^ 2 / sliding(t) * 2 * math.pi * R ^ 2 * math.sin(t) * edge / many
end
local law = 2000 / (integral * sliding(0))
within(law, 4.3113, 2e-4, "deep wear: pressure at the pole by the closed form [MPa]")
within(in_the_middle(deep:map "pressure"), law, 1e-3, "deep wear: pressure at the pole [MPa]")

-- --- surface layers thinner than a cell -----------------------------------------------------------------

-- Tests cells of 4 and 2 degrees (1 and 0.5 mm) against cells of 0.5 degrees. A soft coating of vanishing
-- thickness has no effect.
local function coated(size, thickness, E)
  return contact{ load = 3000, model = joint{ mesh = { size = size }, head = { material = cocr,
    layers = thickness and { { thickness = thickness, material = material{ E = E, nu = 0.3 } } } or nil } } }.p_center
end
for _, row in ipairs{ { 4, 29.335, 45.69 }, { 2, 29.335, 45.69 } } do
  local size = row[1]
  within(coated(size, 0.1, 300), row[2], 0.01,
    ("soft coating of 0.1 mm, %g degrees: centre pressure [MPa]"):format(size))
  within(coated(size, 0.01, 300), row[3], 0.012,
    ("soft coating of 0.01 mm, %g degrees: centre pressure [MPa]"):format(size))
  within(coated(size, 1e-5, 300), coated(size), 3e-4,
    ("soft coating of 10 nm, %g degrees: centre pressure without it [MPa]"):format(size))
end
local function lined(size)
  return contact{ load = 2000, model = joint{ mesh = { size = size }, cup = { clearance = 0.1, layers = {
    { thickness = 0.2, material = material{ E = 20, nu = 0.49 } }, { thickness = 6, material = cocr } } } } }.p_center
end
within(lined(4), 24.88, 0.05, "rubber layer of 0.2 mm, 4 degrees: centre pressure [MPa]")
within(lined(1), 24.88, 0.03, "rubber layer of 0.2 mm, 1 degree: centre pressure [MPa]")

-- --- rocking of a metal joint ---------------------------------------------------------------------------
local rocks = wear{ model = metal(2), loading = gait.rocking{ increments = 60 }, k = 3e-11, alpha = 0, cycles = 1e6 }
for _, row in ipairs{ { 2.5e5, 6.621, 0.52780, 16.41 }, { 1e6, 15.617, 2.15182, 9.267 } } do
  rocks:run{ cycles = row[1], progress = false }
  local name = ("metal, rocking, %g cycles: "):format(row[1])
  within(1000 * rocks.depth.cup, row[2], 4e-3, name .. "depth [um]")
  within(rocks.volume.cup, row[3], 1e-3, name .. "volume [mm3]")
  within(in_the_middle(rocks:map "pressure"), row[4], 0.012, name .. "pressure at the centre [MPa]")
end

-- Tests the accuracy of default meshes for contacts under layers, with rounded edges, in holes, of profiles
-- and of balls, and compares it with the accuracy for the pair of the reference paper. Tests the messages for
-- meshes that are too small.

-- Long
local here = arg[0]:match("^(.*)/") or "."
local figures = dofile(here .. "/lib/figures.lua")
local warnings = require "archard.warnings"
local within, below, ok = figures.within, figures.below, figures.ok

local function off_elements(c, half) return math.abs(c.half_width - half) / c.model.mesh.size end
local function soft(thickness, E, nu) return { { thickness = thickness, material = material{ E = E, nu = nu } } } end

-- --- layers against integral transforms ---------------------------------------------------------

local rigid = 1e9
for _, row in ipairs{ { 0.1, 1000, 0.3, 10, 33.257, 0.2102, 10, rigid }, { 1, 1000, 0.3, 10, 19.412, 0.3283, 10, rigid },
  { 1, 1000, 0.49, 10, 21.372, 0.298, 10, rigid }, { 8, 850, 0.46, 100, 50.091, 1.271, 14, rigid },
  { 0.1, 400e3, 0.3, 100, 663.00, 0.096, 10, 210e3 }, { 0.005, 400e3, 0.3, 100, 608.88, nil, 10, 210e3 } } do
  local t, E, nu, load, p0, half, radius, base = table.unpack(row)
  local c = contact{ load = load, model = { upper = body.cylinder{ radius = radius, E = base },
    lower = body.block{ width = 20, height = 10, E = base, layers = soft(t, E, nu) } } }
  local of = ("layer of %g mm, %g MPa, nu = %g: "):format(t, E, nu)
  within(c.p_center, p0, 0.01, of .. "centre pressure [MPa]")
  if half then below(off_elements(c, half), 1, of .. "error of the half width [elements]") end
end

-- Tests layers of thickness t, much thinner than the contact is wide, against the closed form for springs
-- (Winkler foundation): a^3 = 3 P R C / 2 and p0 = a^2 / (2 R C) with C = t (1 - 2 nu) (1 + nu) / (E (1 - nu)).
for _, t in ipairs{ 1e-4, 1e-3 } do
  local C = t * 0.4 * 1.3 / (1000 * 0.7)
  local a = (1.5 * 10 * 10 * C) ^ (1 / 3)
  local c = contact{ load = 10, model = { upper = body.cylinder{ radius = 10, E = rigid }, lower = body.block{ E = rigid, layers = soft(t, 1000, 0.3) } } }
  within(c.p_center, a * a / (20 * C), 0.01,
    ("layer of %g mm, thin as springs: centre pressure [MPa]"):format(t))
  below(off_elements(c, a), 1, "very thin layer: error of the half width [elements]")
end
-- Tests layers of rubber, which bulges beside the contact, against centre pressures on eight times finer
-- meshes: 0.8294, 24.53 and 1.4222 MPa.
for _, row in ipairs{ { 20, 0.3, 0.1, 0.83026 }, { 2000, 0.1, 1, 24.606 }, { 20, 0.1, 0.1, 1.4222 } } do
  local E, t, load, p0 = table.unpack(row)
  local c = contact{ load = load, model = { lower = body.block{ layers = soft(t * 0.10764, E, 0.49) } } }
  within(c.p_center, p0, 0.01, ("rubber of %g MPa, %g half widths thick: centre pressure [MPa]"):format(E, t))
end

-- --- rounded punches ----------------------------------------------------------------------------

-- Computes the contact of a rounded punch on half-planes in closed form (flat half width b, edge radius R,
-- contact half width a): the load is P(a) = E* / (4 R) a^2 (pi - 2 f - sin 2f) with sin f = b / a, and the
-- pressure p(x) is the integral over a of P' / (pi sqrt(a^2 - x^2)).
local E_star = 109890.1
local function punch_law(flat, radius, load)
  local b, low, high = flat / 2, 0, math.pi / 2
  local function of(f) return math.pi - 2 * f - math.sin(2 * f) end
  for _ = 1, 60 do
    local f = (low + high) / 2
    if E_star / (4 * radius) * (b / math.sin(f)) ^ 2 * of(f) > load then low = f else high = f end
  end
  local a = b / math.sin(low)
  local function pressure(x)
    local from, sum, steps = math.sqrt(math.max(x, b) ^ 2 - x * x), 0, 400
    local du = (math.sqrt(a * a - x * x) - from) / steps
    for i = 1, steps do
      local s = math.sqrt(x * x + (from + du * (i - 0.5)) ^ 2)
      local f = math.asin(b / s)
      sum = sum + E_star / (4 * radius) * (2 * s * of(f) + 4 * b * math.cos(f)) / s
    end
    return sum * du / math.pi
  end
  local most = 0
  for i = 0, 200 do most = math.max(most, pressure(b + (a - b) * (i / 200 * 0.9 - 0.2))) end
  return a, pressure(0), most
end
for _, row in ipairs{ { 1, 2, 200 }, { 1, 2, 2000 }, { 0.1, 5, 100 }, { 0.7, 2, 200 }, { 0.93, 1.7, 250 } } do
  local flat, radius, load = table.unpack(row)
  local a, p0, most = punch_law(flat, radius, load)
  local c = contact{ load = load, model = { upper = body.punch{ flat = flat, radius = radius, height = 10 },
    lower = body.block{ width = 20, height = 10 } } }
  local of = ("punch, flat %g, edges %g mm, %g N: "):format(flat, radius, load)
  within(c.p_center, p0, 0.01, of .. "centre pressure of half-planes [MPa]")
  within(c.p_max, most, 0.02, of .. "largest pressure [MPa]")
  below(off_elements(c, a), 1, of .. "error of the half width [elements]")
end
warnings.keep()
warnings.take()
contact{ load = 20, model = { upper = body.punch{ flat = 2, radius = 0.5, height = 10 }, lower = body.block{ width = 20, height = 10 },
  mesh = { size = 0.05 } } }
ok((warnings.take() or ""):find("its peaks there are too low until wear widens the edges; a mesh that resolves them would be too large", 1, true),
  "edges with too few elements give a warning")
contact{ load = 500, model = { upper = body.punch{ flat = 1, radius = 1, height = 10 }, lower = body.block{ width = 20, height = 10 },
  mesh = { size = 0.05 } } }
ok((warnings.take() or ""):find("its peaks there are too low until wear widens the edges; mesh.size = ", 1, true),
  "and the size that resolves them, if such a mesh is small enough")

-- --- pins ---------------------------------------------------------------------------------------

-- Tests that loads proportional to the clearance have the same contact angle and almost the same ratio of
-- centre pressure to load.
local least, most = math.huge, 0
for i = 1, 40 do
  local clearance = i * 0.0025
  local load = 2e5 * clearance
  local c = contact{ load = load, model = { upper = body.disc{ radius = 10 - clearance }, lower = body.ring{ inner = 10, outer = 20 } } }
  least, most = math.min(least, c.p_center / load), math.max(most, c.p_center / load)
end
below(most / least - 1, 0.01, "pins of 40 clearances: variation of centre pressure / load")
local liner = { upper = body.disc{ radius = 13.9 }, lower = body.ring{ inner = 14, outer = 30, layers = soft(8, 850, 0.46) } }
local worn_in = contact{ load = 100, model = liner }
liner.mesh = { fineness = 3 }
within(worn_in.p_center, contact{ load = 100, model = liner }.p_center, 0.01,
  "liner with a steel back: centre pressure against a finer mesh [MPa]")

-- --- profiles -----------------------------------------------------------------------------------

local function parabola(radius) return function(x) return -x * x / (2 * radius) end end
for what, case in pairs{
  ["a parabola"] = { 10, { upper = body.profile{ width = 4, height = 2, y = parabola(10) }, lower = body.block{} } },
  ["a circle, wide"] = { 10, { upper = body.profile{ width = 16, height = 10, y = function(x) return math.sqrt(100 - x * x) end }, lower = body.block{} } },
  ["with its crest beside the middle"] = { 10,
    { upper = body.profile{ width = 4, height = 2, y = function(x) return -(x - 0.3) ^ 2 / 20 end },
      lower = body.block{} } },
  ["as the lower body"] = { 20 / 3, { upper = body.cylinder{ radius = 10 },
    lower = body.profile{ width = 20, height = 10, y = parabola(20) } } },
  ["with a hollow"] = { 20, { upper = body.cylinder{ radius = 10 },
    lower = body.profile{ width = 20, height = 10, y = parabola(-20) } } } } do
  local radius, pair = table.unpack(case)
  local c, theory = contact{ model = pair }, hertz{ radius = radius }
  within(c.p_max, theory.p_max, 0.002, "profile, " .. what .. ": largest pressure [MPa]")
  within(c.model.mesh.size, theory.half_width / 5.382, 0.03,
    "profile, " .. what .. ": element size of an equal cylinder [mm]")
end
local level = { upper = body.profile{ width = 4, height = 2, y = function() return 0 end }, lower = body.block{} }
ok(pcall(model, level), "a flat profile is meshed")
local _, why = pcall(contact, { model = level })
ok(tostring(why):find("the bodies are too small for this contact", 1, true),
  "a contact wider than the bodies is reported")

-- --- balls --------------------------------------------------------------------------------------

for _, row in ipairs{ { 10, 50, 200e3 }, { 10, 5, 200e3 }, { 3, 100, 400e3 } } do
  local radius, load, E = table.unpack(row)
  local pair = { geometry = "axisymmetric", radius = radius, cylinder = { E = E } }
  local c, theory = contact{ load = load, model = pair }, hertz{ geometry = "axisymmetric", radius = radius, load = load, cylinder = { E = E } }
  local of = ("ball of %g mm, %g N: "):format(radius, load)
  within(c.p_center, theory.p_max, 0.003, of .. "centre pressure [MPa]")
  if radius == 10 then within(c.approach, theory.approach, 0.01, of .. "approach [mm]") end
  pair.mesh = { fineness = 2 }
  within(c.approach, contact{ load = load, model = pair }.approach, 0.001,
    of .. "approach against a finer mesh [mm]")
end

-- --- messages -----------------------------------------------------------------------------------

for what, case in pairs{
  ["a soft layer"] = { 10, { upper = body.cylinder{ E = rigid }, lower = body.block{ E = rigid, layers = soft(0.1, 1000, 0.3) } } },
  ["a punch"] = { 200, { upper = body.punch{ flat = 1, radius = 2, height = 10 }, lower = body.block{ width = 20, height = 10 } } },
  ["a liner"] = { 100, { upper = liner.upper, lower = liner.lower } } } do
  local load, pair = table.unpack(case)
  local free = contact{ load = load, model = pair }
  local size = free.model.mesh.size
  pair.mesh = { size = size, zone = { cylinder = 8 * size, plate = 8 * size } }
  local _, narrow = pcall(contact, { load = load, model = pair })
  local upper, lower = tostring(narrow):match("needs mesh.zone = {cylinder = ([%d.]+), plate = ([%d.]+)} mm")
  pair.mesh.zone = { cylinder = tonumber(upper), plate = tonumber(lower) }
  within(contact{ load = load, model = pair }.p_max, free.p_max, 1e-3,
    "largest pressure with the zones suggested for " .. what)
end

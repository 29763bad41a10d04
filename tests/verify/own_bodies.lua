-- Bodies of one's own against closed forms and independent numbers: punches, pins in bushes, layers,
-- waves; and what wears them.
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local bush_law = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/bush.lua")
local within, below = figures.within, figures.below

local function hexes(c) return ("%a %a %a"):format(c.p_max, c.half_width, c.approach) end

-- --- the paper's pair, as bodies ----------------------------------------------------------------

figures.ok(hexes(contact{ model = { upper = body.cylinder{ radius = 10 }, lower = body.block{ width = 20, height = 10 } } })
  == hexes(contact{}), "cylinder on block is the paper's pair to the bit")

-- --- rounded punch ------------------------------------------------------------------------------

-- sin f = b/a, 4 P R / (E* a^2) = pi - 2 f - sin 2f on half-planes: a = 0.530577. Bodies 10 mm high
-- by finite elements of 5 um, another program: p(0) = 123.70, p_max = 644.46.
local punch = model{ upper = body.punch{ flat = 1, radius = 2, height = 10 }, lower = body.block{ width = 20, height = 10 },
  mesh = { size = 0.01, height = 0.0125, zone = { cylinder = 1.4, plate = 1.4 } } }
local c = contact{ model = punch, load = 200 }
within(c.p_center, 123.70, 0.005, "rounded punch: centre pressure [MPa]")
within(c.p_max, 644.46, 0.02, "rounded punch: largest pressure [MPa]")
below(math.abs(c.half_width - 0.530577), 0.01, "rounded punch: half width, off by less than an element [mm]")
local p = c:pressure("cylinder").p
local lopsided = 0
for i = 1, #p do lopsided = math.max(lopsided, math.abs(p[i] - p[#p + 1 - i]) / c.p_max) end
below(lopsided, 1e-9, "rounded punch: symmetric")
local below_it = contact{ model = { upper = body.block{ width = 20, height = 10 },
  lower = body.punch{ flat = 1, radius = 2, height = 10 }, mesh = { size = 0.01, height = 0.0125,
    zone = { cylinder = 1.4, plate = 1.4 } } }, load = 200 }
within(below_it.p_center, c.p_center, 1e-3, "rounded punch: from below it is the same")

-- --- pin in a bush ------------------------------------------------------------------------------

-- Fourier series of a bush of outer radius 20, built in: clearance, load, semi-angle, p(0).
local function pin(c, load, zone, size)
  return contact{ load = load, model = { upper = body.disc{ radius = 10 - c / 2 },
    lower = body.ring{ inner = 10 + c / 2, outer = 20 + c / 2 },
    mesh = { size = size, height = size, far = 1, zone = { cylinder = zone, plate = zone } } } }
end
for _, row in ipairs{ { 0.05, 100, 8.60, 42.54, 6, 0.05 }, { 0.05, 1000, 24.87, 151.32, 14, 0.1 },
  { 0.05, 10000, 56.45, 766.32, 25, 0.2 }, { 0.2, 1000, 13.34, 275.46, 8, 0.05 } } do
  local clearance, load, angle, p0, zone, size = table.unpack(row)
  local solved = pin(clearance, load, zone, size)
  local of = ("pin in a bush, c = %g mm, %g N: "):format(clearance, load)
  within(solved.p_center, p0, 0.01, of .. "centre pressure [MPa]")
  below(math.abs(math.deg(solved.half_width / (10 + clearance / 2)) - angle), math.deg(size / 10),
    of .. "semi-angle, off by less than an element [degrees]")
  figures.ok(solved.normal_force > load, of .. "normal forces are more than the load")
end
-- A cup over a pin is the same, upside down.
local cup = contact{ load = 1000, model = { upper = body.ring{ inner = 10.025, outer = 20.025 },
  lower = body.disc{ radius = 9.975 }, mesh = { size = 0.1, height = 0.1, far = 1, zone = { cylinder = 14, plate = 14 } } } }
within(cup.p_center, pin(0.05, 1000, 14, 0.1).p_center, 2e-3, "a cup over a pin: the same upside down")

-- --- layers -------------------------------------------------------------------------------------

local function layered(upper_E, base_E, thickness, E, nu, load, size, rows, zone)
  return contact{ load = load, model = { upper = body.cylinder{ radius = 10, E = upper_E },
    lower = body.block{ width = 20, height = 10, E = base_E, layers = { { thickness = thickness, E = E, nu = nu } } },
    mesh = { size = size, height = size, rows = rows, far = 1, zone = { cylinder = zone, plate = zone } } } }
end
local function check_layer(what, solved, p0, half, element)
  within(solved.p_center, p0, 0.01, what .. ": centre pressure [MPa]")
  if half then below(math.abs(solved.half_width - half), element, what .. ": half width, off by less than an element [mm]") end
end
check_layer("rigid cylinder, layer of 0.1", layered(1e9, 1e9, 0.1, 1000, 0.3, 10, 0.01, 3, 0.7), 33.257, 0.2102, 0.01)
check_layer("rigid cylinder, layer of 1", layered(1e9, 1e9, 1, 1000, 0.3, 10, 0.02, 3, 1), 19.412, 0.3283, 0.02)
check_layer("rigid cylinder, nu = 0.49", layered(1e9, 1e9, 1, 1000, 0.49, 10, 0.02, 3, 1), 21.372, 0.298, 0.02)
check_layer("coat of 0.1", layered(210e3, 210e3, 0.1, 400e3, 0.3, 100, 0.005, 3, 0.5), 663.00, 0.096, 0.005)
check_layer("coat of 0.005", layered(210e3, 210e3, 0.005, 400e3, 0.3, 100, 0.0025, 2, 0.4), 608.88)
local alike = layered(200e3, 200e3, 0.05, 200e3, 0.3, 100, 0.02, 3, 1)
within(alike.p_center, contact{ model = { mesh = { size = 0.02, height = 0.02, zone = { cylinder = 1, plate = 1 } } } }.p_center,
  2e-3, "a layer of the same material is none")

-- --- waves --------------------------------------------------------------------------------------

-- Westergaard: with p* = pi E* D / l, waves that touch over 2 a of each length l carry a mean of
-- p* sin^2(pi a / l), with 2 mean / sin(pi a / l) at the crest. On a crowned profile for the wave in the middle.
local length, height = 0.1, 1e-4
local star = math.pi * 109890.1 * height / length
local rough = contact{ load = 50, average = 0, model = {
  upper = body.profile{ width = 4, height = 2,
    y = function(x) return height * math.cos(2 * math.pi * x / length) - x * x / 440 end },
  lower = body.block{ width = 4, height = 2 },
  mesh = { size = 0.002, height = 0.0025, far = 0.2, zone = { cylinder = 1.2, plate = 1.2 } } } }
local at = rough:pressure("cylinder")
local force, touching = 0, 0
for i, x in ipairs(at.x) do
  local share = math.max(0, math.min(1, (length / 2 - math.abs(x)) / 0.002 + 0.5)) -- of the node's width
  force = force + share * at.p[i] * 0.002
  if at.p[i] > 0 then touching = touching + share * 0.002 end
end
local mean, sine = force / length, math.sin(math.pi * touching / 2 / length)
figures.about(touching / length, 2 / math.pi * math.asin(math.sqrt(mean / star)), 0.02, "waves: share in contact, within an element")
within(rough.p_center, 2 * mean / math.sqrt(mean / star), 0.01, "waves: pressure at a crest [MPa]")

-- --- what wears them ----------------------------------------------------------------------------

-- A bush that alone wears, the load fixed in it, comes to h = delta cos t - c, p = p0 cos t with cos e = c / delta
-- and V = 2 R c (tan e - e): from the volume to the depth.
local R, gap, P, k = 10, 0.05, 1000, 1e-6
local bush = model{ upper = body.disc{ radius = R - gap }, lower = body.ring{ inner = R, outer = 20 },
  mesh = { size = 0.25, height = 0.1, rows = 4, far = 1, zone = { cylinder = 26, plate = 26 } } }
local function angle_of(volume) return bush_law.angle_of(R, gap, volume) end
for _, goal in ipairs{ { 0.5, 0.09 }, { 1, 0.036 }, { 2, 0.014 } } do
  local share, off = table.unpack(goal)
  local w = wear{ model = bush, k_cylinder = 0, k_plate = k, load = P, stroke = 0.01, jump = "auto",
    distance = share * R * gap / (k * P) }
  w:run()
  local e = angle_of(w.volume_plate)
  local of = ("bush worn to k P s / (R c) = %g: "):format(share)
  within(w.depth_plate, gap / math.cos(e) - gap, off + 0.005, of .. "depth by the cosine law [mm]")
  within(w.p_center, P / (R * (e + math.sin(e) * math.cos(e))), off + 0.005, of .. "pressure by the cosine law [MPa]")
  figures.ok(w.volume_cylinder == 0, of .. "the pin does not wear")
  within(w.volume_plate, k * w.load_distance, 1e-12, of .. "V = k integral normal force ds [mm3]")
  figures.ok(w.load_distance > 1.05 * P * w.distance, of .. "normal forces are more than the load")
end

-- On the mesh that it gets by itself, too; its surfaces move, and are condensed anew on the way.
for _, geometry in ipairs{ "moving", "frozen" } do
  local w = wear{ model = { upper = body.disc{ radius = R - gap }, lower = body.ring{ inner = R, outer = 20, name = "bush" } },
    k_cylinder = 0, k_plate = k, load = P, slide = "z", jump = "auto", distance = R * gap / (k * P), geometry = geometry }:run()
  below(bush_law.deviation(w, R, gap), 0.041, ("bush worn on its own mesh, %s: pressures off the cosine law"):format(geometry))
end

-- Both wear, their surfaces move, and slide in the plane or out of it: the force that wears them is the same on both.
for _, way in ipairs{ { slide = "z", jump = "auto" }, { slide = "z", scheme = "implicit", tolerance = 1e-3 },
  { slide = "x", scheme = "implicit", tolerance = 1e-3 } } do
  local w = wear{ model = bush, k = k, alpha = 0.3, load = P, stroke = 0.5, distance = 30, slide = way.slide, jump = way.jump,
    scheme = way.scheme, tolerance = way.tolerance }:run()
  local of = ("bush and pin worn, slide %s, %s: V = k integral normal force ds "):format(way.slide, way.scheme or "explicit")
  within(w.volume_cylinder, 0.3 * k * w.load_distance, 1e-12, of .. "of the pin [mm3]")
  within(w.volume_plate, 0.7 * k * w.load_distance, 1e-12, of .. "of the bush [mm3]")
end

-- A coat that wears ten times slower than what it lies on: V = k F s in it, faster beneath.
local coated = model{ radius = 10, lower = body.block{ width = 20, height = 10, k = 1e-7,
  layers = { { thickness = 2e-3, E = 400e3, nu = 0.3, k = 1e-8 } } }, mesh = { size = 0.04, height = 0.02, zone = { cylinder = 2, plate = 2 } } }
local function worn_by(distance)
  local w = wear{ model = coated, load = 100, stroke = 0.01, distance = distance, jump = "auto" }
  w:run()
  return w
end
local early, late = worn_by(100), worn_by(4000)
within(early.volume_plate, 1e-8 * 100 * 100, 1e-9, "coat: volume by its own k while it lasts [mm3]")
figures.ok(early.depth_plate < 2e-3, "coat: not through yet")
figures.ok(late.depth_plate > 2e-3 and late.volume_plate > 1e-8 * 100 * 4000 * 1.2, "coat: through, and wear goes faster")

-- Where the plate wears evenly, its layers do: under a stroke over all of it, and on the track of a pin.
local slow = material{ E = 200e3, nu = 0.3, k = 1e-9 }
local function on(thickness, k_below) return body.block{ k = k_below, layers = { { thickness = thickness, material = slow } } } end
for _, scheme in ipairs{ "explicit", "implicit" } do
  local w = wear{ load = 100, stroke = 20, distance = 2000, jump = 10, scheme = scheme, model = { lower = on(1, 2e-8) } }:run()
  within(w.volume_plate, 1e-9 * 100 * 2000, 1e-12, "layer over the whole plate, " .. scheme .. ": volume by its own k [mm3]")
end
local through = wear{ load = 100, stroke = 20, distance = 120000, jump = 7, model = { lower = on(0.5e-3, 2e-8) } }:run()
within((through.depth_plate - 0.5e-3) / 2e-8 + 0.5e-3 / 1e-9, 100 * 120000 / 20, 1e-12, "layer worn through evenly: integral dh / k [N]")
for _, thickness in ipairs{ 1, 1e-4 } do
  local w = wear{ load = 50, slide = "z", track = 20, cycles = 1000, jump = 100, model = { geometry = "axisymmetric",
    upper = body.cylinder{ radius = 10, k = 1e-13 }, lower = on(thickness, 2e-8) } }:run()
  local alone = 1e-9 * 50 * w.distance
  if thickness == 1 then
    within(w.volume_plate, alone, 1e-12, "layer under a track: volume by its own k [mm3]")
  else -- the mean depth goes through it where it is as deep
    local left = 2 * math.pi * 20 * 2 * w.half_width * thickness
    within(w.volume_plate, left + 20 * (alone - left), 0.01, "layer under a track, worn through: volume [mm3]")
  end
end

-- What is left of a layer carries: the pressure on a plate worn evenly is that on one with so thin a layer,
-- and of the base alone in the end. The soft layer is wholly in rows of its own, of which little is left.
local function worn_evenly(E, base, load, thickness, depths, tolerance)
  local function pair(left)
    return { upper = body.cylinder{ radius = 10, E = base, k = 0 }, lower = body.block{ width = 20, height = 10, E = base, k = 1e-6,
      layers = left > 0 and { { thickness = left, material = material{ E = E, nu = 0.3, k = 1e-6 } } } or nil } }
  end
  local w = wear{ load = load, stroke = 20, distance = 1e6, jump = 100, model = pair(thickness) }
  for _, depth in ipairs(depths) do
    w:run{ depth = { plate = depth } }
    within(w.p_center, contact{ load = load, model = pair(math.max(0, thickness - depth)) }.p_center, tolerance,
      ("E %g on %g MPa, %g of %g mm worn evenly: pressure [MPa]"):format(E, base, depth, thickness))
  end
end
worn_evenly(1000, 1e9, 10, 0.1, { 0.02, 0.05, 0.085 }, 0.03)
worn_evenly(20e3, 200e3, 100, 0.01, { 0.0025, 0.0075, 0.02 }, 0.005)

-- A layer that is never worn through wears as a body of its material does, however fast the one beneath would.
local function under_stroke(lower, scheme)
  return wear{ load = 100, stroke = 0.2, distance = 3000, scheme = scheme, jump = scheme == "explicit" and "auto" or nil,
    tolerance = scheme == "implicit" and 1e-3 or nil, model = { upper = body.cylinder{ radius = 10, k = 0 }, lower = lower } }:run()
end
for _, scheme in ipairs{ "explicit", "implicit" } do
  local layered, plain = under_stroke(on(0.05, 2e-8), scheme), under_stroke(body.block{ k = 1e-9 }, scheme)
  local of = ("layer never worn through, %s: "):format(scheme)
  within(layered.depth_plate, plain.depth_plate, 0.002, of .. "depth of its material alone [mm]")
  within(layered.p_center, plain.p_center, 0.005, of .. "pressure of its material alone [MPa]")
  figures.ok(layered.update <= 2 * plain.update, of .. "in updates as long")
end

-- Coats thinner than what a hundredth of the wear box is, of the material that they lie on.
local function in_hole(coat, on_pin)
  local layers = coat and { { thickness = coat, material = material{ E = 200e3 } } }
  return contact{ load = P, model = { upper = body.disc{ radius = R - gap, layers = on_pin and layers or nil },
    lower = body.ring{ inner = R, outer = 20, layers = not on_pin and layers or nil } } }.p_center
end
for _, coat in ipairs{ 2e-3, 1e-5 } do
  for _, on_pin in ipairs{ true, false } do
    within(in_hole(coat, on_pin), in_hole(), 1e-3, ("coat of %g mm on the %s: pressure [MPa]"):format(coat, on_pin and "pin" or "bush"))
  end
end

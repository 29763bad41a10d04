-- Tests pins in bushes against Fourier series, worn bushes against the cosine law, and coatings in bushes.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local bush_law = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/bush.lua")
local within, below = figures.within, figures.below

-- --- pin in a bush ------------------------------------------------------------------------------

-- Computes a pin in a bush of outer radius 20 mm, which is fixed outside. The references below are from
-- Fourier series: clearance [mm], load [N/mm], half angle of the contact [degrees], p(0) [MPa].
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
    of .. "error of the half angle, below an element [degrees]")
  figures.ok(solved.normal_force > load, of .. "the normal force exceeds the load")
end
-- Tests a cup over a pin, a pin in a bush turned upside down.
local cup = contact{ load = 1000, model = { upper = body.ring{ inner = 10.025, outer = 20.025 },
  lower = body.disc{ radius = 9.975 }, mesh = { size = 0.1, height = 0.1, far = 1, zone = { cylinder = 14, plate = 14 } } } }
within(cup.p_center, pin(0.05, 1000, 14, 0.1).p_center, 2e-3, "a cup over a pin: pressure of a pin in a bush")

-- --- worn ----------------------------------------------------------------------------------------

-- Tests the cosine law of a bush that wears alone (see lib/bush.lua) under a fixed load. The worn volume V
-- determines the half angle e of the contact and thus the depth.
local R, gap, P, k = 10, 0.05, 1000, 1e-6
local bush = model{ upper = body.disc{ radius = R - gap }, lower = body.ring{ inner = R, outer = 20 },
  mesh = { size = 0.25, height = 0.1, rows = 4, far = 1, zone = { cylinder = 26, plate = 26 } } }
local function angle_of(volume) return bush_law.angle_of(R, gap, volume) end
for _, goal in ipairs{ { 0.5, 0.09 }, { 1, 0.036 }, { 2, 0.014 } } do
  local share, off = table.unpack(goal)
  local w = wear{ model = bush, k_cylinder = 0, k_plate = k, load = P, stroke = 0.01, scheme = "explicit",
    distance = share * R * gap / (k * P) }
  w:run()
  local e = angle_of(w.volume_plate)
  local of = ("bush worn to k P s / (R c) = %g: "):format(share)
  within(w.depth_plate, gap / math.cos(e) - gap, off + 0.005, of .. "depth by the cosine law [mm]")
  within(w.p_center, P / (R * (e + math.sin(e) * math.cos(e))), off + 0.005, of .. "pressure by the cosine law [MPa]")
  figures.ok(w.volume_cylinder == 0, of .. "the pin does not wear")
  within(w.volume_plate, k * w.load_distance, 1e-12, of ..
    "V is k times the integral of the normal force over the distance [mm3]")
  figures.ok(w.load_distance > 1.05 * P * w.distance, of .. "the normal force exceeds the load")
end

-- Tests the cosine law on the default mesh, too, with frozen geometry and with moving surfaces, whose
-- stiffness is recomputed during the run.
for _, geometry in ipairs{ "moving", "frozen" } do
  local w = wear{ model = { upper = body.disc{ radius = R - gap }, lower = body.ring{ inner = R, outer = 20, name = "bush" } },
    k_cylinder = 0, k_plate = k, load = P, slide = "z", scheme = "explicit", distance = R * gap / (k * P), geometry = geometry }:run()
  below(bush_law.deviation(w, R, gap), 0.041,
    ("bush on the default mesh, %s geometry: deviation of the pressures from the cosine law"):format(geometry))
end

-- Tests wear of both bodies with moving surfaces and sliding in the plane or out of it: the same force wears
-- both bodies.
for _, way in ipairs{ { slide = "z", jump = "auto" }, { slide = "z", scheme = "implicit", tolerance = 1e-3 },
  { slide = "x", scheme = "implicit", tolerance = 1e-3 } } do
  local w = wear{ model = bush, k = k, alpha = 0.3, load = P, stroke = 0.5, distance = 30, slide = way.slide, jump = way.jump,
    scheme = way.scheme, tolerance = way.tolerance }:run()
  local of = ("bush and pin worn, slide %s, %s: volume by the integral of the normal force, "):format(way.slide, way.scheme or "explicit")
  within(w.volume_cylinder, 0.3 * k * w.load_distance, 1e-12, of .. "pin [mm3]")
  within(w.volume_plate, 0.7 * k * w.load_distance, 1e-12, of .. "bush [mm3]")
end

-- Tests coatings thinner than a hundredth of the wear box, of the same material as their base.
local function in_hole(coat, on_pin)
  local layers = coat and { { thickness = coat, material = material{ E = 200e3 } } }
  return contact{ load = P, model = { upper = body.disc{ radius = R - gap, layers = on_pin and layers or nil },
    lower = body.ring{ inner = R, outer = 20, layers = not on_pin and layers or nil } } }.p_center
end
for _, coat in ipairs{ 2e-3, 1e-5 } do
  for _, on_pin in ipairs{ true, false } do
    within(in_hole(coat, on_pin), in_hole(), 1e-3,
      ("coating of %g mm on the %s: pressure without it [MPa]"):format(coat, on_pin and "pin" or "bush"))
  end
end

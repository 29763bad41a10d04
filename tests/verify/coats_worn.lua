-- Tests the wear of layers and coatings: volumes by the coefficient of each layer, and pressures on the
-- remaining layers.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, below = figures.within, figures.below

-- --- worn ----------------------------------------------------------------------------------------

-- Tests a coating that wears ten times slower than its base. The volume is V = k F s with the coating's k until the
-- coating is worn through, then the volume grows faster.
local coated = model{ radius = 10, lower = body.block{ width = 20, height = 10, k = 1e-7,
  layers = { { thickness = 2e-3, E = 400e3, nu = 0.3, k = 1e-8 } } }, mesh = { size = 0.04, height = 0.02, zone = { cylinder = 2, plate = 2 } } }
local function worn_by(distance)
  local w = wear{ model = coated, load = 100, stroke = 0.01, distance = distance, scheme = "explicit" }
  w:run()
  return w
end
local early, late = worn_by(100), worn_by(4000)
within(early.volume_plate, 1e-8 * 100 * 100, 1e-9, "coating not worn through: volume by its own k [mm3]")
figures.ok(early.depth_plate < 2e-3, "coating: the depth is less than the thickness")
figures.ok(late.depth_plate > 2e-3 and late.volume_plate > 1e-8 * 100 * 4000 * 1.2,
  "coating worn through: wear is faster than by the coating's k")

-- Tests that uniform wear of the plate includes its layers: with a stroke over the whole plate, and on the
-- track of a pin.
local slow = material{ E = 200e3, nu = 0.3, k = 1e-9 }
local function on(thickness, k_below) return body.block{ k = k_below, layers = { { thickness = thickness, material = slow } } } end
for _, scheme in ipairs{ "explicit", "implicit" } do
  local w = wear{ load = 100, stroke = 20, distance = 2000, jump = 10, scheme = scheme, model = { lower = on(1, 2e-8) } }:run()
  within(w.volume_plate, 1e-9 * 100 * 2000, 1e-12, "layer over the whole plate, " .. scheme .. ": volume by its own k [mm3]")
end
local through = wear{ load = 100, stroke = 20, distance = 120000, jump = 7, model = { lower = on(0.5e-3, 2e-8) } }:run()
within((through.depth_plate - 0.5e-3) / 2e-8 + 0.5e-3 / 1e-9, 100 * 120000 / 20, 1e-12,
  "layer worn through uniformly: integral of dh / k [N]")
for _, thickness in ipairs{ 1, 1e-4 } do
  local w = wear{ load = 50, slide = "z", track = 20, cycles = 1000, jump = 100, model = { geometry = "axisymmetric",
    upper = body.cylinder{ radius = 10, k = 1e-13 }, lower = on(thickness, 2e-8) } }:run()
  local alone = 1e-9 * 50 * w.distance
  if thickness == 1 then
    within(w.volume_plate, alone, 1e-12, "layer under a track: volume by its own k [mm3]")
  else  -- after the layer is worn through, the mean depth is compared
    local left = 2 * math.pi * 20 * 2 * w.half_width * thickness
    within(w.volume_plate, left + 20 * (alone - left), 0.01, "layer under a track, worn through: volume [mm3]")
  end
end

-- Tests that the remaining layer carries the load. The pressure on a uniformly worn plate equals the pressure
-- on a plate with a layer of the remaining thickness, and finally the pressure on the base. The soft layer
-- has its own element rows, of which few remain.
local function worn_evenly(E, base, load, thickness, depths, tolerance)
  local function pair(left)
    return { upper = body.cylinder{ radius = 10, E = base, k = 0 }, lower = body.block{ width = 20, height = 10, E = base, k = 1e-6,
      layers = left > 0 and { { thickness = left, material = material{ E = E, nu = 0.3, k = 1e-6 } } } or nil } }
  end
  local w = wear{ load = load, stroke = 20, distance = 1e6, jump = 100, model = pair(thickness) }
  for _, depth in ipairs(depths) do
    w:run{ depth = { plate = depth } }
    within(w.p_center, contact{ load = load, model = pair(math.max(0, thickness - depth)) }.p_center, tolerance,
      ("layer of E %g on %g MPa, %g of %g mm worn uniformly: pressure [MPa]"):format(E, base, depth,
        thickness))
  end
end
worn_evenly(1000, 1e9, 10, 0.1, { 0.02, 0.05, 0.085 }, 0.03)
worn_evenly(20e3, 200e3, 100, 0.01, { 0.0025, 0.0075, 0.02 }, 0.005)

-- Tests that a layer that is never worn through wears like a body of its material, whatever the coefficient
-- of the material below.
local function under_stroke(lower, scheme)
  return wear{ load = 100, stroke = 0.2, distance = 3000, scheme = scheme, jump = scheme == "explicit" and "auto" or nil,
    tolerance = scheme == "implicit" and 1e-3 or nil, model = { upper = body.cylinder{ radius = 10, k = 0 }, lower = lower } }:run()
end
for _, scheme in ipairs{ "explicit", "implicit" } do
  local layered, plain = under_stroke(on(0.05, 2e-8), scheme), under_stroke(body.block{ k = 1e-9 }, scheme)
  local of = ("layer never worn through, %s: "):format(scheme)
  within(layered.depth_plate, plain.depth_plate, 0.002, of .. "depth of a body of its material [mm]")
  within(layered.p_center, plain.p_center, 0.005, of .. "pressure of a body of its material [MPa]")
  figures.ok(layered.update <= 2 * plain.update, of .. "at most twice the number of updates")
end

-- Tests that the meshes that follow a scar stay fine enough for the coating exposed at its edges, where it
-- carries ten times the pressure of the centre. The values are those of elements of 0.0141 mm.
local warnings = require "archard.warnings"
for _, scheme in ipairs{ "explicit", "implicit" } do
  warnings.keep()
  local w = wear{ load = 100, stroke = 1, distance = 1e5, scheme = scheme, jump = scheme == "explicit" and "auto" or nil, model = { lower = body.block{ k = 0 },
    upper = body.cylinder{ radius = 10, k = 1e-8, layers = { { thickness = 3e-3, material = material{ E = 200e3, nu = 0.25, k = 1e-9 } } } } } }:run()
  local of = ("coating exposed at the edges of a scar, %s: "):format(scheme)
  figures.ok((warnings.take() or ""):find("a layer is worn through, and 0.05", 1, true),
    of .. "a warning that the exposed layer is narrow")
  within(w.p_center, 41.43, 0.01, of .. "pressure in the centre [MPa]")
  within(w.depth_cylinder, 42.047e-3, 0.002, of .. "depth [mm]")
  within(w.volume_cylinder, 0.051445, 0.002, of .. "volume [mm3]")
end

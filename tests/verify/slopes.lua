-- Tests deep scars with inclined surfaces: the outlines lose the area k L d in total, and the losses of both
-- bodies have the ratio k_c to k_p.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, below, ok = figures.within, figures.below, figures.ok

-- Returns the area below the polyline through the points (x, y).
local function under(x, y)
  local sum = 0
  for i = 2, #x do sum = sum + (x[i] - x[i - 1]) * (y[i] + y[i - 1]) / 2 end
  return sum
end

-- Returns the area lost from the outline of a body [mm2], computed by the polygon of the body's present
-- nodes.
local function lost(w, body)
  local p, y, radius = w:profile(body), {}, w.model.radius
  for i, x in ipairs(p.x) do y[i] = body == "plate" and 0 or radius - math.sqrt(radius ^ 2 - x ^ 2) end
  return (body == "plate" and -1 or 1) * (under(p.worn_x, p.y) - under(p.x, y))
end

local function deep(radius, distance, couple)
  local zone = radius == 2 and 2 or 3.2
  local model = { radius = radius, cylinder = couple.cylinder, plate = couple.plate,
    mesh = { size = 0.02, height = 0.025, far = 1, rows = radius == 2 and 12 or 6, zone = { cylinder = zone, plate = zone * 1.1 } } }
  return wear{ k = 1e-6, load = 100, distance = distance, jump = couple.jump, scheme = couple.scheme,
    increments = 20, refresh = 0.05, stroke = 0.11, model = model }:run()
end

local cases = {
  { "R = 2 mm", deep(2, 300, {}) },
  { "R = 2 mm, soft plate", deep(2, 300, { plate = { E = 20e3 } }) },
  { "R = 2 mm, soft cylinder", deep(2, 300, { cylinder = { E = 20e3 } }) },
  { "R = 10 mm", deep(10, 660, { jump = 40, scheme = "implicit" }) },
  { "reference case", wear{}:run() },
}
for _, case in ipairs(cases) do
  local name, w = case[1], case[2]
  figures.note(("%s: %.3g um deep, slopes to %.2g"):format(name, 1e3 * (w.depth.cylinder + w.depth.plate),
    w.half_width / w.model.radius))
  for _, body in ipairs{ "cylinder", "plate" } do
    within(lost(w, body), w.k / 2 * 100 * w.distance, 1e-9,
      name .. ": area lost from the outline of the " .. body .. " [mm2]")
    below(figures.asymmetry(w:profile(body).h), 1e-9, name .. ": asymmetry of the " .. body)
  end
end

-- Tests that pressures act along normals. Between a stiff and a soft body the force components along x raise
-- or lower the surfaces, with opposite sign if the bodies are exchanged. If forces acted along the load, both
-- centre pressures would be more similar.
local soft_plate, soft_cylinder = cases[2][2], cases[3][2]
ok(soft_plate.p_center < soft_cylinder.p_center,
  "a soft plate with slopes has a lower centre pressure than a soft cylinder")

-- Tests slip that includes the elastic part: the volumes of both bodies follow from the same work, summed
-- over pairs of points.
for _, couple in ipairs{ { plate = { E = 2e3 } }, { plate = { E = 20e3 } }, { cylinder = { E = 2e3 } } } do
  for _, alpha in ipairs{ 0.25 } do
    couple.radius = 10
    local w = wear{ model = couple.plate and { plate = couple.plate, mesh = { zone = { cylinder = 2.4, plate = 2.8 } } }
      or { cylinder = couple.cylinder, mesh = { zone = { cylinder = 2.4, plate = 2.8 } } },
      slip = "total", alpha = alpha, increments = 40, jump = 100, distance = 220 }:run()
    local name = ("total slip, %s of E = %g, alpha = %g"):format(couple.plate and "plate" or "cylinder",
      (couple.plate or couple.cylinder).E, alpha)
    within(w.volume.cylinder / w.volume.plate, alpha / (1 - alpha), 1e-9, name .. ": V_c / V_p (Eq. 15)")
    figures.note(("%s: volume / (k L d) %.6f"):format(name, w.volume.total / (1e-8 * 100 * 220)))
  end
end
local soft = { E = 2e3, nu = 0.1 }
for name, w in pairs{ steel = wear{ slip = "total", stroke = 20, alpha = 0.3, jump = "auto", distance = 660 },
  ["soft bodies"] = wear{ slip = "total", stroke = 20, alpha = 0.3, load = 20, k = 5e-9, jump = "auto", distance = 800,
    model = { cylinder = soft, plate = soft } } } do
  w:run()
  within(w.volume.cylinder / w.volume.plate, 3 / 7, 1e-9, "total slip over the whole plate, " .. name .. ": V_c / V_p (Eq. 15)")
end
local steady = wear{ alpha = 1, slip = "total", distance = 440, jump = 100 }:run()
-- The plate's strain below the contact shortens the sliding distance. The strain at the surface of a
-- half-plane is -(1 + nu)(1 - 2 nu) p / E.
local strain = -1.3 * 0.4 * figures.mean(steady.history.p_center, 2) / 200e3
figures.about(steady.volume.total / 4.4e-4 - 1, strain, 0.15 * -strain, "total slip under a steady contact: V / (k L d) - 1")

-- Tests sliding out of the plane. Each point stays opposite to the same point of the other body. Therefore
-- the depth partition factor (alpha-tilde) equals alpha, and the sum of the largest depths of both bodies
-- equals the depth of the cylinder in a run with alpha = 1.
local one = wear{ alpha = 1 }:run()
for _, alpha in ipairs{ 0.25, 0.5 } do
  local w = wear{ alpha = alpha, slide = "z" }:run()
  within(w.depth_partition, alpha, 1e-5, ("slide = z, alpha = %g: alpha-tilde"):format(alpha))
  within(w.volume.cylinder / w.volume.total, alpha, 1e-4,
    ("slide = z, alpha = %g: fraction of the volume"):format(alpha))
  within(w.depth.cylinder + w.depth.plate, one.depth.cylinder, 1e-3,
    "slide = z: sum of depths against alpha = 1 [mm]")
  within(w.p_center, one.p_center, 1e-3, "slide = z: centre pressure against alpha = 1 [MPa]")
end

-- Tests a plate of slope m, which has an exact solution by rotation: the cylinder touches the plate beside
-- its axis with the normal force L sqrt(1 + m^2), so the largest pressure is Hertz' pressure times (1 +
-- m^2)^(1/4). Forces along y instead of the normal would have the factor (1 + m^2)^(3/4).
local function peak(c)
  local p, sum, top, at = c:pressure("cylinder"), {}, 0, 0
  for i, value in ipairs(p.p) do
    if value > top then top, at = value, i end
  end
  for i = 0, 4 do sum[i], sum[5 + i] = 0, 0 end
  for i, value in ipairs(p.p) do -- p^2 is a parabola, fitted by least squares to its upper part
    local x, y = (p.x[i] - p.x[at]) / 0.05, (value / top) ^ 2
    for power = 0, value > 0.6 * top and 4 or -1 do
      sum[power], sum[5 + power] = sum[power] + x ^ power, sum[5 + power] + y * x ^ power
    end
  end
  local s0, s1, s2, s3, s4 = table.unpack(sum, 0, 4)
  local t0, t1, t2 = table.unpack(sum, 5, 7)
  local det = s0 * (s2 * s4 - s3 * s3) - s1 * (s1 * s4 - s2 * s3) + s2 * (s1 * s3 - s2 * s2)
  local a = (t0 * (s2 * s4 - s3 * s3) - s1 * (t1 * s4 - t2 * s3) + s2 * (t1 * s3 - t2 * s2)) / det
  local b = (s0 * (t1 * s4 - t2 * s3) - t0 * (s1 * s4 - s2 * s3) + s2 * (s1 * t2 - s2 * t1)) / det
  local q = (s0 * (s2 * t2 - s3 * t1) - s1 * (s1 * t2 - s2 * t1) + t0 * (s1 * s3 - s2 * s2)) / det
  return top * math.sqrt(a - b * b / (4 * q))
end

local inclined = model{ radius = 2, mesh = { size = 0.01, height = 0.01, rows = 14, far = 0.3,
  zone = { cylinder = 0.8, plate = 0.8 } } }
for _, slope in ipairs{ 0.06, 0.12 } do
  local sum, count = 0, 0
  for load = 160, 240, 20 do
    local function plane(x) return 0.06 + slope * x end
    local c = contact{ model = inclined, load = load, worn = { plate = plane } }
    sum = sum + peak(c) / hertz{ radius = 2, load = load }.p_max
    count = count + 1
  end
  within(sum / count, (1 + slope * slope) ^ 0.25, 4e-4,
    ("plate inclined by %g: largest pressure / Hertz' pressure, mean of five loads"):format(slope))
end

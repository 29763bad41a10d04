-- Tests a ring that wears a block over 3600 m, until the scar is 25 times as wide as the initial contact.
-- Automatic steps and meshes are compared with much shorter steps, the limit of rigid bodies and published
-- depths.
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local below, within = figures.below, figures.within
local at_distance = require "archard.lib.history_at"

local metres = { 5, 50, 800, 1600, 3600 }
local radius, load, k = 20, 65 / 6, 2e-9 -- units: mm, N/mm, mm2/N

local function ring(fields, stops)
  fields.model, fields.load, fields.k_cylinder, fields.k_plate = { radius = radius }, load, 0, k
  fields.slide, fields.distance, fields.scheme = "z", 3600e3, "implicit"
  local w, depth = wear(fields), {}
  for i, m in ipairs(stops or metres) do
    w:run{ distance = 1000 * m, progress = false }
    depth[i] = w.depth.plate
  end
  return depth, w
end

local function worst(a, b, from)
  local largest = 0
  for i = from or 1, #a do largest = math.max(largest, math.abs(a[i] / b[i] - 1)) end
  return largest
end

local fine = ring{ tolerance = 2e-5 }
for _, case in ipairs{ { 1e-3, 1e-4, 60 }, { 1e-2, 3e-4, 40 } } do
  local tolerance, error, updates = table.unpack(case)
  local depth = ring{ tolerance = tolerance }
  local what = ("tolerance %g: "):format(tolerance)
  below(worst(depth, fine), error, what .. "error of the depths against much shorter steps")
  local _, whole = ring({ tolerance = tolerance }, { 3600 })
  below(whole.update, updates, what .. "number of updates for 3600 m")
  within(depth[5] * 1e3, 44.063, 0.0005, what .. "depth at 3600 m, rigid limit [um]")
  within(depth[3] * 1e3, 16.155, 0.0005, what .. "depth at 800 m, published [um]")
end

-- Tests the volume of a wide scar. Wear is normal to the surface, so the volume is k times the integral of p
-- over the arc times the distance. For inclined surfaces this is larger than k times load times distance.
local function over_arc(w)
  local surface, contact = w:profile "plate", w:pressure()
  local arc, j = 0, 2
  for i = 2, #contact.x - 1 do
    while j < #surface.x and surface.worn_x[j] < contact.x[i] do j = j + 1 end
    local slope = (surface.y[j] - surface.y[j - 1]) / (surface.worn_x[j] - surface.worn_x[j - 1])
    arc = arc + contact.p[i] * (contact.x[i + 1] - contact.x[i - 1]) / 2 * math.sqrt(1 + slope ^ 2)
  end
  return arc / load
end
local w = wear{ model = { radius = radius }, load = load, k_cylinder = 0, k_plate = k, slide = "z", distance = 3600e3, scheme = "implicit",
  tolerance = 1e-4 }
local total, before, at = 0, 1, 0
while w.distance < 3600e3 do
  w:step()
  local now = over_arc(w)
  total, before, at = total + (now + before) / 2 * (w.distance - at), now, w.distance
end
below(math.abs(w.volume.plate / (k * load * total) - 1), 5e-5,
  "error of the volume against k times the integral of p over the arc")

-- Tests the centre pressure at all updates of a scar wider than three half widths. The pressure is nearly
-- uniform, and the width of the contact changes from node to node.
local function centre(mesh)
  return wear{ model = { radius = radius, mesh = mesh }, load = load, k_cylinder = 0, k_plate = k, slide = "z", distance = 3600e3,
    scheme = "implicit" }:run{ progress = false }.history
end
local usual, twice, off = centre{}, centre{ fineness = 2 }, 0
for i = 2, #usual.distance do
  if usual.half_width[i] > 3 * usual.half_width[1] then
    off = math.max(off, math.abs(usual.p_center[i] / at_distance(twice, "p_center", usual.distance[i]) - 1))
  end
end
below(off, 0.016, "error of the centre pressure at any update against half the element size")

warn "@off" -- suppresses warnings about the coarse mesh
-- Tests that long steps also converge: computes the whole distance in a few steps of backward Euler.
for _, case in ipairs{ { 1, 0.002 }, { 8, 0.001 } } do
  local steps, error = table.unpack(case)
  local w = wear{ model = { radius = radius, mesh = { size = 0.05, height = 0.06, zone = { cylinder = 8, plate = 8 } } },
    load = load, k_cylinder = 0, k_plate = k, slide = "z", distance = 3600e3, scheme = "implicit", order = 1,
    geometry = "frozen", jump = 3600e3 / 0.22 / steps }
  w:run{ progress = false }
  within(w.update, steps, 0, ("%d steps: number of updates"):format(steps))
  below(math.abs(w.depth.plate / fine[5] - 1), error, ("%d steps: error of the depth"):format(steps))
end

-- Tests a worn surface that is transferred to another mesh: the pressures equal the pressures of a run on
-- that mesh, and the worn areas are unchanged.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, below, ok = figures.within, figures.below, figures.ok

local zone = { cylinder = 1.2, plate = 1.6 }
local function mesh(size)
  return { size = size, height = 1.25 * size, rows = math.floor(0.06 / size + 0.5), zone = zone }
end

local function run(case, size)
  local definition = { model = { mesh = mesh(size) }, jump = 100 * size / 0.02 }
  for key, value in pairs(case) do definition[key] = value end
  return wear(definition):run()
end

local function at(p, x)
  for i = 2, #p.x do
    if p.x[i] >= x then
      return p.p[i - 1] + (p.p[i] - p.p[i - 1]) * (x - p.x[i - 1]) / (p.x[i] - p.x[i - 1])
    end
  end
end

-- Returns the largest difference of the pressures over the inner part of the contact, relative to the
-- pressure at the centre.
local function apart(contact, w, reach)
  local largest = 0
  for _, body in ipairs{ "cylinder", "plate" } do
    local p, q = contact:pressure(body), w:pressure(body)
    for i, x in ipairs(p.x) do
      if math.abs(x) <= reach then largest = math.max(largest, math.abs(p.p[i] - at(q, x))) end
    end
  end
  return largest / w.p_center
end

-- Returns the area lost from the outline of a body [mm2], and the body's smallest depth [mm].
local function lost(w, body)
  local p, area, least, radius = w:profile(body), 0, math.huge, w.model.radius
  local function top(x) return body == "plate" and 0 or radius - math.sqrt(radius ^ 2 - x ^ 2) end
  for i = 2, #p.x do
    area = area + (p.worn_x[i] - p.worn_x[i - 1]) * (p.y[i] + p.y[i - 1]) / 2
      - (p.x[i] - p.x[i - 1]) * (top(p.x[i]) + top(p.x[i - 1])) / 2
  end
  for _, h in ipairs(p.h) do least = math.min(least, h) end
  return math.abs(area), least
end

for _, case in ipairs{ {}, { alpha = 0.25, stroke = 0.22 }, { alpha = 1 }, { alpha = 0 } } do
  local coarse = run(case, 0.02)
  local name = ("alpha = %g, stroke = %g"):format(coarse.alpha, coarse.stroke)
  local like = contact{ worn = coarse, model = model{ mesh = mesh(0.02) } }
  below(apart(like, coarse, 0.4), 1e-4, name .. ", an equal model: difference of the pressures")
  local fine = run(case, 0.01)
  local on_fine = contact{ worn = coarse, model = fine.model }
  within(on_fine.p_center, fine.p_center, 0.01, name .. ", from 20 to 10 um: centre pressure [MPa]")
  below(apart(on_fine, fine, 0.7 * fine.half_width), 0.03, name ..
    ", from 20 to 10 um: difference of the pressures in the inner 0.7")
  within(contact{ worn = coarse, model = { mesh = mesh(0.005) } }.p_center, fine.p_center, 0.01,
    name .. ", from 20 to 5 um: centre pressure [MPa]")
  within(contact{ worn = fine, model = coarse.model }.p_center, coarse.p_center, 0.02,
    name .. ", from 10 to 20 um: centre pressure [MPa]")
  for _, geometry in ipairs{ "moving", "frozen" } do
    local taken = wear{ worn = coarse, model = fine.model, geometry = geometry, k = 1e-12 }
    for _, body in ipairs{ "cylinder", "plate" } do
      local before = lost(coarse, body)
      local after, least = lost(taken, body)
      ok(math.abs(after - before) <= 1e-12 * (before + 1e-3),
        ("%s, %s: area lost by the %s %.9g, after the transfer %.9g mm2"):format(name, geometry, body,
          before, after))
      ok(least >= 0, ("%s, %s: no negative depth of the %s"):format(name, geometry, body))
    end
  end
end

-- Tests measured profiles: points of a known scar 20 um apart, between the nodes, are transferred to meshes of
-- 20 to 5 um. The reference is the scar given as a function, which is evaluated at the nodes. Linear
-- interpolation between the points would give pressures too high by 2.4, 13 and 22 %.
local depth, reach = 2e-3, 0.25
local function scar(x) return math.abs(x) < reach and depth * (1 - (x / reach) ^ 2) ^ 2 or 0 end
local function points(spacing, offset)
  local t = { x = {}, h = {} }
  for i = -25, 25 do
    t.x[#t.x + 1] = spacing * i + offset
    t.h[#t.h + 1] = scar(t.x[#t.x])
  end
  return t
end
local function area(t)
  local sum = 0
  for i = 2, #t.x do sum = sum + (t.x[i] - t.x[i - 1]) * (t.h[i] + t.h[i - 1]) / 2 end
  return sum
end
for _, size in ipairs{ 0.02, 0.01, 0.005 } do
  local m = model{ mesh = mesh(size) }
  for _, body in ipairs{ "cylinder", "plate" } do
    local what = ("%g um, a scar measured every 20 um on the %s: "):format(1000 * size, body)
    local given = points(0.02, 0.007)
    local by_function = contact{ model = m, worn = { [body] = scar } }
    local by_points = contact{ model = m, worn = { [body] = given } }
    within(by_points.p_center, by_function.p_center, 0.01, what .. "centre pressure [MPa]")
    local p, q, largest = by_points:pressure(), by_function:pressure(), 0
    for i in ipairs(p.p) do largest = math.max(largest, math.abs(p.p[i] - q.p[i])) end
    below(largest / q.p[#q.p // 2 + 1], 0.02, what .. "difference of the pressures")
    for _, geometry in ipairs{ "moving", "frozen" } do
      local t = wear{ model = m, worn = { [body] = given }, k = 1e-12, geometry = geometry }:profile(body)
      local least = math.huge
      for _, h in ipairs(t.h) do least = math.min(least, h) end
      within(area(t), area(given), 1e-12, what .. "area [mm2], " .. geometry)
      ok(least >= 0, what .. "no negative depth, " .. geometry)
    end
  end
end
local nodes = wear{ model = { mesh = mesh(0.02) } }:profile("plate")
local at_nodes = { x = nodes.x, h = {} }
for i, x in ipairs(nodes.x) do at_nodes.h[i] = scar(x) end
local put, off = wear{ model = { mesh = mesh(0.02) }, worn = { plate = at_nodes } }:profile("plate"), 0
for i, h in ipairs(put.h) do off = math.max(off, math.abs(h - at_nodes.h[i])) end
below(off / depth, 1e-15, "points at the nodes are unchanged: relative error of the depth")

-- A worn surface taken over to another mesh: the pressures are those of a run on that mesh, the areas lost are the same.
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

-- Largest difference over the inner part of the contact, as a share of the pressure at the centre.
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

-- Area that the outline of a body has lost, and its least depth.
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
  below(apart(like, coarse, 0.4), 1e-4, name .. ", a like model: pressures differ by")
  local fine = run(case, 0.01)
  local on_fine = contact{ worn = coarse, model = fine.model }
  within(on_fine.p_center, fine.p_center, 0.01, name .. ", from 20 to 10 um: centre pressure [MPa]")
  below(apart(on_fine, fine, 0.7 * fine.half_width), 0.03, name .. ", from 20 to 10 um: pressures in the inner 0.7 differ by")
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
        ("%s, %s: area lost by the %s %.9g, taken over %.9g mm2"):format(name, geometry, body, before, after))
      ok(least >= 0, ("%s, %s: no depth of the %s below zero"):format(name, geometry, body))
    end
  end
end

-- Tests stresses against the closed form for Hertz' pressure (McEwen): at the surface, also near the
-- contact's edge, and inside. At the surface they are computed from the tractions and the strain along the
-- surface. On worn surfaces the reference is a law of half-planes: the stress along the surface equals the
-- pressure. Errors are relative to the largest pressure. They include a tension along the surface, 1 % of the
-- pressure, which half-planes do not have: finite bodies carry the load to their supports by a tension of the
-- order of L / (pi R) and of p a / R.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local below, within = figures.below, figures.within

-- Returns the stresses xx, yy and xy at x and `depth` for Hertz' pressure p0 over the width 2 a.
local function mcewen(x, depth, a, p0)
  local q = a * a - x * x + depth * depth
  local root = math.sqrt(q * q + 4 * x * x * depth * depth)
  local m, n = math.sqrt(math.max(0, (root + q) / 2)), math.sqrt(math.max(0, (root - q) / 2))
  if x < 0 then n = -n end
  local both = m * m + n * n
  if both == 0 then return 0, 0, 0 end
  local share = (depth * depth + n * n) / both
  return -p0 / a * (m * (1 + share) - 2 * depth), -p0 / a * m * (1 - share),
    -p0 / a * n * (m * m - depth * depth) / both
end

local steel = { E = 200e3, nu = 0.3 }

-- Calls each(node, x, depth, exact stresses, field) for all nodes near the contact.
local function nodes_near(c, bodies, load, each)
  local h = hertz{ load = load, cylinder = bodies.cylinder, plate = bodies.plate }
  for body, field in pairs(c:stress()) do
    local up = body == "cylinder" and 1 or -1
    for n, x in ipairs(field.x) do
      local depth = up * field.y[n]
      if up == 1 then depth = depth - (10 - math.sqrt(100 - math.min(100, x * x))) end
      if math.abs(x) < 2.5 * h.half_width and depth < 2.5 * h.half_width then
        local xx, yy, xy = mcewen(x, math.max(0, depth), h.half_width, h.p_max)
        each(n, x, depth, { xx, yy, up * xy }, field, h)
      end
    end
  end
end

-- Returns the largest errors of a mesh over loads whose edges move across several nodes: at surface nodes
-- more than one and a half elements from the edge, at the other surface nodes, in the first row inside, and
-- deeper. The last error is the error of von Mises' stress at the free surface.
local function errors_of(bodies, size)
  local scale = hertz(bodies).E_star / hertz{}.E_star
  local m = model{ cylinder = bodies.cylinder, plate = bodies.plate,
    mesh = { size = size, height = 1.25 * size, far = 1, zone = { cylinder = 1, plate = 1.2 } } }
  local worst = { surface = 0, edge = 0, row = 0, inside = 0, free = 0 }
  for load = 80, 140, size < 0.008 and 30 or size < 0.015 and 5 or 2.5 do
    nodes_near(contact{ model = m, load = scale * load }, bodies, scale * load,
      function(n, x, depth, exact, field, h)
        local from_edge = (math.abs(x) - h.half_width) / size
        local place = depth > 1.5 * 1.25 * size and "inside" or depth > 1e-6 and "row"
          or math.abs(from_edge) > 1.5 and "surface" or "edge"
        for k, name in ipairs{ "sxx", "syy", "sxy" } do
          worst[place] = math.max(worst[place], math.abs(field[name][n] - exact[k]) / h.p_max)
        end
        if depth < 1e-6 and from_edge > 0.5 then
          worst.free = math.max(worst.free, field.mises[n] / h.p_max)
        end
      end)
  end
  return worst
end

local soft = { E = 1000, nu = 0.4999 }
for _, pair in ipairs{ { "steel on steel", steel, steel }, { "steel on nu = .4999", steel, soft },
  { "E = 20e3, nu = .2 on steel", { E = 20e3, nu = 0.2 }, steel } } do
  for _, size in ipairs{ 0.02, 0.01, pair[1] == "steel on steel" and 0.005 or nil } do
    local worst = errors_of({ cylinder = pair[2], plate = pair[3] }, size)
    local what = ("%s, %g um: "):format(pair[1], 1000 * size)
    below(worst.surface, 0.02, what .. "surface, at least one and a half elements from the edge, error")
    below(worst.free, 0.02, what .. "von Mises stress at the free surface, error")
    below(worst.inside, 0.02, what .. "inside, from the second row of nodes on, error")
    below(worst.row, 0.035, what .. "first row of nodes inside, error")
    below(worst.edge, 0.021,
      what .. "surface nodes next to the edge, error")
  end
end

-- Tests that errors of stresses, relative to the finest mesh, decrease with the square of the element size. Two
-- errors [MPa] are tested, root mean squares over all loads and both bodies: the error of sxx at the surface, at
-- and near the centre, and the error of the largest von Mises stress.
local models = {}
local function figures_at(size, load)
  models[size] = models[size] or model{ mesh = { size = size, height = 1.25 * size } }
  local along, mises = {}, {}
  for body, field in pairs(contact{ model = models[size], load = load }:stress()) do
    for _, n in ipairs(models[size].mesh[body]:surface()) do
      for _, x in ipairs{ 0, 0.04, 0.24 } do
        if math.abs(field.x[n] - x) < 1e-3 * x + 1e-9 then along[body .. x] = field.sxx[n] end
      end
    end
    mises[body] = math.max(table.unpack(field.mises))
  end
  return { along = along, mises = mises }
end

local function off(size, name, loads, reference)
  local sum, count = 0, 0
  for i, load in ipairs(loads) do
    for key, value in pairs(figures_at(size, load)[name]) do
      sum, count = sum + (value - reference[i][name][key]) ^ 2, count + 1
    end
  end
  return math.sqrt(sum / count)
end

local loads, reference = { 80, 92, 104, 116, 128, 140 }, {}
for i, load in ipairs(loads) do reference[i] = figures_at(0.005, load) end
for _, row in ipairs{ { "along", "stress along the surface" }, { "mises", "largest von Mises stress" } } do
  local name, what = row[1], row[2]
  local coarse, fine = off(0.02, name, loads, reference), off(0.01, name, loads, reference)
  below(coarse, 4, what .. ", 20 um: r.m.s. error [MPa]")
  below(fine, 1, what .. ", 10 um: r.m.s. error [MPa]")
  figures.above(math.log(coarse / fine, 2), 1.7, what .. ": order of convergence from 20 to 10 um")
end

-- Tests the largest von Mises stress at the nominal load, and its value on very fine meshes: the stress of
-- the half-plane plus the tension of finite bodies at the same position.
local function mises_of(xx, yy)
  local zz = 0.3 * (xx + yy)
  return math.sqrt(((xx - yy) ^ 2 + (yy - zz) ^ 2 + (zz - xx) ^ 2) / 2)
end
local exact = hertz{}
local default, fine = contact{}:stress(), contact{ model = { mesh = { size = 0.0025 } } }:stress()
for _, body in ipairs{ "cylinder", "plate" } do
  local field = fine[body]
  local most, at = 0, 1
  for n, v in ipairs(field.mises) do
    if v > most then most, at = v, n end
  end
  local xx, yy = mcewen(0, math.abs(field.y[at]), exact.half_width, exact.p_max)
  local tension = field.sxx[at] - xx
  within(mises_of(xx, yy), 0.5575 * exact.p_max, 1e-4, body .. ": largest von Mises stress in a half-plane [MPa]")
  figures.about(tension, 4.5, 1.5, body .. ": tension of the finite body at this position [MPa]")
  within(most, mises_of(xx + tension, yy), 1e-3, body .. ": largest von Mises stress, 2.5 um [MPa]")
  within(math.max(table.unpack(default[body].mises)), most, 0.01,
    body .. ": largest von Mises stress, 20 um [MPa]")
end

-- Tests worn surfaces, including kinks at the edges of scars. The stress along the surface equals the
-- pressure except for the tension of finite bodies and the effect of inclined surfaces (proportional to the
-- slopes), for any shape, mesh and material.
for _, case in ipairs{ { "steel on steel", {}, { alpha = 0.5, load = 100 } },
  { "cylinder alone", {}, { alpha = 1, load = 100 } }, { "s = 4a", {}, { alpha = 0.75, stroke = 0.44 } },
  { "steel on nu = .4999", { plate = soft }, { alpha = 0.5, load = 1.2, k = 1e-6 } } } do
  for _, size in ipairs{ 0.02, case[1] == "steel on steel" and 0.01 or nil } do
    local def = { stroke = 0.11, scheme = "explicit", distance = 660 }
    for name, value in pairs(case[3]) do def[name] = value end
    def.model = { plate = case[2].plate, mesh = { size = size, height = 1.25 * size } }
    local w = wear(def)
    w:run()
    local c = w:contact()
    local least, most = math.huge, -math.huge
    for body, field in pairs(c:stress()) do
      local p = c:pressure(body).p
      for i, n in ipairs(w.model.mesh[body]:surface()) do
        if math.abs(field.x[n]) < 3 * c.half_width then
          local rest = (field.sxx[n] + p[i]) / c.p_max
          least, most = math.min(least, rest), math.max(most, rest)
        end
      end
    end
    local what = ("worn, %s, %g um: stress along the surface + p, "):format(case[1], 1000 * size)
    figures.above(least, -0.02, what .. "smallest fraction of p_max")
    below(most, 0.065, what .. "largest fraction of p_max")
  end
end

-- Tests moving geometry whose stiffness is recomputed only occasionally (condensation of the wear box)
-- against recomputation at every update. All updates and nodes are compared.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local below = figures.below

-- Returns the pressures and depths after every update.
local function path(definition, refresh)
  local copy = {}
  for name, value in pairs(definition) do copy[name] = value end
  copy.refresh = refresh
  local w, states = wear(copy), {}
  while w.distance < definition.distance * (1 - 1e-12) do
    w:step()
    states[#states + 1] = { p_center = w.p_center, half_width = w.half_width, depth = w.depth,
      cylinder = w:pressure("cylinder"), plate = w:pressure("plate") }
  end
  return states
end

-- Returns three largest differences: of the pressures at any node, of the pressures more than 2.5 elements
-- inside the contact's edges (both relative to the centre pressure), and of the depths (relative).
local function compare(definition, size)
  local exact, found = path(definition, 0), path(definition)
  local any, inside, depth = 0, 0, 0
  for u, state in ipairs(found) do
    local other = exact[u]
    for _, body in ipairs{ "cylinder", "plate" } do
      for i, p in ipairs(state[body].p) do
        local share = math.abs(p - other[body].p[i]) / other.p_center
        any = math.max(any, share)
        if math.abs(other[body].x[i]) < other.half_width - 2.5 * size then inside = math.max(inside, share) end
      end
      if other.depth[body] > 0 then depth = math.max(depth, math.abs(state.depth[body] / other.depth[body] - 1)) end
    end
  end
  return any, inside, depth
end

local function check(what, definition, size)
  local any, inside, depth = compare(definition, size)
  below(any, 5e-4, what .. ": error of the pressure at any node, fraction of p_center")
  below(inside, 1e-4, what .. ": error of the pressure inside the contact's edges, fraction of p_center")
  -- the two runs couple the bodies at slightly different node positions, so the depths differ slightly
  -- although the worn areas are exact
  below(depth, 5e-5, what .. ": relative error of the depth")
end

local usual = model{}
for _, case in ipairs{ { 0.5, 0.11 }, { 0, 0.22 }, { 0.75, 0.44 }, { 1, 0.11 } } do
  local alpha, stroke = case[1], case[2]
  check(string.format("20 um, alpha = %g, s = %g", alpha, stroke), { model = usual, alpha = alpha, stroke = stroke,
    jump = 11 / stroke, distance = 1320 }, 0.02)
end
check("10 um", { model = { mesh = { size = 0.01, height = 0.0125 } }, jump = 50, distance = 660 }, 0.01)
check("a soft plate, worn 8 um deep",
  { model = { plate = { E = 2e3, nu = 0.4 },
    mesh = { size = 0.02, height = 0.025, far = 1, zone = { cylinder = 2.4, plate = 2.8 } } },
  load = 20, k = 1e-6, jump = 15, distance = 330, alpha = 0 }, 0.02)

-- Tests that a run stored between two recomputations of the stiffness continues with identical bits.
local w = wear{ model = usual }
w:run{ distance = 500, progress = false }
local file = os.tmpname()
os.remove(file)
w:save(file)
local restored = wear.open(file)
os.remove(file)
w:run{ progress = false }
restored:run{ progress = false }
local same = true
for _, body in ipairs{ "cylinder", "plate" } do
  local p, q = w:pressure(body).p, restored:pressure(body).p
  for i = 1, #p do same = same and p[i] == q[i] end
end
figures.ok(same and w.depth.cylinder == restored.depth.cylinder, "a restored run continues with identical bits")

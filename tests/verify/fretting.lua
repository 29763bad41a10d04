-- Tests wear with friction: McColl's fretting case in gross slip, the energy law, and partial slip against a
-- reduced law that needs no friction solver. The reduced law is dw/dN = 4 mu k p (g + w) for the sum w of
-- both wear depths over the cycles N, outside a stick zone with constant edge c. Here p is the pressure on
-- the worn surfaces, and 2 mu g is the slip in half a cycle by Cattaneo and Mindlin.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, note, ok = figures.within, figures.note, figures.ok

-- --- McColl -------------------------------------------------------------------------------------

local cycles = { 1000, 5000, 10000, 18000 }
local half_plane = { 0.3790, 1.1321, 1.8161, 2.7147 } -- depths of the flat on half-planes with friction [um]

local fretting = wear{ model = { radius = 6, mesh = { size = 0.01, height = 0.01 } }, friction = 0.9, load = 18.5,
  stroke = 0.05, increments = 40, k_cylinder = 1.9e-8, k_plate = 2.9e-8, cycles = 18000, jump = "auto" }
local start = os.clock()
for i, count in ipairs(cycles) do
  fretting:run{ cycles = count, progress = false }
  within(1e3 * fretting.depth.plate, half_plane[i], 0.005, ("McColl, %d cycles: depth of the flat [um]"):format(count))
end
ok(fretting.gross == 1 and fretting.stick_width == 0, "the case is in gross slip")
note(("%d updates, %d contact solutions, %.1f s"):format(fretting.update, fretting.solutions, os.clock() - start))

-- --- the energy law -----------------------------------------------------------------------------

local coarse = model{ mesh = { size = 0.02, height = 0.025 } }
for label, fields in pairs{ gross = { stroke = 0.05 }, partial = { tangential = 30 } } do
  for _, jump in ipairs{ 20, "auto" } do
    local w = wear{ model = coarse, friction = 0.6, k = 1e-7, law = "energy", cycles = 400, increments = 40, jump = jump,
      stroke = fields.stroke, tangential = fields.tangential }
    w:run{ progress = false }
    within(w.volume.total, 1e-7 * w.energy, 1e-9, ("V = k E, %s slip, jump %s"):format(label, jump))
  end
end

-- --- partial slip -------------------------------------------------------------------------------

local mu, load, k, last, jump = 0.6, 100, 1e-7, 10000, 100
local a = hertz{}.half_width

local function g(x, c)
  local t = math.abs(x) / c
  return t > 1 and c * c / 20 * (t * math.sqrt(t * t - 1) - math.log(t + math.sqrt(t * t - 1))) or 0
end

-- Returns a table of the sum of both wear depths, indexed by x. Each body wears by half of the sum.
local function depths(run, body)
  local depth = {}
  if not run then return depth end
  local profile = run:profile(body)
  for i, x in ipairs(profile.x) do depth[x] = 2 * profile.h[i] end
  return depth
end

-- Computes the reduced law by a run without friction. The run slides 2 mm per cycle, so its local factor is
-- half of the factor per cycle.
local function reduced(bodies, c)
  local run
  run = wear{ model = bodies, load = load, slide = "z", stroke = 1, k = k, cycles = last, jump = jump,
    local_factor = { vector = function(body, x)
      local factor, depth = {}, depths(run, body)
      for i, at in ipairs(x) do
        factor[i] = math.abs(at) > c and 4 * mu * (g(at, c) + (depth[at] or 0)) / 2 or 0
      end
      return factor
    end } }
  return run:run{ progress = false }
end

-- The slip annulus has few nodes on these meshes too, so the result is extrapolated with second order from
-- two meshes.
local c = 0.0675 -- edge of the stick zone [mm], halfway between two nodes of each mesh
local function reduced_on(nodes)
  local size = c / (nodes + 0.5)
  return reduced(model{ mesh = { size = size, height = size / 2, zone = { cylinder = 0.5, plate = 0.6 } } }, c).volume.total
end
local coarse_law, fine_law = reduced_on(13), reduced_on(26)
local expected = fine_law + (fine_law - coarse_law) / ((26.5 / 13.5) ^ 2 - 1)

for _, case in ipairs{ { 6, 1, 0.015 }, { 13, 1, 0.003 }, { 6, 0.5, 0.015 }, { 13, 0.5, 0.003 } } do
  local nodes, height, allowed = table.unpack(case)
  local size = c / (nodes + 0.5)
  local bodies = model{ mesh = { size = size, height = height * size } }
  local w = wear{ model = bodies, friction = mu, load = load, tangential = mu * load * (1 - (c / a) ^ 2), k = k,
    cycles = last, jump = jump, increments = 40 }
  w:step()
  local first = w.stick_width
  w:run{ progress = false }
  local label = ("elements of %.1f x %.1f um, %d cycles of partial slip: "):format(1e3 * size, 1e3 * height * size, last)
  within(w.volume.total, expected, allowed, label .. "volume [mm3]")
  within(first, 2 * c, 1e-3, label .. "width of the stick zone after the first step [mm]")
  within(w.stick_width, first, 1e-12, label .. "width of the stick zone at the end [mm]")
  note(("p at the centre %.2f MPa, depth of each %.4f um"):format(w.p_center, 1e3 * w.depth.plate))
end

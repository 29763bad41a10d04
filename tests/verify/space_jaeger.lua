-- Tests random closed paths of load and tangential force on a ball of nu = 0: displacements after each leg,
-- and the work of the second turn. The reference is Jaeger's superposition of slices of load, which is exact
-- for any path.
--   ARCHARD_RUNS=200 tests/run -a verify/space_jaeger   more paths

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local below, mean = figures.below, figures.mean
local slices = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/slices.lua")
local random = math.random
math.randomseed(200)
local count = tonumber(os.getenv "ARCHARD_RUNS") or 3

local E, radius, mu, most = 200e3, 10, 0.5, 20
local G, E_star = E / 2, E / 2
local function half_width(load) return (3 * load * radius / (4 * E_star)) ^ (1 / 3) end

-- --- slices -------------------------------------------------------------------------------------

-- For nu = 0 the sum of (2 - nu) / (8 G a) of both bodies is 1 / (2 G a).
local function compliance(load) return 1 / (2 * G * half_width(load)) end

-- Changes load and force in 200 equal increments. Returns the work of the force.
local function jaeger_leg(s, load, force)
  local parts, work, load0, force0 = 200, 0, s.n * s.step, s.force
  for k = 1, parts do
    local share, q, x = k / parts, s.force, s.motion
    slices.change(s, load0 + share * (load - load0), force0 + share * (force - force0))
    work = work + (s.force + q) / 2 * (s.motion - x)
  end
  return work
end

-- --- paths --------------------------------------------------------------------------------------

local function corners()
  local path = {}
  for i = 1, random(3, 5) do
    local load = most * (0.1 + 0.9 * random())
    path[i] = { load = load, force = 0.95 * mu * load * (2 * random() - 1) }
  end
  return path
end

local steel = material{ E = E, nu = 0 }
local pair = { geometry = "3-D", upper = body.ball{ radius = radius, material = steel },
  lower = body.block{ material = steel } }

local function both_ways(path)
  local s, c = slices.new(4000, most, mu, compliance), contact{ model = pair, load = path[1].load, friction = mu }
  local motions, works, energies = {}, {}, {}
  local scale = mu * most / (2 * G * half_width(most)) -- displacement under the force mu * most without slip
  jaeger_leg(s, path[1].load, 0)
  for turn = 1, 2 do
    local work, energy = 0, c.energy
    for i = 1, #path do
      local to = path[i % #path + 1]
      work = work + jaeger_leg(s, to.load, to.force)
      c = c:move{ load = to.load, tangential = to.force }
      motions[#motions + 1] = math.abs(c.x - s.motion) / scale
    end
    works[turn], energies[turn] = work, c.energy - energy
  end
  return motions, energies[2] / works[2] - 1, works[2] / (mu * most * scale)
end

-- The error of the work of a turn (once around the path) is relative to this work. Turns that dissipate less
-- than 1/500 of the work in full slip are included in the mean only, and turns below 1/5000 not at all.
local motion, worst, errors, largest, large = {}, 0, {}, 0, 0
for i = 1, count do
  local motions, error, size = both_ways(corners())
  for _, off in ipairs(motions) do
    motion[#motion + 1], worst = off, math.max(worst, off)
  end
  if size > 2e-4 then errors[#errors + 1] = math.abs(error) end
  if size > 2e-3 then large, largest = large + 1, math.max(largest, math.abs(error)) end
  figures.note(("path %d: motion off by up to %.3f %%, work by %.2f %% of %.2g"):format(i, 100 * math.max(table.unpack(motions)),
    100 * error, size))
end
below(mean(motion), 1e-4,
  ("displacements of %d legs, mean error as a fraction of the largest displacement"):format(#motion))
below(worst, 1e-3, "displacements, largest error")
below(mean(errors), 0.005, ("work of %d turns, mean error"):format(#errors))
below(largest, 0.015, ("work of %d turns with much slip, largest error"):format(large))

-- On this path the work of one and of two increments was the same by chance, and the work of the turn was 3.2 % too
-- large, although the work of each cell differed.
local path = {}
for i, corner in ipairs{ { 16.9348, -3.14919 }, { 4.91841, -2.19472 }, { 14.6812, -0.416162 }, { 16.9683, -4.07193 },
  { 10.1199, -2.46236 } } do path[i] = { load = corner[1], force = corner[2] } end
local _, error = both_ways(path)
below(math.abs(error), 0.005, "work of a turn in which the sum over the cells agrees by chance, error")

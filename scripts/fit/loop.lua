-- Friction loops as measurements of a fit. A loop is the tangential force over the displacement in one cycle,
-- given as points in the order of time. Each half of the loop is compared with the same half of the simulated
-- loop: forces at the measured positions or, if a force drives the run, positions at the measured forces.

local check = require "archard.lib.check"
local statistics = require "archard.lib.statistics"

local loop = {}

local function finite(list)
  if not check.list.test(list) then return false end
  for i = 1, #list do
    if not check.number.test(list[i]) then return false end
  end
  return true
end

loop.kind = check.kind("a loop, with lists x [mm] and tangential [N] of equal length, at least 8 points", function(v)
  return type(v) == "table" and finite(v.x) and finite(v.tangential) and #v.x == #v.tangential and #v.x >= 8
end)

-- Returns the indices of the smallest and the largest value. The motion reverses at these two points.
local function ends_of(along)
  local low, high = 1, 1
  for i, value in ipairs(along) do
    if value < along[low] then low = i end
    if value > along[high] then high = i end
  end
  return low, high
end

-- Returns a list of booleans, one for each point: true if the point belongs to the half with increasing
-- values.
local function rising(along)
  local low, high = ends_of(along)
  local up, n = {}, #along
  for i = 1, n do up[i] = (i - low) % n <= (high - low) % n end
  return up
end

local function copied(list) return table.move(list, 1, #list, 1, {}) end

-- Makes an item of data from a loop. from: the checked fields loop, distance, compliance, shift, level and
-- title; errors: list of standard errors, or nil; by_force: true if a force drives the run.
function loop.item(from, errors, by_force)
  local x, force = copied(from.loop.x), copied(from.loop.tangential)
  for i, f in ipairs(force) do x[i] = x[i] - (from.compliance or 0) * f end
  local along, value = x, force
  if by_force then along, value = force, x end
  local low, high = ends_of(along)
  local width = math.abs(x[high] - x[low])
  return { kind = "loop", distance = from.distance, x = along, value = value, error = errors, by_force = by_force,
    up = rising(along), unit = by_force and "mm" or "N", fixed = { shift = from.shift, level = from.level },
    free = { { kind = "shift", span = width / 10, unit = "mm" },
      { kind = "level", span = statistics.largest(force), unit = "N" } },
    title = from.title or ("loop at %g mm"):format(from.distance) }
end

-- --- simulated values ----------------------------------------------------------------------------

-- Returns the points of a closed loop from index `from` to index `to`, sorted by `along`. The index continues
-- at 1 after the last point.
local function half(along, value, from, to)
  local points, n = {}, #along
  for step = 0, (to - from) % n do
    local i = (from - 1 + step) % n + 1
    points[#points + 1] = { along[i], value[i] }
  end
  table.sort(points, function(a, b) return a[1] < b[1] end)
  return points
end

-- Returns the value at x by linear interpolation between the points. Beyond an end it returns the value at
-- this end.
local function at(points, x)
  local low, high = 1, #points
  if x <= points[low][1] then return points[low][2] end
  if x >= points[high][1] then return points[high][2] end
  while high - low > 1 do
    local middle = (low + high) // 2
    if points[middle][1] <= x then low = middle else high = middle end
  end
  local a, b = points[low], points[high]
  return b[1] > a[1] and a[2] + (b[2] - a[2]) * (x - a[1]) / (b[1] - a[1]) or a[2]
end

-- Returns the simulated values at the points of an item. there: the simulated loop { x=, tangential= }, whose
-- last point repeats the first one and is ignored; position: { shift=, level= }.
function loop.values(item, there, position)
  local along, value = copied(there.x), copied(there.tangential)
  if item.by_force then along, value = value, along end
  along[#along], value[#value] = nil, nil
  local low, high = ends_of(along)
  local up, down = half(along, value, low, high), half(along, value, high, low)
  local sideways = item.by_force and position.level or position.shift
  local upwards = item.by_force and position.shift or position.level
  local list = {}
  for i, x in ipairs(item.x) do list[i] = at(item.up[i] and up or down, x - sideways) + upwards end
  return list
end

-- --- implausible units -----------------------------------------------------------------------------

-- Checks that the ranges of the measured and the simulated loop differ by less than a factor of 20.
function loop.check_position(where, number, item, there)
  local along = item.by_force and there.tangential or there.x
  local a, b = ends_of(item.x)
  local c, d = ends_of(along)
  local ratio = (item.x[b] - item.x[a]) / (along[d] - along[c])
  if ratio > 20 or ratio < 0.05 then
    check.fail(where, ("field 'data[%d].loop.%s': range %.3g, the simulated range is %.3g %s: expected numbers in "
      .. "%s, or another stroke or force of the run"):format(number, item.by_force and "tangential" or "x",
      item.x[b] - item.x[a], along[d] - along[c], item.by_force and "N" or "mm",
      item.by_force and "N" or "mm"))
  end
end

return loop

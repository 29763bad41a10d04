-- Detects the wear scar in a trace, fits a line or circle (the form) to the unworn part, and computes weights
-- for the scar's area.

local form = require "archard.profile.form"
local noise = require "archard.profile.noise"

local scar = {}

local ends = 0.15   -- fraction of the trace at each end that is assumed to be unworn at first
scar.margin = 0.2   -- width of each margin, where material may pile up, as a fraction of the scar's width
local least = 0.05  -- fraction of the trace at each end that is always treated as unworn
local clear = 5     -- smallest depth of a scar, in multiples of the scatter
local blocks = 500  -- largest number of groups of points in the search for a scar

-- Divides the points into at most `blocks` groups of neighbours. Returns the mean x and the mean z of each
-- group.
local function blocked(x, z)
  local size = math.max(1, math.ceil(#x / blocks))
  local bx, bz = {}, {}
  for first = 1, #x - size + 1, size do
    local sx, sz = 0, 0
    for i = first, first + size - 1 do sx, sz = sx + x[i], sz + z[i] end
    bx[#bx + 1], bz[#bz + 1] = sx / size, sz / size
  end
  return bx, bz
end

local function outside(from, to)
  return function(x) return x < from or x > to end
end

-- Returns a function is_used(x) that is true in the unworn part, which is the trace outside the scar and its
-- margins. The ends of the trace always belong to the unworn part.
local function beside(x, from, to)
  local side, end_part = scar.margin * (to - from), least * (x[#x] - x[1])
  return outside(math.min(from, math.max(from - side, x[1] + end_part)),
    math.max(to, math.min(to + side, x[#x] - end_part)))
end

-- Returns the positions of both ends of the scar, or nil if the deepest point is not below the threshold.
-- On each side of the deepest point, the end is the first point that is not below the form.
local function reach(x, depth, threshold)
  local deepest = 1
  for i = 2, #x do if depth[i] > depth[deepest] then deepest = i end end
  if not (depth[deepest] > threshold) then return nil end
  local first, last = deepest, deepest
  while first > 1 and depth[first] > 0 do first = first - 1 end
  while last < #x and depth[last] > 0 do last = last + 1 end
  return x[first], x[last]
end

local function depths_below(found, x, z)
  local depth = {}
  for i = 1, #x do
    local height = found:height(x[i])
    if not height then return nil end
    depth[i] = height - z[i]
  end
  return depth
end

-- Detects the scar of a trace. Returns the form of the unworn part (nil if the points do not determine it),
-- both ends of the scar (nil if no scar is detected), and is_used(x), a function that is true in the unworn
-- part.
function scar.find(x, z, kind)
  local bx, bz = blocked(x, z)
  local whole = x[#x] - x[1]
  local is_used = outside(x[1] + ends * whole, x[#x] - ends * whole)
  local from, to, found
  for _ = 1, 12 do
    found = form.fit(kind, bx, bz, is_used)
    local depth = found and depths_below(found, bx, bz)
    if not depth then return nil end
    local flanks = {}
    for i = 1, #bx do if is_used(bx[i]) then flanks[#flanks + 1] = depth[i] end end
    local new_from, new_to = reach(bx, depth, math.max(clear * noise.robust(flanks), 1e-12 * whole))
    if new_from == from and new_to == to then break end
    from, to = new_from, new_to
    if not from then break end
    is_used = beside(x, from, to)
  end
  return form.fit(kind, x, z, from and is_used), from, to, from and is_used
end

-- Fits the form beside a scar whose ends are known. Returns the same values as scar.find.
function scar.fit(x, z, kind, from, to)
  local is_used = beside(x, from, to)
  return form.fit(kind, x, z, is_used), from, to, is_used
end

-- Returns the standard deviation [mm] and the correlation length [mm] of the depths of the unworn part, below a
-- form with `parameters` parameters, and the number of its points.
function scar.scatter(x, depth, is_used, parameters)
  local list, sum = {}, 0
  for i = 1, #x do
    if not is_used or is_used(x[i]) then
      list[#list + 1] = depth[i]
      sum = sum + depth[i] ^ 2
    end
  end
  return math.sqrt(sum / math.max(1, #list - parameters)), noise.length(list) * (x[#x] - x[1]) / (#x - 1), #list
end

-- Returns the weight of each point in an integral over x: the length [mm] of the point's cell between `from`
-- and `to`.
function scar.weights(x, from, to)
  local weights = {}
  for i = 1, #x do
    local low = i > 1 and (x[i - 1] + x[i]) / 2 or x[1]
    local high = i < #x and (x[i] + x[i + 1]) / 2 or x[i]
    weights[i] = math.max(0, math.min(high, to) - math.max(low, from))
  end
  return weights
end

return scar

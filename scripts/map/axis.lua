-- Coordinates of a map along one axis: makes and checks even steps, locates a value between two points, and
-- computes weights for resampling.

local axis = {}

-- Returns the mean step of the points.
function axis.step(list) return (list[#list] - list[1]) / (#list - 1) end

-- Returns the index of the first point that is more than a twentieth of a step from its evenly spaced
-- position, or nil if there is none.
function axis.uneven(list)
  local step = axis.step(list)
  for i = 2, #list do
    if not (list[i] > list[i - 1]) or math.abs(list[i] - list[1] - (i - 1) * step) > 0.05 * step then return i end
  end
end

-- Returns a list of `count` points with even steps, beginning at `first`.
function axis.even(first, step, count)
  local list = {}
  for i = 1, count do list[i] = first + (i - 1) * step end
  return list
end

-- Returns the index of the point before a value, and the distance between this point and the value as a
-- fraction of the step. Returns nil if the value is outside the points. A value that is beyond an end by
-- less than 1e-6 of a step (the error of single precision) is treated as the end.
function axis.locate(list, value)
  local n, step = #list, axis.step(list)
  local beyond = 1e-6 * step
  if not (value >= list[1] - beyond and value <= list[n] + beyond) then return nil end
  local i = math.max(1, math.min(n - 1, math.floor((value - list[1]) / step) + 1))
  while i > 1 and list[i] > value do i = i - 1 end
  while i < n - 1 and list[i + 1] < value do i = i + 1 end
  return i, math.max(0, math.min(1, (value - list[i]) / (list[i + 1] - list[i])))
end

-- Returns the indices of the first and the last point in a range { from, to }, or nil if the range contains
-- no point. Either end of the range may be nil.
function axis.within(list, range)
  local low, high = range[1] or -math.huge, range[2] or math.huge
  local beyond, first, last = 1e-6 * axis.step(list), nil, nil
  for i = 1, #list do
    if list[i] >= low - beyond and list[i] <= high + beyond then first, last = first or i, i end
  end
  return first, last
end

local function linear(list, value)
  local i, share = axis.locate(list, value)
  return { first = i, 1 - share, share }
end

-- Returns the weights for the mean over a cell of width `size` about a value. The weight of a point is the
-- overlap of its own cell with this cell, divided by the sum of all overlaps.
local function mean(list, value, size)
  local step, total = axis.step(list), 0
  local low, high = value - size / 2, value + size / 2
  local first = math.max(1, math.floor((low - list[1]) / step + 0.5) + 1)
  local last = math.min(#list, math.ceil((high - list[1]) / step - 0.5) + 1)
  local weights = { first = first }
  for i = first, last do
    local cell = list[1] + (i - 1) * step
    local share = math.max(0, math.min(high, cell + step / 2) - math.max(low, cell - step / 2))
    weights[i - first + 1], total = share, total + share
  end
  for k = 1, #weights do weights[k] = weights[k] / total end
  return weights
end

-- Returns points with the step `size`, centred in the range of the old points, and for each of them the
-- weights of the old points. If the new step is smaller, the weights interpolate linearly; else they
-- compute means over cells of the new size.
function axis.resampled(list, size)
  local whole = list[#list] - list[1]
  local count = math.floor(whole / size + 1e-9) + 1
  local points = axis.even((list[1] + list[#list] - (count - 1) * size) / 2, size, count)
  local weights = {}
  for i = 1, count do
    weights[i] = size > axis.step(list) * (1 + 1e-9) and mean(list, points[i], size) or linear(list, points[i])
  end
  return points, weights
end

return axis

-- Averages measured traces: over cells of equal length, which reduces points and noise, and over several
-- traces.

local average = {}

-- Averages the points of a trace over cells of width `step`. Returns three lists: position, mean height and
-- number of points of each cell. If a cell has no points, returns nil and the position of this cell.
function average.cells(x, z, step)
  local count = math.max(1, math.floor((x[#x] - x[1]) / step + 1e-9))
  local first = (x[1] + x[#x] - (count - 1) * step) / 2
  local cx, cz, counts = {}, {}, {}
  for i = 1, count do cx[i], cz[i], counts[i] = first + (i - 1) * step, 0, 0 end
  for i = 1, #x do
    local cell = math.floor((x[i] - first) / step + 0.5) + 1
    if cell == count + 1 and x[i] - cx[count] <= step * (0.5 + 1e-9) then cell = count end
    if counts[cell] then cz[cell], counts[cell] = cz[cell] + z[i], counts[cell] + 1 end
  end
  for i = 1, count do
    if counts[i] == 0 then return nil, cx[i] end
    cz[i] = cz[i] / counts[i]
  end
  return cx, cz, counts
end

-- Returns the heights at the increasing positions `at` by linear interpolation. All positions must be in the
-- range of x.
function average.at(x, z, at)
  local result, i = {}, 1
  for k = 1, #at do
    while i < #x - 1 and x[i + 1] < at[k] do i = i + 1 end
    local share = (at[k] - x[i]) / (x[i + 1] - x[i])
    result[k] = z[i] + share * (z[i + 1] - z[i])
  end
  return result
end

-- Returns the weighted mean of several traces with equal positions, and its standard error, which is computed
-- from the differences between the traces. lists: heights of each trace; errors: standard error of each
-- trace, which sets its weight.
function average.traces(lists, errors)
  local weights, total = {}, 0
  for t, e in ipairs(errors) do
    weights[t] = e > 0 and 1 / e ^ 2 or 1
    total = total + weights[t]
  end
  local mean, spread = {}, 0
  for i = 1, #lists[1] do
    local sum = 0
    for t = 1, #lists do sum = sum + weights[t] * lists[t][i] end
    mean[i] = sum / total
    for t = 1, #lists do spread = spread + weights[t] * (lists[t][i] - mean[i]) ^ 2 end
  end
  return mean, math.sqrt(spread / total / (#lists - 1) / #lists[1])
end

return average

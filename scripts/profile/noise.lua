-- Estimates the standard deviation and the correlation length of the noise of a trace.

local noise = {}

local function median(list)
  table.sort(list)
  local middle = #list // 2
  return #list % 2 == 1 and list[middle + 1] or (list[middle] + list[middle + 1]) / 2
end

-- Returns a robust standard deviation of a list of numbers, computed from the median absolute deviation.
-- Outliers have little effect. The list is overwritten.
function noise.robust(list)
  local middle = median(list)
  for i = 1, #list do list[i] = math.abs(list[i] - middle) end
  return 1.482602218505602 * median(list)
end

-- Returns the standard deviation of white noise in a trace. It is computed from the median distance of a
-- point from the line between its two neighbours, which is insensitive to the curvature of the surface. In a
-- long trace only about 20000 points are used, which suffices for an accuracy of 1 %.
function noise.estimate(x, z)
  local offs, stride = {}, math.max(1, (#x - 2) // 20000)
  for i = 2, #x - 1, stride do
    local share = (x[i] - x[i - 1]) / (x[i + 1] - x[i - 1])
    local off = z[i] - z[i - 1] - share * (z[i + 1] - z[i - 1])
    offs[#offs + 1] = off / math.sqrt(1 + share ^ 2 + (1 - share) ^ 2)
  end
  return #offs > 0 and noise.robust(offs) or 0
end

local function covariance(list, lag, mean)
  local sum = 0
  for i = 1, #list - lag do sum = sum + (list[i] - mean) * (list[i + lag] - mean) end
  return sum / (#list - lag)
end

-- Returns the integral of the autocorrelation as a number of points (1 for independent points). The sum ends
-- where the correlation is no longer significant. Each lag is longer than the previous one by about a
-- quarter, which limits the computing time for long traces.
function noise.length(list)
  local mean = 0
  for i = 1, #list do mean = mean + list[i] / #list end
  local all = covariance(list, 0, mean)
  if all <= 0 then return 1 end
  local sum, before, at, lag = 0, 1, 0, 1
  while lag <= #list // 4 do
    local now = covariance(list, lag, mean) / all
    if now < 2 / math.sqrt(#list) then break end
    sum = sum + (lag - at) * (before + now) / 2
    before, at, lag = now, lag, math.max(lag + 1, lag * 5 // 4)
  end
  return math.max(1, 2 * sum)
end

return noise

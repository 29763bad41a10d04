-- Computes wear coefficients from measured volumes (Eqs. 1, 11, 12), for a whole test or as tables over the
-- distance from volumes measured at several distances. Each test has one pair of volumes.

local statistics = require "archard.lib.statistics"

local volumes = {}

local names = { "k", "k_cylinder", "k_plate", "alpha" }

local function map(list, f)
  local result = {}
  for i, value in ipairs(list) do result[i] = f(value, i) end
  return result
end

-- --- one interval of distance ----------------------------------------------------------------------

-- Returns the standard deviation of each quantity over the tests. The deviation of alpha is a first-order estimate.
local function deviations(cylinder, plate, c, p, work)
  local total = c + p
  local function of(f)
    return statistics.deviation(map(cylinder, function(value, i) return f(value, plate[i]) end))
  end
  return {
    k = of(function(a, b) return (a + b) / work end),
    k_cylinder = of(function(a) return a / work end),
    k_plate = of(function(_, b) return b / work end),
    alpha = total > 0 and of(function(a, b) return (p * a - c * b) / total ^ 2 end) or nil,
  }
end

-- Returns the standard deviations for a single test whose volumes have the known error `err` [mm3].
local function known_deviations(c, p, work, err)
  local total = c + p
  return { k = math.sqrt(2) * err / work, k_cylinder = err / work, k_plate = err / work,
    alpha = total > 0 and math.sqrt(c * c + p * p) * err / total ^ 2 or nil }
end

-- Computes k and alpha of an interval of distance. cylinder, plate: volumes [mm3] lost in the interval, one
-- per test; work: load times distance [N mm]. Returns { mean=, spread=, low=, high= }, each a table of the
-- quantities. low and high are the confidence range of the mean; they are empty for a single test without
-- `err`.
function volumes.stretch(cylinder, plate, work, confidence, err)
  local c, p = statistics.mean(cylinder), statistics.mean(plate)
  local result = { mean = { k = (c + p) / work, k_cylinder = c / work, k_plate = p / work,
    alpha = c + p > 0 and c / (c + p) or nil }, low = {}, high = {} }
  local count, freedom = #cylinder, #cylinder - 1
  result.spread = deviations(cylinder, plate, c, p, work)
  if count == 1 and err then
    result.spread, freedom = known_deviations(c, p, work, err), statistics.known
  end
  for name, spread in pairs(result.spread) do
    local margin = statistics.student(confidence, freedom) * spread / math.sqrt(count)
    result.low[name] = math.max(0, result.mean[name] - margin)
    result.high[name] = math.min(name == "alpha" and 1 or math.huge, result.mean[name] + margin)
  end
  return result
end

-- --- tables over the distance ----------------------------------------------------------------------

-- Returns the start and the end of each interval: 0, then each measured distance twice, the last one once.
local function points(distance)
  local list = {}
  for i, d in ipairs(distance) do
    list[2 * i - 1], list[2 * i] = distance[i - 1] or 0, d
  end
  return list
end

-- Returns the mean of the quantity `name` at the start and end of each interval. In an interval without wear
-- the value of the previous interval is used.
local function steps(mean, name)
  local list = {}
  for i, each in ipairs(mean) do
    local value = each[name] or list[2 * i - 2] or 0
    list[2 * i - 1], list[2 * i] = value, value
  end
  return list
end

-- Returns the results for each interval between the distances. cylinder[test][i] and plate[test][i] are the
-- volumes at distance i [mm3].
local function stretches(distance, cylinder, plate, given)
  local list = {}
  for i, d in ipairs(distance) do
    local function lost(test) return test[i] - (test[i - 1] or 0) end
    local from = distance[i - 1] or 0
    -- the volume at the start is exactly 0
    local err = given.error and given.error * (i > 1 and math.sqrt(2) or 1)
    list[i] = volumes.stretch(map(cylinder, lost), map(plate, lost), given.load * (d - from),
      given.confidence, err)
  end
  return list
end

-- Computes k and alpha over the distance. given: load, confidence, error. Returns two tables by quantity. The
-- first contains tables { distance=, value= }, constant in each interval: wear{} with these k and alpha
-- reproduces the measured volumes. The second contains the bands { distance=, value=, low=, high= } of the
-- means at the middle of each interval.
function volumes.course(distance, cylinder, plate, given)
  local list, at = stretches(distance, cylinder, plate, given), points(distance)
  local mean = map(list, function(stretch) return stretch.mean end)
  local tables, bands = {}, {}
  for _, name in ipairs(names) do
    tables[name] = { distance = at, value = steps(mean, name) }
    local band = { distance = {}, value = {}, low = {}, high = {} }
    for i, stretch in ipairs(list) do
      band.distance[i] = (at[2 * i - 1] + at[2 * i]) / 2
      band.value[i] = stretch.mean[name] or 0 / 0
      band.low[i], band.high[i] = stretch.low[name], stretch.high[name]
    end
    bands[name] = band
  end
  return tables, bands
end

return volumes

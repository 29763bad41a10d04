-- Computes wear coefficients from measured volumes (Eqs. 1, 11, 12): for a whole test or, if volumes were
-- measured at several distances, as tables over the distance. Each test has one volume of each body.

local statistics = require "archard.lib.statistics"

local volumes = {}

local names = { "k", "k_cylinder", "k_plate", "alpha" }

local function map(list, f)
  local result = {}
  for i, value in ipairs(list) do result[i] = f(value, i) end
  return result
end

-- --- one interval of distance ----------------------------------------------------------------------

-- Returns the standard deviation of each quantity over the tests. For alpha it is a first-order estimate.
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

-- Returns the standard deviations for a single test whose volumes have the known standard error `err` [mm3].
local function known_deviations(c, p, work, err)
  local total = c + p
  return { k = math.sqrt(2) * err / work, k_cylinder = err / work, k_plate = err / work,
    alpha = total > 0 and math.sqrt(c * c + p * p) * err / total ^ 2 or nil }
end

-- Computes k and alpha for an interval of the distance. cylinder, plate: volumes [mm3] lost in the
-- interval, one for each test; work: load times distance [N mm]. Returns { mean=, spread=, low=, high= },
-- each a table by quantity. The tables low and high have the confidence limits of the mean; for a single
-- test without `err` they are empty.
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

-- Returns the start and end distances of all intervals in one list: 0, d1, d1, d2, d2, ..., with d1, d2, ...
-- the measured distances.
local function points(distance)
  local list = {}
  for i, d in ipairs(distance) do
    list[2 * i - 1], list[2 * i] = distance[i - 1] or 0, d
  end
  return list
end

-- Returns the mean of the quantity `name` twice for each interval, for its start and its end. An interval
-- without wear has the value of the previous interval.
local function steps(mean, name)
  local list = {}
  for i, each in ipairs(mean) do
    local value = each[name] or list[2 * i - 2] or 0
    list[2 * i - 1], list[2 * i] = value, value
  end
  return list
end

-- Returns the results of each interval between the distances. cylinder[test][i], plate[test][i]: volume [mm3]
-- lost up to distance i.
local function stretches(distance, cylinder, plate, given)
  local list = {}
  for i, d in ipairs(distance) do
    local function lost(test) return test[i] - (test[i - 1] or 0) end
    local from = distance[i - 1] or 0
    -- the volume at the start is exactly 0, so only later intervals have errors at both ends
    local err = given.error and given.error * (i > 1 and math.sqrt(2) or 1)
    list[i] = volumes.stretch(map(cylinder, lost), map(plate, lost), given.load * (d - from),
      given.confidence, err)
  end
  return list
end

-- Computes k and alpha over the distance. given: load, confidence, error. Returns two tables by quantity. The
-- first contains tables { distance=, value= } with constant values in each interval, which reproduce the
-- measured volumes if used as k and alpha in wear{}. The second contains the confidence bands { distance=,
-- value=, low=, high= } at the middle of each interval.
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

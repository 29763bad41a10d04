-- Wear coefficients from measured volumes (Eqs. 1, 11, 12): over a whole test, or as tables over the
-- distance from volumes on the way. The volumes of both bodies come in pairs, one pair a test.

local statistics = require "archard.lib.statistics"

local volumes = {}

local names = { "k", "k_cylinder", "k_plate", "alpha" }

local function map(list, f)
  local result = {}
  for i, value in ipairs(list) do result[i] = f(value, i) end
  return result
end

-- --- one stretch of sliding ------------------------------------------------------------------------

-- What each pair is off the mean, in each quantity; alpha to first order.
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

-- The same of a single test whose readings are known to err by so much [mm3].
local function known_deviations(c, p, work, err)
  local total = c + p
  return { k = math.sqrt(2) * err / work, k_cylinder = err / work, k_plate = err / work,
    alpha = total > 0 and math.sqrt(c * c + p * p) * err / total ^ 2 or nil }
end

-- From the volumes lost over a stretch in each test to { mean=, spread=, low=, high= } of the
-- quantities; low and high bound the mean with a confidence, nil for a single test without `err`.
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
    local room = statistics.student(confidence, freedom) * spread / math.sqrt(count)
    result.low[name] = math.max(0, result.mean[name] - room)
    result.high[name] = math.min(name == "alpha" and 1 or math.huge, result.mean[name] + room)
  end
  return result
end

-- --- tables over the distance ----------------------------------------------------------------------

-- Between two stretches: the slope that Fritsch and Butland give a monotonic curve there, here that
-- of the volume.
local function between(a, b, length_a, length_b)
  if a <= 0 or b <= 0 then return 0 end
  local wa, wb = length_a + 2 * length_b, 2 * length_a + length_b
  return (wa + wb) / (wa / a + wb / b)
end

-- Values at both ends and in the middle of every stretch: continuous, nowhere below 0, linear in
-- between, and with the mean of each stretch kept exactly.
local function ends_and_middles(mean, length)
  local list, n = {}, #mean
  for i = 2, n do
    local a, b = mean[i - 1], mean[i]
    list[2 * i - 1] = math.min(between(a, b, length[i - 1], length[i]), 2 * a, 2 * b)
  end
  local function outer(i, inner) -- on a line through the stretch's mean
    return math.max(0, math.min(2 * mean[i], 2 * mean[i] - (list[inner] or mean[i])))
  end
  list[1], list[2 * n + 1] = outer(1, 3), outer(n, 2 * n - 1)
  for i = 1, n do list[2 * i] = 2 * mean[i] - (list[2 * i - 1] + list[2 * i + 1]) / 2 end
  return list
end

-- alpha at the same points, so that the integral of k alpha over each stretch is that of k_cylinder
-- (k and alpha linear between points): at the ends the share of both, in the middle what is left.
local function shares(k, k_cylinder, mean)
  local list = {}
  for i = 1, #k, 2 do
    local around = mean[(i + 1) // 2] or mean[#mean]
    list[i] = k[i] > 0 and k_cylinder[i] / k[i] or around.alpha or 0
  end
  for i = 2, #k, 2 do
    local a, b, here = k[i - 1], k[i + 1], mean[i // 2]
    local left = 12 * here.k_cylinder - list[i - 1] * (2 * a + k[i]) - list[i + 1] * (2 * b + k[i])
    local weight = a + b + 4 * k[i]
    list[i] = weight > 0 and left / weight or here.alpha or 0
    list[i] = math.max(0, math.min(1, list[i]))
  end
  return list
end

-- 0, and the measured distances, with the middles between.
local function points(distance)
  local list = { 0 }
  for _, d in ipairs(distance) do
    local before = list[#list]
    list[#list + 1], list[#list + 2] = (before + d) / 2, d
  end
  return list
end

-- The stretches between distances; volumes are lists by test of lists by distance.
local function stretches(distance, cylinder, plate, given)
  local list = {}
  for i, d in ipairs(distance) do
    local function lost(test) return test[i] - (test[i - 1] or 0) end
    local from = distance[i - 1] or 0
    -- the volume at the start is 0 without any reading
    local err = given.error and given.error * (i > 1 and math.sqrt(2) or 1)
    list[i] = volumes.stretch(map(cylinder, lost), map(plate, lost), given.load * (d - from),
      given.confidence, err)
  end
  return list
end

-- given: load, confidence, error. The volumes that wear{} takes with k and alpha, or each body with
-- its own k, are those measured. Returns the tables { distance=, value= } by name, and the bands
-- { distance=, value=, low=, high= }, of the means of the stretches at their middles.
function volumes.course(distance, cylinder, plate, given)
  local list, at = stretches(distance, cylinder, plate, given), points(distance)
  local mean = map(list, function(stretch) return stretch.mean end)
  local length = map(distance, function(d, i) return d - (distance[i - 1] or 0) end)
  local tables, bands = {}, {}
  for _, name in ipairs{ "k_cylinder", "k_plate" } do
    tables[name] = ends_and_middles(map(mean, function(m) return m[name] end), length)
  end
  tables.k = map(tables.k_cylinder, function(value, i) return value + tables.k_plate[i] end)
  tables.alpha = shares(tables.k, tables.k_cylinder, mean)
  for _, name in ipairs(names) do
    tables[name] = { distance = at, value = tables[name] }
    local band = { distance = {}, value = {}, low = {}, high = {} }
    for i, stretch in ipairs(list) do
      band.distance[i], band.value[i] = at[2 * i], stretch.mean[name] or 0 / 0
      band.low[i], band.high[i] = stretch.low[name], stretch.high[name]
    end
    bands[name] = band
  end
  return tables, bands
end

return volumes

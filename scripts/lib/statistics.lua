-- Statistics of a few measurements: mean, largest absolute value, standard deviation, and Student's
-- distribution.

local random = require "archard.random"

local statistics = {}

function statistics.mean(list)
  local sum = 0
  for _, value in ipairs(list) do sum = sum + value end
  return sum / #list
end

-- Returns the largest absolute value of a list.
function statistics.largest(list)
  local most = 0
  for _, value in ipairs(list) do most = math.max(most, math.abs(value)) end
  return most
end

-- Returns the standard deviation of the sample, or nil for a single measurement.
function statistics.deviation(list)
  if #list < 2 then return nil end
  local middle, sum = statistics.mean(list), 0
  for _, value in ipairs(list) do sum = sum + (value - middle) ^ 2 end
  return math.sqrt(sum / (#list - 1))
end

statistics.known = 10000 -- degrees of freedom for a known standard deviation (normal distribution)

-- Returns the two-sided quantile of Student's distribution. confidence: level in (0, 1); freedom: degrees of
-- freedom.
function statistics.student(confidence, freedom)
  return random.student_quantile((1 + confidence) / 2, freedom)
end

return statistics

-- Means, sizes, spreads and confidence of a few measurements.
local statistics = {}

function statistics.mean(list)
  local sum = 0
  for _, value in ipairs(list) do sum = sum + value end
  return sum / #list
end

-- The largest of their sizes, whatever their signs.
function statistics.largest(list)
  local most = 0
  for _, value in ipairs(list) do most = math.max(most, math.abs(value)) end
  return most
end

-- Standard deviation of the sample; nil for one measurement.
function statistics.deviation(list)
  if #list < 2 then return nil end
  local middle, sum = statistics.mean(list), 0
  for _, value in ipairs(list) do sum = sum + (value - middle) ^ 2 end
  return math.sqrt(sum / (#list - 1))
end

-- Student's distribution: the probability to be within +-t at a number of degrees of freedom, with t
-- as the angle whose tangent is t / sqrt(freedom) (a finite series).
local function within(angle, freedom)
  local c, s, term, sum = math.cos(angle), math.sin(angle), 1, 0
  local odd = freedom % 2
  for i = 1, (freedom - odd) // 2 do
    sum = sum + term
    term = term * c * c * (2 * i - 1 + odd) / (2 * i + odd)
  end
  if odd == 0 then return s * sum end
  return 2 / math.pi * (angle + s * c * sum)
end

statistics.known = 10000 -- degrees of freedom that stand for a known deviation: the normal curve

-- How many standard deviations of the mean are within a confidence.
function statistics.student(confidence, freedom)
  local low, high = 0, math.pi / 2
  for _ = 1, 60 do
    local middle = (low + high) / 2
    if within(middle, freedom) < confidence then low = middle else high = middle end
  end
  return math.tan(low) * math.sqrt(freedom)
end

return statistics

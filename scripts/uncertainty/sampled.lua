-- Statistics of samples: moments, quantiles and shares with what their number lets one say of them.
-- Leans on archard.random.

local random = require "archard.random"
local statistics = require "archard.lib.statistics"

local sampled = {}

function sampled.sorted(list)
  local copy = table.move(list, 1, #list, 1, {})
  table.sort(copy)
  return copy
end

-- The value below which a share of the sorted samples lies, linear between two.
function sampled.quantile(sorted, share)
  local at = 1 + share * (#sorted - 1)
  local low = math.floor(at)
  local high = math.min(low + 1, #sorted)
  return sorted[low] + (at - low) * (sorted[high] - sorted[low])
end

-- How many standard deviations on both sides hold a confidence.
function sampled.reach(confidence) return random.normal_quantile((1 + confidence) / 2) end

-- The samples between which the true quantile lies with a confidence, by how many of n fall below it.
function sampled.quantile_range(sorted, share, reach)
  local n = #sorted
  local room = reach * math.sqrt(n * share * (1 - share))
  local low, high = math.floor(n * share - room), math.ceil(n * share + room) + 1
  return sorted[math.max(low, 1)], sorted[math.min(high, n)]
end

-- Mean and standard deviation, and half the range that holds the mean.
function sampled.moments(list, reach)
  local mean, deviation = statistics.mean(list), statistics.deviation(list)
  return mean, deviation, reach * deviation / math.sqrt(#list)
end

-- The range of a share that was seen in `count` of n samples (Clopper and Pearson).
function sampled.share_range(count, n, confidence)
  local out = (1 - confidence) / 2
  local low = count > 0 and random.beta_quantile(out, count, n - count + 1) or 0
  local high = count < n and random.beta_quantile(1 - out, count + 1, n - count) or 1
  return low, high
end

-- Spearman's correlation of ranks; nil where one of both does not vary.
function sampled.rank_correlation(a, b)
  local value = random.rank_correlation(a, b)
  return value == value and value or nil
end

return sampled

-- Computes statistics of samples: moments, quantiles and probabilities, with their confidence intervals.

local random = require "archard.random"
local statistics = require "archard.lib.statistics"

local sampled = {}

function sampled.sorted(list)
  local copy = table.move(list, 1, #list, 1, {})
  table.sort(copy)
  return copy
end

-- Returns a quantile of sorted samples by linear interpolation between two samples.
function sampled.quantile(sorted, share)
  local at = 1 + share * (#sorted - 1)
  local low = math.floor(at)
  local high = math.min(low + 1, #sorted)
  return sorted[low] + (at - low) * (sorted[high] - sorted[low])
end

-- Returns half the width of a two-sided confidence interval, in standard deviations of a normal distribution.
function sampled.reach(confidence) return random.normal_quantile((1 + confidence) / 2) end

-- Returns the confidence interval of a quantile as two samples, whose ranks follow from the binomial
-- distribution. share: probability of the quantile; reach: see sampled.reach.
function sampled.quantile_range(sorted, share, reach)
  local n = #sorted
  local margin = reach * math.sqrt(n * share * (1 - share))
  local low, high = math.floor(n * share - margin), math.ceil(n * share + margin) + 1
  return sorted[math.max(low, 1)], sorted[math.min(high, n)]
end

-- Returns the mean, the standard deviation, and half the width of the confidence interval of the mean.
function sampled.moments(list, reach)
  local mean, deviation = statistics.mean(list), statistics.deviation(list)
  return mean, deviation, reach * deviation / math.sqrt(#list)
end

-- Returns the confidence interval (Clopper and Pearson) of the probability of an event that occurred in
-- `count` of n samples.
function sampled.share_range(count, n, confidence)
  local out = (1 - confidence) / 2
  local low = count > 0 and random.beta_quantile(out, count, n - count + 1) or 0
  local high = count < n and random.beta_quantile(1 - out, count + 1, n - count) or 1
  return low, high
end

-- Returns Spearman's rank correlation of two lists, or nil if a list is constant.
function sampled.rank_correlation(a, b)
  local value = random.rank_correlation(a, b)
  return value == value and value or nil
end

return sampled

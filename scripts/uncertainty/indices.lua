-- Sobol's indices from a design of Saltelli: what share of a result's variance each field causes by
-- itself (first order), and with all that it takes part in (total order, by Jansen 1999). For the first
-- order there are two estimates, one good for fields that matter little (Saltelli et al. 2010), one for
-- those that matter most (Janon et al. 2014): the one with the smaller error is taken. Errors are those
-- of ratios of means (delta method), as if the points were random: even points do better. Leans on
-- nothing.

local indices = {}

-- mean(g) / mean(v) and its standard error from the n pairs.
local function ratio(g, v)
  local n, sum_g, sum_v = #g, 0, 0
  for i = 1, n do sum_g, sum_v = sum_g + g[i], sum_v + v[i] end
  local value, middle, square = sum_g / sum_v, sum_v / n, 0
  for i = 1, n do square = square + ((g[i] - value * v[i]) / middle) ^ 2 end
  return { value = value, error = math.sqrt(square / (n - 1) / n) }
end

local function middle_of(a, b)
  local sum = 0
  for i = 1, #a do sum = sum + a[i] + b[i] end
  return sum / (2 * #a)
end

-- by(a, b, mean, product) -> the ratio of mean products to the variance of both lists.
local function by(a, b, mean, product)
  local g, v = {}, {}
  for i = 1, #a do
    local da, db = a[i] - mean, b[i] - mean
    g[i], v[i] = product(da, db, i), (da * da + db * db) / 2
  end
  return ratio(g, v)
end

-- The second and the mixed sets share nothing but the field: their covariance is its own part.
local function first_of(a, b, mixed, mean)
  local little = by(a, b, mean, function(_, db, i) return db * (mixed[i] - a[i]) end)
  local most = by(b, mixed, middle_of(b, mixed), function(db, dm) return db * dm end)
  return most.error < little.error and most or little
end

-- of(a, b, mixed): results of the first sets, the second ones, and the first with one field out of the
-- second. Returns { value=, error= } of first and total order; nil where the result does not vary.
function indices.of(a, b, mixed)
  local mean, varies = middle_of(a, b), false
  for i = 1, #a do varies = varies or a[i] ~= a[1] or b[i] ~= a[1] end
  if not varies then return nil end
  return first_of(a, b, mixed, mean), by(a, b, mean, function(_, _, i) return (a[i] - mixed[i]) ^ 2 / 2 end)
end

return indices

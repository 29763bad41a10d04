-- Computes Sobol indices from Saltelli's design: the shares of a result's variance that a field causes alone
-- (first order) and together with its interactions (total order, Jansen 1999). The first order has two
-- estimates: one is accurate for small indices (Saltelli et al. 2010), the other for large indices (Janon et
-- al. 2014). The estimate with the smaller error is used. Each estimate is a ratio of two means. Its error is
-- the standard error for random points (delta method), an upper bound for evenly distributed points.

local indices = {}

-- Returns the ratio of the means of the lists g and v, and its standard error.
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

-- Returns the mean of product(da, db, i) divided by the variance of both lists, and the error of this ratio.
-- da, db: deviations of a[i] and b[i] from `mean`.
local function by(a, b, mean, product)
  local g, v = {}, {}
  for i = 1, #a do
    local da, db = a[i] - mean, b[i] - mean
    g[i], v[i] = product(da, db, i), (da * da + db * db) / 2
  end
  return ratio(g, v)
end

-- Returns the first-order index of a field. The second set and the mixed set have only this field in common,
-- so their covariance is the contribution of the field.
local function first_of(a, b, mixed, mean)
  local little = by(a, b, mean, function(_, db, i) return db * (mixed[i] - a[i]) end)
  local most = by(b, mixed, middle_of(b, mixed), function(db, dm) return db * dm end)
  return most.error < little.error and most or little
end

-- Returns the indices of first and of total order, each as { value=, error= }, or nil if the result is
-- constant. a, b: results of the first and the second sets; mixed: results of the first sets with one field
-- from the second sets.
function indices.of(a, b, mixed)
  local mean, varies = middle_of(a, b), false
  for i = 1, #a do varies = varies or a[i] ~= a[1] or b[i] ~= a[1] end
  if not varies then return nil end
  return first_of(a, b, mixed, mean), by(a, b, mean, function(_, _, i) return (a[i] - mixed[i]) ^ 2 / 2 end)
end

return indices

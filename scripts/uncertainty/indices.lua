-- Sobol's indices from a design of Saltelli: what share of a result's variance each field causes by
-- itself (first order), and with all that it takes part in (total order). First order by Saltelli et
-- al. (2010), total by Jansen (1999). Their errors are those of ratios of means (delta method), as if
-- the points were random: even points do better. Leans on nothing.

local indices = {}

-- mean(g) / mean(v) and its standard error from the n pairs.
local function ratio(g, v)
  local n, sum_g, sum_v = #g, 0, 0
  for i = 1, n do sum_g, sum_v = sum_g + g[i], sum_v + v[i] end
  local value, middle, square = sum_g / sum_v, sum_v / n, 0
  for i = 1, n do square = square + ((g[i] - value * v[i]) / middle) ^ 2 end
  return value, math.sqrt(square / (n - 1) / n)
end

local function middle_of(a, b)
  local sum = 0
  for i = 1, #a do sum = sum + a[i] + b[i] end
  return sum / (2 * #a)
end

-- of(a, b, mixed): results of the first sets, the second ones, and those with one field exchanged.
-- Returns { value=, error= } of first and total order; nil where the result does not vary.
function indices.of(a, b, mixed)
  local mean, first, total, variance = middle_of(a, b), {}, {}, {}
  local spread = 0
  for i = 1, #a do
    local da, db, dm = a[i] - mean, b[i] - mean, mixed[i] - mean
    first[i] = db * (dm - da)
    total[i] = (da - dm) ^ 2 / 2
    variance[i] = (da * da + db * db) / 2
    spread = spread + variance[i]
  end
  if spread == 0 then return nil end
  local s, s_error = ratio(first, variance)
  local t, t_error = ratio(total, variance)
  return { value = s, error = s_error }, { value = t, error = t_error }
end

return indices

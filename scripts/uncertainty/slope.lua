-- Computes the slope of a result with respect to a number of the definition, by a least-squares fit to runs
-- with many values of the number. Half widths and pressures change in small steps when the contact edge moves
-- from node to node, so a local derivative would depend on the mesh. The slope over a range of several nodes
-- does not.

local least_squares = require "archard.least_squares"
local statistics = require "archard.lib.statistics"

-- Returns the powers 0 to `degree` of all points in one flat list, point by point.
local function powers(points, degree)
  local flat = {}
  for _, t in ipairs(points) do
    for power = 0, degree do flat[#flat + 1] = t ^ power end
  end
  return flat
end

-- Fits a polynomial to values. Returns its slope at 0, the standard error of the slope, the scatter of the
-- values, and the polynomial at 0.
local function polynomial(points, values, degree)
  local n, sum, slope, variance, middle = degree + 1, 0, 0, 0, 0
  local u, s, v = least_squares.svd{ a = powers(points, degree), rows = #points, columns = n }
  local left = table.move(values, 1, #values, 1, {})
  for k = 1, n do
    local along = 0
    for p, value in ipairs(values) do along = along + u[(p - 1) * n + k] * value end
    for p = 1, #values do left[p] = left[p] - u[(p - 1) * n + k] * along end
    middle, slope = middle + v[k] * along / s[k], slope + v[n + k] * along / s[k]
    variance = variance + (v[n + k] / s[k]) ^ 2
  end
  for _, off in ipairs(left) do sum = sum + off * off end
  local scatter = math.sqrt(sum / (#points - n))
  return slope, scatter * math.sqrt(variance), scatter, middle
end

-- The standard error is multiplied by this factor, because deviations of neighbouring runs are correlated.
local doubt = 2

local rounding = 1e-10 -- a relative scatter below this limit is rounding error

-- Returns { value =, error =, middle =, scatter =, ripple = }: value and error of the slope, fitted result
-- in the middle (at the point 0), scatter of the results about the fit, and ripple: the scatter of the
-- slopes between neighbouring points, divided by the slope. points: evenly spaced numbers from -1 to 1, or
-- on one side of 0 only; values: result at each point.
return function(points, values)
  local even, even_error, _, middle = polynomial(points, values, 2)
  local cubic, cubic_error, scatter = polynomial(points, values, 3)
  local value, err = even, even_error
  if cubic_error < even_error then value, err = cubic, cubic_error end
  local between = scatter * math.sqrt(2) / math.abs(points[2] - points[1])
  local smooth = scatter <= rounding * statistics.largest(values)
  return { value = value, error = doubt * err, middle = middle, scatter = scatter,
    ripple = smooth and 0 or between / math.abs(value) }
end

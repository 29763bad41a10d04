-- The slope of a result through many values by least squares. Half widths and pressures jump a little
-- as the contact's edge goes from node to node: the derivative at one place is then the mesh's, and
-- only a line through runs over several nodes tells how the result answers. Leans on
-- lib/statistics.lua.

local statistics = require "archard.lib.statistics"

-- Solves a small symmetric system in place for several right sides, columns n + 1 and on.
local function eliminate(rows)
  local n = #rows
  for i = 1, n do
    for r = 1, n do
      local factor = r ~= i and rows[r][i] / rows[i][i] or 0
      for c = i, factor ~= 0 and #rows[r] or 0 do rows[r][c] = rows[r][c] - factor * rows[i][c] end
    end
  end
  return rows
end

local function normal_equations(points, values, degree)
  local rows = {}
  for i = 1, degree + 1 do
    rows[i] = {}
    for j = 1, degree + 3 do rows[i][j] = j == degree + 3 and i == 2 and 1 or 0 end
  end
  for p, t in ipairs(points) do
    for i = 1, degree + 1 do
      for j = 1, degree + 1 do rows[i][j] = rows[i][j] + t ^ (i + j - 2) end
      rows[i][degree + 2] = rows[i][degree + 2] + values[p] * t ^ (i - 1)
    end
  end
  return rows
end

-- The polynomial of a degree: its slope at 0, the standard error of that, the scatter about it, and its
-- value at 0.
local function polynomial(points, values, degree)
  local rows = eliminate(normal_equations(points, values, degree))
  local sum = 0
  for p, t in ipairs(points) do
    local off = values[p]
    for i = 1, degree + 1 do off = off - rows[i][degree + 2] / rows[i][i] * t ^ (i - 1) end
    sum = sum + off * off
  end
  local scatter = math.sqrt(sum / (#points - degree - 1))
  return rows[2][degree + 2] / rows[2][2], scatter * math.sqrt(rows[2][degree + 3] / rows[2][2]), scatter,
    rows[1][degree + 2] / rows[1][1]
end

-- Neighbouring runs miss the line to the same side, so that the error is more than they say.
local doubt = 2

local rounding = 1e-10 -- of a result: less than this is no scatter

-- slope(points, values): values at evenly spaced points, of which some lie on either side of 0 or all on
-- one, in units of their range. Returns { value =, error =, middle = the result at 0, scatter = of a
-- result, ripple = scatter of the slope between neighbours, over the slope }.
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

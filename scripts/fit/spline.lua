-- Interpolates values at knots by a monotone cubic curve (Fritsch and Butland). The curve is returned as a
-- table for wear{}, with closely spaced points between which wear{} interpolates linearly.

local spline = {}

local pieces = 8 -- number of points per knot interval

-- Returns the slope of the curve at an inner knot: the weighted harmonic mean of the chord slopes a and b on
-- both sides, or 0 at an extremum.
local function inner(a, b, length_a, length_b)
  if a * b <= 0 then return 0 end
  local wa, wb = length_a + 2 * length_b, 2 * length_a + length_b
  return (wa + wb) / (wa / a + wb / b)
end

-- Returns the slope of the curve at an end knot: the slope of the parabola through three knots, limited such
-- that the curve stays monotone.
local function outer(first, second, length, next_length)
  local slope = ((2 * length + next_length) * first - length * second) / (length + next_length)
  if slope * first <= 0 then return 0 end
  if first * second <= 0 and math.abs(slope) > 3 * math.abs(first) then return 3 * first end
  return slope
end

local function slopes(knots, value)
  local n, length, rise, list = #knots, {}, {}, {}
  for i = 1, n - 1 do
    length[i] = knots[i + 1] - knots[i]
    rise[i] = (value[i + 1] - value[i]) / length[i]
  end
  if n == 2 then return { rise[1], rise[1] } end
  for i = 2, n - 1 do list[i] = inner(rise[i - 1], rise[i], length[i - 1], length[i]) end
  list[1] = outer(rise[1], rise[2], length[1], length[2])
  list[n] = outer(rise[n - 1], rise[n - 2], length[n - 1], length[n - 2])
  return list
end

-- Returns the value of a cubic Hermite polynomial at the relative position t (0 to 1) in an interval.
local function at(t, length, from, to, slope, next_slope)
  local s = 1 - t
  return from * s * s * (1 + 2 * t) + to * t * t * (1 + 2 * s)
    + length * t * s * (slope * s - next_slope * t)
end

-- Returns the curve through the knots as { distance=, value= }. knots: distances of the knots [mm]; value:
-- values at the knots.
function spline.series(knots, value)
  local slope, series = slopes(knots, value), { distance = { knots[1] }, value = { value[1] } }
  for i = 1, #knots - 1 do
    local length = knots[i + 1] - knots[i]
    for j = 1, pieces do
      local n = #series.distance + 1
      series.distance[n] = j < pieces and knots[i] + length * j / pieces or knots[i + 1]
      series.value[n] = j < pieces
        and at(j / pieces, length, value[i], value[i + 1], slope[i], slope[i + 1]) or value[i + 1]
    end
  end
  return series
end

return spline

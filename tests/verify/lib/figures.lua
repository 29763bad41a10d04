-- Functions that check values against references and print the computed values as TAP lines.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/../lua/lib/tap.lua")

local figures = { note = tap.note, ok = tap.ok }

-- Checks |got - expected| <= share |expected|.
function figures.within(got, expected, share, what)
  local off = got / expected - 1
  return tap.ok(math.abs(off) <= share, ("%s: %.6g, expected %.6g (%+.3f %%, allowed %g %%)")
    :format(what, got, expected, 100 * off, 100 * share))
end

-- Checks |got - expected| <= tolerance, for references with few digits.
function figures.about(got, expected, tolerance, what)
  return tap.ok(math.abs(got - expected) <= tolerance,
    ("%s: %.5g, expected %.5g within %g"):format(what, got, expected, tolerance))
end

function figures.below(got, limit, what)
  return tap.ok(got < limit, ("%s: %.3g, allowed %g"):format(what, got, limit))
end

function figures.above(got, limit, what)
  return tap.ok(got > limit, ("%s: %.4g, at least %g"):format(what, got, limit))
end

function figures.mean(values, first)
  local sum = 0
  for i = first or 1, #values do sum = sum + values[i] end
  return sum / (#values - (first or 1) + 1)
end

-- Returns the mean of the four cells of a joint's map nearest to the direction of the load.
function figures.in_the_middle(map)
  local n = #map.theta
  local function at(i, k) return map.values[(i - 1) * 2 * n + k] end
  return (at(n // 2, n) + at(n // 2 + 1, n) + at(n // 2, n + 1) + at(n // 2 + 1, n + 1)) / 4
end

-- Returns the largest |v[i] - v[mirror of i]|, relative to the largest value.
function figures.asymmetry(values)
  local largest, apart = 0, 0
  for i, v in ipairs(values) do
    largest = math.max(largest, math.abs(v))
    apart = math.max(apart, math.abs(v - values[#values + 1 - i]))
  end
  return largest > 0 and apart / largest or 0
end

return figures

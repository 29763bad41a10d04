-- Checks of figures against reference values: TAP lines that name the figure found.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/../lua/lib/tap.lua")

local figures = { note = tap.note, ok = tap.ok }

-- |got - expected| <= share |expected|
function figures.within(got, expected, share, what)
  local off = got / expected - 1
  return tap.ok(math.abs(off) <= share, ("%s: %.6g, expected %.6g (%+.3f %%, allowed %g %%)")
    :format(what, got, expected, 100 * off, 100 * share))
end

-- |got - expected| <= room, for figures given to some digits
function figures.about(got, expected, room, what)
  return tap.ok(math.abs(got - expected) <= room,
    ("%s: %.5g, expected %.5g within %g"):format(what, got, expected, room))
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

-- largest |v[i] - v[mirror]| as a share of the largest value
function figures.asymmetry(values)
  local largest, apart = 0, 0
  for i, v in ipairs(values) do
    largest = math.max(largest, math.abs(v))
    apart = math.max(apart, math.abs(v - values[#values + 1 - i]))
  end
  return largest > 0 and apart / largest or 0
end

return figures

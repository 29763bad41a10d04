-- Sweeps of an input: results must vary smoothly, and an input that differs by rounding must give the same
-- result. A step is the part of a result's change between two points that exceeds the changes before and
-- after. The variable ARCHARD_POINTS sets the number of points of each sweep (default 24).
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local wanted = tonumber(os.getenv("ARCHARD_POINTS"))

-- Returns the largest step of a list, relative to its largest value.
local function largest_step(list)
  local largest, step = 0, 0
  for _, v in ipairs(list) do largest = math.max(largest, math.abs(v)) end
  for i = 2, #list - 2 do
    local before, here, after = list[i] - list[i - 1], list[i + 1] - list[i], list[i + 2] - list[i + 1]
    step = math.max(step, math.min(math.abs(here - before), math.abs(here - after), math.abs(here - (before + after) / 2)))
  end
  return step / largest
end

figures.about(largest_step{ 1, 2, 3, 4.5, 5.5, 6.5 }, 0.5 / 6.5, 1e-12,
  "a step is distinguished from a slope")

-- Returns the function sweep(name, from, to, results, solve), where solve(x) returns the results by name.
-- `most` is the largest allowed step of a result, `noise` the largest allowed relative change by rounding of
-- the input, `usual` the number of points without ARCHARD_POINTS.
return function(most, noise, usual)
  local points = wanted or usual or 24
  return function(name, from, to, results, solve)
    local found = {}
    for i = 0, points - 1 do
      local r = solve(from + (to - from) * i / (points - 1))
      for _, of in ipairs(results) do
        found[of] = found[of] or {}
        table.insert(found[of], r[of])
      end
    end
    for _, of in ipairs(results) do figures.below(largest_step(found[of]), most,
      ("sweep of %s: largest step of %s"):format(name, of)) end
    local x = from + 0.37 * (to - from)
    local a, b, off = solve(x), solve(x * (1 + 1e-15)), 0
    for _, of in ipairs(results) do off = math.max(off, math.abs(b[of] / a[of] - 1)) end
    figures.below(off, noise, ("sweep of %s: change of the results by rounding of the input"):format(name))
  end
end

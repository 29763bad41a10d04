-- Computes derivatives of a function with many results by central differences with decreasing steps. Each
-- difference is extrapolated with the difference of the next smaller step (Richardson). Larger steps average
-- over kinks of the function, and smaller steps are dominated by noise. Therefore, for each result, the
-- extrapolated value that differs least from its neighbours is used.

local levels, shrink = 8, 5

-- Returns the Richardson extrapolation of two differences whose errors are of second order in the step.
local function extrapolated(wide, narrow)
  return (shrink * shrink * narrow - wide) / (shrink * shrink - 1)
end

-- Returns { value=, error= }: the item of the list that differs least from its neighbours, and this
-- difference.
local function flattest(list)
  local best = { value = list[1], error = math.huge }
  for i = 2, #list - 1 do
    local off = math.max(math.abs(list[i] - list[i - 1]), math.abs(list[i] - list[i + 1]))
    if off < best.error then best.value, best.error = list[i], off end
  end
  return best
end

-- Computes the derivatives of all results. differences(h): function that returns a list of (f(x + h) - f(x -
-- h)) / (2 h), one for each result; step: largest h. Returns a list of { value=, error= }.
return function(differences, step)
  local lists, before = {}, differences(step)
  for m = 1, #before do lists[m] = {} end
  for level = 2, levels do
    local narrow = differences(step / shrink ^ (level - 1))
    for m, value in ipairs(narrow) do lists[m][level - 1] = extrapolated(before[m], value) end
    before = narrow
  end
  local found = {}
  for m, list in ipairs(lists) do found[m] = flattest(list) end
  return found
end

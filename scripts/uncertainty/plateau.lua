-- Derivatives of a function with many results, by central differences over ever smaller steps. Each
-- difference is extrapolated with the next smaller one (Richardson); of what that gives, every result
-- keeps the value that both neighbours confirm best: larger steps average over kinks of the function,
-- smaller ones drown in its noise. Leans on nothing.

local levels, shrink = 8, 5

-- The square of the step taken out of two differences.
local function extrapolated(wide, narrow)
  return (shrink * shrink * narrow - wide) / (shrink * shrink - 1)
end

-- The value on the flattest place of the list, and how far its neighbours are off.
local function flattest(list)
  local best = { value = list[1], error = math.huge }
  for i = 2, #list - 1 do
    local off = math.max(math.abs(list[i] - list[i - 1]), math.abs(list[i] - list[i + 1]))
    if off < best.error then best.value, best.error = list[i], off end
  end
  return best
end

-- derive(differences, step): differences(h) -> list of (f(x + h) - f(x - h)) / (2 h). Returns a list
-- of { value=, error= }; step is the widest.
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

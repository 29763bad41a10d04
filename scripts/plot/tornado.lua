-- plot.tornado: draws the influence of each input on a result as a bar, sorted by length. The influence is
-- the Sobol index or the rank correlation from a sampled study, or the relative sensitivity (percent per
-- percent) from w:sensitivity.

local check = require "archard.lib.check"
local draw = require "archard.plot.draw"
local naming = require "archard.plot.naming"

local where = "plot.tornado"

-- --- values of the bars --------------------------------------------------------------------------

-- Each function of_...() returns the axis label and a list of bars { name=, value=, whole= }, one for each
-- input. `whole` (optional) is the length of a second bar of the same input.
local function of_sensitivity(object, of, at)
  local bars = {}
  for i, name in ipairs(object.to) do bars[i] = { name = name, value = object[of][name].elasticity[at] } end
  return "elasticity (% per %)", bars
end

local function of_indices(object, of, at)
  local bars = {}
  for i, name in ipairs(object.fields) do
    bars[i] = { name = name, value = object[of].first[name].value[at], whole = object[of].total[name].value[at] }
  end
  return "share of the variance", bars
end

local function of_ranks(object, of)
  local bars = {}
  for i, name in ipairs(object.fields) do bars[i] = { name = name, value = object[of].rank[name] or 0 } end
  return "rank correlation", bars
end

local function reader_of(object)
  if naming.get(object, "to") then return of_sensitivity end
  if naming.get(object, "fields") then return naming.get(object, "indices") and of_indices or of_ranks end
  check.fail(where, "expected a sampled study, its uncertainty or a sensitivity, got " .. check.shown(object))
end

-- --- drawing them --------------------------------------------------------------------------------

local function length_of(bar) return math.abs(bar.whole or bar.value) end

-- Adds filled bars at the heights 1, 2, ... in the order of `bars`. Each bar extends from `below` to `above`,
-- measured from its height. Only the first bar has the title, since the key needs it once.
local function add_bars(curves, bars, field, below, above, series, title)
  for i, bar in ipairs(bars) do
    local to = bar[field]
    curves[#curves + 1] = { x = { 0, to, to, 0, 0 }, y = { i + below, i + below, i + above, i + above, i + below },
      style = "filled", series = series, title = i == 1 and title or nil }
  end
end

-- Returns the curves of all bars. The two bars of an input are drawn one above the other, because overlapping
-- bars would show a third colour.
local function curves_of(bars)
  local curves = {}
  if bars[1].whole then
    add_bars(curves, bars, "whole", 0.02, 0.36, 1, "total index")
    add_bars(curves, bars, "value", -0.36, -0.02, 2, "first-order index")
  else
    add_bars(curves, bars, "value", -0.35, 0.35, 1)
  end
  return curves
end

local function places_of(bars)
  local at, words = {}, {}
  for i, bar in ipairs(bars) do at[i], words[i] = i, naming.word_of(bar.name) end
  return { at = at, words = words }
end

-- Returns the index of the distance nearest to `at` [mm], or the last index without `at`.
local function index_of(distance, at)
  local best = #distance
  for i, d in ipairs(at and distance or {}) do
    if math.abs(d - at) < math.abs(distance[best] - at) then best = i end
  end
  return best
end

local function name_in(object, of)
  of = of or object.of[1]
  for _, name in ipairs(object.of) do
    if name == of then return of end
  end
  check.fail(where, ("field 'of': no quantity '%s'%s"):format(of, check.hint(of, object.of)))
end

-- plot.tornado(study or uncertainty or sensitivity, { of=, at=, ... }) draws the bars for the result `of` at
-- the distance `at` [mm].
return function(object, options)
  options = draw.options(where, options, { of = check.text, at = check.positive })
  if naming.get(object, "uncertainty") then
    object = check.as(where, object.uncertainty, object, { of = options.of or "depth_cylinder" })
  end
  local read = reader_of(object)
  local of, index = name_in(object, options.of), index_of(object.distance, options.at)
  local label, bars = read(object, of, index)
  table.sort(bars, function(a, b)
    if length_of(a) ~= length_of(b) then return length_of(a) < length_of(b) end
    return a.name > b.name
  end)
  local given = curves_of(bars)
  given.xlabel, given.yplaces, given.yrange = label, places_of(bars), { 0.5, #bars + 0.5 }
  given.title = ("%s at %g mm"):format(naming.word_of(of), object.distance[index])
  draw.draw(where, draw.over(given, options))
end

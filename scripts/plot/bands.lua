-- plot.bands: draws results of a sampled study over the sliding distance, as bands between quantiles and a
-- line for the median or the mean.

local check = require "archard.lib.check"
local curves = require "archard.plot.curves"
local draw = require "archard.plot.draw"
local naming = require "archard.plot.naming"
local shapes = require "archard.plot.shapes"

local where = "plot.bands"

-- Returns the panel of a quantity: one band for each pair of quantiles, the outermost pair first, and a line
-- for the middle quantile. Without a middle quantile the line is the mean.
local function panel_of(uncertainty, name)
  local result = uncertainty[name]
  local quantiles, distance = result.quantiles, uncertainty.distance
  local label, factor = curves.quantity_of(name)
  local panel = { xlabel = "distance / mm", ylabel = label, title = naming.word_of(name) }
  for i = 1, #quantiles // 2 do
    local low, high = quantiles[i], quantiles[#quantiles + 1 - i]
    panel[i] = shapes.area(distance, low.value, high.value, factor)
    panel[i].title = ("%g to %g %%"):format(100 * low.share, 100 * high.share)
  end
  local middle = #quantiles % 2 == 1 and quantiles[#quantiles // 2 + 1]
  panel[#panel + 1] = { x = distance, y = shapes.scaled(middle and middle.value or result.mean, factor), series = 2,
    title = middle and ("%g %%"):format(100 * middle.share) or "mean" }
  return panel
end

-- plot.bands(study or uncertainty, { of=, ... }) draws one panel for each result in `of`.
return function(object, options)
  options = draw.options(where, options, { of = check.any "a name or a list of names" })
  local uncertainty = object
  if naming.get(object, "uncertainty") then
    uncertainty = check.as(where, object.uncertainty, object, { of = options.of })
  elseif not (naming.get(object, "distance") and naming.get(object, "fields")) then
    check.fail(where, "expected a sampled study or its uncertainty, got " .. check.shown(object))
  end
  local names = options.of or uncertainty.of
  names = type(names) == "table" and names or { names }
  local panels = {}
  for i, name in ipairs(names) do
    if not naming.get(uncertainty, name) then
      check.fail(where, ("field 'of': the uncertainty has no quantity '%s'%s"):format(tostring(name),
        check.hint(tostring(name), uncertainty.of)))
    end
    panels[i] = panel_of(uncertainty, name)
  end
  local title = ("%s, %d samples"):format(uncertainty.name, uncertainty.n)
  local given = #panels == 1 and panels[1] or { panels = panels, title = title }
  if #panels == 1 then given.title = title end
  draw.draw(where, draw.over(given, options))
end

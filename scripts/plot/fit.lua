-- plot.fit: draws a fit with its data (error bars, the model with its confidence band, residuals), or the
-- expected errors of a test design.

local check = require "archard.lib.check"
local curves = require "archard.plot.curves"
local draw = require "archard.plot.draw"
local keys = require "archard.lib.keys"
local naming = require "archard.plot.naming"
local shapes = require "archard.plot.shapes"

local where = "plot.fit"

-- --- a fit ---------------------------------------------------------------------------------------

local scaled = shapes.scaled

local function band_of(fit, x, low, high)
  local area = shapes.area(x, low, high, 1)
  area.title = ("%g %% band"):format(100 * fit.confidence)
  return area
end

-- Returns true if the band is wider than the line of the model, with a line width of a 100th of the vertical range.
local function is_visible(low, high, range)
  local widest = 0
  for i = 1, #low do widest = math.max(widest, high[i] - low[i]) end
  return widest > (range[2] - range[1]) / 30
end

-- Returns the label of the vertical axis and the factor from the unit of the data to the unit of the label.
local function label_of(item)
  if item.kind == "loop" then
    if item.unit == "N" then return "tangential force / N", 1 end
    return "motion / µm", 1e3
  end
  if item.x then return "wear depth / µm", 1e3 end
  local label, factor = curves.quantity_of(item.of)
  if label then return label, factor end
  return item.unit ~= "" and item.of .. " / " .. item.unit or item.of, 1
end

-- Returns the range of all values in the lists, with a margin of 8 % at each end.
local function range_of(...)
  local low, high = math.huge, -math.huge
  for _, list in ipairs{ ... } do
    for _, value in ipairs(list) do low, high = math.min(low, value), math.max(high, value) end
  end
  local margin = high > low and 0.08 * (high - low) or math.max(0.1 * math.abs(high), 1e-12)
  return { low - margin, high + margin }
end

local function ends_of(item, sign)
  local list = {}
  for i, value in ipairs(item.value) do list[i] = value + sign * item.error[i] end
  return list
end

-- Returns the horizontal values of a data set and the label of their axis.
local function across(item)
  if item.kind == "sphere" then return item.x, "angle from the load / degree" end
  if item.kind ~= "loop" then return item.x or item.distance, item.x and (item.along or "x") .. " / mm" or naming.axis_of("distance") end
  if item.unit == "N" then return scaled(item.x, 1e3), "motion / µm" end
  return item.x, "tangential force / N"
end

-- Returns the panel of a friction loop. The confidence band is not drawn, because it would overlap itself and
-- is not wider than the line.
local function loop_panel(item)
  local label, factor = label_of(item)
  local x, name = across(item)
  local function round(list) return { list[#list], table.unpack(list) } end
  return {
    { x = round(x), y = scaled(round(item.model), factor), series = 1, title = "model", style = "lines" },
    { x = x, y = scaled(item.value, factor), error = scaled(item.error, factor), style = "points",
      colour = "black", title = "data" },
    title = item.brief or naming.word_of(item.title), ylabel = label, xlabel = name, xrange = range_of(x),
  }
end

-- Returns the curve of the model: the history of the run with the identified values, or the values at the data
-- points if the history does not contain the quantity.
local function model_of(item, run, x)
  local fine, history = pcall(function() return { distance = run.history.distance, value = run.history[item.of] } end)
  if item.kind ~= "series" or #x == 1 or not fine or not history.value then return x, item.model end
  return history.distance, history.value
end

local few = 40 -- with more data points than this, the model is drawn over the data

local function main_panel(item, fit)
  if item.kind == "loop" then return loop_panel(item) end
  local label, factor = label_of(item)
  local x, name = across(item)
  local model_x, model_y = model_of(item, fit.wear, x)
  local model = { x = model_x, y = scaled(model_y, factor), series = 1, title = "model",
    style = #x == 1 and "points" or "lines" }
  local data = { x = x, y = scaled(item.value, factor), error = scaled(item.error, factor), style = "points",
    colour = #x > few and "#808080" or "black", series = 1, title = "data" }
  local first, second = model, data
  if #x > few then first, second = data, model end
  local low, high = scaled(item.low, factor), scaled(item.high, factor)
  local range = range_of(low, high, scaled(ends_of(item, -1), factor), scaled(ends_of(item, 1), factor))
  local panel = {
    first, second,
    title = item.brief or naming.word_of(item.title), ylabel = label, xlabel = name,
    ydown = item.x and true or nil, xrange = range_of(x), yrange = range,
  }
  if is_visible(low, high, range) then table.insert(panel, 1, band_of(fit, x, low, high)) end
  return panel
end

local function residual_panel(item)
  local x, name = across(item)
  local range, most = range_of(x), 3
  for _, value in ipairs(item.residual) do most = math.max(most, 1.1 * math.abs(value)) end
  return { { x = range, y = { 0, 0 }, colour = "grey" },
    { x = x, y = item.residual, style = "points", colour = "black", series = 1 },
    xrange = range, yrange = { -most, most },
    ylabel = "residual in standard errors", xlabel = name }
end

local function curve_panel(fit, name, curve)
  return { band_of(fit, curve.distance, curve.low, curve.high),
    { x = curve.distance, y = curve.value, series = 1, title = "fit", style = "lines" },
    title = naming.word_of(name) .. " over the distance", xlabel = naming.axis_of("distance"), ylabel = naming.axis_of(name) }
end

-- Gives all panels with the same vertical label the same vertical range.
local function share_ranges(panels)
  local all = {}
  for _, panel in ipairs(panels) do
    local range, own = all[panel.ylabel], panel.yrange
    if own then all[panel.ylabel] = range and { math.min(range[1], own[1]), math.max(range[2], own[2]) } or own end
  end
  for _, panel in ipairs(panels) do panel.yrange = panel.yrange and all[panel.ylabel] end
end

-- Returns the data sets to draw. If any data set has several values, data sets with a single value are
-- omitted, because print(f) shows them.
local function drawn(list)
  local chosen = {}
  for _, item in ipairs(list) do if #item.value > 1 then chosen[#chosen + 1] = item end end
  return #chosen > 0 and chosen or list
end

-- Returns a figure with one column of panels for each data set: data above, residuals below. A single data
-- set has its residuals beside it.
local function of_fit(fit)
  local above, below, figure = {}, {}, { panels = {} }
  for _, item in ipairs(drawn(fit.data)) do
    above[#above + 1], below[#below + 1] = main_panel(item, fit), residual_panel(item)
  end
  share_ranges(above)
  share_ranges(below)
  for _, panel in ipairs(above) do figure.panels[#figure.panels + 1] = panel end
  for _, panel in ipairs(below) do figure.panels[#figure.panels + 1] = panel end
  figure.layout = #above == 1 and { 1, 2 } or { 2, #above }
  return figure
end

local function of_curves(fit)
  local figure, names = { panels = {} }, keys(fit.band)
  if #names == 0 then check.fail(where, "curves=true: this fit has no unknown with knots") end
  for i, name in ipairs(names) do figure.panels[i] = curve_panel(fit, name, fit.band[name]) end
  return figure
end

-- --- a design ------------------------------------------------------------------------------------

-- Returns one panel for each unknown, with its expected standard error over the distance. The error is in
-- percent of the start value or, if the start value is 0, of the prior error.
local function of_design(design)
  local figure = { panels = {} }
  for i, name in ipairs(design.names) do
    local scale = design.start[name] ~= 0 and math.abs(design.start[name]) or design.prior_error[name]
    local panel, by = { title = "error of " .. naming.word_of(name), xlabel = naming.axis_of("distance"),
      ylabel = "standard error / %", logy = true }, {}
    for _, one in ipairs(design.alone) do
      local curve = by[one.measure]
      if not curve then
        curve = { x = {}, y = {}, style = "linespoints", title = one.title }
        by[one.measure], panel[#panel + 1] = curve, curve
      end
      curve.x[#curve.x + 1], curve.y[#curve.y + 1] = one.distance, 100 * one.error[name] / scale
    end
    figure.panels[i] = panel
  end
  return figure
end

-- --- the picture ---------------------------------------------------------------------------------

local own = { curves = check.flag }

-- plot.fit(f, { curves=true }) draws the result f of fit{}, plot.fit(d) the result d of fit.design{}.
return function(given, options)
  local class = type(given) == "table" and (getmetatable(given) or {}).__name
  if class ~= "fitted" and class ~= "design" then
    check.fail(where, "expected a result of fit{} or fit.design{}, got " .. check.shown(given))
  end
  options = draw.options(where, options, own)
  local figure = class == "design" and of_design(given) or (options.curves and of_curves or of_fit)(given)
  draw.draw(where, draw.over(figure, options))
end

-- Converts lengths on the axes of a picture to a suitable unit, for example distances to m or km and depths
-- to nm, and divides very large and small numbers by a power of ten. The conversion copies the figure, because
-- points may later be added to the original in its own units.

local merged = require "archard.lib.merged"

local units = {}

-- `lengths`: quantities whose unit may be changed. `known`: units, each with the number of units per mm and
-- the length [mm] below which the unit is used.
local lengths = { distance = true, ["wear depth"] = true, ["sum of wear depths"] = true, slip = true }
local known = { { "nm", 1e6, 1e-4 }, { "µm", 1e3, 1 }, { "mm", 1, 1e4 }, { "m", 1e-3, 1e7 }, { "km", 1e-6, math.huge } }

local function in_mm(unit)
  for _, each in ipairs(known) do
    if each[1] == unit then return 1 / each[2] end
  end
end

-- Returns the quantity on an axis, and the length of the axis unit [mm]. Returns nil if the unit of the axis
-- may not be changed.
local function length_of(axis)
  local what, unit = (axis.label or ""):match "^(.-) / (%S+)$"
  if lengths[what] and in_mm(unit) then return what, in_mm(unit) end
end

-- Returns the largest absolute value on an axis of a panel, in the unit of the axis.
local function reach_of(panel, name)
  local most, axis = 0, panel[name]
  for _, curve in ipairs(panel.curves) do
    for _, value in ipairs(curve[name]) do
      if value == value and math.abs(value) < math.huge then most = math.max(most, math.abs(value)) end
    end
  end
  if axis.min and axis.max then most = math.max(math.abs(axis.min), math.abs(axis.max)) end
  return most
end

-- Returns the largest length [mm] of each quantity on the axes, so that all axes of a quantity have the same
-- unit.
local function reaches_of(figure, name)
  local reaches = {}
  for _, panel in ipairs(figure.panels) do
    local what, mm = length_of(panel[name])
    if what then reaches[what] = math.max(reaches[what] or 0, mm * reach_of(panel, name)) end
  end
  return reaches
end

local function unit_for(reach)
  for _, each in ipairs(known) do
    if reach < each[3] then return each[1], each[2] end
  end
end

local function scaled(list, factor)
  local result = {}
  for i = 1, #list do result[i] = factor * list[i] end
  return result
end

-- Returns a copy of the panel with one axis in another unit.
local function in_unit(panel, name, label, factor)
  local axis, curves = merged(panel[name]), {}
  axis.label = label
  axis.min, axis.max = axis.min and factor * axis.min, axis.max and factor * axis.max
  for i, curve in ipairs(panel.curves) do
    curves[i] = merged(curve, { [name] = scaled(curve[name], factor) })
    if name == "y" and curve.error then curves[i].error = scaled(curve.error, factor) end
  end
  return merged(panel, { [name] = axis, curves = curves })
end

-- Returns a copy of the figure with the lengths along its axis `name` ("x" or "y") in a suitable unit.
function units.shown(figure, name)
  local reaches, result = reaches_of(figure, name), merged(figure)
  result.panels = {}
  for i, panel in ipairs(figure.panels) do
    local what, mm = length_of(panel[name])
    local fits = what and reaches[what] > 0
    local unit, per_mm = unit_for(fits and reaches[what] or 0)
    local factor = fits and mm * per_mm or 1
    result.panels[i] = math.abs(factor - 1) < 1e-9 and panel or in_unit(panel, name, ("%s / %s"):format(what, unit), factor)
  end
  return result
end

-- --- powers of ten -------------------------------------------------------------------------------

-- Returns the exponent of the power of ten by which numbers up to `reach` are divided: 0 if they are short.
local function exponent_of(reach)
  if reach >= 1e5 then return 3 * math.floor(math.log(reach, 10) / 3 + 1e-9) end
  return reach > 0 and reach < 1e-3 and math.floor(math.log(reach, 10) + 1e-9) or 0
end

local raised = { [0] = "⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹" }

-- Returns a label with a power of ten, such as "volume / 10⁻⁴ mm³" or "k / (10⁻⁸ mm²/N)".
function units.with_power(label, exponent)
  local digits = ("%d"):format(exponent):gsub("%d", function(digit) return raised[tonumber(digit)] end):gsub("-", "⁻")
  local what, unit = label:match "^(.-) / (.*)$"
  local compound = unit and unit:match "^%((.*)%)$"
  if compound then return ("%s / (10%s %s)"):format(what, digits, compound) end
  return what and ("%s / 10%s %s"):format(what, digits, unit) or ("%s / 10%s"):format(label, digits)
end

-- Returns a copy of the figure in which numbers along the linear axis `name` that are very large or small are divided
-- by a power of ten, which is added to the label. Axes with the same label have the same power.
function units.with_powers(figure, name)
  local reaches, result = {}, merged(figure)
  local function is_plain(panel)
    local axis = panel[name]
    return axis.label and not axis.log and not axis.places and not panel.field and not axis.label:find " / %(?10"
  end
  for _, panel in ipairs(figure.panels) do
    local label = panel[name].label
    if is_plain(panel) then reaches[label] = math.max(reaches[label] or 0, reach_of(panel, name)) end
  end
  result.panels = {}
  for i, panel in ipairs(figure.panels) do
    local label = panel[name].label
    local exponent = is_plain(panel) and exponent_of(reaches[label]) or 0
    result.panels[i] = exponent == 0 and panel or in_unit(panel, name, units.with_power(label, exponent), 10.0 ^ -exponent)
  end
  return result
end

return units

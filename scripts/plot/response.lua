-- plot.response: draws a result of a study over a varied setting, with one curve for each value of a second
-- setting, or draws the result as a map over both settings.

local check = require "archard.lib.check"
local keys = require "archard.lib.keys"
local spelling = require "archard.lib.spelling"
local draw = require "archard.plot.draw"
local units = require "archard.plot.units"
local naming = require "archard.plot.naming"
local curves = require "archard.plot.curves"

local where = "plot.response"

-- --- varied settings -----------------------------------------------------------------------------

local function setting_of(study, case, name)
  local value = (study.flat and study.flat[case.id] or case.settings)[name]
  if value == nil then value = naming.get(case, name) end
  return value
end

local function check_varied(study, field, name)
  for _, each in ipairs(study.varied) do
    if each == name then return end
  end
  check.fail(where, ("field '%s': \"%s\" was not varied in this study%s"):format(field, name,
    check.hint(name, study.varied)))
end

local function matches(study, case, given)
  for name, value in pairs(given) do
    local is = setting_of(study, case, name)
    local close = type(is) == "number" and type(value) == "number"
      and math.abs(is - value) <= 1e-9 * math.max(math.abs(is), math.abs(value))
    if is ~= value and not close then return false end
  end
  return true
end

-- Raises an error if options.where contains a setting that no case has.
local function check_where(study, given)
  for name in pairs(given) do
    local known = false
    for _, case in ipairs(study:cases()) do known = known or setting_of(study, case, name) ~= nil end
    if not known then
      check.fail(where, ("field 'where': no case has a setting '%s'%s"):format(tostring(name),
        check.hint(tostring(name), study.varied)))
    end
  end
end

-- Returns the finished cases that match options.where, each as { case=, x=, by=, y= } with the values to
-- draw.
local function points_of(study, options)
  local points = {}
  for _, case in ipairs(study:cases()) do
    if case.status == "done" and matches(study, case, options.where or {}) then
      local point = { case = case, x = setting_of(study, case, options.x),
        by = options.by and setting_of(study, case, options.by),
        y = naming.get(case, options.y) or case.last and case.last[options.y] }
      if type(point.y) ~= "number" then
        check.fail(where, ("field 'y': the cases have no numeric result or setting '%s'%s"):format(options.y,
          check.hint(options.y, keys(case.last or {}))))
      end
      points[#points + 1] = point
    end
  end
  if #points == 0 then check.fail(where, "no finished case matches 'where'") end
  return points
end

-- Raises an error if two cases have the same position in the picture but differ in another setting.
local function refuse_hidden(study, points)
  local seen = {}
  for _, point in ipairs(points) do
    local position = tostring(point.x) .. "|" .. tostring(point.by)
    local other = seen[position]
    for _, name in ipairs(other and study.varied or {}) do
      local a, b = setting_of(study, other, name), setting_of(study, point.case, name)
      if a ~= b then
        check.fail(where, ("cases %d and %d have the same position and differ in %s: choose with "
          .. "by=\"%s\" or where={ %s=%s }"):format(other.id, point.case.id, name, name, spelling.field(name),
          type(a) == "string" and ("%q"):format(a) or tostring(a)))
      end
    end
    seen[position] = point.case
  end
end

-- Returns the distinct values of a field of the points, and true if all are numbers. Numbers are sorted;
-- other values are listed in order of appearance.
local function values_of(points, field)
  local values, seen, numbers = {}, {}, true
  for _, point in ipairs(points) do
    local value = point[field]
    if value ~= nil and not seen[value] then
      seen[value] = true
      values[#values + 1] = value
      numbers = numbers and type(value) == "number"
    end
  end
  if numbers then table.sort(values) end
  return values, numbers
end

-- --- curves --------------------------------------------------------------------------------------

-- Returns ticks at 1, 2, 3, ... with the values as labels, or nil if all values are numbers.
local function places_for(values, numbers)
  if numbers then return nil end
  local at, words = {}, {}
  for i, value in ipairs(values) do at[i], words[i] = i, tostring(value) end
  return { at = at, words = words }
end

local function position_in(values, numbers)
  local positions = {}
  for i, value in ipairs(values) do positions[value] = numbers and value or i end
  return positions
end

local function curve_of(points, by, positions, factor)
  local mine, curve = {}, { x = {}, y = {}, style = "linespoints" }
  for _, point in ipairs(points) do
    if point.by == by and positions[point.x] then mine[#mine + 1] = point end
  end
  table.sort(mine, function(a, b) return positions[a.x] < positions[b.x] end)
  for i, point in ipairs(mine) do curve.x[i], curve.y[i] = positions[point.x], point.y * factor end
  return curve
end

local function as_curves(points, options, label, factor)
  local xs, numbers = values_of(points, "x")
  local positions, result = position_in(xs, numbers), { xlabel = naming.axis_of(options.x),
    ylabel = label, xplaces = places_for(xs, numbers) }
  local others, are_numbers = values_of(points, "by")
  for i, by in ipairs(options.by and others or { false }) do
    local curve = curve_of(points, options.by and by or nil, positions, factor)
    curve.title = options.by and naming.value_of(options.by, by) or nil
    curve.value = are_numbers and #others > 8 and by or nil
    result[i] = curve
  end
  if are_numbers and #others > 8 then result.vlabel = naming.axis_of(options.by) end
  return result
end

-- --- map -----------------------------------------------------------------------------------------

-- Draws a map with one square of equal size for each case. The values of the settings are tick labels,
-- because values such as strokes of 0.11 mm and 20 mm do not fit one scale.
local function as_map(points, options, label, factor)
  local most = 0
  for _, point in ipairs(points) do most = math.max(most, math.abs(point.y * factor)) end
  local power = most > 0 and (most < 0.01 or most >= 1e5) and math.floor(math.log(most, 10)) or 0
  factor = factor / 10 ^ power
  if power ~= 0 then label = units.with_power(label, power) end
  local xs, ys = values_of(points, "x"), values_of(points, "by")
  local across, up = position_in(xs, false), position_in(ys, false)
  local field, n = { x = {}, y = {}, value = {} }, 0
  for _, point in ipairs(points) do
    local i, j = across[point.x], up[point.by]
    for k, corner in ipairs { { -.5, -.5 }, { .5, -.5 }, { .5, .5 }, { -.5, .5 } } do
      field.x[n + k], field.y[n + k] = i + corner[1], j + corner[2]
      field.value[n + k] = point.y * factor
    end
    n = n + 4
  end
  return { field, xlabel = naming.axis_of(options.x), ylabel = naming.axis_of(options.by),
    xplaces = places_for(xs, false), yplaces = places_for(ys, false),
    vlabel = label, xrange = { 0.5, #xs + 0.5 }, yrange = { 0.5, #ys + 0.5 } }
end

-- --- the picture ---------------------------------------------------------------------------------

-- Returns four values: the name of a quantity for the title ("wear depth"), its axis label ("wear depth /
-- µm"), the factor to the unit of the label, and " of the cylinder", " of the plate" or "".
local function labels_of(name)
  local label, factor = curves.quantity_of(name)
  if not label then return name, name, 1 end
  local body = name:match("_(cylinder)$") or name:match("_(plate)$")
  return label:match("^(.-) / ") or label, label, factor, body and " of the " .. body or ""
end

local own = { x = check.text, y = check.text, by = check.text, where = check.table,
  map = check.flag }

-- plot.response(study, { x="alpha", y="depth_cylinder", by="stroke", map=true, where={ k=1e-8 } }) draws the
-- result y of the finished cases over the setting x.
return function(study, options)
  local cases = naming.get(study, "cases")
  if not cases or not naming.get(study, "varied") then
    check.fail(where, "expected a study as the first argument, got " .. check.shown(study))
  end
  options = draw.options(where, type(options) == "string" and { x = options } or options, own)
  for _, name in ipairs { "x", "y" } do
    if type(options[name]) ~= "string" then check.refuse(where, name, "a string", options[name]) end
  end
  check_varied(study, "x", options.x)
  if options.by then check_varied(study, "by", options.by) end
  if options.map and not options.by then check.refuse(where, "by", "a string, as required by map=true", nil) end
  check_where(study, options.where or {})
  local points = points_of(study, options)
  refuse_hidden(study, points)
  local name, label, factor, body = labels_of(options.y)
  local given = (options.map and as_map or as_curves)(points, options, label, factor)
  given.title = name .. (body or "")
  local remaining = {}
  for name, value in pairs(options) do
    if not own[name] then remaining[name] = value end
  end
  draw.draw(where, draw.over(given, remaining))
end

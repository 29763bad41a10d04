-- Reads the unknowns of a fit: numbers in wear{}, model{} or bodies, or k and alpha as curves over the
-- distance. Each number is a parameter of the fit. A change of variables limits parameters to their bounds.

local check = require "archard.lib.check"
local check_names = require "archard.study.names"
local merged = require "archard.lib.merged"
local numbers = require "archard.definition.number"
local settings = require "archard.definition.settings"
local spline = require "archard.fit.spline"

local unknown = {}

-- --- the fields ----------------------------------------------------------------------------------

local not_below_0 = check.kind("a number >= 0", function(v) return check.number.test(v) and v >= 0 end)
local distances = check.list_of(not_below_0, "increasing distances", true)
local knots = check.kind("at least two increasing distances [mm]", function(v)
  return distances.test(v) and #v > 1
end)
local starts = check.list_of(check.number, "numbers")
local start_kind = check.kind("a number, or a list with one for each knot", function(v)
  return check.number.test(v) or starts.test(v)
end)
local fields = { start = start_kind, low = check.number, high = check.number, knots = knots,
  smooth = check.one_of({ "auto" }, not_below_0) }
unknown.fields = fields

-- Returns the typical range of a parameter, which is the unit of its steps and its prior error.
local function span_of(one)
  if one.low and one.high then return one.high - one.low end
  if one.low then return one.start - one.low end
  if one.high then return one.high - one.start end
  return one.start ~= 0 and math.abs(one.start) or 1
end

-- Checks that low < high and that both bounds lie in the permitted range of the setting.
local function check_bounds(where, field, setting, given)
  for _, name in ipairs{ "low", "high" } do
    local value = given[name]
    if value and ((setting.low and value < setting.low) or (setting.high and value > setting.high)) then
      check.refuse(where, field .. "." .. name, ("a number from %g to %g"):format(setting.low or -math.huge,
        setting.high or math.huge), value)
    end
  end
  if given.low and given.high and given.low >= given.high then
    check.fail(where, ("fields '%s.low' and '%s.high': expected low < high, got %g and %g"):format(field, field,
      given.low, given.high))
  end
end

-- Makes one parameter of an unknown. name: name given by the user; given.paths: paths of the settings in
-- wear{}; distance: distance of the knot [mm], or nil.
local function parameter(where, field, name, setting, given, start, distance)
  local one = { path = name, paths = given.paths, unit = setting.unit or "", start = start, distance = distance,
    name = distance and ("%s at %g mm"):format(name, distance) or name,
    low = given.low or setting.low, high = given.high or setting.high }
  if (one.low and start <= one.low) or (one.high and start >= one.high) then
    check.fail(where, ("field '%s.start': expected a number inside the bounds %s and %s, got %g")
      :format(field, one.low or "none", one.high or "none", start))
  end
  one.span = span_of(one)
  return one
end

local function check_one(where, field, setting, given)
  given = check.definition(where, given, fields)
  check_bounds(where, field, setting, given)
  if given.start == nil then check.refuse(where, field .. ".start", fields.start.expected, nil) end
  if given.knots and not setting.series then
    check.fail(where, ("field '%s.knots': only k, alpha and other settings that can be a table over the "
      .. "distance can have knots"):format(field))
  end
  if type(given.start) == "table" and #given.start ~= #(given.knots or { 1 }) then
    check.fail(where, ("field '%s.start': expected one number for each knot, got %d")
      :format(field, #given.start))
  end
end

local function add(self, where, name, given, paths)
  local field = "unknown." .. name
  local setting = numbers.setting(paths[1])
  numbers.check(where, field, setting)
  if type(given) == "number" then given = { start = given } end
  if type(given) ~= "table" then check.refuse(where, field, "a table { start= }", given) end
  check_one(where, field, setting, given)
  given = merged(given, { paths = paths })
  local starts = type(given.start) == "table" and given.start or nil
  if not given.knots then
    self[#self + 1] = parameter(where, field, name, setting, given, starts and starts[1] or given.start)
    return
  end
  local curve = { path = name, knots = given.knots, first = #self + 1, smooth = given.smooth or 0,
    unit = setting.unit or "" }
  self.curves[#self.curves + 1] = curve
  for i, distance in ipairs(given.knots) do
    self[#self + 1] = parameter(where, field, name, setting, given, starts and starts[i] or given.start,
      distance)
  end
end

-- Returns the paths of the settings of each name, in a table by name. Raises an error if a path belongs to
-- two names. The model is read only if a name is not a field of wear{}.
local function paths_of(where, names, model)
  local by_name, flat, there, beneath = {}, {}, {}, nil
  for _, name in ipairs(names) do
    if not numbers.of_run(name) then beneath = beneath or settings.flatten(where, { model = model }) end
    by_name[name] = numbers.paths(name, beneath or {})
    for _, path in ipairs(by_name[name]) do
      if there[path] then
        check.fail(where, ("fields 'unknown.%s' and 'unknown.%s': both are %s"):format(there[path], name, path))
      end
      flat[path], there[path] = 0, name
    end
  end
  check_names(where, { flat })
  return by_name
end

-- Checks and reads the user's unknowns. model: the user's model, or nil. Returns a list of parameters {
-- name=, path=, paths=, unit=, start=, low=, high=, span= }; its field `curves` is the list of curves.
function unknown.read(where, given, model)
  local names, self = {}, { curves = {} }
  for name in pairs(given) do
    if type(name) ~= "string" then check.fail(where, "field 'unknown': fields are given by name, as { k = ... }") end
    names[#names + 1] = name
  end
  if #names == 0 then check.fail(where, "field 'unknown': expected at least one field, got none") end
  table.sort(names)
  local paths = paths_of(where, names, model)
  for _, name in ipairs(names) do add(self, where, name, given[name], paths[name]) end
  return self
end

-- --- values --------------------------------------------------------------------------------------

local function slice(values, curve)
  return table.move(values, curve.first, curve.first + #curve.knots - 1, 1, {})
end

-- Returns a curve as { distance=, value= }. values: the values of all parameters.
function unknown.series(curve, values) return spline.series(curve.knots, slice(values, curve)) end

-- Returns the settings in a table by path. values: the values of all parameters.
function unknown.settings(self, values)
  local flat = {}
  for i, one in ipairs(self) do
    for _, path in ipairs(one.paths) do flat[path] = values[i] end
  end
  for _, curve in ipairs(self.curves) do
    local series = unknown.series(curve, values)
    flat[curve.path] = nil
    flat[curve.path .. ".distance"], flat[curve.path .. ".value"] = series.distance, series.value
  end
  return flat
end

-- --- bounds by a change of variables -------------------------------------------------------------
-- The search changes one variable for each parameter. The variable is 1 at the start value of the parameter,
-- and a change by 1 changes the parameter by about its typical range.

local function phase(one) -- start value of a parameter as an angle between its bounds
  return math.asin(2 * (one.start - one.low) / (one.high - one.low) - 1)
end

-- Returns the value of a parameter at the search variable u, and the derivative of the value with respect to
-- u.
function unknown.value(one, u)
  if one.low and one.high then
    local half, angle = (one.high - one.low) / 2, u - 1 + phase(one)
    return one.low + half * (1 + math.sin(angle)), half * math.cos(angle)
  elseif one.low then
    local above = (one.start - one.low) * math.exp(u - 1)
    return one.low + above, above
  elseif one.high then
    local below = (one.high - one.start) * math.exp(1 - u)
    return one.high - below, below
  end
  return one.start + one.span * (u - 1), one.span
end

-- Returns the value of a parameter after a step. The step is limited to 0.9 of the distance to a bound.
function unknown.inside(one, value, step)
  if one.low then step = math.max(step, 0.9 * (one.low - value)) end
  if one.high then step = math.min(step, 0.9 * (one.high - value)) end
  return value + step
end

-- Returns "low" or "high" if a parameter is at its lower or upper bound, else nil.
function unknown.at_bound(one, value)
  if one.low and value - one.low < 1e-4 * one.span then return "low" end
  if one.high and one.high - value < 1e-4 * one.span then return "high" end
end

-- --- roughness of curves -------------------------------------------------------------------------

-- Returns a matrix whose product with the parameters is the roughness of the curves. For each inner knot,
-- one row computes the second difference of the values divided by their typical range. The spacings of the
-- knots are divided by their mean.
function unknown.roughness(self)
  local rows = {}
  for _, curve in ipairs(self.curves) do
    local knots = curve.knots
    local mean = (knots[#knots] - knots[1]) / (#knots - 1)
    for i = 2, #knots - 1 do
      local a, b, row = (knots[i] - knots[i - 1]) / mean, (knots[i + 1] - knots[i]) / mean, {}
      local j = curve.first + i - 1
      local scale = 1 / self[j].span
      row[j - 1], row[j], row[j + 1] = scale / a, -scale * (1 / a + 1 / b), scale / b
      rows[#rows + 1] = row
    end
  end
  return rows
end

-- Returns the largest roughness weight of all curves, or "auto" if a curve has smooth = "auto".
function unknown.smooth(self)
  local most = 0
  for _, curve in ipairs(self.curves) do
    if curve.smooth == "auto" then return "auto" end
    most = math.max(most, curve.smooth)
  end
  return most
end

return unknown

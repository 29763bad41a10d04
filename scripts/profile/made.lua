-- Lua functions profile{ x=, z= } and profile.read: check the user's fields, convert lengths to mm and make a
-- profile (class.lua, evaluate.lua).

local check = require "archard.lib.check"
local csv = require "archard.lib.csv"
local keys = require "archard.lib.keys"
local merged = require "archard.lib.merged"
local units = require "archard.lib.csv_units"
local profile = require "archard.profile.evaluate"

local column = check.kind("the name of a column or its number", function(v)
  return type(v) == "string" or check.count.test(v)
end)

-- --- a definition ---------------------------------------------------------------------------------------

local noise_level = check.kind("a number >= 0 in mm", function(v) return check.number.test(v) and v >= 0 end)
local treatment = { level = profile.level_kind, scar = profile.range, filter = check.positive, error = noise_level }

local function with(fields)
  for name, kind in pairs(treatment) do fields[name] = kind end
  return fields
end

local fields = with{ x = check.list, z = check.list, y = check.list, h = check.list }

-- Returns the name of the field with the values: "z" for heights or "h" for depths.
local function one_of_both(where, given)
  if (given.z == nil) == (given.h == nil) then
    check.fail(where, ("fields 'z' and 'h': expected one of them, got %s"):format(given.z and "both" or "none"))
  end
  return given.z and "z" or "h"
end

-- Levels and filters a profile as required by the user's fields. Levelling comes before filtering: the filter
-- does not change a line, and changes a circle only slightly, mostly at the ends.
local function treated(where, p, given)
  if given.scar and not given.level then
    check.fail(where, "field 'scar': only allowed with level, which is fitted outside the scar")
  end
  if given.level then p = profile.level(where, p, given.level, given.scar) end
  return given.filter and p:filter(given.filter) or p
end

local function numbers(where, name, list)
  for i = 1, #list do
    if type(list[i]) ~= "number" then check.refuse(where, ("%s[%d]"):format(name, i), "a number in mm", list[i]) end
  end
  return list
end

local function new(given)
  local where = "profile"
  given = check.definition(where, given, fields)
  if given.z and given.y then check.fail(where, "fields 'z' and 'y': expected one of them, got both") end
  if given.y then given = merged(given, { z = given.y }) end
  local name = one_of_both(where, given)
  if given.x == nil then check.refuse(where, "x", "positions in mm", nil) end
  local p = profile.new(where, numbers(where, "x", given.x), numbers(where, name, given[name]), name, given.error)
  return treated(where, p, given)
end

-- --- a file ------------------------------------------------------------------------------------------------

local unit_kind = check.kind('a unit such as "um", or { x="mm", z="um" }', function(v)
  return type(v) == "string" or type(v) == "table"
end)
local read_fields = with{ unit = unit_kind, x = column, z = column, h = column }
local lengths = { mm = true, cm = true, m = true, um = true, nm = true, ["in"] = true, ["µm"] = true, ["μm"] = true }
local usual = { x = { "x", "s", "position", "distance" }, z = { "z", "height", "y" }, h = { "h", "depth" } }

local function unit_of(where, given, name)
  local unit = given
  if type(given) == "table" then
    given = check.fields(where, given, { x = check.text, z = check.text, h = check.text }, "unit.")
    unit = given[name]
  end
  if unit and not lengths[unit] then
    check.refuse(where, "unit", "a length: mm, um, nm, cm, m or in", unit)
  end
  return unit
end

-- Returns the first of the usual column names that the file contains, or nil if it contains none.
local function usual_name(columns, name)
  for _, word in ipairs(usual[name]) do if columns[word] then return word end end
end

-- Returns the values of a column in mm, and its name if its unit is unknown and mm is used. A unit in the header of
-- the file has priority over a unit given by the user.
local function in_mm(where, path, read, name, wanted, given)
  local found = math.type(wanted) == "integer" and read.order[wanted] or wanted
  local values = found and read.columns[found]
  if not values and wanted then
    check.fail(where, ("%s: no column %s; the columns are %s"):format(path, check.shown(wanted), table.concat(keys(read.columns), ", ")))
  end
  if not values then
    check.fail(where, ("%s: no column for '%s'; the columns are %s: give its name, %s=\"...\""):format(path, name,
      table.concat(keys(read.columns), ", "), name))
  end
  for i = 1, #values do
    if type(values[i]) ~= "number" then check.fail(where, ("%s: column %q: expected numbers"):format(path, found)) end
  end
  local header = read.units[found]
  if header and not lengths[header] then
    check.fail(where, ("%s: column %q: expected a unit of length, got %s"):format(path, found, header), "FORMAT")
  end
  local unit, result = not header and unit_of(where, given, name), {}
  for i = 1, #values do result[i] = units.scaled(values[i], unit or "mm") end
  return result, not header and not unit and found
end

local function note_units(where, path, x, values)
  if not x and not values then return end
  warn(("%s: %s: no unit of %s, mm is used; another one is set by unit = \"um\" or { x = \"mm\", z = \"um\" }"):format(where, path,
    table.concat({ x or values, x and values or nil }, " and ")))
end

local function read(path, given)
  local where = "profile.read"
  given = check.definition(where, given or {}, read_fields)
  if not check.file.test(path) then check.fail(where, "expected the path of a file, got " .. check.shown(path)) end
  if given.z and given.h then one_of_both(where, given) end
  local source = {}
  source.columns, source.units, source.order = csv.read(path)
  local name = given.h and "h" or not given.z and not usual_name(source.columns, "z")
    and usual_name(source.columns, "h") and "h" or "z"
  local x, x_unknown = in_mm(where, path, source, "x", given.x or usual_name(source.columns, "x"), given.unit)
  local values, unknown = in_mm(where, path, source, name, given[name] or usual_name(source.columns, name), given.unit)
  note_units(where, path, x_unknown, unknown)
  return treated(where, profile.new(where, x, values, name, given.error, path), given)
end

return { new = new, read = read, mean = profile.mean }

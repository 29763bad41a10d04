-- map.read recognizes the format of a file, reads a map, converts units, and crops, repairs and levels the
-- map.

local check = require "archard.lib.check"
local level = require "archard.map.level"
local map = require "archard.map.class"
local repair = require "archard.map.repair"
local source = require "archard.map.source"
local units = require "archard.lib.csv_units"

local where = "map.read"

-- --- formats ----------------------------------------------------------------------------------------

local function of(module, name)
  return function(file, ...)
    local found = require("archard.map." .. module)
    return (name and found[name] or found)(file, ...)
  end
end

local function refused(what)
  return function(file)
    file:refuse("expected a supported format (.xyz, .grd, .sdf, .gsf, .sur, .al3d, text), got %s", what)
  end
end

-- List of formats: the first bytes of a file, and the function that reads the file.
local formats = { { "DSAA", of("surfer", "DSAA") }, { "DSBB", of("surfer", "DSBB") }, { "DSRB", of("surfer", "DSRB") },
  { "Gwyddion Simple Field 1.0\n", of("gsf", "read") }, { "DIGITAL SURF", of "sur" },
  { "DSCOMPRESSED", refused "a compressed .sur; save it without compression" },
  { "AliconaImaging\0\r\n", of("al3d", "read") }, { "PK\3\4", refused "a zip archive, such as .x3p; save it as .sdf" },
  { "GWYP", refused "Gwyddion's own .gwy; save it as .gsf" } }
for _, version in ipairs{ "ISO-1.0", "ISO-2.0", "BCR-1.0" } do
  for _, kind in ipairs{ "a", "b" } do
    formats[#formats + 1] = { kind .. version, function(file) return of "sdf"(file, kind .. version) end }
  end
end

-- Reads a text file: a matrix if the user gave `step`, else a list of points. A file with a zero byte near
-- the start is binary and is refused.
local function read_text(file, given)
  if file.text:sub(1, 4096):find "%z" then
    file:refuse("expected .xyz, .grd, .sdf, .gsf, .sur, .al3d or text, got other bytes: %q", file.text:sub(1, 12))
  end
  if given.step then
    local step = type(given.step) == "table" and { rawget(given.step, 1), rawget(given.step, 2) } or { given.step, given.step }
    return of("text", "matrix")(file, step)
  end
  return of("text", "points")(file)
end

local function read_file(file, given)
  if #file.text == 0 then file:refuse "expected a map, the file is empty" end
  for _, format in ipairs(formats) do
    if file:starts_with(format[1]) then return format[2](file) end
  end
  return read_text(file, given)
end

-- --- units ------------------------------------------------------------------------------------------

local lengths = { mm = true, cm = true, m = true, um = true, nm = true, ["in"] = true, ["µm"] = true, ["μm"] = true }
local pressures = { MPa = true, GPa = true, kPa = true, Pa = true, ["N/mm2"] = true }
local length = check.one_of{ "mm", "um", "nm", "cm", "m", "in" }
local unit_kind = check.kind('a unit such as "um", or { x="mm", y="um" }', function(v)
  return type(v) == "string" or type(v) == "table"
end)

-- Returns the unit of x or y. The unit in the file has priority over the unit given by the user.
local function unit_of(file, of_file, given, name)
  local stated = given
  if type(given) == "table" then
    given = check.fields(where, given, { x = check.text, y = check.text }, "unit.")
    stated = given[name]
  end
  if stated and not lengths[stated] then check.refuse(where, "unit", length.expected, stated) end
  if of_file and of_file ~= "" then
    if not (lengths[of_file] or name == "y" and pressures[of_file]) then
      file:refuse("expected %s in a unit of length, got %q", name == "x" and "x and y" or "z", of_file)
    end
    return of_file
  end
  if not stated then
    check.fail(where, ("field 'unit': expected the unit of %s (%s), as %s contains none, got nil; "
      .. 'unit = { x = "mm", y = "um" } if x and y have another unit than the heights'):format(
      name == "x" and "x and y" or "heights", length.expected, file.path))
  end
  return stated
end

local function scale(list, unit)
  local factor = units.scaled(1, unit)
  if factor ~= 1 then for i = 1, #list do list[i] = list[i] * factor end end
end

-- --- processing of the points -----------------------------------------------------------------------

local fill_kind = check.kind("true or a height in mm", function(v) return v == true or check.number.test(v) end)
local step_kind = check.kind("a distance in mm, or { along x, along z }", function(v)
  return check.positive.test(v) or type(v) == "table" and check.positive.test(rawget(v, 1)) and check.positive.test(rawget(v, 2))
end)
local crop_kind = check.kind("{ x={ from, to }, z={ from, to } }", function(v)
  return type(v) == "table" and rawget(v, 1) == nil
end)
local fields = { unit = unit_kind, step = step_kind, crop = crop_kind, outliers = check.positive, fill = fill_kind,
  level = level.kind, scar = level.scar }

local function refuse_missing(file, t, count, first)
  file:refuse("expected a value at each point, %d of %d have none (the first at x = %.6g, z = %.6g mm); fill = true uses "
    .. "the mean of neighbours, fill = 0 a height in mm, crop = { x={ from, to } } omits them", count, #t.y,
    t.x[(first - 1) // #t.z + 1], t.z[(first - 1) % #t.z + 1])
end

local function repaired(file, t, given)
  local y, nx, nz = t.y, #t.x, #t.z
  t.outliers = given.outliers and repair.outliers(y, nx, nz, given.outliers) or 0
  local count, first = repair.count_missing(y)
  t.missing = count
  if count == 0 then return end
  if count == #y then file:refuse("expected at least one point with a value, got %d points without", count) end
  if not given.fill then refuse_missing(file, t, count, first) end
  if given.fill == true then return repair.fill(y, nx, nz) end
  for k = 1, #y do if y[k] ~= y[k] then y[k] = given.fill end end
end

-- Warns if a unit that may be meant only for the heights makes a map very small.
local function warn_small(file, found, unit)
  local tiny = 0.05 -- [mm]
  local size = math.max(found.x[#found.x] - found.x[1], found.z[#found.z] - found.z[1])
  if type(unit) ~= "string" or size >= tiny then return end
  warn(("map.read: %s: the map is only %.3g mm long, as unit = %q is the unit of x and y, too; unit = { x = \"mm\", y = %q } "
    .. "gives x and y another unit"):format(file.path, size, unit, unit))
end

-- map.read(path, { unit=, step=, crop=, outliers=, fill=, level=, scar= }) reads a map from a file.
local function read(path, given)
  given = check.definition(where, given or {}, fields)
  if not check.file.test(path) then check.fail(where, "expected the path of a file, got " .. check.shown(path)) end
  if given.scar and not given.level then
    check.fail(where, "field 'scar': only allowed with level, which is fitted outside the scar")
  end
  local file = source.open(where, path)
  local found = read_file(file, given)
  local unit = unit_of(file, found.unit_y, given.unit, "y")
  local unit_x = unit_of(file, found.unit_x, given.unit, "x")
  scale(found.x, unit_x)
  scale(found.z, unit_x)
  if not found.unit_x then warn_small(file, found, given.unit) end
  scale(found.y, unit)
  local t = map.derived({ unit = pressures[unit] and "MPa" or "mm", path = path,
    name = found.name or (pressures[unit] and "pressure" or "height") }, found.x, found.z, found.y)
  if given.crop then t = check.as(where, t.crop, t, given.crop) end
  repaired(file, t, given)
  t = map.new(where, t.x, t.z, t.y, t)
  return given.level and level.off(where, t, given.level, given.scar) or t
end

return { read = read }

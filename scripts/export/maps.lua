-- Writes maps to files: export.vti writes image data for ParaView, export.gsf fields for Gwyddion, and
-- export.csv tables of points.

local axis = require "archard.map.axis"
local check = require "archard.lib.check"
local decimal = require "archard.export.decimal"
local files = require "archard.files"
local gsf = require "archard.map.gsf"
local joint_history = require "archard.joint.history"
local map = require "archard.map.class"
local strict = require "archard.strict"
local written = require "archard.lib.written"
local xml = require "archard.export.xml"

local maps = {}

-- Checks the path of a file and returns it. The extension `ending` is added to a path without an extension;
-- any other extension is an error.
local function checked_path(where, path, ending)
  local own = check.file.test(path) and path:match "%.[^./]*$"
  if not check.file.test(path) or own and own ~= ending then
    check.refuse(where, "path", "a file name that ends in " .. ending, path)
  end
  return own and path or path .. ending
end

local function check_map(where, value, number)
  if not map.is(value) then
    check.fail(where, ("%sexpected a map, got %s"):format(number and ("item %d: "):format(number) or "", check.shown(value)))
  end
end

-- --- VTK --------------------------------------------------------------------------------------------

local function differ(a, b)
  if #a ~= #b then return true end
  local tolerance = 1e-9 * axis.step(a)
  return math.abs(a[1] - b[1]) > tolerance or math.abs(a[#a] - b[#b]) > tolerance
end

-- Checks a map or a list of maps and returns a list of maps. All maps in a list must have the same points and
-- different names.
local function list_of(where, given)
  if map.is(given) then return { given } end
  if type(given) ~= "table" or given[1] == nil then
    check.fail(where, ('expected a map or a list of maps, such as w:map("ball") in 3-D, got %s'):format(check.shown(given)))
  end
  local list, seen = {}, {}
  for i, t in ipairs(given) do
    check_map(where, t, i)
    if differ(t.x, given[1].x) or differ(t.z, given[1].z) then
      check.fail(where, ("item %d: expected the points of the first map, got %d x %d other points; make them equal by "
        .. "t:resample and t:crop"):format(i, #t.x, #t.z))
    end
    if seen[t.name] then
      check.fail(where, ("item %d: expected a unique name, got %q again"):format(i, t.name))
    end
    list[i], seen[t.name] = t, true
  end
  return list
end

-- Appends the values of a map to the list of text lines, in the order of VTK: x changes fastest, then z.
local function add_values(lines, t)
  local row, nz = {}, #t.z
  for j = 1, nz do
    for i = 1, #t.x do row[i] = files.number(t.y[(i - 1) * nz + j]) end
    lines[#lines + 1] = table.concat(row, " ")
  end
end

-- Returns the depth, height and pressure maps of a body of a run, or nil for a body without maps, such as a
-- groove.
local function maps_of(run, body)
  local list = {}
  for i, what in ipairs{ "depth", "height", "pressure" } do
    local fine, t = pcall(run.map, run, body, what)
    if not fine then return nil end
    list[i] = t
  end
  return list
end

-- Writes one file STEM-BODY.vti for each body of a three-dimensional run. Returns the list of paths.
function maps.bodies(where, run, stem)
  local files_written = {}
  for _, body in ipairs{ run.model.bodies.upper, run.model.bodies.lower } do
    local list = maps_of(run, body)
    if list then files_written[#files_written + 1] = maps.write(where, list, ("%s-%s.vti"):format(stem, body)) end
  end
  return files_written
end

-- Lua function export.vti(object, path). It writes one file for a map, for a list of maps, or for the
-- pressure of a three-dimensional contact. For a three-dimensional run it writes one file for each body.
-- Returns the paths.
function maps.vti(given, path, options)
  local where = "export.vti"
  check.definition(where, options or {}, {})
  path = checked_path(where, path, ".vti")
  local shown = check.shown(given)
  if shown == "a wear object" and given.model.geometry == "3-D" then
    return written.returned(where, table.unpack(maps.bodies(where, given, (path:gsub("%.vti$", "")))))
  end
  if shown == "a contact object" and given.model.geometry == "3-D" then given = given:pressure() end
  return written.returned(where, maps.write(where, list_of(where, given), path))
end

-- Writes maps with common points as VTK image data in the plane y = 0, one array of values for each map.
-- Returns the path.
function maps.write(where, list, path)
  local x, z = list[1].x, list[1].z
  local extent = ("0 %d 0 0 0 %d"):format(#x - 1, #z - 1)
  local lines = { '<?xml version="1.0"?>', '<VTKFile type="ImageData" version="0.1" byte_order="LittleEndian">',
    ('<ImageData WholeExtent="%s" Origin="%s 0 %s" Spacing="%s 1 %s">'):format(extent, files.number(x[1]), files.number(z[1]),
      files.number(axis.step(x)), files.number(axis.step(z))),
    ('<Piece Extent="%s">'):format(extent), "<PointData>" }
  for _, t in ipairs(list) do
    local name = t.name:gsub("%c", " ")
    lines[#lines + 1] = ('<DataArray type="Float64" Name="%s" format="ascii">'):format(xml(name))
    add_values(lines, t)
    lines[#lines + 1] = "</DataArray>"
  end
  lines[#lines + 1] = "</PointData>\n</Piece>\n</ImageData>\n</VTKFile>\n"
  files.write(where, path, table.concat(lines, "\n"))
  return path
end

-- --- GSF and CSV files ------------------------------------------------------------------------------

-- Lua function export.gsf(map, path): writes a map in the GSF format of Gwyddion and returns the path.
function maps.gsf(t, path)
  local where = "export.gsf"
  check_map(where, t)
  path = checked_path(where, path, ".gsf")
  files.write(where, path, gsf.text(t))
  return written.returned(where, path)
end

local function csv_of(t)
  local name = t.name:gsub('[%c",;%[%]()]', " ")
  local lines = { ("x [mm],z [mm],%s [%s]"):format(name, t.unit) }
  for i, x in ipairs(t.x) do
    for j, z in ipairs(t.z) do
      lines[#lines + 1] = ("%s,%s,%s"):format(files.number(x), files.number(z), files.number(t.y[(i - 1) * #t.z + j]))
    end
  end
  return table.concat(lines, "\n") .. "\n"
end

-- Converts a map over the angles theta and phi to a table with the columns theta, phi and value. Also returns
-- the units of the angles.
local function lattice_of(map)
  local theta, phi = {}, {}
  for _, each in ipairs(map.theta) do
    for _, other in ipairs(map.phi) do theta[#theta + 1], phi[#phi + 1] = each, other end
  end
  return { theta = theta, phi = phi, value = map.values }, { theta = "degrees", phi = "degrees" }
end

local function is_lattice(t) return type(t) == "table" and rawget(t, "theta") and rawget(t, "phi") and rawget(t, "values") end

-- Writes a CSV file and returns its path. This function writes maps over x and z, maps over theta and phi, the table of
-- a study, the history of a joint's run, and the pressure of a joint's contact. archard.files writes all other objects.
local function write_csv(t, path, ...)
  if strict.is(t, "joint_wear") then
    local columns, units = joint_history(t)
    return files.csv(columns, path, units)
  end
  local lattice = strict.is(t, "joint_contact") and t.pressure or is_lattice(t) and t
  if lattice then
    local columns, units = lattice_of(lattice)
    return files.csv(columns, path, units)
  end
  local is_study = check.shown(t) == "a study object"
  if not is_study and not map.is(t) then return files.csv(t, path, ...) end
  path = checked_path("export.csv", path, ".csv")
  files.write("export.csv", path, is_study and t:table{ format = "csv" } .. "\n" or csv_of(t))
  return path
end

-- Separates the option `decimal` from the units of the columns in the third argument of export.csv. Returns true if it
-- is a comma, and the units or nothing. Only tables of lists have units.
local function split_options(t, given)
  if type(given) ~= "table" then return false, given end
  local units = {}
  for name, value in pairs(given) do
    if name ~= "decimal" then units[name] = value end
  end
  if given.decimal ~= nil and given.decimal ~= "," and given.decimal ~= "." then
    check.refuse("export.csv", "decimal", '"." or ","', given.decimal)
  end
  local has_units = next(units) ~= nil
  if has_units and (check.shown(t) ~= "a table" or is_lattice(t)) then
    check.fail("export.csv", ("unknown field '%s' (known: decimal)"):format(tostring((next(units)))))
  end
  return given.decimal == ",", has_units and units or nil
end

-- Lua function export.csv(object, path, { decimal= }) or, for a table of lists, export.csv(t, path, { x = "mm", decimal= }):
-- writes a CSV file and returns its path.
function maps.csv(...)
  local t, path, given = ...
  local has_commas, units = split_options(t, given)
  local paths = table.pack(write_csv(t, path, units))
  for i = 1, has_commas and paths.n or 0 do decimal("export.csv", paths[i]) end
  return written.returned("export.csv", table.unpack(paths, 1, paths.n))
end

return maps

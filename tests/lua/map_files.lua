-- Tests map files: this test writes each format from its specification and reads it back. Also tests units,
-- missing points, outliers, and broken files, which give errors with the name of the file, the expected and
-- the found value.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- which would only slow it down.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local warnings = require "archard.warnings"
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds
local abs, max, pack = math.abs, math.max, string.pack

local folder = os.tmpname()
os.remove(folder)
assert(os.execute("mkdir " .. folder))
local function path(name) return folder .. "/" .. name end

local function write(name, ...)
  local file <close> = assert(io.open(path(name), "wb"))
  assert(file:write(...))
  return path(name)
end

-- --- the test surface as rows of heights -------------------------------------------------------------------

local nx, nz, dx, dz = 7, 5, 0.01, 0.02 -- mm
local function height(x, z) return 1e-3 * (0.3 * x / dx - 0.2 * z / dz + 0.05 * x * z / (dx * dz)) end

-- Returns rows of integer heights in steps of `step` mm. The first row is at the largest z if `from_top` is
-- true, otherwise at the smallest z.
local function rows(step, from_top)
  local list = {}
  for j = 1, nz do
    local r, z = from_top and nz + 1 - j or j, (j - 1) * dz
    list[r] = {}
    for i = 1, nx do list[r][i] = height((i - 1) * dx, z) / step end
  end
  return list
end

local function packed(list, item, pad)
  local parts = {}
  for _, row in ipairs(list) do
    for _, value in ipairs(row) do
      parts[#parts + 1] = pack(item, item:find "[ih]" and math.floor(value + 0.5) or value)
    end
    parts[#parts + 1] = pad
  end
  return table.concat(parts)
end

local function worded(list, format)
  local lines = {}
  for r, row in ipairs(list) do
    local words = {}
    for i, value in ipairs(row) do words[i] = format:format(format:find "d" and math.floor(value + 0.5) or value) end
    lines[r] = table.concat(words, " ")
  end
  return table.concat(lines, "\n")
end

-- Checks that the map equals the surface; x0 and z0 are the coordinates of the map's corner.
local function same(t, tolerance, what, x0, z0)
  local most = t.size[1] == nx and t.size[2] == nz and 0 or 1
  for i, x in ipairs(most == 0 and t.x or {}) do
    most = max(most, abs(x - (x0 or 0) - (i - 1) * dx) / dx)
    for j, z in ipairs(t.z) do
      most = max(most, abs(z - (z0 or 0) - (j - 1) * dz) / dz)
      most = max(most, abs(t.y[(i - 1) * nz + j] - height((i - 1) * dx, (j - 1) * dz)) / 1e-3)
    end
  end
  if not ok(most <= tolerance, what) then tap.note(most) tap.note(t) end
end

-- --- text ---------------------------------------------------------------------------------------------------

local function xyz(head, scale_x, scale_y, order)
  local lines = {}
  for i = 1, nx do
    for j = 1, nz do
      local x, z = (i - 1) * dx, (j - 1) * dz
      lines[#lines + 1] = ("%.9g %.9g %.9g"):format(x * scale_x, z * scale_x, height(x, z) * scale_y)
    end
  end
  if order then table.sort(lines, order) end
  return head .. table.concat(lines, "\n") .. "\n"
end

same(map.read(write("a.xyz", xyz("", 1, 1)), { unit = "mm" }), 1e-6, ".xyz file in mm")
same(map.read(write("b.xyz", xyz("# made\n", 1000, 1e6)), { unit = { x = "um", y = "nm" } }), 1e-6,
  ".xyz file in um and nm")
same(map.read(write("c.xyz", xyz("x [um], y [um], z [nm]\n", 1000, 1e6, function(a, b) return a:reverse() < b:reverse() end))), 1e-6,
  ".xyz file with units in its header and points in any order")
same(map.read(write("m.txt", "# heights\n", worded(rows(1e-3), "%.7f"), "\n"), { step = { dx, dz }, unit = "um" }), 1e-6,
  "matrix of heights with given steps")
is(map.read(path "m.txt", { step = 0.5, unit = "um" }).z[2], 0.5, "one step for x and z")
for name, text in pairs{ tabs = "0,5\t0,25\t1\r\n1,5\t2\t3,25\r\n", blanks = " 0,5 0,25 1\n 1,5 2,0 3,25\n", semicolons = "0,5;0,25;1\n1,5;2;3,25\n",
  ["commas without blanks"] = "0.5,0.25,1\n1.5,2,3.25\n", ["commas with blanks"] = "0.5, 0.25, 1\n1.5, 2, 3.25\n" } do
  local m = map.read(write("decimal.txt", text), { step = 0.5, unit = "mm" })
  ok(#m.x == 3 and #m.z == 2 and m.y[1] == 0.5 and m.y[#m.y] == 3.25, "numbers between " .. name)
end
is(map.read(path "m.txt", { step = 0.5, unit = "um" }).path, path "m.txt",
  "a map contains the path of its file")

-- --- Surfer ---------------------------------------------------------------------------------------------------

local function dsaa(list, n1, n2)
  return ("DSAA\n%d %d\n%g %g\n%g %g\n0 1\n%s\n"):format(n1 or nx, n2 or nz, 1, 1 + (nx - 1) * dx, 2, 2 + (nz - 1) * dz,
    worded(list or rows(1e-3), "%.7f"))
end
local function dsbb(n1, n2, list)
  return "DSBB" .. pack("<i2i2dddddd", n1 or nx, n2 or nz, 1, 1 + (nx - 1) * dx, 2, 2 + (nz - 1) * dz, 0, 1)
    .. packed(list or rows(1e-3), "<f")
end
local function dsrb(version, list, rotation)
  local data = packed(list or rows(1e-3), "<d")
  return pack("<i4i4i4", 0x42525344, 4, version or 1) .. pack("<i4i4i4i4dddddddd", 0x44495247, 72, nz, nx, 1, 2, dx, dz, 0, 1,
    rotation or 0, 1.70141e38) .. pack("<i4i4", 0x41544144, #data) .. data
end
local mixed = { unit = { x = "mm", y = "um" } }
same(map.read(write("a.grd", dsaa()), mixed), 1e-6, "Surfer 6 text file", 1, 2)
same(map.read(write("b.grd", dsbb()), mixed), 1e-6, "Surfer 6 binary file", 1, 2)
same(map.read(write("c.grd", dsrb()), mixed), 1e-12, "Surfer 7 file", 1, 2)
local holed = rows(1e-3)
holed[2][3] = 1.70141e38
for name, text in pairs{ text = dsaa(holed), ["6"] = dsbb(nil, nil, holed), ["7"] = dsrb(2, holed) } do
  fails(function() map.read(write("hole.grd", text), mixed) end,
    { "hole.grd: expected a value at each point, 1 of 35 have none (the first at x = 1.02, z = 2.02 mm)", "fill = true" },
    "a point without a value, Surfer " .. name)
end
local filled = map.read(path "hole.grd", { unit = mixed.unit, fill = true })
near(filled:at(1.02, 2.02), height(0.02, 0.02), 1e-6, "a missing value is filled from its neighbours")
is(filled.missing, 1, "number of filled points")
is(map.read(path "hole.grd", { unit = mixed.unit, fill = 7 }):at(1.02, 2.02), 7,
  "a missing value is filled by a given height")
is(map.read(path "hole.grd", { unit = mixed.unit, crop = { x = { 1.025 } } }).missing, 0,
  "a missing value is cropped")

-- --- ISO 25178-71 ---------------------------------------------------------------------------------------------

local function sdf_text(changes, list, format, version)
  local lines = { version or "aISO-1.0" }
  local values = { ManufacID = "archard", CreateDate = "010120261200", ModDate = "010120261200", NumPoints = nx, NumProfiles = nz,
    Xscale = dx / 1000, Yscale = dz / 1000, Zscale = 1e-9, Zresolution = -1, Compression = 0, DataType = 7, CheckType = 0 }
  for name, value in pairs(changes or {}) do values[name] = value end
  for _, name in ipairs{ "ManufacID", "CreateDate", "ModDate", "NumPoints", "NumProfiles", "Xscale", "Yscale", "Zscale",
    "Zresolution", "Compression", "DataType", "CheckType" } do
    if values[name] ~= "none" then lines[#lines + 1] = ("%s = %s"):format(name, values[name]) end
  end
  return table.concat(lines, "\r\n") .. "\r\n*\r\n" .. worded(list or rows(1e-6), format or "%.5f") .. "\r\n*\r\nend\r\n*\r\n"
end
local function sdf_binary(kind, item, list, changes, version)
  local c = changes or {}
  return (version or "bISO-1.0") .. pack("c10c12c12", "archard", "010120261200", "010120261200")
    .. pack(version == "bISO-2.0" and "<I4I4" or "<I2I2", c.nx or nx, c.nz or nz)
    .. pack("<dddd", c.dx or dx / 1000, dz / 1000, 1e-9, -1) .. pack("BBB", c.compression or 0, kind, c.check or 0)
    .. packed(list or rows(1e-6), item)
end
same(map.read(write("a.sdf", sdf_text())), 1e-6, ".sdf text file")
same(map.read(write("b.sdf", sdf_text({ DataType = 5 }, nil, "%d", "aBCR-1.0"))), 1e-3,
  ".sdf text file of whole numbers, BCR version")
for kind, item in pairs{ [5] = "<i2", [6] = "<i4", [7] = "<d" } do
  same(map.read(write("c.sdf", sdf_binary(kind, item))), 1e-3, ".sdf binary file, number format " .. item)
end
same(map.read(write("d.sdf", sdf_binary(3, "<f", nil, nil, "bISO-2.0"))), 1e-6, ".sdf binary file, version 2")
holed = rows(1e-6)
holed[5][7] = -32768
is(map.read(write("hole.sdf", sdf_binary(5, "<i2", holed)), { fill = 0 }).missing, 1,
  "the smallest whole number is a missing value")
is(map.read(write("hole.sdf", (sdf_text({ DataType = 5 }, nil, "%d"):gsub("300", "BAD", 1))), { fill = 0 }).missing, 1, "BAD is a missing value")

-- --- Gwyddion, Digital Surf, Alicona -----------------------------------------------------------------------------

local function gsf(changes, list)
  local values = { XRes = nx, YRes = nz, XReal = nx * dx / 1000, YReal = nz * dz / 1000, XYUnits = "m", ZUnits = "m" }
  for name, value in pairs(changes or {}) do values[name] = value end
  local head = "Gwyddion Simple Field 1.0\n"
  for _, name in ipairs{ "XRes", "YRes", "XReal", "YReal", "XOffset", "YOffset", "XYUnits", "ZUnits", "Title" } do
    if values[name] and values[name] ~= "none" then head = head .. ("%s = %s\n"):format(name, values[name]) end
  end
  return head .. ("\0"):rep(4 - #head % 4) .. packed(list or rows(1e3, true), "<f")
end
same(map.read(write("a.gsf", gsf())), 1e-6, ".gsf", dx / 2, dz / 2)
for length = 0, 3 do
  same(map.read(write("b.gsf", gsf{ Title = ("t"):rep(length + 1) })), 1e-6,
    ".gsf header of any length", dx / 2, dz / 2)
end
is(map.read(path "b.gsf").name, "tttt", "the title of a .gsf file is the name of the map")
same(map.read(write("c.gsf", gsf({ XOffset = 1e-3, ZUnits = "um" }, rows(1e-3, true)))), 1e-6,
  ".gsf file with an offset, heights in um", 1 + dx / 2,
  dz / 2)
is(map.read(write("d.gsf", gsf({ ZUnits = "Pa" }, rows(1e-6, true)))).unit, "MPa",
  ".gsf file of pressures in Pa")

local function sur(changes, list)
  local c = changes or {}
  local item = (c.bits or 16) == 16 and "<i2" or "<i4"
  local head = pack("<c12i2i2i2i2c30c30", "DIGITAL SURF", 0, c.objects or 1, 1, c.kind or 2, "map", "archard") .. ("\0"):rep(6)
    .. pack("<i2i2c8i2i4i4i4i4i4", c.special or 0, 0, "", c.bits or 16, -1000, 3000, c.nx or nx, nz, nx * nz)
    .. pack("<fff", c.dx or dx, dz, 1e-6) .. pack("c16c16c16", "X", "Y", "Z") .. pack("c16c16c16", c.unit or "mm", "mm", "mm"):rep(2)
    .. pack("<fff", 1, 1, 1)
  head = head .. ("\0"):rep(334 - #head) .. pack("<I2I2", c.comment and #c.comment or 0, 0)
  head = head .. ("\0"):rep(466 - #head) .. pack("<fff", 0, 0, 0)
  return head .. ("\0"):rep(512 - #head) .. (c.comment or "") .. packed(list or rows(1e-6, true), item)
end
same(map.read(write("a.sur", sur())), 1e-3, ".sur")
same(map.read(write("b.sur", sur{ bits = 32, comment = "a scar" })), 1e-3,
  ".sur file of 32 bits with a comment")
holed = rows(1e-6, true)
holed[1][2] = -1002
near(map.read(write("hole.sur", sur({ special = 1 }, holed)), { fill = 0 }):at(dx, (nz - 1) * dz), 0, 1e-10,
  "missing value in a .sur file")

local function al3d(changes, list)
  local tags = { { "Cols", nx }, { "Rows", nz }, { "DepthImageOffset", 0 }, { "InvalidPixelValue", "1e10" },
    { "PixelSizeXMeter", dx / 1000 }, { "PixelSizeYMeter", dz / 1000 }, { "TextureImageOffset", 0 } }
  tags[3][2] = 17 + 52 * (#tags + 2) + 256
  local head = "AliconaImaging\0\r\n" .. pack("c20c30c2", "Version", "1", "\r\n") .. pack("c20c30c2", "TagCount",
    tostring(changes and changes.TagCount or #tags), "\r\n")
  for _, tag in ipairs(tags) do
    local value = changes and changes[tag[1]] or tag[2]
    if value ~= "none" then head = head .. pack("c20c30c2", tag[1], tostring(value), "\r\n") end
  end
  -- each row of 7 columns is padded to 32 bytes
  return head .. ("\0"):rep(254) .. "\r\n" .. packed(list or rows(1e3, true), "<f", "\0\0\0\0")
end
same(map.read(write("a.al3d", al3d())), 1e-6, ".al3d")
holed = rows(1e3, true)
holed[3][3] = 1e10
is(map.read(write("hole.al3d", al3d(nil, holed)), { fill = true }).missing, 1,
  "missing value in an .al3d file")

-- --- processing of points -------------------------------------------------------------------------------------

local function matrix(n, f)
  local lines = {}
  for j = 1, n do
    local words = {}
    for i = 1, n do words[i] = f(i, j) end
    lines[j] = table.concat(words, "\t")
  end
  return table.concat(lines, "\n")
end
local rough = write("rough.txt", matrix(40, function(i, j)
  return i == 20 and j == 30 and "5000" or abs(i - 10) < 4 and abs(j - 10) < 4 and "nan" or ("%.6f"):format(i + 0.1 * (i * 7 + j * 13) % 2)
end))
local t = map.read(rough, { step = 0.01, unit = "um", outliers = 20, fill = true })
is(t.outliers, 1, "number of outliers")
near(t:at(0.19, 0.29), 0.02, 0.1, "an outlier is replaced by the median of its neighbours")
is(t.missing, 49, "number of missing values in a hole")
near(t:at(0.09, 0.09), 0.011, 0.1, "a hole is filled from its neighbours")
holds(tostring(t), { "49 points without a value were filled", "1 outliers were replaced" }, "print")
local plane = write("plane.txt", matrix(30, function(i, j) return abs(i - 15) < 4 and abs(j - 12) < 4 and "---" or 3 * i - j end))
near(map.read(plane, { step = 0.01, unit = "um", fill = true }):at(0.14, 0.11), 0.033, 1e-6, "a hole in a plane is filled by the plane")
t = map.read(plane, { step = 0.01, unit = "um", fill = true, level = "plane" })
is(t.form, "plane", "levelled by map.read")
ok(max(t:volume().above, t:volume().below) < 1e-9, "a levelled plane is zero")

-- --- files written ----------------------------------------------------------------------------------------------

local function bytes(name)
  local file <close> = assert(io.open(path(name), "rb"))
  return file:read "a"
end

local own = { x = {}, z = {} }
for i = 1, nx do own.x[i] = -0.03 + (i - 1) * dx end
for j = 1, nz do own.z[j] = 0.5 + (j - 1) * dz end
own.y = function(x, z) return height(x + 0.03, z - 0.5) end
own = map(own)
is(export.gsf(own, path "own"), path "own.gsf", "export.gsf adds the extension")
same(map.read(path "own.gsf"), 1e-5, ".gsf file written and read", -0.03, 0.5)
local p = map.read(export.gsf(map{ x = { 0, 1 }, z = { 0, 2 }, y = { 1, 2, 3, 4 }, unit = "MPa", name = "pressure" }, path "p.gsf"))
is(p.unit .. p.name .. p:at(1, 0), "MPapressure3.0", ".gsf file of pressures written and read")
is(export.csv(own, path "own.csv"), path "own.csv", "export.csv returns the file name")
same(map.read(path "own.csv"), 1e-12, ".csv file written and read", -0.03, 0.5)
is(csv.read(path "own.csv").height[2], own.y[2], ".csv file of a map read by csv.read")
local twice = map{ x = own.x, z = own.z, y = function() return 7 end, name = "p < 8", unit = "MPa" }
is(export.vti({ own, twice }, path "own.vti"), path "own.vti", "export.vti returns the file name")
local text = bytes "own.vti"
holds(text, { '<ImageData WholeExtent="0 6 0 0 0 4" Origin="-0.03 0 0.5" Spacing="', '<DataArray type="Float64" Name="height" format="ascii">',
  'Name="p &lt; 8"' }, ".vti file with two maps and quoted names")
local values = {}
for word in text:match('Name="height"[^>]*>(.-)<'):gmatch "%S+" do values[#values + 1] = tonumber(word) end
is(#values, nx * nz, ".vti file with a value for each point")
do -- a name from a file of another program
  local named = map{ x = { 0, 1 }, z = { 0, 1 }, y = { 0, 1, 2, 3 }, name = "\27[31m\xB5" }
  export.vti(named, path "named.vti")
  ok(utf8.len(bytes "named.vti") and bytes("named.vti"):find('Name=" [31mµ"', 1, true), ".vti file with a name in Latin-1")
  ok(not tostring(named):find("\27", 1, true), "print of a map without control characters of its name")
end
local exact = true
for i = 1, nx do for j = 1, nz do exact = exact and values[(j - 1) * nx + i] == own.y[(i - 1) * nz + j] end end
ok(exact, ".vti values are ordered by x first, identical to the bit")
fails(function() export.vti({ own, own }, path "a.vti") end,
  'item 2: expected a unique name, got "height" again',
  "export.vti of two maps with the same name")
fails(function() export.vti({ own, p }, path "a.vti") end,
  "item 2: expected the points of the first map, got 2 x 2 other points",
  "export.vti of maps with different points")
fails(function() export.vti(3, path "a.vti") end, "or a list of maps, such as w:map(\"ball\") in 3-D, got 3",
  "export.vti of a number")
fails(function() export.vti(own, path "a.vtk") end,
  { "field 'path': expected a file name that ends in .vti", "a.vtk" },
  "export.vti with another extension")
fails(function() export.gsf({}, path "a.gsf") end, "export.gsf: expected a map, got a table",
  "export.gsf of a table")

-- --- wrong calls --------------------------------------------------------------------------------------------------

fails(function() map.read(path "a.xyz") end,
  { "field 'unit': expected the unit of heights", 'unit = { x = "mm", y = "um" }' }, "a file without units")
warnings.keep()
map.read(path "a.xyz", { unit = "nm" })
holds(warnings.take(), "as unit = \"nm\" is the unit of x and y, too", "a tiny map gives a warning")
fails(function() map.read(path "a.xyz", { unit = "furlong" }) end,
  'field \'unit\': expected "mm", "um", "nm", "cm", "m" or "in", got "furlong"',
  "an unknown unit")
fails(function() map.read(path "m.txt", { unit = "um" }) end,
  { "m.txt", "for a matrix of heights give step =" },
  "a matrix without steps")
fails(function() map.read(path "none.sdf") end, { "none.sdf", "No such file" }, "a missing file")
fails(function() map.read(path "a.xyz", { units = "mm" }) end, "unknown field 'units'", "an unknown field")
fails(function() map.read(3) end, "expected the path of a file, got 3", "a number instead of a path")

-- --- broken files ---------------------------------------------------------------------------------------------------

local whole = { xyz = xyz("", 1, 1), dsaa = dsaa(), dsbb = dsbb(), dsrb = dsrb(), sdfa = sdf_text(), sdfb = sdf_binary(7, "<d"),
  gsf = gsf(), sur = sur(), al3d = al3d() }
local broken = { -- each row: contents of a file, and a part of the error message
  { "", "expected a map, the file is empty" },
  { "\0\1\2\3", "got other bytes" },
  { "PK\3\4 and more", "got a zip archive, such as .x3p; save it as .sdf" },
  { "DSCOMPRESSED", "got a compressed .sur" },
  { "# nothing\n", "expected lines of numbers, got none" },
  { "1 2 3\n1 2\n", "line 2: expected three numbers x y z, got 2 words" },
  { "1 2 3\n1 two 3\n", "line 2: expected a number, got \"two\"" },
  { "1 2 3\n1 2 0x10\n", "line 2: expected a number, got \"0x10\"" },
  { "1 1 3\n1 2 3\n2 1 3\n1 1 4\n", "expected each point once, got x = 1, y = 1 twice" },
  { "1 1 3\n2 2 3\n3 3 3\n4 4 3\n5 5 3\n", "expected points of a rectangular grid, got 5 points with 5 different x and 5 different y" },
  { "1 1 3\n2 1 3\n3.5 1 3\n1 2 3\n2 2 3\n3.5 2 3\n", "expected even steps of x, got 2 after 1" },
  { "1 1 3\n2 1 3\n3 1 3\n", "got 1 value of y" },
  { "1 1 1e999\n2 1 3\n", "expected a finite number, got inf" },
  { "x [um], y [mm], z [um]\n1 1 1\n", "expected units of x, y and z, one for x and y" },
  { whole.dsaa:gsub("7 5", "7 500"), "expected 7 x 500 values" },
  { whole.dsaa:gsub("7 5", "7 1"), "expected the number of rows, a whole number >= 2, got 1" },
  { whole.dsaa:gsub("%s*%S+%s*$", ""), "point 7 of row 5: expected a number, got the file's end" },
  { whole.dsaa:gsub("7 5", "7 five"), "expected the number of rows, got \"five\"" },
  { dsaa():gsub("1 1.06", "1 0.9"), "expected increasing x, got 1 to 0.9" },
  { whole.dsbb:sub(1, 40), "expected the limits of x, y and z at bytes 9 to 56, the file has 40" },
  { whole.dsbb:sub(1, -2), "expected 7 x 5 values of 4 bytes, 140 bytes after a header of 56, got 139" },
  { dsbb(32767, 32767), "expected 32767 x 32767 values" },
  { dsbb(-7, 5), "expected the number of columns, a whole number >= 2, got -7" },
  { whole.dsrb:sub(1, 12) .. pack("<i4i4", 1, -8), "expected the size of a section, got -8" },
  { whole.dsrb:sub(1, 12), "expected the grid section" },
  { dsrb(9), "expected version 1 or 2, got 9" },
  { dsrb(1, nil, 30), "expected a grid without rotation, got rotation 30" },
  { sdf_text{ NumPoints = 0 }, "expected NumPoints, a whole number >= 2, got 0" },
  { sdf_text{ NumPoints = 1e6 // 1 | 0, NumProfiles = 1e6 // 1 | 0 }, "expected 1000000 x 1000000 values" },
  { sdf_text{ Xscale = "none" }, "expected Xscale > 0, got nil" },
  { sdf_text{ Compression = 1 }, "data without compression and check sums, got Compression = 1" },
  { sdf_text{ DataType = 11 }, "expected DataType 0 to 7, got 11" },
  { whole.sdfa:gsub("%*", "+"), "expected a header that ends in a line '*', got the file's end" },
  { whole.sdfa:gsub("300.00000", "wide"), "expected a number, got \"wide\"" },
  { whole.sdfb:sub(1, 60), "expected the scales" },
  { whole.sdfb:sub(1, -3), "got 278" },
  { sdf_binary(7, "<d", nil, { dx = 0 / 0 }), "expected Xscale > 0, got nan" },
  { sdf_binary(7, "<d", nil, { check = 2 }), "got CheckType = 2" },
  { sdf_binary(5, "<i2", nil, { nx = 65535, nz = 65535 }), "expected 65535 x 65535 values of 2 bytes" },
  { gsf{ XRes = "seven" }, "expected XRes, a whole number >= 2, got nil" },
  { gsf{ XRes = 1e9 // 1 | 0 }, "expected 1000000000 x 5 values" },
  { gsf{ XReal = -1 }, "expected XReal > 0, got -1" },
  { gsf{ ZUnits = "V" }, "expected z in a unit of length, got \"V\"" },
  { gsf{ XOffset = "left" }, "expected a number, got XOffset = \"left\"" },
  { (whole.gsf:gsub("%z", "1")), "expected a zero byte at the end of the header, got none" },
  { whole.gsf:sub(1, -2), "140 bytes after a header of 1" },
  { whole.gsf:gsub("YRes = 5", "YRes 5"), "expected lines name = value, got \"YRes 5\"" },
  { whole.sur:sub(1, 300), "expected the length of the comment" },
  { sur{ objects = 3 }, "expected one surface, got 3 of a surface" },
  { sur{ kind = 5 }, "expected one surface, got 1 of a series of surfaces" },
  { sur{ bits = 24 }, "expected points of 16 or 32 bits, got 24" },
  { sur{ nx = 2147483647 }, "expected 2147483647 x 5 values of 2 bytes" },
  { sur{ dx = 0 }, "expected the step of x > 0, got 0.0" },
  { sur{ unit = "" }, "expected one unit of x and y, got \"\" and \"mm\"" },
  { whole.al3d:sub(1, 100), "expected the value of a tag" },
  { al3d{ TagCount = 99999 }, "expected TagCount, at most" },
  { al3d{ TagCount = 9 }, "expected a line end after tag" },
  { al3d{ Rows = 4000 }, "expected 7 x 4000 values" },
  { al3d{ Cols = "many" }, "expected a whole number, got Cols = \"many\"" },
  { al3d{ DepthImageOffset = -4 }, "expected DepthImageOffset in" },
  { al3d{ PixelSizeXMeter = 0 }, "expected PixelSizeXMeter > 0, got 0" },
}
for i, case in ipairs(broken) do
  local name = write("broken.bin", case[1])
  fails(function() map.read(name, { unit = "um" }) end, { "map.read: ", name .. ": ", case[2] }, ("broken %d: %s"):format(i, case[2]))
end

-- Tests that a changed or truncated file gives a map or an error that names the file, never an internal
-- error.
math.randomseed(7)
local strange = 0
for name, text in pairs(whole) do
  for trial = 1, 120 do
    local at = math.random(trial % 2 == 0 and math.min(#text, 700) or #text)
    local changed = trial % 3 == 0 and text:sub(1, at - 1) or text:sub(1, at - 1) .. string.char(math.random(0, 255)) .. text:sub(at + 1)
    local fine, err = pcall(map.read, write("fuzz.bin", changed), { unit = "um", fill = true })
    if not fine and (type(err) ~= "table" or err.where ~= "map.read" or tostring(err):find "scripts/") then
      strange = strange + 1
      tap.note(name .. ": " .. tostring(err))
    end
  end
end
is(strange, 0, "a changed or truncated file gives a map or an error of map.read")

os.execute("rm -r " .. folder)

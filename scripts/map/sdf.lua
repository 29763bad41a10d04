-- Reads surface data files (ISO 25178-71), text or binary: version 1.0, its predecessor BCR-1.0, and
-- version 2.0. Lengths are in metres. Rows start at the smallest y.

local axis = require "archard.map.axis"

-- Format of a binary number and the value that marks a missing point, for each DataType of the file.
local types = { [0] = { "<I1" }, { "<I2", 65535 }, { "<I4", 4294967295 }, { "<f" }, { "<i1" }, { "<i2", -32768 },
  { "<i4", -2147483648 }, { "<d" } }

local names = { "ManufacID", "CreateDate", "ModDate", "NumPoints", "NumProfiles", "Xscale", "Yscale", "Zscale",
  "Zresolution", "Compression", "DataType", "CheckType" }

local function binary_header(source, version)
  local count = version == "ISO-2.0" and "<I4I4" or "<I2I2"
  local header = {}
  source:take("c10c12c12", "the manufacturer and two dates")
  header.NumPoints, header.NumProfiles = source:take(count, "the number of points and profiles")
  header.Xscale, header.Yscale, header.Zscale = source:take("<dddd", "the scales")
  header.Compression, header.DataType, header.CheckType = source:take("BBB", "the type of data")
  return header
end

-- Reads the header lines "name = value" up to a line with a star.
local function text_header(source)
  local header, known = {}, {}
  for _, name in ipairs(names) do known[name:lower()] = name end
  while true do
    local line, after = source.text:match("^([^\n]*)\n()", source.at)
    if not line then source:refuse "expected a header that ends in a line '*', got the file's end" end
    source.at = after
    if line:find "^%s*%*" then return header end
    local name, value = line:match "^%s*(%a+)%s*=%s*(.-)%s*$"
    if name and known[name:lower()] then
      value = source.number(value) or value
      header[known[name:lower()]] = math.tointeger(value) or value
    end
  end
end

local function checked(source, header)
  for _, name in ipairs{ "Compression", "CheckType" } do
    if header[name] and header[name] ~= 0 then
      source:refuse("expected data without compression and check sums, got %s = %s", name, tostring(header[name]))
    end
  end
  if not types[header.DataType] then source:refuse("expected DataType 0 to 7, got %s", tostring(header.DataType)) end
  for _, name in ipairs{ "Xscale", "Yscale", "Zscale" } do source:positive(header[name], name) end
  return source:count(header.NumPoints, "NumPoints"), source:count(header.NumProfiles, "NumProfiles")
end

-- Reads a surface data file. magic: the first bytes of the file, such as "aISO-1.0"; "a" means text, "b"
-- binary.
return function(source, magic)
  local version, is_text = magic:sub(2), magic:sub(1, 1) == "a"
  source.at = 9
  local header = (is_text and text_header or binary_header)(source, version)
  local nx, nz = checked(source, header)
  local item, none = table.unpack(types[header.DataType])
  local options = { bad = "BAD", is_missing = function(value)
    return value ~= value or value == none or math.abs(value) > 1e300
  end }
  local y = is_text and source:words(nx, nz, options) or source:grid(nx, nz, item, options)
  for k = 1, #y do y[k] = y[k] * header.Zscale end
  return { x = axis.even(0, header.Xscale, nx), z = axis.even(0, header.Yscale, nz), y = y, unit_x = "m", unit_y = "m" }
end

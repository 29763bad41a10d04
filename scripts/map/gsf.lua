-- Reads and writes Gwyddion Simple Field files. Such a file has header lines "name = value", zero bytes up
-- to a multiple of four, and single-precision numbers by rows from the top. Units have no prefix; points
-- are in the middle of cells.

local axis = require "archard.map.axis"
local files = require "archard.files"

local gsf = { magic = "Gwyddion Simple Field 1.0\n" }

local function is_missing(value) return value ~= value end

local function header_of(source)
  local header, stop = {}, source.text:find("\0", 1, true)
  if not stop then source:refuse "expected a zero byte at the end of the header, got none" end
  for line in source.text:sub(#gsf.magic + 1, stop - 1):gmatch "[^\n]+" do
    local name, value = line:match "^%s*([%w_]+)%s*=%s*(.-)%s*$"
    if not name then source:refuse("expected lines name = value, got %q", line) end
    header[name] = value
  end
  source.at = stop + 4 - (stop - 1) % 4
  return header
end

local function whole(source, header, name)
  return source:count(math.tointeger(source.number(header[name])), name)
end

local function real(source, header, name, or_else)
  if header[name] == nil then return or_else end
  return source.number(header[name]) or source:refuse("expected a number, got %s = %q", name, header[name])
end

function gsf.read(source)
  local header = header_of(source)
  local nx, nz = whole(source, header, "XRes"), whole(source, header, "YRes")
  local dx = source:positive(real(source, header, "XReal", 1), "XReal") / nx
  local dz = source:positive(real(source, header, "YReal", 1), "YReal") / nz
  local y = source:grid(nx, nz, "<f", { from_top = true, is_missing = is_missing })
  return { x = axis.even(real(source, header, "XOffset", 0) + dx / 2, dx, nx),
    z = axis.even(real(source, header, "YOffset", 0) + dz / 2, dz, nz), y = y, unit_x = header.XYUnits,
    unit_y = header.ZUnits, name = header.Title }
end

-- Returns the content of a .gsf file for a map. Lengths are converted to m and pressures to Pa.
function gsf.text(t)
  local nx, nz, dx, dz = #t.x, #t.z, axis.step(t.x) / 1000, axis.step(t.z) / 1000
  local pressure = t.unit == "MPa"
  local scale = pressure and 1e6 or t.unit == "mm" and 1e-3 or 1
  local lines = { gsf.magic .. "XRes = " .. nx, "YRes = " .. nz, "XReal = " .. files.number(nx * dx),
    "YReal = " .. files.number(nz * dz), "XOffset = " .. files.number(t.x[1] / 1000 - dx / 2),
    "YOffset = " .. files.number(t.z[1] / 1000 - dz / 2), "XYUnits = m",
    "ZUnits = " .. (pressure and "Pa" or t.unit == "mm" and "m" or t.unit:gsub("%c", " ")),
    "Title = " .. t.name:gsub("%c", " "), "" }
  local header = table.concat(lines, "\n")
  local rows, row = { header .. ("\0"):rep(4 - #header % 4) }, {}
  for j = nz, 1, -1 do
    for i = 1, nx do row[i] = string.pack("<f", t.y[(i - 1) * nz + j] * scale) end
    rows[#rows + 1] = table.concat(row)
  end
  return table.concat(rows)
end

return gsf

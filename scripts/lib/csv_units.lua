-- Reads the unit after the name of a column, as in "h [um]" or "h (um)", and converts numbers to mm, N,
-- MPa, s and degrees.

local keys = require "archard.lib.keys"
local merged = require "archard.lib.merged"

local larger = { mm = 1, cm = 10, m = 1000, km = 1e6, ["in"] = 25.4, inch = 25.4, N = 1, kN = 1000, MPa = 1, ["N/mm2"] = 1, GPa = 1000, s = 1,
  min = 60, h = 3600, mm2 = 1, mm3 = 1, cm3 = 1000, m3 = 1e9, ["mm2/N"] = 1, ["N mm"] = 1, J = 1000, ["m2/N"] = 1e6, ["1/MPa"] = 1, cycles = 1, ["-"] = 1,
  deg = 1, degree = 1, degrees = 1, ["°"] = 1, rad = 180 / math.pi }
-- Divisors for smaller units. Division by 1000 is more accurate than multiplication by 0.001, which is not
-- an exact floating-point number.
local smaller = { um = 1000, ["µm"] = 1000, ["μm"] = 1000, nm = 1e6, mN = 1000, kPa = 1000, Pa = 1e6, ms = 1000,
  um3 = 1e9, ["mm3/(N m)"] = 1000, ["mm3/Nm"] = 1000, ["%"] = 100 }

local units = {}

-- Returns the name and the unit of a header: "h" and "um" for "h [um]". For a header without a unit, only
-- the header is returned.
function units.split(header)
  local name, unit = header:match("^(.-)%s*%[%s*(.-)%s*%]$")
  if not name then name, unit = header:match("^(.-)%s*%(%s*(.-)%s*%)$") end
  if not name or name == "" then return header end
  return name, unit
end

-- Converts the powers m^3, m³ and m**3 to m3.
local function plain(unit)
  return (unit:gsub("%*%*(%d)", "%1"):gsub("%^(%d)", "%1"):gsub("²", "2"):gsub("³", "3"))
end

function units.known(unit) return (larger[plain(unit)] or smaller[plain(unit)]) ~= nil end

-- Converts a number from `unit`, which must be known, to mm, N, MPa, s or degrees.
function units.scaled(value, unit)
  unit = plain(unit)
  return larger[unit] and value * larger[unit] or value / smaller[unit]
end

function units.list()
  return table.concat(keys(merged(larger, smaller)), ", ")
end

return units

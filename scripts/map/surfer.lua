-- Reads Surfer grids of Golden Software: text (DSAA), Surfer 6 (DSBB) and Surfer 7 (DSRB). Rows start at
-- the smallest y. The files contain no units.

local axis = require "archard.map.axis"

local surfer = {}

local blank = 1.70141e38

local function is_blank(value) return not (value < blank * (1 - 1e-6)) end

local function points(source, name, low, high, count)
  if not (high > low and high - low < math.huge) then
    source:refuse("expected increasing %s, got %g to %g", name, low, high)
  end
  return axis.even(low, (high - low) / (count - 1), count)
end

local function header_word(source, pattern, what)
  local first, last = source.text:find("%S+", source.at)
  local word = first and source.text:sub(first, last)
  local value = source.number(word)
  if not value or not word:find(pattern) then
    source:refuse("expected %s, got %s", what, word and ("%q"):format(word) or "the file's end")
  end
  source.at = last + 1
  return value
end

function surfer.DSAA(source)
  source.at = 5
  local function whole(what) return source:count(math.tointeger(header_word(source, "^%d+$", what)), what) end
  local function number(what) return header_word(source, "", what) end
  local nx, nz = whole "the number of columns", whole "the number of rows"
  local x0, x1, z0, z1 = number "the smallest x", number "the largest x", number "the smallest y", number "the largest y"
  number "the smallest z"
  number "the largest z"
  local y = source:words(nx, nz, { is_missing = is_blank })
  return { x = points(source, "x", x0, x1, nx), z = points(source, "y", z0, z1, nz), y = y }
end

function surfer.DSBB(source)
  source.at = 5
  local nx, nz = source:take("<i2i2", "the number of columns and rows")
  local x0, x1, z0, z1 = source:take("<dddddd", "the limits of x, y and z")
  source:count(nx, "the number of columns")
  source:count(nz, "the number of rows")
  local y = source:grid(nx, nz, "<f", { is_missing = is_blank })
  return { x = points(source, "x", x0, x1, nx), z = points(source, "y", z0, z1, nz), y = y }
end

local sections = { header = 0x42525344, grid = 0x44495247, data = 0x41544144 }

-- Moves the reading position to the section `name` of the file. Returns the size of the section in bytes.
local function go_to(source, name)
  while true do
    local id, size = source:take("<i4i4", ("the %s section"):format(name))
    if id == sections[name] then return size end
    if size < 0 then source:refuse("expected the size of a section, got %d", size) end
    source.at = source.at + size
  end
end

function surfer.DSRB(source)
  local size = go_to(source, "header")
  local version = source:take("<i4", "the version")
  if version ~= 1 and version ~= 2 then source:refuse("expected version 1 or 2, got %d", version) end
  source.at = source.at + math.max(0, size - 4)
  go_to(source, "grid")
  local nz, nx = source:take("<i4i4", "the number of rows and columns")
  local x0, z0, dx, dz, _, _, rotation, no_value = source:take("<dddddddd", "the grid")
  if rotation ~= 0 then source:refuse("expected a grid without rotation, got rotation %g", rotation) end
  go_to(source, "data")
  local y = source:grid(source:count(nx, "the number of columns"), source:count(nz, "the number of rows"), "<d",
    { is_missing = function(value)
      return value ~= value or value == no_value or version == 1 and value >= no_value
    end })
  return { x = axis.even(x0, source:positive(dx, "the step of x"), nx),
    z = axis.even(z0, source:positive(dz, "the step of y"), nz), y = y }
end

return surfer

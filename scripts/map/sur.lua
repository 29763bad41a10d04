-- Reads uncompressed .sur files of Digital Surf. Such a file has a header of 512 bytes, then integers by
-- rows from the top. A height is the integer times a step.

local axis = require "archard.map.axis"

local function unit_of(source, text, what)
  text = text:gsub("^\xB5", "u") -- µ in Latin-1
  if text == "" then source:refuse("expected the unit of %s, got none", what) end
  return text
end

local kinds = { [1] = "one profile", [2] = "a surface", [3] = "a binary image", [4] = "a series of profiles",
  [5] = "a series of surfaces" }

-- Reads the part of the header from the name of the object to the number of points.
local function sizes(source, order)
  source:take("c60c6", "the names of object and operator")
  local special, _ = source:take(order .. "i2i2c8", "the special points")
  local bits, low, high, nx, nz = source:take(order .. "i2i4i4i4i4", "the size")
  source:take(order .. "i4", "the number of points")
  if bits ~= 16 and bits ~= 32 then source:refuse("expected points of 16 or 32 bits, got %d", bits) end
  return special, bits, low, high, source:count(nx, "the points of a line"), source:count(nz, "the number of lines")
end

local function scales(source, order)
  local dx, dz, dy = source:take(order .. "fff", "the steps of x, y and z")
  source:take("c48", "the names of axes")
  local unit_x, unit_z, unit_y = source:take_text(16, "a unit"), source:take_text(16, "a unit"), source:take_text(16, "a unit")
  if unit_x ~= unit_z then source:refuse("expected one unit of x and y, got %q and %q", unit_x, unit_z) end
  return { dx = source:positive(dx, "the step of x"), dz = source:positive(dz, "the step of y"),
    dy = source:positive(dy, "the step of z"), unit_x = unit_of(source, unit_x, "x"), unit_y = unit_of(source, unit_y, "z") }
end

-- Returns the offsets of x, z and y from the header, and moves the reading position to the first point.
local function offsets(source, order)
  source.at = 335
  local comment, private = source:take(order .. "I2I2", "the length of the comment")
  source.at = 467
  local x, z, y = source:take(order .. "fff", "the offsets")
  source.at = 513 + comment + private
  return x, z, y
end

return function(source)
  source.at = 13
  local order = source:take("<i2", "the byte order") == 0 and "<" or ">"
  local objects, _, kind = source:take(order .. "i2i2i2", "the kind of object")
  if kind ~= 2 and kind ~= 1 or objects > 1 then -- some programs write surfaces as profiles of several lines
    source:refuse("expected one surface, got %d of %s", objects, kinds[kind] or ("kind %d"):format(kind))
  end
  local special, bits, low, high, nx, nz = sizes(source, order)
  local scale = scales(source, order)
  local x0, z0, y0 = offsets(source, order)
  local y = source:grid(nx, nz, order .. (bits == 16 and "i2" or "i4"), { from_top = true, is_missing = function(value)
    return special == 1 and (value < low or value > high)
  end })
  for k = 1, #y do y[k] = y[k] * scale.dy + y0 end
  return { x = axis.even(x0, scale.dx, nx), z = axis.even(z0, scale.dz, nz), y = y, unit_x = scale.unit_x,
    unit_y = scale.unit_y }
end

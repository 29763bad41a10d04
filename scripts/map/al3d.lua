-- Reads .al3d files of Alicona Imaging. Such a file has tags of 52 bytes, then a depth image of
-- single-precision numbers in metres. The image is stored by rows from the top; each row is padded to a
-- multiple of eight bytes.

local axis = require "archard.map.axis"

local al3d = { magic = "AliconaImaging\0\r\n" }

local function take_tag(source, tags)
  local name = source:take_text(20, "the name of a tag")
  local value = source:take_text(30, "the value of a tag")
  if source:take("c2", "the end of a tag") ~= "\r\n" then
    source:refuse("expected a line end after tag %q", name)
  end
  tags[name] = value
end

local function number(source, tags, name, what)
  if not tags[name] then source:refuse("expected a tag %s, got none", name) end
  return source.number(tags[name]) or source:refuse("expected %s, got %s = %q", what, name, tags[name])
end

local function whole(source, tags, name)
  return math.tointeger(number(source, tags, name, "a whole number"))
end

function al3d.read(source)
  local tags = {}
  source.at = #al3d.magic + 1
  take_tag(source, tags)
  take_tag(source, tags)
  local count = whole(source, tags, "TagCount")
  if not count or count < 0 or count > #source.text // 52 then
    source:refuse("expected TagCount, at most %d in a file of %d bytes, got %q", #source.text // 52, #source.text, tags.TagCount)
  end
  for _ = 1, count do take_tag(source, tags) end
  local nx, nz = source:count(whole(source, tags, "Cols"), "Cols"), source:count(whole(source, tags, "Rows"), "Rows")
  local dx = source:positive(number(source, tags, "PixelSizeXMeter", "a length"), "PixelSizeXMeter")
  local dz = source:positive(number(source, tags, "PixelSizeYMeter", "a length"), "PixelSizeYMeter")
  local offset = whole(source, tags, "DepthImageOffset")
  if not offset or offset < source.at - 1 or offset > #source.text then
    source:refuse("expected DepthImageOffset in [%d, %d], got %q", source.at - 1, #source.text, tags.DepthImageOffset)
  end
  local none = source.number(tags.InvalidPixelValue)
  none = none and string.unpack("<f", string.pack("<f", none))
  source.at = offset + 1
  local y = source:grid(nx, nz, "<f", { from_top = true, row = (4 * nx + 7) // 8 * 8, is_missing = function(value)
    return value ~= value or value == none
  end })
  return { x = axis.even(0, dx, nx), z = axis.even(0, dz, nz), y = y, unit_x = "m", unit_y = "m" }
end

return al3d

-- Reads the bytes of a map file in order, reads grids of values, and raises errors with the name of the file.
-- Sizes from a header are compared with the size of the file before memory is allocated.

local check = require "archard.lib.check"
local files = require "archard.files"

local source = {}
source.__index = source

local missing = 0 / 0
source.missing = missing -- value of a missing point

function source.open(where, path)
  return setmetatable({ where = where, path = path, text = files.read(where, path), at = 1 }, source)
end

-- Raises an error with the name of the file.
function source:refuse(message, ...)
  check.fail(self.where, ("%s: %s"):format(self.path, message:format(...)), "FORMAT")
end

function source:starts_with(text) return self.text:sub(1, #text) == text end

-- Reads the next values in a format of string.unpack. what: name of the values in errors.
function source:take(format, what)
  local size = string.packsize(format)
  if #self.text < self.at + size - 1 then
    self:refuse("expected %s at bytes %d to %d, the file has %d", what, self.at, self.at + size - 1, #self.text)
  end
  local values = table.pack(string.unpack(format, self.text, self.at))
  self.at = values[values.n]
  return table.unpack(values, 1, values.n - 1)
end

-- Returns the text in the next `size` bytes, up to a zero byte, without blanks at both ends.
function source:take_text(size, what)
  return (self:take("c" .. size, what):match("^[^\0]*"):match("^%s*(.-)%s*$"))
end

-- Checks and returns a number of points from a header.
function source:count(value, what)
  if not (math.type(value) == "integer" and value >= 2) then
    self:refuse("expected %s, a whole number >= 2, got %s", what, tostring(value))
  end
  return value
end

-- Checks and returns a step or a scale from a header, which must be > 0.
function source:positive(value, what)
  if not (type(value) == "number" and value > 0 and value < math.huge) then
    self:refuse("expected %s > 0, got %s", what, value ~= value and "nan" or tostring(value))
  end
  return value
end

-- Returns the number that a text contains, or nil if the text is not a number.
function source.number(word)
  if not word or not word:find "^[+-]?[%d.]" or word:find "^[+-]?0[xX]" then return nil end
  local value = tonumber(word)
  return value and value + 0.0
end

-- Raises an error if the rest of the file is too small for nz rows of nx values. size: bytes of a value;
-- row: bytes from one row to the next.
function source:check_size(nx, nz, size, row)
  local needed, left = row * (nz - 1) + size * nx, #self.text - self.at + 1
  if needed > left then
    self:refuse("expected %d x %d values of %d bytes, %d bytes after a header of %d, got %d", nx, nz, size, needed,
      self.at - 1, left)
  end
end

-- Returns `value`, a finite number or NaN (missing). An infinite value is an error; the message states the
-- point i and the row j.
function source:checked(value, i, j)
  if value == math.huge or value == -math.huge then
    self:refuse("point %d of row %d: expected a finite number, got %g", i, j, value)
  end
  return value
end

-- The functions grid and words check nx and nz against the size of the file. Callers therefore make the
-- lists of x and z only after reading the values.

-- Reads nz rows of nx values in the binary format `item` and returns a flat list in which the
-- value at x[i], z[j] is number (i - 1) * nz + j. options.from_top: true if rows start at the largest z; options.row: bytes from one row to the next;
-- options.is_missing(value): true for a missing value.
function source:grid(nx, nz, item, options)
  local size, y, from = string.packsize(item), {}, self.at
  local row = options.row or size * nx
  self:check_size(nx, nz, size, row)
  for i = 1, nx * nz do y[i] = missing end
  for r = 1, nz do
    local j, at = options.from_top and nz + 1 - r or r, from + (r - 1) * row
    for i = 1, nx do
      local value
      value, at = string.unpack(item, self.text, at)
      if not options.is_missing(value) then y[(i - 1) * nz + j] = self:checked(value + 0.0, i, r) end
    end
  end
  return y
end

-- Reads nz rows of nx values, separated by blanks, from the position self.at of the text on. Returns a flat
-- list in the order of source:grid. options.bad: word for a missing value; options.is_missing(value): true
-- for a missing value. Text after the last value is ignored.
function source:words(nx, nz, options)
  local left = #self.text - self.at + 1
  if nx * nz > (left + 1) // 2 then -- a value needs at least a digit and a blank
    self:refuse("expected %d x %d values, got only %d bytes of text", nx, nz, left)
  end
  local next_word, y = self.text:gmatch("%S+", self.at), {}
  for i = 1, nx * nz do y[i] = missing end
  for j = 1, nz do
    for i = 1, nx do
      local word = next_word()
      local value = source.number(word) or word and word == options.bad and missing
      if not value then
        self:refuse("point %d of row %d: expected a number, got %s", i, j, word and ("%q"):format(word) or "the file's end")
      end
      if not options.is_missing(value) then y[(i - 1) * nz + j] = self:checked(value, i, j) end
    end
  end
  return y
end

return source

-- What a user hands to a plot function, checked: names with the nearest known one, kinds of values.
-- Errors are those of every class, placed where the user's own text called. Leans on
-- archard.gnuplot for the error objects.

local gnuplot = require "archard.gnuplot"

local check = {}

-- "file:line: " of the first caller outside the program's own scripts.
local function user_position()
  local level = 2
  local info = debug.getinfo(level, "Sl")
  while info and info.source:find("^@scripts/") do
    level = level + 1
    info = debug.getinfo(level, "Sl")
  end
  return info and info.currentline > 0 and ("%s:%d: "):format(info.short_src, info.currentline)
    or ""
end

-- Raises an error object; the code is a status name, "ARGUMENT" where left out.
function check.fail(where, message, code)
  local _, object = pcall(gnuplot.raise, where, code or "ARGUMENT", (message:gsub("%z", " ")))
  if type(object) == "table" then object.position = user_position() end
  error(object, 0)
end

-- How far two names are apart: insertions, deletions, changes, neighbours swapped.
local function distance(a, b)
  local before, row
  local last = {}
  for j = 0, #b do last[j] = j end
  for i = 1, #a do
    row = { [0] = i }
    for j = 1, #b do
      local cost = a:byte(i) == b:byte(j) and 0 or 1
      row[j] = math.min(last[j - 1] + cost, last[j] + 1, row[j - 1] + 1)
      if before and j > 1 and a:byte(i) == b:byte(j - 1) and a:byte(i - 1) == b:byte(j) then
        row[j] = math.min(row[j], before[j - 2] + 1)
      end
    end
    before, last = last, row
  end
  return last[#b]
end

-- " (did you mean 'title'?)", or the list of what is known.
function check.hint(name, known)
  local best, least = nil, 1 + #name // 3
  local sorted = {}
  for _, word in ipairs(known) do sorted[#sorted + 1] = word end
  table.sort(sorted)
  for _, word in ipairs(sorted) do
    local apart = distance(name, word)
    if apart < least or (apart == least and not best) then best, least = word, apart end
  end
  if best then return (" (did you mean '%s'?)"):format(best) end
  return (" (known: %s)"):format(table.concat(sorted, ", "))
end

-- A value in a message: "dumb", 3, a wear object, a table.
function check.shown(value)
  if type(value) == "string" then return ('"%s"'):format(value) end
  if type(value) == "number" or type(value) == "boolean" then return tostring(value) end
  if value == nil then return "nil" end
  local class = type(value) == "userdata" and (debug.getmetatable(value) or {}).__name
  class = type(class) == "string" and class:match("^archard%.(.*)") or class
  return type(class) == "string" and ("a %s object"):format(class) or "a " .. type(value)
end

-- --- kinds of values: { test, what is expected } ----------------------------------------------

local function kind(expected, test) return { expected = expected, test = test } end

local function finite(value)
  return type(value) == "number" and value == value and math.abs(value) < math.huge
end

check.text = kind("a string", function(v) return type(v) == "string" end)
check.flag = kind("true or false", function(v) return type(v) == "boolean" end)
check.number = kind("a finite number", finite)
check.positive = kind("a number > 0", function(v) return finite(v) and v > 0 end)
check.list = kind("a list of numbers", function(v)
  return type(v) == "table" or type(v) == "userdata"
end)
check.table = kind("a table", function(v) return type(v) == "table" end)
check.count = kind("a whole number from 1 to 100000", function(v)
  return math.type(v) and v >= 1 and v <= 100000 and v == math.floor(v)
end)
check.range = kind("{ low, high }, two different finite numbers, or one of them", function(v)
  if type(v) ~= "table" or (v[1] == nil and v[2] == nil) then return false end
  return (v[1] == nil or finite(v[1])) and (v[2] == nil or finite(v[2])) and v[1] ~= v[2]
end)
check.size = kind("{ width, height }, two whole numbers from 10 to 20000", function(v)
  if type(v) ~= "table" then return false end
  for i = 1, 2 do
    if not (finite(v[i]) and v[i] >= 10 and v[i] <= 20000 and v[i] % 1 == 0) then return false end
  end
  return true
end)
check.grid = kind("{ rows, columns }, two whole numbers from 1 to 50", function(v)
  if type(v) ~= "table" then return false end
  for i = 1, 2 do
    if not (finite(v[i]) and v[i] >= 1 and v[i] <= 50 and v[i] % 1 == 0) then return false end
  end
  return true
end)
check.box = kind("{ x0, x1, y0, y1 }", function(v)
  return type(v) == "table" and finite(v[1]) and finite(v[2]) and finite(v[3]) and finite(v[4])
    and v[1] < v[2] and v[3] < v[4]
end)

-- One of these words; `also` is a kind whose values are taken too.
function check.one_of(words, also)
  local quoted = {}
  for i, word in ipairs(words) do quoted[i] = '"' .. word .. '"' end
  local expected = table.concat(quoted, ", ") .. (also and ", or " .. also.expected or "")
  return kind(expected, function(v)
    for _, word in ipairs(words) do
      if v == word then return true end
    end
    return also ~= nil and also.test(v)
  end)
end

-- Every named field of `given` must be in `fields` (name = kind). List items are the caller's.
function check.fields(where, given, fields, prefix)
  prefix = prefix or ""
  for name, value in pairs(given) do
    if type(name) == "string" then
      local wanted = fields[name]
      if not wanted then
        local known = {}
        for word in pairs(fields) do known[#known + 1] = word end
        check.fail(where, ("unknown field '%s%s'%s"):format(prefix, name, check.hint(name, known)))
      elseif not wanted.test(value) then
        check.fail(where, ("field '%s%s': expected %s, got %s"):format(prefix, name,
          wanted.expected, check.shown(value)))
      end
    end
  end
  return given
end

return check

-- What a user hands to a plot function, checked: names with the nearest known one, kinds of values.
-- Errors are those of every class, placed where the user's own text called. Leans on
-- archard.gnuplot for the error objects, on archard.names for the words.

local gnuplot = require "archard.gnuplot"
local names = require "archard.names"

local check = {}

-- Raises an error object; the code is a status name, "ARGUMENT" where left out.
function check.fail(where, message, code)
  gnuplot.raise(where, code or "ARGUMENT", (message:gsub("%z", " ")))
end

-- " (did you mean 'title'?)", or the list of what is known.
function check.hint(name, known)
  local sorted = table.move(known, 1, #known, 1, {})
  table.sort(sorted)
  local best = names.nearest(name, sorted)
  if best then return (" (did you mean '%s'?)"):format(best) end
  return (" (known: %s)"):format(table.concat(sorted, ", "))
end

check.shown = names.shown -- a value in a message: "dumb", 3, a wear object, a table

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

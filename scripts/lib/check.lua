-- What a user hands to a function of a script, checked: names with the nearest known one, kinds of
-- values, in the words of the classes written in C. Errors are those of every class, placed where
-- the user's own text called. Leans on archard.names for both.

local keys = require "archard.lib.keys"
local names = require "archard.names"

local check = {}

-- Raises an error object; the code is a status name, "ARGUMENT" where left out.
function check.fail(where, message, code)
  names.raise(where, code or "ARGUMENT", (message:gsub("%z", " ")))
end

-- " (did you mean 'title'?)", or the list of what is known. The name itself, which has been refused, is no
-- advice.
function check.hint(name, known)
  local sorted = {}
  for _, each in ipairs(known) do
    if each ~= name then sorted[#sorted + 1] = each end
  end
  table.sort(sorted)
  local best = names.nearest(name, sorted)
  if best then return (" (did you mean '%s'?)"):format(best) end
  return (" (known: %s)"):format(table.concat(sorted, ", "))
end

check.plain = names.plain -- a text of a file, for people: no codes that a terminal obeys
check.shown = names.shown -- a value in a message: "dumb", 3, a wear object, a table

-- --- kinds of values: { test, what is expected } -------------------------------------------------

-- item: the kind of what stands in a list, to tell which one is wrong; growing: so must they be.
function check.kind(expected, test, item, growing)
  return { expected = expected, test = test, item = item, growing = growing }
end
local kind = check.kind

local function finite(value)
  return type(value) == "number" and value == value and math.abs(value) < math.huge
end

local function whole(value, low, high)
  return finite(value) and value % 1 == 0 and value >= low and value <= high
end

check.text = kind("a string", function(v) return type(v) == "string" end)
check.file = kind("a file name", function(v)
  return type(v) == "string" and v ~= "" and not v:find("\0", 1, true)
end)
check.flag = kind("true or false", function(v) return type(v) == "boolean" end)
check.number = kind("a number", finite)
check.positive = kind("a number > 0", function(v) return finite(v) and v > 0 end)
check.share = kind("a number in (0, 1)", function(v) return finite(v) and v > 0 and v < 1 end)
check.table = kind("a table", function(v) return type(v) == "table" end)
check.list = kind("a list of numbers", check.table.test)
check.progress = kind('a function, false or "lines"', function(v)
  return type(v) == "function" or v == false or v == "lines"
end)

-- A whole number; without `high` as large as it likes.
function check.whole(low, high)
  return kind(high and ("a whole number in [%d, %d]"):format(low, high)
    or ("a whole number >= %d"):format(low), function(v) return whole(v, low, high or v) end)
end

check.count = check.whole(1, 100000)

-- The first item of a list that is not what it should be, and what that is; nil where all are.
local function wrong_item(list, item, growing)
  for i = 1, #list do
    local one = list[i]
    if not item.test(one) then return i, item.expected end
    if growing and i > 1 and one <= list[i - 1] then
      return i, ("more than %g, the one before"):format(list[i - 1])
    end
  end
end

-- A list whose items are all of a kind, one at least; `growing`: each number beyond the one before.
function check.list_of(item, expected, growing)
  return kind(expected, function(v)
    return type(v) == "table" and #v > 0 and not wrong_item(v, item, growing)
  end, item, growing)
end

-- Whatever the caller has checked, or another one will.
function check.any(expected) return kind(expected, function() return true end) end

local deepest = 20 -- tables in tables

-- Refuses a table that holds itself, or goes on as if it did, where one descends into it: `name` is that of
-- the table reached, with its points.
function check.depth(where, name)
  local _, points = name:gsub("%.", "")
  if points > deepest then
    check.fail(where, ("field '%s': expected tables within tables %d deep at most, got %d (one that holds itself?)")
      :format(name:match "^[^.]*%.[^.]*%.[^.]*" .. "...", deepest, points))
  end
end

-- Fields of all names, which whoever reads them checks.
check.anything = setmetatable({}, { __index = function() return check.any "a field" end })

local function pair(names, low, high)
  return kind(("{ %s }, two whole numbers in [%d, %d]"):format(names, low, high), function(v)
    return type(v) == "table" and whole(v[1], low, high) and whole(v[2], low, high)
  end)
end

check.size = pair("width, height", 10, 20000)
check.grid = pair("rows, columns", 1, 50)
check.range = kind("{ low, high }, two different finite numbers, or one of them", function(v)
  if type(v) ~= "table" or (v[1] == nil and v[2] == nil) then return false end
  return (v[1] == nil or finite(v[1])) and (v[2] == nil or finite(v[2])) and v[1] ~= v[2]
end)
check.box = kind("{ x0, x1, y0, y1 }", function(v)
  return type(v) == "table" and finite(v[1]) and finite(v[2]) and finite(v[3]) and finite(v[4])
    and v[1] < v[2] and v[3] < v[4]
end)

-- One of these words; `also` is a kind whose values are taken too.
function check.one_of(words, also)
  local expected = {}
  for i, word in ipairs(words) do expected[i] = '"' .. word .. '"' end
  if also then expected[#expected + 1] = also.expected end
  local last = #expected > 1 and " or " .. table.remove(expected) or ""
  return kind(table.concat(expected, ", ") .. last, function(v)
    for _, word in ipairs(words) do
      if v == word then return true end
    end
    return also ~= nil and also.test(v)
  end)
end

-- --- fields ---------------------------------------------------------------------------------------

-- Raises the error for a field whose value is not what is expected.
function check.refuse(where, name, expected, value)
  check.fail(where, ("field '%s': expected %s, got %s"):format(name, expected, check.shown(value)))
end

-- Raises the error for a value that is not of a kind, or for the item of it that is not.
local function refuse_kind(where, name, wanted, value)
  if wanted.item and type(value) == "table" then
    local i, expected = wrong_item(value, wanted.item, wanted.growing)
    if i then check.refuse(where, ("%s[%d]"):format(name, i), expected, value[i]) end
  end
  check.refuse(where, name, wanted.expected, value)
end

-- Lists are as long as they are: one that says its own length would be read on without end.
local function says_its_length(value)
  local metatable = type(value) == "table" and getmetatable(value)
  return type(metatable) == "table" and rawget(metatable, "__len") ~= nil
end

-- Every named field of `given` must be in `fields` (name = kind). List items are the caller's.
function check.fields(where, given, fields, prefix)
  prefix = prefix or ""
  if type(given) ~= "table" then
    check.fail(where, ("%sexpected a table of named fields, got %s"):format(
      prefix ~= "" and ("field '%s': "):format(prefix:sub(1, -2)) or "", check.shown(given)))
  end
  for name, value in pairs(given) do
    if type(name) == "string" then
      local wanted = fields[name]
      if not wanted then
        check.fail(where, ("unknown field '%s%s'%s"):format(prefix, name, check.hint(name, keys(fields))))
      elseif says_its_length(value) then
        check.fail(where, ("field '%s%s': expected %s, got a table with a __len of its own"):format(prefix, name,
          wanted.expected))
      elseif not wanted.test(value) then
        refuse_kind(where, prefix .. name, wanted, value)
      end
    end
  end
  return given
end

-- Calls a function; what it raises is told of as the call `where` that the user made.
function check.as(where, f, ...)
  local results = table.pack(pcall(f, ...))
  if results[1] then return table.unpack(results, 2, results.n) end
  local err = results[2]
  if type(err) ~= "table" or not err.message then error(err, 0) end
  check.fail(where, err.message, err.code)
end

-- The same of a table that holds nothing else; `or_else` is what might stand in its place, `name` the
-- field that it is.
function check.definition(where, given, fields, or_else, name)
  if type(given) ~= "table" then
    check.fail(where, ("expected %sa table of named fields, got %s"):format(or_else or "",
      check.shown(given)))
  end
  if given[1] ~= nil then
    check.fail(where, "fields are given by name; found [1]" .. (name and " in " .. name or ""))
  end
  return check.fields(where, given, fields)
end

return check

-- Checks arguments that scripts pass to functions: the names of fields and the kinds of values. Errors have
-- the same form as the errors of the C classes, with the position of the user's call.

local keys = require "archard.lib.keys"
local names = require "archard.names"

local check = {}

-- Raises an error object with a message. where: name of the function that the user called; code: name of a
-- status, default "ARGUMENT".
function check.fail(where, message, code)
  names.raise(where, code or "ARGUMENT", (message:gsub("%z", " ")))
end

-- Returns a hint for an unknown name: " (did you mean 'title'?)" if a known name is similar, else the list
-- of known names. `name` itself is never suggested.
function check.hint(name, known)
  local sorted = {}
  for _, each in ipairs(known) do
    if each ~= name then sorted[#sorted + 1] = each end
  end
  table.sort(sorted)
  local best, relation = names.nearest(name, sorted)
  if best then return (" (did you mean '%s'%s?)"):format(best, relation) end
  return (" (known: %s)"):format(table.concat(sorted, ", "))
end

check.plain = names.plain -- plain(text) removes terminal control codes from a text, such as a name from a file
check.shown = names.shown -- shown(value) formats a value for a message: "dumb", 3, a wear object, a table

-- --- kinds of values: a test and a text of the expected value ----------------------------------

-- Makes a kind, which describes the values that an argument may have. expected: description in messages;
-- test(value): returns true for an accepted value. For lists, `item` is the kind of the items (to report
-- the wrong item), and `growing` is true if the items must increase.
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

check.section = kind("the line of a section, { z = 0 } or { x = 0 } in mm", function(v)
  return type(v) == "table" and (v.x == nil) ~= (v.z == nil) and finite(v.x or v.z) and keys(v)[2] == nil
end)

-- Returns the kind of whole numbers from `low` to `high`. Without `high`, there is no upper limit.
function check.whole(low, high)
  return kind(high and ("a whole number in [%d, %d]"):format(low, high)
    or ("a whole number >= %d"):format(low), function(v) return whole(v, low, high or v) end)
end

check.count = check.whole(1, 100000)

-- Returns the index of the first wrong item of a list and the expected value; nil if all items are
-- right.
local function wrong_item(list, item, growing)
  for i = 1, #list do
    local one = list[i]
    if not item.test(one) then return i, item.expected end
    if growing and i > 1 and one <= list[i - 1] then
      return i, ("more than the item before, %g"):format(list[i - 1])
    end
  end
end

-- Returns the kind of non-empty lists with items of the kind `item`. growing: true if each number must be
-- larger than the previous one.
function check.list_of(item, expected, growing)
  return kind(expected, function(v)
    return type(v) == "table" and #v > 0 and not wrong_item(v, item, growing)
  end, item, growing)
end

-- Returns a kind that accepts all values, for fields that are checked elsewhere.
function check.any(expected) return kind(expected, function() return true end) end

local deepest = 20 -- largest number of levels of nested tables

-- Raises an error for too deeply nested tables, such as a table that contains itself. name: path of the
-- nested table, such as "base.model.lower".
function check.depth(where, name)
  local _, points = name:gsub("%.", "")
  if points > deepest then
    check.fail(where, ("field '%s': expected at most %d levels of tables, got %d (does a table contain itself?)")
      :format(name:match "^[^.]*%.[^.]*%.[^.]*" .. "...", deepest, points))
  end
end

-- For check.fields: fields of any name and value. Other functions check such a table.
check.anything = setmetatable({}, { __index = function() return check.any "a field" end })

-- Returns a kind of short lists, which check.fields copies.
local function tuple(expected, test)
  local made = kind(expected, test)
  made.copied = true
  return made
end

local function pair(names, low, high)
  return tuple(("{ %s }, two whole numbers in [%d, %d]"):format(names, low, high), function(v)
    return type(v) == "table" and whole(v[1], low, high) and whole(v[2], low, high)
  end)
end

check.size = pair("width, height", 10, 20000)
check.grid = pair("rows, columns", 1, 50)
check.range = tuple("{ low, high }, two different finite numbers, or one of them", function(v)
  if type(v) ~= "table" or (v[1] == nil and v[2] == nil) then return false end
  return (v[1] == nil or finite(v[1])) and (v[2] == nil or finite(v[2])) and v[1] ~= v[2]
end)
check.box = tuple("{ x0, x1, y0, y1 }", function(v)
  return type(v) == "table" and finite(v[1]) and finite(v[2]) and finite(v[3]) and finite(v[4])
    and v[1] < v[2] and v[3] < v[4]
end)

-- Returns the kind of values that equal one of the strings `words`. also: another kind that is accepted.
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

-- Raises the error for a field with an unexpected value.
function check.refuse(where, name, expected, value)
  check.fail(where, ("field '%s': expected %s, got %s"):format(name, expected, check.shown(value)))
end

-- Raises an error for a value of a wrong kind or, if the value is a list, for its first wrong item.
local function refuse_kind(where, name, expected_kind, value)
  if expected_kind.item and type(value) == "table" then
    local i, expected = wrong_item(value, expected_kind.item, expected_kind.growing)
    if i then check.refuse(where, ("%s[%d]"):format(name, i), expected, value[i]) end
  end
  check.refuse(where, name, expected_kind.expected, value)
end

-- Returns true if a value is a table with a __len metamethod. Such tables are refused, since __len could
-- report an endless list.
local function has_len(value)
  local metatable = type(value) == "table" and getmetatable(value)
  return type(metatable) == "table" and rawget(metatable, "__len") ~= nil
end

-- Returns a copy of a list without its metamethods, which could return another value the next time.
local function copied(value)
  local copy = {}
  for i, each in pairs(value) do copy[i] = each end
  return copy
end

-- Raises an error if the table `given` has an unknown field or a wrong value. Returns a copy for which each field and
-- each list was read once, since a metamethod could return another value the next time. fields: the kinds of all
-- fields by name; prefix: path of the table in messages. List items are not checked.
function check.fields(where, given, fields, prefix)
  prefix = prefix or ""
  if type(given) ~= "table" then
    check.fail(where, ("%sexpected a table of named fields, got %s"):format(
      prefix ~= "" and ("field '%s': "):format(prefix:sub(1, -2)) or "", check.shown(given)))
  end
  local copy = {}
  for name, value in pairs(given) do
    copy[name] = value
    if type(name) == "string" then
      local expected_kind = fields[name]
      if not expected_kind then
        check.fail(where, ("unknown field '%s%s'%s"):format(prefix, name, check.hint(name, keys(fields))))
      elseif has_len(value) then
        check.fail(where, ("field '%s%s': expected %s, got a table with a __len metamethod"):format(prefix, name,
          expected_kind.expected))
      end
      if type(value) == "table" and (expected_kind.copied or expected_kind.item) then
        value = copied(value)
        copy[name] = value
      end
      if not expected_kind.test(value) then refuse_kind(where, prefix .. name, expected_kind, value) end
    end
  end
  return copy
end

-- Returns the message and the code of an error object of this program. Returns nil for other values, whose
-- metamethods are not called.
function check.reason(err)
  local message = type(err) == "table" and rawget(err, "message")
  if type(message) ~= "string" then return nil end
  local code = rawget(err, "code")
  return message, type(code) == "string" and code or nil
end

-- Calls f and returns its results. Errors of f are raised again as errors of `where`, the function that the
-- user called.
function check.as(where, f, ...)
  local results = table.pack(pcall(f, ...))
  if results[1] then return table.unpack(results, 2, results.n) end
  local message, code = check.reason(results[2])
  if not message then error(results[2], 0) end
  check.fail(where, message, code)
end

-- Calls a function of the user and returns its results. An error that Lua reports at the position of the call, such as
-- that of an ended coroutine, is raised without this position.
function check.call(f, ...)
  local results = table.pack(pcall(f, ...))
  if results[1] then return table.unpack(results, 2, results.n) end
  local why = results[2]
  error(type(why) == "string" and (why:gsub("^scripts/[^:]*:%d+: ", "")) or why, 0)
end

-- Checks and returns a table that has only named fields. or_else: description of other accepted values;
-- name: name of the field that contains the table.
function check.definition(where, given, fields, or_else, name)
  if type(given) ~= "table" then
    check.fail(where, ("expected %sa table of named fields, got %s"):format(or_else or "",
      check.shown(given)))
  end
  if rawget(given, 1) ~= nil then
    check.fail(where, "expected fields by name (field = value), got a value without a name" .. (name and " in " .. name or ""))
  end
  return check.fields(where, given, fields)
end

return check

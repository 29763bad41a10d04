-- The globals of the session: all globals except the globals that existed at its start.

local debug, math, next, rawequal, rawget, table, tostring, type =
  debug, math, next, rawequal, rawget, table, tostring, type
local globals = _G

local help = require "archard.help"
local kept = require "archard.session.kept"
local names = require "archard.names"
local spelling = require "archard.lib.spelling"

local own = {}

local there = { _ = true, arg = true }
for name in next, globals do there[name] = true end

-- Returns true for the name of a global of the program. Some of these globals are created after this file was
-- loaded.
local function is_ours(name) return there[name] or (require "archard")[name] ~= nil end

-- Returns true if the name is reserved for a global of the program.
own.is_taken = is_ours

-- Returns the class of a value: the class name, such as "wear" or "study", for an object of archard;
-- "program" for parts of the program; else the Lua type.
function own.class(value)
  local metatable = debug.getmetatable(value)
  local address = type(metatable) == "table" and help.address_of(value)
  if not address or address:find("[.{]") or type(value) == "function" then
    local name = type(metatable) == "table" and not metatable.__plain and rawget(metatable, "__name")
    return type(name) == "string" and name or type(value)
  end
  return rawequal((require "archard")[address], value) and "program" or address
end

-- Returns the globals of the session as a list of { name=, value=, class= }, sorted by name.
function own.list()
  local list = {}
  for name, value in next, globals do
    if type(name) == "string" and not is_ours(name) then
      list[#list + 1] = { name = name, value = value, class = own.class(value) }
    end
  end
  table.sort(list, function(a, b) return a.name < b.name end)
  return list
end

local function is_plain(value)
  local metatable = debug.getmetatable(value)
  return type(value) == "table" and (metatable == nil or (type(metatable) == "table" and metatable.__plain))
end

-- Returns true for a list of numbers that doubles represent exactly. Such a list is saved as one value, whatever its
-- length.
local function is_list(value)
  local count = #value
  for i = 1, count do
    local number = rawget(value, i)
    local held = type(number) == "number" and (number ~= number or number + 0.0 == number)
    if not held then return false end
  end
  return count > 0 and next(value, count) == nil
end

local function sorted_keys(value)
  local keys = {}
  for key in next, value do keys[#keys + 1] = key end
  table.sort(keys, function(a, b)
    if math.type(a) and math.type(b) then return a < b end
    return tostring(a) < tostring(b)
  end)
  return keys
end

-- Calls visit(path, value, class, owner) for all globals and for the values in their tables, in order. `path`
-- is the list of keys, such as { "w" } or { "runs", 1 }. `owner` is the result or contact that contains the
-- value, or nil. The parts of a value are visited only once, and not at all if visit returns false for the
-- value.
function own.visit(visit)
  local seen = {}
  local look
  local function look_inside(path, parts, owner)
    for _, key in ipairs(sorted_keys(parts)) do
      local inner, value = table.move(path, 1, #path, 1, {}), rawget(parts, key)
      inner[#inner + 1] = key
      look(inner, value, own.class(value), owner)
    end
  end
  function look(path, value, class, owner)
    local kind, parts = kept.parts(value, class)
    if not kind and not is_plain(value) then return visit(path, value, class, owner) end
    if not kind and is_list(value) then return visit(path, value, "list", owner) end
    local again = seen[value]
    seen[value] = true
    if visit(path, value, kind or "table", owner) == false or again then return end
    if parts or not kind then look_inside(path, parts or value, kind and value or owner) end
  end
  -- An object with several names is visited first as a global, then inside a table, then as part of a result.
  local rank = { {}, {}, {} }
  for _, each in ipairs(own.list()) do
    local list = kept.parts(each.value, each.class) and rank[3] or is_plain(each.value) and rank[2] or rank[1]
    list[#list + 1] = each
  end
  for _, list in ipairs(rank) do
    for _, each in ipairs(list) do look({ each.name }, each.value, each.class) end
  end
end

-- Returns a path as text that can be printed, such as "runs[1].first".
function own.spoken(path)
  local parts = { path[1] }
  for i = 2, #path do parts[i] = spelling.index(path[i]) end
  return names.plain(table.concat(parts))
end

local function is_unsaved(value, class)
  if class == "wear" then return not tostring(value):find "%(closed%)$" and value.update > 0 and not value.saved end
  if class == "joint_wear" then return not tostring(value):find "%(closed%)$" and value.update > 0 and value.saved ~= value.update end
  return kept.is_class(class) and not kept.is_saved(value)
end

-- Returns the objects whose present state is in no file: runs after the first update, results and contacts.
-- Each is { path=, value=, class= }.
function own.unsaved()
  local list, seen = {}, {}
  own.visit(function(path, value, class)
    if class ~= "table" and not seen[value] and is_unsaved(value, class) then
      seen[value] = true
      list[#list + 1] = { path = path, value = value, class = class }
    end
    return class == "table" -- the parts of a result are saved with the result
  end)
  table.sort(list, function(a, b) return own.spoken(a.path) < own.spoken(b.path) end)
  return list
end

return own

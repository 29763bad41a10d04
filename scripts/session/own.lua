-- The globals that the session has made: all but those that were there at its start.

local debug, math, next, rawequal, rawget, table, tostring, type =
  debug, math, next, rawequal, rawget, table, tostring, type
local globals = _G

local help = require "archard.help"
local names = require "archard.names"
local spelling = require "archard.lib.spelling"

local own = {}

local there = { _ = true, arg = true }
for name in next, globals do there[name] = true end

-- Some globals of the program may have come after this file was read.
local function is_ours(name) return there[name] or (require "archard")[name] ~= nil end

-- Whether a global of that name is not the session's to make.
own.is_taken = is_ours

-- "wear", "study", ...: the class of an object of ours, or else the type; "program" where it is a part of that.
function own.class(value)
  local metatable = debug.getmetatable(value)
  local address = type(metatable) == "table" and help.address_of(value)
  if not address or address:find("[.{]") or type(value) == "function" then
    local name = type(value) == "table" and type(metatable) == "table" and not metatable.__plain and rawget(metatable, "__name")
    return type(name) == "string" and name or type(value)
  end
  return rawequal((require "archard")[address], value) and "program" or address
end

-- List of { name=, value=, class= } in the order of names.
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

-- A list of numbers that doubles hold: one value, however long.
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

-- Calls visit(path, value, class) for everything in the globals and in tables of theirs, in order and
-- once for each table: path is the list of keys, "w" or "runs", 1. What it says false of stays closed.
function own.visit(visit)
  local seen = {}
  local function look(path, value, class)
    if not is_plain(value) then return visit(path, value, class) end
    if is_list(value) then return visit(path, value, "list") end
    if seen[value] or visit(path, value, "table") == false then return end
    seen[value] = true
    for _, key in ipairs(sorted_keys(value)) do
      local inner = table.move(path, 1, #path, 1, {})
      inner[#inner + 1] = key
      look(inner, value[key], own.class(value[key]))
    end
  end
  local tables = {} -- after the globals themselves: what has a name of its own is told of by that
  for _, each in ipairs(own.list()) do
    if is_plain(each.value) then
      tables[#tables + 1] = each
    else
      visit({ each.name }, each.value, each.class)
    end
  end
  for _, each in ipairs(tables) do look({ each.name }, each.value, "table") end
end

-- "runs[1].first" of a path, for people.
function own.spoken(path)
  local parts = { path[1] }
  for i = 2, #path do parts[i] = spelling.index(path[i]) end
  return names.plain(table.concat(parts))
end

-- Runs that have worn and that no file holds as they stand: a list of { path=, value= }.
function own.unsaved()
  local list, seen = {}, {}
  own.visit(function(path, value, class)
    if class ~= "wear" or tostring(value):find("%(closed%)$") or seen[value] then return end
    seen[value] = true
    if value.update > 0 and not value.saved then list[#list + 1] = { path = path, value = value } end
  end)
  table.sort(list, function(a, b) return own.spoken(a.path) < own.spoken(b.path) end)
  return list
end

return own

-- map{ x=, z=, y= } checks the fields of the user and makes a map (class.lua).

local check = require "archard.lib.check"
local map = require "archard.map.class"
require "archard.map.level"

local values = check.kind("a list of numbers, or a function (x, z) -> number", function(v)
  return type(v) == "table" or type(v) == "function"
end)
local fields = { x = check.list, z = check.list, y = values, unit = check.text, name = check.text }

local function copied(list) return table.move(list, 1, #list, 1, {}) end

-- Calls a function of the user. An error is raised again without the position that Lua adds.
local function called(f, x, z)
  local fine, value = pcall(f, x, z)
  if not fine then error(value, 0) end
  return value or false
end

-- Returns the values of a function f(x, z) at all points of a map.
local function sampled(f, x, z)
  local y = {}
  for i = 1, #x do for j = 1, #z do y[#y + 1] = called(f, x[i], z[j]) end end
  return y
end

local function new(given)
  local where = "map"
  given = check.definition(where, given, fields)
  for _, name in ipairs{ "x", "z", "y" } do
    if given[name] == nil then check.refuse(where, name, fields[name].expected, nil) end
  end
  local x, z, y = copied(given.x), copied(given.z), given.y
  y = type(y) == "function" and sampled(y, x, z) or copied(y)
  return map.new(where, x, z, y, { unit = given.unit, name = given.name })
end

return { new = new }

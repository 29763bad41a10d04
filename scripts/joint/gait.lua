-- Gaits are the rotations and loads of a joint over a cycle. This file has gait("iso", { increments= }),
-- gait{ flexion=, ... }, gait.rocking{}, gait.flexion{} and gait.read(path).

local check = require "archard.lib.check"
local given_gait = require "archard.joint.given_gait"
local keys = require "archard.lib.keys"
local made = require "archard.joint.made"
local sphere = require "archard.sphere"

local module = {}

local usual = 20
local named = { iso = true, prosim = true }

local function simple(name, usual_angle)
  return function(given)
    local where = "gait." .. name
    given = check.definition(where, given or {}, { angle = check.positive, load = check.positive, increments = check.count })
    local n = given.increments or usual
    local function of(count) return sphere.named(name, count, given.angle or usual_angle, given.load or 2000) end
    return made(name, of(n), of(2 * n))
  end
end

module.rocking = simple("rocking", 23)
module.flexion = simple("flexion", 21.5)

local columns = { t = true, flexion = true, adduction = true, rotation = true, load = true, Fx = true, Fy = true, Fz = true }

-- gait.read(path, { increments=, order=, period= }) reads a gait from the columns t, flexion, adduction,
-- rotation and load (or Fx, Fy, Fz) of a text file.
function module.read(path, options)
  local where = "gait.read"
  if not check.file.test(path) then check.refuse(where, "path", "a file name", path) end
  options = check.definition(where, options or {}, { increments = check.count, order = check.text, period = check.positive })
  local table_of = require("archard.lib.csv").read(path)
  for _, name in ipairs(keys(table_of)) do
    if not columns[name] then
      warn(("%s: %s: the column %s is not used (known: %s)"):format(where, path, check.shown(name), table.concat(keys(columns), ", ")))
    end
  end
  local given = { increments = options.increments, order = options.order, period = options.period, t = rawget(table_of, "t") }
  for _, name in ipairs{ "flexion", "adduction", "rotation" } do given[name] = rawget(table_of, name) end
  local x, y, z = rawget(table_of, "Fx"), rawget(table_of, "Fy"), rawget(table_of, "Fz")
  given.load = z and { x = x, y = y, z = z } or rawget(table_of, "load")
  if not given.t or not given.load then
    check.fail(where, path .. ": expected columns t, flexion, adduction, rotation and load (or Fx, Fy, Fz)")
  end
  return given_gait.read(given, path:match "[^/]+$")
end

return setmetatable(module, { __call = function(_, given, options)
  if type(given) ~= "string" then
    if options ~= nil then check.fail("gait", "expected one table, gait{ flexion=, load=, increments= }, got a second argument; gait.read(path) reads a file") end
    return given_gait.read(given)
  end
  options = check.definition("gait", options or {}, { increments = check.count })
  if not named[given] then
    check.fail("gait", ("expected the name of a gait, got %s%s"):format(check.shown(given), check.hint(given, { "iso", "prosim" })))
  end
  return made(given == "iso" and "iso-like (the shapes between its ranges are approximate)" or given,
    sphere.named(given, options.increments or usual), sphere.named(given, 2 * (options.increments or usual)))
end })

-- gait "iso", gait{ flexion=, ... }, gait.rocking{}, gait.flexion{}, gait.read(path): rotations and loads of a joint
-- over a cycle.

local check = require "archard.lib.check"
local made = require "archard.joint.made"
local sphere = require "archard.sphere"

local module = {}

local usual = 20
local named = { iso = true, prosim = true }

local angle_kind = check.kind("a function of t in [0, 1], a number or a list of degrees", function(v)
  return type(v) == "function" or check.number.test(v) or type(v) == "table" and #v > 1
end)
local load_kind = check.kind("a function of t, a number or a list of N, or { x=, y=, z= } of them", function(v)
  return type(v) == "function" or type(v) == "table" or check.positive.test(v)
end)
local fields = { flexion = angle_kind, adduction = angle_kind, rotation = angle_kind, load = load_kind, order = check.text,
  increments = check.count, t = check.list_of(check.number, "a list of times from 0 to 1", true) }

-- Converts a number, a list over times (evenly spaced without `times`) or a function to a function of t.
local function over_time(name, value, times)
  if type(value) == "number" then return function() return value end end
  if type(value) == "function" then
    return function(t)
      local result = value(t)
      if not check.number.test(result) then check.refuse("gait", name, ("a finite number at t = %g"):format(t), result) end
      return result
    end
  end
  local n = #value
  local function at(i) return times and times[i] or (i - 1) / (n - 1) end
  if times and #times ~= n then
    check.fail("gait", ("field '%s': expected one value for each of the %d times, got %d"):format(name, #times, n))
  end
  for i = 1, n do
    if not check.number.test(value[i]) then check.refuse("gait", ("%s[%d]"):format(name, i), "a finite number", value[i]) end
  end
  return function(t)
    local i = 1
    while i < n - 1 and t > at(i + 1) do i = i + 1 end
    local share = (t - at(i)) / (at(i + 1) - at(i))
    return value[i] + (value[i + 1] - value[i]) * math.min(1, math.max(0, share))
  end
end

local function from_fields(given)
  check.definition("gait", given, fields, 'the name of a gait, "iso" or "prosim", or ')
  local n = given.increments or usual
  local angles, loads, parts = {}, {}, {}
  for i, name in ipairs{ "flexion", "adduction", "rotation" } do
    parts[i] = over_time(name, given[name] or 0, given.t)
  end
  for i = 0, 2 * n do
    for k = 1, 3 do angles[3 * i + k] = parts[k](i / (2 * n)) end
  end
  local load = given.load or 2000
  local by_axis = type(load) == "table" and #load == 0
  for k, name in ipairs{ "x", "y", "z" } do
    local value
    if by_axis then value = load[name] or 0 else value = k == 3 and load or 0 end
    local f = over_time(by_axis and "load." .. name or "load", value, given.t)
    for i = 0, n - 1 do loads[3 * i + k] = f((i + 0.5) / n) end
  end
  return made("own", sphere.angles(n, angles, loads, given.order or "xyz"))
end

local function simple(name, usual_angle)
  return function(given)
    local where = "gait." .. name
    check.definition(where, given or {}, { angle = check.positive, load = check.positive, increments = check.count })
    given = given or {}
    local n = given.increments or usual
    return made(name, sphere.named(name, n, given.angle or usual_angle, given.load or 2000))
  end
end

module.rocking = simple("rocking", 23)
module.flexion = simple("flexion", 21.5)

-- gait.read(path, { increments=, order= }): reads the columns t, flexion, adduction, rotation and load, or Fx, Fy, Fz
function module.read(path, options)
  local where = "gait.read"
  if not check.file.test(path) then check.refuse(where, "path", "a file name", path) end
  options = check.definition(where, options or {}, { increments = check.count, order = check.text })
  local table_of = require("archard.lib.csv").read(path)
  local given = { increments = options.increments, order = options.order, t = rawget(table_of, "t") }
  for _, name in ipairs{ "flexion", "adduction", "rotation" } do given[name] = rawget(table_of, name) end
  local x, y, z = rawget(table_of, "Fx"), rawget(table_of, "Fy"), rawget(table_of, "Fz")
  given.load = z and { x = x, y = y, z = z } or rawget(table_of, "load")
  if not given.t or not given.load then
    check.fail(where, path .. ": expected columns t, flexion, adduction, rotation and load (or Fx, Fy, Fz)")
  end
  return from_fields(given)
end

return setmetatable(module, { __call = function(_, given)
  if type(given) ~= "string" then return from_fields(given) end
  if not named[given] then
    check.fail("gait", ('expected "iso" or "prosim", got %s%s'):format(check.shown(given), check.hint(given, { "iso", "prosim" })))
  end
  return made(given == "iso" and "iso-like (the shapes between its ranges are approximate)" or given,
    sphere.named(given, usual))
end })

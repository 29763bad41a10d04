-- Gaits that a user defines by fields. Rotations and loads over a cycle are functions of t in [0, 1], lists
-- or numbers.

local check = require "archard.lib.check"
local made = require "archard.joint.made"
local sphere = require "archard.sphere"
local strict = require "archard.strict"

local given = {}

local usual = 20 -- increments

local angle_kind = check.kind("a function of t in [0, 1], a number or a list of degrees", function(v)
  return type(v) == "function" or check.number.test(v) or type(v) == "table" and #v > 1
end)
local load_kind = check.kind("a function of t, a number or a list of N, or { x=, y=, z= } of them", function(v)
  return type(v) == "function" or type(v) == "table" or check.positive.test(v)
end)
given.kind = check.kind('a gait such as gait "iso", or its fields', function(v) return type(v) == "table" or given.is(v) end)
given.fields = { gait = given.kind, name = check.text, instants = check.list } -- name, instants: in run files
local fields = { flexion = angle_kind, adduction = angle_kind, rotation = angle_kind, load = load_kind, order = check.text,
  increments = check.count, t = check.list_of(check.number, "a list of times from 0 to 1", true), period = check.positive }

-- Returns the times divided by the period. The first time must be 0 and the last one the period.
local function over_cycle(t, period)
  local shares = {}
  for i, time in ipairs(t) do shares[i] = time / period end
  local first, last = shares[1], shares[#shares]
  if not first or math.abs(first) > 1e-9 or math.abs(last - 1) > 1e-9 then
    check.fail("gait", ("field 't': expected times from 0 to the period %g, got %s; period is the length of the cycle in the unit of t (100 for percent)")
      :format(period, first and ("%g to %g"):format(t[1], t[#t]) or "none"))
  end
  return shares
end

-- Returns a function of t for a number, a list or a function. A list has one value for each of `times`;
-- without `times` its values are evenly spaced.
local function over_time(name, value, times)
  if type(value) == "number" then return function() return value end end
  if type(value) == "function" then
    return function(t)
      local result = value(t)
      if not check.number.test(result) then check.refuse("gait", name, ("a finite number at t = %g"):format(t), result) end
      return result
    end
  end
  local n = type(value) == "table" and #value or 0
  local function at(i) return times and times[i] or (i - 1) / (n - 1) end
  if times and #times ~= n then
    check.fail("gait", ("field '%s': expected one value for each of the %d times, got %d"):format(name, #times, n))
  end
  if n < 2 then check.fail("gait", ("field '%s': expected at least two values over a cycle, got %d"):format(name, n)) end
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

for name, kind in pairs(fields) do given.fields[name] = kind end

local most = 60 -- largest rotation in half an increment [degree]

-- Returns the list of n instants. parts: functions of t for the three angles [degree]; loads: functions of
-- t for the three components of the load [N].
local function instants_of(n, parts, loads, order)
  local angles, forces = {}, {}
  for i = 0, 2 * n do
    for k = 1, 3 do
      angles[3 * i + k] = parts[k](i / (2 * n))
      local turned = i > 0 and math.abs(angles[3 * i + k] - angles[3 * i + k - 3]) or 0
      if turned > most then
        check.fail("gait", ("field 'increments': expected rotations of at most %g degrees in half an increment, got %.3g at t = %.3g; use more than %d")
          :format(most, turned, i / (2 * n), n))
      end
    end
  end
  for i = 0, n - 1 do
    for k = 1, 3 do forces[3 * i + k] = loads[k]((i + 0.5) / n) end
  end
  return sphere.angles(n, angles, forces, order)
end

-- Returns a gait from the fields of gait{}. name: name of the gait in texts, default "own".
function given.read(from, name)
  from = check.definition("gait", from, fields, 'the name of a gait, "iso" or "prosim", or ')
  if not next(from) then check.fail("gait", "expected at least one angle (flexion, adduction or rotation), got none") end
  local n = from.increments or usual
  local parts, loads = {}, {}
  local times = from.t and over_cycle(from.t, from.period or 1)
  for i, angle in ipairs{ "flexion", "adduction", "rotation" } do
    parts[i] = over_time(angle, from[angle] or 0, times)
  end
  local load = from.load or 2000
  local by_axis = type(load) == "table" and #load == 0
  for k, axis in ipairs{ "x", "y", "z" } do
    local value
    if by_axis then value = load[axis] or 0 else value = k == 3 and load or 0 end
    loads[k] = over_time(by_axis and "load." .. axis or "load", value, times)
  end
  return made(name or "own", instants_of(n, parts, loads, from.order or "xyz"), instants_of(2 * n, parts, loads, from.order or "xyz"))
end

function given.is(value) return strict.is(value, "gait") end

-- Returns a gait object unchanged, or creates a gait from its fields or from a run file (name and instants).
function given.of(it)
  if given.is(it) then return it end
  if rawget(it, "instants") ~= nil then return made(it.name, table.move(it.instants, 1, #it.instants, 1, {})) end
  return given.read(it)
end

return given

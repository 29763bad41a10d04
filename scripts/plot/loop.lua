-- plot.loop: draws fretting loops, the tangential force over the position of the plate in a steady cycle.

local check = require "archard.lib.check"
local curves = require "archard.plot.curves"
local draw = require "archard.plot.draw"
local naming = require "archard.plot.naming"
local shapes = require "archard.plot.shapes"

local loop = {}

-- Returns true for a loop returned by w:loop().
local function is_loop(thing)
  return type(thing) == "table" and rawget(thing, "tangential") ~= nil and rawget(thing, "x") ~= nil
end

local function loop_of(where, thing)
  if is_loop(thing) then return thing end
  if type(thing) == "userdata" and curves.get(thing, "loop") then return thing:loop() end
  check.fail(where, "expected wear runs with friction or their loops, got " .. check.shown(thing))
end

-- Splits the arguments into runs or loops, and options. A last argument that is a table but not a loop
-- contains the options.
local function split(...)
  local given, options = { ... }, nil
  local last = given[#given]
  if type(last) == "table" and not is_loop(last) then options = table.remove(given) end
  return given, options or {}
end

-- Returns the titles of the curves: the user's titles, the settings in which the runs differ, or the cycles
-- at which the loops were computed. A single curve has a title only if the user set one.
local function names_of(where, things, loops, titles)
  if titles or #things == 1 then return titles or {} end
  local runs, cycles = true, {}
  for i, thing in ipairs(things) do
    runs = runs and not is_loop(thing)
    local cycle = rawget(loops[i], "cycle")
    cycles[i] = cycle == 0 and "unworn" or cycle and ("after %.6g cycles"):format(cycle) or nil
  end
  return runs and naming.names_of(where, things) or cycles
end

-- Returns the unit of the position axis (µm, or mm if a position exceeds 1 mm) and the factor from mm to this
-- unit.
local function unit_of(loops)
  local most = 0
  for _, one in ipairs(loops) do
    for _, x in ipairs(one.x) do most = math.max(most, math.abs(x)) end
  end
  if most < 1 then return "µm", 1000 end
  return "mm", 1
end

-- plot.loop(w1, w2 or w2:loop(), ..., { titles=, ... }) draws the fretting loops of runs.
function loop.loop(...)
  local where = "plot.loop"
  local things, options = split(...)
  options = draw.options(where, options, { titles = check.table })
  if #things == 0 then check.fail(where, "expected wear runs with friction or their loops, got none") end
  local loops = {}
  for i, thing in ipairs(things) do loops[i] = loop_of(where, thing) end
  local unit, scale = unit_of(loops)
  local names = names_of(where, things, loops, options.titles)
  local given = { xlabel = "position of the plate / " .. unit, ylabel = "tangential force / N",
    title = #things > 1 and "fretting loops" or "fretting loop" }
  for i, one in ipairs(loops) do
    given[i] = { x = shapes.scaled(one.x, scale), y = one.tangential,
      title = ("%s%.4g N mm per loop"):format(names[i] and tostring(names[i]) .. ", " or "", one.energy) }
  end
  options.titles = nil
  draw.draw(where, draw.over(given, options))
end

return loop

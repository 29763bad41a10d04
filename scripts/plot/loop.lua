-- plot.loop: fretting loops, the tangential force over the plate's position in a steady cycle. Leans on plot/curves.lua
-- and plot/draw.lua.

local check = require "archard.lib.check"
local curves = require "archard.plot.curves"
local draw = require "archard.plot.draw"
local shapes = require "archard.plot.shapes"

local loop = {}

-- A run with friction, or what w:loop() gave.
local function is_loop(thing)
  return type(thing) == "table" and rawget(thing, "tangential") ~= nil and rawget(thing, "x") ~= nil
end

local function loop_of(where, thing)
  if is_loop(thing) then return thing end
  if type(thing) == "userdata" and curves.get(thing, "loop") then return thing:loop() end
  check.fail(where, "expected wear runs with friction or their loops, got " .. check.shown(thing))
end

-- Options come last: a table that is no loop.
local function split(...)
  local given, options = { ... }, nil
  local last = given[#given]
  if type(last) == "table" and not is_loop(last) then options = table.remove(given) end
  return given, options or {}
end

-- plot.loop(w1, w2 or w2:loop(), ..., { titles=, ... })
function loop.loop(...)
  local where = "plot.loop"
  local things, options = split(...)
  options = draw.options(where, options, { titles = check.table })
  if #things == 0 then check.fail(where, "expected wear runs with friction or their loops, got none") end
  local given = { xlabel = "position of the plate / µm", ylabel = "tangential force / N",
    title = #things > 1 and "fretting loops" or "fretting loop" }
  for i, thing in ipairs(things) do
    local one = loop_of(where, thing)
    local name = options.titles and options.titles[i] and tostring(options.titles[i])
    given[i] = { x = shapes.scaled(one.x, 1000), y = one.tangential,
      title = ("%s%.4g N mm a cycle"):format(name and name .. ", " or "", one.energy) }
  end
  options.titles = nil
  draw.draw(where, draw.over(given, options))
end

return loop

-- Tests user functions that fail: the error is reported at the first failing call, with the arguments and the
-- function's message. The run stays at its last complete step, from which it can be continued.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local is, ok, holds, fails = tap.is, tap.ok, tap.holds, tap.fails

local m = model{ mesh = { size = 0.1, height = 0.1 } }
require "archard.warnings".keep() -- suppresses the warning of the coarse mesh

-- Returns a function that fails in each call after five updates and counts these calls.
local asked
local function failing(value, words)
  asked = 0
  return function(...)
    local state = select(select("#", ...), ...)
    if state.update < 5 then return value end
    asked = asked + 1
    if words then return words end
    error "boom"
  end
end

-- Checks that a run stops with the error of the user's function after `stands` updates (default five), and that it
-- continues after `good` has replaced this function.
local function try(name, fields, parts, good, stands)
  fields.model, fields.distance, fields.jump = m, 440, fields.jump or 100
  local w = wear(fields)
  stands = stands or 5
  local err = fails(function() w:run() end, parts, name .. ": the error has the position and the reason")
  is(asked, 1, name .. ": the function is called once more")
  ok(not tostring(err):find("scripts/", 1, true), name ..
    ": the message contains no position in a script of archard")
  is(w.update, stands, name .. ": the run is at its last complete step")
  local before, pressure = w.distance, w.p_center
  is(#w.history.distance, stands + 1, name .. ": the history ends at the last complete step")
  fails(function() w:step() end, parts, name .. ": a second step fails in the same way")
  ok(w.distance == before and w.p_center == pressure, name .. ": the second failure changes nothing")
  w:set(good)
  w:step()
  is(w.update, stands + 1, name .. ": the run continues with a new function")
end

try("k", { k = failing(1e-8) }, { "k(state at distance 110 mm, cycle 500) failed", "boom" }, { k = 1e-8 })
try("alpha", { alpha = failing(0.5) }, { "alpha(state at distance 110 mm, cycle 500) failed", "boom" }, { alpha = 0.5 })
try("jump", { jump = failing(100) }, { "jump(state at distance 110 mm, cycle 500) failed", "boom" }, { jump = 100 })
try("a text of k", { k = failing(1e-8, "x") }, { "k(state at distance 110 mm, cycle 500) failed: expected a number, got string" },
  { k = 1e-8 })
try("a NaN of k", { k = failing(1e-8, 0 / 0) }, { "field 'k': expected a number >= 0 mm2/N, got nan" }, { k = 1e-8 })
try("friction", { friction = failing(0.2) }, { "friction(state at distance 110 mm", "boom" }, { friction = 0.2 },
  4) -- the function is called with the state at the end of an update

-- --- functions called once for each step ---------------------------------------------------------
for _, name in ipairs{ "progress", "stop_when" } do
  asked = 0
  local w = wear{ model = m, distance = 440, jump = 100 }
  fails(function()
    w:run{ [name] = function(run)
      if run.update < 5 then return end
      asked = asked + 1
      error "boom"
    end }
  end, { name .. " failed", "boom" }, name .. ": the error is reported")
  is(asked .. " " .. w.update, "1 5", name .. ": the run ends at once after a complete step")
  w:run{ progress = false }
  is(w.distance, 440.0, name .. ": the run continues to its end")
end

asked = 0
local w = wear{ model = m, distance = 440, jump = 100, local_factor = function(_, _, _, state)
  if state.update < 5 then return 1 end
  asked = asked + 1
  error "boom"
end }
holds(select(2, pcall(w.run, w)), { "local_factor(\"cylinder\", x = ", "boom" },
  "the message of local_factor contains the point")
is(asked .. " " .. w.update, "1 5", "local_factor: the run ends at once after a complete step")

-- Tests that the function may fail at any call, even at a call for an estimate only.
for nth = 2, 12 do
  asked = 0
  local w = wear{ model = m, distance = 440, jump = 100, alpha = function()
    asked = asked + 1
    if asked == nth then error "boom" end
    return 0.5
  end }
  holds(select(2, pcall(w.run, w, { progress = false })), { "alpha(state at", "boom" },
    "the failure of call " .. nth .. " is reported")
  ok(asked <= nth + 3 and w.update <= nth,
    ("failure of call %d: the run ends at update %d after %d calls"):format(nth, w.update, asked))
end

fails(function() wear{ model = m, loading = { x = function(t) error("boom " .. t) end, load = 100, cycles = 10 } } end,
  { "loading.x(0) failed", "boom 0" }, "a loading is called when the run is defined")
fails(function() contact{ model = m, worn = { plate = function(x) if x > 0 then error "boom" end return 0 end } } end,
  { "worn.plate(", "failed", "boom" }, "an error in a worn shape function")

-- time(f, ...) calls a function and prints the elapsed time and the processor time of the call.

local check = require "archard.lib.check"
local term = require "archard.term"

local function shown(seconds) return seconds < 1 and ("%.3g ms"):format(1e3 * seconds) or ("%.3g s"):format(seconds) end

local function is_callable(value)
  local metatable = debug.getmetatable(value)
  return type(value) == "function" or type(metatable) == "table" and metatable.__call ~= nil
end

-- Prints the elapsed and the processor time since `clock` and `busy` [s], and returns the results of the call.
local function report(clock, busy, ...)
  print(("time: %s, processors %s"):format(shown(term.clock() - clock), shown(os.clock() - busy)))
  return ...
end

return function(f, ...)
  if not is_callable(f) then
    check.fail("time", "expected a function, as in time(function() w:run() end), got " .. check.shown(f))
  end
  return report(term.clock(), os.clock(), f(...))
end

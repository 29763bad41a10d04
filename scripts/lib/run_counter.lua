-- Shows the progress of a search with many runs as a line on a terminal, and reports it after an interrupt
-- (Ctrl-C).
--
--   local counter <close> = run_counter.new("fit", 40)   about 40 runs
--   counter:better("k 2.1e-08, alpha 0.31")              best values up to now
--   counter:ran()                                        one more run is finished

local process = require "archard.process"
local progress = require "archard.lib.progress"
local term = require "archard.term"

local counter = {}
counter.__index = counter

-- Creates a counter. what: name of the search; about: expected number of runs; mode: false to show nothing
-- on the terminal.
function counter.new(what, about, mode)
  local self = setmetatable({ what = what, about = about, count = 0, shown = mode == nil and term.movable "stderr",
    started = term.clock() }, counter)
  self:show()
  return self
end

function counter:text()
  return ("%s: %d of about %d runs done%s"):format(self.what, self.count, math.max(self.about, self.count + 1),
    self.best and ", best so far " .. self.best or "")
end

function counter:show()
  process.report(self:text() .. (self.kept and ", kept in " .. self.kept or ""))
  if not self.shown then return end
  local now = term.clock()
  local left = self.count > 0 and (now - self.started) * math.max(1, self.about - self.count) / self.count or math.huge
  local line = ("%s, %s left"):format(self:text(), progress.duration(left))
  io.stderr:write("\r", line:sub(1, term.size "stderr" - 1), "\27[K")
end

function counter:ran(runs)
  self.count = self.count + (runs or 1)
  self:show()
end

-- Reports a better result. kept: the name under which the best values are available after an
-- interrupt.
function counter:better(text, kept)
  self.best, self.kept = text, kept
  self:show()
end

function counter:close()
  process.report ""
  if self.shown then io.stderr:write("\r\27[K") end
  self.shown = false
end
counter.__close = counter.close

return counter

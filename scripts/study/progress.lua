-- Progress display of a study. On a terminal it shows one line for each worker and one for the whole study,
-- redrawn at the same position. Elsewhere it shows nothing or, in mode "lines", one line for each finished
-- case.

local check = require "archard.lib.check"
local one_run = require "archard.lib.progress"
local term = require "archard.term"

local bar, duration = one_run.bar, one_run.duration

local progress = {}
progress.__index = progress

local pause = 0.1 -- seconds between two redraws

-- Makes the display of a study. mode: nil (draws on a terminal), false (no display), "lines" (prints a line
-- for each finished case on standard output), or a function called after each case with { case=, failure=,
-- done=, total= }.
function progress.new(workers, total, done, mode)
  return setmetatable({ workers = workers, total = total, done = done, first = done, failed = 0,
    mode = mode, shown = mode == nil and term.movable("stderr"), started = term.clock(),
    last = -math.huge, lines = 0, slots = {} }, progress)
end

function progress:start(i, case) self.slots[i] = { case = case, share = 0 } end

function progress:at(i, share)
  if self.slots[i] and share then self.slots[i].share = share end
end

function progress:finish(i, case, failure)
  local slot = self.slots[i]
  if slot and slot.case == case then self.slots[i] = nil end
  self.done = self.done + 1
  if failure then self.failed = self.failed + 1 end
  if self.mode == "lines" then
    print(("%d/%d  case %d  %s%s"):format(self.done, self.total, case.id, case.label,
      failure and "  failed" or "")) -- the reason for a failure is printed after the run
    io.flush()
  elseif type(self.mode) == "function" then
    check.call(self.mode, { case = case, failure = failure, done = self.done, total = self.total })
  end
end

local function fitted(text, width) return text:sub(1, math.max(width - 1, 1)) end

function progress:total_line(now, width)
  local part = 0
  for _, slot in pairs(self.slots) do part = part + slot.share end
  local rate = (self.done - self.first + part) / math.max(now - self.started, 1e-9)
  local left = rate > 0 and (self.total - self.done - part) / rate or math.huge
  local failed = self.failed > 0 and (", %d failed"):format(self.failed) or ""
  return fitted(("study %s %d of %d cases%s, %s left"):format(
    bar((self.done + part) / self.total, 20), self.done, self.total, failed, duration(left)), width)
end

-- Returns the lines of the display. now: time [s]; width: columns of the terminal. Tests also call this
-- function.
function progress:text(now, width)
  local lines = { self:total_line(now, width) }
  for i = 1, self.workers do
    local slot = self.slots[i]
    lines[#lines + 1] = slot and fitted(("  %s %3.0f %%  case %d  %s"):format(bar(slot.share, 10),
      100 * slot.share, slot.case.id, slot.case.label), width) or "  -"
  end
  return lines
end

function progress:draw()
  if not self.shown then return end
  local now = term.clock()
  if now - self.last < pause then return end
  self.last = now
  local lines = self:text(now, (term.size("stderr")))
  local up = self.lines > 0 and ("\r\27[%dA"):format(self.lines) or "\r"
  io.stderr:write(up, table.concat(lines, "\27[K\n"), "\27[K\n")
  self.lines = #lines
end

-- Erases the drawn lines and ends the display.
function progress:close()
  if self.lines > 0 then io.stderr:write(("\r\27[%dA\27[J"):format(self.lines)) end
  self.lines, self.shown = 0, false
end
progress.__close = progress.close

return progress

-- Draws a progress bar on standard error if it is a terminal. The bar fits the width of the terminal and is
-- redrawn at most ten times a second.
--
--   local bar = progress.new{ total = 1320, label = "wear", unit = "mm" }
--   bar:update(done, "cycle 2700")     done in the unit of total; the note is optional
--   bar:close()                        clears the bar; also called after an error

local term = require "archard.term"

local progress = {}
progress.__index = progress
progress.__close = function(self) self:close() end

local pause = 0.1 -- seconds between two redraws

function progress.new(definition)
  local self = {
    total = definition.total,
    label = definition.label or "",
    unit = definition.unit or "",
    shown = term.movable("stderr"),
    started = term.clock(),
    first = definition.done or 0, -- amount done before the start, excluded from the rate
    last = -math.huge,
    past = {}, -- { seconds after the start, amount done since then }, at times that grow by a tenth or more
  }
  return setmetatable(self, progress)
end

-- Returns a time as "4:05" or "1:04:05", and "-:--" above 100 hours.
function progress.duration(seconds)
  if seconds ~= seconds or seconds > 359999 then return "-:--" end
  local whole = math.floor(seconds + 0.5)
  local hours, minutes = whole // 3600, whole // 60 % 60
  if hours > 0 then return ("%d:%02d:%02d"):format(hours, minutes, whole % 60) end
  return ("%d:%02d"):format(minutes, whole % 60)
end

-- Returns a bar such as "[###.......]" with `width` characters between the brackets.
function progress.bar(share, width)
  local full = math.floor(math.max(0, math.min(1, share)) * width + 0.5)
  return "[" .. ("#"):rep(full) .. ("."):rep(width - full) .. "]"
end

-- Formats whole numbers with all digits, and other numbers with four digits.
local function amount(value)
  return (math.type(value) == "integer" and "%d" or "%.4g"):format(value)
end

local function remember(past, seconds, done)
  if done > 0 and seconds > 1.1 * (past[#past] or { 0 })[1] then past[#past + 1] = { seconds, done } end
end

-- Returns the estimated time left, in seconds. The amount done is assumed to grow as a power of time, through its
-- values now and at about half the time: steps of wear runs become longer.
function progress:left(done, seconds)
  local most_power = 3
  local so_far, power = done - self.first, 1
  if so_far <= 0 then return math.huge end
  for i = #self.past, 1, -1 do
    local before = self.past[i]
    if before[1] <= seconds / 2 then
      power = math.max(1, math.min(most_power, math.log(so_far / before[2]) / math.log(seconds / before[1])))
      break
    end
  end
  return seconds * (((self.total - self.first) / so_far) ^ (1 / power) - 1)
end

-- Returns the finished share (0 to 1), and the texts before and after the bar.
function progress:parts(done, note, now)
  local share = self.total > 0 and math.min(1, math.max(0, done / self.total)) or 1
  local rate = (done - self.first) / math.max(now - self.started, 1e-9)
  local left = self:left(done, math.max(now - self.started, 1e-9))
  local head = ("%s%3.0f %%"):format(self.label ~= "" and self.label .. " " or "", 100 * share)
  local tail = ("%s/%s %s  %.3g %s/s  %s left"):format(amount(done), amount(self.total), self.unit, rate,
    self.unit, progress.duration(left))
  if note then tail = note .. "  " .. tail end
  return share, head, tail
end

-- Returns the text of the bar for a line of `width` columns. Tests call this function too.
function progress:line(done, note, now, width)
  local share, head, tail = self:parts(done, note, now)
  local space = width - #head - #tail - 6
  if space < 6 then return (head .. "  " .. tail):sub(1, math.max(width - 1, 0)) end
  return ("%s %s %s"):format(head, progress.bar(share, math.min(space, 30)), tail)
end

function progress:update(done, note)
  if not self.shown then return end
  local now = term.clock()
  if now - self.last < pause and done < self.total then return end
  self.last = now
  remember(self.past, now - self.started, done - self.first)
  local width = term.size("stderr")
  io.stderr:write("\r", self:line(done, note, now, width), "\27[K")
  self.drawn = true
end

function progress:close()
  if self.drawn then io.stderr:write("\r\27[K") end
  self.drawn = false
  self.shown = false
end

return progress

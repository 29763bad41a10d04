-- Computes the cases of a run file in worker processes: hands them out, watches, reports. Leans on
-- archard.process for the workers, worker.lua for what they do, study_progress for the display.

local process = require "archard.process"
local check = require "archard.lib.check"
local itself = require "archard.lib.itself"
local progress = require "archard.study.progress"

local function waiting(store, chosen)
  local queue, finished = {}, 0
  for _, case in ipairs(store:cases()) do
    if not chosen or chosen(case.id) then
      if case.status == "done" then finished = finished + 1 else queue[#queue + 1] = case end
    end
  end
  return queue, finished
end

local run = {}
run.__index = run

-- Gives worker i its next case, if there is one.
function run:feed(i)
  local case = table.remove(self.queue, 1)
  self.busy[i] = case
  if not case then return end
  self.running = self.running + 1
  self.pool:send(i, "case " .. case.id)
  self.display:start(i, case)
end

function run:over(i, case, failure)
  self.running = self.running - 1
  self.busy[i] = nil
  if failure then
    self.failed[#self.failed + 1] = { id = case.id, label = case.label, message = failure }
  end
  self.display:finish(i, case, failure)
end

-- A worker that died took one case with it: no other.
function run:bury(i, event)
  local case = self.busy[i]
  if not case then return end
  local words = event.words:gsub("%s+", " "):gsub("^ ", ""):gsub(" $", "")
  local message = ("its process ended by %s%s"):format(event.ended,
    words ~= "" and ": " .. words or "")
  self.store:mark(case.id, "failed", message)
  self:over(i, case, message)
end

function run:hear(i, line)
  local word, rest = line:match("^(%a+) ?(.*)$")
  local case = self.busy[i]
  if word == "broken" then
    check.fail("study:run", rest, "IO")
  elseif not case then
    return
  elseif word == "at" then
    self.display:at(i, tonumber(rest:match("(%S+)$")))
  elseif word == "warned" then
    self.warned[#self.warned + 1] = { id = case.id, label = case.label,
      message = rest:match("^%d+ (.*)$") }
  elseif word == "done" then
    self:over(i, case)
  elseif word == "failed" then
    self:over(i, case, rest:match("^%d+ (.*)$"))
  end
end

function run:attend(event)
  local i = event.worker
  if event.line then self:hear(i, event.line) else self:bury(i, event) end
  if not self.busy[i] then self:feed(i) end
end

-- store: open for writing. options: workers, chosen (function(id) -> whether it is to be done; nil:
-- all), progress. Returns the failed cases, as a list
-- of { id=, label=, message= }, a list of the same of those that were warned of, and how many there
-- were to compute.
return function(store, options)
  store:release()
  local queue, finished = waiting(store, options.chosen)
  local count, failed, warned = #queue, {}, {}
  if count == 0 then return failed, warned, 0 end
  local workers = math.min(options.workers, count)
  local pool <close> = process.pool(workers, { "-e", itself("study.worker", store.path) })
  local display <close> = progress.new(workers, count + finished, finished, options.progress)
  local self = setmetatable({ store = store, pool = pool, queue = queue, busy = {}, running = 0,
    failed = failed, warned = warned, display = display }, run)
  for i = 1, workers do self:feed(i) end
  while self.running > 0 do
    for _, event in ipairs(pool:wait(0.5)) do self:attend(event) end
    display:draw()
  end
  return failed, warned, count
end

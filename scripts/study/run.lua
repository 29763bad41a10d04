-- Computes the cases of a run file in worker processes (study/worker.lua): assigns the cases, collects the
-- results and updates the display.

local process = require "archard.process"
local check = require "archard.lib.check"
local files = require "archard.files"
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

-- Sends worker `i` the next case or, if no case is left, the command to store its computed cases.
function run:feed(i)
  local case = self.queue[self.next]
  self.busy[i] = case
  if case then
    self.next = self.next + 1
    self.pool:send(i, "case " .. case.id)
    self.display:start(i, case)
  elseif next(self.computed[i]) then
    self.pool:send(i, "store")
  end
end

function run:over(i, case, failure)
  self.left = self.left - 1
  self.computed[i][case.id] = nil
  if failure then
    self.failed[#self.failed + 1] = { id = case.id, label = case.label, message = failure }
  end
  self.display:finish(i, case, failure)
end

function run:fail(i, case, message)
  self.store:mark(case.id, "failed", message)
  self:over(i, case, message)
end

-- Handles the end of a worker process. Its current case fails, and its computed cases that are not stored are
-- queued again. If the process ended while storing, the computed cases fail too, because storing them would
-- fail again.
function run:handle_exit(i, event)
  local case, computed = self.busy[i], self.computed[i]
  local words = event.words:gsub("%s+", " "):gsub("^ ", ""):gsub(" $", "")
  local message = ("its process ended by %s%s"):format(event.ended,
    words ~= "" and ": " .. words or "")
  self.busy[i], self.computed[i] = nil, {}
  if case then self:fail(i, case, message) end
  for _, lost in pairs(computed) do
    if case then self.queue[#self.queue + 1] = lost else self:fail(i, lost, message) end
  end
end

function run:computed_case(i)
  local case = self.busy[i]
  self.busy[i], self.computed[i][case.id] = nil, case
  self:feed(i)
end

function run:handle_line(i, line)
  local word, id, rest = line:match("^(%a+) (%d+) ?(.*)$")
  if line:match("^broken ") then check.fail("study:run", line:match("^broken (.*)$"), "IO") end
  if not word then return end
  local case = self.computed[i][math.tointeger(tonumber(id))]
  if word == "at" then
    self.display:at(i, tonumber(rest))
  elseif word == "computed" then
    self:computed_case(i)
  elseif word == "warned" then
    self.warned[#self.warned + 1] = { id = case.id, label = case.label, message = rest }
  elseif word == "done" then
    self:over(i, case)
  elseif word == "failed" then
    self:over(i, case, rest)
  end
end

function run:handle_event(event)
  if event.line then return self:handle_line(event.worker, event.line) end
  self:handle_exit(event.worker, event)
  self:feed(event.worker)
end

local usual_keep = 60 -- default of options.keep: seconds between saves of a long case

-- Computes the waiting cases of `store`, a run file open for writing. options: workers; keep (seconds between
-- saves of a long case); chosen (function(id) that returns true for the cases to compute; nil: all);
-- progress. Returns the failed cases and the cases with warnings, as lists of { id=, label=, message= }, and
-- the number of computed cases.
return function(store, options)
  store:release()
  local queue, finished = waiting(store, options.chosen)
  local count, failed, warned = #queue, {}, {}
  if count == 0 then return failed, warned, 0 end
  local folder, least = files.confined()
  local pool <close> = process.pool(math.min(options.workers, count), { "-e", itself.chunk("study.worker", store.path,
    options.keep or usual_keep, folder or "", least) })
  local workers = pool:count()
  local display <close> = progress.new(workers, count + finished, finished, options.progress)
  local self = setmetatable({ store = store, pool = pool, queue = queue, next = 1, busy = {}, computed = {},
    left = count, failed = failed, warned = warned, display = display }, run)
  for i = 1, workers do
    self.computed[i] = {}
    self:feed(i)
  end
  while self.left > 0 do
    process.report(("%d of %d done, stored in %s; run the study again to continue"):format(display.done, display.total, store.path))
    for _, event in ipairs(pool:wait(0.5)) do self:handle_event(event) end
    display:draw()
  end
  process.report ""
  return failed, warned, count
end

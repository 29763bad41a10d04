-- Worker process of a study. It reads commands from standard input, one per line: "case ID" computes a
-- case, "store" stores all computed cases in the run file. The worker prints "at ID SHARE" with the
-- computed fraction of the case, "computed ID" when it is ready for the next case, and after storing "done
-- ID" or "failed ID TEXT". A case with a warning first prints "warned ID TEXT". "broken TEXT" means that
-- the run file cannot be written.

local stores = require "archard.store"
local files = require "archard.files"
local joint_file = require "archard.joint.file"
local settings = require "archard.definition.settings"
local term = require "archard.term"
local transaction = require "archard.study.transaction"
local warnings = require "archard.warnings"
local wear_task = require "archard.study.wear_task"

local pause = 0.2 -- seconds between two lines on the progress of a case
local longest_wait = 0.5 -- longest time [s] that a computed case waits before it is stored

-- Converts an error to one line of text. The position in the program is omitted, because it does not help the
-- user.
local function one_line(value)
  if type(value) == "table" then value.position = nil end
  return (tostring(value):gsub("%s+", " "):sub(1, 480))
end

local function print_words(...)
  io.write(table.concat({ ... }, " "), "\n")
  io.flush()
end

-- --- tasks ---------------------------------------------------------------------------------------

local tasks = {}

-- Returns the last value of each history column, by name.
local function last_record(run)
  local values = {}
  for name, list in pairs(run.history) do values[name] = list[#list] end
  return values
end

function tasks.wear(store, id, on_progress, every)
  local snapshots = tonumber(store:info("looks")) or 0
  local run, list = wear_task(store, id, settings.nest(store:values(id, "settings")), snapshots, every, on_progress)
  return function()
    joint_file.save(store, id, run, list, last_record(run))
  end, run
end

-- Searches for the settings of a case, see study/search.lua. Returns a function that stores them as the
-- results of the case.
function tasks.converge(store, id, on_progress)
  local search = require "archard.study.search"
  local found = search(settings.nest(store:values(id, "settings")), on_progress)
  return function() store:set_values(id, "results", settings.flatten("converge", found)) end
end

-- Computes a run of a fit. Returns a function that stores the results that the fit compares with
-- measurements.
function tasks.fit(store, id, on_progress)
  local observe = require "archard.study.observe"
  local readings, run = observe.run(settings.nest(store:values(id, "settings")),
    observe.read(store:info("observe")), on_progress)
  run:close()
  return function() store:set_values(id, "results", settings.flatten("fit", { looks = readings })) end
end

-- --- computation of single cases ------------------------------------------------------------------

-- Returns the progress callback of a case. Only cases that run longer than `pause` seconds are marked as
-- running.
local function progress_of(store, id)
  local last, marked = term.clock(), false
  return function(share)
    local now = term.clock()
    if now - last < pause then return end
    last = now
    if not marked then store:mark(id, "running") end
    marked = true
    print_words("at", id, ("%.3f"):format(share))
  end
end

-- Returns the engine's warning for the current case, or nil if there is none. Warnings of the task "converge"
-- are ignored, because its search exceeds limits intentionally.
local function warning_of(store)
  local text = warnings.take()
  return store:info("task") ~= "converge" and text or nil
end

-- Computes a case. Returns { id=, seconds=, warning=, failure=, keep=, run= }. keep: function that writes the
-- results; run: the wear object.
local function compute_case(store, id, every)
  local start = term.clock()
  warnings.take()
  local task = tasks[store:info("task") or "wear"]
  local fine, keep, run = pcall(task, store, id, progress_of(store, id), every)
  return { id = id, seconds = term.clock() - start, warning = warning_of(store), run = run,
    keep = fine and keep or nil, failure = not fine and one_line(keep) or nil }
end

-- --- storing -------------------------------------------------------------------------------------

local function write_case(store, case)
  if case.keep then case.keep() end
  if case.warning then
    local results = store:values(case.id, "results")
    results.warning = case.warning
    store:set_values(case.id, "results", results)
  end
  store:mark(case.id, case.failure and "failed" or "done", case.failure, not case.failure and case.seconds
    or nil)
end

local function report(case)
  if case.run then case.run:close() end
  if case.warning then print_words("warned", case.id, one_line(case.warning)) end
  if case.failure then print_words("failed", case.id, case.failure) else print_words("done", case.id) end
end

-- Writes all cases in one transaction; on an error, none is written. Returns the time [s] of the commit.
local function write_cases(store, cases)
  local written
  transaction(store, function()
    for _, case in ipairs(cases) do write_case(store, case) end
    written = term.clock()
  end)
  local seconds = term.clock() - written
  for _, case in ipairs(cases) do report(case) end
  return seconds
end

-- Queue of computed cases. A commit waits for the disk, so short cases are stored together. This limits the
-- waiting time to a tenth of the computing time.
local result_queue = {}
result_queue.__index = result_queue

function result_queue:is_due() return term.clock() - self.since >= math.min(longest_wait, 10 * self.commit) end

-- Stores all cases in the queue together. If this fails, for example because the disk is full, stores each
-- case separately.
function result_queue:store()
  local cases = self.cases
  self.cases = {}
  if #cases == 0 then return end
  local fine, seconds = pcall(write_cases, self.file, cases)
  if fine then
    self.commit = seconds
  else
    for _, case in ipairs(cases) do write_cases(self.file, { case }) end
  end
  self.since = term.clock()
end

function result_queue:add(case)
  self.cases[#self.cases + 1] = case
  if self:is_due() then self:store() end
end

local function handle_line(results, line)
  if line == "store" then return results:store() end
  local id = math.tointeger(tonumber(line:match("^case (%d+)$")))
  if not id then error("worker: unknown command: " .. line) end
  local case = compute_case(results.file, id, results.every)
  print_words("computed", id)
  results:add(case)
end

-- Runs the worker. every: seconds between saves of a long case; folder: folder to which the sandbox confines
-- the worker, or "" without a sandbox; least: number of bytes that must remain free on the disk.
return function(path, every, folder, least)
  if folder ~= "" then files.confine(folder, least) end
  local results = setmetatable({ file = stores.open(path, "write"), cases = {}, since = term.clock(),
    commit = 0, every = tonumber(every) }, result_queue)
  warnings.keep()
  for line in io.lines() do
    local fine, why = pcall(handle_line, results, line)
    if not fine then print_words("broken", one_line(type(why) == "table" and why.message or why)) end
  end
end

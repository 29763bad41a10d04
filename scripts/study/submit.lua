-- Runs a study as a job array. The cases are split into shares. For each share, Slurm or GNU parallel starts
-- a process, which writes its own run file. This program follows the job, merges the shares into the study's
-- run file and restarts interrupted shares.
-- A folder beside the run file contains the script, the run files and logs of the shares, and a description
-- of the job. The folder is removed after merging. If this program is killed, the next submit of the same
-- study follows the job, or merges its results and continues.

local check = require "archard.lib.check"
local definitions = require "archard.study.definitions"
local files = require "archard.files"
local itself = require "archard.lib.itself"
local process = require "archard.process"
local progress = require "archard.lib.progress"
local report = require "archard.study.report"
local shell = require "archard.lib.shell"
local text_file = require "archard.lib.text_file"

local where = "study:submit"
local submit = {}

local texts = check.kind("a list of strings", function(v)
  if type(v) ~= "table" then return false end
  for _, text in ipairs(v) do
    if type(text) ~= "string" then return false end
  end
  return true
end)
submit.fields = { engine = check.one_of{ "slurm", "parallel", "local" }, shares = check.whole(1, 1000),
  workers = check.whole(1, 256), file = check.file, options = texts, tries = check.whole(1, 100),
  wait = check.flag, progress = check.progress }

local engines = { slurm = require "archard.slurm.array", parallel = require "archard.slurm.parallel" }

-- --- folder of a job -----------------------------------------------------------------------------

-- Returns a table with the properties and file names of a job. name: name of the job set by the engine, or
-- nil before the start.
local function describe(folder, engine, shares, name)
  return { folder = folder, engine = engine, shares = shares, name = name,
    script = folder .. "/share.sh", note = folder .. "/job", blank = folder .. "/blank.archard",
    file = function(i) return ("%s/%s-of-%d.archard"):format(folder, i, shares) end,
    log = function(i) return ("%s/%s-of-%d.log"):format(folder, i, shares) end }
end

local function write_note(job)
  files.write(where, job.note, ("%s %d %s\n"):format(job.engine, job.shares, job.name or "-"))
end

-- Returns the job that the note in the folder describes. Returns nil if the note is missing or incomplete, or
-- names an unknown engine.
local function noted(folder)
  local word, count, name = (text_file.read(folder .. "/job") or ""):match("^(%a+) (%d+) (%S+)\n$")
  local engine, shares = engines[word], count and math.tointeger(tonumber(count))
  if not engine or not submit.fields.shares.test(shares) then return nil end
  if name ~= "-" and not engine.is_name(name) then return nil end
  return describe(folder, word, shares, name ~= "-" and name or nil)
end

-- Raises an error if the folder of a job is a link, or contains a link or a pipe: through a link, a program would
-- change a file elsewhere.
local function check_folder(folder)
  local function refuse(path, expected, kind)
    check.fail(where, ("%s: expected a %s, got a %s; remove it"):format(path, expected, kind))
  end
  local kind = process.kind(folder)
  if kind and kind ~= "folder" then refuse(folder, "folder of this study", kind) end
  for _, name in ipairs(process.files(folder) or {}) do
    kind = process.kind(folder .. "/" .. name)
    if kind and kind ~= "file" and kind ~= "folder" then refuse(folder .. "/" .. name, "file", kind) end
  end
end

-- Removes a run file, and its journal and lock file, which remain if a program is killed.
local function remove_store(path)
  for _, ending in ipairs{ "", "-journal", ".lock" } do os.remove(path .. ending) end
end

-- Removes all files of this job and of earlier jobs from the folder, including journals without a run file,
-- and then the folder. Other files are not removed.
local function clear(job)
  local names = process.files(job.folder) or {}
  for _, name in ipairs(names) do
    if name:find "^%w+%-of%-%d+%.log$" or name:find "^%d+%-of%-%d+%.archard" or name:find "^%.archard%-part%-" then
      remove_store(job.folder .. "/" .. name)
    end
  end
  remove_store(job.blank)
  for _, path in ipairs{ job.script, job.note, job.folder } do os.remove(path) end
end

-- --- following -----------------------------------------------------------------------------------

-- Returns how many cases a share has finished. The number is read from the last line of its log.
local function gone_through(path)
  local file <close> = io.open(path, "r")
  if not file then return 0 end
  file:seek("end", -math.min(file:seek("end"), 1000))
  local count = 0
  for number in ("\n" .. file:read("a")):gmatch("\n(%d+)/%d+  case ") do count = tonumber(number) end
  return count
end

local function counted(job)
  local sum = 0
  for i = 1, job.shares do sum = sum + gone_through(job.log(i)) end
  return sum
end

-- Makes the progress display of a job. mode: as the option progress of study:run.
local function display(total, mode)
  local last
  local bar = mode == nil and progress.new{ total = total, label = "study", unit = "cases" }
  return {
    show = function(done, note)
      if bar then return bar:update(done, note) end
      if not mode or done == last then return end
      last = done
      if mode ~= "lines" then return check.call(mode, { done = done, total = total }) end
      print(("%d/%d  %s"):format(done, total, note))
      io.flush()
    end,
    close = function() if bar then bar:close() end end,
  }
end

local patience = 30 -- largest number of consecutive failed queries of the job's state

-- Waits until the job has ended. The interval between queries of its state increases to 10 s.
local function follow(job, total, mode)
  local shown <close> = setmetatable(display(total, mode), { __close = function(self) self.close() end })
  local pause, silent = 0.2, 0
  while true do
    local state, why = engines[job.engine].state(job)
    if state == nil then break end
    silent = state and 0 or silent + 1
    if silent > patience then
      check.fail(where, ("job %s: %s does not report its state: %s"):format(job.name, job.engine, why),
        "IO")
    end
    shown.show(counted(job), ("job %s: %s"):format(job.name, state or "no answer"))
    process.pause(pause, ("job %s continues in the background; submit again to follow it"):format(job.name))
    pause = math.min(1.3 * pause, 10)
  end
  shown.show(counted(job), "ended")
end

-- --- merging -------------------------------------------------------------------------------------

-- Merges the finished cases of a share. A missing file is not an error, because another submit of the same
-- study may have merged it.
local function take(store, job, path)
  local fine, why = pcall(store.merge, store, path)
  if fine or not text_file.exists(path) then return end
  local message, code = check.reason(why)
  if not message then error(why, 0) end
  check.fail(where, ("%s; remove the folder %s to continue without the results of its shares"):format(message,
    job.folder), code)
end

-- Merges the shares of an ended job, and removes each file after it has been merged.
local function join(store, job)
  for i = 1, job.shares do
    local path = job.file(i)
    if text_file.exists(path) then
      take(store, job, path)
      os.remove(path)
    end
  end
  store:release()
end

local function of_status(store, status)
  local list = {}
  for _, case in ipairs(store:cases()) do
    if case.status == status then list[#list + 1] = case end
  end
  return list
end

-- --- starting ------------------------------------------------------------------------------------

local function absolute(path)
  local text, fine = shell.ask(('whole=$(realpath -m -- %s) && printf %%s/ "$whole"'):format(shell.quote(path)))
  if fine and text:find "%c" then check.fail(where, "field 'file': the name of the file's folder contains a control character") end
  if fine then return text:sub(1, -2) end
  check.fail(where, ("%s: the shell cannot determine its absolute path: %s"):format(path,
    text ~= "" and text or "no output (is the limit of open files too low?)"), "IO")
end

-- Returns the shell script of a share. Its number is in SLURM_ARRAY_TASK_ID, else in the first argument of
-- the script.
local function script_of(job, whole)
  local program = process.program() or check.fail(where, "the path of this program is unknown", "IO")
  local chunk = itself.chunk("study.share", whole, job.folder, job.shares, job.workers)
  return ("#!/bin/sh\n# One share of a study; written by s:submit{}.\nARCHARD_SHARE=${SLURM_ARRAY_TASK_ID:-$1}\n"
    .. "export ARCHARD_SHARE\nexec %s\n"):format(shell.line{ program, "-e", chunk })
end

-- Writes a run file with the definitions and no results. Each share starts from a copy of this file.
local function write_blank(self, path)
  remove_store(path)
  local store <close> = definitions.open(where, path, "create")
  definitions.write(self, store)
end

local function start(self, job, whole)
  local made, why = process.make_folder(job.folder)
  if not made then check.fail(where, ("folder %s: %s"):format(job.folder, why), "IO") end
  files.write(where, job.script, script_of(job, whole))
  write_blank(self, job.blank)
  for i = 1, job.shares do os.remove(job.log(i)) end
  write_note(job)
  job.name, why = engines[job.engine].start(job)
  if not job.name then
    clear(job)
    check.fail(where, ("%s refused the job: %s"):format(engines[job.engine].program, why), "IO")
  end
  write_note(job)
end

-- Returns the reason for a job without results: the last line of a share's log, else the first line of the
-- engine's log.
local function last_words(job)
  for i = 1, job.shares do
    local line = (text_file.read(job.log(i)) or ""):match("([^\n]+)%s*$")
    if line then return line end
  end
  return (text_file.read(job.log("parallel")) or ""):match("[^\n]+")
    or "the logs of its shares are empty; see " .. job.folder
end

-- --- running -------------------------------------------------------------------------------------

-- Sets failed cases to "waiting", so that they are computed again, and returns all waiting cases.
local function prepare(whole)
  local store <close> = definitions.open(where, whole, "write")
  for _, case in ipairs(of_status(store, "failed")) do store:mark(case.id, "waiting") end
  store:release()
  return of_status(store, "waiting")
end

-- Returns a new job. waiting: number of cases to compute.
local function new_job(folder, options, waiting)
  local job = describe(folder, options.engine, math.min(options.shares, waiting))
  job.workers, job.options = options.workers or 1, options.options or {}
  return job
end

-- Runs the waiting cases as one job and merges the results. Returns the job and the number of cases still
-- waiting. Raises an error if the job finished no case.
local function round(self, options, folder, whole, waiting)
  local job = new_job(folder, options, waiting)
  start(self, job, whole)
  if options.wait == false then return job end
  follow(job, waiting, options.progress)
  local store <close> = definitions.open(where, whole, "write")
  join(store, job)
  local left = #of_status(store, "waiting")
  if left == waiting then
    check.fail(where, ("job %s ended without a result: %s"):format(job.name, last_words(job)), "IO")
  end
  return job, left
end

-- Returns the cases in the list `asked` that have warnings, each as { id=, label=, message= }.
local function warned_of(store, asked)
  local list = {}
  for _, case in ipairs(asked) do
    local text = store:values(case.id, "results").warning
    if text then list[#list + 1] = { id = case.id, label = case.label, message = check.plain(tostring(text)) } end
  end
  return list
end

local function finish(self, store, asked)
  self.failed, self.warned = of_status(store, "failed"), warned_of(store, asked)
  local waiting = #of_status(store, "waiting")
  report(self.failed, self.warned)
  if waiting > 0 then
    io.stderr:write(("study: %d cases were interrupted; submit again to continue\n"):format(waiting))
  end
end

-- Raises an error if the program of an engine is missing. advice: end of the message, or nil.
local function check_engine(name, advice)
  local program = engines[name].program
  if not shell.has(program) then
    check.fail(where, ("field 'engine': \"%s\" needs the program %s, which is not in PATH%s"):format(
      name, program, advice or ""), "MISSING")
  end
end

-- Waits for the job of an earlier submit, if any, and merges its results. Returns false if the job is still
-- running and options.wait is false.
local function earlier(self, folder, whole, options)
  local job = noted(folder)
  if not job then return true end
  if job.name then check_engine(job.engine, "; without the job of an earlier submit, remove the folder " .. folder) end
  if job.name and engines[job.engine].state(job) ~= nil then
    io.stderr:write(("study: job %s is still running\n"):format(job.name))
    if options.wait == false then return false end
    follow(job, #self.flat, options.progress)
  end
  local store <close> = definitions.open(where, whole, "write")
  join(store, job)
  clear(job)
  return true
end

local function rounds(self, options, folder, whole)
  local asked = prepare(whole)
  local waiting, job = #asked, nil
  for _ = 1, options.tries or 3 do
    if waiting == 0 then break end
    job, waiting = round(self, options, folder, whole, waiting)
    if options.wait == false then return end
  end
  if job then clear(job) end
  local store <close> = definitions.open(where, whole, "write")
  finish(self, store, asked)
end

-- Runs a study as jobs and returns the study. study.file must be set; it is the run file of the study.
function submit.run(self, options)
  options.engine = options.engine or "local"
  options.shares = options.shares or process.processors()
  local whole = absolute(self.file)
  local folder = whole .. ".shares"
  if options.engine ~= "local" then check_engine(options.engine) end
  check_folder(folder)
  definitions.for_run(where, self, whole):close() -- the run file now exists and belongs to this study
  if not earlier(self, folder, whole, options) then return self end
  if options.engine == "local" then
    return self:run{ workers = math.min(options.shares, 256), progress = options.progress }
  end
  rounds(self, options, folder, whole)
  return self
end

return submit

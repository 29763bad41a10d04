-- Class study: many wear runs (cases) in one run file. This module makes and opens studies. study/run.lua
-- computes the cases, study/case.lua reads their results; study/table.lua, figures.lua and converge.lua show
-- them.

local check = require "archard.lib.check"
local lazy = require "archard.lib.lazy"
local merged = require "archard.lib.merged"
local of_samples = require "archard.uncertainty.fields"
local settings = require "archard.definition.settings"
local strict = require "archard.strict"
local text_file = require "archard.lib.text_file"

local study = {}
local methods = {}
local class = { __name = "study", __methods = methods, __fields = { "name", "file" } }

-- Default of `snapshots`, the number of times that the surfaces of a case are stored before the end of its
-- run.
local usual_snapshots = 6

local open_file = lazy("archard.study.definitions", "open")

-- --- making ------------------------------------------------------------------------------------

local definition_fields = merged({ base = check.table, vary = check.table, name = check.text, snapshots = check.whole(0),
  cases = check.list_of(check.table, "a list of tables"), task = check.one_of{ "wear", "converge" },
  sample = check.table }, of_samples)

-- Reads the samples of a study; returns nil if there are none. Without samples, fields such as n and seed
-- raise an error.
local function read_sample(where, given)
  if given.sample then return require "archard.uncertainty.design".read(where, given) end
  for _, name in ipairs{ "n", "design", "seed", "indices" } do
    if given[name] ~= nil then
      check.fail(where, ("field '%s' needs samples: give sample={...}"):format(name))
    end
  end
end

local function refuse_two(where, given)
  for _, pair in ipairs{ { "vary", "cases" }, { "vary", "sample" }, { "cases", "sample" } } do
    if given[pair[1]] and given[pair[2]] then
      check.fail(where, ("fields '%s' and '%s': expected one of them, got both"):format(pair[1], pair[2]))
    end
  end
end

-- Returns the flat settings of all cases. Without `vary`, `cases` and `sample`, `base` is the only case.
local function expand(where, given, sample)
  refuse_two(where, given)
  local cases = given.cases or sample and require "archard.uncertainty.design".cases(sample)
    or settings.grid(where, given.vary or {})
  local flat = {}
  for i, case in ipairs(cases) do flat[i] = settings.join(where, given.base or {}, case) end
  if sample then require "archard.uncertainty.one_mesh"(sample, flat) end
  return flat
end

local function new(where, given)
  given = check.definition(where, given, definition_fields)
  local sample = read_sample(where, given)
  local self = { name = given.name or "study", named = given.name ~= nil, flat = expand(where, given, sample), task = given.task,
    snapshots = given.snapshots or sample and 0 or usual_snapshots, sample = sample }
  if not given.task then require "archard.study.names"(where, self.flat) end
  self.varied = settings.varied(self.flat)
  self.labels = {}
  for i, case in ipairs(self.flat) do self.labels[i] = settings.label(case, self.varied) end
  return setmetatable(self, class)
end

-- study.paper(base) returns a study of the 20 cases in Table 1 of the paper. `base` may contain more fields
-- of wear{}. If the elements are smaller than in the paper, the cycles per update are reduced in proportion.
function study.paper(base)
  base = check.definition("study.paper", base or {}, check.anything)
  local size = settings.flatten("study.paper", base or {})["model.mesh.size"]
  return new("study.paper", { name = "paper", base = base,
    cases = require "archard.study.paper".cases(type(size) == "number" and size or nil) })
end

-- study.meshes(base) returns a study of the paper's cases with the shortest stroke, on successively finer
-- meshes.
function study.meshes(base)
  base = check.definition("study.meshes", base or {}, check.anything)
  return new("study.meshes", { name = "meshes of the paper", base = base, snapshots = 0,
    cases = require "archard.study.paper".mesh_cases() })
end

-- study.trials(base) returns a study of the runs of the paper's convergence study (Fig. 8), each integrated
-- by Eq. (4) and by Eq. (5).
function study.trials(base)
  base = check.definition("study.trials", base or {}, check.anything)
  return new("study.trials", { name = "trials", base = base, snapshots = 0,
    cases = require "archard.study.paper".trial_cases() })
end

-- --- run files ---------------------------------------------------------------------------------

-- study.open(path) opens the study in a run file. Its results can be read, and it can be continued.
function study.open(path)
  if not check.file.test(path) then
    check.fail("study.open", ("expected the name of a run file, got %s"):format(check.shown(path)))
  end
  local store = open_file("study.open", path, "read")
  check.as("study.open", store.check, store)
  local there = require "archard.study.stored"("study.open", store)
  local self = new("study.open", { name = there.name, cases = { {} }, snapshots = there.snapshots, task = there.task })
  self.sample, self.flat, self.varied, self.labels = there.sample, there.flat, settings.varied(there.flat), {}
  for i, case in ipairs(self.flat) do self.labels[i] = settings.label(case, self.varied) end
  self.file, self.reading = path, store
  return self
end

-- Returns the run file. The first call opens it for reading.
function methods:store()
  if not self.reading then
    if not self.file then
      check.fail("study", "the study has no results yet: call run{}, or open its file with study.open(file)")
    end
    self.reading = open_file("study", self.file, "read")
  end
  return self.reading
end

-- --- running -----------------------------------------------------------------------------------

local shard_kind = check.kind('"i/n" with i from 1 to n', function(v)
  local i, n = tostring(v):match("^(%d+)/(%d+)$")
  i, n = tonumber(i), tonumber(n)
  return type(v) == "string" and i ~= nil and i >= 1 and n >= i
end)
local run_fields = {
  workers = check.whole(1, 256), file = check.file, shard = shard_kind, progress = check.progress,
  keep = check.positive,
}

-- Returns a function that selects the cases of share i of n: cases i, i + n, i + 2n, ... text: "i/n", or nil
-- for all cases.
local function read_shard(text)
  if not text then return nil end
  local i, n = text:match("(%d+)/(%d+)")
  return function(id) return (id - tonumber(i)) % tonumber(n) == 0 end
end

-- Makes the run of the first case, so that a value out of range is reported before any run starts. A study
-- has no cases, and is refused, if the program was killed while writing its file.
local function try_first(self, where)
  if #self.flat == 0 then
    check.fail(where, ("%s has no cases: create the study again%s"):format(self.file or "the study",
      self.file and ", and run it with this file" or ""))
  end
  if self.task then return end
  local made, run = pcall(wear, settings.nest(self.flat[1]))
  if made then return run:close() end
  if type(run) ~= "table" then error(run, 0) end
  check.fail(where, ("case 1: %s"):format(run.message), run.code)
end

-- study:run{ workers=, file=, shard="i/n", progress=, keep= } computes all unfinished cases and returns the
-- study. After the call, study.failed lists the failed cases and study.warned the cases with warnings.
function methods:run(options)
  options = options or {}
  options = check.fields("study:run", options, run_fields)
  self:close()
  try_first(self, "study:run")
  local definitions = require "archard.study.definitions"
  local path = options.file or self.file or definitions.usual_path("study:run", self)
  if self.sample and not text_file.exists(path) then require "archard.uncertainty.trial"(self) end
  local store = definitions.for_run("study:run", self, path)
  self.file = path
  local workers = options.workers or require "archard.process".processors()
  self.failed, self.warned = check.as("study:run", require "archard.study.run", store, { workers = workers,
    keep = options.keep, chosen = read_shard(options.shard), progress = options.progress })
  store:close()
  require "archard.study.report"(self.failed, self.warned)
  return self
end

-- study:submit{ engine=, shares=, workers=, file=, options=, tries=, wait=, progress= } runs the cases as a
-- job array and merges the results into the run file. Returns the study. See study/submit.lua.
function methods:submit(options)
  local submit = require "archard.study.submit"
  options = merged(check.fields("study:submit", options or {}, submit.fields))
  self:close()
  try_first(self, "study:submit")
  self.file = options.file or self.file or require "archard.study.definitions".usual_path("study:submit", self)
  return submit.run(self, options)
end

-- Returns the list of cases in the order of the study. Finished cases have results.
function methods:cases()
  local new_case = require "archard.study.case".new
  local list = {}
  if not self.file then
    for id, flat in ipairs(self.flat) do
      list[id] = new_case(self, { id = id, label = self.labels[id], status = "waiting" },
        settings.nest(flat))
    end
    return list
  end
  for i, row in ipairs(self:store():cases()) do
    list[i] = new_case(self, row, settings.nest(self.flat[i]))
  end
  return list
end

function methods:table(options) return require "archard.study.table".make(self, options) end

function methods:figures(options) return require "archard.study.figures".draw(self, options) end

function methods:uncertainty(options) return require "archard.uncertainty.result"(self, options) end

function methods:failure(given) return require "archard.uncertainty.failure"(self, given) end

-- Closes the run file if it is open.
function methods:close()
  if self.reading then self.reading:close() end
  self.reading = nil
end

-- study.converge{...} searches for element size, jump and increments; see study/converge.lua.
function study.converge(given, options)
  return require "archard.study.converge"(study, given, options)
end

-- study.fretting_map{...} computes slip regimes over load and motion amplitude; see study/fretting_map.lua.
function study.fretting_map(given)
  return require "archard.study.fretting_map"(given)
end

-- --- joining -----------------------------------------------------------------------------------

-- study.merge(file, ..., { file = }) merges the run files of the shares of one study into one file (default:
-- "study.archard"). All cases must be finished in these files.
function study.merge(...)
  local files = { ... }
  local options = type(files[#files]) == "table" and table.remove(files) or {}
  options = check.fields("study.merge", options, { file = check.file })
  for _, file in ipairs(options) do files[#files + 1] = file end
  for i, file in ipairs(files) do
    if not check.file.test(file) then
      check.fail("study.merge", ("argument %d: expected the name of a run file, got %s"):format(i,
        check.shown(file)))
    end
  end
  if #files == 0 then check.fail("study.merge", "expected the names of run files, got none") end
  return check.as("study.merge", require "archard.study.merge", files, options.file or "study.archard", study.open,
    require "archard.study.definitions".write)
end

-- --- showing -----------------------------------------------------------------------------------

local function count_by_status(self)
  local count = { waiting = 0, running = 0, done = 0, failed = 0 }
  for _, case in ipairs(self:cases()) do count[case.status] = count[case.status] + 1 end
  return count
end

function class.__tostring(self)
  local count = count_by_status(self)
  local lines = { ("study%s: %d cases%s"):format(self.name ~= "study" and " " .. self.name or "", #self.flat,
    self.file and " in " .. self.file or ""),
    ("  %d done, %d failed, %d waiting"):format(count.done, count.failed,
      count.waiting + count.running) }
  if #self.varied > 0 then lines[#lines + 1] = "  varied: " .. table.concat(self.varied, ", ") end
  return table.concat(lines, "\n")
end

strict.class(class)

return setmetatable(study, { __call = function(_, given) return new("study", given or {}) end })

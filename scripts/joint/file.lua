-- Runs of joints in run files. The settings of a case are the fields of wear{} from which the run can be
-- created again. Its results include the state, the history and the last record. The functions `save`,
-- `wear`, `history` and `surfaces` also accept runs of the engine.

local check = require "archard.lib.check"
local merged = require "archard.lib.merged"
local runs = require "archard.joint.run"
local settings = require "archard.definition.settings"
local sphere = require "archard.sphere"
local store = require "archard.store"
local strict = require "archard.strict"

local file = {}

local callable = runs.callable
local counted = { "updates", "solutions" }

-- --- runs ---------------------------------------------------------------------------------------

-- Returns the definition of a run as flat fields. A function is replaced by the string "function".
local function flat_definition(run)
  local definition = run:definition()
  for _, name in ipairs(callable) do
    if type(definition[name]) == "function" then definition[name] = "function" end
  end
  return settings.flatten("joint_wear:save", definition)
end

local function add(to, prefix, from, names)
  for _, name in ipairs(names) do to[prefix .. name] = from[name] end
end

local recorded = { "cycles", "updates", "solutions", "volume_head", "volume_cup", "p_peak", "area", "work", "penetration" }

local function flat_results(run)
  local results = { state = sphere.state(run.engine), ["record.step"] = run.step }
  add(results, "history.", run.history, runs.columns)
  add(results, "record.", run.record, recorded)
  return results
end

local function part(results, prefix)
  local found = {}
  for name, value in pairs(results) do
    local rest = name:match("^" .. prefix .. "%.(.+)$")
    if rest then found[rest] = type(value) == "table" and table.move(value, 1, #value, 1, {}) or value end
  end
  return found
end

-- Inserts the user's functions into a saved definition, in the fields with the string "function".
local function with_functions(definition, functions)
  for _, name in ipairs(callable) do
    local f = type(functions) == "table" and functions[name]
    if definition[name] == "function" and type(f) ~= "function" then
      check.fail("joint.open", ("field '%s': expected a function, as when the run was saved"):format(name))
    end
    if definition[name] == "function" then definition[name] = f end
  end
  return definition
end

local function restored(definition, results, functions)
  for _, name in ipairs{ "updates", "model.order" } do definition[name] = math.tointeger(definition[name]) end
  local run = wear(settings.nest(with_functions(definition, functions)))
  sphere.set_state(run.engine, results.state)
  local record = part(results, "record")
  for _, name in ipairs(counted) do record[name] = math.tointeger(record[name]) end
  run.step, record.step = record.step, nil
  runs.restore(run, record, part(results, "history"))
  return run
end

-- --- cases of run files: runs of a joint or of the engine ---------------------------------------

local function is_joint(value) return strict.is(value, "joint_wear") end
file.is_joint = is_joint

-- Returns the results of a case if it is a run of a joint, else nil.
local function results_of(from, id)
  local results = from:values(id, "results")
  return results.state and results or nil
end

-- Saves a run as the case `id` of a file. surfaces: surfaces at earlier updates, for a run of the engine;
-- others: further results by name, or nil.
function file.save(to, id, run, surfaces, others)
  if not is_joint(run) then
    to:save(id, run, surfaces)
    return others and to:set_values(id, "results", others)
  end
  to:set_values(id, "definition", flat_definition(run))
  to:set_values(id, "results", merged(others or {}, flat_results(run)))
end

function file.wear(from, id, functions)
  local results = results_of(from, id)
  if not results then return from:wear(id, functions) end
  local fine, run = pcall(restored, from:values(id, "definition"), results, functions)
  if fine then return run end
  if type(run) == "table" and run.message then error(run, 0) end
  check.fail("joint.open", from.path .. ": the file is damaged: " .. tostring(run), "FORMAT")
end

function file.history(from, id)
  local results = results_of(from, id)
  return results and runs.history(part(results, "history")) or from:history(id)
end

function file.surfaces(from, id) return results_of(from, id) and {} or from:surfaces(id) end

-- Returns the definition of a run as flat fields, as they are stored in a run file.
function file.definition(run)
  local path = os.tmpname()
  os.remove(path)
  local to <close> = store.open(path, "create")
  local fine, values = pcall(function()
    to:add(1, "run")
    file.save(to, 1, run, {})
    return to:values(1, "definition")
  end)
  to:close()
  os.remove(path)
  if not fine then error(values, 0) end
  return values
end

-- --- files of one run ---------------------------------------------------------------------------

local function check_path(where, path)
  if not check.file.test(path) then check.refuse(where, "path", "a file name", path) end
end

-- Saves a run in a file, completely or not at all. An existing file of a joint is replaced; any other
-- existing file is refused.
function file.write(run, path)
  check_path("joint_wear:save", path)
  check.as("joint_wear:save", function()
    local to <close> = store.replace(path, "joint")
    to:begin()
    to:set_info("program", "archard " .. require "archard".version)
    to:add(1, "wear of a joint")
    file.save(to, 1, run)
    to:mark(1, "done")
    to:commit()
    to:publish()
  end)
  run.saved = run.update
  return run
end

local function read(path, functions)
  local from <close> = store.open(path, "read")
  from:check()
  local kind = from:info "kind"
  if kind ~= "joint" then
    check.fail("joint.open", ("%s: expected a file saved by w:save of a joint, got a run file of kind %s"):format(path, tostring(kind)),
      "FORMAT")
  end
  if not results_of(from, 1) then check.fail("joint.open", path .. ": the file is damaged: it has no state", "FORMAT") end
  return file.wear(from, 1, functions)
end

function file.open(path, functions)
  check_path("joint.open", path)
  return check.as("joint.open", read, path, functions)
end

-- Returns the run of case `id` of a run file if it is a run of a joint, else nil. functions: the user's
-- functions by name.
function file.open_case(path, functions, id)
  local from <close> = store.open(path, "read")
  return results_of(from, id) and file.wear(from, id, functions)
end

return file

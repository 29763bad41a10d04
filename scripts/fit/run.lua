-- Lua functions fit and fit.design: check the user's fields and make the problem that fit/solve.lua solves.

local check = require "archard.lib.check"
local check_names = require "archard.study.names"
local data = require "archard.fit.data"
local measure = require "archard.measure"
local merged = require "archard.lib.merged"
local naming = require "archard.plot.naming"
local problems = require "archard.fit.problem"
local result = require "archard.fit.result"
local run_counter = require "archard.lib.run_counter"
local runs = require "archard.fit.runs"
local solve = require "archard.fit.solve"
local unknown = require "archard.fit.unknown"

local fit = {}

local where = "fit"
local model_kind = check.kind("a model object or a table of its fields", function(v)
  return type(v) == "userdata" or type(v) == "table"
end)
local common = { model = model_kind, base = check.table, unknown = check.table, file = check.file,
  workers = check.whole(1, 256), progress = check.progress, confidence = check.share }
local fields = merged(common, { data = check.table })

-- Raises an error if a field occurs both in `base` and in `unknown`.
local function refuse_double(name, base, unknowns)
  for field in pairs(unknowns) do
    if base[field] ~= nil then
      check.fail(name, ("field 'base.%s': %s is an unknown; give its start value in unknown.%s"):format(field, field, field))
    end
  end
end

-- Returns the fields of wear{} that all runs share. The sliding distance is extended to the last measurement.
local function base_of(name, given, what)
  local base = merged(check.definition(name, given.base or {}, check.anything, nil, "base"), { model = given.model })
  local flat = {}
  for field in pairs(base) do flat[tostring(field)] = 0 end
  check_names(name, { flat })
  refuse_double(name, base, given.unknown)
  local last = what.distances[#what.distances]
  if base.cycles == nil and base.loading == nil and (base.distance or 1320) < last then
    base.distance = last
  end
  return base
end

local function start_of(unknowns)
  local values = {}
  for i, one in ipairs(unknowns) do values[i] = one.start end
  return values
end

local function is_by_force(base)
  local loading = base.loading
  if base.tangential ~= nil or type(loading) ~= "table" then return base.tangential ~= nil end
  return loading.tangential ~= nil or type(loading[1]) == "table" and loading[1].tangential ~= nil
end

-- Returns a table that describes the motion for data.read: path() returns the sliding distance of a cycle
-- [mm], and by_force is true if a force drives the runs.
local function motion_of(name, given, unknowns)
  local base = merged(given.base, { model = given.model })
  local function path()
    local first = runs.new(name, base, unknowns, nil, {}):given(start_of(unknowns))
    local run <close> = wear(first)
    return run.total_distance / run.cycles
  end
  return { path = path, by_force = is_by_force(base) }
end

-- Returns the user's model: field `model`, else base.model, else nil.
local function model_of(given)
  if given.model ~= nil then return given.model end
  return type(given.base) == "table" and given.base.model or nil
end

-- Returns the measurements of `given` with the roles "cylinder" and "plate" for bodies that are given by the
-- names of the user's model.
local function with_roles(given)
  local model, list = model_of(given), {}
  local names = measure.bodies((type(model) == "table" or type(model) == "userdata") and model or nil)
  for i, one in ipairs(given.data) do
    local body = type(one) == "table" and type(one.body) == "string" and rawget(one, "body")
    local name = body and not data.kinds.body.test(body) and naming.get(names, body)
    list[i] = name and merged(one, { body = name == names.upper and "cylinder" or "plate" }) or one
  end
  return #list > 0 and list or given.data
end

-- Makes the problem of a fit or a design. each: estimated number of runs for each unknown, for the progress
-- display.
local function prepare(name, given, items, each)
  local unknowns = unknown.read(name, given.unknown, model_of(given))
  local what = data.required(items)
  local options = { file = given.file, workers = given.workers, progress = given.progress,
    counter = run_counter.new(name, 3 + each * (#unknowns + 1), given.progress) }
  local all = runs.new(name, base_of(name, given, what), unknowns, what, options)
  return problems.new(name, unknowns, items, all)
end

-- Raises an error if there are more unknowns than data values. If the user gave no errors, estimating them
-- needs one more value.
local function refuse_few(problem, told)
  local count, needed = #problem.measured, #problem.parameters
  if count > needed or told and count == needed then return end
  check.fail(where, ("too few data: %d value%s for %d unknown%s (%d fields, %d positions of profiles and loops); "
    .. "add data, remove unknowns, or fix shift, tilt and level%s"):format(count, count == 1 and "" or "s",
    needed, needed == 1 and "" or "s", #problem.unknowns, #problem.positions,
    count == needed and "; if the data have the field 'error', this number suffices" or ""))
end

local function need(name, given, list)
  for _, field in ipairs(list) do
    if given[field] == nil then check.refuse(name, field, fields[field].expected, nil) end
  end
end

-- Runs fit{ model=, base=, unknown=, data=, file=, workers=, progress=, confidence= } and returns the result.
local function run(given)
  given = check.definition(where, given, fields)
  need(where, given, { "unknown", "data" })
  local unknowns = unknown.read(where, given.unknown, model_of(given))
  local items, told = data.read(where, with_roles(given), motion_of(where, given, unknowns))
  local problem = prepare(where, given, items, 8)
  local _ <close> = problem.runs.counter
  refuse_few(problem, told)
  data.check_sizes(where, items, problem.runs:one(start_of(unknowns)))
  local found = solve.fit(problem, unknown.smooth(problem.unknowns), told)
  return result.new(problem, found, told, given.confidence or 0.95)
end

function fit.design(given)
  return require "archard.fit.design"(given, common, prepare)
end

fit.run = run

return fit

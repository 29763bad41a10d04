-- Manages the runs of a fit, one for each set of values of the unknowns. The runs are computed by this
-- process or, if a run file is given, by the workers of a study. A run that the file contains is not
-- computed again, even in a later call.

local check = require "archard.lib.check"
local finer = require "archard.fit.finer"
local observe = require "archard.study.observe"
local settings = require "archard.definition.settings"
local transaction = require "archard.study.transaction"
local unknown = require "archard.fit.unknown"

local runs = {}
runs.__index = runs

-- Returns the label of a run: the names and values of the unknowns, with all digits.
local function label_of(self, values, refined)
  local words = {}
  for i, one in ipairs(self.unknowns) do words[i] = ("%s %.17g"):format(one.name, values[i]) end
  return table.concat(words, ", ") .. (refined and ", half the element size" or "")
end

local function deep(where, given, prefix)
  if type(given) ~= "table" or getmetatable(given) then return given end
  check.depth(where, prefix)
  local copy = {}
  for name, value in pairs(given) do copy[name] = deep(where, value, prefix .. tostring(name) .. ".") end
  return copy
end

-- Returns the fields of wear{} of a run. values: values of the unknowns; refined: true to halve the element
-- sizes, which the model must allow.
function runs:given(values, refined)
  local given = deep(self.where, self.base, "base.")
  for name, value in pairs(unknown.settings(self.unknowns, values)) do
    local at, last = settings.place(given, name)
    at[last] = value
  end
  return refined and finer(self.where, given) or given
end

-- --- runs in this process ------------------------------------------------------------------------

local function fail_at(self, each, why)
  local message, code = check.reason(why)
  if not message or code == "STOPPED" or each.refined then error(why, 0) end
  check.fail(self.where, ("the run with %s failed: %s. Narrower bounds (low, high) can keep the search "
    .. "away from these values"):format(each.label, message), code)
end

-- Computes one run and stores its results. Only the first run of a fit prints its warnings.
local function compute_here(self, each)
  if self.count > 0 then warn "@off" end
  local fine, readings, run = pcall(observe.run, self:given(each.values, each.refined), self.what)
  warn "@on"
  if not fine then fail_at(self, each, readings) end
  run:close()
  self.count = self.count + 1
  self.known[each.label] = readings
  if self.counter then self.counter:ran() end
  if type(self.progress) == "function" then check.call(self.progress, self.count, each.label) end
end

-- --- runs by workers, stored in a run file -------------------------------------------------------

local function same_fit(self, store)
  local base = observe.text(self.what) .. "\n" .. self.fingerprint
  if #store:cases() == 0 and not store:info("kind") then
    store:set_info("kind", "fit")
    store:set_info("task", "fit")
    store:set_info("name", "fit")
    store:set_info("observe", observe.text(self.what))
    store:set_info("fit", base)
    store:set_info("program", "archard " .. require "archard".version)
  elseif store:info("kind") ~= "fit" or store:info("fit") ~= base then
    check.fail(self.where, ("%s contains another fit or other data; give another file name, or remove the file"):format(
      store.path), "ARGUMENT")
  end
end

-- Returns the settings common to all runs as text. A later call compares this text with the text in the run
-- file to check that the file belongs to the same fit.
local function fingerprint(where, base)
  local lines = {}
  for name, value in pairs(settings.carrier(where)(settings.flatten(where, base))) do
    if type(value) == "table" then value = table.concat(value, " ") end
    lines[#lines + 1] = name .. "=" .. tostring(value)
  end
  table.sort(lines)
  return table.concat(lines, "\n")
end

local function open(self)
  local store = check.as(self.where, require "archard.store".open, self.file, "create")
  store:check()
  transaction(store, same_fit, self, store)
  for _, case in ipairs(store:cases()) do
    self.cases[case.label] = case.id
    self.last = math.max(self.last, case.id)
  end
  return store
end

local function add_cases(self, store, wanted)
  local carried = settings.carrier(self.where)
  for _, each in ipairs(wanted) do
    if not self.cases[each.label] then
      self.last = self.last + 1
      self.cases[each.label] = self.last
      store:add(self.last, each.label)
      store:set_values(self.last, "settings", carried(settings.flatten(self.where,
        self:given(each.values, each.refined))))
    end
  end
end

local function numbers(list)
  return table.move(list, 1, #list, 1, {})
end

local function from_store(store, id)
  local readings = settings.nest(store:values(id, "results")).looks
  for _, reading in ipairs(readings) do
    for name, values in pairs(reading) do
      if type(values) == "table" and values.h then reading[name] = { x = numbers(values.x), h = numbers(values.h) } end
    end
    local loop = reading.loop
    if loop then reading.loop = { x = numbers(loop.x), tangential = numbers(loop.tangential) } end
  end
  return readings
end

local function compute_by_workers(self, wanted)
  local store <close> = open(self)
  transaction(store, add_cases, self, store, wanted)
  local failed, _, count = require "archard.study.run"(store, { workers = self.workers,
    progress = self.progress or false })
  self.count = self.count + count
  if self.counter then self.counter:ran(count) end
  local reasons = {}
  for _, each in ipairs(failed) do reasons[each.label] = { message = each.message, code = "NUMERIC" } end
  for _, each in ipairs(wanted) do
    if reasons[each.label] then fail_at(self, each, reasons[each.label]) end
  end
  for _, each in ipairs(wanted) do self.known[each.label] = from_store(store, self.cases[each.label]) end
end

-- --- both ----------------------------------------------------------------------------------------

-- Returns the results of one run for each set of values in `list`, in the order of `list`. Runs that are not
-- yet known are computed.
function runs:many(list, refined)
  local wanted, seen, result = {}, {}, {}
  for _, values in ipairs(list) do
    local label = label_of(self, values, refined)
    if not self.known[label] and not seen[label] then
      wanted[#wanted + 1], seen[label] = { label = label, values = values, refined = refined }, true
    end
  end
  if self.file and #wanted > 0 then
    compute_by_workers(self, wanted)
  else
    for _, each in ipairs(wanted) do compute_here(self, each) end
  end
  for i, values in ipairs(list) do result[i] = self.known[label_of(self, values, refined)] end
  return result
end

function runs:one(values) return self:many{ values }[1] end

-- Returns the results of a run with half the element size; nil if the model has no element sizes.
function runs:refined(values)
  return finer(self.where, self.base) and self:many({ values }, true)[1] or nil
end

-- Returns the run for a set of values as a wear object, advanced to the last distance.
function runs:wear(values)
  local _, run = observe.run(self:given(values), self.what)
  return run
end

-- Converts a model object to a table of its fields if an unknown changes a field of the model.
local function open_model(where, base, unknowns)
  for _, one in ipairs(unknowns) do
    if one.paths[1]:match("^model%.") and base.model ~= nil then
      base.model = settings.nest(settings.flatten(where, { model = base.model })).model
      return
    end
  end
end

-- Makes an empty collection of runs. options: file, workers, progress, and counter (a run_counter).
function runs.new(where, base, unknowns, what, options)
  local self = setmetatable({ where = where, base = deep(where, base, "base."), unknowns = unknowns, what = what,
    file = options.file, progress = options.progress, counter = options.counter, known = {}, cases = {}, last = 0, count = 0,
    workers = options.workers or require "archard.process".processors() }, runs)
  open_model(where, self.base, unknowns)
  if self.file then self.fingerprint = fingerprint(where, self.base) end
  return self
end

return runs

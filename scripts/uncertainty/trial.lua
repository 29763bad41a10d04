-- Checks, before a sampled study starts, that the smallest and the largest sampled value of each field are
-- valid and change the result. The check needs two runs for each field.

local check = require "archard.lib.check"
local merged = require "archard.lib.merged"
local settings = require "archard.definition.settings"

local where = "study:run"

local function ends_of(flat, name)
  local low, high = flat[1][name], flat[1][name]
  for _, case in ipairs(flat) do low, high = math.min(low, case[name]), math.max(high, case[name]) end
  return low, high
end

-- Returns the history of the first case with the field `name` set to `value`, or false if the run fails.
local function history_with(flat, name, value)
  local made, run = pcall(wear, settings.nest(merged(flat[1], { [name] = value })))
  if not made then
    local message = type(run) == "table" and run.message or tostring(run)
    check.fail(where, ("field 'sample.%s': a run with the sampled value %g is refused (%s); set low= and "
      .. "high= of the distribution to limits within the valid range; the deviation is in the unit of the value, not a share"):format(name, value, message))
  end
  local fine, why = pcall(run.run, run, { progress = false })
  local history = run.history
  run:close()
  if not fine and type(why) == "table" and why.code == "STOPPED" then error(why, 0) end
  return fine and history
end

-- Columns that only repeat settings. same(a, b) ignores these columns and returns true if two histories are
-- equal.
local setting_columns = { load = true, k = true, alpha = true, jump = true }

local function equal(x, y)
  if #x ~= #y then return false end
  for i = 1, #x do
    if x[i] ~= y[i] and (x[i] == x[i] or y[i] == y[i]) then return false end -- two NaN count as equal
  end
  return true
end

local function same(a, b)
  for name, column in pairs(a) do
    if not setting_columns[name] and not equal(column, b[name]) then return false end
  end
  return true
end

-- Raises an error if a field has no effect, for example because another field replaces it. An index of 0 for
-- this field would be misleading.
return function(study)
  for _, field in ipairs(study.sample.fields) do
    local low, high = ends_of(study.flat, field.name)
    local a, b = history_with(study.flat, field.name, low), history_with(study.flat, field.name, high)
    if a and b and same(a, b) then
      check.fail(where, ("field 'sample.%s': it has no effect: %g and %g give the same run (does "
        .. "another field replace it?)"):format(field.name, low, high))
    end
  end
end

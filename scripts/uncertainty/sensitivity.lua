-- Lua method w:sensitivity{ of=, to= }: returns derivatives and elasticities of results with respect to
-- numbers of the definition, with their errors, at all distances of the history. An elasticity is the
-- relative change of a result divided by the relative change of the number. Each number is varied by itself.
-- Smooth results are differentiated by uncertainty/plateau.lua. Some results, such as half widths, change in
-- steps from node to node; their slopes over a range of the number are computed by uncertainty/slope.lua.

local aligned = require "archard.lib.aligned"
local changer = require "archard.uncertainty.changer"
local check = require "archard.lib.check"
local derive = require "archard.uncertainty.plateau"
local outcomes = require "archard.uncertainty.outcomes"
local repeated = require "archard.uncertainty.repeated"
local run_counter = require "archard.lib.run_counter"
local slope = require "archard.uncertainty.slope"
local strict = require "archard.strict"

local where = "wear:sensitivity"

local class = strict.class{ __name = "sensitivity", __fields = { "of", "to", "distance", "runs" } }

local shares = check.kind("a relative change from 0 to 0.5", function(v)
  return check.number.test(v) and v >= 0 and v <= 0.5
end)
local fields = { of = check.any "names", to = check.any "names", over = shares }

local function names_of(name, given, usual)
  given = given == nil and usual or given
  local list = type(given) == "table" and given or { given }
  for _, each in ipairs(list) do
    if type(each) ~= "string" then check.refuse(where, name, "a name or a list of names", each) end
  end
  if #list == 0 then check.refuse(where, name, "a name or a list of names", given) end
  return list
end

-- Returns the distances of the history [mm], without distance 0 at the start of the run.
local function distances_of(run)
  local list = {}
  for i, d in ipairs(run.history.distance) do
    if i > 1 then list[#list + 1] = d end
  end
  if #list == 0 then check.fail(where, "the run has not started: call run{} first") end
  return list
end

local function values_of(run, names)
  local list, history = {}, run.history
  for _, name in ipairs(names) do
    for i = 2, #history.distance do list[#list + 1] = history[name][i] end
  end
  return list
end

-- Returns the relative tolerance for differences between a run and its repetition. For runs with automatic
-- steps it is larger, because automatic steps are corrected by their error estimate, and repeated steps are
-- not. In other runs only rounding errors occur.
local function tolerance_of(definition) return definition.steps_chosen and 0.02 or 1e-9 end

-- Raises an error if the definition does not reproduce the run, because changed runs could then not be
-- compared with it.
local function check_repeats(run, definition, distances)
  local state = outcomes.usual(run)
  if state[3] == "p_peak" then state[3] = nil end -- p_peak is not compared, because it depends on the lengths of the steps
  local again, tolerance = repeated.run(definition, distances, state), tolerance_of(definition)
  for i, value in ipairs(values_of(run, state)) do
    if math.abs(value - again[i]) > tolerance * math.abs(value) then
      check.fail(where, "the run cannot be repeated from its definition: it was changed during the run "
        .. "(w:set), or started from a worn shape")
    end
  end
end

-- --- one number ----------------------------------------------------------------------------------

-- first_step: relative change of the varied number in the first difference; smallest_step: limit below which
-- a change is not reduced further if runs fail near the end of the valid range.
local first_step, smallest_step = 0.03, 0.0004

local counting -- counter of the runs in the current call, for the progress display

local function results_at(self, definition)
  self.runs = self.runs + 1
  counting:ran()
  return repeated.run(definition, self.distance, self.of)
end

-- Returns a function(h) that computes central differences: (results at value + h - results at value - h) / (2
-- h). set(x) returns the definition with the value x of the varied number; `changed`, if given, is a function
-- that modifies this definition.
local function differences_for(self, value, set, changed)
  local function results(at)
    local definition = set(at)
    return results_at(self, changed and changed(definition) or definition)
  end
  return function(h)
    local above, below = results(value + h), results(value - h)
    local list = {}
    for i = 1, #above do list[i] = (above[i] - below[i]) / (2 * h) end
    return list
  end
end

-- Returns the central differences for a change h in runs whose steps are divided into `parts` equal steps.
local function with_parts(self, value, set, h, parts)
  return differences_for(self, value, set, function(definition)
    return repeated.in_parts(definition, parts)
  end)(h)
end

-- Refined runs divide each step into these numbers of parts, to correct the error that automatic steps
-- cause in a derivative. The remaining error is estimated as twice the change from the last halving, plus a
-- quarter of the correction.
local coarse_parts, fine_parts = 4, 8

local function step_error(whole, coarse, fine)
  return 2 * math.abs(fine - coarse) + math.abs(fine - whole) / 4
end

local function refine(self, value, set, h, found)
  local whole, coarse = with_parts(self, value, set, h, 1), with_parts(self, value, set, h, coarse_parts)
  for i, fine in ipairs(with_parts(self, value, set, h, fine_parts)) do
    found[i].value = found[i].value + fine - whole[i]
    found[i].error = found[i].error + step_error(whole[i], coarse[i], fine)
  end
  return found
end

local function raise_stop(why)
  if type(why) ~= "table" or why.code == "STOPPED" then error(why, 0) end
end

-- --- results that change in steps ----------------------------------------------------------------

-- widest: default of the largest relative change of the varied number; side: number of runs with larger
-- values, and with smaller values; rippled: ripple (see slope.lua) above which the slope over the range
-- replaces the derivative.
local widest, side, rippled = 0.24, 8, 0.03

-- Computes runs with evenly spaced relative changes of the varied number, from -share to share. Returns the
-- points (relative change / share) and the results of the runs. The outermost runs are computed first,
-- because they fail if the varied number leaves its valid range.
local function wide_runs(self, value, set, share)
  local points, lists = {}, {}
  for j = side, 0, -1 do
    for _, t in ipairs(j > 0 and { j / side, -j / side } or { 0 }) do
      points[#points + 1] = t
      lists[#lists + 1] = results_at(self, set(value * (1 + share * t)))
    end
  end
  return points, lists
end

local function in_order(points, lists, m)
  local t, y = {}, {}
  for p, at in ipairs(points) do
    local i = math.tointeger(at * side) + side + 1
    t[i], y[i] = at, lists[p][m]
  end
  return t, y
end

-- Replaces the derivatives of results that change in steps by slopes over a wide range of the varied number.
-- over: largest relative change of the number, which is halved while runs fail.
local function replace_rippled(self, value, set, definition, found, over)
  local share, fine, points, lists = 2 * over, false, nil, nil
  while not fine and share > 2 * first_step do
    share = share / 2
    fine, points, lists = pcall(wide_runs, self, value, set, share)
    if not fine then raise_stop(points) end
  end
  for m = 1, fine and #found or 0 do
    local one = slope(in_order(points, lists, m))
    if one.ripple > rippled then
      local unit = share * value
      found[m] = { value = one.value / unit, over = share,
        error = (one.error + tolerance_of(definition) * math.abs(one.value)) / math.abs(unit) }
    end
  end
end

-- Returns the derivatives with respect to one number. If a run fails, for example because a value is outside
-- the valid range, the change of the number is reduced.
local function derivatives(self, name, value, set, definition)
  if value == 0 then
    check.fail(where, ("field 'to': %s is 0 and cannot be changed by a percentage"):format(name))
  end
  local differences, step, why = differences_for(self, value, set), first_step, nil
  while step >= smallest_step do
    local h = step * math.abs(value)
    local fine, found = pcall(derive, differences, h)
    if fine then return definition.steps_chosen and refine(self, value, set, h / 25, found) or found end
    why, step = found, step / 4
    raise_stop(why)
  end
  check.fail(where, ("field 'to': %s cannot be changed by %g %% in both directions: %s"):format(name,
    400 * step, why.message), why.code)
end

-- Returns the elasticity, derivative * value / result. It is 0 if the derivative is 0, even if the result is
-- 0.
local function elastic(derivative, value, result)
  return derivative == 0 and 0 or derivative * value / result
end

-- Stores derivatives and elasticities in self[column][name]. found: derivatives; there: results of the run;
-- both with errors, in the same order.
local function into_columns(self, name, value, found, there)
  local n = #self.distance
  for c, column in ipairs(self.of) do
    local result = { derivative = {}, error = {}, elasticity = {}, elasticity_error = {}, over = {} }
    for i = 1, n do
      local one, y = found[(c - 1) * n + i], there[(c - 1) * n + i]
      local elasticity = elastic(one.value, value, y.value)
      result.derivative[i], result.error[i], result.elasticity[i] = one.value, one.error, elasticity
      result.over[i] = one.over or 0
      result.elasticity_error[i] = math.abs(elastic(one.error, value, y.value))
        + math.abs(elastic(elasticity, y.error, y.value))
    end
    self[column][name] = result
  end
end

-- Returns the results of the unchanged run, to which elasticities refer, with their errors. Results of runs
-- without automatic steps have no error.
local function results_of(self, run, definition)
  local there = values_of(run, self.of)
  if not definition.steps_chosen then
    for i, value in ipairs(there) do there[i] = { value = value, error = 0 } end
    return there
  end
  self.runs = self.runs + 2
  local coarse = repeated.run(repeated.in_parts(definition, coarse_parts), self.distance, self.of)
  for i, fine in ipairs(repeated.run(repeated.in_parts(definition, fine_parts), self.distance, self.of)) do
    there[i] = { value = fine, error = step_error(there[i], coarse[i], fine) }
  end
  return there
end

-- --- showing -------------------------------------------------------------------------------------

function class.__tostring(self)
  local g, rows = #self.distance, { { "of", "to", "derivative", "+-", "percent per percent", "+-", "over" } }
  for _, column in ipairs(self.of) do
    for _, name in ipairs(self.to) do
      local one = self[column][name]
      rows[#rows + 1] = { column, name, ("%.5g"):format(one.derivative[g]), ("%.1g"):format(one.error[g]),
        ("%.5f"):format(one.elasticity[g]), ("%.1g"):format(one.elasticity_error[g]),
        one.over[g] > 0 and ("+-%.3g %%"):format(100 * one.over[g]) or "" }
    end
  end
  local lines = { ("sensitivities at %g mm, from %d runs"):format(self.distance[g], self.runs) }
  for _, line in ipairs(aligned(rows)) do lines[#lines + 1] = "  " .. line end
  return table.concat(lines, "\n")
end

return function(run, given)
  given = check.definition(where, given or {}, fields)
  local self = { runs = 1, distance = distances_of(run),
    of = outcomes.names(where, names_of("of", given.of, outcomes.usual(run)), run.history) }
  local definition = repeated.definition(run)
  self.to = names_of("to", given.to, changer.usual(definition))
  local each = definition.steps_chosen and 20 or 12
  local counter <close> = run_counter.new(where, 1 + each * #self.to)
  counting = counter
  local changers = {}
  for i, name in ipairs(self.to) do changers[i] = { changer.of(run, name, definition) } end
  check_repeats(run, definition, self.distance)
  local there = results_of(self, run, definition)
  for _, column in ipairs(self.of) do self[column] = {} end
  for i, name in ipairs(self.to) do
    local value, set = changers[i][1], changers[i][2]
    local found = derivatives(self, name, value, set, definition)
    replace_rippled(self, value, set, definition, found, given.over or widest)
    into_columns(self, name, value, found, there)
  end
  return setmetatable(self, class)
end

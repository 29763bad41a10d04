-- Reads the results of a sampled study at common distances, in the order of the design. Failed cases are
-- counted and omitted.

local check = require "archard.lib.check"
local columns = require "archard.settings".columns
local joint_file = require "archard.joint.file"
local history_at = require "archard.lib.history_at"
local keys = require "archard.lib.keys"
local measure = require "archard.measure"

local outcomes = {}

-- Returns the unit of a history column, or "" if it has none. Names of depth and volume columns may contain
-- names of bodies.
function outcomes.unit(name)
  local of_bodies = { depth = "mm", volume = "mm3" }
  for _, column in ipairs(columns) do
    if column.name == name then return column.unit or "" end
  end
  return of_bodies[name:match "^%l+"] or ""
end

-- Returns the default columns for a run or case: the wear depths of both bodies, and p_center or, if there is
-- no such column, p_peak.
function outcomes.usual(run)
  local bodies = measure.bodies(run.model)
  return { "depth_" .. bodies.upper, "depth_" .. bodies.lower, run.history.p_center and "p_center" or "p_peak" }
end

-- Checks the name of a history column, or a list of such names, and returns a list. Names of columns may
-- contain the names that the user gave to the bodies, as in depth_pin.
function outcomes.names(where, of, history)
  local list = type(of) == "table" and of or { of }
  for _, name in ipairs(list) do
    if type(name) ~= "string" then check.refuse(where, "of", "the name of a column or a list of them", name) end
    if not history[name] then
      check.fail(where, ("field 'of': no column '%s' in the history%s"):format(name, check.hint(name, keys(history))))
    end
  end
  if #list == 0 then check.refuse(where, "of", "the name of a column or a list of them", of) end
  return list
end

-- Returns the rows of all cases in the run file. Raises an error if a case has not been run.
function outcomes.rows(study, where)
  if not study.sample then
    check.fail(where, ("study %s has no samples: create it with study{ sample={...} }"):format(study.name))
  end
  local rows, waiting = study:store():cases(), 0
  for _, row in ipairs(rows) do
    if row.status ~= "done" and row.status ~= "failed" then waiting = waiting + 1 end
  end
  if waiting > 0 then
    check.fail(where, ("%d of %d cases have not run yet: call run{} first"):format(waiting, #rows))
  end
  return rows
end

-- Returns true if the case with this number is a sample of the distributions. With indices, only the first
-- two cases of each point are samples; the other cases are mixtures of these two.
function outcomes.is_sample(study, number)
  return not study.sample.indices or (number - 1) % (#study.sample.fields + 2) < 2
end

-- Returns a list that is true at each row with a usable result, and the number of failed cases. For indices of
-- sensitivity, the cases of a sample point are used only if all of them are finished.
local function counted(study, rows)
  local kept, group, left_out = {}, study.sample.indices and #study.sample.fields + 2 or 1, 0
  for first = 1, #rows, group do
    local fine = true
    for i = first, first + group - 1 do fine = fine and rows[i].status == "done" end
    for i = first, first + group - 1 do
      kept[i] = fine
      if rows[i].status == "failed" then left_out = left_out + 1 end
    end
  end
  return kept, left_out
end

-- Returns the history of a finished case. Raises an error (ARC_FORMAT) if it is missing, because the file is
-- then damaged.
local function history_of(store, where, id)
  local history = joint_file.history(store, id)
  if history then return history end
  check.fail(where, ("%s: the file is damaged: case %d is done and has no history"):format(store.path, id), "FORMAT")
end

-- Returns the first finished case of a study. Raises an error if there is none, or if its history is missing.
function outcomes.first(study, where)
  for i, row in ipairs(outcomes.rows(study, where)) do
    if row.status == "done" and history_of(study:store(), where, row.id) then return study:cases()[i] end
  end
  check.fail(where, "fewer than two cases have results")
end

-- Calls visit(number, history, index) for each used case. number: number of the case among the used cases;
-- index: its number in the study. Returns the number of failed cases and the number of used cases.
function outcomes.each(study, where, visit)
  local rows = outcomes.rows(study, where)
  local kept, failed = counted(study, rows)
  local store, number = study:store(), 0
  for i, row in ipairs(rows) do
    if kept[i] then
      number = number + 1
      visit(number, history_of(store, where, row.id), i)
    end
  end
  if number < 2 then check.fail(where, "fewer than two cases have results") end
  return failed, number
end

-- Returns the distances `at` or, without `at`, 50 evenly spaced distances [mm] up to the end of the shortest
-- case.
local function grid(at, shortest)
  if at then return at end
  local list = {}
  for i = 1, 50 do list[i] = shortest * i / 50 end
  return list
end

local function shortest_of(study, where)
  local shortest = math.huge
  outcomes.each(study, where, function(_, history)
    shortest = math.min(shortest, history.distance[#history.distance])
  end)
  return shortest
end

-- Returns { distance=, n=, failed=, index=, values= }. values[name][g][i]: value of the i-th used case at
-- distance[g]; index[i]: number of this case in the study; n, failed: numbers of used and of failed cases.
function outcomes.read(study, where, names, at)
  local shortest = shortest_of(study, where)
  local result = { distance = grid(at, shortest), values = {}, index = {} }
  for _, d in ipairs(result.distance) do
    if d > shortest * (1 + 1e-9) then
      check.fail(where, ("field 'at': expected distances up to %g mm, the end of the shortest case, "
        .. "got %g"):format(shortest, d))
    end
  end
  for _, name in ipairs(names) do
    result.values[name] = {}
    for g = 1, #result.distance do result.values[name][g] = {} end
  end
  result.failed, result.n = outcomes.each(study, where, function(i, history, index)
    result.index[i] = index
    for _, name in ipairs(names) do
      for g, d in ipairs(result.distance) do
        result.values[name][g][i] = history_at(history, name, d)
      end
    end
  end)
  return result
end

return outcomes

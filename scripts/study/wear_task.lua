-- Computes a wear run of a study, records surfaces at given distances, and saves the run to the run file at
-- intervals. If the process is killed, the next call continues the saved run.

local joint_file = require "archard.joint.file"
local term = require "archard.term"
local transaction = require "archard.study.transaction"

-- Returns a function(distance) that returns true if surfaces must be recorded at this update. There are
-- `count` records: the unworn surfaces, and the first surfaces at or after each multiple of 1/`count` of the
-- total distance. The final surfaces are stored separately.
local function recorder(count, total)
  local next_look = 0
  return function(distance)
    if total <= 0 or next_look >= count or distance < next_look / count * total then return false end
    next_look = math.floor(distance / total * count) + 1
    return true
  end
end

local function record(run, list)
  for _, surface in ipairs(run:surfaces()) do list[#list + 1] = surface end
end

-- Returns the surfaces recorded before the run was saved, which the run file stores together with the state
-- of the run.
local function recorded(run, surfaces, is_due)
  local due, list, history = {}, {}, run.history
  for i, distance in ipairs(history.distance) do
    if is_due(distance) then due[history.update[i]] = true end
  end
  for _, surface in ipairs(surfaces) do
    if due[surface.update] then list[#list + 1] = surface end
  end
  return list
end

-- Returns the saved run and its surfaces, or nil if no unfinished run was saved.
local function saved_run(store, id)
  local fine, run = pcall(joint_file.wear, store, id)
  if fine and run.update > 0 and not run.done then return run, joint_file.surfaces(store, id) end
end

-- Computes a case. given: fields of wear{}; snapshots: number of records; every: seconds between saves.
-- Returns the finished run and the recorded surfaces.
return function(store, id, given, snapshots, every, on_progress)
  local run, surfaces = saved_run(store, id)
  run = run or wear(given)
  local total, last = run.total_distance, term.clock()
  -- joints record their maps only at the end
  local is_due = recorder(joint_file.is_joint(run) and 0 or snapshots, total)
  local list = surfaces and recorded(run, surfaces, is_due) or {}
  if not surfaces and is_due(run.distance) then record(run, list) end
  run:run{ progress = function()
    if not run.done and is_due(run.distance) then record(run, list) end
    on_progress(run.distance / total)
    if term.clock() - last < every or run.done then return end
    transaction(store, joint_file.save, store, id, run, list)
    last = term.clock()
  end }
  return run, list
end

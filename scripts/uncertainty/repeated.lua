-- Repeats a run from its definition, for w:sensitivity{}. One number of the definition may be changed.

local check = require "archard.lib.check"
local known = require "archard.settings"
local merged = require "archard.lib.merged"
local settings = require "archard.definition.settings"
local joint_file = require "archard.joint.file"
local quiet = require "archard.lib.quiet"

local repeated = {}

local where = "wear:sensitivity"

local function loading_of(blocks)
  for _, block in ipairs(blocks or {}) do block.periodic = block.periodic ~= 0 end
  return blocks
end

-- Fields that may be 0 in a definition. In all other fields, 0 means that the user did not give the field.
local zeros = { alpha = true, friction = true, refresh = true }

-- Adds the flat settings of the model to the definition. Removes k and alpha from it if a body has its own
-- wear coefficient.
local function take_coefficients(definition)
  definition.flat = settings.flatten(where, { model = definition.model })
  for path, value in pairs(definition.flat) do
    if path:match("%.k$") and value > 0 then definition.k, definition.alpha = nil, nil end
  end
end

-- Returns the definition of a run of wear{}. The definition of a joint{} is returned by its own method
-- (joint/run.lua).
local function of_engine(run)
  local there = settings.nest(joint_file.definition(run))
  local definition = { model = run.model, loading = loading_of(there.loading) }
  for _, setting in ipairs(known.wear) do
    local name = setting.name
    if setting.choice then
      definition[name] = there[name]
    elseif setting.plain and (run[name] ~= 0 or zeros[name]) then
      definition[name] = run[name]
    end
  end
  local has, local_factor = pcall(function() return run.local_factor end)
  definition.local_factor = has and local_factor or nil
  return definition
end

function repeated.definition(run)
  local definition = joint_file.is_joint(run) and run:definition() or of_engine(run)
  take_coefficients(definition)
  return repeated.with_steps(run, definition)
end

-- Returns the number of cycles in the step of the history that begins at a distance [mm].
local function step_from(history, distance)
  local i = 2
  while history.distance[i + 1] and history.distance[i] <= distance * (1 + 1e-9) do i = i + 1 end
  return history.cycle[i] - history.cycle[i - 1]
end

-- Returns the definition for the repetition of a run. A run with automatic steps is repeated with the steps
-- of the original run, because new automatic steps of each repetition would change the results and hide the
-- effect of the changed number. The repetition is implicit, because the steps may be too long for the
-- explicit scheme.
function repeated.with_steps(run, definition)
  if not (definition.tolerance or definition.jump == "auto") then return definition end
  definition.tolerance, definition.steps_chosen = nil, run.history
  if not joint_file.is_joint(run) then definition.scheme = "implicit" end
  return repeated.in_parts(definition, 1)
end

-- Returns the definition with each step of the original run divided into `parts` equal steps.
function repeated.in_parts(definition, parts)
  local history = definition.steps_chosen
  return merged(definition, { jump = function(state) return step_from(history, state.distance) / parts end })
end

-- --- running -------------------------------------------------------------------------------------

-- Returns the indices of the history rows at the given distances [mm]. The history must have a row at each
-- distance.
local function rows_at(history, distances)
  local rows, at = {}, 1
  for i, d in ipairs(distances) do
    while history.distance[at + 1] and history.distance[at] < d * (1 - 1e-9) do at = at + 1 end
    rows[i] = at
  end
  return rows
end

-- Returns a copy of the definition without the fields that wear{} does not accept.
local function wear_fields(definition)
  local copy = merged(definition)
  copy.steps_chosen, copy.flat = nil, nil
  return copy
end

local function run_to(definition, distances, names)
  local run <close> = wear(wear_fields(definition))
  for _, d in ipairs(distances) do
    if d * (1 - 1e-9) > run.distance then run:run{ distance = d, progress = false } end
  end
  local history, list = run.history, {}
  local rows = rows_at(history, distances)
  for _, name in ipairs(names) do
    for _, row in ipairs(rows) do list[#list + 1] = history[name][row] end
  end
  return list
end

-- Repeats a run. Returns one flat list with the values of each column at the distances [mm]; a step of the
-- repeated run ends at each distance. Warnings are suppressed, because the original run has already
-- reported them.
function repeated.run(definition, distances, names)
  return quiet(run_to, definition, distances, names)
end

return repeated

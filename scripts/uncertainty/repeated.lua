-- A finished run once more, from its definition as it is or with a number changed: what sensitivities
-- compare. Leans on archard.store, which knows the whole definition of a run.

local check = require "archard.lib.check"
local known = require "archard.settings"
local merged = require "archard.lib.merged"
local settings = require "archard.definition.settings"
local stores = require "archard.store"
local quiet = require "archard.lib.quiet"

local repeated = {}

local where = "wear:sensitivity"

-- What a run file would keep of the run.
local function stored(run)
  local path = os.tmpname()
  os.remove(path)
  local store <close> = stores.open(path, "create")
  local fine, values = pcall(function()
    store:add(1, "run")
    store:save(1, run, {})
    return store:values(1, "definition")
  end)
  store:close()
  os.remove(path)
  if not fine then error(values, 0) end
  return settings.nest(values)
end

local function loading_of(blocks)
  for _, block in ipairs(blocks or {}) do block.periodic = block.periodic ~= 0 end
  return blocks
end

-- The definition that wear{} takes, beside it `flat`, the settings of its model: words and loading as a run file has them, all else (numbers,
-- tables, functions, the model) as the run tells. 0 stands for what was not given, where it is not a
-- choice of its own.
local zeros = { alpha = true, friction = true, refresh = true }

-- Bodies with coefficients of their own make those of the couple: that has none in its definition.
local function take_coefficients(definition)
  definition.flat = settings.flatten(where, { model = definition.model })
  for path, value in pairs(definition.flat) do
    if path:match("%.k$") and value > 0 then definition.k, definition.alpha = nil, nil end
  end
end

function repeated.definition(run)
  local there = stored(run)
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
  take_coefficients(definition)
  return repeated.with_steps(run, definition)
end

-- The cycles of the step of a history that leads on from a distance [mm].
local function step_from(history, distance)
  local i = 2
  while history.distance[i + 1] and history.distance[i] <= distance * (1 + 1e-9) do i = i + 1 end
  return history.cycle[i] - history.cycle[i - 1]
end

-- Steps that chose themselves are taken again as they were, and implicitly, for they may be long:
-- chosen anew for every changed number, they would cover small changes with noise.
function repeated.with_steps(run, definition)
  if not (definition.tolerance or definition.jump == "auto") then return definition end
  definition.tolerance, definition.scheme, definition.steps_chosen = nil, "implicit", run.history
  return repeated.in_parts(definition, 1)
end

-- The same with each of these steps in so many parts.
function repeated.in_parts(definition, parts)
  local history = definition.steps_chosen
  return merged(definition, { jump = function(state) return step_from(history, state.distance) / parts end })
end

-- --- running -------------------------------------------------------------------------------------

-- The rows of a history at the distances, all of which it has.
local function rows_at(history, distances)
  local rows, at = {}, 1
  for i, d in ipairs(distances) do
    while history.distance[at + 1] and history.distance[at] < d * (1 - 1e-9) do at = at + 1 end
    rows[i] = at
  end
  return rows
end

-- What wear{} knows of it.
local function taken(definition)
  local copy = merged(definition)
  copy.steps_chosen, copy.flat = nil, nil
  return copy
end

local function run_to(definition, distances, names)
  local run <close> = wear(taken(definition))
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

-- run(definition, distances, names) -> a list: of each column in turn its values at the distances,
-- where the changed run ends a step too. What the engine warns of, the run itself has told.
function repeated.run(definition, distances, names)
  return quiet(run_to, definition, distances, names)
end

return repeated

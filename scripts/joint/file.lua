-- Converts runs of joints to flat tables of named values, for run files and sessions, and back.

local check = require "archard.lib.check"
local made = require "archard.joint.made"
local runs = require "archard.joint.run"
local sphere = require "archard.sphere"
local store = require "archard.store"

local file = {}

-- --- definitions --------------------------------------------------------------------------------

local plain = { "radius", "clearance", "inclination", "cover", "size", "foundation" }
local callable = { "k", "alpha", "creep" } -- settings that may be functions

local function flat_layers(layers)
  local list = {}
  for _, layer in ipairs(layers) do
    list[#list + 1], list[#list + 2], list[#list + 3] = layer.thickness, layer.E, layer.nu
  end
  return #list > 0 and list or nil
end

local function layers_from(list)
  local layers = {}
  for i = 1, #(list or {}), 3 do layers[#layers + 1] = { thickness = list[i], E = list[i + 1], nu = list[i + 2] } end
  return layers
end

-- A definition as flat fields "joint.NAME".
function file.flat_joint(def)
  local flat = { ["joint.core"] = { def.core.E, def.core.nu }, ["joint.head_layers"] = flat_layers(def.head_layers),
    ["joint.cup_layers"] = flat_layers(def.cup_layers) }
  for _, name in ipairs(plain) do flat["joint." .. name] = def[name] end
  flat["joint.order"] = def.second_order and 2 or 1
  return flat
end

function file.joint_from(flat)
  local core = flat["joint.core"]
  local def = { core = { E = core[1], nu = core[2] }, head_layers = layers_from(flat["joint.head_layers"]),
    cup_layers = layers_from(flat["joint.cup_layers"]), second_order = flat["joint.order"] == 2 }
  for _, name in ipairs(plain) do def[name] = flat["joint." .. name] end
  return def
end

function file.flat_gait(g, prefix)
  return { [prefix .. "name"] = g.name, [prefix .. "instants"] = g.instants }
end

function file.gait_from(flat, prefix)
  local instants = flat[prefix .. "instants"] or {}
  return made(flat[prefix .. "name"], table.move(instants, 1, #instants, 1, {}))
end

-- --- runs ---------------------------------------------------------------------------------------

local settings = { "k", "alpha", "goal", "updates", "scheme", "tolerance", "step" }
local counted = { "updates", "solutions" }

local function add(to, from)
  for name, value in pairs(from) do to[name] = value end
end

-- The definition and all results of a run as two flat tables.
function file.flat_run(run)
  local definition, results = file.flat_joint(run.def), { state = sphere.state(run.engine) }
  for _, name in ipairs(settings) do definition[name] = run[name] end
  for _, name in ipairs(callable) do
    if type(run[name]) == "function" then definition[name] = "function" end
  end
  for i, block in ipairs(run.blocks) do
    add(definition, file.flat_gait(block.gait, ("loading.%d."):format(i)))
    if block.cycles < math.huge then definition[("loading.%d.cycles"):format(i)] = block.cycles end
  end
  for name, column in pairs(run.history) do results["history." .. name] = column end
  for name, value in pairs(run.record) do results["record." .. name] = value end
  return definition, results
end

local function blocks_from(flat)
  local blocks = {}
  while flat[("loading.%d.name"):format(#blocks + 1)] do
    local prefix = ("loading.%d."):format(#blocks + 1)
    blocks[#blocks + 1] = { gait = file.gait_from(flat, prefix), cycles = flat[prefix .. "cycles"] }
  end
  return blocks
end

local function take(results, prefix)
  local part = {}
  for name, value in pairs(results) do
    local rest = name:match("^" .. prefix .. "%.(.+)$")
    if rest then part[rest] = type(value) == "table" and table.move(value, 1, #value, 1, {}) or value end
  end
  return part
end

-- The value of a setting, or the given function if the setting was one.
local function function_or_value(definition, name, functions)
  if definition[name] ~= "function" then return definition[name] end
  local f = type(functions) == "table" and functions[name]
  if type(f) ~= "function" then
    check.fail("joint.open", ("field '%s': the run has a function here: give it again, as { %s = f }"):format(name, name))
  end
  return f
end

function file.run_from(definition, results, functions)
  local blocks = blocks_from(definition)
  local run = runs.new(file.joint_from(definition), { loading = blocks,
    k = function_or_value(definition, "k", functions), alpha = function_or_value(definition, "alpha", functions),
    creep = function_or_value(definition, "creep", functions), cycles = definition.goal, scheme = definition.scheme,
    updates = definition.updates and math.tointeger(definition.updates) })
  run.tolerance, run.step = definition.tolerance, definition.step
  sphere.set_state(run.engine, results.state)
  local record = take(results, "record")
  for _, name in ipairs(counted) do record[name] = math.tointeger(record[name]) end
  runs.restore(run, record, take(results, "history"))
  return run
end

-- --- run files ----------------------------------------------------------------------------------

local function check_path(where, path)
  if not check.file.test(path) then check.refuse(where, "path", "a file name", path) end
end

-- Writes the file completely or not at all; replaces a file of a joint, refuses any other file.
function file.save(run, path)
  check_path("joint_wear:save", path)
  local definition, results = file.flat_run(run)
  check.as("joint_wear:save", function()
    local to <close> = store.replace(path, "joint")
    to:begin()
    to:set_info("program", "archard " .. require "archard".version)
    to:add(1, "wear of a joint")
    to:set_values(1, "definition", definition)
    to:set_values(1, "results", results)
    to:mark(1, "done")
    to:commit()
    to:publish()
  end)
  return run
end

function file.open(path, functions)
  check_path("joint.open", path)
  local definition, results
  check.as("joint.open", function()
    local from <close> = store.open(path, "read")
    from:check()
    local kind = from:info "kind"
    if kind ~= "joint" then
      check.fail("joint.open", ("%s: expected a file of w:save of a joint, got a run file of kind %s"):format(path, tostring(kind)),
        "FORMAT")
    end
    definition, results = from:values(1, "definition"), from:values(1, "results")
  end)
  local fine, run = pcall(file.run_from, definition, results, functions)
  if fine then return run end
  if type(run) == "table" and run.message then error(run, 0) end
  check.fail("joint.open", path .. ": the file is damaged: " .. tostring(run), "FORMAT")
end

return file

-- Lua function export.json: writes the definition, progress and results of a run as JSON. The engine's lists
-- of settings and history columns (archard.settings) determine which fields are written.

local check = require "archard.lib.check"
local files = require "archard.files"
local json = require "archard.export.json"
local known = require "archard.settings"
local role_of = require "archard.definition.number".role_of
local joint_file = require "archard.joint.file"
local joint_history = require "archard.joint.history"
local nest = require "archard.definition.settings".nest
local value_at = require "archard.definition.settings".value_at
local written = require "archard.lib.written"

local where = "export.json"

-- Settings that a wear object stores under another name, because the field of the same name contains the
-- current value. Example: w.distance is the distance slid so far, w.total_distance is the setting.
local held_as = { distance = "total_distance", update = "update_at" }

-- Copies a value for JSON. A function becomes the string "function", a material object becomes a table.
local function plain(value)
  if type(value) == "function" then return "function" end
  local copy = {}
  for _, setting in ipairs(type(value) == "userdata" and known.material or {}) do -- a material object
    copy[setting.path] = value[setting.path]
  end
  if next(copy) then return copy end
  if type(value) ~= "table" or value == json.null then return value end
  for name, inner in pairs(value) do copy[name] = plain(inner) end
  return copy
end

local function put(into, units, prefix, path, value, unit)
  local inner = into
  for group in path:gmatch("([^.]+)%.") do
    inner[group] = inner[group] or {}
    inner = inner[group]
  end
  inner[path:match("[^.]+$")] = plain(value)
  if unit and unit ~= "" then units[prefix .. path] = unit end
end

-- Adds the units of the fields of a body or layer to `units`. A wear coefficient k = 0 means that none was
-- given; it is replaced by null.
local function complete(part, units, prefix)
  for _, class in ipairs{ "body", "material" } do
    for _, setting in ipairs(known[class]) do
      local name = setting.path:gsub("^layer1%.", "")
      if part[name] then units[prefix .. name] = setting.unit end
    end
  end
  if part.k == 0 then part.k = json.null end
  if part.material then complete(part.material, units, prefix .. "material.") end
end

-- Returns the fields of a body that the user gave and adds their units to `units`. Returns null for the
-- default body.
local function body_of(given, units, prefix)
  if rawequal(given, nil) then return json.null end
  local body = plain(given)
  complete(body, units, prefix)
  for _, layer in ipairs(body.layers or {}) do complete(layer, units, prefix .. "layers.") end
  if body.x then units[prefix .. "x"] = "mm" end
  return body
end

-- Returns the settings of a class ("wear", "model" or "material") with their values in `object`. Adds their
-- units to `units`.
local function definition(class, object, units, prefix)
  local into = {}
  for _, setting in ipairs(known[class]) do
    local path = setting.path
    if setting.class == "body" then
      into[path] = body_of(object[path], units, prefix .. path .. ".")
    elseif class == "model" and role_of[path] and object[role_of[path]] then -- the body's fields contain the material
      into[path] = json.null
    elseif setting.class == "material" then
      into[path] = definition("material", object[path], units, prefix .. path .. ".")
    elseif setting.plain and not setting.group then
      local value = value_at(object, class == "wear" and held_as[path] or path)
      if setting.optional and value == 0 then value = json.null end -- 0: not given
      put(into, units, prefix, path, value, setting.unit)
    end
  end
  return into
end

local function results(run, units)
  local into = {}
  for _, column in ipairs(known.columns) do
    local values = run.history[column.name]
    put(into, units, "results.", column.name, values[#values], column.unit)
  end
  put(into, units, "results.", "volume_total", run.volume.total, "mm3")
  into.done = run.done
  return into
end

local function summary_of(run)
  local units = {}
  local asked = definition("wear", run, units, "definition.")
  asked.model = definition("model", run.model, units, "definition.model.")
  local called = run.model.bodies
  asked.model.bodies = { upper = called.upper, lower = called.lower }
  asked.loading = run.loading and plain(run.loading) or json.null
  units["definition.loading.x"], units["definition.loading.load"] = "mm", "N"
  asked.local_factor = run.local_factor and "function" or json.null
  return { definition = asked, results = results(run, units), units = units }
end

-- Returns the summary of a joint's run: the fields of wear{}, the last row of the history, and the units.
local function joint_summary(run)
  local into, units = { done = run.done }, {}
  local columns, units_of, names = joint_history(run)
  for _, name in ipairs(names) do
    put(into, units, "results.", name, columns[name][#columns[name]], units_of[name])
  end
  put(into, units, "results.", "volume_total", run.volume.total, "mm3")
  return { definition = nest(joint_file.definition(run)), results = into, units = units }
end

-- export.json(run, path): writes the summary of a run and returns the path of the file.
return function(run, path)
  local is_joint = joint_file.is_joint(run)
  if not is_joint and check.shown(run) ~= "a wear object" then
    check.fail(where, "expected a wear object, got " .. check.shown(run))
  end
  if not check.file.test(path) then check.refuse(where, "path", "a file name", path) end
  local ending = path:match("%.[^./]*$")
  if not ending then path = path .. ".json" end
  if ending and ending ~= ".json" then
    check.refuse(where, "path", "a file name that ends in .json", path)
  end
  local summary = (is_joint and joint_summary or summary_of)(run)
  summary.versions = { archard = require "archard".version, lua = _VERSION:match("[%d.]+") }
  files.write(where, path, json.encode(summary))
  return written.returned(where, path)
end

-- Resolves the names of numeric fields of wear{}, model{} and bodies. Studies, samples, fits and sensitivities use
-- these names. A name is a path in wear{}, such as "load", "model.radius" or "model.lower.layers.1.thickness".
-- "model." may be omitted, and layer1 means layers.1. E or nu without a body means the value of both bodies.

local check = require "archard.lib.check"
local known = require "archard.settings"

local number = {}

local function named(list, path)
  for _, setting in ipairs(list) do
    if setting.path == path then return setting end
  end
end

-- --- settings --------------------------------------------------------------------------------------

local field_of = { upper = "cylinder", lower = "plate" } -- model{} fields of the default pair, a cylinder on a plate
local role_of = { cylinder = "upper", plate = "lower" }
number.role_of = role_of

-- Returns the setting (type, unit and range) of a field, given by its path inside a body or material.
-- Returns nil for an unknown field, and for a field that is a table over positions, such as the heights of
-- a profile.
local function in_body(rest)
  local layer = rest:gsub("^layers%.(%d+)%.", "layer%1.")
  local material = rest:gsub("^layers%.%d+%.", ""):gsub("^materials%.[^.]+%.", ""):gsub("^material%.", "")
  local own = named(known.body, layer)
  return own and not own.series and own or named(known.material, material)
end

-- Numeric settings that only joints have. owners: the body of a joint to which a setting belongs.
local angle = { type = "a number in [0, 180]", unit = "degree", low = 0, high = 180 }
local of_joints = { clearance = { type = "a number > 0", unit = "mm", low = 0 }, inclination = angle, cover = angle }
local owners = { clearance = "cup", inclination = "cup", cover = "cup", radius = "head" }

-- Returns the setting at a path such as "model.radius", or nil if there is none.
function number.setting(path)
  local inside = path:match("^model%.(.+)$")
  if not inside then return named(known.wear, path) end
  local body, rest = inside:match("^(%l+)%.(.+)$")
  if body == "head" or body == "cup" then return of_joints[rest] or in_body(rest) end
  if field_of[body] then return in_body(rest) end
  if role_of[body] then return named(known.material, rest) end
  return named(known.model, inside)
end

-- Raises an error for the user's field `field` if its setting is nil or not of a numeric type.
function number.check(where, field, setting)
  if not setting or not setting.type:match("^a number") then
    check.fail(where, ("field '%s': expected the name of a field of wear{} or model{} that is a number, "
      .. "got %s"):format(field, setting and "a field of type " .. setting.type or "an unknown name"))
  end
end

-- --- bodies ----------------------------------------------------------------------------------------

local function kind_of(flat, role) return flat["model." .. role .. ".kind"] end

-- Returns the role ("upper" or "lower") of the body whose kind is `word`; nil if both bodies have this
-- kind. If no body has it, "cylinder" and "plate" are read as older names of the upper and the lower body.
-- "cylinder" never means the lower body: the result is nil even if only the lower body is a cylinder.
local function role_by_kind(flat, word)
  local upper, lower = kind_of(flat, "upper") == word, kind_of(flat, "lower") == word
  if upper ~= lower then return upper and "upper" or word ~= "cylinder" and "lower" or nil end
  return not upper and role_of[word] or nil
end

-- Returns the role of a body, given by its role, name, kind or older name; nil if there is no such body.
local function role(flat, word)
  if field_of[word] then return word end
  for each in pairs(field_of) do
    if flat["model." .. each .. ".name"] == word then return each end
  end
  return role_by_kind(flat, word)
end

-- Returns the path of a material property (such as E) inside a body. The property can be a field of the
-- body itself or of the body's material.
local function in_material(flat, prefix, rest)
  local before, name = rest:gsub("^material%.", ""):gsub("^(layers%.%d+%.)material%.", "%1"):match("^(.-)([^.]+)$")
  for _, setting in ipairs(named(known.material, name) and known.material or {}) do
    if flat[prefix .. before .. "material." .. setting.path] then return before .. "material." .. name end
  end
  return before .. name
end

local function is_joint(flat)
  for path in pairs(flat) do
    if path:match "^model%.cup%." or path:match "^model%.head%." then return true end
  end
  return false
end

-- Returns the path of a numeric field of a joint, given by a name such as "clearance" or "cup.layer1.E".
local function joint_path(flat, inside)
  local body, rest = inside:match("^(%l+)%.(.+)$")
  if not rest then return owners[inside] and ("model.%s.%s"):format(owners[inside], inside) or "model." .. inside end
  local prefix = "model." .. body .. "."
  return prefix .. in_material(flat, prefix, (rest:gsub("^layer(%d+)%.", "layers.%1.")))
end

-- Returns the path of a numeric field of a body, given by a name such as "cylinder.E", or nil if the first word is
-- not a body.
local function body_path(flat, word, rest)
  local which = role(flat, word)
  if not which then return nil end
  if not kind_of(flat, which) then return "model." .. field_of[which] .. "." .. rest end
  local prefix, inside = "model." .. which .. ".", rest:gsub("^layer(%d+)%.", "layers.%1.")
  return prefix .. in_material(flat, prefix, inside)
end

-- --- paths -----------------------------------------------------------------------------------------

local both = { E = true, nu = true }

-- Returns true if a name is a field of wear{} itself and not of the model.
function number.of_run(name)
  local first = name:match("^[^.]*")
  return first ~= "model" and named(known.wear, first) ~= nil
end

-- Returns a list of the paths of a numeric field: one path, or two if the name means both bodies. flat:
-- all settings of the run and its model, by path. An unknown name is returned unchanged.
function number.paths(name, flat)
  if both[name] and not is_joint(flat) then return { body_path(flat, "upper", name), body_path(flat, "lower", name) } end
  if number.of_run(name) then return { name } end
  local inside = name:gsub("^model%.", "")
  if is_joint(flat) then return { joint_path(flat, inside) } end
  local word, rest = inside:match("^([^.]+)%.(.+)$")
  local path = word and body_path(flat, word, rest)
  if path then return { path } end
  return { named(known.model, inside) and "model." .. inside or name }
end

-- Returns the path that the name of a numeric field means. field: the user's field, for error messages.
-- Raises ARGUMENT if the name means both bodies.
function number.path(where, field, name, flat)
  local paths = number.paths(name, flat)
  if #paths > 1 then
    check.fail(where, ("field '%s': %s is ambiguous, %s or %s; expected the name of one of them")
      :format(field, name, paths[1], paths[2]))
  end
  return paths[1]
end

-- Replaces the given names of numeric fields in flat settings by their paths. Returns the settings.
function number.rename(flat, names)
  for name in pairs(names) do
    local paths, value = number.paths(name, flat), flat[name]
    if paths[1] ~= name then flat[name] = nil end
    for _, path in ipairs(paths) do flat[path] = value end
  end
  return flat
end

return number

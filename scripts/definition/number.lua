-- Names of the numbers of wear{}, model{} and their bodies: what studies vary and sample, fits look for and
-- sensitivities change. A number is called as it stands in wear{}, "load", "model.radius",
-- "model.lower.layers.1.thickness"; "model." may be left out, layer1 stands for layers.1, and E and nu alone
-- for those of both bodies. Leans on the lists of settings.

local check = require "archard.lib.check"
local known = require "archard.settings"

local number = {}

local function named(list, path)
  for _, setting in ipairs(list) do
    if setting.path == path then return setting end
  end
end

-- --- settings --------------------------------------------------------------------------------------

local field_of = { upper = "cylinder", lower = "plate" } -- what the usual pair has in their place
local role_of = { cylinder = "upper", plate = "lower" }
number.role_of = role_of

-- Of a body: its own, or those of one of its materials. Heights of a profile are a list.
local function in_body(rest)
  local layer = rest:gsub("^layers%.(%d+)%.", "layer%1.")
  local material = rest:gsub("^layers%.%d+%.", ""):gsub("^materials%.[^.]+%.", ""):gsub("^material%.", "")
  local own = named(known.body, layer)
  return own and not own.series and own or named(known.material, material)
end

-- The setting that a path stands for, or nil.
function number.setting(path)
  local inside = path:match("^model%.(.+)$")
  if not inside then return named(known.wear, path) end
  local body, rest = inside:match("^(%l+)%.(.+)$")
  if field_of[body] then return in_body(rest) end
  if role_of[body] then return named(known.material, rest) end
  return named(known.model, inside)
end

-- Raises the error for a setting that is something else.
function number.check(where, field, setting)
  if not setting or not setting.type:match("^a number") then
    check.fail(where, ("field '%s': expected the name of a number of wear{} or model{}, "
      .. "got one that is %s"):format(field, setting and setting.type or "no number"))
  end
end

-- --- bodies ----------------------------------------------------------------------------------------

local function kind_of(flat, role) return flat["model." .. role .. ".kind"] end

-- The one body that is of the kind; a cylinder below is none of the upper body, which that word stood for.
local function role_by_kind(flat, word)
  local upper, lower = kind_of(flat, "upper") == word, kind_of(flat, "lower") == word
  if upper ~= lower then return upper and "upper" or word ~= "cylinder" and "lower" or nil end
  return not upper and role_of[word] or nil
end

-- The body that a word means: its role, its name, its kind or its older name.
local function role(flat, word)
  if field_of[word] then return word end
  for each in pairs(field_of) do
    if flat["model." .. each .. ".name"] == word then return each end
  end
  return role_by_kind(flat, word)
end

-- Where the definition has a number of a material: in E=, or within a material given as a whole.
local function in_material(flat, prefix, rest)
  local before, name = rest:gsub("^material%.", ""):gsub("^(layers%.%d+%.)material%.", "%1"):match("^(.-)([^.]+)$")
  for _, setting in ipairs(named(known.material, name) and known.material or {}) do
    if flat[prefix .. before .. "material." .. setting.path] then return before .. "material." .. name end
  end
  return before .. name
end

-- The path of a number of a body, "cylinder.E" and the like, or nil where the word means none.
local function body_path(flat, word, rest)
  local which = role(flat, word)
  if not which then return nil end
  if not kind_of(flat, which) then return "model." .. field_of[which] .. "." .. rest end
  local prefix, inside = "model." .. which .. ".", rest:gsub("^layer(%d+)%.", "layers.%1.")
  return prefix .. in_material(flat, prefix, inside)
end

-- --- paths -----------------------------------------------------------------------------------------

local both = { E = true, nu = true }

-- Whether a name is of wear{} and of no model.
function number.of_run(name)
  local first = name:match("^[^.]*")
  return first ~= "model" and named(known.wear, first) ~= nil
end

-- paths(name, flat) -> the paths of the number of that name, one or, of both bodies, two. flat: the settings
-- of its model by flat name, as far as there are any. A name that means nothing is its own path.
function number.paths(name, flat)
  if both[name] then return { body_path(flat, "upper", name), body_path(flat, "lower", name) } end
  if number.of_run(name) then return { name } end
  local inside = name:gsub("^model%.", "")
  local word, rest = inside:match("^([^.]+)%.(.+)$")
  local path = word and body_path(flat, word, rest)
  if path then return { path } end
  return { named(known.model, inside) and "model." .. inside or name }
end

-- The same of one number; `field` is its place in messages.
function number.path(where, field, name, flat)
  local paths = number.paths(name, flat)
  if #paths > 1 then
    check.fail(where, ("field '%s': %s stands for those of both bodies here, %s and %s; expected the name of one")
      :format(field, name, paths[1], paths[2]))
  end
  return paths[1]
end

-- Puts the paths in place of the names in flat settings.
function number.rename(flat, names)
  for name in pairs(names) do
    local paths, value = number.paths(name, flat), flat[name]
    if paths[1] ~= name then flat[name] = nil end
    for _, path in ipairs(paths) do flat[path] = value end
  end
  return flat
end

return number

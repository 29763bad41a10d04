-- Checks the names of a case's settings against the help entries of wear{}, model{}, the bodies and
-- material{}, so that a misspelt name is reported before any run.

local check = require "archard.lib.check"
local keys = require "archard.lib.keys"
local merged = require "archard.lib.merged"

local tree -- tree of the known names; names below an empty table are not checked

-- Adds the parts of a path, such as "mesh.size", to the tree `at`.
local function plant(at, path)
  for part in path:gmatch("[^.]+") do
    at[part] = at[part] or {}
    at = at[part]
  end
end

-- Returns the names of the fields of a body and its material. This function adds the fields layers and
-- materials, which have no help entries.
local function grow_body(body, material)
  for name in pairs(body) do
    if name:match "^layer%d" then body[name] = nil end
  end
  body.layers = merged({ thickness = {}, material = material }, material)
  body.x, body.material, body.materials = {}, material, {}
  return merged(body, material)
end

local function grow()
  local grown = { wear = {}, model = {}, material = {}, body = {} }
  for _, entry in ipairs(require "archard.help".all()) do
    local class, path = entry.address:match("^(%a+){([%w_.]+)}$")
    if grown[class] then plant(grown[class], path) end
  end
  grown.model.cylinder, grown.model.plate = grown.material, grown.material
  local body = grow_body(grown.body, grown.material)
  grown.model.upper, grown.model.lower = body, body
  -- joint{} checks the names below these fields
  grown.model.head, grown.model.cup, grown.model.foundation, grown.model.order = {}, {}, {}, {}
  for name in pairs(require "archard.joint.run".fields) do grown.wear[name] = grown.wear[name] or {} end
  for name in pairs(require "archard.joint.given_gait".fields) do grown.wear.loading[name] = {} end
  grown.wear.model = grown.model
  return grown.wear
end

local function refuse(where, at, prefix, name)
  if at == tree and tree.model[name] then
    check.fail(where, ("unknown field '%s': it is a field of model{}: write model = { %s = ... }")
      :format(name, name))
  end
  check.fail(where, ("unknown field '%s%s'%s"):format(prefix, name, check.hint(name, keys(at))))
end

-- Raises an error if a setting has an unknown name, such as "model.mesh.sise".
local function refuse_unknown(where, name)
  local at, prefix = tree, ""
  for part in name:gmatch("[^.]+") do
    if next(at) == nil then return end
    if not math.tointeger(tonumber(part)) then -- an integer is the index of a list element
      if not at[part] then refuse(where, at, prefix, part) end
      at, prefix = at[part], prefix .. part .. "."
    end
  end
end

-- Checks all names in the flat settings of all cases.
return function(where, cases)
  tree = tree or grow()
  local seen = {}
  for _, case in ipairs(cases) do
    for name in pairs(case) do
      if not seen[name] then refuse_unknown(where, name) end
      seen[name] = true
    end
  end
end

-- Refines a run, to estimate the error of fitted values that is due to its mesh.

local merged = require "archard.lib.merged"
local number = require "archard.definition.number"
local settings = require "archard.definition.settings"

local meshed = { ["plane strain"] = true, ["plane stress"] = true, axisymmetric = true }
local most_rows = 100

-- Returns the fields of wear{} in `given` with elements half as large and a given number of cycles per update
-- (jump) half as large, which explicit steps on smaller elements need; nil for models without element sizes
-- (3-D, springs, imported meshes).
return function(where, given)
  local fine, flat = pcall(settings.flatten, where, { model = given.model })
  if not fine or flat["model.mesh"] or not meshed[flat["model.geometry"] or "plane strain"] then return nil end
  local function given_number(name) return tonumber(flat["model.mesh." .. name]) end
  if given_number "size" or given_number "height" then
    local rows = given_number "rows" or number.setting "model.mesh.rows".default
    flat["model.mesh.rows"] = math.min(most_rows, 2 * rows)
  end
  if not given_number "size" then flat["model.mesh.fineness"] = 2 * (given_number "fineness" or 1) end
  for _, name in ipairs{ "size", "height", "far" } do
    local value = given_number(name)
    if value then flat["model.mesh." .. name] = value / 2 end
  end
  local jump = math.type(given.jump) and given.jump >= 2 and given.jump / 2 or given.jump
  return merged(given, { model = settings.nest(flat).model, jump = jump })
end

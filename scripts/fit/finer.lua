-- Refines the mesh of a run, to estimate the error of fitted values that is due to the mesh.

local merged = require "archard.lib.merged"
local settings = require "archard.definition.settings"

local meshed = { ["plane strain"] = true, ["plane stress"] = true, axisymmetric = true }
local usual_rows = 3

-- Returns the fields of wear{} in `given` with elements half as large; nil for models without element sizes
-- (3-D, springs, imported meshes).
return function(where, given)
  local fine, flat = pcall(settings.flatten, where, { model = given.model })
  if not fine or not meshed[flat["model.geometry"] or "plane strain"] then return nil end
  local sized = false
  for _, name in ipairs{ "size", "height", "far" } do
    local value = tonumber(flat["model.mesh." .. name])
    if value then flat["model.mesh." .. name], sized = value / 2, sized or name ~= "far" end
  end
  if sized then
    flat["model.mesh.rows"] = 2 * (flat["model.mesh.rows"] or usual_rows)
  else
    flat["model.mesh.fineness"] = 2 * (flat["model.mesh.fineness"] or 1)
  end
  return merged(given, { model = settings.nest(flat).model })
end

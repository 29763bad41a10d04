-- Returns the history of a joint's run for files. The names of the columns contain head and cup instead of
-- cylinder and plate.

local known = require "archard.settings".columns
local body_names = { cylinder = "head", plate = "cup" }

-- Returns the columns of the history by name, their units, and the names in the order of the history.
return function(run)
  local columns, units, names = {}, {}, {}
  for _, column in ipairs(known) do
    local name = column.name:gsub("_(%l+)$", function(body) return "_" .. (body_names[body] or body) end)
    columns[name] = run.history[column.name]
    if columns[name] then
      names[#names + 1] = name
      units[name] = column.unit
    end
  end
  return columns, units, names
end

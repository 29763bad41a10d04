-- Which fields of wear{}, model{} and material{} are numbers that may take any value of a range: what fits
-- look for and samples are drawn of. Leans on the lists of settings.

local check = require "archard.lib.check"
local settings = require "archard.settings"

local number = {}

-- The setting that a name stands for, "model.plate.E" among them, or nil.
function number.setting(name)
  local list, path = settings.wear, name
  local body, rest = name:match("^model%.(%a+)%.([%a_]+)$")
  if body == "cylinder" or body == "plate" then
    list, path = settings.material, rest
  elseif name:match("^model%.") then
    list, path = settings.model, name:match("^model%.(.*)$")
  end
  for _, setting in ipairs(list) do
    if setting.path == path then return setting end
  end
end

-- Raises the error for a setting that is something else.
function number.check(where, field, setting)
  if not setting or not setting.type:match("^a number") then
    check.fail(where, ("field '%s': expected the name of a number of wear{} or model{}, "
      .. "got one that is %s"):format(field, setting and setting.type or "no number"))
  end
end

return number

-- For tests of rows of settings: tables with further fields, and values other than the default.
local lib = {}

function lib.merged(...)
  local all = {}
  for _, part in ipairs{ ... } do for name, value in pairs(part) do all[name] = value end end
  return all
end

-- Returns values to try for the setting of a table row, other than its default. The first values are
-- most likely valid.
function lib.others(row)
  local list, usual = {}, tonumber(row.default)
  for _, value in ipairs(row.choice and row.values or {}) do
    if value ~= row.default then list[#list + 1] = value end
  end
  if row.choice then return list end
  if row.type == "false or true" then return { true } end
  if row.type:find "^a word" or row.type:find "^a name" or row.type:find "^a text" then return { "another" } end
  for _, value in ipairs{ usual and usual * 0.9 or false, usual and usual // 1 - 1 or false, 0.4, 2, 7 } do
    if value and value ~= usual then list[#list + 1] = value end
  end
  return list
end

return lib

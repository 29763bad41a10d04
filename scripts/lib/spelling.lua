-- Spelling of table keys in Lua, such as stroke or ["model.radius"].

local find, format, tostring, type = string.find, string.format, tostring, type

local spelling = { keywords = {} } -- list of Lua's reserved words

local is_keyword = {}
for word in ("and break do else elseif end false for function goto if in local nil not or repeat "
  .. "return then true until while"):gmatch("%a+") do
  spelling.keywords[#spelling.keywords + 1], is_keyword[word] = word, true
end

function spelling.is_name(key)
  return type(key) == "string" and find(key, "^[%a_][%w_]*$") ~= nil and not is_keyword[key]
end

-- Returns a key as it is written between braces: stroke or ["model.radius"].
function spelling.field(key)
  if spelling.is_name(key) then return key end
  return format(type(key) == "string" and "[%q]" or "[%s]", type(key) == "string" and key or tostring(key))
end

-- Returns a key as it is written after the name of a table: .stroke or ["model.radius"].
function spelling.index(key)
  return spelling.is_name(key) and "." .. key or spelling.field(key)
end

return spelling

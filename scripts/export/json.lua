-- Formats Lua values as JSON. Tables with an element [1] become arrays, other tables become objects with
-- sorted keys, and NaN and infinity become null.

local as_utf8 = require "archard.lib.as_utf8"
local files = require "archard.files"
local keys = require "archard.lib.keys"

local json = { null = setmetatable({}, { __name = "null" }) }

local escapes = { ['"'] = '\\"', ["\\"] = "\\\\", ["\b"] = "\\b", ["\f"] = "\\f", ["\n"] = "\\n", ["\r"] = "\\r",
  ["\t"] = "\\t" }

-- Returns the string `text` with quotes and escapes as required by JSON.
local function quoted(text)
  return '"' .. as_utf8(text):gsub('[%c"\\\x7F]', function(c)
    return escapes[c] or ("\\u%04x"):format(c:byte())
  end) .. '"'
end

local encode

local function array(values, indent)
  local parts = {}
  for i, value in ipairs(values) do parts[i] = encode(value, indent) end
  return "[" .. table.concat(parts, ", ") .. "]"
end

local function object(values, indent)
  local parts, deeper = {}, indent .. "  "
  for i, name in ipairs(keys(values)) do parts[i] = deeper .. quoted(name) .. ": " .. encode(values[name], deeper) end
  if #parts == 0 then return "{}" end
  return "{\n" .. table.concat(parts, ",\n") .. "\n" .. indent .. "}"
end

function encode(value, indent)
  local kind = type(value)
  if kind == "number" then
    return value == value and math.abs(value) < math.huge and files.number(value) or "null"
  end
  if kind == "string" then return quoted(value) end
  if kind == "boolean" then return tostring(value) end
  if value == nil or value == json.null then return "null" end
  if value[1] ~= nil then return array(value, indent) end
  return object(value, indent)
end

function json.encode(value) return encode(value, "") .. "\n" end

return json

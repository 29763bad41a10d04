-- Returns completions of the text before the cursor: globals, fields, methods, the named fields in a
-- constructor call, the values of such a field, or file names. The module only reads raw tables and
-- metatables, and runs no code of the user. archard.help supplies the names that are in no table.

local debug, next, pcall, rawget, type = debug, next, pcall, rawget, type
local table = table
local find, sub, match = string.find, string.sub, string.match
local globals = _G

local help = require "archard.help"
local spelling = require "archard.lib.spelling"

local complete = {}

-- --- tokens ------------------------------------------------------------------------------------

local function close_of_string(text, at, quote)
  local i = at + 1
  while i <= #text do
    local c = sub(text, i, i)
    if c == "\\" then
      i = i + 1
    elseif c == quote then
      return i
    elseif c == "\n" then
      return nil
    end
    i = i + 1
  end
end

-- Returns the kind and the last position of the token at position `at`. The last position is nil if the text
-- ends within the token.
local function token_at(text, at)
  local equals = match(text, "^%-%-%[(=*)%[", at)
  if equals then return "comment", select(2, find(text, "]" .. equals .. "]", at, true)) end
  if find(text, "^%-%-", at) then return "comment", find(text, "\n", at, true) end
  equals = match(text, "^%[(=*)%[", at)
  if equals then return "string", select(2, find(text, "]" .. equals .. "]", at, true)) end
  local quote = match(text, "^[\"']", at)
  if quote then return "string", close_of_string(text, at, quote) end
  for _, pattern in next, { "^[%a_][%w_]*", "^%.?%d[%w.]*", "^[=~<>]=", "^::", "^%.%.%.?", "^." } do
    local _, last = find(text, pattern, at)
    if last then return pattern == "^[%a_][%w_]*" and "name" or "other", last end
  end
  return "other", at
end

-- Returns all complete tokens of the text, each { kind=, text=, last= }, and the unfinished token at the end
-- of the text, { kind=, text=, at= }, or nil.
local function tokenise(text)
  local tokens, at = {}, 1
  while true do
    at = find(text, "%S", at)
    if not at then return tokens end
    local kind, last = token_at(text, at)
    if not last then return tokens, { kind = kind, text = sub(text, at), at = at } end
    if kind ~= "comment" then
      tokens[#tokens + 1] = { kind = kind, text = sub(text, at, last), last = last }
    end
    at = last + 1
  end
end

-- --- position of the cursor ---------------------------------------------------------------------

-- Returns the chain a.b["c"]:d that ends at token `i` as a list of names. Returns nil for other expressions,
-- such as the result of a call.
local function chain_before(tokens, i)
  local names = {}
  while true do
    local token = tokens[i]
    if not token then return nil end
    if token.text == "]" then
      local key = tokens[i - 1]
      if not (tokens[i - 2] and tokens[i - 2].text == "[") then return nil end
      table.insert(names, 1, tonumber(key.text) or match(key.text, "^[\"'](.*)[\"']$") or false)
      i = i - 3
    elseif token.kind == "name" then
      table.insert(names, 1, token.text)
      local before = tokens[i - 1] and tokens[i - 1].text
      if before ~= "." and before ~= ":" then return names end
      i = i - 2
    else
      return nil
    end
  end
end

-- Returns the frame of the open bracket "{" at token `i`. The field `call` is the chain of the function
-- that is called with the table; the field `path` has the names of the fields that contain an inner table.
local function brace_frame(tokens, i, parent)
  local before = tokens[i - 1]
  local frame = { open = "{", used = {} }
  if not before then return frame end
  if before.text == "=" and parent and parent.open == "{" and parent.call then
    local field = tokens[i - 2].text
    frame.call = parent.call
    frame.path = parent.path and parent.path .. "." .. field or field
  elseif (before.text == "(" or before.text == ",") and parent and parent.open == "(" then
    frame.call = parent.call
  elseif (before.text == "{" or before.text == ",") and parent and parent.open == "{" then
    frame.call, frame.path = parent.call, parent.path -- an item of a list: plot{ {x=, y=}, ... }
  elseif before.kind == "name" or before.text == "]" then
    frame.call = chain_before(tokens, i - 1)
  end
  return frame
end

-- Returns the innermost frame (bracket) that is still open after the last token, or nil if none is open.
local function open_frame(tokens)
  local frames = {}
  for i = 1, #tokens do
    local text, top = tokens[i].text, frames[#frames]
    if tokens[i].kind == "string" then -- no bracket
    elseif text == "{" then
      frames[#frames + 1] = brace_frame(tokens, i, top)
    elseif text == "(" or text == "[" then
      frames[#frames + 1] = { open = text, call = text == "(" and chain_before(tokens, i - 1) or nil }
    elseif text == "}" or text == ")" or text == "]" then
      frames[#frames] = nil
    elseif text == "=" and top and top.used then
      top.used[tokens[i - 1].text] = true
    end
  end
  return frames[#frames]
end

-- --- values, looked up without running code ----------------------------------------------------

local function class_of(value)
  local metatable = debug.getmetatable(value)
  local name = type(metatable) == "table" and rawget(metatable, "__name")
  if type(name) ~= "string" then return nil end
  name = name:gsub("^archard%.", "")
  return help.entry(name) and name
end

-- Returns the table in which Lua finds a missing key of `value`. Returns nil if the lookup would call a
-- function.
local function fallback_of(value)
  if type(value) == "string" then return rawget(globals, "string") end
  local metatable = debug.getmetatable(value)
  if type(metatable) ~= "table" then return nil end
  local methods = rawget(metatable, "__methods")
  if type(methods) == "table" then return methods end
  local index = rawget(metatable, "__index")
  return type(index) == "table" and index or nil
end

local function raw_member(value, key)
  for _ = 1, 10 do
    if type(value) == "table" then
      local found = rawget(value, key)
      if found ~= nil then return found end
    end
    value = fallback_of(value)
    if value == nil then return nil end
  end
end

-- Returns the value of a chain and the address of its help entry; each may be nil. Help entries state the
-- class of fields that are computed on access.
local function resolve(chain)
  local value = rawget(globals, chain[1])
  local address = value == nil and nil or class_of(value) or help.address_of(value)
  for i = 2, #chain do
    local key = chain[i]
    local member = value ~= nil and raw_member(value, key) or nil
    local below = address and help.entry(address .. "." .. tostring(key)) and address .. "." .. key
    value = member
    address = value ~= nil and (class_of(value) or help.address_of(value)) or below
    local entry = address and help.entry(address)
    if value == nil and entry and entry.class then address = entry.class end
  end
  return value, address
end

local function address_of_call(chain)
  if not chain then return nil end
  local _, address = resolve(chain)
  return address or table.concat(chain, ".")
end

-- --- candidates --------------------------------------------------------------------------------

local function add_keys(set, values, functions_only)
  for key, value in next, values do
    if type(key) == "string" and find(key, "^[%a_][%w_]*$") then
      if not functions_only or type(value) == "function" then set[key] = true end
    end
  end
end

local function add_declared_fields(set, value)
  local metatable = debug.getmetatable(value)
  local fields = type(metatable) == "table" and rawget(metatable, "__fields")
  if type(fields) == "function" then
    local fine, list = pcall(fields, value)
    fields = fine and list
  end
  if type(fields) ~= "table" then return end
  for key, name in next, fields do set[type(key) == "string" and key or name] = true end
end

local function add_members(set, value, functions_only)
  for _ = 1, 10 do
    if value == nil then return end
    if type(value) == "table" then add_keys(set, value, functions_only) end
    if not functions_only then add_declared_fields(set, value) end
    value = fallback_of(value)
  end
end

local function add_documented(set, address, functions_only)
  for _, entry in next, help.members(address) do
    if not functions_only or entry.kind == "method" then set[entry.name] = true end
  end
  local entry = not functions_only and help.entry(address)
  for _, key in next, entry and entry.keys or {} do set[key] = true end
end

local function sorted(set, prefix)
  local words = {}
  for word in next, set do
    if type(word) == "string" and sub(word, 1, #prefix) == prefix then words[#words + 1] = word end
  end
  table.sort(words)
  return words
end

local function global_words(prefix)
  local set = {}
  add_keys(set, globals)
  if prefix ~= "" then
    for _, word in next, spelling.keywords do set[word] = true end
  end
  -- Names that begin with "_" are offered only after a typed "_".
  local words = {}
  for _, word in next, sorted(set, prefix) do
    if prefix ~= "" or sub(word, 1, 1) ~= "_" then words[#words + 1] = word end
  end
  return words
end

local function member_words(tokens, prefix)
  local separator = tokens[#tokens].text
  local chain = chain_before(tokens, #tokens - 1)
  if not chain then return {} end
  local value, address = resolve(chain)
  -- Some names, such as `state`, exist only as arguments of the user's functions.
  if value == nil and not address then address = table.concat(chain, ".") end
  local set = {}
  add_members(set, value, separator == ":")
  if address then add_documented(set, address, separator == ":") end
  return sorted(set, prefix)
end

local function field_words(frame, prefix)
  local address = address_of_call(frame.call)
  local set = {}
  for _, entry in next, help.fields(address, frame.path) do
    if not frame.used[entry.name] then set[entry.name] = true end
  end
  return sorted(set, prefix)
end

local function module_words(prefix)
  local set = {}
  add_keys(set, package.loaded)
  for name in next, package.preload do set[name] = true end
  for name in next, package.loaded do set[name] = true end
  return sorted(set, prefix)
end

-- Completes a text inside a string: with values of a field or of a method's argument, module names, or files.
local function string_words(tokens, frame, prefix)
  local before = tokens[#tokens]
  if before and before.text == "=" and frame and frame.call then
    local entry = help.option(address_of_call(frame.call), frame.path, tokens[#tokens - 1].text)
    if entry and entry.values then return entry.values end
    return "files"
  end
  local call = frame and frame.open == "(" and frame.call
  if before and before.kind == "name" then call = chain_before(tokens, #tokens) end
  if not call then return "files" end
  if call[#call] == "require" then return module_words(prefix) end
  if call[#call] == "help" then return help.addresses() end
  local entry = help.entry(address_of_call(call))
  return entry and entry.values or "files"
end

-- complete.words(text) returns the list of completions, or "files" for file names. The second result is the
-- text to append if there is only one completion.
function complete.words(text)
  local tokens, open = tokenise(text)
  if open and open.kind == "comment" then return {}, "" end
  local frame = open_frame(tokens)
  if open then return string_words(tokens, frame, sub(open.text, 2)), "" end

  local prefix = ""
  local last = tokens[#tokens]
  if last and last.kind == "name" and last.last == #text then
    prefix = last.text
    tokens[#tokens] = nil
    last = tokens[#tokens]
  end
  local before = last and last.text
  if before == "." or before == ":" then return member_words(tokens, prefix), "" end
  if frame and frame.open == "{" and frame.call and (before == "{" or before == "," or before == ";") then
    local words = field_words(frame, prefix)
    if #words > 0 then return words, "=" end
  end
  return global_words(prefix), ""
end

return complete

-- Formats any value as readable text of a given width. Long lists are shortened, nested tables are
-- indented, keys are sorted, and tables that contain themselves are marked. No metamethod except __tostring
-- is called.

local debug, math, next, pcall, rawget, rawlen, string, table, tostring, type, utf8 =
  debug, math, next, pcall, rawget, rawlen, string, table, tostring, type, utf8

local names = require "archard.names"
local spelling = require "archard.lib.spelling"
local term = require "archard.term"

local pretty = {}

-- Limits of the output. "..." replaces omitted items.
local limits = {
  depth = 5,        -- number of levels of nested tables that are shown
  list = 40,        -- number of items shown of the outermost list
  inner_head = 4,   -- number of items shown at the start of a long list inside a table
  keys = 200,       -- number of fields shown of one table
  total = 2000,     -- number of items in the whole output
}

local colours = { number = "36", string = "32", boolean = "35", ["nil"] = "35", dim = "2" }

local function visible_length(text)
  local plain = text:gsub("\27%[[%d;]*m", "")
  return utf8.len(plain) or #plain
end

local writer = {}
writer.__index = writer

function writer:paint(kind, text)
  if not self.colour or not colours[kind] then return text end
  return "\27[" .. colours[kind] .. "m" .. text .. "\27[0m"
end

local escapes = { ["\n"] = "\\n", ["\r"] = "\\r", ["\t"] = "\\t", ["\\"] = "\\\\", ['"'] = '\\"' }

local function quote(text)
  text = text:gsub('[%c\\"]', function(c) return escapes[c] or ("\\%d"):format(c:byte()) end)
  if not utf8.len(text) then
    text = text:gsub("[\128-\255]", function(c) return ("\\%d"):format(c:byte()) end)
  end
  return '"' .. names.plain(text) .. '"'
end

-- Returns the result of an object's __tostring, or nil if it has none.
local function own_text(value)
  local metatable = debug.getmetatable(value)
  if type(metatable) ~= "table" or rawget(metatable, "__tostring") == nil
    or rawget(metatable, "__plain") then return nil end
  local fine, text = pcall(tostring, value)
  if fine then return text end
  return "(its __tostring failed" .. (type(text) == "string" and ": " .. text or "") .. ")"
end

-- Formats a number in a list with six digits, which keeps columns readable.
local function number_in_list(value)
  return math.type(value) == "integer" and tostring(value) or ("%.6g"):format(value)
end

-- Formats a number. NaN and zero are printed without a sign.
local function number_text(value, within)
  if value ~= value then return "nan" end
  if value == 0 and within then return "0" end
  return within == "list" and number_in_list(value) or tostring(value)
end

function writer:scalar(value, within)
  local kind = type(value)
  if kind == "string" then
    return within and self:paint(kind, quote(value)) or value
  elseif kind == "number" then
    return self:paint(kind, number_text(value, within))
  end
  local text = own_text(value) or tostring(value)
  -- Shows an object inside a table as one line.
  if within then text = text:match("^[^\n]*") .. (text:find("\n") and " ..." or "") end
  return self:paint(kind, text)
end

local function is_plain_table(value)
  return type(value) == "table" and own_text(value) == nil
end

local order = { number = 1, string = 2, boolean = 3 }

local function key_before(a, b)
  local ka, kb = order[type(a)] or 4, order[type(b)] or 4
  if ka ~= kb then return ka < kb end
  if ka <= 2 then return a < b end
  return tostring(a) < tostring(b)
end

-- Returns the sorted keys of a table, without the list indices 1 to `count`.
local function sorted_keys(value, count)
  local keys = {}
  for key in next, value do
    local in_list = math.type(key) == "integer" and key >= 1 and key <= count
    if not in_list then keys[#keys + 1] = key end
  end
  table.sort(keys, key_before)
  return keys
end

function writer:key(key)
  if spelling.is_name(key) then return key end
  return "[" .. self:scalar(key, "key") .. "]"
end

-- Returns the number of items shown from the start of a list with `count` items. A shortened list also
-- shows its last item.
local function shown_head(count, depth)
  local most = depth == 0 and limits.list or limits.inner_head + 2
  if count <= most then return count end
  return depth == 0 and limits.list - 2 or limits.inner_head
end

function writer:list_parts(value, count, depth, indent)
  local parts = {}
  local head = shown_head(count, depth)
  for i = 1, head do parts[i] = self:any(rawget(value, i), depth + 1, indent + 2, "list") end
  if head < count then
    parts[head + 1] = self:paint("dim", "...")
    parts[head + 2] = self:any(rawget(value, count), depth + 1, indent + 2, "list")
  end
  return parts, head < count
end

function writer:field_parts(parts, value, count, depth, indent)
  local keys = sorted_keys(value, count)
  for i, key in next, keys do
    if i > limits.keys then
      parts[#parts + 1] = self:paint("dim", ("... (%d more)"):format(#keys - limits.keys))
      break
    end
    local name = self:key(key)
    local text = self:any(rawget(value, key), depth + 1, indent + 2, "field",
      visible_length(name) + 3)
    parts[#parts + 1] = name .. " = " .. text
  end
end

local function fits(parts, available)
  local length = 4
  for _, part in next, parts do
    if part:find("\n") then return false end
    length = length + visible_length(part) + 2
  end
  return length - 2 <= available
end

-- Returns the items of a list side by side, in lines that fit the width.
local function fill(parts, indent, width)
  local margin = string.rep(" ", indent + 2)
  local lines, line, length = {}, {}, 0
  for i, part in next, parts do
    if i < #parts then part = part .. "," end
    local size = visible_length(part) + 1
    if #line > 0 and indent + 2 + length + size > width then
      lines[#lines + 1] = margin .. table.concat(line, " ")
      line, length = {}, 0
    end
    line[#line + 1] = part
    length = length + size
  end
  lines[#lines + 1] = margin .. table.concat(line, " ")
  return "{\n" .. table.concat(lines, "\n") .. "\n" .. string.rep(" ", indent) .. "}"
end

local function stack(parts, indent)
  local margin = "\n" .. string.rep(" ", indent + 2)
  return "{" .. margin .. table.concat(parts, "," .. margin) .. "\n" .. string.rep(" ", indent) .. "}"
end

local function has_tables(value, count)
  for i = 1, count do
    if is_plain_table(rawget(value, i)) then return true end
  end
  return false
end

function writer:table(value, depth, indent, taken)
  if self.path[value] then return self:paint("dim", "<cycle>") end
  if next(value) == nil then return "{}" end
  if depth >= limits.depth then return self:paint("dim", "{...}") end
  self.path[value] = true
  local count = rawlen(value)
  local parts, shortened = self:list_parts(value, count, depth, indent)
  local items = #parts
  self:field_parts(parts, value, count, depth, indent)
  self.path[value] = nil
  local text
  local note = shortened and (" (%d items)"):format(count) or ""
  if fits(parts, self.width - indent - taken - #note - 1) then
    text = "{ " .. table.concat(parts, ", ") .. " }"
  elseif #parts == items and not has_tables(value, count) then
    text = fill(parts, indent, self.width)
  else
    text = stack(parts, indent)
  end
  return text .. (shortened and self:paint("dim", note) or "")
end

function writer:any(value, depth, indent, within, taken)
  self.total = self.total + 1
  if self.total > limits.total then return self:paint("dim", "...") end
  if is_plain_table(value) then return self:table(value, depth, indent, taken or 0) end
  return self:scalar(value, within)
end

-- Returns the text of a value, without a final newline. options: { width = 80, colour = false }. A string
-- is returned unchanged; inside a table it is quoted.
function pretty.format(value, options)
  options = options or {}
  local self = setmetatable({
    width = options.width or 80,
    colour = options.colour or false,
    path = {},
    total = 0,
  }, writer)
  return self:any(value, 0, 0)
end

-- Formats a value for the width of the terminal. print() shows lists in this form.
function pretty.fitted(value) return pretty.format(value, { width = (term.size()) }) end

return pretty

-- The interactive prompt: compiles the lines of the user, checks whether they are complete, and shows their
-- values.

-- Local copies of globals, because the user may overwrite any global.
local error, load, print, rawget, rawset, select, tonumber, type = error, load, print, rawget, rawset,
  select, tonumber, type
local math, table, string, io, os = math, table, string, io, os
local globals = _G

local csv_units = require "archard.lib.csv_units"
local names = require "archard.names"
local pager = require "archard.lib.pager"
local term = require "archard.term"
local pretty = require "archard.lib.pretty"
local version = require "archard".version

local prompt = {}

-- Compiles `text` as part of the chunk `name`, with line numbers that start at `line`.
local function load_at(text, name, line)
  local parts = { string.rep("\n", line - 1), text }
  local next_part = 0
  return load(function()
    next_part = next_part + 1
    if parts[next_part] == "" then next_part = next_part + 1 end
    return parts[next_part]
  end, name, "t")
end

-- Returns true if the parser expects more lines. An unfinished quoted string is an error unless its
-- line ends with a backslash.
local function is_open(message, text)
  if message:find("unfinished string near", 1, true) and not text:find("\\$") then return false end
  return message:find("<eof>'?$") ~= nil
end

-- Splits the text into two parts: its last lines, which are an expression, and the lines before them, which
-- are a chunk. The values of the expression can then be shown. Returns nil if this is not possible. Lines
-- that Lua would join with the previous line, such as "(c)" after "a = b", are not split.
local function split_last(text)
  local at = #text
  for _ = 1, 100 do
    local head = text:sub(1, at):match("^(.*)\n")
    if not head then return nil end
    local tail = text:sub(#head + 2)
    if tail:find("^%s*[^%s%-~({\"'%[]") and load("return " .. tail) and load(head) then
      return head, tail
    end
    at = #head
  end
end

-- Returns code that runs `head` and returns the values of `expression`. The code avoids the tail call
-- `return f()`, which would remove the frame of the chunk and thus the line number of errors in f.
local function handed_on(head, expression)
  -- Adds a line break only if the text may end with a comment, since a line break shifts the line numbers of errors.
  local ended = expression:find("--", 1, true) and "\n)" or ")"
  return head .. "return (function(...) return ... end)(" .. expression .. ended
end

local own_names = {} -- the globals that the program defines
for name, value in pairs(globals) do own_names[name] = value end

local noted_locals = false

-- Prints a note if a line is valid Lua that users from other programs do not expect.
local function note_surprises(text)
  local function note(...) io.stderr:write("note: ", string.format(...), "\n") end
  if not noted_locals and text:find("^%s*local%s") then
    noted_locals = true
    note("a local variable exists only in its chunk; omit 'local' to keep the value")
  end
  if not term.is_terminal() then return end
  local whole, part = text:match("^%s*[%a_][%w_.]*%s*=%s*(%-?%d+),(%d[%deE.+-]*)%s*$")
  if whole then note("the value is %s: numbers have a decimal point, as in %s.%s", whole, whole, part) end
  local name = text:match("^%s*([%a_][%w_]*)%s*=[^=]")
  if name and own_names[name] ~= nil and rawget(globals, name) == own_names[name] then
    note("%s was defined by the program, and is replaced for this session", name)
  end
end

-- Converts short commands, as in IPython and Octave: ?name and name? show help, ? the overview, !command runs in the shell,
-- and clear clears the screen unless a global has this name. Returns a function that runs the command, or
-- nil if the text is not a short command.
local function short_command(text)
  local word = text:match("^%s*%?%s*([%w_.:{}]+)%s*$") or text:match("^%s*([%w_.:{}]+)%s*%?%s*$")
  if word then return function() require "archard".help(word) end end
  if text:find("^%s*%?%s*$") then return function() require "archard".help() end end
  local line = text:match("^%s*!%s*(.+)$")
  if line then
    return function()
      if not os.execute then error("programs of the system are not run in the sandbox", 0) end
      os.execute(line)
    end
  end
  if text:find("^%s*clear%s*$") and rawget(globals, "clear") == nil and term.is_terminal() then
    return function() io.write("\27[H\27[2J") end
  end
end

local function unit_message(number, unit)
  return ("numbers have no units: %s instead of %s %s (help \"units\")"):format(number, number, unit)
end

-- Returns a message if the text becomes complete with "()", which would otherwise wait for more lines:
-- "w:run" and "x = 5 mm". Returns nil for other texts.
local function refuse_without_call(text)
  if not load(text .. "()", "", "t") then return nil end
  local number, unit = text:match("([%d.]+)%s+([%a_][%w_]*)%s*$")
  if number then return unit_message(number, unit) end
  local method = text:match("([%w_.]+:[%w_]+)%s*$")
  return method and ("a method is called with () or {}: %s()"):format(method)
end

local longest = 10000 -- [bytes] longer texts are not searched for hints; the duration grows with the square of the length

-- Returns a hint for a text that is not valid Lua, or "". `message` is Lua's error message.
local function hint_for(text, message)
  if #text > longest then return "" end
  local word = text:match "^%s*help%s+([%w_.:{}]+)%s*$"
  if word then return ('; did you mean help "%s"?'):format(word) end
  local next_field = message:match "expected near '([%a_][%w_]*)'$" or message:match "to close '{' at line %d+%) near '([%a_][%w_]*)'$"
  if next_field and text:find("{.*[^%s,{][ \t\n]+" .. next_field .. "%s*=") then
    return ("; a comma is missing before %s"):format(next_field)
  end
  for amount, word in text:gmatch "(%d[%d.eE+-]*)%s+(%a[%w]*)" do
    if csv_units.known(word) and word ~= "in" then return "; " .. unit_message(amount, word) end
  end
  local number, unit = message:match "malformed number near '([%d.]+)(%a+)'$"
  if number and not number:find("^0$") then return ("; numbers have no units: %s (help \"units\")"):format(number) end
  local object, field = text:match "([%a_][%w_.:]*)%s*[%(%[]%s*([%a_][%w_]*)%s*=[^=]"
  if object then return ("; fields are given in braces: %s{ %s = ... }"):format(object, field) end
  return ""
end

-- Compiles the text of the user. Returns a function; nil and a message after an error; or nil, nil if more
-- lines are needed.
function prompt.compile(text, name, line)
  local short = short_command(text)
  if short then return short end
  local expression = text:gsub("^%s*=", "")
  local chunk, as_expression = load_at("return " .. expression, name, line)
  if chunk then return load_at(handed_on("", expression), name, line) or chunk end
  if text:find("\n") then
    local head, tail = split_last(text)
    chunk = head and load_at(handed_on(head .. "\n", tail), name, line)
    if chunk then return chunk end
  end
  local as_statement
  chunk, as_statement = load_at(text, name, line)
  if chunk then
    note_surprises(text)
    return chunk
  end
  if is_open(as_statement, text) or is_open(as_expression, text) then return nil, refuse_without_call(text) end
  local message = text:find("^%s*=") and as_expression or as_statement
  return nil, message .. hint_for(text, message)
end

-- Returns a syntax error with a hint. `text` is the chunk; if it is nil, `file` is the name of the script, of which
-- the lines before the error are read.
function prompt.explained(message, text, file)
  local line = tonumber(message:match ":(%d+): ")
  local opened = not text and line and io.open(file)
  if opened then
    local lines = {}
    for each in opened:lines() do
      lines[#lines + 1] = each
      if #lines == line then break end
    end
    opened:close()
    text = table.concat(lines, "\n", math.max(1, line - 20), #lines)
  end
  return message .. (text and hint_for(text, message) or "")
end

-- Shows the values of a chunk and stores the first one in the global `_`. A single string is shown page by
-- page.
function prompt.show(...)
  local count = select("#", ...)
  local first = ...
  if first ~= nil then rawset(globals, "_", first) end
  local width = term.size()
  local texts, together = {}, 0
  for i = 1, count do
    local value = select(i, ...)
    texts[i] = type(value) == "string" and names.plain(value)
      or pretty.format(value, { width = width, colour = term.colour() })
    together = texts[i]:find("\n") and math.huge or together + #texts[i] + 2
  end
  local text = table.concat(texts, together <= width and "  " or "\n")
  if count == 1 and type(first) == "string" then return pager.show(text) end
  print(text)
end

local texts = {
  first = "> ",
  more = ">> ",
  banner = "archard " .. version .. ", wear of sliding surfaces. help() explains, Ctrl-D exits.\n",
}

function prompt.text(which)
  local text = texts[which]
  if which == "banner" or not term.colour() then return text end
  -- Readline needs \1 and \2 around invisible characters.
  return "\1\27[1m\2" .. text .. "\1\27[0m\2"
end

return prompt

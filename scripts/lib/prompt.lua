-- What the prompt does with a chunk: is it complete, how are its values shown, what the prompt
-- looks like. Leans on archard.lib.pretty and archard.term.

-- The user may overwrite any global: keep what is needed here.
local error, load, print, rawget, rawset, select, type = error, load, print, rawget, rawset, select, type
local table, string, io, os = table, string, io, os
local globals = _G

local names = require "archard.names"
local pager = require "archard.lib.pager"
local term = require "archard.term"
local pretty = require "archard.lib.pretty"
local version = require "archard".version

local prompt = {}

-- Loads `text` as if it stood at line `line` of `name`.
local function load_at(text, name, line)
  local parts = { string.rep("\n", line - 1), text }
  local next_part = 0
  return load(function()
    next_part = next_part + 1
    if parts[next_part] == "" then next_part = next_part + 1 end
    return parts[next_part]
  end, name, "t")
end

-- Did the parser come to the end and want more? A string in quotes ends with its line, unless a
-- backslash stands there.
local function is_open(message, text)
  if message:find("unfinished string near", 1, true) and not text:find("\\$") then return false end
  return message:find("<eof>'?$") ~= nil
end

-- The text up to its last lines, and these, where they alone are an expression and those before them
-- alone a chunk: then the expression's values can be shown. Lines that Lua would take for the end
-- of what stands above, as in "a = b" over "(c)", are left together.
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

-- A chunk that ends with the values of `expression`. A plain `return f()` would be a tail call: the
-- chunk's frame would be gone, and with it the line that an error in f is to be reported at.
local function handed_on(head, expression)
  local ended = expression:find("--", 1, true) and "\n)" or ")" -- on its line, as errors are told by it
  return head .. "return (function(...) return ... end)(" .. expression .. ended
end

local told_about_locals = false

local function note_locals(text)
  if told_about_locals or not text:find("^%s*local%s") then return end
  told_about_locals = true
  io.stderr:write("note: a local lives in its own chunk only; leave out 'local' to keep the value\n")
end

-- Lines as in IPython and Octave: ?name and name? explain, !command runs in the shell, clear clears the
-- screen unless a global has that name. Returns what does it, or nil.
local function short_command(text)
  local word = text:match("^%s*%?%s*([%w_.:{}]+)%s*$") or text:match("^%s*([%w_.:{}]+)%s*%?%s*$")
  if word then return function() require "archard".help(word) end end
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

-- compile(text, name, line) -> function; or nil, message; or nil, nil where more lines are needed.
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
    note_locals(text)
    return chunk
  end
  if is_open(as_statement, text) or is_open(as_expression, text) then return nil, nil end
  return nil, text:find("^%s*=") and as_expression or as_statement
end

-- Shows the values of a chunk, a text longer than the screen page by page; keeps the first in the global `_`.
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

-- Text of the prompt itself; readline wants what takes no room between \1 and \2.
local texts = {
  first = "> ",
  more = ">> ",
  banner = "archard " .. version .. ", wear of sliding surfaces. help() explains, Ctrl-D leaves.\n",
}

function prompt.text(which)
  local text = texts[which]
  if which == "banner" or not term.colour() then return text end
  return "\1\27[1m\2" .. text .. "\1\27[0m\2"
end

return prompt

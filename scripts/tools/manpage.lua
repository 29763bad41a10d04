-- Writes the manual page archard-lua(7), made from the help entries, to standard output:
--
--   archard scripts/tools/manpage.lua > build/man/archard-lua.7

local help = require "archard.help"
local show = require "archard.help.show"

local out = {}
local function put(...) out[#out + 1] = table.concat({ ... }) end

-- Escapes a text for roff: backslashes, and dots and quotes at the beginning of a line.
local function escape(text)
  return (text:gsub("\\", "\\e"):gsub("^([.'])", "\\&%1"):gsub("\n([.'])", "\n\\&%1"))
end

-- Writes a text in lines of at most 76 characters. Each sentence begins on a new line.
local function put_filled(text)
  text = text:gsub("%s+", " ")
  local line = ""
  for word in text:gmatch("%S+") do
    if line ~= "" and #line + #word > 76 then
      put(escape(line))
      line = ""
    end
    line = line == "" and word or line .. " " .. word
    if word:find("[%l%d)\"][.]$") and not word:find("Eqs?%.$") and not word:find("%.%.%.$") then
      put(escape(line))
      line = ""
    end
  end
  if line ~= "" then put(escape(line)) end
end

local function put_text(text)
  local literal = false
  for line in (text:gsub("\n\n", "\n\0\n") .. "\n"):gmatch("(.-)\n") do
    local wanted = line:find("^  ") ~= nil
    if wanted ~= literal then put(wanted and ".Bd -literal" or ".Ed") end
    literal = wanted
    if wanted then
      put(escape(line))
    elseif line == "\0" then
      if not text:find("\n\n  ", 1, true) then put(".Pp") end
    elseif line ~= "" then
      put_filled(line)
    end
  end
  if literal then put(".Ed") end
end

-- Returns the first line of a list item. The text is escaped so that roff does not read it as a macro.
local function item(text)
  local words = {}
  for word in escape(text):gmatch("%S+") do
    words[#words + 1] = "\\&" .. word:gsub('"', "\\(dq")
  end
  return ".It Li " .. table.concat(words, " ")
end

local function put_entry(entry, name)
  put(item(name))
  put_text(entry.text)
  local facts = show.facts(entry)
  if facts ~= "" then put_filled("(" .. facts .. ")") end
end

local function put_list(title, list, name_of)
  if #list == 0 then return end
  put(".Pp")
  put(title)
  put('.Bl -tag -width "xxxxxx" -compact')
  for _, entry in ipairs(list) do put_entry(entry, name_of(entry)) end
  put(".El")
end

local function option_name(entry)
  return (entry.path ~= "" and entry.path .. "." or "") .. entry.name
end

local function options_of(address)
  local list = {}
  for _, entry in ipairs(help.all()) do
    if entry.kind == "option" and entry.owner == address then list[#list + 1] = entry end
  end
  return list
end

-- Returns the members of an object and of its fields, such as wear.depth.cylinder.
local function members_of(address, kind)
  local list = {}
  for _, entry in ipairs(help.all()) do
    local own = entry.kind ~= "option" and entry.address:sub(1, #address + 1) == address .. "."
    local called = entry.kind == "method" or entry.kind == "function"
    if own and (kind == "called") == called then list[#list + 1] = entry end
  end
  return list
end

local function put_object(entry)
  put(".Ss ", entry.name)
  put(".Dl ", escape(entry.use or entry.address))
  put(".Pp")
  put_text(entry.text)
  put_list("Fields of the definition:", options_of(entry.address), option_name)
  put_list("Fields:", members_of(entry.address, "read"), function(member)
    return member.address:sub(#entry.address + 2)
  end)
  local called = members_of(entry.address, "called")
  put_list("Functions:", called, function(member) return member.use or member.address end)
  for _, member in ipairs(called) do
    put_list(("Fields of the argument of %s:"):format(member.name), options_of(member.address), option_name)
  end
end

local head = [[
.\" Written by scripts/tools/manpage.lua from the help entries.
.Dd November 22, 2026
.Dt ARCHARD-LUA 7
.Os
.Sh NAME
.Nm archard-lua
.Nd objects and functions of archard
.Sh DESCRIPTION
The objects and functions that
.Xr archard 1
provides in Lua, at its prompt and in scripts, with fields, units and defaults.
They are globals, and fields of
.Li require \(dqarchard\(dq .
A constructor has one argument, a table of named fields.
All fields have defaults, which are the values of the reference case.
An unknown name, a wrong type or a value out of range is an error.
Equation numbers refer to the article under
.Sx SEE ALSO .
.Sh OBJECTS]]

local tail = [[
.Sh SEE ALSO
.Xr archard 1 ,
.Xr lua 1 ,
.Xr archard-file 5
.Rs
.%A L. Mattei
.%A F. Di Puccio
.%T Influence of the wear partition factor on wear evolution modelling of sliding surfaces
.Re]]

put(head)
for _, entry in ipairs(help.all()) do
  if entry.kind ~= "option" and not entry.address:find("[.{]") then put_object(entry) end
end
put(".Sh TOPICS")
for _, topic in ipairs(require "archard.help.topics") do
  put(".Ss ", topic[1])
  put_text(topic[2])
end
put(tail)
print(table.concat(out, "\n"))

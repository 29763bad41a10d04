-- help() explains objects, fields and methods. This file searches the help entries and shows them. The
-- entries are in the other files of this folder, the topics in topics.lua. Completion at the prompt uses the
-- entries for names that no table contains, and the manual page is generated from the entries.
--
-- Addresses of entries: "wear" is an object, "wear.step" is a method or field of this object, "wear{jump}"
-- is a field of the definition table of wear{}, and "wear{loading.x}" is a field of a table inside that
-- table.

local debug, ipairs, next, print, rawget, select, string, table, type =
  debug, ipairs, next, print, rawget, select, string, table, type

local names = require "archard.names"
local pager = require "archard.lib.pager"
local search = require "archard.help.search"

local help = {}

local entries     -- entries by address
local ordered     -- entries in the order of the files
local topics = {}  -- topics by name in lower case, and as a list in the order of the overview

-- Splits the address of an entry, such as "wear.step" or "wear{k}". Returns the owner ("wear"), the name
-- within the owner ("step" or "k"), and true for a name in braces, which is a field of the owner's definition
-- table.
local function split(address)
  local owner, option = address:match("^(.-){(.*)}$")
  if owner then return owner, option, true end
  owner, option = address:match("^(.*)%.([^.]+)$")
  if owner then return owner, option, false end
  return nil, address, false
end

local function add(list)
  for _, entry in ipairs(list) do
    entry.address = entry[1]
    local in_definition
    entry.owner, entry.name, in_definition = split(entry.address)
    if in_definition then
      entry.kind = entry.kind or "option"
      entry.path, entry.name = entry.name:match("^(.-)%.?([^.]*)$")
    end
    entries[entry.address] = entry
    ordered[#ordered + 1] = entry
  end
end

-- Loads the entries at the first use of help, since scripts without help do not need them.
local function load_entries()
  if entries then return end
  entries, ordered = {}, {}
  add(require "archard.help.settings"(require "archard.help.engine"))
  add(require "archard.help.tools")
  add(require "archard.help.maps")
  add(require "archard.help.joint")
  add(require "archard.help.study")
  add(require "archard.help.fit")
  add(require "archard.help.uncertainty")
  add(require "archard.help.session")
  for i, topic in ipairs(require "archard.help.topics") do
    topics[i] = { address = topic[1], name = topic[1], kind = "topic", text = topic[2] }
    topics[topic[1]:lower()] = topics[i]
  end
end

-- --- functions for completion and the manual --------------------------------------------------

-- Returns the entry at an address, or nil if there is none. Fields of an entry: address, name, owner, kind,
-- type, unit, default, values, text; class: class of the value or result; takes: name of an object, such as
-- "plot", whose options this function or field also accepts in its table; use: an example.
function help.entry(address)
  load_entries()
  return entries[address]
end

function help.all()
  load_entries()
  return ordered
end

function help.addresses()
  local list = {}
  for i, entry in ipairs(help.all()) do list[i] = entry.address end
  for _, topic in ipairs(topics) do list[#list + 1] = topic.name end
  return list
end

-- Returns the entries of the methods and fields of an object.
function help.members(address)
  local list = {}
  for _, entry in ipairs(help.all()) do
    if entry.owner == address and entry.kind ~= "option" then list[#list + 1] = entry end
  end
  return list
end

-- Returns the entries of the fields in the definition table of `address`, or in an inner table of it at
-- `path`.
function help.definition(address, path)
  local list = {}
  for _, entry in ipairs(help.all()) do
    if entry.kind == "option" and entry.owner == address and entry.path == (path or "") then
      list[#list + 1] = entry
    end
  end
  return list
end

-- Returns true if `address` is a string and `path` is a string or nil.
local function names_fit(address, path)
  return type(address) == "string" and (path == nil or type(path) == "string")
end

-- Follows a path through tables that have the fields of another definition, such as wear{ model={ ... } } or
-- the options of plot{} in plot.pressure(w, { ... }). Returns the address of the other definition and the
-- rest of the path inside it. Returns nil for a field that cannot be changed in an existing object.
local function follow(address, path)
  local at = address
  local rest = ""
  for name in (path or ""):gmatch("[^.]+") do
    rest = rest == "" and name or rest .. "." .. name
    local entry = entries[("%s{%s}"):format(at, rest)]
    local taken = not entry and entries[at] and entries[at].takes
    if taken then
      local changes = entries[at].kind == "method"
      at, entry = taken, entries[("%s{%s}"):format(taken, rest)]
      if changes and entry and entry.fixed then return nil end
    end
    local other = entry and (entry.takes or entry.class)
    if other and #help.definition(at, rest) == 0 then at, rest = other, "" end
  end
  return at, rest
end

-- Returns the entries of all fields that the table at `path` in the definition of `address` may have,
-- including fields of another definition. Fields that cannot be changed in an existing object are omitted.
function help.fields(address, path)
  if not names_fit(address, path) then return {} end
  load_entries()
  local at, rest = follow(address, path)
  if not at then return {} end
  local list = help.definition(at, rest)
  local taken = rest == "" and entries[at] and entries[at].takes
  for _, entry in ipairs(taken and help.definition(taken) or {}) do
    if not (entry.fixed and entries[at].kind == "method") then list[#list + 1] = entry end
  end
  return list
end

function help.option(address, path, name)
  for _, entry in ipairs(help.fields(address, path)) do
    if entry.name == name then return entry end
  end
end

-- --- addresses of values ----------------------------------------------------------------------

local function class_name(value)
  local metatable = debug.getmetatable(value)
  local name = type(metatable) == "table" and rawget(metatable, "__name")
  return type(name) == "string" and (name:gsub("^archard%.", "")) or nil
end

local function find_in(methods, value, prefix)
  if type(methods) ~= "table" then return nil end
  for name, member in next, methods do
    if member == value and type(name) == "string" then return prefix .. "." .. name end
  end
end

-- Returns the address of a function that is a method of a class. The metatables in the registry are
-- searched.
local function find_method(value)
  for key, metatable in next, debug.getregistry() do
    if type(key) == "string" and type(metatable) == "table" then
      local class = (key:gsub("^archard%.", ""))
      if entries[class] then
        local found = find_in(rawget(metatable, "__methods"), value, class)
          or find_in(rawget(metatable, "__index"), value, class)
        if found then return found end
      end
    end
  end
end

-- Returns the address of a value: a global of archard, a function in such a global, an object or a method.
-- Returns nil for other values.
function help.address_of(value)
  load_entries()
  if value == nil then return nil end
  local kind = type(value)
  if kind ~= "function" and kind ~= "table" and kind ~= "userdata" then return nil end
  local module = require "archard"
  for name, member in next, module do
    if rawequal(member, value) and entries[name] then return name end
  end
  for name, member in next, module do
    local found = type(member) == "table" and kind == "function" and find_in(member, value, name)
    if found and entries[found] then return found end
  end
  if kind == "function" then return find_method(value) end
  local class = class_name(value)
  return class and entries[class] and class or nil
end

-- --- search by name ----------------------------------------------------------------------------

local function spoken(name)
  return (name:gsub("%s+", ""):gsub("%(.*%)$", ""):gsub("[{:]$", ""):gsub(":", "."))
end

-- Returns the entry "wear.step" for the name "w.step" if the global w is a wear object.
local function by_object(name)
  local object, member = name:match("^([%a_][%w_]*)%.(.+)$")
  local class = object and help.address_of(rawget(_G, object))
  return class and entries[class .. "." .. member]
end

-- Returns the entry "contact.slip" for the name "c.slip", because the help texts call a contact c.
local function by_letter(name)
  local letter, member = name:match("^(%l)%.(.+)$")
  for _, entry in ipairs(letter and ordered or {}) do
    local other = entries[entry.address:match("^[^.]*") .. "." .. member]
    if other and entry.use and entry.use:sub(1, 2) == letter .. ":" then return other end
  end
end

-- Returns true if an entry has the given name. The name of an option can include its path, such as
-- mesh.size or model.mesh.size.
local function is_called(entry, name)
  if entry.name == name then return true end
  if entry.kind ~= "option" then return false end
  local place = (entry.path ~= "" and entry.path .. "." or "") .. entry.name
  return place == name or entry.owner .. "." .. place == name
end

-- Returns all entries that a name can mean. If the name is the address of an entry, only this entry is returned; else
-- all topics and entries with this name, with options of methods at the end.
function help.find(name)
  if type(name) ~= "string" then return {} end
  load_entries()
  local topic = topics[name:lower():match("^%s*(.-)%s*$")]
  name = spoken(name)
  local exact = entries[name] or by_object(name) or by_letter(name)
  if exact then return { exact } end
  local found, of_methods = { topic }, {}
  for _, entry in ipairs(ordered) do
    local list = entry.kind == "option" and entry.owner:find(".", 1, true) and of_methods or found
    if is_called(entry, name) then list[#list + 1] = entry end
  end
  return table.move(of_methods, 1, #of_methods, #found + 1, found)
end

-- Returns the examples as entries; an empty list if they are not installed.
local function example_entries()
  local fine, list = pcall(require "archard.lib.examples_folder".entries)
  return fine and list or {}
end

-- Returns all topics, entries and examples.
local function everything()
  load_entries()
  local list = table.move(topics, 1, #topics, 1, {})
  table.move(ordered, 1, #ordered, #list + 1, list)
  local examples = example_entries()
  return table.move(examples, 1, #examples, #list + 1, list)
end

-- Returns the topics, entries and examples that contain all words of a text or are listed for the text as a
-- synonym. The best are first. Also returns the number of good answers among them, and true if these are
-- from a synonym.
function help.matches(text)
  if type(text) ~= "string" then return {}, 0, false end
  return search.find(everything(), text)
end

-- --- showing -----------------------------------------------------------------------------------

local show = require "archard.help.show"

-- Returns the known name that is most similar to `name` or to its last part; nil if none is similar enough.
local function nearest(name)
  local known = {}
  for _, entry in ipairs(ordered) do
    known[#known + 1], known[#known + 2] = entry.name, entry.address
  end
  for _, topic in ipairs(topics) do known[#known + 1] = topic.name end
  return names.nearest(name, known) or names.nearest(name:match("[^.]+$") or name, known)
end

-- Returns the paragraphs of a text that contain all words of a phrase or, without such a paragraph, its last word. Also
-- returns the number of all paragraphs.
local function paragraphs_with(phrase, text)
  local all, chosen = {}, {}
  local joined = text:gsub("\n\n  ", "\n\0  ") -- an example belongs to the paragraph before it
  for paragraph in (joined .. "\n\n"):gmatch "(.-)\n\n+" do all[#all + 1] = paragraph:gsub("%z", "\n") end
  for _, words in ipairs{ phrase, phrase:match "%S+%s*$" } do
    for _, paragraph in ipairs(all) do
      if search.contains(words, paragraph) then chosen[#chosen + 1] = paragraph end
    end
    if chosen[1] then break end
  end
  return chosen, #all
end

-- Returns the entry of a long topic with only those of its paragraphs that are about `name`; the entry itself if it is
-- short or of another kind, or if no or all paragraphs are.
local function part_of(entry, name)
  local long = 1000 -- [characters]
  if not name or entry.kind ~= "topic" or #entry.text < long then return entry end
  local parts, count = paragraphs_with(name, entry.text)
  if not parts[1] or #parts == count then return entry end
  return { address = entry.address, name = entry.name, kind = "topic",
    text = ("%s\n\nhelp %q shows the whole topic."):format(table.concat(parts, "\n\n"), entry.name) }
end

-- Returns a text: the first of the entries found, and a list of the others. Only paragraphs about `name` of a long topic
-- are shown; nil shows all. Returns nil without an entry.
local function first_of(found, name)
  local best, others = found[1], {}
  if not best then return nil end
  for i = 2, #found do
    if found[i].owner ~= best.address then others[#others + 1] = found[i] end
  end
  local text = show.entry(help, part_of(best, name))
  return others[1] and text .. "\n\n" .. show.others(others, 5) or text
end

-- Returns the help text for a synonym, such as "roughness", or nil. Also returns the entries that the search finds.
local function explain_synonym(name)
  local found, sure, meant = help.matches(name)
  return meant and first_of(table.move(found, 1, sure, 1, {}), name), found, sure
end

-- Returns the help text of a name. A synonym has priority over fields and methods of this name. If no entry has the name,
-- it is read as a question or as a word to search for, and a similar name is suggested if the search finds nothing.
local function explain_name(name)
  local found = help.find(name)
  if #found == 0 then found = help.find(name:lower()) end
  if #found > 0 then
    local text = found[1].owner and not name:find("[.{:]") and explain_synonym(name)
    if text then return text end
    if found[1].kind == "topic" then return first_of(found) end
    local texts = {}
    for i, entry in ipairs(found) do texts[i] = show.entry(help, entry) end
    return table.concat(texts, "\n\n")
  end
  local text = #search.words(name) > 1 and first_of(search.answers(everything(), name), name)
  if text then return text end
  local meant, sure
  meant, found, sure = explain_synonym(name)
  if meant then return meant end
  if sure > 0 then return show.found(found, name, math.min(sure, 12)) end
  local near = nearest(spoken(name))
  local hint = #found > 0 and ("help.search %q finds entries with parts of these words"):format(name)
    or "help() lists the objects and topics"
  return ("no help for %q%s; %s"):format(name, near and (", did you mean %q?"):format(near) or "", hint)
end

-- Returns the text that help(value) prints.
function help.text(...)
  load_entries()
  if select("#", ...) == 0 then return show.overview() end
  local value = ...
  if type(value) == "string" then return explain_name(value) end
  local address = help.address_of(value)
  if address and entries[address] then return show.entry(help, entries[address]) end
  if value == nil then return "no help for nil: no value has this name; check its spelling" end
  return ("no help for this %s; help \"p_max\" explains a field by its name, help() lists all names"):format(type(value))
end

-- Prints a list of all topics, entries and examples that contain the words of `text`.
function help.search(text)
  local found = help.matches(text)
  if not found[1] then
    return print(('no text contains %s; try another word, as in help.search "units", or help()'):format(names.shown(text)))
  end
  pager.show(show.found(found, text))
end

return setmetatable(help, {
  __call = function(_, ...) pager.show(help.text(...)) end,
  __tostring = function() return show.overview() end,
})

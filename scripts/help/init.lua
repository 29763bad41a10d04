-- help(): explains objects, fields and methods. The entries are in the files of this folder (engine, tools, maps, joint,
-- session, study, fit, uncertainty), the topics in topics.lua. This file finds and shows them. Completion uses it for
-- names that no table contains, and the manual page is written from it.
--
-- Addresses: "wear" is an object, "wear.step" its method or field, "wear{jump}" a field of its definition table, and
-- "wear{loading.x}" a field of a table in that table.

local debug, next, print, rawget, select, string, table, type =
  debug, next, print, rawget, select, string, table, type

local names = require "archard.names"
local pager = require "archard.lib.pager"
local search = require "archard.help.search"

local help = {}

local entries     -- by address
local ordered     -- as written
local topics = {}  -- by name, and as written

-- Splits an address into the owner, the name within it, and true if the name is in the definition table of the owner.
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

-- Reads the entries on first use, so that scripts without help do not need time for them.
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
    topics[topic[1]] = topics[i]
  end
end

-- --- for completion and the manual ------------------------------------------------------------

-- Returns the entry of an address, or nil. Fields: address, name, owner, kind, type, unit, default, values, class (of its
-- value or result), takes (the object whose definition has further fields of it), use (an example of its use), text.
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

-- Returns the methods and fields of an object.
function help.members(address)
  local list = {}
  for _, entry in ipairs(help.all()) do
    if entry.owner == address and entry.kind ~= "option" then list[#list + 1] = entry end
  end
  return list
end

-- Returns the fields of the definition table of `address`, or of the table at `path` within it.
function help.definition(address, path)
  local list = {}
  for _, entry in ipairs(help.all()) do
    if entry.kind == "option" and entry.owner == address and entry.path == (path or "") then
      list[#list + 1] = entry
    end
  end
  return list
end

-- Returns true if the address, and the path unless it is nil, are strings.
local function names_fit(address, path)
  return type(address) == "string" and (path == nil or type(path) == "string")
end

-- Follows a path into tables whose fields are those of another definition, such as wear{ model={ ... } }, or plot{} in
-- plot.pressure(w, { ... }). Returns an address and the rest of the path within it; nil for a field that cannot be
-- changed in an existing object.
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

-- Returns all fields that a table may have, including those of another definition, without fields that cannot be changed
-- in an existing object.
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

-- --- from a value to its address --------------------------------------------------------------

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

-- Returns the address of a function that is a method of some class, from the metatables in the registry.
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

-- Returns the address of a global of archard, a function in it, an object or a method; nil for other values.
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

-- --- finding by name ---------------------------------------------------------------------------

local function spoken(name)
  return (name:gsub("%s+", ""):gsub("%(.*%)$", ""):gsub("[{:]$", ""):gsub(":", "."))
end

-- Returns the entry "wear.step" for "w.step" if w is a global wear object.
local function by_object(name)
  local object, member = name:match("^([%a_][%w_]*)%.(.+)$")
  local class = object and help.address_of(rawget(_G, object))
  return class and entries[class .. "." .. member]
end

-- Returns true if the entry has this name. An option may also have its path, such as mesh.size or model.mesh.size.
local function is_called(entry, name)
  if entry.name == name then return true end
  if entry.kind ~= "option" then return false end
  local place = (entry.path ~= "" and entry.path .. "." or "") .. entry.name
  return place == name or entry.owner .. "." .. place == name
end

-- Returns every entry that a name can mean: the entry with this address, else all entries with this name, options of
-- methods last.
function help.find(name)
  if type(name) ~= "string" then return {} end
  load_entries()
  local topic = topics[name:lower():match("^%s*(.-)%s*$")]
  name = spoken(name)
  local exact = entries[name] or by_object(name)
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

-- Returns the topics, entries and examples that contain all words of the text or explain its synonym, and how many of
-- them answer it.
function help.matches(text)
  if type(text) ~= "string" then return {}, 0 end
  load_entries()
  local list = table.move(topics, 1, #topics, 1, {})
  table.move(ordered, 1, #ordered, #list + 1, list)
  local examples = example_entries()
  table.move(examples, 1, #examples, #list + 1, list)
  return search.find(list, text)
end

-- --- showing -----------------------------------------------------------------------------------

local show = require "archard.help.show"

-- Returns the known name nearest to `name`, or to its last part, if it is similar enough for a typing error.
local function nearest(name)
  local known = {}
  for _, entry in ipairs(ordered) do
    known[#known + 1], known[#known + 2] = entry.name, entry.address
  end
  for _, topic in ipairs(topics) do known[#known + 1] = topic.name end
  return names.nearest(name, known) or names.nearest(name:match("[^.]+$") or name, known)
end

local fillers = { a = 1, an = 1, ["and"] = 1, by = 1, can = 1, ["do"] = 1, does = 1, ["for"] = 1, from = 1, how = 1, i = 1,
  ["in"] = 1, is = 1, it = 1, my = 1, ["not"] = 1, of = 1, on = 1, ["or"] = 1, the = 1, to = 1, what = 1, with = 1 }

-- Returns the best entries for the single words of a phrase, or nil if there are none.
local function explain_words(phrase)
  local texts, words = {}, search.words(phrase)
  for _, word in ipairs(#words > 1 and words or {}) do
    local found, sure = help.matches(word)
    if not fillers[word] and sure > 0 then texts[#texts + 1] = show.found(found, word, math.min(sure, 4)) end
  end
  return texts[1] and ("no help for %q; help for its words:\n\n%s"):format(phrase, table.concat(texts, "\n\n"))
end

-- Returns the entries of a name; else those that a search finds; else those of its words; else a similar name.
local function explain_name(name)
  local found = help.find(name)
  if #found == 0 then found = help.find(name:lower()) end
  if #found > 0 then
    local texts = {}
    for i, entry in ipairs(found) do texts[i] = show.entry(help, entry) end
    return table.concat(texts, "\n\n")
  end
  local sure
  found, sure = help.matches(name)
  if sure > 0 then return show.found(found, name, math.min(sure, 12)) end
  local near = nearest(spoken(name))
  local words = not near and explain_words(name)
  if words then return words end
  local search = #found > 0 and ("help.search %q finds parts of words"):format(name) or "help() lists the objects and topics"
  return ("no help for %q%s; %s"):format(name, near and (", did you mean %q?"):format(near) or "", search)
end

-- Returns the text that help(value) prints.
function help.text(...)
  load_entries()
  if select("#", ...) == 0 then return show.overview() end
  local value = ...
  if type(value) == "string" then return explain_name(value) end
  local address = help.address_of(value)
  if address and entries[address] then return show.entry(help, entries[address]) end
  if value == nil then return "no help for nil: is the name spelt as you meant it?" end
  return ("no help for this %s; help() lists all names"):format(type(value))
end

-- help.search(text): a list of the texts that contain it.
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

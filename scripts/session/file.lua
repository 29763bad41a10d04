-- session.save and session.open write all values of the session to one run file and read them again. The
-- values are complete states of runs, models, studies, and plain values. session/own.lua determines which
-- values belong to the session. Every value is a case of the file. The settings of the case contain the kind
-- of the value, its path (key.1, key.2, ... for a value such as runs[1].first) and the data to create the
-- value again.

local check = require "archard.lib.check"
local files = require "archard.files"
local joint_file = require "archard.joint.file"
local kept = require "archard.session.kept"
local lists = require "archard.settings"
local own = require "archard.session.own"
local settings = require "archard.definition.settings"
local spelling = require "archard.lib.spelling"
local store = require "archard.store"
local text_file = require "archard.lib.text_file"

local session = {}

-- Path of the file that this session was last saved to or opened from.
local last

-- --- from values to cases and back: writers[class](value, given, file, id) fills `given` ---------

local writers, readers = {}, {}

-- Saves a run in its case `id`, which the file already contains.
function writers.wear(value, _, file, id) joint_file.save(file, id, value) end

function readers.wear(_, file, id, functions) return joint_file.wear(file, id, functions) end

writers.joint_wear, readers.joint_wear = writers.wear, readers.wear

-- Returns the error message. If a function of the run `name` is missing, the message explains how to pass it.
local function cure(message, name)
  if not message:find("expected a function, as when the run was saved", 1, true) then return message end
  local field = message:match "^field '([%w_]+)'" or "k"
  return ("%s; give it as session.open(path, { %s = { %s = f } })"):format(message, spelling.field(name), field)
end

local function write_fields(value, given)
  for name, one in pairs(settings.flatten("session.save", { is = value })) do given[name] = one end
end

writers.model, writers.joint, writers.gait = write_fields, write_fields, write_fields

-- The model of a run is read with the run, because the settings of the model could result in a different
-- model.
function readers.model(given, _, _, _, values)
  if given.of then return values[math.tointeger(given.of)].model end
  return model(settings.nest(given).is)
end

function writers.material(value, given)
  for _, setting in ipairs(lists.material) do given["is." .. setting.name] = value[setting.name] end
end

function readers.material(given) return material(settings.nest(given).is) end

function readers.joint(given) return joint(settings.nest(given).is) end

function readers.gait(given) return require "archard.joint.given_gait".of(settings.nest(given).is) end

-- The cases of a study that has run are in the study's own file. For other studies this function stores the
-- cases.
function writers.study(value, given)
  given.file, given.name, given.looks, given.task = value.file, value.name, value.snapshots, value.task
  local carried = settings.carrier("session.save")
  for i, flat in ipairs(value.file and {} or value.flat) do
    given["count"] = i
    for name, one in pairs(carried(flat)) do given[("is.%d.%s"):format(i, name)] = one end
  end
end

function readers.study(given)
  if given.file then return study.open(given.file) end
  local nested, cases = settings.nest(given).is or {}, {}
  for i = 1, given.count do cases[i] = nested[i] or {} end
  return study{ name = given.name, snapshots = math.tointeger(given.looks), task = given.task, cases = cases }
end

local function write_plain(value, given) given.is = value end

local function read_plain(given) return given.is end

for _, class in ipairs{ "string", "boolean" } do
  writers[class], readers[class] = write_plain, read_plain
end

-- Run files contain doubles. Integers that a double cannot represent exactly are stored as text.
function writers.number(value, given)
  given.is, given.whole = value, math.type(value) == "integer"
  if given.whole and math.tointeger(value + 0.0) ~= value then given.is = tostring(value) end
end

function readers.number(given)
  return given.whole and math.tointeger(tonumber(given.is)) or tonumber(given.is)
end

function writers.list(value, given)
  given.is, given.whole = value, true
  for _, number in ipairs(value) do given.whole = given.whole and math.type(number) == "integer" end
end

function readers.list(given)
  local list = {}
  for i, number in ipairs(given.is) do list[i] = given.whole and math.tointeger(number) or number end
  return list
end

-- For a table, a result and a contact only the path is stored. Their parts are separate cases.
local function writer_of(class) return writers[class] or (kept.is_class(class) and writers.table) end
local function reader_of(class) return readers[class] or (kept.is_class(class) and readers.table) end

function writers.table() end

function readers.table() return {} end

-- --- paths ---------------------------------------------------------------------------------------

-- Returns true if a key is a name that can be printed.
local function is_global(key) return type(key) == "string" and not key:find "%c" and check.plain(key) == key end

-- Writes the keys of a path into `given`. Returns false if a key is neither a text nor a whole number,
-- because a file cannot contain such keys.
local function write_path(given, path)
  if not is_global(path[1]) then return false end
  for i, key in ipairs(path) do
    if type(key) ~= "string" and math.type(key) ~= "integer" then return false end
    given["key." .. i] = key
    given["whole." .. i] = math.type(key) == "integer"
  end
  return true
end

local function read_path(given)
  local path = {}
  while given["key." .. #path + 1] ~= nil do
    local i = #path + 1
    path[i] = given["whole." .. i] and math.tointeger(given["key." .. i]) or given["key." .. i]
  end
  return path
end

local function put(into, path, value)
  for i = 1, #path - 1 do into = rawget(into, path[i]) end
  rawset(into, path[#path], value)
end

-- --- saving --------------------------------------------------------------------------------------

-- Stores in the case of each model the number of the first case that is a run with this model.
local function note_owners(cases)
  for _, each in ipairs(cases) do
    for id, other in ipairs(each.class == "model" and cases or {}) do
      local has_it = not each.given.of and other.class == "wear" and other.value.model == each.value
      if has_it then each.given.of = id end
    end
  end
end

-- Returns the class of a value or, for a value that cannot be saved, the reason: "closed", or why a contact
-- cannot be created again.
local function reason(value, class)
  if (type(value) == "userdata" or class == "joint_wear") and tostring(value):find "%(closed%)$" then return "closed" end
  local kind, parts, why = kept.parts(value, class)
  return kind and not parts and ("%s %s"):format(class, why) or class
end

-- Returns the cases to write, in order: a table precedes its values, and an object with several names is
-- written once and then referred to by the number of its case. Also returns a list of the values that
-- cannot be saved, except functions in results.
local function gather()
  local cases, left, number = {}, {}, {}
  own.visit(function(path, value, class, owner)
    local given = { kind = class }
    local name, why = own.spoken(path), reason(value, class)
    local torn = type(value) == "string" and value:find("\0", 1, true)
    if not writer_of(class) or why ~= class or torn or not write_path(given, path) then
      if not owner then left[#left + 1] = ("%s (%s)"):format(name, why) end
      return false
    end
    local object = type(value) == "table" or type(value) == "userdata"
    if object and number[value] then given.kind, given.same = "same", number[value] end
    cases[#cases + 1] = { name = name, given = given, value = value, class = given.kind, owner = owner }
    if object then number[value] = number[value] or #cases end
    return given.kind ~= "same" and (class == "table" or kept.is_class(class))
  end)
  note_owners(cases)
  return cases, left
end

-- Calls a function of the store. An error is reported as an error of `where`, the user's call; the message
-- begins with `name`, the global.
local function as(where, name, f, ...)
  local results = table.pack(pcall(f, ...))
  if results[1] then return table.unpack(results, 2, results.n) end
  local message, code = check.reason(results[2])
  if not message then error(results[2], 0) end
  check.fail(where, name and ("%s: %s"):format(name, cure(message, name)) or message, code)
end

local function write_one(file, id, each)
  file:add(id, each.name:sub(1, 190))
  if each.class ~= "same" then writer_of(each.class)(each.value, each.given, file, id) end
  file:set_values(id, "settings", each.given)
  file:mark(id, "done")
end

local function write(file, cases)
  file:begin()
  file:set_info("program", "archard " .. require "archard".version)
  for id, each in ipairs(cases) do as("session.save", each.name, write_one, file, id, each) end
  file:commit()
end

local words = { wear = "run", joint_wear = "run", model = "model", joint = "model", study = "study", contact = "contact", joint_contact = "contact",
  result = "result" }
local order = { "run", "model", "study", "contact", "result" }

-- Returns a text such as "2 runs, 1 model, 3 other values". Parts of results are not counted.
local function summary(cases)
  local count, others, parts = {}, 0, {}
  for _, each in ipairs(cases) do
    local word = words[each.class] or kept.is_class(each.class) and "result"
    if word and not each.owner then
      count[word] = (count[word] or 0) + 1
    elseif not each.owner then
      others = others + 1
    end
  end
  for _, word in ipairs(order) do
    local n = count[word]
    local many = word == "study" and "studies" or word .. "s"
    if n then parts[#parts + 1] = ("%d %s"):format(n, n == 1 and word or many) end
  end
  if others > 0 then parts[#parts + 1] = ("%d other value%s"):format(others, others == 1 and "" or "s") end
  return parts[1] and table.concat(parts, ", ") or "nothing"
end

local function notes(cases, left)
  local lines = {}
  for _, each in ipairs(cases) do
    if words[each.class] == "run" and #each.value.functions > 0 then
      lines[#lines + 1] = ("  %s: pass its functions again to session.open (%s)"):format(each.name,
        table.concat(each.value.functions, ", "))
    elseif each.class == "study" and each.value.file then
      lines[#lines + 1] = ("  %s: the cases are stored in %s"):format(each.name, each.value.file)
    end
  end
  if left[1] then lines[#lines + 1] = "  not saved: " .. table.concat(left, ", ") end
  return #lines > 0 and "\n" .. table.concat(lines, "\n") or ""
end

local function check_path(where, path)
  if check.file.test(path) then return end
  check.fail(where, "expected the name of a file, got " .. check.shown(path))
end

-- session.save(path) saves the session and returns a text that lists the saved values. An earlier session in
-- this file is replaced; other files are refused. After an error the old file is unchanged.
function session.save(path)
  if path == nil then path = last end
  check_path("session.save", path)
  local cases, left = gather()
  as("session.save", nil, function()
    local file <close> = store.replace(path, "session")
    write(file, cases)
    file:publish()
  end)
  last = path
  for _, each in ipairs(cases) do
    if each.class == "wear" then store.note_saved(each.value) end
    if each.class == "joint_wear" then each.value.saved = each.value.update end
    if kept.is_class(each.class) then kept.note_saved(each.value) end
  end
  return ("saved in %s: %s%s"):format(path, summary(cases), notes(cases, left))
end

-- --- opening -------------------------------------------------------------------------------------

local openers = { wear = "wear.open", study = "study.open", joint = "joint.open" }

local function check_kind(file, path)
  local kind = tostring(file:info "kind")
  if kind ~= "session" then
    local opener = openers[kind] and ("; %s opens it"):format(openers[kind]) or ""
    check.fail("session.open", ("%s: expected a file of session.save, got a run file of kind %s%s"):format(
      path, kind, opener), "FORMAT")
  end
end

-- Returns the user's functions for the run `name` from a table of functions by run, such as { w = { k = f }
-- }.
local function functions_of(given, name)
  if given == nil then return nil end
  if type(given) ~= "table" then
    check.fail("session.open", "expected a table of runs' functions, { w = { k = f } }, got " .. check.shown(given))
  end
  return given[name]
end

-- Returns the description of a case of a file: number, settings, path, name and class. The value itself is
-- not created.
local function described(file, id)
  local given = file:values(id, "settings")
  local path = read_path(given)
  local name = is_global(path[1]) and own.spoken(path) or "?"
  return { id = id, given = given, path = path, name = name, class = given.kind }
end

-- Returns the descriptions of all cases in the order of creation: values that refer to another case, such as
-- the model of a run, are last.
local function in_order(file)
  local first, later = {}, {}
  for _, case in ipairs(file:cases()) do
    local each = described(file, case.id)
    local list = (each.given.of or each.given.same) and later or first
    list[#list + 1] = each
  end
  return table.move(later, 1, #later, #first + 1, first)
end

-- Functions by kind of value. Each returns true if the settings of a case have the types that this kind
-- needs.
local sound = {
  string = function(given) return type(given.is) == "string" end,
  boolean = function(given) return type(given.is) == "boolean" end,
  number = function(given) return tonumber(given.is) ~= nil end,
  list = function(given) return type(given.is) == "table" end,
  study = function(given) return given.file ~= nil or check.count.test(given.count) end,
}

local function is_sound(given)
  for name, key in pairs(given) do
    if name:find "^key%." and type(key) ~= "string" and not math.tointeger(key) then return false end
  end
  return (given.file == nil or type(given.file) == "string")
    and (not sound[given.kind] or sound[given.kind](given))
end

-- Raises ARC_FORMAT unless a stored case is a valid value of a session. The file is untrusted: a value must
-- have a known class and a name that archard does not use, and a value in a table must follow its table in
-- the file.
local function check_place(file, each, values, tables)
  local given, path = each.given, each.path
  local inside = table.move(path, 1, #path - 1, 1, {})
  local known = reader_of(given.kind) or values[math.tointeger(given.same)]
  local owner = given.of == nil or values[math.tointeger(given.of)] ~= nil
  if known and owner and is_sound(given) and each.name ~= "?" and not own.is_taken(path[1])
    and (#inside == 0 or tables[own.spoken(inside)]) then return end
  check.fail("session.open", ("%s: the file is damaged: case %d (%q) is not a valid value of a session"):format(file.path,
    each.id, each.name), "FORMAT")
end

-- Creates all values of a file; the globals of the session are not changed yet.
local function read(file, functions)
  local values, cases, missing, tables, owners = {}, {}, {}, {}, {} -- tables and owners are indexed by path
  for _, each in ipairs(in_order(file)) do
    local given = each.given
    check_place(file, each, values, tables)
    if given.same then
      each.value = values[math.tointeger(given.same)]
    elseif given.kind == "study" and given.file and not files.is_there(given.file) then
      missing[#missing + 1] = ("%s: file %s not found"):format(each.name, check.plain(given.file))
    else
      each.value = as("session.open", each.name, reader_of(given.kind), given, file, each.id,
        functions_of(functions, each.name), values)
    end
    values[each.id] = each.value
    local name, inside = own.spoken(each.path), own.spoken(table.move(each.path, 1, #each.path - 1, 1, {}))
    tables[name] = given.kind == "table" or kept.is_class(given.kind)
    each.owner = owners[inside]
    owners[name] = each.owner or kept.is_class(given.kind)
    if each.value ~= nil then cases[#cases + 1] = each end
  end
  return cases, missing
end

-- Returns the globals made from the cases of a file. It fills the tables and creates results and contacts
-- from their parts, the innermost first.
local function assemble(cases)
  local globals, made = {}, {}
  for _, each in ipairs(cases) do put(globals, each.path, each.value) end
  for i = #cases, 1, -1 do
    local each = cases[i]
    if kept.is_class(each.class) then
      made[each.value] = as("session.open", each.name, kept.made, each.class, each.value)
      kept.note_saved(made[each.value])
      put(globals, each.path, made[each.value])
    end
  end
  for _, each in ipairs(cases) do
    if each.class == "same" and made[each.value] then put(globals, each.path, made[each.value]) end
  end
  return globals
end

-- Raises an error if a global with unsaved values would be overwritten.
local function refuse_loss(cases)
  local new = {}
  for _, each in ipairs(cases) do new[each.path[1]] = true end
  for _, each in ipairs(own.unsaved()) do
    if new[each.path[1]] then
      local word, name = words[each.class] or words.result, each.path[1]
      check.fail("session.open", ("%s is a %s that has not been saved, and the file contains another %s: "
        .. "save it, or set %s = nil"):format(own.spoken(each.path), word, name, name))
    end
  end
end

-- session.open(path [, functions]) creates all values of a file as globals and returns a text that lists
-- them. After an error no global is created. The file contains no functions of runs: session.open(path, { w =
-- { k = f } }) sets them again.
function session.open(path, functions)
  check_path("session.open", path)
  local cases, missing = as("session.open", nil, function()
    local file <close> = store.open(path, "read")
    file:check()
    check_kind(file, path)
    return read(file, functions)
  end)
  refuse_loss(cases)
  for name, value in pairs(assemble(cases)) do _G[name] = value end
  last = path
  local text = { ("opened %s: %s"):format(path, summary(cases)) }
  for i, line in ipairs(missing) do text[i + 1] = "  left out: " .. line end
  return check.plain(table.concat(text, "\n"))
end

-- --- leaving -------------------------------------------------------------------------------------

-- Returns a file name to suggest: the last file of this session or, without one, the first of the names
-- session.archard, session-2.archard, ... that does not exist yet.
function session.suggested()
  if last then return last end
  for i = 1, math.huge do
    local name = i == 1 and "session.archard" or ("session-%d.archard"):format(i)
    if not text_file.exists(name) then return name end
  end
end

return session

-- Splits results and contacts into parts that a session can save, and creates them again. A result is a table
-- of plain values and of other saved objects. A contact is saved as the list of calls that created it.

local check = require "archard.lib.check"
local quiet = require "archard.lib.quiet"
local merged = require "archard.lib.merged"
local record = require "archard.contact_record"
local strict = require "archard.strict"

local debug, rawget, setmetatable, tostring, type = debug, rawget, setmetatable, tostring, type

local kept = {}

-- Modules that define the metatables of results, by class.
local modules = { calibration = "archard.study.calibrate", convergence = "archard.study.converge",
  failure = "archard.uncertainty.failure", fitted = "archard.fit.result", form = "archard.profile.form",
  fretting_map = "archard.study.fretting_map", map = "archard.map.made", profile = "archard.profile.made",
  sensitivity = "archard.uncertainty.sensitivity", uncertainty = "archard.uncertainty.result" }

-- --- results --------------------------------------------------------------------------------------

local function result_class(value)
  local metatable = type(value) == "table" and debug.getmetatable(value)
  local name = metatable and rawget(metatable, "__name")
  return modules[name] and strict.class_named(name) == metatable and name or nil
end

local function made_result(class, parts)
  require(modules[class])
  return setmetatable(parts, strict.class_named(class))
end

-- --- contacts -------------------------------------------------------------------------------------

-- Returns the definition of a contact{} call and of the moves after it, in the order of the calls.
local function calls_of(contact)
  local calls, one = {}, record(contact)
  while one do
    table.insert(calls, 1, one)
    one = one.from
  end
  return calls
end

local function contact_parts(contact)
  local calls = calls_of(contact)
  local first, moves = calls[1], {}
  local worn = first.given.worn
  if first.update and (tostring(worn):find "%(closed%)$" or worn.update ~= first.update) then
    return nil, ("on the surfaces of a run at update %d, and the run is now at another update"):format(first.update)
  end
  for _, shape in pairs(type(worn) == "table" and not result_class(worn) and worn or {}) do
    if type(shape) == "function" then return nil, "on surfaces given by functions" end
  end
  for i = 2, #calls do moves[i - 1] = calls[i].given end
  return { model = contact.model, given = merged(first.given, { model = false }), moves = moves }
end

local function made_contact(parts)
  local made = contact(merged(parts.given, { model = parts.model }))
  for _, move in ipairs(parts.moves) do made = made:move(move) end
  return made
end

-- Returns the arguments with which the contact of a joint is solved again. A contact of a joint has no moves.
local function joint_contact_parts(contact)
  return { model = contact.model, given = { load = contact.load, direction = contact.direction } }
end

-- --- both -----------------------------------------------------------------------------------------

-- kept.parts(value) returns the class and the table of parts of a result or contact. For a contact that
-- cannot be created again it returns class, nil and the reason; for other values nil.
function kept.parts(value, class)
  if class == "joint_contact" then return class, joint_contact_parts(value) end
  if class == "contact" and type(value) == "userdata" and not tostring(value):find "%(closed%)$" then
    return class, contact_parts(value)
  end
  class = result_class(value)
  return class, class and value
end

function kept.is_class(name) return name == "contact" or name == "joint_contact" or modules[name] ~= nil end

-- Creates an object of a class from its parts. A result is the table of parts itself, with its metatable.
function kept.made(class, parts)
  if class == "joint_contact" then return quiet(function() return parts.model:contact(parts.given) end) end
  if class ~= "contact" then return made_result(class, parts) end
  if type(parts.given) ~= "table" or type(parts.moves) ~= "table" then
    check.fail("contact", "expected the calls that created the contact", "FORMAT")
  end
  return quiet(made_contact, parts)
end

-- --- saved ----------------------------------------------------------------------------------------

local saved = setmetatable({}, { __mode = "k" })

function kept.note_saved(value) saved[value] = true end

-- Returns true if a file contains the object. A measured trace or map counts as saved in the file it was read
-- from.
function kept.is_saved(value) return saved[value] or (type(value) == "table" and rawget(value, "path") ~= nil) end

return kept

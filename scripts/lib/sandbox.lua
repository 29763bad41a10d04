-- archard --sandbox: removes functions with access to the system from the user's globals. Functions that
-- the program's own scripts need are restricted to allowed files.

local files = require "archard.files"

local load, loadfile = load, loadfile
local globals, open, remove = _G, io.open, os.remove

-- --- functions for the program's own scripts -----------------------------------------------------

function io.open(path, mode)
  local use = (mode or "r"):find "^r" and not (mode or ""):find("+", 1, true) and "read" or "write"
  local found, why = files.find(path, use)
  if not found then return nil, why end
  return open(found, mode)
end

function os.remove(path)
  local found, why = files.find(path, "write")
  if not found then return nil, why end
  return remove(found)
end

os.rename = nil

-- Prevents loading Lua files from the program's folder, since a script of the user could have written them.
function _ENV.loadfile() return nil, "the sandbox reads no examples" end

function io.popen() error("other programs cannot be started in the sandbox", 0) end
function os.execute() return nil, "other programs cannot be started in the sandbox" end

-- Temporary files are created in the working folder.
local count = 0
function os.tmpname()
  count = count + 1
  return (".archard-%d-%d"):format(os.time(), count)
end

-- --- functions for the user's scripts ------------------------------------------------------------

-- Loads a Lua file that the sandbox allows to be read. Errors contain the position of the caller.
local function read_chunk(path, ...)
  if type(path) ~= "string" then error("expected a file name, got " .. type(path), 3) end
  local found, why = files.find(path, "read")
  if not found then return nil, why end
  return loadfile(path, "t", ...)
end

-- Returns a require function for archard, the standard libraries and Lua files in the folder of the script.
local function requirer(folder)
  local loaded = { archard = require "archard" }
  for _, name in ipairs{ "string", "table", "math", "utf8", "coroutine", "os" } do loaded[name] = globals[name] end
  return function(name)
    if type(name) ~= "string" or not name:find "^[%w_][%w_.]*$" then error("expected a module name", 2) end
    if loaded[name] == nil then
      local path = ("%s/%s.lua"):format(folder, (name:gsub("%.", "/")))
      local chunk, why = read_chunk(path)
      if not chunk then error(why, 2) end
      local result = chunk(name, path)
      loaded[name] = result == nil and true or result
    end
    return loaded[name]
  end
end

-- Metatables made by the user. Other metatables are hidden, because the user could add a finalizer to them,
-- and Lua would not count the instructions of this finalizer.
local theirs = setmetatable({}, { __mode = "k" })

local function hide_metatables()
  local get = globals.getmetatable
  globals.getmetatable = function(value)
    local metatable = getmetatable(value)
    if metatable == nil or theirs[metatable] then return get(value) end
    return false
  end
end

-- Includes finalizers in the count of instructions. Lua calls no hook during a finalizer, so finalizers are
-- run in a coroutine, which has its own hooks. Each object with a finalizer has a guard object, which is
-- collected together with it. The finalizer of the guard runs the finalizer of the object.
local function count_finalizers()
  local set = globals.setmetatable
  local guards = setmetatable({}, { __mode = "k" })
  local guard = {}

  function guard.__gc(self)
    local metatable = getmetatable(self.object)
    local finalizer = type(metatable) == "table" and rawget(metatable, "__gc")
    guards[self.object] = nil
    if type(finalizer) ~= "function" then return end
    local fine, why = coroutine.resume(coroutine.create(finalizer), self.object)
    if not fine then error(why, 0) end
  end

  globals.setmetatable = function(value, metatable)
    if type(metatable) == "table" then theirs[metatable] = true end
    local finalizer = theirs[metatable] and rawget(metatable, "__gc")
    if finalizer == nil then return set(value, metatable) end
    rawset(metatable, "__gc", nil)
    local fine, why = pcall(set, value, metatable)
    rawset(metatable, "__gc", finalizer)
    if not fine then error(why, 2) end
    guards[value] = guards[value] or setmetatable({ object = value }, guard)
    return value
  end
end

return function(folder)
  local os = os
  globals.os = { time = os.time, clock = os.clock, date = os.date, difftime = os.difftime }
  for _, name in ipairs{ "io", "debug", "package", "examples" } do globals[name] = nil end
  require "archard".examples = nil
  globals.string.dump = nil
  globals.load = function(chunk, name, _, ...) return load(chunk, name, "t", ...) end
  globals.loadfile = function(path, _, ...) return read_chunk(path, ...) end
  globals.dofile = function(path)
    local chunk, why = read_chunk(path)
    if not chunk then error(why, 2) end
    return chunk()
  end
  globals.require = requirer(folder)
  hide_metatables()
  count_finalizers()
end

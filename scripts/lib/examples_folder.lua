-- Finds the folder of the examples, lists the examples, and loads the parts of large ones.

local check = require "archard.lib.check"
local itself = require "archard.lib.itself"
local process = require "archard.process"
local text_file = require "archard.lib.text_file"

local folder = {}

-- Paths of the examples folder for an installed program and for a program in the build folder, relative to
-- the program or to archard.so, the module for the stock interpreter.
local beside_program = { "/../share/archard/examples", "/../examples", "/../../examples" }
local beside_module = { "/../../../share/archard/examples", "/../../../../share/archard/examples", "/../../examples" }

local function search(path, candidates)
  local here = (path or ""):match("^(.*)/[^/]*$") or "."
  for _, candidate in ipairs(candidates) do
    if process.files(here .. candidate) then return here .. candidate end
  end
  return nil, here
end

function folder.find()
  local found, bin = search(process.program(), beside_program)
  local module = not found and itself.module()
  found = found or module and search(module, beside_module)
  return found or check.fail("examples", "no examples found in share/archard/examples beside " .. bin, "MISSING")
end

-- Returns the names of the example files in order, such as "01_contact".
function folder.names()
  local list = {}
  for _, file in ipairs(process.files(folder.find())) do
    list[#list + 1] = file:match("^([^.].*)%.lua$")
  end
  table.sort(list)
  return list
end

-- Returns the first sentence of the comment at the start of an example.
local function title(path)
  local head = {}
  for line in text_file.read(path):gmatch("[^\n]+") do
    if not line:find("^%-%-") then break end
    head[#head + 1] = line:gsub("^%-%-%s*", "")
  end
  local text = table.concat(head, " ")
  return text:match("^(.-[.])%s") or text
end

-- Returns a list of the examples in the form of help entries. The text of an entry is the example's first
-- sentence.
function folder.entries()
  local list = {}
  for i, name in ipairs(folder.names()) do
    list[i] = { kind = "example", name = name, address = ('examples "%s"'):format(name:gsub("^%d+_", "")),
      text = title(folder.find() .. "/" .. name .. ".lua") }
  end
  return list
end

-- Returns a function part(each), which returns the result of the file `each` in the folder `name` of the
-- examples. The first call loads the file. The file's argument is the same function, to load other parts.
function folder.parts(where, name)
  local loaded = {}
  local function part(each)
    if not loaded[each] then
      local chunk, why = loadfile(("%s/%s/%s.lua"):format(folder.find(), name, each), "t", _ENV)
      if not chunk then check.fail(where, why, "MISSING") end
      loaded[each] = chunk(part)
    end
    return loaded[each]
  end
  return part
end

return folder

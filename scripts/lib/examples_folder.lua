-- Where the examples are, and larger examples that the program itself uses. Leans on archard.process.

local check = require "archard.lib.check"
local itself = require "archard.lib.itself"
local process = require "archard.process"
local text_file = require "archard.lib.text_file"

local folder = {}

-- Where they are, seen from the program and from the module for the stock interpreter: as installed,
-- and as just built.
local beside_program = { "/../share/archard/examples", "/../examples", "/../../examples" }
local beside_module = { "/../../../share/archard/examples", "/../../../../share/archard/examples", "/../../examples" }

local function look(path, places)
  local here = (path or ""):match("^(.*)/[^/]*$") or "."
  for _, place in ipairs(places) do
    if process.files(here .. place) then return here .. place end
  end
  return nil, here
end

function folder.find()
  local found, bin = look(process.program(), beside_program)
  local module = not found and itself.module()
  found = found or module and look(module, beside_module)
  return found or check.fail("examples", "they are not there: looked in share/archard/examples beside " .. bin, "MISSING")
end

-- As the files are called, in the order of the course: "01_contact", ...
function folder.names()
  local list = {}
  for _, file in ipairs(process.files(folder.find())) do
    list[#list + 1] = file:match("^([^.].*)%.lua$")
  end
  table.sort(list)
  return list
end

-- The first sentence of the comment that an example begins with.
local function title(path)
  local head = {}
  for line in text_file.read(path):gmatch("[^\n]+") do
    if not line:find("^%-%-") then break end
    head[#head + 1] = line:gsub("^%-%-%s*", "")
  end
  local text = table.concat(head, " ")
  return text:match("^(.-[.])%s") or text
end

-- A list as help's entries are, each with the listed name and the first sentence.
function folder.entries()
  local list = {}
  for i, name in ipairs(folder.names()) do
    list[i] = { kind = "example", name = name, address = ('examples "%s"'):format(name:gsub("^%d+_", "")),
      text = title(folder.find() .. "/" .. name .. ".lua") }
  end
  return list
end

-- Reads the parts of a larger example: a function(name) -> what FOLDER/NAME.lua returns, which is called
-- with that function, to read others by.
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

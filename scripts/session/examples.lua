-- examples(): the course of programs that came with this one, to read and to run.

local check = require "archard.lib.check"
local folder = require "archard.lib.examples_folder".find
local pager = require "archard.lib.pager"
local process = require "archard.process"
local text_file = require "archard.lib.text_file"

local examples = {}

-- examples.names(): as the files are called, in the order of the course: "01_contact", ...
function examples.names()
  local list = {}
  for _, file in ipairs(process.files(folder())) do
    list[#list + 1] = file:match("^([^.].*)%.lua$")
  end
  table.sort(list)
  return list
end

-- Each goes by its number, by its name, or by both.
local function path_of(where, wanted)
  local plain = {}
  for i, name in ipairs(examples.names()) do
    local number, rest = name:match("^(%d+)_(.*)$")
    plain[i] = rest or name
    if wanted == name or wanted == rest or number and math.type(wanted) == "integer" and wanted == tonumber(number) then
      return folder() .. "/" .. name .. ".lua"
    end
  end
  check.fail(where, ("no example %s%s"):format(check.shown(wanted), check.hint(tostring(wanted), plain)))
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

-- The list of all, a line or more for each.
local function overview()
  local show = require "archard.help.show"
  local lines = {}
  for i, name in ipairs(examples.names()) do
    lines[i] = { name = name, text = title(folder() .. "/" .. name .. ".lua") }
  end
  return show.listing("Examples", lines)
    .. '\n\nexamples "wear" or examples(2) shows one, examples.run "wear" runs it'
end

-- examples.run(name, ...): as a script of that name with these arguments, whose globals stay.
function examples.run(name, ...)
  local path = path_of("examples.run", name)
  local before = rawget(_G, "arg")
  rawset(_G, "arg", { [0] = path, ... })
  local chunk <const> = assert(loadfile(path))
  local restored <close> = setmetatable({}, { __close = function() rawset(_G, "arg", before) end })
  chunk(...)
end

return setmetatable(examples, {
  __call = function(_, name)
    pager.show(name == nil and overview() or text_file.read(path_of("examples", name)))
  end,
  __tostring = function() return overview() end,
})

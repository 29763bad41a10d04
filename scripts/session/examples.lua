-- examples() lists and shows the example programs, examples.run runs one.

local check = require "archard.lib.check"
local examples_folder = require "archard.lib.examples_folder"
local pager = require "archard.lib.pager"
local text_file = require "archard.lib.text_file"

local examples = {}

-- examples.names() returns the names of the example files, such as "01_contact", in the order of their
-- numbers.
examples.names = examples_folder.names

-- Returns the path of an example, given by its number, its name, or number and name such as "01_contact".
local function path_of(where, wanted)
  local plain = {}
  for i, name in ipairs(examples.names()) do
    local number, rest = name:match("^(%d+)_(.*)$")
    plain[i] = rest or name
    if wanted == name or wanted == rest or number and math.type(wanted) == "integer" and wanted == tonumber(number) then
      return examples_folder.find() .. "/" .. name .. ".lua"
    end
  end
  local similar = {}
  for _, name in ipairs(plain) do
    if wanted ~= "" and name:find((tostring(wanted):lower():gsub("%s", "_")), 1, true) then similar[#similar + 1] = "'" .. name .. "'" end
  end
  local hint = check.hint(tostring(wanted), plain)
  if similar[1] and hint:find "known" then hint = (" (did you mean %s?)"):format(table.concat(similar, " or ")) end
  check.fail(where, ("no example %s%s"):format(check.shown(wanted), hint))
end

-- Returns a text that lists all examples with their descriptions.
local function overview()
  local show = require "archard.help.show"
  return show.listing("Examples", examples_folder.entries())
    .. '\n\nexamples "wear" or examples(2) shows an example, examples.run "wear" runs it'
end

-- examples.run(name, ...) runs the example with these arguments. The globals that it creates remain.
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

-- The question on leaving the prompt while runs, results or contacts are in no file. cli/repl.c asks it.

local own = require "archard.session.own"
local session = require "archard.session.file"

local leave = {}

-- Returns the question, or nil if nothing would be lost.
function leave.question()
  local unsaved = own.unsaved()
  if not unsaved[1] then return nil end
  local names = {}
  for i, each in ipairs(unsaved) do names[i] = own.spoken(each.path) end
  if #names > 6 then names = { names[1], names[2], names[3], ("... %d in all"):format(#names) } end
  return ("not saved: %s\nsave the session in %s before leaving? yes, no or stay: "):format(
    table.concat(names, ", "), session.suggested())
end

-- Returns the meaning of an answer: true to leave, false to stay, nil if it is neither.
function leave.answer(line)
  local letter = line:lower():match("^%s*(%a)")
  if letter == "n" then return true end
  if letter == "s" or letter == "c" then return false end
  if letter ~= "y" then return nil end
  print(session.save(session.suggested()))
  return true
end

return leave

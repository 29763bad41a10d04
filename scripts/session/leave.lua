-- Question at the end of the prompt, whether to save unsaved runs, results and contacts. cli/repl.c prints
-- the question and passes the answer to this module.

local own = require "archard.session.own"
local session = require "archard.session.file"

local leave = {}

-- Returns the text of the question, or nil if all values are saved.
function leave.question()
  local unsaved = own.unsaved()
  if not unsaved[1] then return nil end
  local names = {}
  for i, each in ipairs(unsaved) do names[i] = own.spoken(each.path) end
  if #names > 6 then names = { names[1], names[2], names[3], ("... %d in all"):format(#names) } end
  return ("not saved: %s\nsave the session in %s before leaving? yes, no or stay: "):format(
    table.concat(names, ", "), session.suggested())
end

-- Returns true if the answer means to end the program, false if it means to continue, and nil for an
-- unknown answer. The answer "yes" first saves the session.
function leave.answer(line)
  local letter = line:lower():match("^%s*(%a)")
  if letter == "n" then return true end
  if letter == "s" or letter == "c" then return false end
  if letter ~= "y" then return nil end
  print(session.save(session.suggested()))
  return true
end

return leave

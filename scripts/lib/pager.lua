-- Shows a text that is longer than the terminal page by page. The pager is the program in the environment
-- variable PAGER, or `less`, or, if neither is available, the functions of this file. A shorter text is
-- printed, and so is any text if there is no terminal.

local term = require "archard.term"

local pager = {}

local function count_lines(text)
  local _, breaks = text:gsub("\n", "")
  return breaks + 1
end

-- Returns the pager command, or nil if there is no pager. With these options, less shows colours, and its text
-- remains on the screen.
local function command()
  local wished = os.getenv "PAGER"
  if wished and wished ~= "" then return wished end
  return os.execute "command -v less >/dev/null 2>&1" and "less -R -X" or nil
end

-- Shows a text with a pager program and returns true on success. The text is passed in a temporary file:
-- with a pipe, an early end of the pager would cause a write error.
local function through(program, text)
  local name = os.tmpname()
  local file = io.open(name, "w")
  if not file then return false end
  file:write(text, "\n")
  file:close()
  local fine = os.execute(("%s < %s"):format(program, name))
  os.remove(name)
  return fine
end

-- Calls write(page) for each page of `lines` lines. Calls ask() before each further page, and stops if
-- ask() returns true.
function pager.pages(text, lines, write, ask)
  local page, count = {}, 0
  for line in (text .. "\n"):gmatch("(.-)\n") do
    if count == lines then
      write(table.concat(page, "\n"))
      if ask() then return end
      page, count = {}, 0
    end
    count = count + 1
    page[count] = line
  end
  write(table.concat(page, "\n"))
end

local function wait_for_key()
  io.write("-- Enter shows more, q ends -- ")
  io.flush()
  local answer = io.read()
  return answer == nil or answer:find("^%s*q") ~= nil
end

function pager.show(text)
  local _, lines = term.size()
  local terminal = term.is_terminal "stdin" and term.is_terminal "stdout"
  if not terminal or count_lines(text) < lines then return print(text) end
  io.flush()
  local program = command()
  if program and through(program, text) then return end
  pager.pages(text, math.max(2, lines - 1), print, wait_for_key)
end

return pager

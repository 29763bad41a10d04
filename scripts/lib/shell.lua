-- Programs of the system that are asked something: short commands through the shell. Leans on nothing.

local shell = {}

-- A word that the shell takes as it stands.
function shell.quote(word) return "'" .. tostring(word):gsub("'", "'\\''") .. "'" end

-- The words as one command line.
function shell.line(words)
  local quoted = {}
  for i, word in ipairs(words) do quoted[i] = shell.quote(word) end
  return table.concat(quoted, " ")
end

-- Runs a command line: what it printed, without an end of line, and whether it succeeded; where it
-- did not, its errors with the rest. The job that a line leaves behind holds nobody up.
function shell.ask(line)
  local split = 'exec 3>&1; words=$({ %s; } 2>&1 >&3 3>&-) || { status=$?; printf "%%s" "$words"; exit $status; }'
  local pipe <close> = assert(io.popen(split:format(line), "r"))
  local text = pipe:read("a"):gsub("%s+$", "")
  return text, pipe:close() == true
end

function shell.has(program)
  return select(2, shell.ask("command -v " .. shell.quote(program)))
end

return shell

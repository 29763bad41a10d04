-- Runs short commands through the shell and returns their output.

local shell = {}

-- Quotes a word for the shell.
function shell.quote(word) return "'" .. tostring(word):gsub("'", "'\\''") .. "'" end

-- Joins words to one command line.
function shell.line(words)
  local quoted = {}
  for i, word in ipairs(words) do quoted[i] = shell.quote(word) end
  return table.concat(quoted, " ")
end

-- Runs a command line. Returns its output without final line breaks, and true on success. After a failure,
-- the output includes standard error. The call does not wait for background jobs of the line.
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

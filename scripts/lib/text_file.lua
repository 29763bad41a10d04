-- Whether a file is there, and what it holds. Leans on nothing.

local text_file = {}

function text_file.exists(path)
  local file <close> = io.open(path, "r")
  return file ~= nil
end

-- All of it; nil where it cannot be opened.
function text_file.read(path)
  local file <close> = io.open(path, "rb")
  return file and file:read("a")
end

return text_file

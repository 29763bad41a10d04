-- Tests whether a file exists and reads it.

local text_file = {}

function text_file.exists(path)
  local file <close> = io.open(path, "r")
  return file ~= nil
end

-- Returns the whole content of a file, or nil if the file cannot be opened.
function text_file.read(path)
  local file <close> = io.open(path, "rb")
  return file and file:read("a")
end

return text_file

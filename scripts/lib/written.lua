-- Prints the names of files written by a call on standard error.

local written = {}

function written.note(where, ...)
  io.stderr:write(("archard: %s: wrote %s\n"):format(where, table.concat({ ... }, ", ")))
end

-- returned(where, file, ...) -> the files; prints the names unless the prompt shows the returned
-- values.
function written.returned(where, ...)
  if not package.loaded["archard.lib.prompt"] then written.note(where, ...) end
  return ...
end

return written

-- Prints the names of the files that a call has written, on standard error.

local written = {}

function written.note(where, ...)
  io.stderr:write(("archard: %s: wrote %s\n"):format(where, table.concat({ ... }, ", ")))
end

-- returned(where, file, ...) -> the files: for calls that return them, which the prompt shows.
function written.returned(where, ...)
  if not package.loaded["archard.lib.prompt"] then written.note(where, ...) end
  return ...
end

return written

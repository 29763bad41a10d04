-- Prints on standard error the names of the files that a call wrote.

local written = {}

function written.note(where, ...)
  io.stderr:write(("archard: %s: wrote %s\n"):format(where, table.concat({ ... }, ", ")))
end

-- Returns its arguments after `where`, which are the names of written files. Also prints them, except at
-- the prompt, which shows returned values itself.
function written.returned(where, ...)
  if not package.loaded["archard.lib.prompt"] then written.note(where, ...) end
  return ...
end

return written

-- Shows on standard error the progress of building a model. Returns a function(what, share, seconds), or
-- nil if standard error is not a terminal. what: name of the part that is being built; share: finished
-- share, 0 to 1; seconds: time since the start. A call without arguments clears the line.

local term = require "archard.term"

return function()
  if not term.movable("stderr") then return nil end
  local progress = require "archard.lib.progress"
  local drawn
  return function(what, share, seconds)
    if not what then
      if drawn then io.stderr:write("\r\27[K") end
      return
    end
    drawn = true
    io.stderr:write(("\rbuilding the %s %3.0f %% %s %.0f s\27[K"):format(what, 100 * share,
      progress.bar(share, 20), seconds))
  end
end

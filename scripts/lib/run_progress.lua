-- Shows the progress of a wear run up to the distance `goal` [mm] on standard error. Returns nil if
-- standard error is not a terminal, else a function to be called with the run after each step, with the run and
-- true during a long step, and without arguments at the end.

local term = require "archard.term"

return function(run, goal)
  if not term.movable("stderr") then return nil end
  local progress = require "archard.lib.progress"
  local bar = progress.new{ total = goal, done = run.distance, label = "wear", unit = "mm" }
  local began = term.clock()
  return function(now, in_step)
    if not now then return bar:close() end
    if in_step then
      return bar:update(now.distance, ("update %d for %s"):format(now.update + 1, progress.duration(term.clock() - began)))
    end
    began = term.clock()
    bar:update(now.distance, ("cycle %.6g"):format(now.cycle))
  end
end

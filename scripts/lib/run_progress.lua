-- Shows the progress of a wear run up to the distance `goal` [mm] on standard error. Returns nil if
-- standard error is not a terminal, else a function to be called with the run after each step, and without
-- arguments at the end.

local term = require "archard.term"

return function(run, goal)
  if not term.movable("stderr") then return nil end
  local progress = require "archard.lib.progress"
  local bar = progress.new{ total = goal, done = run.distance, label = "wear", unit = "mm" }
  return function(now)
    if not now then return bar:close() end
    bar:update(now.distance, ("cycle %.6g"):format(now.cycle))
  end
end

-- fit: values of wear{} and model{} from what was measured, by weighted nonlinear least squares, and
-- how sure they are. Only names what users see; the work begins in fit/run.lua and is in fit/unknown.lua,
-- fit/data.lua, fit/runs.lua, fit/problem.lua, fit/solve.lua, fit/result.lua and, for tests still to be
-- made, fit/design.lua.

local later = require "archard.lib.later"

local run = later("archard.fit.run", "run")

-- best: of the last search, the best values so far.
return setmetatable({ design = later("archard.fit.run", "design"), best = {} },
  { __call = function(_, given) return run(given) end })

-- Lua function fit: determines fields of wear{} and model{}, with their standard errors, from measurements by
-- weighted nonlinear least squares. This module only lists the public functions; fit/run.lua runs a fit.

local lazy = require "archard.lib.lazy"

local run = lazy("archard.fit.run", "run")

-- The field fit.best contains the best values of the latest search.
return setmetatable({ design = lazy("archard.fit.run", "design"), best = {} },
  { __call = function(_, given) return run(given) end })

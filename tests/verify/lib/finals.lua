-- Returns the final values of the reference paper's cases from an independent solution of the same problem.
-- examples/paper/ uses the same values.
local here = arg[0]:match("^(.*)/") or "."
return dofile(here .. "/../../examples/paper/independent.lua").finals

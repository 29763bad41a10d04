-- Final values of the paper's cases from an independent solution of the same problem, as used by
-- the page of figures.
local here = arg[0]:match("^(.*)/") or "."
return dofile(here .. "/../../examples/paper/independent.lua").finals

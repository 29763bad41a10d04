-- The final values of the paper's cases from an independent solution of the same problem: the rows
-- that the page of figures compares with.
local here = arg[0]:match("^(.*)/") or "."
return dofile(here .. "/../../examples/paper/independent.lua").finals

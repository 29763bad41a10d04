-- The table export: files for other programs. The writers stand in archard.files; a series of
-- files and the summary of a run are made of these here.

local files = require "archard.files"
local later = require "archard.lib.later"

return {
  csv = files.csv,
  vtk = files.vtk,
  inp = files.inp,
  msh = files.msh,
  pvd = later "archard.export.series",
  json = later "archard.export.summary",
}

-- The table export: files for other programs. The writers stand in archard.files; a series of
-- files, the summary of a run and files of maps are made of these here.

local files = require "archard.files"
local later = require "archard.lib.later"

return {
  csv = later("archard.export.maps", "csv"),
  vti = later("archard.export.maps", "vti"),
  gsf = later("archard.export.maps", "gsf"),
  vtk = files.vtk,
  inp = files.inp,
  msh = files.msh,
  pvd = later "archard.export.series",
  json = later "archard.export.summary",
}

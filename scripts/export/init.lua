-- The table export: files for other programs. The writers stand in archard.files; a series of
-- files, the summary of a run and files of maps are made of these here.

local files = require "archard.files"
local later = require "archard.lib.later"
local written = require "archard.lib.written"

local function noted(where, write)
  return function(...) return written.returned(where, write(...)) end
end

return {
  csv = later("archard.export.maps", "csv"),
  vti = later("archard.export.maps", "vti"),
  gsf = later("archard.export.maps", "gsf"),
  vtk = noted("export.vtk", files.vtk),
  inp = noted("export.inp", files.inp),
  msh = noted("export.msh", files.msh),
  pvd = later "archard.export.series",
  json = later "archard.export.summary",
}

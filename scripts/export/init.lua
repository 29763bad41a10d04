-- The table export: files for other programs. Single files are written by archard.files; series of
-- files, run summaries and files of maps by the modules in this folder.

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

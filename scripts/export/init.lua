-- The table export: files for other programs. Single files are written by archard.files; series of
-- files, run summaries and files of maps by the modules in this folder.

local files = require "archard.files"
local lazy = require "archard.lib.lazy"
local written = require "archard.lib.written"

local function noted(where, write)
  return function(...) return written.returned(where, write(...)) end
end

return {
  csv = lazy("archard.export.maps", "csv"),
  vti = lazy("archard.export.maps", "vti"),
  gsf = lazy("archard.export.maps", "gsf"),
  vtk = noted("export.vtk", lazy("archard.export.sphere", "vtk")),
  inp = noted("export.inp", files.inp),
  msh = noted("export.msh", files.msh),
  pvd = lazy "archard.export.series",
  json = lazy "archard.export.summary",
}

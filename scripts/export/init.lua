-- Defines the table `export`, whose functions write files for other programs. The module archard.files writes
-- single files; the modules in this folder write series of files, summaries of runs, and maps.

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

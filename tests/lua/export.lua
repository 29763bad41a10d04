-- Tests export and mesh:write: formats, file names, failures.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

local folder = os.tmpname()
os.remove(folder)
ok(os.execute("mkdir " .. folder), "the temporary folder is created")
local function at(name) return folder .. "/" .. name end

local function read(name)
  local file = assert(io.open(at(name)))
  local text = file:read("a")
  file:close()
  return text
end

-- Returns the columns of a CSV file by their names without units, the list of these names, and the header
-- line.
local function read_csv(name)
  local names, columns, headers = {}, {}, read(name):match("[^\n]*")
  for line in read(name):gmatch("[^\n]+") do
    local column = 0
    for cell in line:gmatch("[^,]+") do
      column = column + 1
      local of = columns[names[column]]
      if of then of[#of + 1] = tonumber(cell) or 0 / 0 else names[column] = cell:gsub(" %[.*", "") end
    end
    if not columns[names[1]] then for _, n in ipairs(names) do columns[n] = {} end end
  end
  return columns, names, headers
end

-- Tests exported CSV files: columns, units and file names.
local w = wear{ increments = 20 }
w:step(3)
is(export.csv(w, at "history.csv"), at "history.csv", "export.csv returns the file name")
local columns, names, headers = read_csv "history.csv"
holds(headers, { "cycle,distance [mm],", ",p_center [MPa],", ",volume_plate [mm3],", ",depth_partition," },
  "history: the header has names and units")
is(#names, #require "archard.settings".columns, "history: all columns")
is(#columns.distance, 4, "history: all rows")
local same = true
for name, values in pairs(w.history) do
  for i, value in ipairs(values) do
    local got = columns[name][i]
    same = same and (got == value or got ~= got and value ~= value)
  end
end
ok(same, "history: the values are identical to the bit")

local c = w:contact()
export.csv({ x = { 1.5, 2 }, y = { 1e-9, 3 } }, at "comma.csv", { x = "mm", decimal = "," })
do
  local text = io.open(at "comma.csv"):read "a"
  is(text, "x [mm];y\n1,5;1e-09\n2;3\n", "decimal commas and semicolons")
  is(csv.read(at "comma.csv").x[1], 1.5, "which csv.read reads")
  fails(function() export.csv(w, at "comma.csv", { separator = ";" }) end, "unknown field 'separator' (known: decimal)", "an unknown option")
  fails(function() export.csv(w, at "comma.csv", { decimal = ";" }) end, 'field \'decimal\': expected "." or ","', "another decimal sign")
end
export.csv(c, at "pressure.csv")
columns = read_csv "pressure.csv"
is(select(3, read_csv "pressure.csv"), "x_cylinder [mm],p_cylinder [MPa],x_plate [mm],p_plate [MPa]",
  "the header of a pressure file has units")
is(columns.p_cylinder[26], c:pressure("cylinder").p[26], "pressures of the cylinder")
is(#columns.p_plate, #c:pressure("plate").p, "pressures of the plate")
export.csv(w:profile("plate"), at "profile.csv")
columns, names = read_csv "profile.csv"
is(table.concat(names, ","), "x,y,h,way,worn_x", "a table without units: x is the first column")
is(columns.h[31], w:profile("plate").h[31], "values of the exported profile")
export.csv(w:profile("plate"), at "profile.csv", { x = "mm", h = "mm" })
is(select(3, read_csv "profile.csv"), "x [mm],y [mm],h [mm],way [mm],worn_x [mm]",
  "a table with units for all columns of a profile")
export.csv(w:pressure("plate"), at "pressure.txt", { p = "N/mm2" })
is(select(3, read_csv "pressure.txt"), "x [mm],p [N/mm2]", "the unit given by the user is written")
export.csv(w.history, at "columns")
holds(select(3, read_csv "columns"), { "distance [mm],", "p_center [MPa]" },
  "the history as a table; the file name has no extension")
export.csv({ x = { 1 } }, at "plain.csv")
is(read "plain.csv", "x\n1\n", "a table with one column")
for _, ending in ipairs{ "json", "vtu", "png", "pvd" } do
  fails(function() export.csv(w, at("w." .. ending)) end, { "field 'path': expected a file name with the extension .csv", "w." .. ending },
    "export.csv refuses the extension ." .. ending)
  ok(not io.open(at("w." .. ending)), "no file is written for a wrong extension")
end
fails(function() export.csv({ x = { 1 } }, at "a.csv", { y = "mm" }) end, { "the unit of a column", "'y' = \"mm\"" },
  "a unit for a column that does not exist")
fails(function() export.csv({ x = { 1 } }, at "a.csv", "mm") end, "expected units by name",
  "a unit without a column name")
fails(function() export.csv({}, at "a.csv") end, "export.csv: the table is empty", "an empty table")
fails(function() export.csv({ 1, 2 }, at "a.csv") end, { "arrays by name", "found [1]" },
  "a list of numbers without a name")
fails(function() export.csv({ x = { 1 }, y = { 1, 2 } }, at "a.csv") end,
  "1 numbers in 'x' and 2 in 'y'", "columns of different length")
fails(function() export.csv({ x = { "a" } }, at "a.csv") end, "field 'x[1]': expected a number",
  "a text in a column of numbers")
fails(function() export.csv(hertz{}, at "a.csv") end, "expected a wear or contact object",
  "export.csv of a hertz object")
fails(function() export.csv(w) end, "field 'path': expected a file name, got nil",
  "export.csv without a file name")
local err = fails(function() export.csv(w, at "no/such/folder.csv") end, { "cannot write", "No such file" },
  "a file in a missing folder")
is(err.code, "IO", "error code of a failed write")

-- Tests exported VTK files.
local files = { export.vtk(c, at "stress.vtk") }
is(files[1], at "stress-cylinder.vtk", "a VTK file for the cylinder")
is(files[2], at "stress-plate.vtk", "a VTK file for the plate")
local text = read "stress-plate.vtk"
holds(text, { "# vtk DataFile", "POINTS " .. w.model.mesh.plate.nodes, "CELLS", "POINT_DATA", "mises" },
  "a VTK file contains the mesh and the stresses")
-- a stress object is exported like its contact
export.vtk(c:stress(), at "field.vtk")
is(read "field-plate.vtk", text, "a stress object gives the same VTK file")
files = { export.csv(c:stress(), at "field.csv") }
is(files[1], at "field-cylinder.csv", "a stress object in CSV gives a file for each body")
local columns, _, headers = read_csv "field-plate.csv"
is(headers:match("^[^,]*,[^,]*,[^,]*"), "x [mm],y [mm],ux [mm]", "the header of a stress file has units")
is(#columns.mises, w.model.mesh.plate.nodes, "a stress file has a row for each node")
is(columns.mises[7], c:stress().plate.mises[7], "stresses in CSV are identical to the bit")
export.vtk(w.model, at "mesh")
ok(not read("mesh-plate.vtk"):find("mises"), "a model in VTK has no stresses; the extension is added")
is(export.vtk(w.model.mesh.plate, at "plate.vtk"), at "plate.vtk", "a mesh is exported to one VTK file")
holds(read "plate.vtk", "POINTS " .. w.model.mesh.plate.nodes, "the VTK file contains all nodes of the mesh")
is(#{ export.vtk(w, at "run.vtk") }, 2, "a run gives two VTK files")
is(read "run-plate.vtk", text, "a run gives the VTK files of its contact")
fails(function() export.vtk(hertz{}, at "w.vtk") end, "expected a run, a contact, its stress, a model or a mesh",
  "export.vtk of a hertz object")
fails(function() export.vtk(c, at "c.stl") end, { "field 'path': expected a file name that ends in .vtk (legacy) or .vtu",
  "c.stl" }, "export.vtk with another extension")

local mesh = w.model.mesh.cylinder
mesh:write(at "cylinder.inp")
text = read "cylinder.inp"
holds(text, { "*NODE, NSET=cylinder", "TYPE=CPE4" }, "the deck of a single mesh")
ok(not text:find("plate"), "the deck of one body does not contain the other body")
mesh:write(at "cylinder.vtk")
holds(read "cylinder.vtk", "CELLS " .. mesh.elements_count, "a mesh as a VTK file")
mesh:write(at "cylinder.csv")
columns, _, headers = read_csv "cylinder.csv"
is(headers, "node,x [mm],y [mm]", "the header of a mesh file has units")
is(#columns.node, mesh.nodes, "a mesh file has a row for each node")
local x, y = mesh:node(7)
ok(columns.x[7] == x and columns.y[7] == y, "coordinates of a node in a mesh file")
fails(function() mesh:write(at "mesh.stl") end, "ends in .vtk, .vtu, .inp, .msh or .csv",
  "a mesh file with another extension")
fails(function() mesh:write() end, "expected a file name", "a mesh file without a name")

-- Tests decks for CalculiX (tests/verify/calculix.lua runs CalculiX with them).
is(export.inp(w.model, at "model"), at "model.inp", "the extension .inp is added to the name of a deck")
local deck = read "model.inp"
holds(deck, { "*NODE, NSET=cylinder", "*ELEMENT, TYPE=C3D8, ELSET=plate", "TYPE=C3D6", "*ELASTIC\n200000, 0.3",
  "*CONTACT PAIR", "*CLOAD\nbase, 2, 100\n", "*CONTACT FILE" }, "the deck of a model has the default load")
export.inp(contact{ model = w.model }, at "unworn.inp")
is(read "unworn.inp", deck, "the deck of a model is the deck of its contact")
export.inp(w, at "run.inp")
export.inp(c, at "c.inp")
is(read "run.inp", read "c.inp", "the deck of a run is the deck of its contact")
export.inp(c:stress(), at "stress.inp")
is(read "stress.inp", read "c.inp", "the deck of a stress object is the deck of its contact")
ok(read "run.inp" ~= deck, "the deck of a run contains the worn surfaces")
local soft = model{ plate = { E = 1000, nu = 0.48 }, mesh = { size = 0.04, height = 0.05 } }
export.inp(contact{ model = soft, load = 1 }, at "soft.inp")
holds(read "soft.inp", { "TYPE=C3D8, ELSET=cylinder", "TYPE=C3D8I, ELSET=plate" },
  "each body has its own element type in the deck")
fails(function() export.inp(hertz{}, at "h.inp") end, "export.inp: expected a run, a contact or a model",
  "export.inp of a hertz object")
fails(function() export.inp(c, at "c.dat") end, "ends in .inp", "export.inp with another extension")

-- Tests exported time series of VTK files (tests/cli/test_vtk reads the files).
ok(not pcall(export.pvd, w, at "se\233ries.pvd"), "a file name that XML cannot contain")
local add = export.pvd(w, at "series.pvd")
add()
local _, states = read "series.pvd":gsub("<DataSet", "")
is(states, 2, "the first call writes the present state of both bodies")
w:step()
add(w)
_, states = read "series.pvd":gsub("<DataSet", "")
is(states, 4, "the second call adds a state")
holds(read "series.pvd", { 'file="series-00001-plate.vtu"', 'timestep="' .. require "archard.files".number(w.distance) },
  "the series lists the files and distances")
holds(read "series-00001-plate.vtu", { 'Name="wear_depth"', 'Name="pressure"', 'Name="mises"', 'Name="displacement"' },
  "a file of the series contains all arrays")
local said, usual = {}, io.stderr
io.stderr = { write = function(_, ...) said[#said + 1] = table.concat{ ... } end }
export.pvd(w, at "last.pvd")
io.stderr = usual
holds(table.concat(said), { "last.pvd with one state at ", "as progress of w:run" },
  "the number of written states is reported")
fails(function() export.pvd(c, at "c.pvd") end, "export.pvd: expected a wear object",
  "export.pvd of a contact")
fails(function() export.pvd(w, at "c.vtu") end, "ends in .pvd", "export.pvd with another extension")
fails(function() export.pvd(w, at "c.pvd", { every = 0 }) end, "field 'every': expected a whole number >= 1",
  "export.pvd with every = 0")
fails(function() export.pvd(w, at "c.pvd", { each = 2 }) end, "unknown field 'each'",
  "export.pvd with an unknown field")
ok(not io.open(at "c.pvd"), "no file is written after a refusal")
fails(function() export.pvd(w, at "no/c.pvd") end, "export.pvd: cannot write",
  "export.pvd to a missing folder")

-- Tests exported JSON summaries of runs.
w = wear{ model = w.model, increments = 20 }
w:step(3)
is(export.json(w, at "w"), at "w.json", "the extension .json is added to the file name")
local summary = read "w.json"
holds(summary, { '"archard": "' .. require "archard".version .. '"', '"stroke": 0.11', '"definition.load": "N"', '"update": 3,',
  '"definition.model.radius": "mm"', '"depth_plate": ' .. require "archard.files".number(w.depth.plate) },
    "the summary contains settings, units and results")
local fresh = wear{ model = w.model, k = function() return 1e-8 end }
export.json(fresh, at "fresh.json")
holds(read "fresh.json", { '"depth_partition": null', '"k": "function"' },
  "NaN becomes null, a function its type")
holds(read "fresh.json", '"k": null,', "the coefficient of a body without one is null instead of 0")
holds(summary, { '"lower": null', '"upper": "cylinder"' }, "the default pair in the summary")
export.json(wear{ load = 100, model = { mesh = { size = 0.2, height = 0.2 }, upper = body.punch{ flat = 1, radius = 2, height = 10, name = "foot" },
  lower = body.block{ k = 2e-8, layers = { { thickness = 0.4, material = material{ E = 4e5, k = 1e-9 } } } } } }, at "own.json")
holds(read "own.json", { '"upper": "foot"', '"lower": "block"', '"cylinder": null', '"plate": null', '"kind": "punch"', '"flat": 1,',
  '"name": "foot"', '"k": 2e-08', '"thickness": 0.4', '"E": 400000', '"k": 1e-09', '"definition.model.upper.flat": "mm"',
  '"definition.model.lower.layers.k": "mm2/N"' }, "user-defined bodies in the summary")
fails(function() export.json(c, at "c.json") end, "export.json: expected a wear object",
  "export.json of a contact")
fails(function() export.json(w, at "w.txt") end, "ends in .json", "export.json with another extension")
fails(function() export.json(w) end, "field 'path': expected a file name, got nil",
  "export.json without a file name")
if os.execute("command -v sqlite3 >/dev/null") then
  local pipe = io.popen("sqlite3 :memory: \"select json_valid(readfile('" .. at "w.json" .. "')), json_valid(readfile('"
    .. at "fresh.json" .. "'))\"")
  is(pipe:read("a"), "1|1\n", "sqlite3 accepts both summaries as valid JSON")
  pipe:close()
else
  tap.note("skipped without sqlite3: validity of the JSON files")
end
local json = require "archard.export.json"
is(json.encode{ 1, 0 / 0, { a = 'x"\n\1\xFF' } }, '[1, null, {\n  "a": "x\\"\\n\\u0001\xC3\xBF"\n}]\n',
  "NaN, control characters and invalid UTF-8 in JSON")

os.execute("rm -r " .. folder)

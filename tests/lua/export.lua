-- Tests export and mesh:write: formats, file names, failures.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

local folder = os.tmpname()
os.remove(folder)
ok(os.execute("mkdir " .. folder), "a folder to write to")
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
is(export.csv(w, at "history.csv"), at "history.csv", "returns the name of the file")
local columns, names, headers = read_csv "history.csv"
holds(headers, { "cycle,distance [mm],", ",p_center [MPa],", ",volume_plate [mm3],", ",depth_partition," },
  "history: units behind the names")
is(#names, #require "archard.settings".columns, "history: all columns")
is(#columns.distance, 4, "history: all rows")
local same = true
for name, values in pairs(w.history) do
  for i, value in ipairs(values) do
    local got = columns[name][i]
    same = same and (got == value or got ~= got and value ~= value)
  end
end
ok(same, "history: the same bits")

local c = w:contact()
export.csv(c, at "pressure.csv")
columns = read_csv "pressure.csv"
is(select(3, read_csv "pressure.csv"), "x_cylinder [mm],p_cylinder [MPa],x_plate [mm],p_plate [MPa]",
  "pressures have units")
is(columns.p_cylinder[26], c:pressure("cylinder").p[26], "pressures of the cylinder")
is(#columns.p_plate, #c:pressure("plate").p, "pressures of the plate")
export.csv(w:profile("plate"), at "profile.csv")
columns, names = read_csv "profile.csv"
is(table.concat(names, ","), "x,y,h,way,worn_x", "a plain table: x first")
is(columns.h[31], w:profile("plate").h[31], "its numbers")
export.csv(w:profile("plate"), at "profile.csv", { x = "mm", h = "mm" })
is(select(3, read_csv "profile.csv"), "x [mm],y [mm],h [mm],way [mm],worn_x [mm]", "columns of a profile")
export.csv(w:pressure("plate"), at "pressure.txt", { p = "N/mm2" })
is(select(3, read_csv "pressure.txt"), "x [mm],p [N/mm2]", "unless another is given")
export.csv(w.history, at "columns")
holds(select(3, read_csv "columns"), { "distance [mm],", "p_center [MPa]" }, "a history as a table; no ending")
export.csv({ x = { 1 } }, at "plain.csv")
is(read "plain.csv", "x\n1\n", "a table with the given columns only")
for _, ending in ipairs{ "json", "vtu", "png", "pvd" } do
  fails(function() export.csv(w, at("w." .. ending)) end, { "field 'path': expected a file name with the extension .csv", "w." .. ending },
    "not as ." .. ending)
  ok(not io.open(at("w." .. ending)), "nothing is written")
end
fails(function() export.csv({ x = { 1 } }, at "a.csv", { y = "mm" }) end, { "the unit of a column", "'y' = \"mm\"" },
  "a unit of nothing")
fails(function() export.csv({ x = { 1 } }, at "a.csv", "mm") end, "expected units by name", "a unit without a name")
fails(function() export.csv({}, at "a.csv") end, "export.csv: the table is empty", "empty table")
fails(function() export.csv({ 1, 2 }, at "a.csv") end, { "arrays by name", "found [1]" }, "a list")
fails(function() export.csv({ x = { 1 }, y = { 1, 2 } }, at "a.csv") end,
  "1 numbers in 'x' and 2 in 'y'", "lengths differ")
fails(function() export.csv({ x = { "a" } }, at "a.csv") end, "field 'x[1]': expected a number",
  "text in an array")
fails(function() export.csv(hertz{}, at "a.csv") end, "expected a wear or contact object", "hertz")
fails(function() export.csv(w) end, "field 'path': expected a file name, got nil", "no path")
local err = fails(function() export.csv(w, at "no/such/folder.csv") end, { "cannot write", "No such file" },
  "a folder that is not there")
is(err.code, "IO", "its code")

-- Tests exported VTK files.
local files = { export.vtk(c, at "stress.vtk") }
is(files[1], at "stress-cylinder.vtk", "a file for the cylinder")
is(files[2], at "stress-plate.vtk", "a file for the plate")
local text = read "stress-plate.vtk"
holds(text, { "# vtk DataFile", "POINTS " .. w.model.mesh.plate.nodes, "CELLS", "POINT_DATA", "mises" },
  "stresses in VTK")
-- a stress object is exported like its contact
export.vtk(c:stress(), at "field.vtk")
is(read "field-plate.vtk", text, "a stress in VTK, the same file")
files = { export.csv(c:stress(), at "field.csv") }
is(files[1], at "field-cylinder.csv", "a stress in CSV: a file a body")
local columns, _, headers = read_csv "field-plate.csv"
is(headers:match("^[^,]*,[^,]*,[^,]*"), "x [mm],y [mm],ux [mm]", "with units")
is(#columns.mises, w.model.mesh.plate.nodes, "node by node")
is(columns.mises[7], c:stress().plate.mises[7], "the same bits")
export.vtk(w.model, at "mesh")
ok(not read("mesh-plate.vtk"):find("mises"), "a model in VTK has no stresses; the ending is added")
is(export.vtk(w.model.mesh.plate, at "plate.vtk"), at "plate.vtk", "a mesh is one file")
holds(read "plate.vtk", "POINTS " .. w.model.mesh.plate.nodes, "with its nodes")
is(#{ export.vtk(w, at "run.vtk") }, 2, "a run: two files")
is(read "run-plate.vtk", text, "the files of a run are those of its contact")
fails(function() export.vtk(hertz{}, at "w.vtk") end, "expected a run, a contact, its stress, a model or a mesh",
  "anything else")
fails(function() export.vtk(c, at "c.stl") end, { "field 'path': expected a file name that ends in .vtk (legacy) or .vtu",
  "c.stl" }, "another ending")

local mesh = w.model.mesh.cylinder
mesh:write(at "cylinder.inp")
text = read "cylinder.inp"
holds(text, { "*NODE, NSET=cylinder", "TYPE=CPE4" }, "a deck of one mesh")
ok(not text:find("plate"), "has nothing of the other")
mesh:write(at "cylinder.vtk")
holds(read "cylinder.vtk", "CELLS " .. mesh.elements_count, "a mesh as VTK")
mesh:write(at "cylinder.csv")
columns, _, headers = read_csv "cylinder.csv"
is(headers, "node,x [mm],y [mm]", "a mesh has units")
is(#columns.node, mesh.nodes, "a mesh as CSV")
local x, y = mesh:node(7)
ok(columns.x[7] == x and columns.y[7] == y, "node by node")
fails(function() mesh:write(at "mesh.stl") end, "ends in .vtk, .vtu, .inp, .msh or .csv", "another ending")
fails(function() mesh:write() end, "expected a file name", "no name")

-- Tests decks for CalculiX (tests/verify/calculix.lua runs CalculiX with them).
is(export.inp(w.model, at "model"), at "model.inp", "a deck, the ending is added")
local deck = read "model.inp"
holds(deck, { "*NODE, NSET=cylinder", "*ELEMENT, TYPE=C3D8, ELSET=plate", "TYPE=C3D6", "*ELASTIC\n200000, 0.3",
  "*CONTACT PAIR", "*CLOAD\nbase, 2, 100\n", "*CONTACT FILE" }, "of a model at the usual load")
export.inp(contact{ model = w.model }, at "unworn.inp")
is(read "unworn.inp", deck, "the deck of a model is that of its contact")
export.inp(w, at "run.inp")
export.inp(c, at "c.inp")
is(read "run.inp", read "c.inp", "a run is its contact")
export.inp(c:stress(), at "stress.inp")
is(read "stress.inp", read "c.inp", "the deck of a stress is that of its contact")
ok(read "run.inp" ~= deck, "worn")
local soft = model{ plate = { E = 1000, nu = 0.48 }, mesh = { size = 0.04, height = 0.05 } }
export.inp(contact{ model = soft, load = 1 }, at "soft.inp")
holds(read "soft.inp", { "TYPE=C3D8, ELSET=cylinder", "TYPE=C3D8I, ELSET=plate" }, "elements as each body has them")
fails(function() export.inp(hertz{}, at "h.inp") end, "export.inp: expected a run, a contact or a model", "of others")
fails(function() export.inp(c, at "c.dat") end, "ends in .inp", "another ending")

-- Tests exported time series of VTK files (tests/cli/test_vtk reads the files).
ok(not pcall(export.pvd, w, at "se\233ries.pvd"), "a file name that XML cannot contain")
local add = export.pvd(w, at "series.pvd")
add()
local _, states = read "series.pvd":gsub("<DataSet", "")
is(states, 2, "a state is there once")
w:step()
add(w)
_, states = read "series.pvd":gsub("<DataSet", "")
is(states, 4, "the next one joins")
holds(read "series.pvd", { 'file="series-00001-plate.vtu"', 'timestep="' .. require "archard.files".number(w.distance) },
  "files and distances")
holds(read "series-00001-plate.vtu", { 'Name="wear_depth"', 'Name="pressure"', 'Name="mises"', 'Name="displacement"' },
  "arrays")
local said, usual = {}, io.stderr
io.stderr = { write = function(_, ...) said[#said + 1] = table.concat{ ... } end }
export.pvd(w, at "last.pvd")
io.stderr = usual
holds(table.concat(said), { "last.pvd with one state at ", "as progress of w:run" }, "written states are reported")
fails(function() export.pvd(c, at "c.pvd") end, "export.pvd: expected a wear object", "of a contact")
fails(function() export.pvd(w, at "c.vtu") end, "ends in .pvd", "another ending")
fails(function() export.pvd(w, at "c.pvd", { every = 0 }) end, "field 'every': expected a whole number >= 1", "never")
fails(function() export.pvd(w, at "c.pvd", { each = 2 }) end, "unknown field 'each'", "an unknown field")
ok(not io.open(at "c.pvd"), "nothing was written")
fails(function() export.pvd(w, at "no/c.pvd") end, "export.pvd: cannot write", "no folder")

-- Tests exported JSON summaries of runs.
w = wear{ model = w.model, increments = 20 }
w:step(3)
is(export.json(w, at "w"), at "w.json", "a summary, the ending is added")
local summary = read "w.json"
holds(summary, { '"archard": "' .. require "archard".version .. '"', '"stroke": 0.11', '"definition.load": "N"', '"update": 3,',
  '"definition.model.radius": "mm"', '"depth_plate": ' .. require "archard.files".number(w.depth.plate) }, "content of the summary")
local fresh = wear{ model = w.model, k = function() return 1e-8 end }
export.json(fresh, at "fresh.json")
holds(read "fresh.json", { '"depth_partition": null', '"k": "function"' }, "NaN is null, a function is named")
holds(read "fresh.json", '"k": null,', "a body without a coefficient has none, not 0")
holds(summary, { '"lower": null', '"upper": "cylinder"' }, "the usual pair")
export.json(wear{ load = 100, model = { mesh = { size = 0.2, height = 0.2 }, upper = body.punch{ flat = 1, radius = 2, height = 10, name = "foot" },
  lower = body.block{ k = 2e-8, layers = { { thickness = 0.4, material = material{ E = 4e5, k = 1e-9 } } } } } }, at "own.json")
holds(read "own.json", { '"upper": "foot"', '"lower": "block"', '"cylinder": null', '"plate": null', '"kind": "punch"', '"flat": 1,',
  '"name": "foot"', '"k": 2e-08', '"thickness": 0.4', '"E": 400000', '"k": 1e-09', '"definition.model.upper.flat": "mm"',
  '"definition.model.lower.layers.k": "mm2/N"' }, "bodies of one's own")
fails(function() export.json(c, at "c.json") end, "export.json: expected a wear object", "of a contact")
fails(function() export.json(w, at "w.txt") end, "ends in .json", "another ending")
fails(function() export.json(w) end, "field 'path': expected a file name, got nil", "no path")
if os.execute("command -v sqlite3 >/dev/null") then
  local pipe = io.popen("sqlite3 :memory: \"select json_valid(readfile('" .. at "w.json" .. "')), json_valid(readfile('"
    .. at "fresh.json" .. "'))\"")
  is(pipe:read("a"), "1|1\n", "another program finds both valid")
  pipe:close()
else
  tap.note("no sqlite3: not asked whether the JSON is valid")
end
local json = require "archard.export.json"
is(json.encode{ 1, 0 / 0, { a = 'x"\n\1\xFF' } }, '[1, null, {\n  "a": "x\\"\\n\\u0001\xC3\xBF"\n}]\n', "odd values")

os.execute("rm -r " .. folder)

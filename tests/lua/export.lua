-- export and mesh:write: files of the right form, names, failures.
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

-- The columns of a CSV file by name, numbers from row 1.
local function read_csv(name)
  local names, columns = {}, {}
  for line in read(name):gmatch("[^\n]+") do
    local column = 0
    for cell in line:gmatch("[^,]+") do
      column = column + 1
      local of = columns[names[column]]
      if of then of[#of + 1] = tonumber(cell) or 0 / 0 else names[column] = cell end
    end
    if not columns[names[1]] then for _, n in ipairs(names) do columns[n] = {} end end
  end
  return columns, names
end

-- CSV
local w = wear{ increments = 20 }
w:step(3)
export.csv(w, at "history.csv")
local columns, names = read_csv "history.csv"
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
is(columns.p_cylinder[26], c:pressure("cylinder").p[26], "pressures of the cylinder")
is(#columns.p_plate, #c:pressure("plate").p, "and of the plate")
export.csv(w:profile("plate"), at "profile.csv")
columns, names = read_csv "profile.csv"
is(table.concat(names, ","), "x,y,h,way,worn_x", "a plain table: x first")
is(columns.h[31], w:profile("plate").h[31], "its numbers")
fails(function() export.csv({}, at "a.csv") end, "export.csv: the table is empty", "empty table")
fails(function() export.csv({ 1, 2 }, at "a.csv") end, { "arrays by name", "found [1]" }, "a list")
fails(function() export.csv({ x = { 1 }, y = { 1, 2 } }, at "a.csv") end,
  "1 numbers in 'x' and 2 in 'y'", "lengths differ")
fails(function() export.csv({ x = { "a" } }, at "a.csv") end, "field 'x[1]': expected a finite number",
  "text in an array")
fails(function() export.csv(hertz{}, at "a.csv") end, "expected a wear or contact object", "hertz")
fails(function() export.csv(w) end, "field 'path': expected a file name, got nil", "no path")
local err = fails(function() export.csv(w, at "no/such/folder.csv") end, { "cannot write", "No such file" },
  "a folder that is not there")
is(err.code, "IO", "its code")

-- VTK
local files = { export.vtk(c, at "stress.vtk") }
is(files[1], at "stress-cylinder.vtk", "a file for the cylinder")
is(files[2], at "stress-plate.vtk", "and one for the plate")
local text = read "stress-plate.vtk"
holds(text, { "# vtk DataFile", "POINTS " .. w.model.mesh.plate.nodes, "CELLS", "POINT_DATA", "mises" },
  "stresses in VTK")
-- a stress object stands for its contact
export.vtk(c:stress(), at "field.vtk")
is(read "field-plate.vtk", text, "a stress in VTK, the same file")
files = { export.csv(c:stress(), at "field.csv") }
is(files[1], at "field-cylinder.csv", "a stress in CSV: a file a body")
local columns = read_csv "field-plate.csv"
is(#columns.mises, w.model.mesh.plate.nodes, "node by node")
is(columns.mises[7], c:stress().plate.mises[7], "the same bits")
export.vtk(w.model, at "mesh")
ok(not read("mesh-plate.vtk"):find("mises"), "a model in VTK has no stresses; the ending is added")
is(export.vtk(w.model.mesh.plate, at "plate.vtk"), at "plate.vtk", "a mesh is one file")
holds(read "plate.vtk", "POINTS " .. w.model.mesh.plate.nodes, "with its nodes")
fails(function() export.vtk(w, at "w.vtk") end, "expected a contact, its stress, a model or a mesh", "a run")

-- decks
export.inp(w.model, at "model.inp")
holds(read "model.inp", { "*NODE, NSET=cylinder", "*NODE, NSET=plate", "*ELASTIC", "200000" }, "a deck")
fails(function() export.inp(c, at "c.inp") end, "export.inp: expected a model object, got contact",
  "a deck of a contact")
local mesh = w.model.mesh.cylinder
mesh:write(at "cylinder.inp")
text = read "cylinder.inp"
holds(text, { "*NODE, NSET=cylinder", "TYPE=CPE4" }, "a deck of one mesh")
ok(not text:find("plate"), "has nothing of the other")
mesh:write(at "cylinder.vtk")
holds(read "cylinder.vtk", "CELLS " .. mesh.elements_count, "a mesh as VTK")
mesh:write(at "cylinder.csv")
columns = read_csv "cylinder.csv"
is(#columns.node, mesh.nodes, "a mesh as CSV")
local x, y = mesh:node(7)
ok(columns.x[7] == x and columns.y[7] == y, "node by node")
fails(function() mesh:write(at "mesh.stl") end, "ends in .vtk, .inp or .csv", "another ending")
fails(function() mesh:write() end, "expected a file name", "no name")

os.execute("rm -r " .. folder)

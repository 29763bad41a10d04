-- Meshes from Gmsh files: models of them, what is refused, files that are written, Gmsh itself.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

local files = here .. "/../files/msh/"
local folder = os.tmpname()
os.remove(folder)
ok(os.execute("mkdir " .. folder), "a folder to write to")
local function at(name) return folder .. "/" .. name end

-- The paper's pair, written and read: as its own.
local own = model()
is(export.msh(own, at("pair")), at("pair.msh"), "export.msh adds the ending and tells the file")
local read = model{ mesh = at("pair.msh"), radius = 10 }
is(read.mesh.plate.rows, 0, "no wear box")
is(read.mesh.cylinder.nodes, own.mesh.cylinder.nodes, "all nodes of the cylinder")
local c, d = contact{ model = read, load = 100 }, contact{ model = own, load = 100 }
near(c.p_center, d.p_center, 1e-9, "pressure")
near(c.approach, d.approach, 1e-9, "approach")
local function largest_mises(solved) return math.max(table.unpack(solved:stress().plate.mises)) end
near(largest_mises(c), largest_mises(d), 1e-6, "largest von Mises stress of the plate")

-- The radius that is not given is that of the unworn gap.
near(model{ mesh = at("pair.msh") }.radius, 10, 1e-3, "radius of the gap")
is(model{ mesh = at("pair.msh"), plate = { E = 1e5 } }.plate.E, 1e5, "other fields as ever")

-- Frozen geometry alone.
fails(function() wear{ model = read } end, 'expected "frozen" on a mesh from outside', "moving is refused")
local w = wear{ model = read, geometry = "frozen", stroke = 0.2, cycles = 100 }
w:run()
ok(w.depth_plate > 0, "a frozen run wears")
fails(function() w:save(at("w.wear")) end, "mesh from outside cannot be stored", "not stored")
ok(not io.open(at("w.wear")), "and no file is left")
is(contact{ worn = w }.model.mesh.plate.nodes, own.mesh.plate.nodes, "contact{ worn = } stays on its mesh")
fails(function() export.inp(read, at("p.inp")) end, "no wear box", "no deck")

-- Wrong uses.
fails(function() model{ mesh = at("nothing.msh") } end, "cannot read", "no file")
fails(function() model{ mesh = files .. "gap.msh" } end, "move 'upper' by -0.25 mm along y", "a gap")
fails(function() model{ mesh = files .. "good-41.msh", radios = 10 } end, "radios", "unknown field")
fails(function() export.msh(own, at("pair.vtk")) end, "ends in .msh", "wrong ending")
fails(function() export.msh(d, at("pair.msh")) end, "expected a model or a mesh", "not of a contact")
own.mesh.plate:write(at("plate.msh"))
fails(function() model{ mesh = at("plate.msh") } end, "no physical group 'upper'", "half a pair")

-- A mesh by Gmsh of the same shapes.
local outside = model{ mesh = here .. "/../../examples/gmsh_pair.msh", radius = 10 }
local e = contact{ model = outside, load = 100 }
near(e.p_center, d.p_center, 0.01, "Gmsh's mesh: pressure within 1 %")
near(e.half_width, d.half_width, 0.01, "half width within 1 %")
near(e.approach, d.approach, 0.01, "approach within 1 %")
local function run(m) return wear{ model = m, geometry = "frozen", stroke = 0.2, cycles = 500 }:run() end
local a, b = run(outside), run(own)
near(a.depth_cylinder, b.depth_cylinder, 0.01, "depth of the cylinder within 1 %")
near(a.depth_plate, b.depth_plate, 0.01, "depth of the plate within 1 %")

-- Gmsh reads what is written, and what it writes of that is read, in both versions.
if os.execute("command -v gmsh > /dev/null") then
  for _, version in ipairs{ "msh41", "msh22" } do
    local copy = at(version .. ".msh")
    ok(os.execute(("gmsh -v 1 -save -format %s -o %s %s > /dev/null 2>&1"):format(version, copy, at("pair.msh"))),
      "gmsh reads pair.msh and writes " .. version)
    near(contact{ model = model{ mesh = copy, radius = 10 }, load = 100 }.p_center, d.p_center, 1e-9,
      "the same pressure through " .. version)
  end
else
  print("# no gmsh here: its reading is not tested")
end

os.execute("rm -r " .. folder)

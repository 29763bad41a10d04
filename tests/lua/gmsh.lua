-- Tests meshes from Gmsh files: models, refused files, written files, Gmsh itself.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

local files = here .. "/../files/msh/"
local folder = os.tmpname()
os.remove(folder)
ok(os.execute("mkdir " .. folder), "the temporary folder is created")
local function at(name) return folder .. "/" .. name end

-- Tests that the pair of the reference paper gives the same results after writing and reading its mesh.
local own = model()
is(export.msh(own, at("pair")), at("pair.msh"), "export.msh adds the extension and returns the file name")
local read = model{ mesh = at("pair.msh"), radius = 10 }
is(read.mesh.plate.rows, 0, "an imported mesh has no wear box")
is(read.mesh.cylinder.nodes, own.mesh.cylinder.nodes, "the imported cylinder has all nodes")
local c, d = contact{ model = read, load = 100 }, contact{ model = own, load = 100 }
near(c.p_center, d.p_center, 1e-9, "pressure on the imported mesh")
near(c.approach, d.approach, 1e-9, "approach on the imported mesh")
local function largest_mises(solved) return math.max(table.unpack(solved:stress().plate.mises)) end
near(largest_mises(c), largest_mises(d), 1e-6, "largest von Mises stress of the plate")

-- Tests that the default radius is computed from the unworn gap.
near(model{ mesh = at("pair.msh") }.radius, 10, 1e-3, "default radius of an imported mesh")
is(model{ mesh = at("pair.msh"), plate = { E = 1e5 } }.plate.E, 1e5, "a material beside an imported mesh")

-- Tests that only frozen geometry is allowed on an imported mesh.
fails(function() wear{ model = read } end, 'expected "frozen" on an imported mesh',
  "moving geometry on an imported mesh is refused")
local w = wear{ model = read, geometry = "frozen", stroke = 0.2, cycles = 100 }
w:run()
ok(w.depth_plate > 0, "a run with frozen geometry wears")

-- Tests that a run is stored with its mesh and continues without the mesh file, with identical bits.
local half = wear{ model = read, geometry = "frozen", stroke = 0.2, cycles = 100, jump = 20 }
half:step(2)
half:save(at("w.wear"))
local again = wear.open(at("w.wear"))
half:run()
again:run()
ok(again.p_center == half.p_center and again.depth_plate == half.depth_plate, "a stored run continues with identical bits")
is(again.model.mesh.plate.rows, 0, "the stored run uses the imported mesh")
is(contact{ worn = w }.model.mesh.plate.nodes, own.mesh.plate.nodes,
  "contact{ worn = } uses the mesh of the run")
fails(function() export.inp(read, at("p.inp")) end, "no wear box",
  "an input deck of an imported mesh is refused")

-- Tests the error messages for wrong uses of imported meshes.
is(model{ mesh = at("pair.msh"), lower = body.block{ name = "plank", E = 1e5 } }.bodies.lower, "plank",
  "a body without a shape beside an imported mesh")
local function told(upper, field)
  fails(function() model{ mesh = at("pair.msh"), upper = upper } end, "field 'upper." .. field .. "':",
    "a shape that contradicts the imported mesh")
end
told(body.punch{ flat = 1, radius = 2 }, "radius")
told(body.block{ width = 8 }, "width")
told(body.profile{ y = function() return 0 end }, "y")
told(body.cylinder{ layers = { { thickness = 0.1, E = 1e5 } } }, "layers")
fails(function() model{ mesh = at("nothing.msh") } end, "cannot read", "a missing mesh file")
fails(function() model{ mesh = files .. "gap.msh" } end, "move 'upper' by -0.25 mm along y",
  "a gap between the meshes")
fails(function() model{ mesh = files .. "good-41.msh", radios = 10 } end, "radios",
  "an unknown field beside an imported mesh")
fails(function() export.msh(own, at("pair.vtk")) end, "ends in .msh", "export.msh with another extension")
fails(function() export.msh(d, at("pair.msh")) end, "expected a model or a mesh", "export.msh of a contact")
own.mesh.plate:write(at("plate.msh"))
fails(function() model{ mesh = at("plate.msh") } end, "no physical group 'upper'",
  "a file with the mesh of one body only")

-- Tests materials by the names in the mesh: a coating that wears through, compared with archard's own layer.
-- With frozen geometry, both runs use the compliance of the unworn coating.
local coat = { E = 400e3, k = 5e-9 }
local layered = model{ mesh = { size = 0.05 }, upper = body.cylinder{ radius = 10, E = 210e3, k = 2e-8,
  layers = { { thickness = 5e-4, E = coat.E, k = coat.k } } }, lower = body.block{ k = 1e-8 } }
export.msh(layered, at("coated"))
local function coated(upper, lower)
  return model{ mesh = at("coated.msh"), radius = 10, upper = upper, lower = lower or body.gmsh{ k = 1e-8 } }
end
local m = coated(body.gmsh{ name = "roller", E = 210e3, k = 2e-8, materials = { layer1 = coat } })
is(m.upper.materials.layer1.E, 400e3, "material of a mesh region")
is(m.bodies.upper, "roller", "bodies of an imported mesh have their own names")
local function wear_through(pair)
  return wear{ model = pair, geometry = "frozen", stroke = 0.1, cycles = 1600, jump = 100 }:run()
end
local own_coat, its_coat = wear_through(layered), wear_through(m)
ok(its_coat.depth.roller > 7e-4, "the coating is worn through")
-- The layer of the automatic mesh has a constant thickness along the normal of the surface. Wear depths are along y;
-- in this direction the layer of the imported mesh is slightly thicker.
near(its_coat.depth.roller, own_coat.depth.upper, 1e-4, "depth equals the depth with archard's own layer")
near(its_coat.p_center, own_coat.p_center, 1e-4, "pressure equals the pressure with archard's own layer")
near(largest_mises(contact{ model = m, load = 100 }), largest_mises(contact{ model = layered, load = 100 }), 1e-6,
  "von Mises stress below the coating")
is(coated(body.cylinder{ materials = { layer1 = material(coat) } }).upper.kind, "cylinder",
  "body.cylinder with a material object for a mesh region")
local function refused(upper, why, name)
  fails(function() coated(upper) end, why, name)
end
refused(nil,
  "field 'upper.materials': expected a material for each name in the mesh, 'layer1', got none for 'layer1'",
  "a mesh region without a material")
refused(body.gmsh{ materials = { layer1 = coat, coating = coat } },
  "field 'upper.materials': expected the names in the mesh, 'layer1', got 'coating'",
    "a material for a region that is not in the mesh")
refused(body.cylinder{ layers = { { thickness = 0.1, E = 1e5 } } },
  "expected 'upper.materials' with the names in the mesh: 'layer1'",
  "layers beside an imported mesh with regions")
fails(function() model{ upper = body.gmsh{} } end, "expected mesh = \"FILE.msh\" beside body.gmsh{}",
  "body.gmsh without a mesh")
fails(function() model{ upper = body.cylinder{ materials = { a = coat } } } end, "field 'upper.materials': expected layers",
  "materials by name without a mesh")
fails(function() body.gmsh{ materials = { coat = { F = 1 } } } end, "materials.coat.F", "unknown field of a material")
fails(function() body.gmsh{ materials = { coat = 4 } } end, "'materials.coat': expected a material object",
  "a number instead of a material")
fails(function() body.gmsh{ materials = { coat } } end, "by name", "a list of materials without names")
fails(function() body.gmsh{ materials = { a = {}, b = {}, c = {}, d = {}, e = {} } } end,
  "at most 4 materials",
  "more than four materials of regions")
fails(function() body.gmsh{ materials = {}, layers = { { thickness = 1, E = 1e5 } } } end,
  "expected one of them, got both",
  "materials and layers together")
fails(function() body.gmsh{ radius = 10 } end, "unknown field 'radius' of a gmsh", "a radius of body.gmsh")

-- Tests a mesh of a pin in a bush, which needs the radii of the bodies.
local bush = { upper = body.disc{ radius = 9.95, name = "pin" }, lower = body.ring{ inner = 10, outer = 20 } }
local hole = model(bush)
export.msh(hole, at("bush"))
local outer = model{ mesh = at("bush.msh"), upper = bush.upper, lower = bush.lower }
near(contact{ model = outer, load = 100 }.p_center, contact{ model = hole, load = 100 }.p_center, 1e-9,
  "pressure of an imported pin in a bush")
fails(function() model{ mesh = at("bush.msh"), upper = body.disc{ radius = 8 }, lower = bush.lower } end,
  "within 5 % of the radius 8 mm of 'upper'", "a radius that differs from the mesh")
fails(function() model{ mesh = at("bush.msh"), upper = bush.upper, lower = bush.lower, geometry = "axisymmetric" } end,
  "for a hole", "a hole in a body of revolution")

fails(function() model{ mesh = here .. "/../../examples/gmsh_pair.msh", geometry = "axisymmetric" } end,
  "expected mesh lines along the axis x = 0, got an element from x = -",
    "elements that cross the axis of revolution")

-- Tests a model table as the field of another object, and a mesh given as text.
local text = io.open(at("pair.msh")):read("a")
is(contact{ model = { mesh = at("pair.msh"), radius = 10 }, load = 100 }.p_center, c.p_center,
  "a mesh file in contact{ model = }")
is(contact{ model = { mesh = text, radius = 10 }, load = 100 }.p_center, c.p_center, "the text of a mesh instead of its file name")
fails(function() wear{ model = { mesh = text:sub(1, 300) } } end, "model.mesh, line",
  "an incomplete mesh text")

-- Tests that studies, sessions and settings contain the mesh itself instead of the name of its file.
os.execute(("cp %s %s"):format(at("coated.msh"), at("gone.msh")))
local base = { geometry = "frozen", stroke = 0.1, cycles = 40, jump = 20, increments = 20 }
local function coated_study(given)
  base.model = given
  return study{ base = base, vary = { alpha = { 0.25, 0.5 } } }
end
local of_roller = body.gmsh{ name = "roller", E = 210e3, materials = { layer1 = { E = 400e3 } } }
local by_file = coated_study{ mesh = at("gone.msh"), radius = 10, upper = of_roller }
local by_model = coated_study(model{ mesh = at("gone.msh"), radius = 10, upper = of_roller })
by_file:run{ file = at("file.study"), workers = 1, progress = false }
os.remove(at("gone.msh"))
by_model:run{ file = at("model.study"), workers = 1, progress = false }
local p, q = by_file:cases(), by_model:cases()
for i = 1, 2 do
  ok(p[i].status == "done" and p[i].last.p_center == q[i].last.p_center and p[i].last.depth_plate == q[i].last.depth_plate,
    ("case %d: file name and model object give the same result"):format(i))
end
local roller = coated(of_roller, body.gmsh{})
local alone = wear{ model = roller, geometry = "frozen", stroke = 0.1, cycles = 40, jump = 20, increments = 20, k = 1e-8, alpha = 0.5 }
near(q[2].last.depth_plate, alone:run().depth_plate, 1e-9, "a case equals the run outside the study")
near(wear.open(at("file.study"), 2).depth_plate, alone.depth_plate, 1e-9,
  "a case opened from the file of a study")
is(#study.open(at("file.study")):cases(), 2, "a study is opened without its mesh file")
fails(function() coated_study{ mesh = at("gone.msh") }:run{ file = at("none.study"), workers = 1 } end,
  "cannot read",
  "a study with a missing mesh file")
the_model, the_run = roller, alone -- a session stores global variables
session.save(at("session"))
the_model, the_run = nil, nil
session.open(at("session"))
is(the_run.depth.roller, alone.depth.roller, "a session stores runs")
is(the_model.upper.materials.layer1.E, 400e3, "a session stores models with their materials")
is(contact{ model = the_model, load = 100 }.p_center, contact{ model = roller, load = 100 }.p_center,
  "pressure of a model opened from a session")
is(export.msh(the_model), export.msh(roller), "mesh of a model opened from a session")

-- Tests that a mesh of the reference pair made by Gmsh gives the results of archard's own mesh.
local outside = model{ mesh = here .. "/../../examples/gmsh_pair.msh", radius = 10 }
local e = contact{ model = outside, load = 100 }
near(e.p_center, d.p_center, 0.01, "pressure on the mesh by Gmsh within 1 %")
near(e.half_width, d.half_width, 0.01, "half width on the mesh by Gmsh within 1 %")
near(e.approach, d.approach, 0.01, "approach on the mesh by Gmsh within 1 %")
local function run(m) return wear{ model = m, geometry = "frozen", stroke = 0.2, cycles = 500 }:run() end
local a, b = run(outside), run(own)
near(a.depth_cylinder, b.depth_cylinder, 0.01, "depth of the cylinder within 1 %")
near(a.depth_plate, b.depth_plate, 0.01, "depth of the plate within 1 %")

-- Tests that Gmsh reads the written files and that archard reads the files written by Gmsh in both versions
-- of the format.
if os.execute("command -v gmsh > /dev/null") then
  for _, version in ipairs{ "msh41", "msh22" } do
    local copy = at(version .. ".msh")
    ok(os.execute(("gmsh -v 1 -save -format %s -o %s %s > /dev/null 2>&1"):format(version, copy, at("pair.msh"))),
      "gmsh reads pair.msh and writes " .. version)
    near(contact{ model = model{ mesh = copy, radius = 10 }, load = 100 }.p_center, d.p_center, 1e-9,
      "the same pressure through " .. version)
  end
else
  print("# skipped without gmsh: reading and writing by Gmsh")
end

os.execute("rm -r " .. folder)

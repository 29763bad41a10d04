-- Help entries of the objects that compute: material, hertz, model, contact, wear. Form: help.lua.
-- Each: { address, kind=, type=, unit=, default=, values=, class=, use=, text= }. The equations are
-- those of Mattei and Di Puccio, "Influence of the wear partition factor on wear evolution
-- modelling of sliding surfaces".

return {
  -- --- material -------------------------------------------------------------------------------
  { "material", kind = "constructor", use = "material{ E=200e3, nu=0.3, k=1e-9 }",
    text = "A linear elastic material. The defaults are the reference case's steel." },
  { "material.E_star", kind = "field", unit = "MPa",
    text = "Plane-strain modulus E / (1 - nu^2)." },

  -- --- hertz ----------------------------------------------------------------------------------
  { "hertz", kind = "constructor", use = "hertz{ radius=10, load=100 }",
    text = "Hertz' closed form for the line contact of a cylinder on a half-space, or with geometry = "
      .. '"axisymmetric" for that of a ball: what an unworn contact is measured by.' },
  { "hertz.half_width", kind = "field", unit = "mm",
    text = "Half width of the contact, a = sqrt(4 R L_N / (pi t E*)); of a ball cbrt(3 R L_N / (4 E*))." },
  { "hertz.half_width_z", kind = "field", unit = "mm",
    text = "Half width across the motion, with geometry = \"3-D\"; NaN of a cylinder." },
  { "hertz.p_max", kind = "field", unit = "MPa",
    text = "Pressure at the centre, p_H = 2 L_N / (pi a t); of a ball 3 L_N / (2 pi a^2)." },
  { "hertz.E_star", kind = "field", unit = "MPa",
    text = "Contact modulus 1 / (1/E*_c + 1/E*_p) of the pair; in plane stress of E itself." },
  { "hertz.approach", kind = "field", unit = "mm",
    text = "How far a ball and its plate come together, a^2 / R; NaN of a cylinder, where it has no end." },

  -- --- model ----------------------------------------------------------------------------------
  { "model", kind = "constructor", use = "model{ radius=10, mesh={ fineness=2 } }",
    text = "The two elastic bodies, meshed and condensed once: a half cylinder, its flat top built "
      .. "in, on a plate 2 radius wide and radius high. A model never changes, so that any number of "
      .. "contact and wear objects share one. Plane strain, plane stress or bodies of revolution: help "
      .. "\"axisymmetric\". mesh = \"pair.msh\" takes both bodies from "
      .. "a Gmsh file: help \"gmsh\"." },
  { "model.upper", kind = "field", text = "The upper body as it was given; nil: a cylinder." },
  { "model.lower", kind = "field", text = "The lower body as it was given; nil: a block." },
  { "model.bodies", kind = "field",
    text = "What the bodies are called: m.bodies.upper, m.bodies.lower. By their name, as in body.disc{ "
      .. 'name="pin" }; without one by their kind ("ring"), or else "upper" and "lower"; the usual pair '
      .. '"cylinder" and "plate". Results answer to all of these words: w.depth.pin, w.depth.upper, '
      .. 'w:profile("pin"), m.mesh.pin, state.depth.pin, a case of a study, plot.history(w, "depth_pin").' },
  { "body", kind = "module", use = "model{ upper = body.punch{ flat=1, radius=2 }, lower = body.block{} }",
    text = "Makes bodies for model{ upper=, lower= }: the upper one carries the load by its top or held "
      .. "part, the lower one moves. Each takes either E, nu, k or material=, and layers = {{ thickness=, "
      .. "material= }, ...} from the surface inwards, whose k counts as deep as they reach; on a mesh from "
      .. "Gmsh materials = { NAME = } in their place." },
  { "body.cylinder", kind = "function", use = "body.cylinder{ radius=10 }", result = "table",
    text = 'A half cylinder, its flat built in. In a bush it matters how the pin is held: hold="free" lets the flat slide '
      .. 'sideways, hold="hub" makes it a whole disc around a rigid hub.' },
  { "body.ball", kind = "function", use = "body.ball{ radius=10, radius_z=50 }", result = "table",
    text = 'A ball, crowned roller or ellipsoid, for model{ geometry="3-D" }: its surface rises as x^2 / (2 radius) + z^2 / (2 radius_z), '
      .. "z across the motion." },
  { "body.block", kind = "function", use = "body.block{ width=20, height=10 }", result = "table",
    text = 'A block, its base (of an upper one: its top) built in. With geometry="3-D" a half-space, or with a height a layer on a rigid base.' },
  { "body.punch", kind = "function", use = "body.punch{ flat=1, radius=2, height=10 }", result = "table",
    text = "A block with a flat of full width `flat` and edges rounded by `radius` beside it." },
  { "body.profile", kind = "function", use = "body.profile{ y=function(x) return 1e-4*math.cos(60*x) end }",
    result = "table",
    text = "A block with a measured or made-up surface: y(x) out of the body in mm, or lists x and y; or "
      .. "body.profile(profile.read(path)), a trace with z." },
  { "body.map", kind = "function", use = 'body.map{ y=map.read("ball.sdf"):level("sphere"), radius=10 }', result = "table",
    text = 'A measured or made-up topography, for model{ geometry="3-D" } on either side: heights out of the body at even steps of x and z, as a map '
      .. "or as map{ x=, z=, y= } takes them. With a radius (and radius_z) they are added to those of a ball. Cubic between the points; contacts "
      .. "stay within the map, about x = z = 0." },
  { "body.disc", kind = "function", use = "body.disc{ radius=9.95 }", result = "table",
    text = "A whole disc, held by a hub of 0.15 radius in its middle." },
  { "body.ring", kind = "function", use = 'body.ring{ inner=10, outer=20, fixed="outer" }', result = "table",
    text = "A ring; fixed=\"outer\": its hole is in contact, with a disc, cylinder or inner ring in it. "
      .. "Then contact is solved along the arc, x is the length along the hole; without friction." },
  { "body.gmsh", kind = "function", use = "body.gmsh{ name=, E=, materials={ coating={ E=400e3 } } }",
    result = "table", text = "What the Gmsh file of model{ mesh = } has for it; materials by the names there: help "
      .. "\"gmsh\"." },
  { "model.seconds", kind = "field", unit = "s", text = "Time it took to build." },
  { "model.bytes", kind = "field", unit = "bytes", text = "Memory it takes." },
  { "model.close", kind = "method", use = "m:close()",
    text = "Lets go of it now instead of when it is collected; runs and contacts on it stay." },
  { "model.mesh", kind = "field",
    text = "The two meshes, m.mesh.cylinder and m.mesh.plate, and their definition: size, height, "
      .. "fineness, far, zone, rows, element; numbers in place of \"auto\"." },
  { "model.mesh.cylinder", kind = "field", class = "mesh", text = "Mesh of the half cylinder." },
  { "model.mesh.plate", kind = "field", class = "mesh", text = "Mesh of the plate." },

  -- --- mesh -----------------------------------------------------------------------------------
  { "mesh", kind = "object", use = "m.mesh.cylinder, m.mesh.plate",
    text = "Finite elements of one body, an exact mirror image about x = 0. The origin is the first "
      .. "point of contact, x along the plate's surface, y up. w.mesh.cylinder and w.mesh.plate of a "
      .. "run have the nodes where wear has moved them by then." },
  { "mesh.nodes", kind = "field", text = "Number of nodes." },
  { "mesh.quads", kind = "field", text = "Number of quadrilaterals." },
  { "mesh.triangles", kind = "field", text = "Number of triangles." },
  { "mesh.elements_count", kind = "field", text = "Number of elements: quads and triangles." },
  { "mesh.element", kind = "field", text = '"CPE4" or "CPE4I": what "auto" came to for this body; in plane stress "CPS4", of revolution "CAX4".' },
  { "mesh.rows", kind = "field", text = "Element rows of the wear box." },
  { "mesh.body", kind = "field", text = '"cylinder" or "plate".' },
  { "mesh.radius", kind = "field", unit = "mm", text = "Radius of the cylinder." },
  { "mesh.quality", kind = "method", use = "m.mesh.plate:quality()",
    text = "Of the worst elements, as a table: smallest_angle, largest_angle (degrees), aspect (longest "
      .. "edge over shortest), jacobian_ratio (smallest over largest at a quad's corners), "
      .. "smallest_jacobian (mm2, positive); the same of the wear box alone in the table box." },
  { "mesh.write", kind = "method", use = "m.mesh.plate:write(path)",
    text = "Writes the mesh to a file, by its ending: .vtk, .vtu, .inp (Abaqus, CalculiX), .msh "
      .. "(Gmsh) or .csv (nodes)." },
  { "mesh.node", kind = "method", use = "x, y = m.mesh.plate:node(i)",
    text = "Position of node i = 1 ... nodes, in mm." },
  { "mesh.elements", kind = "method", use = "m.mesh.plate:elements()",
    text = "Corners of all elements in one list, four an element, as node numbers from 1; a triangle "
      .. "has 0 as its fourth." },
  { "mesh.coordinates", kind = "method", use = "m.mesh.plate:coordinates()",
    text = "Positions of all nodes, { x=, y= } in mm." },
  { "mesh.surface", kind = "method", use = "m.mesh.plate:surface()",
    text = "Numbers of the candidate contact nodes, by increasing x." },
  { "mesh.box", kind = "method", use = "m.mesh.plate:box()",
    text = "Numbers of the wear box' nodes: rows + 1 for each surface node, from the surface inwards." },
  { "mesh.outline", kind = "method", use = "m.mesh.plate:outline()",
    text = "Numbers of the boundary's nodes, counter-clockwise." },
  { "mesh.fixed", kind = "method", use = "m.mesh.plate:fixed()",
    text = "Numbers of the nodes that are built in or tied to the rigid base." },
  { "mesh.close", kind = "method", use = "mesh:close()", text = "Lets go of it now." },

  -- --- contact --------------------------------------------------------------------------------
  { "contact", kind = "constructor", use = "c = contact{ load=100, x=0 }",
    text = "One contact solution: the plate at x, pressed by the load; c:move goes on from there. "
      .. "Without a model it uses one whose zones suit. With friction, shear, slip and tangential "
      .. "force are positive where the plate is pushed along x." },
  { "contact{worn.cylinder}", type = "function(x) or table { x=, h= }", unit = "mm",
    text = "Wear depth of the cylinder against x. A function is taken at the nodes; points by splines "
      .. "without kinks inside a scar, with the area under them." },
  { "contact{worn.plate}", type = "function(x) or table { x=, h= }", unit = "mm",
    text = "Wear depth of the plate against x. A function is taken at the nodes; points by splines "
      .. "without kinks inside a scar, with the area under them." },
  { "contact.half_width", kind = "field", unit = "mm",
    text = "Half the width of the contact: good to 0.03 of an element unworn, to 0.07 where worn "
      .. "surfaces meet smoothly, to 0.2 in the mean and 0.6 at worst at the edges of scars." },
  { "contact.half_width_z", kind = "field", unit = "mm",
    text = "Half the width across the motion, in 3-D; 0 in the plane." },
  { "contact.area", kind = "field", unit = "mm2", text = "Area in contact, in 3-D; 0 in the plane." },
  { "contact.p_max", kind = "field", unit = "MPa",
    text = "Largest nodal pressure. At the edge of a scar it grows as the mesh shrinks." },
  { "contact.p_average", kind = "field", unit = "MPa",
    text = "Largest pressure averaged over the length `average`: settles as the mesh shrinks." },
  { "contact.p_center", kind = "field", unit = "MPa",
    text = "Pressure at x = 0 of the upper body: the lowest point of a cylinder; that of a profile may lie elsewhere, "
      .. "see p_max." },
  { "contact.normal_force", kind = "field", unit = "N",
    text = "Integral of the pressure over the area: the load, but in holes up to 4/pi times that." },
  { "contact.approach", kind = "field", unit = "mm",
    text = "Rigid approach of the cylinder's built-in top and the plate's base." },
  { "contact.iterations", kind = "field", text = "Active sets the solution went through." },
  { "contact.edges", kind = "field", unit = "mm",
    text = "Where the contact begins and ends, { left=, right= }, counted from the cylinder's axis." },
  { "contact.model", kind = "field", class = "model", text = "The model it was solved on." },
  { "contact.pressure", kind = "method", values = { "cylinder", "plate" },
    use = 'c:pressure("cylinder" | "plate")', default = '"cylinder"',
    text = "Pressure at the surface nodes of a body, as { x=, p= } in mm and MPa; x is counted from "
      .. "the cylinder's axis." },
  { "contact.move", kind = "method", class = "contact",
    use = "c:move{ x= | tangential=, z= | tangential_z=, load=, increments= }",
    text = "The contact after the plate's base has gone to x, or has been driven by a tangential "
      .. "force, and the load has changed; linear in all of them, c stays as it is. Coulomb "
      .. "friction keeps its history: which points slipped, and how far. Where neither x nor tangential "
      .. "is given the base is held. x may go far: then the bodies slide over each other. In 3-D the same goes for z and "
      .. "tangential_z; increments follow paths that turn, and loads that rise while cells stick: such steps are right to first order "
      .. "in their length. A force that turns in a circle loses 8 % of its work with 64 increments a turn." },
  { "contact.z", kind = "field", unit = "mm", text = "Position of the lower body along z, in 3-D with friction; 0 in the plane." },
  { "contact.tangential_z", kind = "field", unit = "N",
    text = "Force that drives the lower body along z, in 3-D with friction; 0 in the plane." },
  { "contact.tangential", kind = "field", unit = "N",
    text = "Force that drives the plate along x. Without friction that which slopes bear." },
  { "contact.energy", kind = "field", unit = "N mm",
    text = "Energy dissipated by friction since the bodies came together: shear force times slip, "
      .. "that between the nodes included. In partial slip of like bodies (Dundurs' beta up to 0.01, as of steels) under a load that "
      .. "stays, whatever the forces before, good to 1.6 % where one element slips on either side, to 0.3 % where three do. Up to beta "
      .. "0.1 one that slips may leave 12 %, three 1.5 %. Beta above 0.1, loads that change and edges of scars have the nodes' sum "
      .. "alone, up to 45, 15 and 6 % off where one, one and a half and two elements slip." },
  { "contact.stick", kind = "field", unit = "mm",
    text = "The zones that stuck in the last increment, a list of { left=, right= }; empty in gross "
      .. "slip. Between nodes to 0.15 of an element, to 0.3 where fewer than six stick. In 3-D a number: the share of the contact's area." },
  { "contact.shear", kind = "method", values = { "cylinder", "plate" },
    use = 'c:shear("cylinder" | "plate")', default = '"cylinder"',
    text = "Shear traction at the surface nodes of a body, as { x=, q= } in mm and MPa: on the "
      .. "cylinder along +x, on the plate along -x. |q| is friction times the pressure at most. In 3-D c:shear() is the map "
      .. 'of |q| on the upper body, c:shear("x") and c:shear("z") are those of its parts, c:shear{ z=0 } is a section { x=, q=, qz= }.' },
  { "contact.slip", kind = "method", use = "c:slip()",
    text = "How far the plate's surface has slipped over the cylinder's nodes since the bodies came "
      .. "together, { x=, s= } in mm, along +x. Nodes that do not touch go on too. Takes no body. In 3-D a map of its "
      .. 'size, c:slip("x") and c:slip("z") of its parts, c:slip{ z=0 } a section { x=, s=, sz= }.' },
  { "contact.stress", kind = "method", class = "stress", use = "c:stress()",
    text = "Displacements and stresses inside both bodies: a field for plot.stress, export.vtk and export.csv. In 3-D c:stress{ y=-0.05 }, a plane below "
      .. 'the surface, c:stress{ z=0 } or { x=0 }, a section down to three half widths, of body="lower" or another: maps sxx, syy, szz, sxy, '
      .. "syz, sxz, mises in MPa for plot.map, over x and z; of a section over x (z) and y, which takes the place of z." },
  { "contact.close", kind = "method", use = "c:close()",
    text = "Lets go of it now instead of when it is collected." },
  { "stress", kind = "object", use = "f = c:stress()",
    text = "Fields on both bodies, f.cylinder and f.plate: lists x, y (mm, nodes), ux, uy (mm, "
      .. "displacements), mises, principal (the largest), shear, sxx, syy, szz, sxy (MPa), elements (four corners "
      .. "each). Of second order in the element size: at the surface from its tractions and the strain "
      .. "along it, inside from the elements' centres. Next to a smooth edge of the contact the "
      .. "pressure is the square-root law's at the point (stresses to 2 % of the largest pressure at "
      .. "20 um, to 9 % with friction 0.6), at kinks of scars the node's." },
  { "stress.cylinder", kind = "field", text = "Lists of the cylinder." },
  { "stress.plate", kind = "field", text = "Lists of the plate." },
  { "stress.contact", kind = "field", class = "contact", text = "The contact it was made of." },

  -- --- wear -----------------------------------------------------------------------------------
  { "wear", kind = "constructor", use = "w = wear{ alpha=0.5, stroke=0.11, distance=1320 }",
    text = "A wear run: two surfaces that slide and lose material by Archard's law in local form, "
      .. "h = k_b times the integral of p ds at every point of both bodies (Eq. 13), k_c = alpha k "
      .. "for the cylinder, k_p = (1 - alpha) k for the plate (Eq. 20).\n\nwear{} is the reference "
      .. "case: a steel cylinder of 10 mm under 100 N, stroke 0.11 mm, alpha 0.5. Nothing runs until "
      .. "w:step() or w:run()." },
  { "wear{loading.x}", type = "function(t) or list", unit = "mm",
    text = "Position of the plate over the cycle." },
  { "wear{loading.load}", type = "function(t), list or number", unit = "N",
    default = "that of the run", text = "Normal load over the cycle; 0 lifts off: no contact, no wear." },
  { "wear{loading.t}", type = "list",
    text = "Increasing times of the lists, in any unit: the first is the start of the cycle (t = 0), "
      .. "the last its end (t = 1). Left out: the points lie evenly in time." },
  { "wear{loading.increments}", type = "whole number >= 1", default = 100,
    text = "Even increments of the cycle, at whose ends functions are called and lists interpolated. "
      .. "Left out: lists are taken point by point, functions at their times; increments = \"auto\" of "
      .. "the run joins what is too far apart." },
  { "wear{loading.cycles}", type = "number > 0", unit = "cycles",
    text = "How often the cycle is repeated. The last block may be without: it goes on to the end." },
  { "wear{loading.periodic}", type = "boolean", default = true,
    text = "false: one generic history, with a geometry update at every increment (Eqs. 4-8)." },
  { "wear{local_factor.vector}", type = "function(body, xs, ps, state, zs)",
    text = "The same for all nodes under pressure in one call, for factors that hang together: xs and "
      .. "ps are lists, with geometry = \"3-D\" zs too, the result is the list of factors, and may be ps "
      .. "itself." },
  { "wear{worn.cylinder}", type = "function(x) or table { x=, h= }", unit = "mm",
    text = "Wear depth of the cylinder to start from." },
  { "wear{worn.plate}", type = "function(x) or table { x=, h= }", unit = "mm",
    text = "Wear depth of the plate to start from." },

  { "wear.step", kind = "method", use = "w:step(n)",
    text = "Makes n geometry updates (1 without n), as long as jump says, the last one shorter so "
      .. "that the distance is met exactly. Returns the record of the last. A step completes or "
      .. "leaves everything as it was." },
  { "wear.run", kind = "method", use = "w:run{ distance= }",
    text = "Steps to the end of the distance, or of the one given. Ctrl-C stops after the step; "
      .. "another w:run() goes on as if nothing had been." },
  { "wear.run{distance}", type = "number > 0", unit = "mm",
    text = "Total travelled distance to stop at; the definition's where left out." },
  { "wear.run{cycles}", type = "number > 0", unit = "cycles",
    text = "Total number of cycles to stop at." },
  { "wear.run{progress}", type = "boolean or function(w)",
    text = "Shows a bar on a terminal (the default there), or calls the function after every step; "
      .. "the run ends early where it returns true. false shows nothing." },
  { "wear.run{depth}", type = "table { cylinder=, plate= }", unit = "mm",
    text = "Ends where the wear depth of a body reaches this value, exactly, by a shorter last step; "
      .. "or at the distance, if that comes first. Given this or another measure, run returns a "
      .. 'second value, which says what ended it: "depth.cylinder", "distance", ...' },
  { "wear.run{volume}", type = "table { cylinder=, plate=, total= }", unit = "mm3",
    text = "Ends where a wear volume reaches this value, as with depth." },
  { "wear.run{depth.cylinder}", type = "number > 0", unit = "mm", text = "Depth of the cylinder." },
  { "wear.run{depth.plate}", type = "number > 0", unit = "mm", text = "Depth of the plate." },
  { "wear.run{volume.cylinder}", type = "number > 0", unit = "mm3", text = "Volume of the cylinder." },
  { "wear.run{volume.plate}", type = "number > 0", unit = "mm3", text = "Volume of the plate." },
  { "wear.run{volume.total}", type = "number > 0", unit = "mm3", text = "Volume of both." },
  { "wear.run{p_center}", type = "number > 0", unit = "MPa",
    text = "Ends where the pressure at the centre passes this value, as with depth." },
  { "wear.run{p_max}", type = "number > 0", unit = "MPa",
    text = "Ends where the largest pressure passes this value, as with depth." },
  { "wear.run{half_width}", type = "number > 0", unit = "mm",
    text = "Ends where half the contact width passes this value, as with depth." },
  { "wear.run{stop_when}", type = "function(w)",
    text = "Called with the run after every step; the run ends where it returns true." },
  { "wear.set", kind = "method", takes = "wear", class = "wear", use = "w:set{ alpha=0.3, load=200 }",
    text = "Changes the definition between two steps: any field of wear{} but model, geometry and "
      .. "worn; and mesh={ ... }, to which the worn shapes are carried over. What is not given stays; the worn shapes and the history stay too. A new loading "
      .. "begins at its start, loading=false and stroke go back to the plain stroke. distance and "
      .. "cycles count from the start of the run. Returns the run." },
  { "wear.set{mesh}", type = "table { size=, fineness=, rows=, zone=, ... }",
    text = "New meshes for both bodies: fields of model{ mesh= }; what is not given stays. With another "
      .. "size and no rows, the wear box stays as deep as it was." },
  { "wear.clone", kind = "method", class = "wear", use = "w:clone()",
    text = "A copy that goes its own way: for a before and after, or for two futures of one past." },
  { "wear.close", kind = "method", use = "w:close()",
    text = "Lets go of it now instead of when it is collected." },
  { "wear.contact", kind = "method", class = "contact", use = "w:contact()",
    text = "The contact on the present shape: plate at x = 0, nominal load, without friction. contact{ model=w.model, worn=w, "
      .. "friction=w.friction } presses the same surfaces with it." },
  { "wear.save", kind = "method", use = "w:save(path)",
    text = "Writes the run, with all it needs to go on, to a run file; wear.open reads it. A run "
      .. "that was saved there before is replaced, anything else is refused." },
  { "wear.open", kind = "function", class = "wear", use = "w = wear.open(path, case)",
    text = "Reads a run that w:save wrote, or a case of a study by its number; it goes on to the "
      .. "same numbers. Functions in its definition cannot be stored: give them again, "
      .. "wear.open(path, { k = f })." },
  { "wear.profile", kind = "method", values = { "cylinder", "plate" },
    use = 'w:profile("cylinder" | "plate")',
    text = "Worn profile of a body: { x=, h=, y=, worn_x=, way= } in mm. x is where the node was unworn "
      .. "and h its wear depth, summed along the normals; (worn_x, y) is where it is now, and way "
      .. "the length of the vector sum of its wear." },
  { "wear.pressure", kind = "method", values = { "cylinder", "plate" },
    use = 'w:pressure("cylinder" | "plate")',
    text = "Pressure on a body in the reference configuration, { x=, p= } in mm and MPa." },
  { "wear.combined", kind = "method", use = "w:combined()",
    text = "Sum profile h_c + h_p (Eq. 31), { x=, h= } in mm." },
  { "wear.local_partition", kind = "method", use = "w:local_partition()",
    text = "Local wear depth partition h_c / (h_c + h_p) along x (Eq. 30)." },
  { "wear.roughness", kind = "method", values = { "cylinder", "plate" },
    use = 'w:roughness("cylinder" | "plate")', default = '"cylinder"',
    text = "Roughness of a profile: its sawtooth part (1 for a sawtooth as high as the depth), root mean "
      .. "square over the middle of the contact. Smooth profiles stay under 1e-4." },
  { "wear.map", kind = "method", use = 'w:map("ball", "depth" | "height" | "pressure")', result = "map",
    text = "Of a run in 3-D: the wear depth [mm], the worn height [mm] or the pressure under load at x = 0 [MPa] of a body over x "
      .. 'and z, as a map. What is left out is "depth". w:profile(body, { z = 0 }) and { x = 0 } are sections.' },
  { "wear.stability", kind = "method", use = "w:stability()",
    text = "{ eigenvalue=, jump_limit= }: the growth rate of ripples in 1/cycle, linearised about the "
      .. "present state, and 2 / eigenvalue. Explicit updates with a larger jump get rough." },
  { "wear.loop", kind = "method", use = "w:loop()",
    text = "{ x=, tangential=, energy=, stick_width=, gross= }: the fretting loop of a steady cycle on the present surfaces: position "
      .. "of the plate's base in mm, the force in N that drives it, and the energy in N mm that "
      .. "it dissipates (over the whole plate, where a cycle is a pass, there and back); the width that never slips in mm, and whether all of it slips at some time. "
      .. "Of runs with friction. In partial slip the loop's area misses what slips between nodes. In gross slip it is larger than the energy by the strain of the surfaces under "
      .. "the pressure, 0.12 % at 591 MPa on steel, which linear elasticity leaves out, and off by the increments' length. "
      .. "plot.loop(w) draws it." },
  { "wear.energy", kind = "field", unit = "N mm", text = "Energy dissipated by friction so far." },
  { "wear.cycle_energy", kind = "field", unit = "N mm",
    text = "Energy that a steady cycle dissipates on the present surfaces; 0 before the first update." },
  { "wear.largest_shear", kind = "field", unit = "N",
    text = "Largest tangential force in that cycle. On curved or worn surfaces it may exceed friction times the load." },
  { "wear.stick_width", kind = "field", unit = "mm",
    text = "Width of the contact that never slips in that cycle; 0 in gross slip." },
  { "wear.gross", kind = "field",
    text = "1 where the whole contact slips at some time in that cycle, 0 where a part of it always sticks, or while "
      .. "friction is 0." },
  { "wear.model", kind = "field", class = "model", text = "The model it runs on." },
  { "wear.mesh", kind = "field", use = "w.mesh.plate:quality()",
    text = "The meshes as they are worn by now, cylinder and plate: objects like those of a model, for "
      .. "quality, plot.mesh(w) and files. Wear that is the same all over the plate leaves its nodes; layers "
      .. "under them come up with moving geometry, but under a track." },
  { "wear.distance", kind = "field", unit = "mm", text = "Travelled distance so far." },
  { "wear.cycle", kind = "field", unit = "cycles", text = "Loading cycles so far." },
  { "wear.update", kind = "field", text = "Geometry updates so far." },
  { "wear.solutions", kind = "field", text = "Contacts solved so far; half of a symmetric stroke is the mirror image of the other half and counts too." },
  { "wear.done", kind = "field", text = "Whether the whole distance has been travelled." },
  { "wear.p_center", kind = "field", unit = "MPa",
    text = "Pressure at the centre, plate at x = 0, nominal load." },
  { "wear.p_max", kind = "field", unit = "MPa",
    text = "Largest nodal pressure, plate at x = 0, nominal load. At the edge of a scar it grows as the "
      .. "mesh shrinks." },
  { "wear.p_average", kind = "field", unit = "MPa",
    text = "Largest pressure averaged over the usual length of contact{ average= }, plate at x = 0, "
      .. "nominal load: it settles as the mesh shrinks." },
  { "wear.p_peak", kind = "field", unit = "MPa",
    text = "Largest pressure on the whole way of the last update's cycle, on the present surfaces, "
      .. "under the loads it has there. A groove's edge presses on the other body's near the ends "
      .. "of the stroke, so that it may be far above p_max. It does not settle as elements get "
      .. "smaller. NaN in runs of files older than format 3, until they go on." },
  { "wear.travel", kind = "field", unit = "mm",
    text = "The plate's way from one end to the other in the last update's cycle, or in its increment of a generic "
      .. "history. NaN, as history.load, in runs of files older than format 4, until they go on." },
  { "wear.load_distance", kind = "field", unit = "N mm",
    text = "Integral of the load over the sliding distance of this run, F d of Archard's law. Forces "
      .. "balance, so that it is the integral of p ds dA on each body too, and under rigid slip a "
      .. "volume is k of that body times it (Eq. 15); a law, local factors and elastic slip show in what "
      .. "volumes differ by. NaN in runs of files older than format 4." },
  { "wear.half_width", kind = "field", unit = "mm",
    text = "Half the width of the contact, plate at x = 0, nominal load: good to 0.03 of an element "
      .. "unworn, to 0.07 where worn surfaces meet smoothly, to 0.2 in the mean and 0.6 at worst at the edges of "
      .. "scars (the paper's cases, against 5 um)." },
  { "wear.half_width_z", kind = "field", unit = "mm",
    text = "Half the width of that contact across the motion, in 3-D; 0 in the plane." },
  { "wear.area", kind = "field", unit = "mm2", text = "Area of that contact, in 3-D; 0 in the plane." },
  { "wear.depth", kind = "field", unit = "mm", text = "Largest wear depth of each body." },
  { "wear.depth.cylinder", kind = "field", unit = "mm",
    text = "Largest wear depth of the cylinder." },
  { "wear.depth.plate", kind = "field", unit = "mm", text = "Largest wear depth of the plate." },
  { "wear.vector_depth", kind = "field", unit = "mm",
    text = "Largest length of the vector sum of the wear steps (Eq. 8) of each body; depth is the "
      .. "scalar sum (Eq. 6)." },
  { "wear.volume", kind = "field", unit = "mm3", text = "Wear volumes of this run. What a starting shape (worn) had lost before counts in "
      .. "the depths, not here." },
  { "wear.volume.cylinder", kind = "field", unit = "mm3", text = "Wear volume of the cylinder." },
  { "wear.volume.plate", kind = "field", unit = "mm3", text = "Wear volume of the plate." },
  { "wear.volume.total", kind = "field", unit = "mm3", text = "Wear volume of both, k L_N d." },
  { "wear.depth_partition", kind = "field",
    text = "Wear depth partition factor alpha-tilde: the cylinder's share of the sum of the largest "
      .. "depths (Eq. 29)." },

  -- --- the definition, read back --------------------------------------------------------------
  { "wear.stroke", kind = "field", unit = "mm",
    text = "The plate's way from one end to the other: the stroke, or that of the present block of loading. "
      .. "history.travel has it update by update." },
  { "wear.strokes", kind = "field", text = "Strokes of a cycle, r of Eq. (21): 2, or 1 at 2 radius." },
  { "wear.k_cylinder", kind = "field", unit = "mm2/N",
    text = "Wear coefficient of the cylinder, alpha k; where that changes, of the last update." },
  { "wear.k_plate", kind = "field", unit = "mm2/N", text = "That of the plate, (1 - alpha) k." },
  { "wear.cycles", kind = "field", unit = "cycles", text = "Cycles of the whole distance (Eq. 21)." },
  { "wear.total_distance", kind = "field", unit = "mm", text = "Travelled distance to simulate." },
  { "wear.procedure", kind = "field", text = 'The one chosen, "SP" or "NSP".' },
  { "wear.update_at", kind = "field", text = '"cycle" or "increment", see wear{update}.' },
  { "wear.loading", kind = "field",
    text = "The blocks of loading as they were sampled, each { x=, load=, cycles=, periodic= }; false "
      .. "for the plain stroke." },
  { "wear.local_factor", kind = "field", text = "The function, or false." },
  { "wear.functions", kind = "field",
    text = 'List of the fields that are functions, "k", "alpha", "jump", "local_factor": what no file '
      .. "can hold." },

  -- --- state ----------------------------------------------------------------------------------
  { "state", kind = "object", use = "wear{ k = function(state) ... end }",
    text = "What functions of the state get. It can be read during the call only. k and alpha are "
      .. "asked at several points between the start and the end of an update, more often where they "
      .. "change, with distance, cycle, depths and volumes predicted there; jump and local_factor, "
      .. "and all that is not predicted, see the last record." },
  { "state.depth", kind = "field", unit = "mm", text = "Largest wear depths, { cylinder=, plate= }." },
  { "state.volume", kind = "field", unit = "mm3", text = "Wear volumes, { cylinder=, plate=, total= }." },
}

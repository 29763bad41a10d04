-- Help entries of the objects that compute: material, hertz, model, contact, wear. Form: help.lua.
-- Each: { address, kind=, type=, unit=, default=, values=, class=, use=, text= }. The equations are
-- those of Mattei and Di Puccio, "Influence of the wear partition factor on wear evolution
-- modelling of sliding surfaces".

return {
  -- --- material -------------------------------------------------------------------------------
  { "material", kind = "constructor", use = "material{ E=200e3, nu=0.3 }",
    text = "A linear elastic material. The defaults are the reference case's steel." },
  { "material{E}", type = "number > 0", unit = "MPa", default = "200e3",
    text = "Young's modulus." },
  { "material{nu}", type = "number, -1 < nu < 0.5", default = 0.3, text = "Poisson's ratio." },
  { "material.E", kind = "field", unit = "MPa", text = "Young's modulus." },
  { "material.nu", kind = "field", text = "Poisson's ratio." },
  { "material.E_star", kind = "field", unit = "MPa",
    text = "Plane-strain modulus E / (1 - nu^2)." },

  -- --- hertz ----------------------------------------------------------------------------------
  { "hertz", kind = "constructor", use = "hertz{ radius=10, load=100 }",
    text = "Hertz' closed form for the line contact of a cylinder on a half-space: what an unworn "
      .. "contact is measured by." },
  { "hertz{radius}", type = "number > 0", unit = "mm", default = 10,
    text = "Radius of the cylinder." },
  { "hertz{load}", type = "number > 0", unit = "N", default = 100,
    text = "Normal load L_N over the whole thickness." },
  { "hertz{cylinder}", type = "material", class = "material", default = "material{}",
    text = "Material of the cylinder." },
  { "hertz{plate}", type = "material", class = "material", default = "material{}",
    text = "Material of the plate." },
  { "hertz{thickness}", type = "number > 0", unit = "mm", default = 1,
    text = "Thickness of both bodies; the load per thickness counts." },
  { "hertz.half_width", kind = "field", unit = "mm",
    text = "Half width of the contact, a = sqrt(4 R L_N / (pi t E*))." },
  { "hertz.p_max", kind = "field", unit = "MPa",
    text = "Pressure at the centre, p_H = 2 L_N / (pi a t)." },
  { "hertz.E_star", kind = "field", unit = "MPa",
    text = "Contact modulus 1 / (1/E*_c + 1/E*_p) of the pair." },
  { "hertz.radius", kind = "field", unit = "mm", text = "Radius of the cylinder." },
  { "hertz.load", kind = "field", unit = "N", text = "Normal load." },
  { "hertz.thickness", kind = "field", unit = "mm", text = "Thickness of both bodies." },
  { "hertz.cylinder", kind = "field", class = "material", text = "Material of the cylinder." },
  { "hertz.plate", kind = "field", class = "material", text = "Material of the plate." },

  -- --- model ----------------------------------------------------------------------------------
  { "model", kind = "constructor", use = "model{ radius=10, mesh={ size=0.020 } }",
    text = "The two elastic bodies, meshed and condensed once: a half cylinder, its flat top built "
      .. "in, on a plate 2 radius wide and radius high. A model never changes, so that any number of "
      .. "contact and wear objects share one. Plane strain." },
  { "model{radius}", type = "number > 0", unit = "mm", default = 10,
    text = "Radius R of the cylinder; it sets the size of the plate too." },
  { "model{cylinder}", type = "material", class = "material", default = "material{}",
    text = "Material of the cylinder." },
  { "model{plate}", type = "material", class = "material", default = "material{}",
    text = "Material of the plate." },
  { "model{thickness}", type = "number > 0", unit = "mm", default = 1,
    text = "Thickness of both bodies." },
  { "model{mesh}", type = "table", text = "How fine the meshes are." },
  { "model{mesh.size}", type = "number > 0", unit = "mm", default = 0.020,
    text = "Width of the elements at the contact." },
  { "model{mesh.height}", type = "number > 0", unit = "mm", default = "1.25 size",
    text = "Height of the elements at the contact." },
  { "model{mesh.far}", type = "number > 0", unit = "mm", default = 1.0,
    text = "Largest size of the elements far from the contact." },
  { "model{mesh.zone}", type = "table { cylinder=, plate= }", unit = "mm",
    text = "Full width of the fine contact zone of each body. Depth and margins of the finer parts "
      .. "scale with the cylinder's. Contact cannot be found outside; an error then names the zone it "
      .. "needs." },
  { "model{mesh.zone.cylinder}", type = "number > 0", unit = "mm", default = 1.0,
    text = "Full width of the fine contact zone of the cylinder." },
  { "model{mesh.zone.plate}", type = "number > 0", unit = "mm", default = 1.2,
    text = "Full width of the fine contact zone of the plate; it holds the contact at both ends of "
      .. "the stroke." },
  { "model{mesh.rows}", type = "whole number >= 1", default = 3,
    text = "Element rows of the wear box: its nodes move with the worn surface." },
  { "model{mesh.element}", values = { "CPE4", "CPE4I" }, default = "CPE4",
    text = "Quadrilateral formulation: fully integrated bilinear, or with incompatible modes, which "
      .. "bend freely. Triangles are CPE3." },
  { "model.radius", kind = "field", unit = "mm", text = "Radius of the cylinder." },
  { "model.thickness", kind = "field", unit = "mm", text = "Thickness of both bodies." },
  { "model.cylinder", kind = "field", class = "material", text = "Material of the cylinder." },
  { "model.plate", kind = "field", class = "material", text = "Material of the plate." },
  { "model.seconds", kind = "field", unit = "s", text = "Time it took to build." },
  { "model.bytes", kind = "field", unit = "bytes", text = "Memory it takes." },
  { "model.close", kind = "method", use = "m:close()",
    text = "Lets go of it now instead of when it is collected; runs and contacts on it stay." },
  { "model.mesh", kind = "field",
    text = "The two meshes, m.mesh.cylinder and m.mesh.plate, and their definition: size, height, far, "
      .. "zone, rows, element." },
  { "model.mesh.cylinder", kind = "field", class = "mesh", text = "Mesh of the half cylinder." },
  { "model.mesh.plate", kind = "field", class = "mesh", text = "Mesh of the plate." },

  -- --- mesh -----------------------------------------------------------------------------------
  { "mesh", kind = "object", use = "m.mesh.cylinder, m.mesh.plate",
    text = "Finite elements of one body, an exact mirror image about x = 0. The origin is the first "
      .. "point of contact, x along the plate's surface, y up." },
  { "mesh.nodes", kind = "field", text = "Number of nodes." },
  { "mesh.quads", kind = "field", text = "Number of quadrilaterals." },
  { "mesh.triangles", kind = "field", text = "Number of triangles." },
  { "mesh.elements_count", kind = "field", text = "Number of elements: quads and triangles." },
  { "mesh.rows", kind = "field", text = "Element rows of the wear box." },
  { "mesh.body", kind = "field", text = '"cylinder" or "plate".' },
  { "mesh.radius", kind = "field", unit = "mm", text = "Radius of the cylinder." },
  { "mesh.quality", kind = "method", use = "m.mesh.plate:quality()",
    text = "Smallest and largest angle (degrees), aspect ratio, and Jacobian ratio of the worst "
      .. "elements, as a table." },
  { "mesh.write", kind = "method", use = "m.mesh.plate:write(path)",
    text = "Writes the mesh to a file, by its ending: .vtk, .inp (Abaqus, CalculiX) or .csv (nodes)." },
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
    text = "One frictionless contact solution: the plate at x, pressed by the load. Without a model "
      .. "it uses one whose zones suit." },
  { "contact{model}", type = "model, or table of its fields", class = "model",
    text = "The bodies. One is built where none is given." },
  { "contact{load}", type = "number > 0", unit = "N", default = 100, text = "Normal load L_N." },
  { "contact{x}", type = "number", unit = "mm", default = 0, text = "Position of the plate." },
  { "contact{worn}", type = "wear, or table { cylinder=, plate= }", class = "wear",
    text = "Shape of the surfaces: that of a wear run; or for each body a function f(x) that gives "
      .. "the depth, or a measured profile { x={...}, h={...} }, in mm. Left out: unworn." },
  { "contact{worn.cylinder}", type = "function(x) or table { x=, h= }", unit = "mm",
    text = "Wear depth of the cylinder against x." },
  { "contact{worn.plate}", type = "function(x) or table { x=, h= }", unit = "mm",
    text = "Wear depth of the plate against x." },
  { "contact.half_width", kind = "field", unit = "mm",
    text = "Half the width of the contact, interpolated between nodes." },
  { "contact.p_max", kind = "field", unit = "MPa", text = "Largest pressure." },
  { "contact.p_center", kind = "field", unit = "MPa",
    text = "Pressure at the lowest point of the cylinder." },
  { "contact.load", kind = "field", unit = "N", text = "Normal load." },
  { "contact.x", kind = "field", unit = "mm", text = "Position of the plate." },
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
  { "contact.stress", kind = "method", class = "stress", use = "c:stress()",
    text = "Displacements and stresses inside both bodies: a field for plot.stress, export.vtk and export.csv." },
  { "contact.close", kind = "method", use = "c:close()",
    text = "Lets go of it now instead of when it is collected." },
  { "stress", kind = "object", use = "f = c:stress()",
    text = "Fields on both bodies, f.cylinder and f.plate: lists x, y (mm, nodes), ux, uy (mm, "
      .. "displacements), mises, shear, sxx, syy, szz, sxy (MPa, averages at nodes), elements (four "
      .. "corners each)." },
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
  { "wear{model}", type = "model, or table of its fields", class = "model",
    text = "The bodies. Without it one is built on first use whose contact zones suit the stroke." },
  { "wear{k}", type = "number >= 0, function(state), or table { distance=, value= }",
    unit = "mm2/N", default = "1e-8",
    text = "Wear coefficient k of the couple: volume = k L_N d (Eq. 1). A function gets the state in "
      .. "the middle of the update, see help \"state\"; a table is interpolated over the distance." },
  { "wear{alpha}", type = "number 0 ... 1, function(state), or table { distance=, value= }",
    default = 0.5,
    text = "Wear partition factor k_c / k (Eq. 19): the share of the volume that the cylinder loses. "
      .. "0: only the plate wears, 1: only the cylinder." },
  { "wear{load}", type = "number > 0", unit = "N", default = 100, text = "Normal load L_N." },
  { "wear{stroke}", type = "number > 0", unit = "mm", default = 0.11,
    text = "Stroke s_t, the plate's way from one end to the other. The reference cases are a, 2a, 4a "
      .. "(0.11, 0.22, 0.44) and 2R (20): the last slides over the whole plate, one way only (r = 1 "
      .. "instead of 2)." },
  { "wear{distance}", type = "number > 0", unit = "mm", default = 1320,
    text = "Travelled distance d_t to simulate. Give this or cycles." },
  { "wear{cycles}", type = "number > 0", unit = "cycles",
    text = "Loading cycles to simulate, N = d_t / (r s_t) (Eq. 21). Give this or distance." },
  { "wear{jump}", type = 'number > 0, "auto", or function(state)', values = { "auto" },
    unit = "cycles", default = 100,
    text = "Cycles from one geometry update to the next (N-bar). Pressures are kept meanwhile. Too "
      .. 'large a jump makes explicit updates rough; "auto" stays below that limit. A function gets '
      .. "the state before the update." },
  { "wear{increments}", type = "even number >= 2", default = 100,
    text = "Increments n_c of a full cycle. Half of them are simulated, the way back being like the "
      .. "way out (Eq. 22)." },
  { "wear{procedure}", values = { "auto", "SP", "NSP" }, default = '"auto"',
    text = "SP simulates the sliding plate (Eq. 22); NSP solves one contact an update, right where "
      .. 'the plate stays flat: alpha = 1, or a stroke of 2 radius (Eqs. 24-27). "auto" chooses.' },
  { "wear{scheme}", values = { "explicit", "implicit" }, default = '"explicit"',
    text = "Pressures of an update: those of the geometry it begins with, or those of the geometry "
      .. "it ends in, which takes longer steps." },
  { "wear{tolerance}", type = "number > 0",
    text = "Relative error an implicit run may make in the depth; it then chooses its own steps." },
  { "wear{order}", type = "1 or 2", default = 2,
    text = "Order of the implicit scheme: pressures of the end of the update, or midway." },
  { "wear{update}", values = { "cycle", "increment" }, default = '"cycle"',
    text = "When the geometry is updated: after jump cycles together, or at every increment "
      .. "(quasi-continuous)." },
  { "wear{law}", values = { "archard", "power", "threshold" }, default = '"archard"',
    text = "Wear law, as a factor on k: 1; (p / p0)^m; or 1 where p > p0 and 0 elsewhere." },
  { "wear{law_pressure}", type = "number > 0", unit = "MPa", default = 100,
    text = "Pressure p0 of the law." },
  { "wear{law_exponent}", type = "number > -1", default = 1,
    text = "Exponent m of the power law." },
  { "wear{k.distance}", type = "list", unit = "mm",
    text = "Increasing distances of a k that is given as a table; linear between them." },
  { "wear{k.value}", type = "list", unit = "mm2/N", text = "Its values there." },
  { "wear{alpha.distance}", type = "list", unit = "mm",
    text = "Increasing distances of an alpha that is given as a table; linear between them." },
  { "wear{alpha.value}", type = "list", text = "Its values there." },
  { "wear{slip}", values = { "rigid", "total" }, default = '"rigid"',
    text = "Sliding distance of an increment: the motion of the plate, or with the elastic part "
      .. "added. With the rigid one the volume is k L_N d to rounding." },
  { "wear{rule}", values = { "trapezoid", "simple" }, default = '"trapezoid"',
    text = "Integration over the increments: Eq. (4) or Eq. (5)." },
  { "wear{geometry}", values = { "moving", "frozen" }, default = '"moving"',
    text = "Whether the worn nodes change the stiffness of the surface layer, or the gap alone." },
  { "wear{refresh}", type = "number >= 0",
    text = "With moving geometry: the stiffness is renewed once a node has moved by more than this "
      .. "share of an element's height. 0 renews it at every update." },
  { "wear{loading}", type = "block { x=, load=, ... }, or list of blocks",
    text = "A cycle of your own instead of stroke and load: x and load as functions of t, which goes "
      .. "from 0 to 1 over the cycle, or as sampled lists. Both strokes are simulated as they are. "
      .. "Functions are called once, when the run is made. Several blocks in a list follow each "
      .. "other, each with its cycles. Without a distance the run ends with the last block; where "
      .. "that has no cycles, it goes on to the end of the distance. The pressures and widths that "
      .. "a run tells are those under load, which by default is the largest of the loading. "
      .. "\n\ncsv.read(path) reads measured lists." },
  { "wear{loading.x}", type = "function(t) or list", unit = "mm",
    text = "Position of the plate over the cycle." },
  { "wear{loading.load}", type = "function(t), list or number", unit = "N",
    default = "that of the run", text = "Normal load over the cycle; 0 lifts off: no contact, no wear." },
  { "wear{loading.t}", type = "list",
    text = "Increasing times of the lists, in any unit: the first is the start of the cycle (t = 0), "
      .. "the last its end (t = 1). Left out: the points lie evenly in time." },
  { "wear{loading.increments}", type = "whole number >= 1", default = 100,
    text = "Even increments of the cycle, at whose ends functions are called and lists interpolated. "
      .. "Left out: lists are taken point by point, functions at their times." },
  { "wear{loading.cycles}", type = "number > 0", unit = "cycles",
    text = "How often the cycle is repeated. The last block may be without: it goes on to the end." },
  { "wear{loading.periodic}", type = "boolean", default = true,
    text = "false: one generic history, with a geometry update at every increment (Eqs. 4-8)." },
  { "wear{local_factor}", type = "function(body, x, p, state), or { vector = function }",
    text = 'Factor on k at each node, for cross-shear and the like. body is "cylinder" or "plate", x '
      .. "the node's own position in mm, p its pressure in MPa; the result is 0 or above. Nodes "
      .. "without pressure are not asked: they do not wear. It is called at every increment." },
  { "wear{local_factor.vector}", type = "function(body, xs, ps, state)",
    text = "The same for all nodes under pressure in one call, for factors that hang together: xs and "
      .. "ps are lists, the result is the list of factors, and may be ps itself." },
  { "wear{worn}", type = "wear, or table { cylinder=, plate= }", class = "wear",
    text = "Shape to start from, as in contact{worn}. Depths and alpha-tilde count from the unworn "
      .. "shape, volumes from this one." },
  { "wear{worn.cylinder}", type = "function(x) or table { x=, h= }", unit = "mm",
    text = "Wear depth of the cylinder to start from." },
  { "wear{worn.plate}", type = "function(x) or table { x=, h= }", unit = "mm",
    text = "Wear depth of the plate to start from." },

  { "wear.step", kind = "method", use = "w:step(n)",
    text = "Makes n geometry updates (1 without n), each of jump cycles, the last one shorter so "
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
      .. "worn. What is not given stays; the worn shapes and the history stay too. A new loading "
      .. "begins at its start, loading=false and stroke go back to the plain stroke. distance and "
      .. "cycles count from the start of the run. Returns the run." },
  { "wear.clone", kind = "method", class = "wear", use = "w:clone()",
    text = "A copy that goes its own way: for a before and after, or for two futures of one past." },
  { "wear.close", kind = "method", use = "w:close()",
    text = "Lets go of it now instead of when it is collected." },
  { "wear.contact", kind = "method", class = "contact", use = "w:contact()",
    text = "The contact on the present shape: plate at x = 0, nominal load." },
  { "wear.save", kind = "method", use = "w:save(path)",
    text = "Writes the run, with all it needs to go on, to a run file; wear.open reads it. A run "
      .. "that was saved there before is replaced, anything else is refused." },
  { "wear.open", kind = "function", class = "wear", use = "w = wear.open(path, case)",
    text = "Reads a run that w:save wrote, or a case of a study by its number; it goes on to the "
      .. "same numbers. Functions in its definition cannot be stored: give them again, "
      .. "wear.open(path, { k = f })." },
  { "wear.profile", kind = "method", values = { "cylinder", "plate" },
    use = 'w:profile("cylinder" | "plate")',
    text = "Worn profile of a body: { x=, h=, y= } in mm; h is the wear depth, y the present height "
      .. "of the surface." },
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
  { "wear.stability", kind = "method", use = "w:stability()",
    text = "{ eigenvalue=, jump_limit= }: the growth rate of ripples in 1/cycle, linearised about the "
      .. "present state, and 2 / eigenvalue. Explicit updates with a larger jump get rough." },
  { "wear.model", kind = "field", class = "model", text = "The model it runs on." },
  { "wear.distance", kind = "field", unit = "mm", text = "Travelled distance so far." },
  { "wear.cycle", kind = "field", unit = "cycles", text = "Loading cycles so far." },
  { "wear.update", kind = "field", text = "Geometry updates so far." },
  { "wear.solutions", kind = "field", text = "Contacts solved so far." },
  { "wear.done", kind = "field", text = "Whether the whole distance has been travelled." },
  { "wear.p_center", kind = "field", unit = "MPa",
    text = "Pressure at the centre, plate at x = 0, nominal load." },
  { "wear.p_max", kind = "field", unit = "MPa",
    text = "Largest pressure, plate at x = 0, nominal load." },
  { "wear.half_width", kind = "field", unit = "mm",
    text = "Half the width of the contact, plate at x = 0, nominal load." },
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
  { "wear.history", kind = "field",
    keys = { "update", "cycle", "distance", "jump", "k", "alpha", "p_center", "p_max", "half_width",
      "depth_cylinder", "depth_plate", "volume_cylinder", "volume_plate", "depth_partition",
      "error", "solutions" },
    text = "Columns by name, one value for each update from 0 on: " .. [[

  update, cycle, distance (mm), jump   p_center, p_max (MPa), half_width (mm)
  depth_cylinder, depth_plate (mm)     volume_cylinder, volume_plate (mm3)
  depth_partition, k, alpha            solutions (contacts solved so far)
  error (of adaptive steps, as a share of the tolerance)]] },

  -- --- the definition, read back --------------------------------------------------------------
  { "wear.k", kind = "field", unit = "mm2/N", text = "Wear coefficient of the couple." },
  { "wear.alpha", kind = "field", text = "Wear partition factor." },
  { "wear.load", kind = "field", unit = "N", text = "Normal load." },
  { "wear.stroke", kind = "field", unit = "mm", text = "Stroke." },
  { "wear.strokes", kind = "field", text = "Strokes of a cycle, r of Eq. (21): 2, or 1 at 2 radius." },
  { "wear.cycles", kind = "field", unit = "cycles", text = "Cycles of the whole distance (Eq. 21)." },
  { "wear.total_distance", kind = "field", unit = "mm", text = "Travelled distance to simulate." },
  { "wear.jump", kind = "field", unit = "cycles", text = "Cycles from one update to the next." },
  { "wear.increments", kind = "field", text = "Increments of a full cycle." },
  { "wear.procedure", kind = "field", text = 'The one chosen, "SP" or "NSP".' },
  { "wear.scheme", kind = "field", text = '"explicit" or "implicit".' },
  { "wear.slip", kind = "field", text = '"rigid" or "total".' },
  { "wear.rule", kind = "field", text = '"trapezoid" or "simple".' },
  { "wear.geometry", kind = "field", text = '"moving" or "frozen".' },
  { "wear.law", kind = "field", text = "The wear law, see wear{law}." },
  { "wear.law_pressure", kind = "field", unit = "MPa", text = "See wear{law_pressure}." },
  { "wear.law_exponent", kind = "field", text = "See wear{law_exponent}." },
  { "wear.order", kind = "field", text = "Order of the implicit scheme." },
  { "wear.tolerance", kind = "field", text = "See wear{tolerance}; 0: steps of jump." },
  { "wear.update_at", kind = "field", text = '"cycle" or "increment", see wear{update}.' },
  { "wear.refresh", kind = "field", text = "When the stiffness is renewed, see wear{refresh}." },
  { "wear.loading", kind = "field",
    text = "The blocks of loading as they were sampled, each { x=, load=, cycles=, periodic= }; false "
      .. "for the plain stroke." },
  { "wear.local_factor", kind = "field", text = "The function, or false." },
  { "wear.functions", kind = "field",
    text = 'List of the fields that are functions, "k", "alpha", "jump", "local_factor": what no file '
      .. "can hold." },

  -- --- state ----------------------------------------------------------------------------------
  { "state", kind = "object", use = "wear{ k = function(state) ... end }",
    text = "What functions of the state get. It can be read during the call only. For k and alpha it "
      .. "is the middle of the update, with distance, cycle, depths and volumes predicted to second "
      .. "order; for jump and local_factor, and all that is not predicted, the last record." },
  { "state.distance", kind = "field", unit = "mm", text = "Travelled distance." },
  { "state.cycle", kind = "field", unit = "cycles", text = "Loading cycles." },
  { "state.update", kind = "field", text = "Geometry updates so far." },
  { "state.depth", kind = "field", unit = "mm", text = "Largest wear depths, { cylinder=, plate= }." },
  { "state.volume", kind = "field", unit = "mm3", text = "Wear volumes, { cylinder=, plate=, total= }." },
  { "state.depth_cylinder", kind = "field", unit = "mm", text = "The same number, a little faster." },
  { "state.depth_plate", kind = "field", unit = "mm", text = "The same number, a little faster." },
  { "state.volume_cylinder", kind = "field", unit = "mm3", text = "The same number, a little faster." },
  { "state.volume_plate", kind = "field", unit = "mm3", text = "The same number, a little faster." },
  { "state.depth_partition", kind = "field", text = "Wear depth partition factor; NaN before any wear." },
  { "state.p_center", kind = "field", unit = "MPa", text = "Pressure at the centre." },
  { "state.p_max", kind = "field", unit = "MPa", text = "Largest pressure." },
  { "state.half_width", kind = "field", unit = "mm", text = "Half the width of the contact." },
  { "state.k", kind = "field", unit = "mm2/N", text = "Wear coefficient of the last update." },
  { "state.alpha", kind = "field", text = "Partition factor of the last update." },
  { "state.jump", kind = "field", unit = "cycles", text = "Cycles of the last update." },
  { "state.error", kind = "field", text = "Estimated error of the last adaptive step, over its tolerance." },
  { "state.solutions", kind = "field", text = "Contacts solved so far." },
}

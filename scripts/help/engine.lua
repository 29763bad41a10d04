-- Help entries of the objects material, hertz, model, body, mesh, contact, stress, wear and state. Each entry
-- is { address, kind=, type=, unit=, default=, values=, class=, use=, text= }; help/init.lua explains
-- addresses and fields. Equation numbers refer to Mattei and Di Puccio, "Influence of the wear partition
-- factor on wear evolution modelling of sliding surfaces".

local of_all = '. Fields of every body: E, nu, k or material, layers, name; see help "body".'

return {
  -- --- material -------------------------------------------------------------------------------
  { "material", kind = "constructor", use = "material{ E=200e3, nu=0.3, k=1e-9 }",
    text = "A linear elastic material with its wear coefficient k, for example material{ E=114e3, nu=0.34, "
      .. 'name="Ti-6Al-4V" }. Use it in a model, model{ cylinder=material{...} }, in a body or in a layer. The '
      .. "defaults describe the steel of the reference case; archard has no library of materials." },
  { "material.E_star", kind = "field", unit = "MPa",
    text = "Plane-strain modulus E / (1 - nu^2)." },

  -- --- hertz ----------------------------------------------------------------------------------
  { "hertz", kind = "constructor", use = "hertz{ radius=10, load=100 }",
    text = "Hertz' closed-form solution for the contact with a flat: of a cylinder (line contact) or, with "
      .. 'geometry = "axisymmetric" or "3-D", of a ball or crowned roller. Use it to check the pressure and '
      .. "half width of an unworn contact." },
  { "hertz.half_width", kind = "field", unit = "mm",
    text = "Half width of the contact: a = sqrt(4 R L_N / (pi t E*)) for a cylinder, a = cbrt(3 R L_N / (4 E*)) "
      .. "for a ball, with the radius R, load L_N, thickness t and contact modulus E*." },
  { "hertz.half_width_z", kind = "field", unit = "mm",
    text = 'Half width of the contact across the motion (along z), with geometry = "3-D"; NaN for a cylinder.' },
  { "hertz.p_max", kind = "field", unit = "MPa",
    text = "Largest pressure, at the centre of the contact: p_H = 2 L_N / (pi a t) for a cylinder, p_H = 3 L_N / "
      .. "(2 pi a^2) for a ball, with the load L_N, half width a and thickness t." },
  { "hertz.E_star", kind = "field", unit = "MPa",
    text = "Contact modulus E* of the cylinder (c) and the plate (p), 1/E* = 1/E*_c + 1/E*_p. The modulus of each "
      .. "body is E / (1 - nu^2), or E in plane stress." },
  { "hertz.approach", kind = "field", unit = "mm",
    text = "Distance by which a ball and its plate approach each other: a^2 / R, with the half width a and the "
      .. "radius R. NaN for a cylinder: its approach is not defined on a half-space." },

  -- --- model ----------------------------------------------------------------------------------
  { "model", kind = "constructor", use = "model{ radius=10, mesh={ fineness=2 } }",
    text = "The two elastic bodies. They are meshed with finite elements, whose stiffness is condensed to the "
      .. "surface nodes. The default is a half cylinder, fixed at its flat top, on a plate, in plane strain; the "
      .. "plate is twice as wide and once as high as the cylinder's radius. A model does not change; several "
      .. 'contacts and runs can share a model. Other geometries: help "axisymmetric". mesh = "pair.msh" reads both '
      .. 'bodies from a Gmsh file: help "gmsh". Bodies with different materials and wear coefficients: model{ '
      .. "cylinder={ E=200e3, nu=0.3, k=1e-9 }, plate={ E=114e3, nu=0.34, k=1e-8 } }. Contacts and runs with "
      .. "friction include the coupling of pressure and shear between different materials (Dundurs' beta)." },
  { "model.upper", kind = "field", text = "Definition of the upper body; nil for the default cylinder." },
  { "model.lower", kind = "field", text = "Definition of the lower body; nil for the default block." },
  { "model.bodies", kind = "field",
    text = "Names of the bodies, m.bodies.upper and m.bodies.lower. A body has the name that its definition sets, "
      .. 'as in body.disc{ name="pin" }; without a name it is called by its kind, such as "ring", or "upper" and '
      .. '"lower". The default bodies are "cylinder" and "plate". Results accept all these names: w.depth.pin, '
      .. 'w.depth.upper, w:profile("pin"), m.mesh.pin, state.depth.pin, plot.history(w, "depth_pin").' },
  { "body", kind = "module", use = "model{ upper = body.punch{ flat=1, radius=2 }, lower = body.block{} }",
    text = "Bodies of a model{ upper=, lower= }, with layers (coatings) if needed. The upper body carries the "
      .. "load, the lower body moves. Each body accepts E, nu, k or material=, and layers = {{ thickness=, "
      .. "material= }, ...} from the surface inwards; each layer wears with its own k. A mesh from Gmsh has "
      .. "materials = { NAME = } instead of layers." },
  { "body{layers}", type = "list of tables { thickness=, material= }",
    text = "Layers such as coatings on the body, at most four, in order from the surface inwards. A layer wears "
      .. "with the k of its material, if the material has one. For example, a plate with a coating of 5 um: w = "
      .. "wear{ model={ lower=body.block{ k=1e-8, layers={{ thickness=0.005, material=material{ E=300e3, nu=0.2, "
      .. "k=1e-10 } }} } } }. w:run{ depth={ plate=0.005 } } stops when the coating is worn through." },
  { "body.cylinder", kind = "function", use = "body.cylinder{ radius=10 }", result = "table",
    text = "A half cylinder, fixed at its flat side. Two other supports are for a pin in a bush: with hold = "
      .. '"free" the flat side can slide sideways except in its middle, with hold = "hub" the body is a '
      .. "whole disc around a rigid hub. Fields: radius, hold" .. of_all },
  { "body.ball", kind = "function", use = "body.ball{ radius=10, radius_z=50 }", result = "table",
    text = 'A ball, crowned roller or ellipsoid for model{ geometry="3-D" }, whose surface has the height '
      .. "x^2 / (2 radius) + z^2 / (2 radius_z); z is across the motion. By default radius_z is equal to "
      .. "radius, for a ball. Fields: radius, radius_z" .. of_all },
  { "body.block", kind = "function", use = "body.block{ width=20, height=10 }", result = "table",
    text = 'A block, fixed at its base or, as the upper body, at its top. With geometry="3-D" it is a half-space '
      .. "or, if a height is given, a layer on a rigid base. Fields: width, height" .. of_all },
  { "body.punch", kind = "function", use = "body.punch{ flat=1, radius=2, height=10 }", result = "table",
    text = "A block with a flat contact face of the full width `flat` [mm], between edges that are rounded by "
      .. "`radius` [mm]. The contact may grow over 0.8 of each radius; a run ends there, at a depth of at most 0.4 "
      .. "radius. Flat pins of a constant section, worn to a larger depth, cannot be modelled. Fields: flat, radius, "
      .. "height" .. of_all },
  { "body.profile", kind = "function", use = "body.profile{ y=function(x) return 1e-4*math.cos(60*x) end }",
    result = "table",
    text = "A block whose surface has a profile: heights in mm, positive out of the body, as a function "
      .. "y(x), as lists x and y, or as a measured trace, body.profile(profile.read(path)). Fields: width, "
      .. "height, y, x" .. of_all },
  { "body.map", kind = "function", use = 'body.map{ y=map.read("ball.sdf"):level("sphere"), radius=10 }', result = "table",
    text = 'A measured or computed rough surface for model{ geometry="3-D" }, as upper or lower body: a map, '
      .. "or the fields of map{ x=, z=, y= }. The heights are positive out of the body, on a grid with "
      .. "constant steps, and interpolated by cubic polynomials. With radius (and radius_z) the heights are "
      .. "added to a ball. The bodies touch near x = z = 0, which should be the middle of the map, because "
      .. "the contact must be within the map. Fields: x, z, y, radius, radius_z" .. of_all },
  { "body.disc", kind = "function", use = "body.disc{ radius=9.95 }", result = "table",
    text = "A full disc, fixed at a hub in its centre; the radius of the hub is 0.15 times the radius of the disc. "
      .. "Fields: radius" .. of_all },
  { "body.ring", kind = "function", use = 'body.ring{ inner=10, outer=20, fixed="outer" }', result = "table",
    text = 'A ring. With fixed="outer" its hole is in contact with a disc, a cylinder or an inner ring. The '
      .. "contact is then solved along the surface of the hole, where x is the arc length; friction is not "
      .. "available. Fields: inner, outer, fixed" .. of_all },
  { "body.gmsh", kind = "function", use = "body.gmsh{ name=, E=, materials={ coating={ E=400e3 } } }",
    result = "table",
    text = "Properties of a body whose mesh is read from the Gmsh file of model{ mesh = }. The field "
      .. 'materials assigns a material to each physical group by its name: help "gmsh".' },
  { "model.seconds", kind = "field", unit = "s", text = "Computing time for building the model." },
  { "model.bytes", kind = "field", unit = "bytes", text = "Memory used by the model." },
  { "model.close", kind = "method", use = "m:close()",
    text = "Frees the memory of the model now instead of at the next garbage collection. Runs and contacts that "
      .. "use the model stay valid." },
  { "model.mesh", kind = "field",
    text = "The meshes m.mesh.cylinder and m.mesh.plate, and the mesh settings size, height, fineness, far, zone, "
      .. 'rows and element, with the values that were chosen for "auto".' },
  { "model.mesh.cylinder", kind = "field", class = "mesh", text = "Mesh of the half cylinder." },
  { "model.mesh.plate", kind = "field", class = "mesh", text = "Mesh of the plate." },

  -- --- mesh -----------------------------------------------------------------------------------
  { "mesh", kind = "object", use = "m.mesh.cylinder, m.mesh.plate",
    text = "Finite element mesh of one body, symmetric about x = 0. The origin is the first point of contact; x is "
      .. "along the plate's surface, y points upwards. The meshes of a run, w.mesh.cylinder and w.mesh.plate, have "
      .. "the worn positions of the nodes. model{ mesh={ size=, zone= } } defines it: help \"meshes\"." },
  { "mesh.nodes", kind = "field", text = "Number of nodes." },
  { "mesh.quads", kind = "field", text = "Number of quadrilaterals." },
  { "mesh.triangles", kind = "field", text = "Number of triangles." },
  { "mesh.elements_count", kind = "field", text = "Number of elements, quadrilaterals and triangles." },
  { "mesh.element", kind = "field",
    text = 'Type of the elements, as named in Abaqus: "CPE4" or "CPE4I" in plane strain, "CPS4" in plane stress, '
      .. '"CAX4" in bodies of revolution.' },
  { "mesh.rows", kind = "field", text = "Number of element rows in the wear box, the regular elements below the surface." },
  { "mesh.body", kind = "field", text = 'Name of the body, "cylinder" or "plate".' },
  { "mesh.radius", kind = "field", unit = "mm", text = "Radius of the cylinder." },
  { "mesh.quality", kind = "method", use = "m.mesh.plate:quality()",
    text = "Returns the values of the worst elements in a table: smallest_angle and largest_angle [degrees], "
      .. "aspect (longest edge over shortest), jacobian_ratio (smallest Jacobian over the largest, at the corners "
      .. "of a quadrilateral) and smallest_jacobian [mm2], positive in a valid mesh. The field box of the table "
      .. "has the same values for the wear box alone." },
  { "mesh.write", kind = "method", use = "m.mesh.plate:write(path)",
    text = "Writes the mesh to a file. The ending chooses the format: .vtk, .vtu, .inp (Abaqus, CalculiX), .msh "
      .. "(Gmsh) or .csv (nodes)." },
  { "mesh.node", kind = "method", use = "x, y = m.mesh.plate:node(i)",
    text = "Position of node i = 1 ... nodes, in mm." },
  { "mesh.elements", kind = "method", use = "m.mesh.plate:elements()",
    text = "Node numbers (from 1) of the corners of all elements in one list, four for each element; the fourth "
      .. "number of a triangle is 0." },
  { "mesh.coordinates", kind = "method", use = "m.mesh.plate:coordinates()",
    text = "Positions of all nodes, { x=, y= } in mm." },
  { "mesh.surface", kind = "method", use = "m.mesh.plate:surface()",
    text = "Numbers of the surface nodes that may be in contact, in the order of increasing x." },
  { "mesh.box", kind = "method", use = "m.mesh.plate:box()",
    text = "Numbers of the nodes of the wear box: for each surface node, a column of rows + 1 nodes from the "
      .. "surface inwards." },
  { "mesh.outline", kind = "method", use = "m.mesh.plate:outline()",
    text = "Numbers of the boundary nodes, counter-clockwise." },
  { "mesh.fixed", kind = "method", use = "m.mesh.plate:fixed()",
    text = "Numbers of the fixed nodes." },
  { "mesh.close", kind = "method", use = "mesh:close()",
    text = "Frees the memory of the mesh now instead of at the next garbage collection." },

  -- --- contact --------------------------------------------------------------------------------
  { "contact", kind = "constructor", use = "c = contact{ load=100, x=0 }",
    text = "One solved contact: the load presses both bodies together, with the plate at position x. c:move "
      .. "continues from the contact c. If no model is given, a model with suitable contact zones is built. With "
      .. "friction, shear, slip and tangential force are positive when the plate is pushed along +x." },
  { "contact{worn.cylinder}", type = "function(x) or table { x=, h= }", unit = "mm",
    text = "Wear depth of the cylinder against x. A function is evaluated at the nodes. The points of a table are "
      .. "interpolated by splines, which are smooth inside a scar and preserve its area." },
  { "contact{worn.plate}", type = "function(x) or table { x=, h= }", unit = "mm",
    text = "Wear depth of the plate against x. A function is evaluated at the nodes. The points of a table are "
      .. "interpolated by splines, which are smooth inside a scar and preserve its area." },
  { "contact.half_width", kind = "field", unit = "mm",
    text = "Half width of the contact. Its error is at most 0.03 element widths for unworn surfaces and 0.07 for "
      .. "smooth worn surfaces; at edges of scars it is less than 0.12 in the mean, mostly below 0.45, at most 0.75." },
  { "contact.half_width_z", kind = "field", unit = "mm",
    text = "Half width of the contact across the motion, in 3-D; 0 in 2-D." },
  { "contact.area", kind = "field", unit = "mm2", text = "Contact area in 3-D; 0 in 2-D." },
  { "contact.p_max", kind = "field", unit = "MPa",
    text = "Largest nodal pressure. At the edge of a scar it grows as the mesh is refined; use p_average there." },
  { "contact.p_average", kind = "field", unit = "MPa",
    text = "Largest mean pressure over a length, which is set by the field average of contact{}. Unlike "
      .. "p_max, it converges at edges of scars when the mesh is refined." },
  { "contact.p_center", kind = "field", unit = "MPa",
    text = "Pressure at x = 0 of the upper body, which is the lowest point of a cylinder. If the upper body has a "
      .. "profile, the largest pressure may be elsewhere: see p_max." },
  { "contact.normal_force", kind = "field", unit = "N",
    text = "Integral of the pressure over the surface. It equals the load, except in holes: there the pressure has "
      .. "different directions, and the integral is up to 4/pi times the load." },
  { "contact.approach", kind = "field", unit = "mm",
    text = "Distance by which the fixed parts of both bodies approach each other." },
  { "contact.iterations", kind = "field",
    text = "Number of iterations of the active-set method that solved the contact." },
  { "contact.edges", kind = "field", unit = "mm",
    text = "Positions of both edges of the contact, { left=, right= }, measured from the cylinder's axis." },
  { "contact.model", kind = "field", class = "model", text = "The model of the contact." },
  { "contact.pressure", kind = "method", values = { "cylinder", "plate" },
    use = 'c:pressure("cylinder" | "plate")', default = '"cylinder"',
    text = "Pressure at the surface nodes of a body, { x=, p= } in mm and MPa; x is measured from the cylinder's "
      .. "axis." },
  { "contact.move", kind = "method", class = "contact",
    use = "c:move{ x= | tangential=, z= | tangential_z=, load=, increments= }",
    text = "Returns the contact after a motion; c itself is not changed. The plate's base moves to x, or a "
      .. "tangential force moves the plate, and the load may change. Position or force and load change linearly "
      .. "and simultaneously. Coulomb friction depends on the history, so the motion starts from the slip of each "
      .. "node in c. If neither x nor tangential is given, the base does not move. If x exceeds the contact width, "
      .. "the bodies slide on each other. In 3-D z and tangential_z are available too, and the number of "
      .. "increments is chosen automatically; c.energy_error estimates the error. If you set increments in 3-D, "
      .. "the error is proportional to their length where the direction of slip rotates: the work of a force that "
      .. "rotates once in 64 increments is 8 % too small. Close to full slip with nu > 0, the motion under a force "
      .. "is larger than in Mindlin's solution, which neglects slip across the force: by 13 % at 0.9999 times the "
      .. "force of full slip." },
  { "contact.z", kind = "field", unit = "mm",
    text = "Position of the lower body along z, in 3-D with friction; 0 in 2-D." },
  { "contact.tangential_z", kind = "field", unit = "N",
    text = "Tangential force on the lower body along z, in 3-D with friction; 0 in 2-D." },
  { "contact.tangential", kind = "field", unit = "N",
    text = "Tangential force on the plate along x. Without friction it is the x component of the pressure forces "
      .. "on inclined surfaces." },
  { "contact.energy", kind = "field", unit = "N mm",
    text = "Energy dissipated by friction since first contact: shear traction times slip, integrated over the "
      .. "contact. On the automatic mesh of a contact with friction (27 elements in the half width), the energy of "
      .. "a cycle has an error of 0.5 % for similar bodies (Dundurs' beta up to 0.01, such as steels). For other "
      .. "bodies the error is 1.5 % if the force is at least 0.3 times the force of full slip, and 6 % at 0.2 "
      .. "times. On coarser meshes the error depends on the number n of elements that slip at each edge. In "
      .. "partial slip under constant load it is 1.6 % for n = 1 and 0.3 % for n = 3 with similar bodies, and 12 % "
      .. "and 1.5 % with beta up to 0.1. With larger beta, changing loads or edges of scars it is 45 % for n = 1, "
      .. "15 % for n = 1.5 and 6 % for n = 2. In 3-D with 40 cells in the half width, the energy of a loop has an "
      .. "error of 0.4 % if the force is at least 0.2 times the force of full slip; for nu = 0.3 it is 0.2 to 0.4 "
      .. "% below Mindlin's solution, which neglects the slip across the force. For the energy of wear runs see "
      .. "wear.energy and wear.cycle_energy." },
  { "contact.energy_error", kind = "field", unit = "N mm",
    text = "In 3-D: estimated error of contact.energy due to the length of the increments. The estimate is the "
      .. "difference from the energy with half as many increments. It is close to the true error where the "
      .. "direction of slip rotates, and three times the true error elsewhere. Motions whose number of increments "
      .. "you set are not included." },
  { "contact.stick", kind = "field", unit = "mm",
    text = "Stick zones at the end of the motion, a list of { left=, right= } in mm; in 3-D the fraction of the "
      .. "contact area that sticks. In gross slip the list is empty, or the fraction 0. The position of an edge "
      .. "has an error of 0.15 element widths, or 0.3 if fewer than six elements stick. In 3-D the radius of the "
      .. "stick zone under a ball is half_width times the square root of the fraction." },
  { "contact.shear", kind = "method", values = { "cylinder", "plate" },
    use = 'c:shear("cylinder" | "plate")', default = '"cylinder"',
    text = "Shear traction at the surface nodes of a body, lists { x=, q= } in mm and MPa. q is positive along +x "
      .. "on the cylinder and along -x on the plate; |q| is at most friction times the pressure. In 3-D c:shear() "
      .. 'is the map of |q| on the upper body, c:shear("x") and c:shear("z") are maps of its components, c:shear{ '
      .. "z=0 } is a section { x=, q=, qz= }." },
  { "contact.slip", kind = "method", use = "c:slip()",
    text = "Slip since first contact, lists { x=, s= } in mm: displacement of the plate's surface along +x "
      .. "relative to the cylinder's nodes. Nodes out of contact are included. In 3-D c:slip() is a map of the "
      .. 'magnitude of slip, c:slip("x") and c:slip("z") are maps of its components, c:slip{ z=0 } is a section { '
      .. "x=, s=, sz= }." },
  { "contact.stress", kind = "method", class = "stress", use = "c:stress()",
    text = "Displacements and stresses inside both bodies, for plot.stress, export.vtk and export.csv. In "
      .. '3-D the result has the stresses in one plane of one body (body="lower" chooses it): c:stress{ '
      .. "y=-0.05 } is a plane below the surface; c:stress{ z=0 }, the default, and c:stress{ x=0 } are "
      .. "sections down to a depth of three half widths. Its maps sxx, syy, szz, sxy, syz, sxz and mises in "
      .. "MPa are for plot.map; the second axis of a section is y. For f = c:stress() in 2-D this loop "
      .. "computes the largest von Mises stress m of the plate and its depth: local m, depth = 0; for i, s "
      .. "in ipairs(f.plate.mises) do if s > m then m, depth = s, -f.plate.y[i] end end." },
  { "contact.close", kind = "method", use = "c:close()",
    text = "Frees the memory of the contact now instead of at the next garbage collection." },
  { "stress", kind = "object", use = "f = c:stress()",
    text = "Displacements and stresses of both bodies, f.cylinder and f.plate. Each has lists x, y (nodes, mm), "
      .. "ux, uy (displacements, mm), mises (von Mises stress), principal (the largest tension), shear (the "
      .. "largest in the plane), sxx, syy, szz, sxy (all stresses in MPa) and elements (four node numbers each). "
      .. "The error is of second order in the element size. Near a smooth edge of the contact, where the pressure "
      .. "follows a square-root law, the error of stresses is 2 % of the largest pressure on elements of 20 um, or "
      .. "9 % with friction 0.6. At edges of scars the nodal pressures are used without this law." },
  { "stress.cylinder", kind = "field", text = "Displacements and stresses of the cylinder, as lists by name." },
  { "stress.plate", kind = "field", text = "Displacements and stresses of the plate, as lists by name." },
  { "stress.contact", kind = "field", class = "contact", text = "The contact from which the stresses were "
    .. "computed." },

  -- --- wear -----------------------------------------------------------------------------------
  { "wear", kind = "constructor", use = "w = wear{ alpha=0.5, stroke=0.11, distance=1320 }",
    text = "A wear run: two sliding surfaces lose material by Archard's local law. At every point of both bodies "
      .. "the wear depth h is the wear coefficient of the body times the integral of the pressure p over the slip "
      .. "s (Eq. 13). The coefficients are k_c = alpha k for the cylinder and k_p = (1 - alpha) k for the plate "
      .. "(Eq. 20).\n\nThe defaults are the reference case: a steel cylinder of radius 10 mm under 100 N, stroke "
      .. "0.11 mm, alpha 0.5. w:step() and w:run() start the computation." },
  { "wear{loading.x}", type = "function(t) or list", unit = "mm",
    text = "Position of the plate during the cycle: a function of the time t from 0 to 1, or a list of values." },
  { "wear{loading.load}", type = "function(t), list or number", unit = "N",
    default = "load of the run", text = "Normal load during the cycle; 0 means no contact and no wear." },
  { "wear{loading.t}", type = "list",
    text = "Increasing times of the values in the lists, in any unit; the first is the start of the cycle "
      .. "(t = 0), the last its end (t = 1). Default: equal intervals." },
  { "wear{loading.increments}", type = "whole number >= 1", default = 100,
    text = "Number of equal increments of the cycle. Functions are evaluated and lists are interpolated at these "
      .. "increments. If the number is omitted, each interval of a list is an increment, and functions are "
      .. 'evaluated at the times of the list; wear{ increments="auto" } may merge increments.' },
  { "wear{loading.cycles}", type = "number > 0", unit = "cycles",
    text = "Number of repetitions of the cycle. Omit it in the last block, which continues to the end of the run." },
  { "wear{loading.periodic}", type = "boolean", default = true,
    text = "If true, the cycle repeats. If false, it is a single history that does not repeat, with a geometry "
      .. "update at every increment (Eqs. 4-8)." },
  { "wear{local_factor.vector}", type = "function(body, xs, ps, state, zs)",
    text = "Function that computes the factors of all nodes in contact in one call, for factors that depend "
      .. "on neighbours. The lists xs and ps have the positions and pressures of the nodes, in 3-D zs the "
      .. "positions across the motion. The function returns a list of factors; this may be the list ps." },
  { "wear{worn.cylinder}", type = "function(x) or table { x=, h= }", unit = "mm",
    text = "Initial wear depth of the cylinder against x, as in contact{worn.cylinder}." },
  { "wear{worn.plate}", type = "function(x) or table { x=, h= }", unit = "mm",
    text = "Initial wear depth of the plate against x, as in contact{worn.plate}." },

  { "wear.step", kind = "method", use = "w:step(n)",
    text = "Makes n geometry updates (default 1) of `jump` cycles each. If the last update reaches the end of the "
      .. "run, it is shorter. Returns the record of the last update. If a step fails, the run is unchanged." },
  { "wear.run", kind = "method", use = "w:run{ distance= }",
    text = "Continues the run to a distance (default: the distance of the definition), or stops it exactly at a "
      .. "depth, volume, pressure or width: w:run{ depth={ plate=20e-3 } } stops at 20 um. Ctrl-C stops after the "
      .. "current step; another w:run() continues with the same results." },
  { "wear.run{distance}", type = "number > 0", unit = "mm",
    text = "Travelled distance, counted from the start of the run, at which the run stops; default: the "
      .. "distance of the definition." },
  { "wear.run{cycles}", type = "number > 0", unit = "cycles",
    text = "Number of cycles, counted from the start of the run, at which the run stops." },
  { "wear.run{progress}", type = "boolean or function(w)",
    text = "true (default on a terminal): shows a progress bar; false: shows nothing. A function is called with "
      .. "the run after every step and ends the run if it returns true." },
  { "wear.run{depth}", type = "table { cylinder=, plate= }", unit = "mm",
    text = "Stops exactly at this wear depth of a body, or at the distance if the run reaches it first. With this "
      .. 'or another criterion, w:run returns the reason as a second value: "depth.cylinder", "distance", ...' },
  { "wear.run{volume}", type = "table { cylinder=, plate=, total= }", unit = "mm3",
    text = "Stops exactly at this wear volume of a body, or of both bodies (total)." },
  { "wear.run{depth.cylinder}", type = "number > 0", unit = "mm", text = "Wear depth of the cylinder at "
    .. "which the run stops." },
  { "wear.run{depth.plate}", type = "number > 0", unit = "mm", text = "Wear depth of the plate at which the "
    .. "run stops." },
  { "wear.run{volume.cylinder}", type = "number > 0", unit = "mm3", text = "Wear volume of the cylinder at "
    .. "which the run stops." },
  { "wear.run{volume.plate}", type = "number > 0", unit = "mm3", text = "Wear volume of the plate at which "
    .. "the run stops." },
  { "wear.run{volume.total}", type = "number > 0", unit = "mm3", text = "Wear volume of both bodies "
    .. "together at which the run stops." },
  { "wear.run{p_center}", type = "number > 0", unit = "MPa",
    text = "Stops exactly where the pressure at the centre (p_center) reaches this value, from above or "
      .. "from below." },
  { "wear.run{p_max}", type = "number > 0", unit = "MPa",
    text = "Stops exactly where the largest pressure (p_max) reaches this value, from above or from below." },
  { "wear.run{half_width}", type = "number > 0", unit = "mm",
    text = "Stops exactly where the half width of the contact reaches this value, from above or from below." },
  { "wear.run{stop_when}", type = "function(w)",
    text = "Function that is called with the run after every step; the run stops if the function returns true." },
  { "wear.set", kind = "method", takes = "wear", class = "wear", use = "w:set{ alpha=0.3, load=200 }",
    text = "Changes fields of wear{} between two steps: any field except model, geometry and worn. mesh={ "
      .. "... } makes new meshes, to which the worn shapes are transferred. Other fields, the worn shapes "
      .. "and the history do not change. A new loading starts with its first block; loading=false or stroke= "
      .. "restores a constant stroke. distance and cycles are counted from the start of the run. The scheme does "
      .. 'not change, unless jump = "auto" or a law that jumps needs another one. Returns the run.' },
  { "wear.set{mesh}", type = "table { size=, fineness=, rows=, zone=, ... }",
    text = "New meshes of both bodies, with fields of model{ mesh= }; omitted fields do not change. If "
      .. "size is given and rows is omitted, the depth of the wear box does not change either." },
  { "wear.clone", kind = "method", class = "wear", use = "w:clone()",
    text = "An independent copy of the run, for example to continue it with two different loads." },
  { "wear.close", kind = "method", use = "w:close()",
    text = "Frees the memory of the run now instead of at the next garbage collection." },
  { "wear.contact", kind = "method", class = "contact", use = "w:contact()",
    text = "The contact of the present surfaces without friction, under the load of the definition and with the "
      .. "plate in its middle position (x = 0). contact{ model=w.model, worn=w, friction=w.friction } is the same "
      .. "contact with friction." },
  { "wear.save", kind = "method", use = "w:save(path)",
    text = "Writes the run to a run file; wear.open continues it. A run already saved in the file is replaced; "
      .. "other files are refused. If the program is killed, a run that was not saved is lost. w:run{ progress = "
      .. "function(w) if w.update % 10 == 0 then w:save(path) end end } saves the run at every tenth update." },
  { "wear.open", kind = "function", class = "wear", use = "w = wear.open(path, case)",
    text = 'Reads a run written by w:save("run.archard"), or a case of a study by its number. w:run() continues '
      .. "the run with the same results, w:run{ cycles=20000 } continues a finished run. Functions of the "
      .. "definition are not stored and must be given again: wear.open(path, { k = f }). If the program was "
      .. "killed, the run continues from its last w:save." },
  { "wear.profile", kind = "method", values = { "cylinder", "plate" },
    use = 'w:profile("cylinder" | "plate")',
    text = "Worn profile of a body, lists { x=, h=, y=, worn_x=, way= } in mm. For each surface node they "
      .. "have the unworn position x, the wear depth h (summed along the normals, positive into the body), "
      .. "the present position (worn_x, y), and `way`, the length of the vector sum of the wear. "
      .. 'export.csv(w:profile("plate"), "plate.csv") writes the profile to a file.' },
  { "wear.pressure", kind = "method", values = { "cylinder", "plate" },
    use = 'w:pressure("cylinder" | "plate")',
    text = "Pressure on a body with the plate at x = 0 under the nominal load, lists { x=, p= } in mm and MPa." },
  { "wear.combined", kind = "method", use = "w:combined()",
    text = "Sum of the wear depths of both bodies, h_c + h_p, along x (Eq. 31), lists { x=, h= } in mm." },
  { "wear.local_partition", kind = "method", use = "w:local_partition()",
    text = "Local partition of the wear depth, h_c / (h_c + h_p), along x (Eq. 30), lists { x=, value= }; h_c and "
      .. "h_p are the depths of the cylinder and the plate." },
  { "wear.roughness", kind = "method", values = { "cylinder", "plate" },
    use = 'w:roughness("cylinder" | "plate")', default = '"cylinder"',
    text = "Numerical oscillation of a profile from node to node (sawtooth), divided by the depth of the profile: "
      .. "1 for a sawtooth as high as the depth, below 1e-4 for a smooth profile. Larger values indicate that a "
      .. 'fixed jump is too large: use jump = "auto". The roughness of measured surfaces is profile.roughness.' },
  { "wear.map", kind = "method", use = 'w:map("ball", "depth" | "height" | "pressure")', result = "map",
    text = "In 3-D: a map of a body over x and z: wear depth [mm] (default), worn height [mm], or pressure [MPa] "
      .. "under the nominal load with the plate at x = 0. w:profile(body, { z = 0 }) and w:profile(body, { x = 0 "
      .. "}) are sections." },
  { "wear.surfaces", kind = "method", use = "w:surfaces()",
    text = "The present surfaces of both bodies, as in case.surfaces." },
  { "wear.stability", kind = "method", use = "w:stability()",
    text = "Returns { eigenvalue=, jump_limit= }: the largest growth rate of ripples [1/cycle], linearised at the "
      .. "present state, and the largest stable jump, 2 / eigenvalue [cycles]. Explicit updates with a larger jump "
      .. "cause ripples on the surfaces." },
  { "wear.loop", kind = "method", use = "w:loop()",
    text = "For runs with friction: the fretting loop of a periodic cycle on the present surfaces, { cycle=, x=, "
      .. "tangential=, energy=, stick_width=, gross= }. cycle is the number of cycles of the run so far, x the "
      .. "list of positions of the plate's base [mm], tangential the list of tangential forces [N], energy the "
      .. "energy dissipated in the cycle [N mm], stick_width the width of the contact that never slips [mm]; gross "
      .. "is true in gross slip. The energy is more accurate than the area of the loop: in partial slip the area "
      .. "omits slip between nodes, in gross slip it includes the surface strain under pressure (0.12 % at 591 MPa "
      .. "on steel). The dissipated energy of a measured loop is its area: sum over its points of (q[i] + q[i-1]) "
      .. "/ 2 * (x[i] - x[i-1]), with forces q and positions x. plot.loop(w) draws the loop; study.fretting_map "
      .. "computes the transition to gross slip." },
  { "wear.energy", kind = "field", unit = "N mm", text = "Energy dissipated by friction since the start of the run." },
  { "wear.cycle_energy", kind = "field", unit = "N mm",
    text = "Energy dissipated by a periodic cycle on the present surfaces; 0 before the first update." },
  { "wear.largest_shear", kind = "field", unit = "N",
    text = "Largest tangential force in a periodic cycle on the present surfaces. On curved or worn surfaces it "
      .. "may exceed the coefficient of friction times the load." },
  { "wear.stick_width", kind = "field", unit = "mm",
    text = "Width of the contact that never slips in a periodic cycle on the present surfaces; 0 in gross slip." },
  { "wear.gross", kind = "field",
    text = "1 if the whole contact slips at some time of a periodic cycle, else 0. Without friction it is 0." },
  { "wear.model", kind = "field", class = "model", text = "The model of the run." },
  { "wear.mesh", kind = "field", use = "w.mesh.plate:quality()",
    text = "The worn meshes of cylinder and plate, for w.mesh.plate:quality(), plot.mesh(w) and export. Uniform "
      .. 'wear of the plate does not move the nodes of its mesh; with geometry = "moving", it shifts the layers of '
      .. "the plate toward the surface." },
  { "wear.distance", kind = "field", unit = "mm", text = "Travelled distance so far." },
  { "wear.cycle", kind = "field", unit = "cycles", text = "Number of loading cycles so far." },
  { "wear.update", kind = "field", text = "Number of geometry updates so far." },
  { "wear.solutions", kind = "field",
    text = "Number of contact problems solved so far; the mirrored halves of symmetric strokes count too." },
  { "wear.done", kind = "field", text = "True if the run has reached its distance." },
  { "wear.p_center", kind = "field", unit = "MPa",
    text = "Pressure at the centre, with the plate at x = 0 under the nominal load." },
  { "wear.p_max", kind = "field", unit = "MPa",
    text = "Largest nodal pressure, with the plate at x = 0 under the nominal load. At the edge of a scar it grows "
      .. "as the mesh is refined; use p_average there." },
  { "wear.p_average", kind = "field", unit = "MPa",
    text = "Largest pressure averaged over the default length of contact{ average= }, with the plate at x = 0 under "
      .. "the nominal load. It converges with the mesh." },
  { "wear.p_peak", kind = "field", unit = "MPa",
    text = "Largest pressure at any time of the last update's cycle. It may be far above p_max because the edge of "
      .. "a scar presses on the other body near the ends of the stroke; it does not converge with the mesh. NaN in "
      .. "a run from a file older than format 3, until the run continues." },
  { "wear.travel", kind = "field", unit = "mm",
    text = "Distance between the extreme positions of the plate in the last update's cycle; in a single history "
      .. "(periodic = false), in its last increment. NaN in a run from a file older than format 4, until the run "
      .. "continues." },
  { "wear.load_distance", kind = "field", unit = "N mm",
    text = "Integral of the load over the sliding distance, which is load times distance in Archard's law. "
      .. "With rigid slip, the wear volume of a body is its k times this integral (Eq. 15); wear laws, local "
      .. "factors and elastic slip cause differences. NaN in a run from a file older than format 4." },
  { "wear.half_width", kind = "field", unit = "mm",
    text = "Half width of the contact, with the plate at x = 0 under the nominal load. Its error is at most 0.03 "
      .. "element widths for unworn surfaces and 0.07 for smooth worn surfaces; at edges of scars it is less than "
      .. "0.12 in the mean, mostly below 0.45, at most 0.75." },
  { "wear.half_width_z", kind = "field", unit = "mm",
    text = "Half width of the contact across the motion, with the plate at x = 0, in 3-D; 0 in 2-D." },
  { "wear.area", kind = "field", unit = "mm2", text = "Area of the contact, with the plate at x = 0, in "
    .. "3-D; 0 in 2-D." },
  { "wear.depth", kind = "field", unit = "mm", text = "Largest wear depth of each body." },
  { "wear.depth.cylinder", kind = "field", unit = "mm",
    text = "Largest wear depth of the cylinder." },
  { "wear.depth.plate", kind = "field", unit = "mm", text = "Largest wear depth of the plate." },
  { "wear.vector_depth", kind = "field", unit = "mm",
    text = "Largest length of the vector sum of the wear (Eq. 8) of each body; depth is the scalar sum (Eq. 6)." },
  { "wear.volume", kind = "field", unit = "mm3",
    text = "Wear volumes of the bodies: w.volume.plate, w.volume.cylinder and w.volume.total, or with the names of "
      .. "the bodies, such as w.volume.ball in 3-D. In 2-D they refer to the thickness of the model (1 mm by "
      .. "default), in 3-D and for bodies of revolution to the whole scar. Initial scars (worn=) are included in "
      .. "depths, not in volumes." },
  { "wear.volume.cylinder", kind = "field", unit = "mm3", text = "Wear volume of the cylinder." },
  { "wear.volume.plate", kind = "field", unit = "mm3", text = "Wear volume of the plate." },
  { "wear.volume.total", kind = "field", unit = "mm3",
    text = "Wear volume of both bodies together. For constant k and load L_N it is k L_N d after the distance d." },
  { "wear.depth_partition", kind = "field",
    text = "Wear depth partition factor alpha-tilde: the largest depth of the cylinder divided by the sum of the "
      .. "largest depths of both bodies (Eq. 29 of the paper)." },

  -- --- fields of the definition -----------------------------------------------------------------
  { "wear.stroke", kind = "field", unit = "mm",
    text = "Stroke in the present block of loading: distance between the extreme positions of the plate. The "
      .. "column travel of the history has the stroke of each update." },
  { "wear.strokes", kind = "field",
    text = "Number of strokes per cycle, r of Eq. (21). It is 2; in 2-D it is 1 if the stroke is twice the radius, "
      .. "because the plate then slides in one direction only." },
  { "wear.k_cylinder", kind = "field", unit = "mm2/N",
    text = "Wear coefficient of the cylinder, alpha k, in the last update." },
  { "wear.k_plate", kind = "field", unit = "mm2/N",
    text = "Wear coefficient of the plate, (1 - alpha) k, in the last update." },
  { "wear.cycles", kind = "field", unit = "cycles", text = "Number of cycles in the whole distance (Eq. 21)." },
  { "wear.total_distance", kind = "field", unit = "mm", text = "Travelled distance at which the run ends." },
  { "wear.procedure", kind = "field", text = 'The procedure in use, "SP" or "NSP": see wear{procedure}.' },
  { "wear.update_at", kind = "field", text = 'When the geometry is updated, "cycle" or "increment": see '
    .. "wear{update}." },
  { "wear.loading", kind = "field",
    text = "The blocks of loading with their sampled values, each a table { x=, load=, cycles=, periodic= }; false "
      .. "for a constant stroke without loading." },
  { "wear.local_factor", kind = "field", text = "The function local_factor of the definition, or false." },
  { "wear.functions", kind = "field",
    text = 'Names of the fields that are functions, such as "k" or "local_factor". Run files do not contain '
      .. "functions." },

  -- --- state ----------------------------------------------------------------------------------
  { "state", kind = "object", use = "wear{ k = function(state) ... end }",
    text = "State of the run, the argument of functions in the definition. They can read it only during the call. "
      .. "Functions k, alpha and friction are called several times in an update, with predicted distance, cycle, "
      .. "depths and volumes; for jump and local_factor the state is the last record of the history." },
  { "state.depth", kind = "field", unit = "mm", text = "Largest wear depth of each body, { cylinder=, plate= }." },
  { "state.volume", kind = "field", unit = "mm3",
    text = "Wear volume of each body and of both, { cylinder=, plate=, total= }." },
}

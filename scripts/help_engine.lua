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
  { "model{mesh.height}", type = "number > 0", unit = "mm", default = 0.025,
    text = "Height of the elements at the contact." },
  { "model{mesh.far}", type = "number > 0", unit = "mm", default = 1.0,
    text = "Largest size of the elements far from the contact." },
  { "model{mesh.zone}", type = "table { cylinder=, plate= }", unit = "mm",
    text = "Full width of the fine contact zone of each body. What surrounds it scales with it. "
      .. "Contact cannot be found outside; an error then names the zone it needs." },
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
  { "model.mesh", kind = "field", text = "The two meshes, m.mesh.cylinder and m.mesh.plate." },
  { "model.mesh.cylinder", kind = "field", class = "mesh", text = "Mesh of the half cylinder." },
  { "model.mesh.plate", kind = "field", class = "mesh", text = "Mesh of the plate." },

  -- --- mesh -----------------------------------------------------------------------------------
  { "mesh", kind = "object", use = "m.mesh.cylinder, m.mesh.plate",
    text = "Finite elements of one body, an exact mirror image about x = 0. The origin is the first "
      .. "point of contact, x along the plate's surface, y up." },
  { "mesh.nodes", kind = "field", text = "Number of nodes." },
  { "mesh.quads", kind = "field", text = "Number of quadrilaterals." },
  { "mesh.triangles", kind = "field", text = "Number of triangles." },
  { "mesh.quality", kind = "method", use = "m.mesh.plate:quality()",
    text = "Smallest and largest angle (degrees), aspect ratio, and Jacobian ratio of the worst "
      .. "elements, as a table." },
  { "mesh.write", kind = "method", use = "m.mesh.plate:write(path)",
    text = "Writes the mesh to a VTK file." },
  { "mesh.node", kind = "method", use = "x, y = m.mesh.plate:node(i)",
    text = "Position of node i = 1 ... nodes, in mm." },
  { "mesh.elements", kind = "method", use = "m.mesh.plate:elements()",
    text = "Corners of all elements in one list, four an element, as node numbers from 1; a triangle "
      .. "has 0 as its fourth." },

  -- --- contact --------------------------------------------------------------------------------
  { "contact", kind = "constructor", use = "c = contact{ load=100, x=0 }",
    text = "One frictionless contact solution: the plate at x, pressed by the load. Without a model "
      .. "it uses one whose zones suit." },
  { "contact{model}", type = "model", class = "model", text = "The bodies. One is built where none "
      .. "is given." },
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
  { "contact.model", kind = "field", class = "model", text = "The model it was solved on." },
  { "contact.pressure", kind = "method", values = { "cylinder", "plate" },
    use = 'c:pressure("cylinder" | "plate")', default = '"cylinder"',
    text = "Pressure at the surface nodes of a body, as { x=, p= } in mm and MPa; x is counted from "
      .. "the cylinder's axis." },
  { "contact.stress", kind = "method", class = "stress", use = "c:stress()",
    text = "Displacements and stresses inside both bodies: a field for plot.stress and export.vtk." },
  { "stress", kind = "object", use = "f = c:stress()",
    text = "Fields on both bodies, f.cylinder and f.plate: lists x, y (mm, nodes), elements (four "
      .. "corners each), mises, shear, sxx, syy, sxy (MPa, averages at nodes)." },
  { "stress.cylinder", kind = "field", text = "Lists of the cylinder." },
  { "stress.plate", kind = "field", text = "Lists of the plate." },

  -- --- wear -----------------------------------------------------------------------------------
  { "wear", kind = "constructor", use = "w = wear{ alpha=0.5, stroke=0.11, distance=1320 }",
    text = "A wear run: two surfaces that slide and lose material by Archard's law in local form, "
      .. "h = k_b times the integral of p ds at every point of both bodies (Eq. 13), k_c = alpha k "
      .. "for the cylinder, k_p = (1 - alpha) k for the plate (Eq. 20).\n\nwear{} is the reference "
      .. "case: a steel cylinder of 10 mm under 100 N, stroke 0.11 mm, alpha 0.5. Nothing runs until "
      .. "w:step() or w:run()." },
  { "wear{model}", type = "model", class = "model",
    text = "The bodies. Without it one is built on first use whose contact zones suit the stroke." },
  { "wear{k}", type = "number >= 0, function(state), or table { distance=, value= }",
    unit = "mm2/N", default = "1e-8",
    text = "Wear coefficient k of the couple: volume = k L_N d (Eq. 1). A function gets the state "
      .. "(distance, cycle, update, depth, volume, ...) in the middle of the update; a table is "
      .. "interpolated over the distance." },
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
      .. 'large a jump makes explicit updates rough; "auto" stays below that limit.' },
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
  { "wear{loading}", type = "table, or list of tables",
    text = "A cycle of your own instead of stroke and load: x and load as functions of t in 0 ... 1, "
      .. "or as sampled lists. Several such blocks in a list follow each other." },
  { "wear{loading.x}", type = "function(t) or list", unit = "mm",
    text = "Position of the plate over the cycle." },
  { "wear{loading.load}", type = "function(t), list or number", unit = "N",
    text = "Normal load over the cycle; 0 lifts off: no contact, no wear." },
  { "wear{loading.t}", type = "list", text = "Times of sampled lists, increasing from 0 to 1." },
  { "wear{loading.increments}", type = "whole number >= 1", default = 100,
    text = "Increments of the cycle." },
  { "wear{loading.cycles}", type = "number > 0", unit = "cycles",
    text = "How often the cycle is repeated." },
  { "wear{loading.periodic}", type = "boolean", default = true,
    text = "false: one generic history, with a geometry update at every increment (Eqs. 4-8)." },
  { "wear{local_factor}", type = "function(body, x, p, state)",
    text = "Factor on k at each node, for cross-shear and the like." },
  { "wear{worn}", type = "wear, or table { cylinder=, plate= }", class = "wear",
    text = "Shape to start from, as in contact{worn}." },
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
    text = "Shows a bar on a terminal (the default there), or calls the function after every step." },
  { "wear.clone", kind = "method", class = "wear", use = "w:clone()",
    text = "A copy that goes its own way: for a before and after, or for two futures of one past." },
  { "wear.save", kind = "method", use = "w:save(path)",
    text = "Writes the run, with all it needs to go on, to a file; wear.open reads it." },
  { "wear.open", kind = "function", class = "wear", use = "w = wear.open(path)",
    text = "Reads a run that w:save wrote; it goes on to the same numbers." },
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
  { "wear.model", kind = "field", class = "model", text = "The model it runs on." },
  { "wear.distance", kind = "field", unit = "mm", text = "Travelled distance so far." },
  { "wear.cycle", kind = "field", unit = "cycles", text = "Loading cycles so far." },
  { "wear.update", kind = "field", text = "Geometry updates so far." },
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
  { "wear.volume", kind = "field", unit = "mm3", text = "Wear volumes." },
  { "wear.volume.cylinder", kind = "field", unit = "mm3", text = "Wear volume of the cylinder." },
  { "wear.volume.plate", kind = "field", unit = "mm3", text = "Wear volume of the plate." },
  { "wear.volume.total", kind = "field", unit = "mm3", text = "Wear volume of both, k L_N d." },
  { "wear.depth_partition", kind = "field",
    text = "Wear depth partition factor alpha-tilde: the cylinder's share of the sum of the largest "
      .. "depths (Eq. 29)." },
  { "wear.history", kind = "field",
    text = "Columns by name, one value for each update from 0 on: " .. [[

  update, cycle, distance (mm), jump     p_center, p_max (MPa), half_width (mm)
  depth_cylinder, depth_plate (mm)       volume_cylinder, volume_plate (mm3)
  depth_partition, k, alpha              solutions (contacts solved so far)]] },
}

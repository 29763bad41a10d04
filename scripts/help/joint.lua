-- Help entries of balls in sockets: joint, gait. Form: help.lua.

return {
  { "joint", kind = "function", use = "joint{ head={ radius=14 }, cup={ clearance=0.06 } }",
    text = "A ball in a socket, as in artificial hips: layered head and cup, full elastic contact of complete concentric spheres and "
      .. "shells. Left out: a metal-on-metal hip of 28 mm. Depths of both bodies are maps in their own frames. First order in "
      .. "displacement over radius and frictionless. Outside this model: edge loading, microseparation, lubrication, plastic "
      .. "flow, which cause many clinical failures. contact{ model=j, load= } and wear{ model=j, loading= } work as j:contact{} and "
      .. "j:wear{} do." },
  { "joint{head}", type = "table { radius=, material=, layers= }", unit = "mm",
    text = "The head: layers {{ thickness=, material= }, ...} from the surface inwards, on a core of the material. A rigid head: E = 1e15." },
  { "joint{cup}", type = "table { clearance=, inclination=, cover=, layers= }", unit = "mm, degree",
    text = "The cup, fixed outside: radial clearance (0.06); angle between its axis and the nominal load (0); angle from the "
      .. "axis to the rim (90); layers from the inside outwards." },
  { "joint{foundation}", values = { "elastic", "winkler", "column" }, default = '"elastic"',
    text = "winkler: springs of the cup's first layer, exact for uniform pressure; right within 4 % for polyethylene with nu up to 0.4, "
      .. "meaningless for metal on metal. column: springs of a confined column." },
  { "joint{order}", type = "number", values = { 1, 2 }, default = "1",
    text = "2: gaps to second order in the head's displacement over the radius, which adds 0.6 % to the pressure of a polyethylene liner "
      .. "of 0.1 mm clearance." },
  { "joint{mesh}", type = "table { size= }", unit = "degree", default = "{ size=2 }",
    text = "Cells in longitude and latitude: 2 suits metal, 4 polyethylene." },
  { "joint.contact", kind = "method", use = "j:contact{ load=3000, direction={ 0, 0, 1 } }", result = "table",
    text = "One contact of the unworn joint: p_max, p_center, area, half_angle (of a cap of that area), approach { x, y, z }, "
      .. "normal_force (the integral of p: more than the load), rim_margin in degrees, pressure as { theta=, phi=, values= }. "
      .. "direction is that of the load in the cup's frame: x medial-lateral, y anterior, z into the cup." },
  { "joint.wear", kind = "method", use = 'j:wear{ loading=gait "iso", k=3e-11, alpha=0.5, cycles=1e6 }',
    text = "A run on a joint of its own; alpha is the head's share of wear, or a function of { cycles= }. k in mm2/N, or a function of { cross_shear=, p_mean=, cycles= } "
      .. "of a cell of the cup. creep: a function of { thickness=, p_mean=, cycles= }, the mean pressure since the start: depth in mm that "
      .. "the cup gives by without losing volume; it has no default. loading: a gait, or blocks {{ gait=, cycles= }, ...}, the last of which lasts. Steps are as long as halves and whole agree within "
      .. "tolerance (0.02 of the depth so far; depths come out ten times as exact, or better); or updates=20 of lengths that grow as N^1.5. "
      .. "scheme \"sweep\" has the wear of each instant inside its contact, and is stable for any step; \"explicit\" keeps "
      .. "below its limit, which print(w) shows. worn={ head=, cup= }: shapes to start from, depths in mm as a function of theta and phi "
      .. 'in degrees, or a w:map of a run. w:run{ cycles= }, w.depth.head, w.volume.cup, w.depth_partition, w.history, w.p_peak, '
      .. 'w:map "cup", "head", "cross shear", "creep" or "pressure", w:penetration(), w:save(path); w:flat "cup" is a map{} of it, azimuthal '
      .. 'equal-area about the load, as plot.map(w, "cup") draws. Studies and fits know plain wear{} runs alone.' },
  { "joint.open", kind = "function", use = 'joint.open("hip.archard", { k=f })',
    text = "A run of a joint that w:save(path) kept: it goes on to the same bits. Functions k, alpha and creep are given again." },
  { "gait", kind = "function", use = 'gait "iso"   gait{ flexion={ 0, 20, 0 }, load=2000 }',
    text = "How a joint turns and is loaded over a cycle. \"iso\" has the ranges of the standard's walk, but the shapes between them are "
      .. 'approximate; "prosim" is a simplified walk of simulators. Own ones: flexion, adduction, rotation in degrees, load in N '
      .. "along z or { x=, y=, z= }: functions of t in [0, 1], numbers, or lists over t; order of the rotations (\"xyz\"), "
      .. "increments (20). A gait has to close. .track [mm] and .work [N mm] are those of a cycle with a head of 28 mm." },
  { "gait.rocking", kind = "function", use = "gait.rocking{ angle=23, load=2000 }", result = "gait",
    text = "Biaxial rocking: the head's axis goes round a cone under a constant load." },
  { "gait.flexion", kind = "function", use = "gait.flexion{ angle=21.5, load=2000 }", result = "gait",
    text = "Flexion alone, angle cos 2 pi t, under a constant load." },
  { "gait.read", kind = "function", use = 'gait.read("walk.csv", { increments=20 })', result = "gait",
    text = "A gait from a table: columns t in [0, 1], flexion, adduction, rotation in degrees, and load or Fx, Fy, Fz in N." },
}

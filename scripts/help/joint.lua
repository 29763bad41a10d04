-- Help entries of balls in sockets: joint, gait. help/engine.lua explains the form of an entry.

return {
  { "joint", kind = "function", use = 'j = joint{ head={ radius=14 }, cup={ clearance=0.06 } }\n'
    .. 'w = wear{ model=j, loading=gait "iso", k=3e-11, cycles=1e6 }\n'
    .. 'w:run()  print(w.volume.cup, w.depth.cup)  plot.map(w, "cup")',
    text = "A ball in a socket, such as an artificial hip. The contact is elastic and frictionless, between "
      .. "complete concentric spheres and shells with layers, to first order in the ratio of displacement to "
      .. "radius. The default is a metal-on-metal hip with a head of 28 mm. The wear depths of head and cup are "
      .. "maps on each body. Not simulated are edge loading, microseparation, lubrication and plastic flow, which "
      .. "cause many clinical failures. For polyethylene, use cup={ layers={{ thickness=8, material=material{ "
      .. "E=600, nu=0.4 } }} }, with alpha = 0 (only the cup wears) and k as a function of cross_shear and p_mean: "
      .. 'help "joint.wear{k}". w.volume.cup is the worn volume [mm3]. contact{ model=j, load= } and wear{ '
      .. "model=j, loading= } are the same as j:contact{} and j:wear{}." },
  { "joint{head}", type = "table { radius=, material=, layers= }, or a body.ball{}", unit = "mm",
    text = "The head: its radius, its material and its layers {{ thickness=, material= }, ...} from the surface "
      .. "inwards. With E = 1e15 the head is rigid." },
  { "joint{cup}", type = "table { clearance=, inclination=, cover=, layers= }", unit = "mm, degree",
    text = "The cup, which is fixed on its outside: clearance is the radial clearance (default 0.06 mm), "
      .. "inclination the angle between the axis of the cup and the nominal load (default 0), cover the angle from "
      .. "the axis to the rim (default 90 degrees). Layers are listed from the inside outwards." },
  { "joint{foundation}", values = { "elastic", "winkler", "column" }, default = '"elastic"',
    text = '"elastic": layered spheres. "winkler": the first layer of the cup is a bed of springs, which is exact '
      .. "for uniform pressure; the error is 4 % for polyethylene with nu up to 0.4; do not use it for metal on "
      .. 'metal. "column": springs with the stiffness of a confined column.' },
  { "joint{order}", type = "number", values = { 1, 2 }, default = "1",
    text = "Order to which the gap is expanded in the ratio of the head's displacement to its radius. Order 2 "
      .. "increases the pressure of a polyethylene liner with a clearance of 0.1 mm by 0.6 %." },
  { "joint{mesh}", type = "table { size= }", unit = "degree", default = "{ size=2 }",
    text = "Size of the cells in longitude and latitude. Use 2 degrees for metal, 4 degrees for polyethylene." },
  { "joint.contact", kind = "method", use = "j:contact{ load=3000, direction={ 0, 0, 1 } }", result = "contact of a joint",
    text = "Contact of the unworn joint under a load. Its fields are p_max, p_center, area, half_angle (of a "
      .. "spherical cap of this area), approach { x, y, z }, normal_force (the integral of the pressure, larger "
      .. "than the load), rim_margin (distance from the rim in degrees) and pressure { theta=, phi=, values= }. "
      .. "c:flat() returns the pressure as a map{}, plot.map(c) draws it. direction is the direction of the load "
      .. "in the cup's frame: x medial-lateral, y anterior, z into the cup." },
  { "joint.wear", kind = "method", use = 'j:wear{ loading=gait "iso", k=3e-11, alpha=0.5, cycles=1e6 }',
    text = "A wear run of a joint. w:run{ cycles= } computes it; results are w.depth.head, w.volume.cup, "
      .. 'w.depth_partition, w.p_peak, w.history, w.cycle and w.distance. Maps over theta and phi are w:map "cup", '
      .. '"head", "cross shear", "creep" or "pressure" (at the largest load, or w:map("pressure", { instant= })); '
      .. 'w:flat "cup" is a map{} in azimuthal equal-area projection about the load, as drawn by plot.map(w, '
      .. '"cup"). w:penetration() returns the displacement of the head in mm. w:save(path) stores the run. '
      .. "Studies, samples, w:sensitivity{}, fits and sessions accept these runs like other runs: vary={ "
      .. 'clearance= }, unknown={ k=, alpha= }, data={ { of="volume_cup", cycle=, value= }, { map=w:map "cup", '
      .. 'body="cup", cycle= } }.' },
  { "joint.wear{loading}", type = "gait, its fields, or blocks {{ gait=, cycles= }, ...}", default = 'gait "iso"',
    text = "Rotations and load of a cycle: a gait, or a list of blocks of which the last continues to the end." },
  { "joint.wear{k}", type = "number >= 0, or function", unit = "mm2/N", default = "3e-11",
    text = "Wear coefficient of the couple, or a function of { cross_shear=, p_mean=, cycle= } of a cell of the "
      .. "cup: k=function(s) return 1e-9 * (0.2 + s.cross_shear) end. cross_shear is the part of the friction work "
      .. "that is done across the main direction of sliding, 0 to 0.5; p_mean is the mean pressure of the cycle "
      .. "[MPa]." },
  { "joint.wear{alpha}", type = "number in [0, 1], or function", default = "0.5",
    text = "The head's share of the wear, or a function of { cycle= }." },
  { "joint.wear{cycles}", type = "number > 0", unit = "cycles", default = "1e6", text = "Number of cycles." },
  { "joint.wear{creep}", type = "function",
    text = "Function of { thickness=, p_mean=, cycle= } that returns the creep depth of the cup in mm; p_mean is "
      .. "the mean pressure since the start. Creep does not add to the wear volume. Default: no creep." },
  { "joint.wear{tolerance}", type = "number in (0, 1)", default = "0.02",
    text = "Accepted difference between the results of one step and of two half steps, relative to the present "
      .. "depth. Errors of depths are at most a tenth of this difference." },
  { "joint.wear{updates}", type = "whole number",
    text = "Number of updates n, instead of the tolerance. The length of the updates increases: update i ends at "
      .. "cycles * (i/n)^1.5." },
  { "joint.wear{jump}", type = "number > 0, or function", unit = "cycles",
    text = "Number of cycles of an update, or a function of { cycle=, distance=, update= } that computes this "
      .. "number. Use jump instead of tolerance and updates." },
  { "joint.wear{distance}", type = "number > 0", unit = "mm",
    text = "Sliding distance of the load over the head, instead of cycles." },
  { "joint.wear{scheme}", values = { "sweep", "explicit" }, default = '"sweep"',
    text = '"sweep" computes the contact of each instant with the wear of this instant and is stable for steps of '
      .. 'any length; "explicit" limits the steps to the stability limit, which print(w) shows.' },
  { "joint.wear{worn}", type = "table { head=, cup= }", unit = "mm",
    text = "Initial wear depths of head and cup, each a function of theta and phi in degrees, or a map "
      .. "returned by w:map." },
  { "joint.open", kind = "function", use = 'joint.open("hip.archard", { k=f })',
    text = "Reads the run of a joint written by w:save(path); w:run() continues it with the same results. The "
      .. "functions k, alpha, creep and jump must be given again." },
  { "gait", kind = "function", values = { "iso", "prosim" }, use = 'gait "iso"   gait{ flexion={ 0, 20, 0 }, load=2000 }',
    text = "Rotations and load of a joint over one cycle. Use it in a joint: joint{}:wear{ loading=gait "
      .. '"iso", cycles=1e6 }. "iso" has the ranges of the walking cycle of ISO 14242-1 with approximate '
      .. 'curves in between; "prosim" is a simplified walking cycle of hip simulators. To define a cycle, '
      .. "set flexion, adduction and rotation in degrees and load in N, along z or { x=, y=, z= }. Each is a "
      .. "function of t in [0, 1], a number, or a list over t (with period=100, t is in percent). Increments "
      .. 'without load cause no wear. order is the order of the rotations (default "xyz"), increments the '
      .. 'number of increments (default 20); gait("iso", { increments=40 }) sets it for a named gait. A gait '
      .. "must be closed. Fields of a gait for a head of 28 mm: .track is the length of the load's track "
      .. "over the head in a cycle [mm], .work the friction work of a cycle divided by the coefficient of "
      .. "friction [N mm]. .instants has fifteen numbers for each increment: rotation matrix by rows, "
      .. "rotation vector, load." },
  { "gait.rocking", kind = "function", use = "gait.rocking{ angle=23, load=2000 }", result = "gait",
    text = "Gait with biaxial rocking: the head's axis describes a cone with the half angle `angle` [degrees] "
      .. "under a constant load." },
  { "gait.flexion", kind = "function", use = "gait.flexion{ angle=21.5, load=2000 }", result = "gait",
    text = "Gait with flexion only, by the angle times cos(2 pi t), under a constant load." },
  { "gait.read", kind = "function", use = 'gait.read("walk.csv", { increments=20, period=100 })', result = "gait",
    text = "Reads a gait from a text file with the columns t, flexion, adduction and rotation in degrees, and load "
      .. "or Fx, Fy, Fz in N. t runs from 0 to the period, which is 1 by default; use period=100 for percent of "
      .. "the cycle." },
}

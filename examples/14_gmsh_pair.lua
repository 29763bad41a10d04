-- Two bodies meshed by Gmsh, compared with archard's own mesh of the same shapes: contact and a run with
-- frozen geometry. gmsh_pair.geo describes the bodies and names their parts; Gmsh generates the mesh:
--   gmsh -2 -order 1 -format msh41 -o gmsh_pair.msh gmsh_pair.geo
--   archard examples/14_gmsh_pair.lua

local here = arg[0]:match("^(.*)/") or "."
local own = model()
local outside = model{ mesh = here .. "/gmsh_pair.msh", radius = 10 }
print(outside)

local function share(got, expected) return 100 * (got / expected - 1) end

local function compare(what, got, expected)
  print(("%-24s %12.6g  own mesh %12.6g  (%+.3f %%)"):format(what, got, expected, share(got, expected)))
end

local c, d = contact{ model = outside, load = 100 }, contact{ model = own, load = 100 }
compare("p_center [MPa]", c.p_center, d.p_center)
compare("half_width [mm]", c.half_width, d.half_width)
compare("approach [mm]", c.approach, d.approach)

local function run(m) return wear{ model = m, geometry = "frozen", stroke = 0.2, cycles = 2000 }:run() end
local v, w = run(outside), run(own)
compare("depth_cylinder [mm]", v.depth_cylinder, w.depth_cylinder)
compare("depth_plate [mm]", v.depth_plate, w.depth_plate)
compare("p_center, worn [MPa]", v.p_center, w.p_center)
plot.mesh(outside, { zoom = { -1, 1, -1, 1 } })

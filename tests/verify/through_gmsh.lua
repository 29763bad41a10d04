-- Tests the same shapes from Gmsh files: meshes made by Gmsh from tests/files/gmsh/*.geo, and archard's own
-- meshes, written and read. Contact and wear over several updates are compared with archard's own bodies,
-- which other tests of this folder compare with closed forms. Gmsh itself is not needed.
local here = arg[0]:match("^(.*)/") or "."
local figures = dofile(here .. "/lib/figures.lua")
local within, below = figures.within, figures.below

local function wave(x) return 1e-4 * math.cos(2 * math.pi * x / 0.1) end

-- upper, lower: archard's own bodies; outside: the bodies for the mesh by Gmsh; fields: fields of both
-- models; wear: fields of both runs.
local shapes = {
  { name = "punch", load = 200, upper = body.punch{ flat = 1, radius = 2, height = 10 },
    lower = body.block{ width = 20, height = 10 }, outside = {}, mesh = { size = 0.02 },
    wear = { stroke = 0.1, cycles = 600, jump = 100 } },
  { name = "bush", load = 1000, upper = body.disc{ radius = 9.95 }, lower = body.ring{ inner = 10, outer = 20 },
    outside = { upper = body.disc{ radius = 9.95 }, lower = body.ring{ inner = 10, outer = 20 } },
    mesh = { size = 0.2, zone = { cylinder = 14, plate = 14 } }, wear = { stroke = 1, cycles = 300, jump = 60, k = 1e-7 } },
  { name = "coat", load = 100, upper = body.cylinder{ radius = 10, E = 210e3, layers = { { thickness = 0.1, E = 400e3 } } },
    lower = body.block{ E = 1e9 }, outside = { upper = body.gmsh{ E = 210e3, materials = { coat = { E = 400e3 } } },
      lower = body.gmsh{ E = 1e9 } }, inside = body.gmsh{ E = 210e3, materials = { layer1 = { E = 400e3 } } },
    fields = { radius = 10 }, mesh = { size = 0.015 }, wear = { stroke = 0.05, cycles = 300, jump = 60 } },
  { name = "waves", load = 70, upper = body.profile{ width = 2, height = 1, y = wave }, lower = body.block{ width = 2, height = 1 },
    outside = {}, mesh = { size = 0.01, zone = { cylinder = 0.7, plate = 0.9 } }, wear = { stroke = 0.02, cycles = 50, jump = 10 } },
  { name = "ball", load = 50, outside = {}, fields = { geometry = "axisymmetric", radius = 10 }, mesh = { size = 0.02 },
    wear = { slide = "z", track = 2, cycles = 8, jump = 2, alpha = 1 } },
}

local function with(base, more)
  local all = {}
  for _, part in ipairs{ base or {}, more } do
    for name, value in pairs(part) do all[name] = value end
  end
  return all
end

local function run(s, m, more)
  return wear(with(with({ model = m, load = s.load, scheme = "implicit", increments = 20 }, s.wear), more)):run()
end

-- Compares the final depths and volumes of both bodies, and the total volume with its exact value.
local function compare(s, of, v, w, share)
  for _, role in ipairs{ "upper", "lower" } do
    if w.depth[role] > 0 then
      within(v.depth[role], w.depth[role], share, of .. "depth of the " .. role .. " body [mm]")
      within(v.volume[role], w.volume[role], share, of .. "volume of the " .. role .. " body [mm3]")
    end
  end
  -- equal up to the tolerance of implicit steps
  within(v.volume.total, (s.wear.k or 1e-8) * v.load_distance, 1e-9,
    of .. "volume by the integral of the normal force [mm3]")
end

for _, s in ipairs(shapes) do
  local own = model(with(s.fields, { upper = s.upper, lower = s.lower, mesh = s.mesh }))
  local by_gmsh = model(with(with(s.fields, s.outside), { mesh = here .. "/../files/gmsh/" .. s.name .. ".msh" }))
  local c, d = contact{ model = by_gmsh, load = s.load }, contact{ model = own, load = s.load }
  local of = s.name .. " by Gmsh: "
  within(c.p_center, d.p_center, 0.01, of .. "centre pressure [MPa]")
  below(math.abs(c.half_width - d.half_width), s.mesh.size / 2,
    of .. "error of the half width, below half an element [mm]")
  -- frozen geometry against a run with moving geometry
  compare(s, of, run(s, by_gmsh, { geometry = "frozen" }), run(s, own), 0.01)

  -- archard's own mesh, written and read: results differ by rounding only
  local inside = s.inside and { upper = s.inside, lower = s.outside.lower } or s.outside
  local path = os.tmpname()
  os.remove(path)
  local again = model(with(with(s.fields, inside), { mesh = export.msh(own, path .. ".msh") }))
  os.remove(path .. ".msh")
  local e = contact{ model = again, load = s.load }
  of = s.name .. ", own mesh written and read: "
  within(e.p_center, d.p_center, 1e-9, of .. "centre pressure [MPa]")
  within(e.half_width, d.half_width, 1e-9, of .. "half width [mm]")
  -- implicit steps are solved to a relative error of 1e-8
  compare(s, of, run(s, again, { geometry = "frozen" }), run(s, own, { geometry = "frozen" }), 5e-8)
end

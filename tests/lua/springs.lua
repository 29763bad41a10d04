-- Tests a second kind of pair, a ball on springs, which has closed forms. Runs, files, studies, fits and plots
-- must work with every kind.
local tap = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/tap.lua")
local is, ok, near, fails = tap.is, tap.ok, tap.near, tap.fails

local mesh = { size = 0.04, zone = { cylinder = 2, plate = 2 } }
local springs = { geometry = "springs", mesh = mesh }
local m = model(springs)
local function run(changes)
  local all = { model = m, stroke = 0.01, distance = 1000, alpha = 0.3, scheme = "implicit", tolerance = 1e-3 }
  for name, value in pairs(changes or {}) do all[name] = value ~= "none" and value or nil end
  return wear(all)
end

-- --- one contact: load = pi R K approach^2 ---------------------------------------------------------
local M = 200e3 * 0.7 / (1.3 * 0.4)
local K = M / 2
local approach = math.sqrt(100 / (math.pi * 10 * K))
local w = run()
near(w.p_center, K * approach, 1e-3, "pressure at the centre of the ball")
near(w.half_width, math.sqrt(2 * 10 * approach), 0.03, "radius of the contact")
ok(tostring(m):find("thickness 1 mm, springs", 1, true), "print of a model with springs: " .. tostring(m))

-- --- wear ------------------------------------------------------------------------------------------
w:run()
near(w.volume.cylinder, 0.3 * 1e-8 * 100 * 1000, 1e-9, "the volume of the ball is alpha k L d")
near(w.volume.plate, 0.7 * 1e-8 * 100 * 1000, 1e-9, "the volume of the flat is (1 - alpha) k L d")
near(w.depth_partition, 0.3, 1e-9, "alpha is the local partition of the depths")
-- After much wear the bodies behave like rigid bodies: together they lose a cap of height h and volume V = pi
-- R h^2.
local cap = math.sqrt(1e-8 * 100 * 1000 / (math.pi * 10))
ok(w.depth.cylinder + w.depth.plate < cap and w.depth.cylinder + w.depth.plate > 0.8 * cap,
  "the depths are below the depth of rigid bodies")
local free = run{ model = { geometry = "springs", mesh = { size = 0.04, zone = { cylinder = 3, plate = 3 } } },
  k = 1e-7, distance = 10000 }
free:run()
near(free.depth.cylinder + free.depth.plate, math.sqrt(1e-7 * 100 * 10000 / (math.pi * 10)), 0.03,
  "after much wear the depth is the depth of rigid bodies")
local staged = run{ scheme = "none", tolerance = "none", jump = "auto" }
staged:run()
near(staged.depth.plate, w.depth.plate, 0.02, "automatic explicit updates agree with implicit steps")
local euler = run{ scheme = "none", tolerance = "none", jump = 2000 }
euler:run()
near(euler.depth.plate, w.depth.plate, 0.02, "explicit updates of fixed length agree with implicit steps")
local ten = run{ k = function(s) return s.distance < 500 and 1e-8 or 3e-8 end }
ten:run()
near(ten.volume.total, 1e-6 * (500 + 3 * 500), 1e-6, "k as a function of the state")
-- The pressure of a spring is K times its compression. The eigenvalue, and with it the stability limit of
-- explicit updates, is therefore K k times the sliding distance of a cycle.
near(run{ scheme = "none", tolerance = "none", jump = 10 }:stability().eigenvalue, K * 0.02 * 1e-8, 1e-9,
  "the largest eigenvalue")
local loads = run{ scheme = "none", tolerance = "none", stroke = "none", jump = 100, cycles = 20000, distance = "none",
  loading = { t = { 0, 0.5, 1 }, x = { 0, 0.01, 0 }, load = { 50, 100, 50 } } }
loads:run()
near(loads.volume.total, 1e-8 * 75 * 400, 1e-9, "volume under a load that varies in a cycle")
local places = run{ scheme = "none", tolerance = "none", jump = 5000, local_factor = function(body) return body == "plate" and 2 or 1 end }
places:run()
near(places.volume.plate, 2 * 0.7e-3, 1e-9, "volume with a local factor")

-- --- profiles, copies, files -----------------------------------------------------------------------
local p = w:profile("plate")
is(#p.x, 51, "the profile along x has all points")
near(p.h[26], w.depth.plate, 1e-12, "the largest depth is in the middle")
is(p.h[10], p.h[42], "the depths are symmetric to the bit")
local path = os.tmpname()
os.remove(path)
local half = run{ distance = 500 }
half:run()
half:save(path)
local again = wear.open(path)
half:run{ distance = 1000 }
again:run{ distance = 1000 }
local a, b = half:profile("plate"), again:profile("plate")
is(table.concat(a.h, " "), table.concat(b.h, " "), "a stored run continues with identical bits")
is(again.p_center, half.p_center, "pressure of an opened run")
is(half:clone().p_center, half.p_center, "pressure of a copied run")
os.remove(path)

-- --- studies, fits, plots --------------------------------------------------------------------------
local base = { model = springs, stroke = 0.01, distance = 200, scheme = "implicit", tolerance = 1e-3 }
local s = study{ base = base, vary = { alpha = { 0, 0.5, 1 }, load = { 50, 100 } } }
s:run{ workers = 2, file = path }
is(#s:cases(), 6, "a study of six cases")
for _, case in ipairs(s:cases()) do
  near(case.volume.total, 1e-8 * case.load * 200, 1e-9, case.label)
end
local case = s:cases()[4]
is(case:profile("plate").h[30], case:wear():profile("plate").h[30], "a case has the profile of its run")
os.remove(path)
local truth = run{ k = 1.4e-8, distance = 200 }
truth:run()
local seen = truth:profile("plate")
local f = fit{ base = base, unknown = { k = { start = 1e-8 }, alpha = { start = 0.5 } }, data = {
  { body = "plate", distance = 200, profile = { x = seen.x, h = seen.h }, error = 1e-6 },
  { of = "volume_cylinder", distance = 200, value = truth.volume.cylinder, relative = 0.01 } } }
near(f.value.k, 1.4e-8, 1e-3, "k of a fit")
near(f.value.alpha, 0.3, 1e-3, "alpha of a fit")
for _, draw in ipairs{ function(file) return plot.profile(w, "plate", { file = file }) end,
  function(file) return plot.history(w, "p_center", { file = file }) end } do
  local svg = os.tmpname() .. ".svg"
  draw(svg)
  local file = assert(io.open(svg))
  ok(file:read("a"):find("<path", 1, true), "a picture is drawn")
  file:close()
  os.remove(svg)
end

-- --- unsupported options ---------------------------------------------------------------------------
fails(function() run{ friction = 0.3 } end, "field 'friction': on springs expected 0",
  "friction on springs is refused")
fails(function() run{ load = 1e6 }:step() end, "the contact reaches the edge of the springs",
  "a contact wider than the springs")
fails(function() contact{ model = m } end, "expected a model with meshes", "contact{} of springs")
fails(function() return m.mesh.plate end, "has no meshes", "a mesh of springs")
fails(function() w:contact() end, "have no contact objects", "the contact of a run on springs")
fails(function() export.vtk(m, "x.vtk") end, "expected a model with meshes", "export.vtk of springs")
fails(function() hertz{ geometry = "springs" } end, "Hertz' formulas are not valid for springs",
  "hertz{} of springs")
fails(function() model{ geometry = "springs",
  lower = body.block{ layers = { { thickness = 0.1, material = material{} } } } } end,
    "springs are only for a ball and a flat",
  "springs with a layered body")
fails(function() w:set{ mesh = { size = 0.1 } } end, "", "w:set of another mesh on springs")


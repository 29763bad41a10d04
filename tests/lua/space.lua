-- Tests contact and wear in three dimensions: balls and rollers on flats as half-spaces, from the definition
-- to the file.
local tap = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/tap.lua")
local warnings = require "archard.warnings"
local is, ok, near, fails = tap.is, tap.ok, tap.near, tap.fails

local m = model{ geometry = "3-D" }
ok(tostring(m):find("half-spaces", 1, true), "print of a model in 3-D: " .. tostring(m))
ok(tostring(m):find("radius 10 mm along x, 10 mm along z", 1, true),
  "the default pair is a ball of 10 mm on a flat")

-- --- Hertz -----------------------------------------------------------------------------------------
local h = hertz{ geometry = "3-D", radius = 5, radius_z = 20, load = 20 }
near(h.half_width, 0.0683891, 1e-5, "Hertz: half width along x of an elliptic contact")
near(h.half_width_z, 0.171021, 1e-5, "Hertz: half width along z of an elliptic contact")
near(h.p_max, 816.46, 1e-5, "Hertz: largest pressure of an elliptic contact")
near(h.approach, 1.19891e-3, 1e-5, "Hertz: approach of an elliptic contact")
fails(function() hertz{ radius_z = 3 } end, "3-D", "two radii need geometry = \"3-D\"")

local roller = model{ geometry = "3-D", upper = body.ball{ radius = 5, radius_z = 20 }, lower = body.block{} }
local c = contact{ model = roller, load = 20 }
near(c.p_max, h.p_max, 3e-3, "largest pressure of a crowned roller")
near(c.half_width, h.half_width, 0.02, "half width of a crowned roller along x")
near(c.half_width_z, h.half_width_z, 0.02, "half width of a crowned roller along z")
near(c.approach, h.approach, 3e-3, "approach of a crowned roller")
near(c.area, math.pi * h.half_width * h.half_width_z, 0.03, "contact area of a crowned roller")

-- --- one contact -----------------------------------------------------------------------------------
c = contact{ model = m, load = 10 }
near(c.p_center, 615.942, 3e-3, "pressure at the centre of a ball")
near(c.approach, 7.75179e-4, 2e-3, "approach of a ball")
local map = c:pressure()
near(map:volume().net, 10, 1e-3, "the pressures balance the load")
local line = c:pressure{ z = 0 }
is(#line.x, #line.p, "a section has a pressure for each x")
near(math.max(table.unpack(line.p)), c.p_max, 1e-12, "the section z = 0 contains the largest pressure")
local across = c:pressure{ x = 0 }
near(across.p[#across.p // 2], line.p[#line.p // 2], 1e-9, "sections along x and along z are equal")
fails(function() c:pressure{ z = 9 } end, "'z': expected a position", "a section outside the window")
fails(function() c:pressure{ y = 0 } end, "unknown field 'y'", "a section at a height")
near(c:move{ x = 0.05 }.p_max, c.p_max, 1e-2, "a moved contact")

-- --- wear ------------------------------------------------------------------------------------------
local function run(changes)
  local all = { model = m, load = 10, stroke = 0.04, alpha = 0.3, distance = 200 }
  for name, value in pairs(changes or {}) do all[name] = value end
  return wear(all)
end
local w = run()
is(w.scheme, "implicit", "the default scheme is implicit")
is(w.tolerance, 1e-3, "the default tolerance")
is(run{ tolerance = 1e-2 }.tolerance, 1e-2, "a given tolerance")
w:run{ distance = 100 }
local file = os.tmpname()
os.remove(file)
w:save(file)
local opened, copy = wear.open(file), w:clone()
os.remove(file)
w:run()
opened:run()
copy:run()
local function same(a, b)
  for name, column in pairs(a.history) do
    for i, x in ipairs(column) do
      local y = b.history[name][i]
      if x ~= y and (x == x or y == y) then return false end
    end
  end
  return true
end
ok(same(w, opened), "a saved run continues with identical bits")
ok(same(w, copy), "a copy of a run continues with identical bits")
do
  local whole, stepped, alike = run{ distance = 60 }, run{ distance = 60 }, 0
  whole:run()
  for _ = 1, whole.update - 1 do
    stepped:step()
    stepped:save(file)
    local rest <close> = wear.open(file)
    os.remove(file)
    rest:run()
    alike = alike + (same(whole, rest) and 1 or 0)
  end
  is(alike, whole.update - 1, "a run saved after any step continues with identical bits")
end
near(w.volume.ball, 0.3 * 1e-8 * 10 * 200, 1e-9, "the volume of the ball is alpha k L d")
near(w.volume.block, 0.7 * 1e-8 * 10 * 200, 1e-9, "the volume of the flat is (1 - alpha) k L d")
is(w.depth.cylinder, w.depth.ball, "the ball has the role name cylinder")
ok(w.history.area[#w.history.area] > w.history.area[1], "the contact area increases with wear")
is(#w.history.half_width_z, #w.history.distance, "the history contains half widths along z")
local depth = w:map("ball")
near(depth:volume().net, w.volume.ball, 1e-9, "the volume of the ball's map is its wear volume")
near(w:map("block", "depth"):volume().net, w.volume.block, 1e-9,
  "the volume of the flat's map is its wear volume")
local profile = w:profile("block", { z = 0 })
near(math.max(table.unpack(profile.h)), w.depth.block, 1e-12,
  "the profile of the flat along x contains its depth")
is(#w:profile("ball", { x = 0 }).h, #depth.z, "the profile of the ball along z has all cells")
ok(tostring(w):find("3-D, half-spaces", 1, true), "print of a run in 3-D: " .. tostring(w))

local shared = run{ distance = 50, workers = 4 }
local alone = run{ distance = 50 }
shared:run()
alone:run()
ok(same(shared, alone), "four workers give identical bits")
local changed, unchanged = run{ distance = 50 }, run{ distance = 50 }
for _, half in ipairs{ changed, unchanged } do half:run{ distance = 25 } end
changed:set{ workers = 2 }
is(changed.workers, 2, "w:set{ workers }")
for _, half in ipairs{ changed, unchanged } do half:run{ distance = 50 } end
ok(same(changed, unchanged), "workers changed in a run give identical bits")
is(wear{ model = m, worn = changed, distance = 5, load = 10, workers = 3 }.workers, 3, "workers of a run on worn surfaces")

local staged = run{ scheme = "explicit" }
staged:run()
is(staged.scheme, "explicit", "a jump selects the explicit scheme")
near(staged.depth.block, w.depth.block, 3e-3, "explicit updates agree with implicit steps")

local sampled = wear{ model = m, alpha = 0.3, distance = 50, load = 10,
  loading = { t = { 0, 0.5, 1 }, x = { -0.02, 0.02, -0.02 }, load = { 10, 10, 10 } } }
sampled:run()
near(sampled.depth.ball, alone.depth.ball, 5e-3, "a loading agrees with the equal stroke")

local s = study{ base = { model = { geometry = "3-D" }, load = 10, stroke = 0.04, distance = 200 }, vary = { alpha = { 0, 1 } } }
s:run{ progress = false, workers = 1 }
is(#s:cases(), 2, "a study of two runs in 3-D")
do
  local case = s:cases()[2]
  local at = case:distances()
  ok(#at >= 5, "a study in 3-D stores surfaces at several distances: " .. #at)
  local row, deepest = 1, 0
  while case.history.distance[row] < at[4] do row = row + 1 end
  local depth, line = case:map("ball", "depth", at[4]), case:profile("ball", at[4])
  for _, h in ipairs(depth.y) do deepest = math.max(deepest, h) end
  is(deepest, case.history.depth_cylinder[row], "the stored map has the depth of its update")
  is(#line.h, #depth.x, "case:profile of a stored map has a point for each row")
  local section = depth:profile{ z = 0 }
  near(line.h[#line.h // 2], section.y[#line.h // 2], 1e-12, "case:profile is the line at z = 0")
  ok(same(case:wear(), case:wear()) and #case:pressure("block").x == #case:wear():map("block").x,
    "case:pressure has the points of the final map")
  fails(function() case:map("ball", "stress") end, 'expected "depth", "height" or "pressure"', "a map of stresses of a case")
end
s:close()

-- --- windows enlarged automatically, tracks of strokes ----------------------------------------------
local function growing() return wear{ model = m, load = 10, stroke = 0.04, alpha = 0.5, distance = 300, k = { distance = { 0, 1000 }, value = { 1e-8, 1e-8 } } } end
local grown = growing()
local narrow = grown:map("ball").x
grown:run{ distance = 150 }
grown:save(file)
local rest = wear.open(file)
os.remove(file)
grown:run()
rest:run()
ok(#grown:map("ball").x > #narrow, "the window grows with the contact")
ok(same(grown, rest), "a saved run with a grown window continues with identical bits")
near(grown.volume.total, 1e-8 * 10 * 300, 1e-9, "the volume is unchanged when the window grows")
local longer = wear{ worn = w, load = 10, stroke = 0.5, distance = 10 }
longer:run()
near(longer.volume.total, 1e-6, 1e-9, "a worn pair continues with a longer stroke")

-- Tests strokes that are an odd number of cells, or much shorter than a cell: both bodies exchanged.
for _, stroke in ipairs{ 0.15, 0.01, 1e-5 } do
  local ball, block = body.ball{ radius = 3.7, radius_z = 9.1, E = 70e3, nu = 0.33 }, body.block{ E = 210e3, nu = 0.28 }
  local function of(upper, lower, alpha)
    warnings.keep()
    local w = wear{ model = model{ geometry = "3-D", upper = upper, lower = lower }, load = 6, stroke = stroke, alpha = alpha, k = 2e-8, distance = 20 }
    w:run{ progress = false }
    warnings.take()
    return w
  end
  local one, two = of(ball, block, 0.3), of(block, ball, 0.7)
  local close = stroke == 1e-5 and 1e-5 or 1e-12
  near(two.depth.lower, one.depth.upper, close, ("stroke %g mm, bodies exchanged: depth of the ball"):format(stroke))
  near(two.depth.upper, one.depth.lower, close, ("stroke %g mm, bodies exchanged: depth of the block"):format(stroke))
  ok(#one:map("lower").x < 80, "the cells do not depend on a short stroke: " .. #one:map("lower").x)
end

-- Tests warnings of limits that wear crosses.
do
  warnings.keep()
  local coarse = { fineness = 0.5 }
  wear{ model = { geometry = "3-D", mesh = coarse }, load = 10, stroke = 0.6, alpha = 0.3, k = 1e-6, distance = 700,
    procedure = "NSP" }:run{ progress = false }
  ok((warnings.take() or ""):find("below 2 they are 15 % and more", 1, true), "a groove that has become short gives a warning")
  warnings.keep()
  wear{ model = { geometry = "3-D", upper = body.ball{ radius = 2 }, mesh = coarse }, track = 40, load = 10, k = 1e-6, alpha = 1,
    distance = 3000, tolerance = 1e-2 }:run{ progress = false }
  ok((warnings.take() or ""):find("half-spaces are accurate up to 0.2", 1, true), "a contact that has become wide gives a warning")
end
local tail = { plate = function(x, z) return 1e-3 * math.exp(-(x * x + z * z) / 0.001) end }
ok(contact{ model = m, load = 10, worn = tail }.p_max > 0, "depths that vanish towards the border")

local groove = wear{ model = m, load = 10, stroke = 1, alpha = 0.5, distance = 100, procedure = "NSP" }
groove:run()
near(groove.volume.block, 0.5 * 1e-8 * 10 * 100, 1e-9, "volume of the flat with a groove")
near(math.max(table.unpack(groove:profile("block", { x = 0 }).h)), groove.depth.block, 1e-12,
  "the section of a groove contains the largest depth")
fails(function() groove:map "block" end, "{ x = 0 }", "a map of a groove")
fails(function() run{ procedure = "NSP", stroke = 0.1 } end, "'procedure'",
  "a groove shorter than two contact widths")

-- --- elliptic and round contacts -------------------------------------------------------------------
local function on_flat(rx, rz) return model{ geometry = "3-D", upper = body.ball{ radius = rx, radius_z = rz }, lower = body.block{} } end
local function factor(x) return x > 0 and 2 or 1 end
local across = run{ model = on_flat(20, 5), slide = "z", distance = 10, local_factor = function(_, _, _, _, z) return factor(z) end }
local along = run{ model = on_flat(5, 20), distance = 10, local_factor = function(_, x) return factor(x) end }
across:run{ distance = 5 }
across:save(file)
local resumed = wear.open(file, { local_factor = across.local_factor })
os.remove(file)
across:run()
along:run{ distance = 5 }
along:run()
resumed:run()
is(across.depth.block, along.depth.block, "a motion along z with exchanged radii: identical depth")
is(across.volume.ball, along.volume.ball, "a motion along z with exchanged radii: identical volume")
is(resumed.depth.block, across.depth.block, "a saved run along z continues with identical bits")
is(across.half_width_z, along.half_width,
  "the half width along z equals the half width along x of the exchanged pair")
local turned, straight = across:map "block", along:map "block"
ok(#turned.x == #straight.z and #turned.z == #straight.x,
  "the maps of the exchanged pair have exchanged sizes")
near(turned:at(0.01, 0.03), straight:at(0.03, 0.01), 1e-12,
  "the maps of the exchanged pair have exchanged axes")
is(#across:profile("block", { x = 0 }).h, #turned.z, "a profile along z has all cells")
fails(function() across:set{ slide = "x", distance = 20 } end, "'slide'", "w:set of another axis of motion")
fails(function() run{ model = on_flat(20, 5), worn = across } end, "'slide'",
  "a worn shape from a run along another axis")
fails(function() contact{ model = across.model, worn = across, x = 0.1 } end, "'x'",
  "a position of a contact on a groove")

fails(function() wear{ model = m, load = 10, track = 0.1, cycles = 2 } end,
  "'track': expected more than the contact's width",
  "a track narrower than the contact")
fails(function() wear{ model = m, load = 10, track = 5, cycles = 2, procedure = "SP" } end, "'procedure'",
  "a track with procedure SP")
local disc = wear{ model = m, load = 10, track = 10, cycles = 2, alpha = 0.3 }
disc:run()
near(disc.distance, 2 * 2 * math.pi * 10, 1e-12, "pin on disc: a cycle is a revolution")
near(disc.volume.block, 0.7 * 1e-8 * 10 * disc.distance, 1e-9, "pin on disc: volume of the disc")
local track = disc:profile("block", { x = 0 })
local section = 0
for i = 2, #track.x do section = section + (track.h[i] + track.h[i - 1]) / 2 * (track.x[i] - track.x[i - 1]) end
near(section * 2 * math.pi * 10, disc.volume.block, 1e-3,
  "pin on disc: the volume is the section times the length of the track")

local turned_pair = model{ geometry = "3-D", upper = body.block{}, lower = body.ball{} }
fails(function() run{ model = turned_pair, procedure = "NSP", stroke = 1 } end, "a lower body.block{}",
  "a groove on a lower ball")

-- --- unsupported options ---------------------------------------------------------------------------
for _, wrong in ipairs{
  { { law = "energy" }, "'law'" }, { { update = "increment" }, "'update'" }, { { slip = "total" }, "'slip'" },
  { { law = "threshold", scheme = "implicit" }, "jump = \"auto\"" }, { { stroke = 1e4 }, "'increments'" },
} do
  fails(function() run(wrong[1]) end, wrong[2], "refused: " .. wrong[2])
end
for _, wrong in ipairs{
  { { mesh = { rows = 2 } }, "mesh.rows" }, { { mesh = { far = 1 } }, "mesh.far" }, { { mesh = { height = 1 } }, "mesh.height" },
  { { mesh = { element = "CPE4" } }, "mesh.element" }, { { thickness = 2 }, "thickness" }, { { axis = 1 }, "axis" },
  { { lower = body.block{ width = 1 } }, "lower.width" }, { { upper = body.cylinder{} }, "upper" },
  { { upper = body.block{} }, "upper" },
} do
  wrong[1].geometry = "3-D"
  fails(function() model(wrong[1]) end, wrong[2], "refused: " .. wrong[2])
end
fails(function() model{ upper = body.ball{} } end, "3-D", "a ball in a plane model")
fails(function() return w.mesh end, "no meshes", "a run in 3-D has no mesh")
fails(function() body.cup{ clearance = 0.1 } end, "joint{", "a cup as a body of a model")

warnings.keep()
contact{ model = { geometry = "3-D", upper = body.ball{ radius = 0.5 }, lower = body.block{} }, load = 500 }
ok((warnings.take() or ""):find("along x is 0.24 of the radius 0.5 mm: half-spaces are accurate up to 0.2", 1, true),
  "a contact too large for half-spaces gives a warning")
do
  local at = {}
  for i = -40, 40 do at[#at + 1] = 0.1 * i end
  local groove = _G.map{ x = at, z = at, y = function(_, z) return z * z / 26 end }
  contact{ model = { geometry = "3-D", upper = body.ball{ radius = 10 }, lower = body.map{ y = groove } }, load = 16000 }
  ok((warnings.take() or ""):find("along z is 0.21 of the radius 10 mm: half-spaces", 1, true),
    "a contact in a groove that is wide only across it gives a warning")
end

-- --- thin coatings, warnings for coarse cells ---------------------------------------------------------
local coat = body.block{ layers = { { thickness = 0.001, E = 400e3 } } }
local thin = contact{ model = model{ geometry = "3-D", upper = body.ball{ radius = 10 }, lower = coat }, load = 10 }
near(thin.p_max, c.p_max, 0.02, "cells of a contact with a coating of 1 um resolve the coating")
fails(function() contact{ model = { geometry = "3-D", lower = coat, mesh = { size = 0.01 } }, load = 10 } end,
  "too wide for a layer of 0.001 mm",
  "cells wider than four coatings")
near(contact{ model = { geometry = "3-D", mesh = { size = 0.06 } }, load = 10 }.approach, c.approach, 0.2,
  "cells almost as wide as the contact")
fails(function() wear{ model = { geometry = "3-D", mesh = { size = 1e-4 } }, load = 10, stroke = 0.1 } end,
  "expected at most 4096 x 4096; use a mesh.size above 0.0001 mm",
  "a window with too many cells")
fails(function() contact{ model = { geometry = "3-D", mesh = { size = 1e-300 } }, load = 10 } end,
  "expected at most 4096 x 4096; use a mesh.size above",
  "a number of cells above the largest integer")
fails(function() wear{ model = { geometry = "3-D", mesh = { size = 5e-4 } }, load = 1000, stroke = 0.9 } end,
  "GB are free: use a mesh.size above 0.0005 mm, a shorter motion",
  "a window larger than the free memory")
for _, cells in ipairs{ 1, 2, 4 } do
  local of_coat = body.block{ layers = { { thickness = 0.005, E = 50e3 } } }
  local function by(size) return contact{ model = { geometry = "3-D", lower = of_coat, mesh = { size = size } }, load = 10 } end
  near(by(0.005 * cells).p_max, by(0.00125).p_max, 5e-3,
    "pressure on cells of " .. cells .. " times the coating thickness")
end

local below = c:stress{ z = 0 }
local largest, where = 0, nil
for k, value in ipairs(below.mises.y) do
  if value > largest then largest, where = value, below.mises.z[(k - 1) % #below.mises.z + 1] end
end
near(largest, 0.620 * c.p_max, 0.01, "the largest von Mises stress below a ball is 0.62 p0")
near(-where, 0.48 * c.half_width, 0.1, "the largest von Mises stress is at the depth 0.48 a")
local surface = c:stress{ y = 0, body = "ball" }
near(surface.syy:at(0, 0), -c.p_center, 1e-2, "sigma_yy at the surface is the negative pressure")
near(surface.sxx:at(0, 0), -0.8 * c.p_center, 2e-2, "sigma_xx at the centre of the surface is -0.8 p0")
near(c:stress{ x = 0 }.szz:at(0, 0), surface.szz:at(0, 0), 1e-9,
  "stress sections agree with the surface plane")
for i, middle in ipairs{ c:stress(), c:stress{} } do
  near(middle.szz:at(0, 0), c:stress{ z = 0 }.szz:at(0, 0), 1e-15, ("stress without a position is the section z = 0, %d"):format(i))
end
fails(function() c:stress{ x = 0, y = -1 } end, "got x and y", "a stress section with two positions")
fails(function() c:stress{ y = 1 } end, "'y'", "stresses above the surface")
fails(function() c:stress{ z = 9 } end, "'z': expected a number from", "a stress section outside the window")
fails(function()
  contact{ model = { geometry = "3-D", lower = body.block{ height = 1 } }, load = 10 }:stress{ y = -0.1 }
end, "homogeneous half-space", "stresses in a body on a rigid base")
fails(function() w:combined() end, "half-spaces", "the combined profile of a run in 3-D")
fails(function() export.inp(m, "x.inp") end, "half-spaces", "an input deck of a model in 3-D")
fails(function() w:set{ mesh = { size = 0.01 } } end, "mesh", "w:set of another cell size")

-- --- start depths -----------------------------------------------------------------------------------
local maps = { ball = opened:map "ball", block = opened:map "block" }
local from_maps, from_run = run{ worn = maps, distance = 20 }, run{ worn = opened, distance = 20 }
near(from_maps.depth.block, from_run.depth.block, 1e-6, "depths of a start from maps")
from_maps:run()
from_run:run()
near(from_maps.depth.block, from_run.depth.block, 1e-4, "a run from maps agrees with a start from the run")
local groove_depth = function(x, z) return math.abs(x) < 0.5 and math.max(0, 1e-4 - z * z / 20) or 0 end
local pressed = contact{ model = m, load = 10, worn = { block = groove_depth } }
ok(pressed.half_width_z > 1.02 * pressed.half_width, "a worn groove given as a function")
for _, wrong in ipairs{
  { function() return 1 end, "0 at the border of the window" }, { function() return -1 end, "expected a depth >= 0 in mm, got -1" },
  { { x = { 0, 1 }, h = { 0, 1 } }, "a function (x, z) -> depth or a map" }, { { x = { 1 }, y = { 1 }, z = { 1 } }, "expected a map, as returned by map{}" },
  { _G.map{ x = { -1, 0, 1 }, z = { -1, 0, 1 }, y = { 0, 0, 0, 0, -1, 0, 0, 0, 0 } }, "expected depths >= 0 mm" },
} do
  fails(function() run{ worn = { ball = wrong[1] } } end, wrong[2], "refused worn shape: " .. wrong[2])
end
fails(function() wear{ worn = { plate = maps.ball } } end, "maps are for geometry",
  "a map as worn shape in a plane model")

fails(function() plot.mesh(m) end, "a model with meshes, got one without", "plot.mesh of a model in 3-D")
fails(function() plot.map(w, "width") end, "what", "plot.map of an unknown quantity")

-- --- pictures and files ------------------------------------------------------------------------------
local folder = os.tmpname()
os.remove(folder)
assert(os.execute("mkdir " .. folder))
local function exists(name)
  local opened <close> = io.open(folder .. "/" .. name)
  return opened ~= nil
end
is(select("#", export.vti(w, folder .. "/w.vti")), 2, "export.vti of a run writes a file for each body")
ok(exists "w-ball.vti" and exists "w-block.vti", "names of the .vti files")
local text <close> = io.open(folder .. "/w-block.vti")
local contents = text:read "a"
for _, name in ipairs{ "depth", "height", "pressure" } do ok(contents:find('Name="' .. name .. '"', 1, true),
  "a .vti file contains the " .. name) end
fails(function() export.vti(w, folder .. "/w.vti", { body = "ball" }) end, "unknown field 'body'", "export.vti with a body")
do
  local trace = { x = { -0.05, 0, 0.05 }, h = { 0, 1e-4, 0 } }
  fails(function() plot.profile(w, "ball", { measured = trace, file = folder .. "/m.gp" }) end, "expected section = { x = 0 }",
    "a measured trace over two sections")
  plot.profile(w, "ball", { measured = trace, section = { x = 0 }, file = folder .. "/m.gp" })
  local text = assert(io.open(folder .. "/m.gp")):read "a"
  ok(text:find("z / mm", 1, true) and text:find("measured", 1, true), "plot.profile draws a trace over the section across the motion")
end
is(export.vti(c, folder .. "/c.vti"), folder .. "/c.vti", "export.vti of a contact")
is(select("#", export.vti(disc, folder .. "/d.vti")), 1, "export.vti writes no map of a groove")
local series = run{ distance = 20 }
series:run{ progress = export.pvd(series, folder .. "/s.pvd", { every = 1 }) }
ok(exists "s.pvd" and exists "s-00001-ball.vti", "export.pvd of a run writes its states as .vti files")
os.execute("rm -r " .. folder)
local picture = os.tmpname() .. ".txt"
plot.stress(c, { section = { x = 0 }, file = picture, term = "dumb" })
local shown <close> = io.open(picture)
ok(shown:read "a":find("von Mises stress of the block, x = 0 mm", 1, true), "plot.stress of a section")
os.remove(picture)
plot.animate(series, { what = "stroke", frames = 2, term = "dumb" })
fails(function() plot.stress(c, { section = { x = 0 }, component = "principal" }) end, "'component'",
  "a stress that sections do not have")
fails(function() plot.stress(c, { section = { x = 0, y = 0 } }) end, "expected one of them",
  "a stress section at x and y")
fails(function() plot.stress(contact{}, { section = { x = 0 } }) end, "'section'",
  "a stress section of a plane contact")
fails(function() plot.animate(wear{}, { what = "stroke" }) end, "'what'",
  "an animation over a stroke in a plane model")

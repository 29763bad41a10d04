-- Tests contact and wear in three dimensions: balls and rollers on flats as half-spaces, from the definition
-- to the file.
local tap = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/tap.lua")
local is, ok, near, fails = tap.is, tap.ok, tap.near, tap.fails

local m = model{ geometry = "3-D" }
ok(tostring(m):find("half-spaces", 1, true), "print(model): " .. tostring(m))
ok(tostring(m):find("radius 10 mm along x, 10 mm along z", 1, true), "alone it is a ball of 10 mm")

-- --- Hertz -----------------------------------------------------------------------------------------
local h = hertz{ geometry = "3-D", radius = 5, radius_z = 20, load = 20 }
near(h.half_width, 0.0683891, 1e-5, "half width along x by formula")
near(h.half_width_z, 0.171021, 1e-5, "half width along z")
near(h.p_max, 816.46, 1e-5, "largest pressure")
near(h.approach, 1.19891e-3, 1e-5, "approach")
fails(function() hertz{ radius_z = 3 } end, "3-D", "two radii need geometry = \"3-D\"")

local roller = model{ geometry = "3-D", upper = body.ball{ radius = 5, radius_z = 20 }, lower = body.block{} }
local c = contact{ model = roller, load = 20 }
near(c.p_max, h.p_max, 3e-3, "a crowned roller's pressure")
near(c.half_width, h.half_width, 0.02, "its half widths")
near(c.half_width_z, h.half_width_z, 0.02, "half width along z")
near(c.approach, h.approach, 3e-3, "its approach")
near(c.area, math.pi * h.half_width * h.half_width_z, 0.03, "its area")

-- --- one contact -----------------------------------------------------------------------------------
c = contact{ model = m, load = 10 }
near(c.p_center, 615.942, 3e-3, "pressure in the centre")
near(c.approach, 7.75179e-4, 2e-3, "approach")
local map = c:pressure()
near(map:volume().net, 10, 1e-3, "the pressures carry the load")
local line = c:pressure{ z = 0 }
is(#line.x, #line.p, "a section is a line")
near(math.max(table.unpack(line.p)), c.p_max, 1e-12, "through the largest pressure")
local across = c:pressure{ x = 0 }
near(across.p[#across.p // 2], line.p[#line.p // 2], 1e-9, "the same in z as in x")
fails(function() c:pressure{ z = 9 } end, "'z': expected a position", "a section beside the window")
fails(function() c:pressure{ y = 0 } end, "unknown field 'y'", "an unknown section")
near(c:move{ x = 0.05 }.p_max, c.p_max, 1e-2, "a moved contact")

-- --- wear ------------------------------------------------------------------------------------------
local function run(changes)
  local all = { model = m, load = 10, stroke = 0.04, alpha = 0.3, distance = 200 }
  for name, value in pairs(changes or {}) do all[name] = value end
  return wear(all)
end
local w = run()
is(w.scheme, "implicit", "the default scheme is implicit")
is(w.tolerance, 1e-3, "with a tolerance")
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
ok(same(w, copy), "a copy, too")
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
  is(alike, whole.update - 1, "saved after any step")
end
near(w.volume.ball, 0.3 * 1e-8 * 10 * 200, 1e-9, "the ball's volume is alpha k L d")
near(w.volume.block, 0.7 * 1e-8 * 10 * 200, 1e-9, "volume of the flat")
is(w.depth.cylinder, w.depth.ball, "bodies answer to their usual words")
ok(w.history.area[#w.history.area] > w.history.area[1], "the history has areas")
is(#w.history.half_width_z, #w.history.distance, "half widths along z in the history")
local depth = w:map("ball")
near(depth:volume().net, w.volume.ball, 1e-9, "a map's volume is the run's")
near(w:map("block", "depth"):volume().net, w.volume.block, 1e-9, "the flat's, too")
local profile = w:profile("block", { z = 0 })
near(math.max(table.unpack(profile.h)), w.depth.block, 1e-12, "a section along x")
is(#w:profile("ball", { x = 0 }).h, #depth.z, "a section along z")
ok(tostring(w):find("3-D, half-spaces", 1, true), "print(w): " .. tostring(w))

local shared = run{ distance = 50, workers = 4 }
local alone = run{ distance = 50 }
shared:run()
alone:run()
ok(same(shared, alone), "four workers: the same bits")

local staged = run{ jump = "auto" }
staged:run()
is(staged.scheme, "explicit", "a jump selects the explicit scheme")
near(staged.depth.block, w.depth.block, 3e-3, "explicit updates come to the same")

local sampled = wear{ model = m, alpha = 0.3, distance = 50, load = 10,
  loading = { t = { 0, 0.5, 1 }, x = { -0.02, 0.02, -0.02 }, load = { 10, 10, 10 } } }
sampled:run()
near(sampled.depth.ball, alone.depth.ball, 5e-3, "the stroke as a loading of one's own")

local s = study{ base = { model = { geometry = "3-D" }, load = 10, stroke = 0.04, distance = 20 }, vary = { alpha = { 0, 1 } } }
s:run{ progress = false, workers = 1 }
is(#s:cases(), 2, "a study of runs in 3-D")
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
ok(#grown:map("ball").x > #narrow, "the window has grown")
ok(same(grown, rest), "to the same bits from a file")
near(grown.volume.total, 1e-8 * 10 * 300, 1e-9, "no wear is lost when the window grows")
local longer = wear{ worn = w, load = 10, stroke = 0.5, distance = 10 }
longer:run()
near(longer.volume.total, 1e-6, 1e-9, "a worn pair continues with a longer stroke")

local groove = wear{ model = m, load = 10, stroke = 1, alpha = 0.5, distance = 100, procedure = "NSP" }
groove:run()
near(groove.volume.block, 0.5 * 1e-8 * 10 * 100, 1e-9, "long strokes as a groove")
near(math.max(table.unpack(groove:profile("block", { x = 0 }).h)), groove.depth.block, 1e-12, "the deepest point of a groove's section")
fails(function() groove:map "block" end, "{ x = 0 }", "a groove has no map")
fails(function() run{ procedure = "NSP", stroke = 0.1 } end, "'procedure'", "a groove shorter than two contacts")

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
is(across.depth.block, along.depth.block, "a motion along z with the radii exchanged: the same to the bit")
is(across.volume.ball, along.volume.ball, "volume of wear across the motion")
is(resumed.depth.block, across.depth.block, "from a file, too")
is(across.half_width_z, along.half_width, "half widths keep their axes")
local turned, straight = across:map "block", along:map "block"
ok(#turned.x == #straight.z and #turned.z == #straight.x, "maps keep theirs")
near(turned:at(0.01, 0.03), straight:at(0.03, 0.01), 1e-12, "the same map, turned")
is(#across:profile("block", { x = 0 }).h, #turned.z, "sections, too")
fails(function() across:set{ slide = "x", distance = 20 } end, "'slide'", "no other axis for worn surfaces")
fails(function() run{ model = on_flat(20, 5), worn = across } end, "'slide'", "slide of a start shape")
fails(function() contact{ model = across.model, worn = across, x = 0.1 } end, "'x'", "x of a contact from a groove")

fails(function() wear{ model = m, load = 10, track = 0.1, cycles = 2 } end, "'track': expected more than the contact's width", "a narrow track")
fails(function() wear{ model = m, load = 10, track = 5, cycles = 2, procedure = "SP" } end, "'procedure'", "a track with both ways")
local disc = wear{ model = m, load = 10, track = 10, cycles = 2, alpha = 0.3 }
disc:run()
near(disc.distance, 2 * 2 * math.pi * 10, 1e-12, "a pin on a disc: a cycle is a revolution")
near(disc.volume.block, 0.7 * 1e-8 * 10 * disc.distance, 1e-9, "the disc's share")
local track = disc:profile("block", { x = 0 })
local section = 0
for i = 2, #track.x do section = section + (track.h[i] + track.h[i - 1]) / 2 * (track.x[i] - track.x[i - 1]) end
near(section * 2 * math.pi * 10, disc.volume.block, 1e-3, "is the section of the track all round")

local turned_pair = model{ geometry = "3-D", upper = body.block{}, lower = body.ball{} }
fails(function() run{ model = turned_pair, procedure = "NSP", stroke = 1 } end, "a lower body.block{}", "a groove on a ball")

-- --- unsupported options ---------------------------------------------------------------------------
for _, wrong in ipairs{
  { { law = "energy" }, "'law'" }, { { update = "increment" }, "'update'" }, { { slip = "total" }, "'slip'" },
  { { law = "threshold" }, "jump = \"auto\"" }, { { stroke = 1e4 }, "'increments'" },
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
fails(function() model{ upper = body.ball{} } end, "3-D", "a ball in the plane")
fails(function() return w.mesh end, "no meshes", "no meshes")
fails(function() body.cup{ clearance = 0.1 } end, "joint{", "a cup is a part of a joint")

local warnings = require "archard.warnings"
warnings.keep()
contact{ model = { geometry = "3-D", upper = body.ball{ radius = 0.5 }, lower = body.block{} }, load = 500 }
ok((warnings.take() or ""):find("0.24 of the radius 0.5 mm: half-spaces are accurate up to 0.2", 1, true), "a contact beyond half-spaces")

-- --- thin coatings, warnings for coarse cells ---------------------------------------------------------
local coat = body.block{ layers = { { thickness = 0.001, E = 400e3 } } }
local thin = contact{ model = model{ geometry = "3-D", upper = body.ball{ radius = 10 }, lower = coat }, load = 10 }
near(thin.p_max, c.p_max, 0.02, "a coat of 1 um has cells that resolve it")
fails(function() contact{ model = { geometry = "3-D", lower = coat, mesh = { size = 0.01 } }, load = 10 } end, "too wide for a layer of 0.001 mm", "cells wider than four layers")
near(contact{ model = { geometry = "3-D", mesh = { size = 0.06 } }, load = 10 }.approach, c.approach, 0.2, "cells nearly as wide as the contact")
fails(function() wear{ model = { geometry = "3-D", mesh = { size = 1e-4 } }, load = 10, stroke = 0.1 } end, "expected at most 4096 x 4096; use a mesh.size above 0.0001 mm", "windows of too many cells")
fails(function() contact{ model = { geometry = "3-D", mesh = { size = 1e-300 } }, load = 10 } end, "expected at most 4096 x 4096; use a mesh.size above", "a number of cells above the largest integer")
fails(function() wear{ model = { geometry = "3-D", mesh = { size = 5e-4 } }, load = 1000, stroke = 0.9 } end, "GB are free: use a mesh.size above 0.0005 mm, a shorter motion", "windows beyond memory")
for _, cells in ipairs{ 1, 2, 4 } do
  local of_coat = body.block{ layers = { { thickness = 0.005, E = 50e3 } } }
  local function by(size) return contact{ model = { geometry = "3-D", lower = of_coat, mesh = { size = size } }, load = 10 } end
  near(by(0.005 * cells).p_max, by(0.00125).p_max, 5e-3, "cells as wide as " .. cells .. " coats")
end

local below = c:stress{ z = 0 }
local largest, where = 0, nil
for k, value in ipairs(below.mises.y) do
  if value > largest then largest, where = value, below.mises.z[(k - 1) % #below.mises.z + 1] end
end
near(largest, 0.620 * c.p_max, 0.01, "von Mises below a ball: 0.62 p0")
near(-where, 0.48 * c.half_width, 0.1, "0.48 a deep")
local surface = c:stress{ y = 0, body = "ball" }
near(surface.syy:at(0, 0), -c.p_center, 1e-2, "at the surface the pressure")
near(surface.sxx:at(0, 0), -0.8 * c.p_center, 2e-2, "stress along x at the centre")
near(c:stress{ x = 0 }.szz:at(0, 0), surface.szz:at(0, 0), 1e-9, "sections and planes agree")
for i, middle in ipairs{ c:stress(), c:stress{} } do
  near(middle.szz:at(0, 0), c:stress{ z = 0 }.szz:at(0, 0), 1e-15, ("stress without a position is the section z = 0, %d"):format(i))
end
fails(function() c:stress{ x = 0, y = -1 } end, "got x and y", "two places")
fails(function() c:stress{ y = 1 } end, "'y'", "above the surface")
fails(function() c:stress{ z = 9 } end, "'z': expected a number from", "beside the window")
fails(function()
  contact{ model = { geometry = "3-D", lower = body.block{ height = 1 } }, load = 10 }:stress{ y = -0.1 }
end, "homogeneous half-space", "stresses in layers")
fails(function() w:combined() end, "half-spaces", "no combined profile")
fails(function() export.inp(m, "x.inp") end, "half-spaces", "no input deck")
fails(function() w:set{ mesh = { size = 0.01 } } end, "mesh", "cells stay")

-- --- start depths -----------------------------------------------------------------------------------
local maps = { ball = opened:map "ball", block = opened:map "block" }
local from_maps, from_run = run{ worn = maps, distance = 20 }, run{ worn = opened, distance = 20 }
near(from_maps.depth.block, from_run.depth.block, 1e-6, "depths from maps")
from_maps:run()
from_run:run()
near(from_maps.depth.block, from_run.depth.block, 1e-4, "start from maps equals start from the run")
local groove_depth = function(x, z) return math.abs(x) < 0.5 and math.max(0, 1e-4 - z * z / 20) or 0 end
local pressed = contact{ model = m, load = 10, worn = { block = groove_depth } }
ok(pressed.half_width_z > 1.02 * pressed.half_width, "a groove by a function")
for _, wrong in ipairs{
  { function() return 1 end, "0 at the border of the window" }, { function() return -1 end, "expected a depth >= 0 in mm, got -1" },
  { { x = { 0, 1 }, h = { 0, 1 } }, "a function (x, z) -> depth or a map" }, { { x = { 1 }, y = { 1 }, z = { 1 } }, "expected a map, as returned by map{}" },
  { _G.map{ x = { -1, 0, 1 }, z = { -1, 0, 1 }, y = { 0, 0, 0, 0, -1, 0, 0, 0, 0 } }, "expected depths >= 0 mm" },
} do
  fails(function() run{ worn = { ball = wrong[1] } } end, wrong[2], "worn: " .. wrong[2])
end
fails(function() wear{ worn = { plate = maps.ball } } end, "maps are for geometry", "a map in the plane")

fails(function() plot.mesh(m) end, "a model with meshes, got one without", "no mesh to draw")
fails(function() plot.map(w, "width") end, "what", "a map of another name")

-- --- pictures and files ------------------------------------------------------------------------------
local folder = os.tmpname()
os.remove(folder)
assert(os.execute("mkdir " .. folder))
local function exists(name)
  local opened <close> = io.open(folder .. "/" .. name)
  return opened ~= nil
end
is(select("#", export.vti(w, folder .. "/w.vti")), 2, "export.vti of a run: a file for each body")
ok(exists "w-ball.vti" and exists "w-block.vti", "with their names")
local text <close> = io.open(folder .. "/w-block.vti")
local contents = text:read "a"
for _, name in ipairs{ "depth", "height", "pressure" } do ok(contents:find('Name="' .. name .. '"', 1, true), "its " .. name) end
is(export.vti(c, folder .. "/c.vti"), folder .. "/c.vti", "of a contact its pressure")
is(select("#", export.vti(disc, folder .. "/d.vti")), 1, "a groove has no map")
local series = run{ distance = 20 }
series:run{ progress = export.pvd(series, folder .. "/s.pvd", { every = 1 }) }
ok(exists "s.pvd" and exists "s-00001-ball.vti", "export.pvd of a run: states as maps")
os.execute("rm -r " .. folder)
local picture = os.tmpname() .. ".txt"
plot.stress(c, { section = { x = 0 }, file = picture, term = "dumb" })
local shown <close> = io.open(picture)
ok(shown:read "a":find("von Mises stress of the block, x = 0 mm", 1, true), "plot.stress of a section")
os.remove(picture)
plot.animate(series, { what = "stroke", frames = 2, term = "dumb" })
fails(function() plot.stress(c, { section = { x = 0 }, component = "principal" }) end, "'component'", "a stress that sections do not have")
fails(function() plot.stress(c, { section = { x = 0, y = 0 } }) end, "expected one of them", "two sections")
fails(function() plot.stress(contact{}, { section = { x = 0 } }) end, "'section'", "a section in the plane")
fails(function() plot.animate(wear{}, { what = "stroke" }) end, "'what'", "an animation over a stroke in the plane")

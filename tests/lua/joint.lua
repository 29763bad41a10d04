-- Tests balls in sockets: defaults, gaits, contact, wear, messages.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- which would make it too slow.
local tap = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/tap.lua")
local is, ok, near, fails = tap.is, tap.ok, tap.near, tap.fails
local warnings = require "archard.warnings"

-- --- gaits -------------------------------------------------------------------------------------------
near(gait("iso").track, 22.308, 5e-3, "length of the load's track for the ISO gait")
ok(#gait("iso", { increments = 40 }).instants == 2 * #gait("iso").instants,
  "the ISO gait with another number of increments")
fails(function() gait("iso", { order = "zyx" }) end, "unknown field 'order'",
  "an order of rotations for a named gait")
fails(function() gait "walking" end, 'name of a gait, got "walking" (known: iso, prosim)',
  "an unknown name of a gait")
fails(function() wear{ model = joint{}, loading = "iso" } end, 'a gait such as gait "iso"',
  "a name instead of a gait")
fails(function() gait{} end, "expected at least one angle", "a gait without motion")
fails(function() gait{ t = { 0, 50, 100 }, flexion = { 0, 20, 0 } } end,
  "field 't': expected times from 0 to the period 1, got 0 to 100",
  "times in percent without a period")
fails(function() gait{ t = { 0, 0.3, 0.7 }, flexion = { 0, 20, 0 } } end, "got 0 to 0.7",
  "times that end before the period")
is(gait{ t = { 0, 50, 100 }, flexion = { 0, 20, 0 }, period = 100 }.track,
  gait{ flexion = { 0, 20, 0 } }.track,
  "times in percent with a period")
fails(function() gait{ flexion = function(t) return 720 * t end, increments = 2 } end,
  "at most 60 degrees in half an increment",
  "a rotation too fast for the increments")
fails(function() gait({ flexion = { 0, 20, 0 } }, { increments = 40 }) end, "got a second argument",
  "increments as a second argument")
is(tostring(wear{ model = joint{ mesh = { size = 4 } } }.depth_partition), "nan",
  "the depth partition is nan before wear")
near(gait.rocking{ increments = 1000 }.work, 68740, 2e-4, "friction work of the rocking gait")
local own = gait{ flexion = function(t) return 21.5 * math.cos(2 * math.pi * t) end, load = 2000 }
near(own.track, gait.flexion().track, 1e-12, "flexion given as a function")
local list = gait{ flexion = { 0, 10, 0 }, load = { z = 1000 } }
near(list.track, 20 * math.pi / 180 * 14, 1e-9, "flexion given as a list")
local path = os.tmpname()
local file = io.open(path, "w")
file:write("t,flexion,adduction,rotation,load\n0,0,0,0,1000\n0.5,10,0,0,1000\n1,0,0,0,1000\n")
file:close()
near(gait.read(path).track, list.track, 1e-9, "flexion read from a file")
is(gait.read(path).name, path:match "[^/]+$", "the name of a gait is its file name")
do
  local file <close> = io.open(path, "w")
  file:write "t [%],flexion [deg],adduction [rad],load [kN],torque\n0,0,0,1,5\n50,10,0,1,5\n100,0,0,1,5\n"
end
warnings.keep()
near(gait.read(path).track, list.track, 1e-9, "a gait file with units in its header")
ok(warnings.take():find 'column "torque" is not used', "unused columns of a gait file are reported")
gait{ flexion = 0 }
ok(warnings.take():find "the head does not move", "a gait without motion gives a warning")
os.remove(path)
fails(function() gait{ flexion = 0, load = { z = { 1000 } } } end,
  "field 'load.z': expected at least two values",
  "a load with a single value")
fails(function() gait "isso" end, "did you mean 'iso'", "a misspelt name of a gait")
fails(function() gait{ flexion = function(t) return 20 * t end } end, "20 degrees",
  "a gait that does not end at its start")
fails(function() gait{ flexion = 0, order = "xxy" } end, "order", "an invalid order of rotations")

-- --- contact -----------------------------------------------------------------------------------------
local pe = material{ E = 1000, nu = 0.4 }
local liner = joint{ head = { material = material{ E = 1e15 } }, cup = { clearance = 0.1, layers = { { thickness = 8, material = pe } } },
  mesh = { size = 4 } }
local c = contact{ model = liner, load = 3000 }
near(c.p_center, 14.738, 5e-3, "centre pressure of a liner")
near(c.approach[3], 0.158792, 1e-3, "displacement of a liner")
ok(tostring(c):find("load 3000 N") and tostring(c):find("degrees to the rim"),
  "print of a contact: " .. tostring(c))
is(c.p_max, liner:contact{ load = 3000 }.p_max, "contact{} and joint:contact{} give the same pressure")
fails(function() contact{ model = liner, direction = { 0, 0, -1 } } end, "180 degrees",
  "a load that points out of the cup")
local second = joint{ head = { material = material{ E = 1e15 } }, cup = { clearance = 0.1, layers = { { thickness = 8, material = pe } } },
  mesh = { size = 4 }, order = 2 }
near(contact{ model = second, load = 3000 }.p_center / c.p_center - 1, 0.0056, 0.05,
  "effect of the second-order gap on the pressure")
fails(function() joint{ order = 3 } end, "expected 1 or 2", "an unknown order of the gap")
fails(function() joint{ cup = { clearance = 0 } } end, "cup.clearance", "a clearance of zero")
is(tostring(joint{ head = body.ball{ radius = 16, E = 3e5 } }),
  tostring(joint{ head = { radius = 16, material = { E = 3e5 } } }),
  "a body.ball as the head")
fails(function() joint{ head = body.block{} } end,
  "field 'head': expected a body.ball{} or { radius= }, got a body.block{}",
  "a body.block as the head")
fails(function() joint{ head = { diameter = 28 } } end,
  "unknown field 'head.diameter' (did you mean 'radius', half of the diameter?)",
  "a diameter instead of a radius")
fails(function() joint{ head = { radius = 0.014 } } end,
  "below half the radius, head.radius = 0.014 mm, got 0.06",
  "a radius in m instead of mm")
fails(function() joint{ cup = { clearence = 0.1 } } end, "did you mean 'clearance'",
  "a misspelt field of the cup")
fails(function() joint{ head = { layers = { { thickness = 15, material = pe } } } } end, "head.layers",
  "layers thicker than the head")

-- --- wear --------------------------------------------------------------------------------------------
local w = wear{ model = liner, loading = gait "iso", k = 1e-9, alpha = 0, cycles = 1e6 }
w:run()
near(1000 * w.depth.cup, 101.75, 5e-3, "1e6 cycles of walking: depth of the cup [um]")
near(w.volume.cup, 31.483, 2e-3, "wear volume of the cup [mm3]")
is(w.volume.head, 0, "with alpha = 0 the head does not wear")
near(w.p_peak, 7.965, 0.02, "largest pressure of the last cycle")
ok(#w.history.cycle > 5 and #w.history.cycle < 20, "number of error-controlled steps: " .. #w.history.cycle)
is(w.history.cycle[#w.history.cycle], 1e6, "the history ends with the last cycle")
ok(tostring(w):find("mm3/(N m)", 1, true) and tostring(w):find("per million cycles"),
  "print of a run: " .. tostring(w))
ok(tostring(w):find("8 mm of E", 1, true) and tostring(w):find("1e+06 of 1e+06 cycles", 1, true),
  "print of a run shows the bodies and the cycles")
ok(tostring(w.volume):find("cup = ", 1, true) and tostring(w.depth):find("head = ", 1, true), "print(w.volume), print(w.depth)")
local table_of = os.tmpname() .. ".csv"
export.csv(w, table_of)
is(#csv.read(table_of).volume_cup, #w.history.cycle, "the exported history has all rows")
ok(io.open(table_of):read():find("distance [mm],area [mm2],cycle,depth_cup [mm],depth_head [mm],depth_partition,jump,load [N],p_peak [MPa]", 1, true),
  "the exported history has units")
os.remove(table_of)
is(#w:map("cup").values, #w:map("cup").theta * #w:map("cup").phi, "a map has a value for each cell")
near(w:penetration()[3], 0.2, 0.5, "the head moves into the cup along the load")
fails(function() w.k = 5 end, "field 'k' cannot be set: the object is read-only",
  "assignment to a setting of a run")
fails(function() w.cycle = 7 end, "read-only", "assignment to the state of a run")
fails(function() liner.head = nil end, "read-only", "assignment to a field of a joint")
fails(function() w.loading.work = 0 end, "read-only", "assignment to a field of a gait")
local count = 0
for _, column in pairs(w.history) do
  count = count + 1
  ok(#column == #w.history.cycle and column[#column] == column[#column], "a column of the history has numbers")
end
is(count, 13, "number of columns in the history of a joint")
near(w.history.p_peak[1], contact{ model = liner, load = 3000 }.p_max, 0.2,
  "the first row of the history contains the unworn contact")
local springs = joint{ foundation = "winkler", mesh = { size = 6 },
  cup = { clearance = 0.1, layers = { { thickness = 8, material = pe } } } }
local one = wear{ model = springs, k = 1e-9 }:run()
is(wear{ model = springs, k = 1e-9 }:run().depth.cup, one.depth.cup, "a repeated run has identical bits")
fails(function() wear{ model = springs, k = function() error "mine" end }:run() end, "mine",
  "an error in the function k")
local broken = false
local stays = wear{ model = springs, k = function() return broken and -1 or 1e-9 end, updates = 4 }
stays:run{ cycles = 2e5, progress = false }
local before, moved = stays:map "cross shear".values, 0
broken = true
fails(function() stays:run{ progress = false } end, "field 'k'", "a negative k from a function")
for i, share in ipairs(stays:map "cross shear".values) do moved = math.max(moved, math.abs(share - before[i])) end
is(moved, 0, "after a failed update the cross-shear is unchanged")
local half = wear{ model = springs, k = 1e-9, updates = 4, alpha = function(s) return s.cycle < 5e5 and 0 or 0.5 end }:run{ progress = false }
ok(half.volume.head > 0 and half.volume.head < 0.4 * half.volume.total,
  "an alpha that changes with the cycles")
fails(function() wear{ model = springs, alpha = function() return 2 end }:run{ progress = false } end,
  "field 'alpha'",
  "an alpha above 1 from a function")
local seat = wear{ model = springs, k = 1e-9, alpha = 0, updates = 8, creep = function(s) return s.thickness * 1e-3 * s.p_mean end }:run{ progress = false }
local flat_out = wear{ model = springs, k = 1e-9, alpha = 0, updates = 8 }:run{ progress = false }
local most = 0
for _, depth in ipairs(seat:map "creep".values) do most = math.max(most, depth) end
ok(seat.depth.cup < flat_out.depth.cup and seat.volume.cup > 0.95 * flat_out.volume.cup and most > 0.03,
  "creep distributes the wear but does not change the volume")
fails(function() wear{ model = springs, creep = function() error "mine" end }:run{ progress = false } end,
  "mine",
  "an error in the function creep")
local seen, ended = 0, wear{ model = springs, k = 1e-9 }
fails(function()
  ended:run{ progress = function(r)
    seen = seen + 1
    if r.cycle > 1e5 then error "enough" end
  end }
end, "enough", "an error in the progress function ends a run")
is(#ended.history.cycle, seen + 1, "the history contains all complete steps")
ok(ended:run{ progress = false }.cycle == 1e6, "a run ended by progress continues")
local twenty = wear{ model = liner, k = 1e-9, alpha = 0, updates = 20 }:run{ progress = false }
is(#twenty.history.cycle, 21, "a row for each of the given updates")
near(twenty.depth.cup, w.depth.cup, 3e-4, "depth with fewer updates")
fails(function() wear{ model = springs, updates = 5, tolerance = 0.1 } end, "got both",
  "updates and tolerance together")

local function bits(list)
  local words = {}
  for i = 1, #list do words[i] = ("%a"):format(list[i]) end
  return table.concat(words, " ")
end

-- --- runs on worn shapes, blocks of gaits -------------------------------------------------------------
local worn = wear{ model = springs, k = 1e-9, cycles = 1, worn = { cup = function(theta, phi) return 0.02 * math.cos(math.rad(2 * phi)) end } }
near(worn.depth.cup, 0.02, 1e-2, "a worn cup given by a function")
local copy = wear{ model = springs, k = 1e-9, cycles = 1, worn = { cup = worn:map "cup" } }
ok(bits(copy:map "cup".values) == bits(worn:map "cup".values), "a worn cup given by the map of a run")
fails(function() wear{ model = springs, worn = { cup = { 1, 2 } } } end, "worn.cup",
  "a worn cup given by a list of wrong length")
fails(function() wear{ model = springs, worn = { cap = function() return 0 end } } end, "did you mean 'cup'",
  "a worn shape of an unknown body")
fails(function() wear{ model = springs, worn = { cup = function() return "x" end } }:run() end, "worn.cup(",
  "a worn shape function that returns a text")
fails(function() wear{ model = springs, loading = { { gait = gait "iso" }, { gait = gait "iso" } } } end,
  "loading[1]",
  "a first block without a number of cycles")
local blocks = wear{ model = springs, k = 1e-9, cycles = 3e5, loading = { { gait = gait "prosim", cycles = 1e5 }, { gait = gait "iso" } } }
blocks:run{ progress = false }
local ends = {}
for _, cycles in ipairs(blocks.history.cycle) do ends[cycles] = true end
ok(ends[1e5] and blocks.loading.name:find "iso", "a step ends at the end of a block")

-- --- grids that are too coarse ------------------------------------------------------------------------
local loose = joint{ cup = { clearance = 2, layers = { { thickness = 20, material = material{ E = 230e3, nu = 0.3 } } } }, mesh = { size = 4 } }
fails(function() contact{ model = loose, load = 50 } end, "at least 6 cells across the contact, got",
  "a grid too coarse for a contact")
fails(function() wear{ model = loose, loading = gait.flexion{ load = 50 } }:run() end, "mesh.size",
  "a grid too coarse for a run")
local explicit = wear{ model = springs, k = 1e-9, cycles = 1e3, scheme = "explicit", updates = 1 }
local function updates_to(cycles)
  local before = #explicit.history.cycle
  explicit:run{ cycles = cycles, progress = false }
  return #explicit.history.cycle - before
end
local few, many = updates_to(1e3), updates_to(4e5)
ok(many > few and many > 1, ("more cycles need more explicit updates: %d, then %d"):format(few, many))
fails(function() wear{ model = springs, k = function() return 1e-9 end, scheme = "explicit" } end,
  "field 'scheme'",
  "explicit steps with k as a function")
fails(function() wear{ model = springs, alpha = 2 } end, "alpha", "an alpha above 1")
fails(function() w:map "cap" end, "cup", "a map of an unknown body")
local flat = w:flat "cup"
near(1000 * flat:at(0, 0), 1000 * w.depth.cup, 0.05, "a flat map is deepest near the load")
local picture = os.tmpname() .. ".txt"
plot.map(w, { what = "cup", term = "dumb", file = picture })
ok(io.open(picture):read "a":find("cup", 1, true), "plot.map of the cup")
plot.map(w, "cup", { term = "dumb", file = picture, title = "mine" })
ok(io.open(picture):read "a":find("mine", 1, true), "plot.map with a title")
plot.map(w, "head", { file = picture .. ".gp" })
ok(io.open(picture .. ".gp"):read "a":find("cbrange [0:1]", 1, true),
  "plot.map of an unworn body has a scale from 0 to 1")
plot.map(w, "pressure", { file = picture .. ".gp" })
ok(io.open(picture .. ".gp"):read "a":find("rim", 1, true),
  "plot.map of the pressure shows the rim of the cup")
plot.map(w, "cross shear", { file = picture .. ".gp" })
ok(not io.open(picture .. ".gp"):read "a":find("cross-shear /", 1, true), "a label without a unit has no slash")
ok(io.open(picture .. ".gp"):read "a":find("NaN", 1, true), "cross-shear is blank where nothing slides")
plot.track(gait "iso", { term = "dumb", file = picture })
plot.track(w, { term = "dumb", file = picture })
ok(io.open(picture):read "a":find("paths of points", 1, true), "plot.track shows paths of points of the head")
ok(io.open(picture .. ".gp"):read "a":find("anterior", 1, true), "plot.map has the names of the axes")
local single = contact{ model = liner, load = 2000, direction = { 0.1, 0, 1 } }
plot.map(single, { file = picture .. ".gp" })
ok(io.open(picture .. ".gp"):read "a":find("pressure / MPa", 1, true),
  "plot.map of a single contact shows the pressure")
near(single:flat():at(0, 28 * math.sin(math.atan(0.1) / 2)), single.p_max, 0.05,
  "the flat map of a single contact")
fails(function() plot.pressure(single) end, "use plot.map for the maps of a joint",
  "plot.pressure of a joint")
ok(tostring(single):find "load 2000 N", "print of a single contact")
fails(function() single.load = 1 end, "read-only", "assignment to a field of a contact")
fails(function() contact{ model = liner, direction = { 0, 0, 0 } } end, "field 'direction'",
  "a direction of length zero")
near(contact{ model = liner, load = 2000, direction = { 1e199, 0, 1e200 } }.p_max, single.p_max, 1e-9,
  "a direction of any length")
fails(function() wear{ loading = gait "iso" } end, "a gait needs model = joint{}", "a gait without a joint")
fails(function() study.converge{ base = { model = liner, cycles = 1 } } end, "got a joint", "a joint in study.converge")
fails(function() wear{ model = springs, k = 1e-9, updates = 1, creep = function() return -1 end }:run{ progress = false } end,
  "field 'creep'", "a negative creep from a function")
fails(function() plot.track{} end, "expected a gait or the run of a joint", "plot.track of an empty table")
os.remove(picture)
os.remove(picture .. ".gp")

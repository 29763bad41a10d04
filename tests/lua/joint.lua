-- Tests balls in sockets: defaults, gaits, contact, wear, messages.
-- Ordinary collector settings are used (see tests/run): continuous garbage collection would make long runs too slow.
local tap = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/tap.lua")
local is, ok, near, fails = tap.is, tap.ok, tap.near, tap.fails
local warnings = require "archard.warnings"

-- --- gaits -------------------------------------------------------------------------------------------
near(gait("iso").track, 22.308, 5e-3, "track of the walk")
ok(#gait("iso", { increments = 40 }).instants == 2 * #gait("iso").instants, "a walk of other increments")
fails(function() gait("iso", { order = "zyx" }) end, "unknown field 'order'", "the order of a named gait")
fails(function() gait "walking" end, 'name of a gait, got "walking" (known: iso, prosim)', "a gait that there is not")
fails(function() wear{ model = joint{}, loading = "iso" } end, 'a gait such as gait "iso"', "the name alone")
fails(function() gait{} end, "expected at least one angle", "a gait without motion")
fails(function() gait{ t = { 0, 50, 100 }, flexion = { 0, 20, 0 } } end, "field 't': expected times from 0 to the period 1, got 0 to 100", "percent without a period")
fails(function() gait{ t = { 0, 0.3, 0.7 }, flexion = { 0, 20, 0 } } end, "got 0 to 0.7", "a part of a cycle")
is(gait{ t = { 0, 50, 100 }, flexion = { 0, 20, 0 }, period = 100 }.track, gait{ flexion = { 0, 20, 0 } }.track, "percent with a period")
fails(function() gait{ flexion = function(t) return 720 * t end, increments = 2 } end, "at most 60 degrees in half an increment", "turns that increments miss")
fails(function() gait({ flexion = { 0, 20, 0 } }, { increments = 40 }) end, "got a second argument", "increments outside the table")
is(tostring(wear{ model = joint{ mesh = { size = 4 } } }.depth_partition), "nan", "no partition before wear")
near(gait.rocking{ increments = 1000 }.work, 68740, 2e-4, "work of rocking")
local own = gait{ flexion = function(t) return 21.5 * math.cos(2 * math.pi * t) end, load = 2000 }
near(own.track, gait.flexion().track, 1e-12, "flexion by a function")
local list = gait{ flexion = { 0, 10, 0 }, load = { z = 1000 } }
near(list.track, 20 * math.pi / 180 * 14, 1e-9, "flexion by a list")
local path = os.tmpname()
local file = io.open(path, "w")
file:write("t,flexion,adduction,rotation,load\n0,0,0,0,1000\n0.5,10,0,0,1000\n1,0,0,0,1000\n")
file:close()
near(gait.read(path).track, list.track, 1e-9, "flexion from a table")
is(gait.read(path).name, path:match "[^/]+$", "named after its file")
do
  local file <close> = io.open(path, "w")
  file:write "t [%],flexion [deg],adduction [rad],load [kN],torque\n0,0,0,1,5\n50,10,0,1,5\n100,0,0,1,5\n"
end
warnings.keep()
near(gait.read(path).track, list.track, 1e-9, "columns with units")
ok(warnings.take():find "column 'torque' is not used", "other columns are named")
gait{ flexion = 0 }
ok(warnings.take():find "the head does not move", "a gait at rest")
os.remove(path)
fails(function() gait{ flexion = 0, load = { z = { 1000 } } } end, "field 'load.z': expected at least two values", "a load of one value")
fails(function() gait "isso" end, "did you mean 'iso'", "a gait by a wrong name")
fails(function() gait{ flexion = function(t) return 20 * t end } end, "20 degrees", "a gait that does not close")
fails(function() gait{ flexion = 0, order = "xxy" } end, "order", "an order of rotations that is none")

-- --- contact -----------------------------------------------------------------------------------------
local pe = material{ E = 1000, nu = 0.4 }
local liner = joint{ head = { material = material{ E = 1e15 } }, cup = { clearance = 0.1, layers = { { thickness = 8, material = pe } } },
  mesh = { size = 4 } }
local c = contact{ model = liner, load = 3000 }
near(c.p_center, 14.738, 5e-3, "centre pressure of a liner")
near(c.approach[3], 0.158792, 1e-3, "displacement of a liner")
ok(tostring(c):find("load 3000 N") and tostring(c):find("degrees to the rim"), "print(c): " .. tostring(c))
is(c.p_max, liner:contact{ load = 3000 }.p_max, "by either call")
fails(function() contact{ model = liner, direction = { 0, 0, -1 } } end, "180 degrees", "a load out of the cup")
local second = joint{ head = { material = material{ E = 1e15 } }, cup = { clearance = 0.1, layers = { { thickness = 8, material = pe } } },
  mesh = { size = 4 }, order = 2 }
near(contact{ model = second, load = 3000 }.p_center / c.p_center - 1, 0.0056, 0.05, "second order in the displacement")
fails(function() joint{ order = 3 } end, "expected 1 or 2", "an order that there is not")
fails(function() joint{ cup = { clearance = 0 } } end, "cup.clearance", "no clearance")
is(tostring(joint{ head = body.ball{ radius = 16, E = 3e5 } }), tostring(joint{ head = { radius = 16, material = { E = 3e5 } } }), "a ball as the head")
fails(function() joint{ head = body.block{} } end, "field 'head': expected a body.ball{} or { radius= }, got a body.block{}", "a block as the head")
fails(function() joint{ head = { diameter = 28 } } end, "unknown field 'head.diameter' (did you mean 'radius', half of the diameter?)", "a diameter")
fails(function() joint{ head = { radius = 0.014 } } end, "below half the radius, head.radius = 0.014 mm, got 0.06", "a radius in m")
fails(function() joint{ cup = { clearence = 0.1 } } end, "did you mean 'clearance'", "a misspelt field")
fails(function() joint{ head = { layers = { { thickness = 15, material = pe } } } } end, "head.layers", "layers that do not fit")

-- --- wear --------------------------------------------------------------------------------------------
local w = wear{ model = liner, loading = gait "iso", k = 1e-9, alpha = 0, cycles = 1e6 }
w:run()
near(1000 * w.depth.cup, 101.75, 5e-3, "1e6 cycles of walking: depth of the cup [um]")
near(w.volume.cup, 31.483, 2e-3, "wear volume of the cup [mm3]")
is(w.volume.head, 0, "alpha = 0: no wear of the head")
near(w.p_peak, 7.965, 0.02, "largest pressure of the last cycle")
ok(#w.history.cycle > 5 and #w.history.cycle < 20, "a row a step, whose errors are held: " .. #w.history.cycle)
is(w.history.cycle[#w.history.cycle], 1e6, "up to all cycles")
ok(tostring(w):find("mm3/(N m)", 1, true) and tostring(w):find("per million cycles"), "print(w): " .. tostring(w))
ok(tostring(w):find("8 mm of E", 1, true) and tostring(w):find("1e+06 of 1e+06 cycles", 1, true), "with the bodies and the cycles")
ok(tostring(w.volume):find("cup = ", 1, true) and tostring(w.depth):find("head = ", 1, true), "print(w.volume), print(w.depth)")
local table_of = os.tmpname() .. ".csv"
export.csv(w, table_of)
is(#csv.read(table_of).volume_cup, #w.history.cycle, "its history as a table")
ok(io.open(table_of):read():find("distance [mm],area [mm2],cycle,depth_cup [mm],depth_head [mm],depth_partition,jump,load [N],p_peak [MPa]", 1, true),
  "with units")
os.remove(table_of)
is(#w:map("cup").values, #w:map("cup").theta * #w:map("cup").phi, "a map")
near(w:penetration()[3], 0.2, 0.5, "the head sinks in along the load")
fails(function() w.k = 5 end, "field 'k' cannot be set: the object is read-only", "runs are read-only")
fails(function() w.cycle = 7 end, "read-only", "their state too")
fails(function() liner.head = nil end, "read-only", "joints are")
fails(function() w.loading.work = 0 end, "read-only", "and gaits")
local count = 0
for _, column in pairs(w.history) do
  count = count + 1
  ok(#column == #w.history.cycle and column[#column] == column[#column], "a column of the history has numbers")
end
is(count, 13, "columns of a joint")
near(w.history.p_peak[1], contact{ model = liner, load = 3000 }.p_max, 0.2, "its first row has the unworn contact")
local springs = joint{ foundation = "winkler", mesh = { size = 6 },
  cup = { clearance = 0.1, layers = { { thickness = 8, material = pe } } } }
local one = wear{ model = springs, k = 1e-9 }:run()
is(wear{ model = springs, k = 1e-9 }:run().depth.cup, one.depth.cup, "the same bits again")
fails(function() wear{ model = springs, k = function() error "mine" end }:run() end, "mine", "an error of k")
local broken = false
local stays = wear{ model = springs, k = function() return broken and -1 or 1e-9 end, updates = 4 }
stays:run{ cycles = 2e5, progress = false }
local before, moved = stays:map "cross shear".values, 0
broken = true
fails(function() stays:run{ progress = false } end, "field 'k'", "a k below zero")
for i, share in ipairs(stays:map "cross shear".values) do moved = math.max(moved, math.abs(share - before[i])) end
is(moved, 0, "cross-shear stays that of the last whole update")
local half = wear{ model = springs, k = 1e-9, updates = 4, alpha = function(s) return s.cycle < 5e5 and 0 or 0.5 end }:run{ progress = false }
ok(half.volume.head > 0 and half.volume.head < 0.4 * half.volume.total, "a share that changes")
fails(function() wear{ model = springs, alpha = function() return 2 end }:run{ progress = false } end, "field 'alpha'", "one above 1")
local seat = wear{ model = springs, k = 1e-9, alpha = 0, updates = 8, creep = function(s) return s.thickness * 1e-3 * s.p_mean end }:run{ progress = false }
local flat_out = wear{ model = springs, k = 1e-9, alpha = 0, updates = 8 }:run{ progress = false }
local most = 0
for _, depth in ipairs(seat:map "creep".values) do most = math.max(most, depth) end
ok(seat.depth.cup < flat_out.depth.cup and seat.volume.cup > 0.95 * flat_out.volume.cup and most > 0.03, "creep spreads wear, its volume stays")
fails(function() wear{ model = springs, creep = function() error "mine" end }:run{ progress = false } end, "mine", "an error of creep")
local seen, ended = 0, wear{ model = springs, k = 1e-9 }
fails(function()
  ended:run{ progress = function(r)
    seen = seen + 1
    if r.cycle > 1e5 then error "enough" end
  end }
end, "enough", "a progress function ends a run")
is(#ended.history.cycle, seen + 1, "after its last whole step")
ok(ended:run{ progress = false }.cycle == 1e6, "a run ended by progress continues")
local twenty = wear{ model = liner, k = 1e-9, alpha = 0, updates = 20 }:run{ progress = false }
is(#twenty.history.cycle, 21, "a row for each of the given updates")
near(twenty.depth.cup, w.depth.cup, 3e-4, "depth with fewer updates")
fails(function() wear{ model = springs, updates = 5, tolerance = 0.1 } end, "got both", "updates and a tolerance")

local function bits(list)
  local words = {}
  for i = 1, #list do words[i] = ("%a"):format(list[i]) end
  return table.concat(words, " ")
end

-- --- runs on worn shapes, blocks of gaits -------------------------------------------------------------
local worn = wear{ model = springs, k = 1e-9, cycles = 1, worn = { cup = function(theta, phi) return 0.02 * math.cos(math.rad(2 * phi)) end } }
near(worn.depth.cup, 0.02, 1e-2, "worn by a function")
local copy = wear{ model = springs, k = 1e-9, cycles = 1, worn = { cup = worn:map "cup" } }
ok(bits(copy:map "cup".values) == bits(worn:map "cup".values), "worn by the map of a run")
fails(function() wear{ model = springs, worn = { cup = { 1, 2 } } } end, "worn.cup", "a list of another length")
fails(function() wear{ model = springs, worn = { cap = function() return 0 end } } end, "did you mean 'cup'", "a body that there is not")
fails(function() wear{ model = springs, worn = { cup = function() return "x" end } }:run() end, "worn.cup(", "no depth")
fails(function() wear{ model = springs, loading = { { gait = gait "iso" }, { gait = gait "iso" } } } end, "loading[1]", "a block without an end")
local blocks = wear{ model = springs, k = 1e-9, cycles = 3e5, loading = { { gait = gait "prosim", cycles = 1e5 }, { gait = gait "iso" } } }
blocks:run{ progress = false }
local ends = {}
for _, cycles in ipairs(blocks.history.cycle) do ends[cycles] = true end
ok(ends[1e5] and blocks.loading.name:find "iso", "a block ends where it is to")

-- --- grids that are too coarse ------------------------------------------------------------------------
local loose = joint{ cup = { clearance = 2, layers = { { thickness = 20, material = material{ E = 230e3, nu = 0.3 } } } }, mesh = { size = 4 } }
fails(function() contact{ model = loose, load = 50 } end, "at least 6 cells across the contact, got", "a grid too coarse for a contact")
fails(function() wear{ model = loose, loading = gait.flexion{ load = 50 } }:run() end, "mesh.size", "a grid that is too coarse for a run")
local explicit = wear{ model = springs, k = 1e-9, cycles = 1e3, scheme = "explicit", updates = 1 }
local function updates_to(cycles)
  local before = #explicit.history.cycle
  explicit:run{ cycles = cycles, progress = false }
  return #explicit.history.cycle - before
end
local few, many = updates_to(1e3), updates_to(4e5)
ok(many > few and many > 1, ("explicit updates go by the cycles asked for: %d, then %d"):format(few, many))
fails(function() wear{ model = springs, k = function() return 1e-9 end, scheme = "explicit" } end, "field 'scheme'", "explicit steps of an unknown k")
fails(function() wear{ model = springs, alpha = 2 } end, "alpha", "a share above 1")
fails(function() w:map "cap" end, "cup", "a map that there is not")
local flat = w:flat "cup"
near(1000 * flat:at(0, 0), 1000 * w.depth.cup, 0.05, "a flat map: deepest about the load")
local picture = os.tmpname() .. ".txt"
plot.map(w, { what = "cup", term = "dumb", file = picture })
ok(io.open(picture):read "a":find("cup", 1, true), "is drawn")
plot.map(w, "cup", { term = "dumb", file = picture, title = "mine" })
ok(io.open(picture):read "a":find("mine", 1, true), "with a word and options")
plot.map(w, "head", { file = picture .. ".gp" })
ok(io.open(picture .. ".gp"):read "a":find("cbrange [0:1]", 1, true), "a scale from 0 to 1 where nothing is worn")
plot.map(w, "pressure", { file = picture .. ".gp" })
ok(io.open(picture .. ".gp"):read "a":find("rim", 1, true), "with the rim of the cup")
plot.track(gait "iso", { term = "dumb", file = picture })
plot.track(w, { term = "dumb", file = picture })
ok(io.open(picture):read "a":find("paths of points", 1, true), "paths of points of the head")
ok(io.open(picture .. ".gp"):read "a":find("anterior", 1, true), "with the names of the axes")
local single = contact{ model = liner, load = 2000, direction = { 0.1, 0, 1 } }
plot.map(single, { file = picture .. ".gp" })
ok(io.open(picture .. ".gp"):read "a":find("pressure / MPa", 1, true), "the pressure of a single contact")
near(single:flat():at(0, 28 * math.sin(math.atan(0.1) / 2)), single.p_max, 0.05, "its flat map")
fails(function() plot.pressure(single) end, "use plot.map for the maps of a joint", "no curve of its pressure")
ok(tostring(single):find "load 2000 N", "a contact as text")
fails(function() single.load = 1 end, "read-only", "which is read-only")
fails(function() contact{ model = liner, direction = { 0, 0, 0 } } end, "field 'direction'", "a direction without length")
near(contact{ model = liner, load = 2000, direction = { 1e199, 0, 1e200 } }.p_max, single.p_max, 1e-9, "or of any length")
fails(function() wear{ loading = gait "iso" } end, "a gait needs model = joint{}", "a gait without a joint")
fails(function() study.converge{ base = { model = liner, cycles = 1 } } end, "got a joint", "a joint in study.converge")
fails(function() wear{ model = springs, k = 1e-9, updates = 1, creep = function() return -1 end }:run{ progress = false } end,
  "field 'creep'", "creep below zero")
fails(function() plot.track{} end, "expected a gait or the run of a joint", "of a table")
os.remove(picture)
os.remove(picture .. ".gp")

-- Tests .vtu and .pvd files of joints, and warnings and refusals of joints.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- which would make it too slow.
local tap = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/tap.lua")
local is, ok, near, fails = tap.is, tap.ok, tap.near, tap.fails

local warnings = require "archard.warnings"
local pe, cocr = material{ E = 1000, nu = 0.4 }, material{ E = 230e3, nu = 0.3 }
local folder = os.tmpname()
os.remove(folder)

-- --- .vtu files: depths and pressures on quadrilaterals ----------------------------------------------
local function numbers(text)
  local list = {}
  for word in text:gmatch "%S+" do list[#list + 1] = tonumber(word) end
  return list
end
local function read(path)
  local file = io.open(path)
  local text = file:read "a"
  file:close()
  local function array(name) return numbers(text:match('Name="' .. name .. '"[^\n]*>\n?([%d%s.e+-]*)') or "") end
  return { points = numbers(text:match "<Points><DataArray[^>]*>(.-)</DataArray>"), corners = array "connectivity", depth = array "wear_depth",
    pressure = array "pressure", text = text }
end
local function cross(a, b) return { a[2] * b[3] - a[3] * b[2], a[3] * b[1] - a[1] * b[3], a[1] * b[2] - a[2] * b[1] } end
-- Returns the integral of the values over the cells, as the vector sum of value times area times normal.
local function integral(file, values)
  local sum = { 0, 0, 0 }
  local function point(c)
    local at = 3 * file.corners[c]
    return { file.points[at + 1], file.points[at + 2], file.points[at + 3] }
  end
  for i, value in ipairs(values) do
    local a, b, c, d = point(4 * i - 3), point(4 * i - 2), point(4 * i - 1), point(4 * i)
    local area = cross({ c[1] - a[1], c[2] - a[2], c[3] - a[3] }, { d[1] - b[1], d[2] - b[2], d[3] - b[3] })
    local middle = (a[1] + b[1] + c[1] + d[1]) * area[1] + (a[2] + b[2] + c[2] + d[2]) * area[2] + (a[3] + b[3] + c[3] + d[3]) * area[3]
    for k = 1, 3 do sum[k] = sum[k] + (middle < 0 and -0.5 or 0.5) * area[k] * value end
  end
  return sum
end
local function size_of(v) return math.sqrt(v[1] ^ 2 + v[2] ^ 2 + v[3] ^ 2) end

local springs = joint{ foundation = "winkler", mesh = { size = 4 },
  cup = { clearance = 0.1, inclination = 20, cover = 88, layers = { { thickness = 8, material = pe } } } }
local w = wear{ model = springs, loading = gait.flexion{ load = 2000 }, k = 1e-9, alpha = 0.3, cycles = 2e5, updates = 3 }
w:run{ progress = export.pvd(w, folder .. "s.pvd") }
local head, cup = export.vtk(w, folder .. "w.vtu")
is(head, folder .. "w-head.vtu", "a .vtu file of the head")
is(cup, folder .. "w-cup.vtu", "a .vtu file of the cup")
local of_cup, of_head = read(cup), read(head)
near(integral(of_cup, of_cup.pressure)[3], 2000, 0.02, "the pressures in the cup's file balance the load")
near(size_of(integral(of_head, of_head.pressure)), 2000, 0.03,
  "the pressures in the head's file balance the load")
ok(#of_cup.depth < #of_head.depth / 1.8, "the cup ends at its rim")
ok(of_cup.text:find('Name="cross_shear"', 1, true) and of_cup.text:find(">MPa</InformationKey>", 1, true),
  "the cup's file has the cross-shear and units")
local most = 0
for _, depth in ipairs(of_cup.depth) do most = math.max(most, depth) end
is(most, w.depth.cup, "the depth in the file is identical to the bit")
local list = io.open(folder .. "s.pvd"):read "a"
is(select(2, list:gsub("<DataSet", "")), 8, "a .pvd file with four states of two bodies: " .. list)
local single = contact{ model = springs, load = 2000 }
is(export.vtk(single, folder .. "c.vtu"), folder .. "c.vtu", "a single contact has one .vtu file")
local alone = read(folder .. "c.vtu")
near(integral(alone, alone.pressure)[3], 2000, 0.02, "the pressures of a single contact balance the load")
export.csv(single, folder .. "c.csv")
local table_of = csv.read(folder .. "c.csv")
is(#table_of.value, #single.pressure.values, "a CSV file of a contact has a row for each cell")
near(table_of.theta[#table_of.value], 178, 1e-3, "theta in a CSV file is in degrees")
os.remove(folder .. "c.vtu")
os.remove(folder .. "c.csv")
export.json(w, folder .. "w.json")
local summary = io.open(folder .. "w.json"):read "a"
ok(summary:find('"volume_head": ' .. ("%.6g"):format(w.volume.head):sub(1, 5), 1, true),
  "a JSON summary has the last row of the history")
ok(summary:find '"clearance": %d' and summary:find '"results.volume_cup": "mm3"',
  "a JSON summary has the definition and units")
fails(function() export.vtk(w, folder .. "w.stl") end, "ends in .vtu", "export.vtk with another extension")
for i = 0, 3 do for _, body in ipairs{ "head", "cup" } do os.remove(("%ss-%05d-%s.vtu"):format(folder, i, body)) end end
for _, name in ipairs{ "s.pvd", "w-head.vtu", "w-cup.vtu", "w.json" } do os.remove(folder .. name) end

-- --- pressures over a cycle -----------------------------------------------------------------------------
local before = w:map("pressure", { instant = 1 }).values
fails(function() w:map("pressure", { instant = 21 }) end, "instant",
  "the pressure map of an increment that does not exist")
local whole = wear{ model = springs, loading = gait.flexion{ load = 2000 }, k = 1e-9, alpha = 0.3, cycles = 3e5, updates = 4 }
local looked = wear{ model = springs, loading = gait.flexion{ load = 2000 }, k = 1e-9, alpha = 0.3, cycles = 3e5, updates = 4 }
whole:run{ progress = false }
looked:run{ progress = function() looked:map "pressure" end }
is(looked.volume.cup, whole.volume.cup, "reading pressure maps does not change the run")
ok(#before == #w:map("cup").values, "the pressure map of one instant")

-- --- warnings near the rim, layers of springs -----------------------------------------------
local program
for i = -1, -9, -1 do program = arg[i] or program end
local function warning_of(f)
  local text = {}
  warn "@off"
  local script = os.tmpname()
  local file = io.open(script, "w")
  file:write(f)
  file:close()
  local pipe = io.popen(("%s %s 2>&1"):format(program, script))
  text = pipe:read "a"
  pipe:close()
  os.remove(script)
  warn "@on"
  return text
end
local near_rim = 'contact{ model = joint{ head = { material = material{ E = 1e15 } }, mesh = { size = 4 }, cup = { clearance = 0.1, cover = %g, '
  .. 'layers = { { thickness = 8, material = material{ E = 1000, nu = 0.4 } } } } }, load = 2500 }'
ok(warning_of('gait("iso", { increments = 8 })'):find("8 increments change its path or work by about 1.4 %",
  1, true),
  "a gait with few increments gives a warning")
is(warning_of('gait "iso" gait "prosim" gait.rocking() gait.flexion() gait{ flexion = { 0, 20, 0 } }'), "",
  "gaits with default increments give no warning")
ok(warning_of(near_rim:format(75)):find("degrees from the cup's rim", 1, true),
  "a contact near the rim gives a warning")
is(warning_of(near_rim:format(90)), "", "a contact far from the rim gives no warning")
local backed = 'contact{ model = joint{ mesh = { size = 2 }, cup = { clearance = 0.06, cover = %g } }, load = 3000 }'
ok(warning_of(backed:format(42)):find("below 25 degrees", 1, true),
  "a metal cup with backing: contact below 25 degrees from the rim")
local function p0(foundation, nu, E)
  return contact{ model = joint{ head = { material = material{ E = 1e15 } }, foundation = foundation, mesh = { size = 3 },
    cup = { clearance = 0.1, layers = { { thickness = 8, material = material{ E = E, nu = nu } } } } }, load = 2500 }.p_center
end
near(p0("winkler", 0.4, 1000) / 13.096, 1.028, 3e-3,
  "Winkler springs with nu = 0.4: pressure 2.8 % above the elastic layer's")
near(p0("column", 0.4, 1000) / 13.096, 1.038, 3e-3,
  "column springs with nu = 0.4: pressure 3.8 % above the elastic layer's")
near(p0("column", 0.3, 1000) / 12.446, 0.928, 3e-3,
  "column springs with nu = 0.3: pressure 7.2 % below the elastic layer's")
near(p0("winkler", 0.3, 1000) / 12.446, 1.001, 3e-3,
  "Winkler springs with nu = 0.3: pressure 0.1 % above the elastic layer's")

-- --- memory of joints without references ----------------------------------------------------
local function resident()
  return tonumber(io.open("/proc/self/status"):read("a"):match "VmRSS:%s*(%d+) kB")
end
local first = resident()
for _ = 1, 40 do
  wear{ model = joint{ foundation = "winkler", mesh = { size = 1 }, cup = { layers = { { thickness = 8, material = pe } } } }, updates = 1, cycles = 1,
    loading = gait.flexion{ increments = 1 } }
end
ok(resident() - first < 200000,
  ("the memory of 80 joints of 6 MB is freed: growth %d kB"):format(resident() - first))

-- --- messages for bad input --------------------------------------------------------------------------------
local function refused(given, expected, what) fails(function() joint(given) end, expected, what) end
refused({ cup = { clearance = -0.1 } }, "cup.clearance", "a negative clearance")
refused({ cup = { clearance = 20 } }, "cup.clearance", "a clearance larger than the radius")
refused({ cup = { layers = {} } }, "cup.layers", "a cup without layers")
refused({ cup = { layers = { { thickness = 3 } } } }, "cup.layers[1]", "a layer without a material")
refused({ head = { layers = { { thickness = 8, material = cocr }, { thickness = 7, material = pe } } } }, "head.layers", "layers thicker than the head")
refused({ cup = { cover = 200 } }, "cup.cover", "a cup larger than a sphere")
refused({ foundation = "column", cup = { layers = { { thickness = 8, material = material{ E = 1000, nu = 0.499 } } } }, mesh = { size = 0.01 } },
  "mesh.size", "more cells than memory can store")
fails(function() gait{ flexion = function(t) return 20 * t end } end, "20 degrees",
  "a gait that does not end at its start")
fails(function() gait{ flexion = { 0, 10, 0 }, t = { 0, 1 } } end, "3", "fewer times than angles")
local tilted = joint{ cup = { clearance = 0.06, inclination = 45, cover = 60 } }
-- Tests that the distance of the contact from the rim and the size of the cells are checked in all updates and
-- blocks of a run, and that reading the pressure does not change the run.
local lining = joint{ foundation = "winkler", mesh = { size = 4 }, cup = { clearance = 0.1, inclination = 20, cover = 85,
  layers = { { thickness = 5, material = pe } } } }
warnings.keep()
wear{ model = lining, k = 1e-9, alpha = 0, cycles = 2e6 }:run{ progress = false }
ok(warnings.take():find "reaches the cup's rim", "a contact that grows to the rim gives a warning")
local tilted_later = { { gait = gait "iso", cycles = 1e4 }, { gait = gait{ flexion = { 0, 20, 0 }, load = { x = -1400, z = 900 } } } }
wear{ model = joint{ cup = { inclination = 30 }, mesh = { size = 4 } }, cycles = 2e4, loading = tilted_later }:run{ progress = false }
ok(warnings.take():find "reaches the cup's rim", "a second block with a load near the rim gives a warning")
local light = { { gait = gait{ flexion = { 0, 20, 0 }, load = 3000 }, cycles = 1e4 }, { gait = gait{ flexion = { 0, 20, 0 }, load = 5 } } }
fails(function() wear{ model = joint{ mesh = { size = 6 } }, cycles = 2e4, loading = light }:run{ progress = false } end, "field 'mesh.size'",
  "a second block with a load too small for the cells")
local function looked_at(look)
  local run_of = wear{ model = lining, k = 1e-9, cycles = 2e5, jump = 5e4 }
  for cycles = 5e4, 2e5, 5e4 do
    run_of:run{ cycles = cycles, progress = false }
    if look then run_of:map "pressure" end
  end
  return run_of
end
is(looked_at(true).volume.cup, looked_at(false).volume.cup,
  "reading the pressure map does not change the wear")
-- Tests loads that fall to zero: results are continuous, and no work is done at zero load.
local function swing(least) return gait{ flexion = { 0, 20, 0, -20, 0 }, load = { least, 2000, 2000, least, least } } end
local function worn_by(least)
  return wear{ model = joint{ mesh = { size = 4 } }, loading = swing(least), cycles = 1e5, updates = 3 }:run{ progress = false }
end
local none, small = worn_by(0), worn_by(1e-6)
near(none.depth.cup, small.depth.cup, 1e-6, "a load of zero and a load of 1 uN in the swing phase: depth")
near(none.volume.total, small.volume.total, 1e-8,
  "a load of zero and a load of 1 uN in the swing phase: volume")
fails(function() contact{ model = joint{}, load = 1e-9 } end, "field 'mesh.size'",
  "a contact smaller than a cell")
fails(function() joint{ cup = { layers = { { thickness = 1, material = { E = -1 } } } } } end,
  "field 'cup.layers[1].material.E': expected a number > 0",
  "a negative E of a layer")
fails(function() joint{ head = { material = { E = 1, nue = 0.3 } } } end, "did you mean 'nu'?", "a misspelt field of a material")
fails(function() joint{ head = { material = gait "iso" } } end, "field 'head.material'",
  "a gait instead of a material")
fails(function() wear{ model = joint{}, k = function() return "1" end }:run{ progress = false } end,
  "got string",
  "a text as the result of k")
fails(function() contact{ model = tilted, load = 3000, direction = { -1, 0, 0.5 } } end,
  "degrees from the cup's axis",
  "a single contact with a load out of the cup")
fails(function() wear{ model = tilted,
  loading = gait{ load = { x = -900, z = 300 } } }:run{ progress = false } end, "degrees from the cup's axis",
  "a run with a load out of the cup")
fails(function() wear{ model = joint{ mesh = { size = 4 } }, loading = gait{ flexion = { 0, 20, 0 }, load = { z = { 2000, -1000, 2000 } } } }:run{ progress = false } end,
  "got z = -1 and 180 degrees, in increment", "a load that pulls during a part of the cycle")
fails(function() contact{ model = joint{ mesh = { size = 10 } }, load = 300 } end, "cells across the contact",
  "cells too large for a contact")
local edge = joint{ head = { material = material{ E = 1e15 } }, mesh = { size = 4 }, cup = { clearance = 0.1, cover = 45, layers = { { thickness = 8, material = pe } } } }
ok(contact{ model = edge, load = 3000 }.rim_margin < 4,
  "the margin of a contact at the rim is less than a cell")
ok(warning_of(near_rim:format(40)):find("reaches the cup's rim", 1, true),
  "a contact at the rim gives a warning")

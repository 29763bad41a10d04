-- Tests measured profiles against closed forms: filter, levelling, noise, areas and their uncertainty,
-- roughness, files.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- which would only slow it down.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local warnings = require "archard.warnings"
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds
local pi, sin, sqrt, abs, max = math.pi, math.sin, math.sqrt, math.abs, math.max

math.randomseed(20)
local pause = collectgarbage("setpause", 200) -- small collector steps are slow for long lists
local function normal() return sqrt(-2 * math.log(1 - math.random())) * math.cos(2 * pi * math.random()) end

-- Returns a profile of the function f with noise of the standard deviation `noise`.
local function trace(from, to, count, f, noise)
  local x, z = {}, {}
  for i = 1, count do
    x[i] = from + (to - from) * (i - 1) / (count - 1)
    z[i] = f(x[i]) + (noise and noise * normal() or 0)
  end
  return profile{ x = x, z = z }
end

-- Returns the largest |a[i] - b(x[i])| for x between the bounds.
local function apart(x, a, b, from, to)
  local most = 0
  for i = 1, #x do
    if x[i] >= from and x[i] <= to then most = max(most, abs(a[i] - b(x[i]))) end
  end
  return most
end

local function wave(length) return function(x) return 1e-3 * sin(2 * pi * x / length) end end

-- --- the Gaussian filter ------------------------------------------------------------------------------

for _, length in ipairs{ 0.4, 0.8, 1.6, 2.4 } do
  local p = trace(0, 8, 8001, wave(length)):filter(0.8)
  local share = 0.5 ^ ((0.8 / length) ^ 2)
  local off = apart(p.x, p.z, function(x) return share * wave(length)(x) end, 1.6, 6.4)
  ok(off < 1e-9 * 1e-3,
    ("a wave of %g mm has %.4f of its amplitude after a filter of 0.8 mm"):format(length, share))
end
for _, cutoff in ipairs{ 0.01, 0.07, 2 } do -- cutoffs of at least two sampling distances
  local direct, p = {}, trace(0, 2, 401, function(x) return math.abs(sin(9 * x)) end)
  local filtered, a = p:filter(cutoff), sqrt(math.log(2) / pi) * cutoff
  for _, i in ipairs{ 1, 7, 200, 401 } do
    local s0, s1, s2, t0, t1 = 0, 0, 0, 0, 0
    for j = 1, #p.x do
      local u = p.x[j] - p.x[i]
      local w = math.exp(-pi * (u / a) ^ 2)
      s0, s1, s2, t0, t1 = s0 + w, s1 + w * u, s2 + w * u * u, t0 + w * p.z[j], t1 + w * u * p.z[j]
    end
    direct[i] = (s2 * t0 - s1 * t1) / (s0 * s2 - s1 * s1)
    ok(abs(filtered.z[i] - direct[i]) < 1e-12,
      ("filter equals direct summation, cut-off %g, point %d"):format(cutoff, i))
  end
end
local slope = trace(-3, 5, 4000, function(x) return 0.3 - 0.02 * x end):filter(1.1)
ok(apart(slope.x, slope.z, function(x) return 0.3 - 0.02 * x end, -3, 5) < 1e-14,
  "the filter does not change a straight line")
local p = trace(0, 8, 4001, wave(0.5))
local long, short = p:filter(0.8), p:filter(0.8, "short")
local sum = {}
for i = 1, #p.x do sum[i] = long.z[i] + short.z[i] end
ok(apart(p.x, sum, wave(0.5), 0, 8) < 1e-16, "long and short waves add up to the profile")
fails(function() p:filter(9) end, { "profile:filter: field 'filter': expected a cut-off in mm in [0.004, 8]",
  "got 9" },
  "a cut-off longer than the profile")
fails(function() p:filter(0.8, "medium") end, 'field \'part\': expected "long" or "short", got "medium"',
  "an unknown part of the waves")
local uneven = { 0, 1, 2, 3, 4, 5, 6, 8 }
fails(function() profile{ x = uneven, z = uneven }:filter(5) end,
  "expected even steps of x, got 1 mm at x = 1 mm",
  "a profile with uneven steps")

-- --- levelling ------------------------------------------------------------------------------------------

local function largest(list)
  local most = 0
  for _, value in ipairs(list) do most = max(most, abs(value)) end
  return most
end

p = trace(-3, 5, 501, function(x) return 40 + 0.3 * x end):level()
ok(largest(p.z) < 2e-14, "a levelled line is zero up to rounding")
is(p.form, "line", "form of a levelled profile")
for _, case in ipairs{ { 10, 0, -1 }, { 10, 2.5, -1 }, { 4, -0.3, 1 }, { 1000, 30, -1 }, { 2.51, 0.02, -1 } } do
  local radius, centre, way = table.unpack(case)
  p = trace(-2.4, 2.4, 1001, function(x) return 7 - way * sqrt(radius ^ 2 - (x - centre) ^ 2) end)
  local q = p:level("circle")
  ok(largest(q.z) < 2e-13 * radius,
    ("a levelled circle of %g mm about %g mm is zero up to rounding"):format(radius, centre))
  near(q.radius, radius, 1e-9, "radius of the fitted circle")
end
ok(largest(trace(-1, 1, 101, function(x) return 1 + x end):level("circle").z) < 1e-14,
  "a line levelled as a circle is zero up to rounding")
p = trace(-2, 2, 2001, function(x) return 0.01 * x + 0.02 * x * x end)
local twice = p:level("line"):level("circle")
ok(apart(p.x, twice.z, function() return 0 end, -2, 2) > 0, "a parabola levelled as a circle is not zero")
is(p:level("circle").z[77], twice.z[77], "a second levelling replaces the first")
fails(function() trace(-1, 1, 101, function(x) return x > 0 and 5 or 0 end):level("circle", { -0.9999, 0.98 }) end,
  "field 'level': the points of this trace do not determine a circle beside the scar",
    "too few points beside a scar")
fails(function() p:level("plane") end, 'field \'level\': expected "line" or "circle", got "plane"',
  "levelling by an unknown form")
fails(function() p:level("line", { 1, 0 }) end, 'field \'scar\': expected "auto" or { from, to } in mm',
  "a scar with its ends exchanged")

-- --- noise ----------------------------------------------------------------------------------------------

local flat = trace(0, 10, 40000, function(x) return 0.1 * x + wave(1)(x) end, 2e-5)
near(flat.error, 2e-5, 0.03, "noise estimated for a slope with waves")
near(flat.correlation, 10 / 39999, 1e-12, "noise without correlation")
local means = flat:average(0.01)
near(means.error, 2e-5 / sqrt(40), 0.03, "noise of means of 40 points")
near(#means.x, 1000, 0.002, "average makes a point for each cell")
local function deviation(q, f)
  local square = 0
  for i = 1, #q.x do square = square + (q.z[i] - f(q.x[i])) ^ 2 / #q.x end
  return sqrt(square)
end
local quiet = trace(0, 10, 40000, function() return 0 end, 2e-5)
for _, cutoff in ipairs{ 0.004, 0.02, 0.1 } do
  local filtered = quiet:filter(cutoff)
  near(deviation(filtered, function() return 0 end), filtered.error, 0.12,
    "noise after a filter, cut-off " .. cutoff)
  near(deviation(quiet:filter(cutoff, "short"), function() return 0 end), quiet:filter(cutoff, "short").error, 0.03,
    "noise removed by the filter")
end
near(deviation(quiet:filter(0.02):filter(0.03), function() return 0 end),
  quiet:filter(0.02):filter(0.03).error, 0.08,
  "noise after two filters")
near(quiet:filter(0.1):level().scatter.length, quiet:filter(0.1).correlation, 0.15,
  "correlation length estimated after a filter")
local traces = {}
for i = 1, 9 do traces[i] = trace(0, 1, 2000, wave(1), 3e-5) end
local mean = profile.mean(traces)
near(mean.error, 1e-5, 0.05, "noise of the mean of nine traces")
near(deviation(mean, wave(1)), 1e-5, 0.05, "scatter of the mean of nine traces")
local raised = trace(0, 1, 2000, function(x) return wave(1)(x) + 1e-3 end, 3e-5)
near(profile.mean{ traces[1], raised }.error, 0.5e-3, 0.02, "the error includes the differences between traces")
fails(function() profile.mean{ traces[1] } end, "expected a list of at least two profiles",
  "the mean of a single profile")
fails(function() profile.mean{ traces[1], 3 } end, "item 2: expected a profile of heights, got 3",
  "a number in a list of profiles")
fails(function() profile.mean(setmetatable({}, { __len = function() return 2 end })) end,
  "expected a list of at least two profiles", "a list whose __len is larger than its length")

-- --- scars --------------------------------------------------------------------------------------------------

-- Returns the height of a parabolic scar from -0.5 to 0.5 mm, 2 um deep, with material piled up beside it.
local function groove(x)
  if abs(x) < 0.5 then return -2e-3 * (1 - 4 * x * x) end
  return abs(x) < 0.55 and 2e-4 * sin(pi * (abs(x) - 0.5) / 0.05) or 0
end
local area = 2e-3 * 2 / 3
local piled = 2 * 2e-4 * 0.05 * 2 / pi
p = trace(-2, 2, 4001, function(x) return 3 + 0.01 * x + groove(x) end)
local v = p:volume{ length = 5 }
near(v.area, area, 2e-4, "area of a parabolic scar")
near(v.volume, 5 * v.area, 1e-15, "the volume is the area times the length")
near(v.width, 1, 0.03, "width of a parabolic scar")
near(v.depth, 2e-3, 2e-3, "depth of a parabolic scar")
near(v.piled, piled, 0.02, "piled-up area beside a scar")
local d = p:depth()
ok(d.h and rawget(d, "z") == nil, "depths have the field h and no field z")
ok(apart(d.x, d.h, function(x) return -groove(x) end, -2, 2) < 2e-9, "depths do not depend on the tilt")
near(d:volume().area, v.area, 1e-12, "depths have the same area")
p = trace(-2.5, 2.5, 4001, function(x) return sqrt(100 - (x - 0.2) ^ 2) + groove(x) end):level("circle", "auto")
near(p.radius, 10, 1e-6, "radius of a worn cylinder")
near(p:volume().area, area, 1e-3, "area of a scar on a circle")
local before = trace(-2, 2, 3001, function(x) return wave(0.7)(x) + 0.02 * x end)
local after = trace(-2, 2, 4001, function(x) return wave(0.7)(x) + groove(x) - 0.03 * x + 4 end)
near(after:depth(before):volume().area, area, 3e-4, "area below a profile measured before")
fails(function() trace(-2, 2, 4001, wave(0.3)):volume() end, { "no scar is clearly deeper than the scatter of 0.7", "scar = { from, to }" },
  "waves are not recognized as a scar")
fails(function() trace(0, 1, 500, function() return 0 end, 1e-5):volume() end, "no scar is clearly deeper",
  "noise is not recognized as a scar")
near(trace(-2, 2, 4001, groove, 1e-6):volume{ scar = { -0.5, 0.5 } }.area, area, 1e-3,
  "area of a scar at a given position")
fails(function() p:depth{ scars = 1 } end, "unknown field 'scars' (did you mean 'scar'?)", "a misspelt field")

-- Tests that the stated uncertainty equals the scatter of 100 traces, with white and with correlated noise.
for _, case in ipairs{ { "white", false }, { "correlated", 0.03 } } do
  local given = { scar = { -0.5, 0.5 } }
  local sum, square, told, count = 0, 0, 0, 100
  for _ = 1, count do
    local noisy = trace(-1.5, 1.5, 1501, groove, 1e-4)
    if case[2] then
      noisy = noisy:filter(case[2])
    end
    local each = noisy:volume{ scar = { -0.56, 0.56 } }
    sum, square, told = sum + each.area, square + each.area ^ 2, told + each.error
  end
  local spread = sqrt(square / count - (sum / count) ^ 2)
  near(told / count, spread, 0.15, "standard error of an area, noise " .. case[1])
end

-- --- roughness ------------------------------------------------------------------------------------------------

local r = trace(0, 4.8, 9601, wave(0.05)):roughness()
is(r.sections, 5, "five sections in 4.8 mm")
near(r.length, 4, 1e-3, "evaluation length of 4 mm")
near(r.Ra, 2e-3 / pi, 5e-4, "Ra of a wave")
near(r.Rq, 1e-3 / sqrt(2), 5e-4, "Rq")
near(r.Rz, 2e-3, 1e-4, "Rz")
near(r.Rt, 2e-3, 5e-4, "Rt")
near(r.Rp, 1e-3, 1e-4, "Rp")
near(r.Rv, 1e-3, 1e-4, "Rv")
near(r.RSm, 0.05, 1e-4, "RSm")
near(r.Rdq, 2 * pi / 0.05 * 1e-3 / sqrt(2), 1e-3, "Rdq")
near(r.Rku, 1.5, 1e-4, "Rku")
near(r.Rsk, 0, 1e-4, "Rsk")
near(trace(0, 4.8, 9601, wave(0.8)):roughness().Rq, 0.5e-3 / sqrt(2), 5e-4,
  "a wave as long as the cut-off contributes half of its amplitude")
near(trace(0, 4.8, 9601, wave(0.05)):roughness{ short = 0.05 }.Rq, 0.5e-3 / sqrt(2), 5e-4,
  "Rq of a wave as long as the short cut-off")
local tilted = trace(0, 4, 8001, function(x) return wave(0.05)(x) + 0.02 * x end)
near(tilted:roughness{ cutoff = false }.Pq, 1e-3 / sqrt(2), 1e-3, "Pq of a tilted trace")
r = trace(0, 6, 60000, function() return 0 end, 1e-5):roughness()
near(r.Rq, 1e-5, 0.02, "Rq of noise")
near(r.Ra, 1e-5 * sqrt(2 / pi), 0.02, "Ra of noise")
near(r.Rku, 3, 0.04, "Rku of noise")
near(r.noise, r.Rq, 0.03, "the noise is reported with the roughness")
local spikes = trace(0, 4.8, 9601, function(x) return (x % 0.1) < 0.005 and -1e-3 or 0 end):roughness()
ok(spikes.Rsk < -2 and spikes.Rv > 5 * spikes.Rp, "scratches cause a negative skewness")
fails(function() trace(0, 1, 1001, wave(0.05)):roughness() end,
  "expected a trace of at least 1.6 mm (1 sections of the cut-off 0.8 mm plus half a cut-off at both ends), got 1 mm",
    "a trace shorter than the cut-off requires")
is(trace(0, 2, 1001, wave(0.05)):roughness{ cutoff = 0.25 }.sections, 5,
  "number of sections with another cut-off")

collectgarbage("setpause", pause)

-- --- files ------------------------------------------------------------------------------------------------------

local path = os.tmpname()
local function file(text)
  local f <close> = assert(io.open(path, "wb"))
  f:write(text)
  return path
end
local function rows(header, from, to, count, f)
  local lines = { header }
  for i = 1, count do
    local x = from + (to - from) * (i - 1) / (count - 1)
    lines[i + 1] = ("%.10g,%.10g"):format(x, f(x))
  end
  return file(table.concat(lines, "\n") .. "\n")
end
p = profile.read(rows("x [mm],z [um]", 0, 4, 401, function(x) return 5 + sin(x) end), { unit = "nm" })
near(p.z[101], 1e-3 * (5 + sin(1)), 1e-9, "units in the header have priority")
is(p.path, path, "path of the file")
p = profile.read(rows("x,height", 0, 4000, 401, function(x) return x / 1000 end), { unit = "um", level = "line" })
near(p.x[401], 4, 1e-15, "one unit for both columns")
ok(largest(p.z) < 1e-14, "a profile levelled by profile.read")
p = profile.read(rows("s,depth", 4, 0, 401, function(x) return x end), { unit = { h = "um" } })
near(p.h[401], 4e-3, 1e-12, "a unit for one column of a trace with decreasing x")
is(p.x[1], 0, "a trace with decreasing x is reversed")
p = profile.read(rows("a,b", 0, 1, 11, function(x) return x end), { x = "a", z = 2, error = 1e-3 })
is(p.z[11], 1, "columns by name and by number")
is(p.error, 1e-3, "given noise of a profile")
p = profile.read(file "x,z\n0,1\n1,1\n2,nan\n3,1\n4,2\n5,1\n6,1\n7,1\n8,1\n9,1\n")
is(#p.x .. " " .. p.missing, "9 1", "points without a value are removed")
holds(tostring(p), { "profile: 9 points, x 0 to 9 mm", "1 points without a value were removed" }, "the missing point is reported")
fails(function() profile.read(rows("a,b", 0, 1, 11, sin)) end, { "no column for 'x'; the columns are a, b" },
  "a file with unknown column names")
fails(function() profile.read(rows("x [N],z", 0, 1, 11, sin)) end,
  'column "x": expected a unit of length, got N',
  "a column with a unit that is not a length")
fails(function() profile.read(rows("x,z", 0, 1, 11, sin), { unit = "MPa" }) end, "expected a length: mm, um",
  "a pressure unit for a profile")
fails(function() profile.read(rows("x,z", 0, 1, 11, sin), { scar = "auto" }) end, "only allowed with level",
  "a scar without levelling")
fails(function() profile.read(rows("x,z", 0, 1, 5, sin)) end, "expected at least 8 points, got 5",
  "a profile with too few points")
fails(function() profile.read(file "x,z\n0,1\n1,1\n1,1\n3,1\n4,2\n5,1\n6,1\n7,1\n8,1\n") end,
  "expected strictly increasing or decreasing positions, got 1 mm after 1 mm", "the same position twice")
fails(function() profile{ x = { 1 } } end, "fields 'z' and 'h': expected one of them, got none",
  "a profile without heights or depths")
fails(function() return p.heigth end, "profile: no field 'heigth'", "an unknown field")
os.remove(path)

-- --- with runs --------------------------------------------------------------------------------------------------

local function shape(x) return abs(x) < 0.4 and 1e-3 * (1 - (x / 0.4) ^ 2) ^ 2 or 0 end
local m = model{ mesh = { size = 0.04, height = 0.05 } }
local exact = contact{ model = m, worn = { plate = shape } }
p = trace(-1.5, 1.5, 3001, function(x) return 0.3 - shape(x) end)
near(contact{ model = m, worn = { plate = p } }.p_max, exact.p_max, 2e-3,
  "a profile of heights as the worn shape")
near(wear{ model = m, worn = { plate = p:depth() } }.depth.plate, 1e-3, 1e-3,
  "a profile of depths as the worn shape")
local noisy = trace(-1.5, 1.5, 6001, function(x) return 0.02 * x - shape(x) end, 2e-5)
near(contact{ model = m, worn = { plate = noisy:average(0.04):depth() } }.p_max, exact.p_max, 0.03,
  "a noisy profile as the worn shape, averaged and levelled")
local hilly = profile{ x = p.x, h = (function()
  local h = {}
  for i, x in ipairs(p.x) do h[i] = 1e-3 * sin(x) end
  return h
end)() }
fails(function() contact{ model = m, worn = { plate = hilly } } end, { "expected no depth below -5 times the scatter",
  "piled-up material" }, "depths far above the surface")
local folder = os.tmpname()
os.remove(folder)
local w = wear{ model = m, worn = { plate = p } }
plot.profile(w, "plate", { measured = noisy, file = folder .. ".gp" })
local drawn = assert(io.open(folder .. ".gp")):read "a"
holds(drawn, "measured", "plot.profile with a measured trace")
plot.profile(w, { measured = { x = { 0, 0.1 }, h = { 1e-3, 0 } }, file = folder .. ".gp" })
fails(function() plot.profile(w, w, { measured = noisy }) end, "expected one body if several runs are drawn",
  "plot.profile of two runs with a measured trace")
fails(function() plot.profile(w, { measured = 3 }) end, "expected a profile, or a table { x=, h= }, got 3",
  "plot.profile with a number as measured trace")

-- --- a profile with another origin of x -----------------------------------------------------------------

local warnings = require "archard.warnings"
local function warned_of(make)
  warnings.keep()
  make()
  return warnings.take() or ""
end
local tilted = trace(-1.5, 1.5, 3001, function(x) return 2.7e-3 * x - shape(x) end, 2e-5)
local without_units = rows("s,depth", 0, 4, 401, function(x) return x end)
holds(warned_of(function() profile.read(without_units) end), "no unit of s and depth, mm is used", "a file without units gives a warning")
is(warned_of(function() profile.read(without_units, { unit = "mm" }) end), "", "a stated unit gives none")
local warned = warned_of(function() contact{ model = m, worn = { plate = tilted } } end)
holds(warned, "tilted by 2.7 um/mm, 8.1 um over its length", "a tilted worn shape gives a warning")
local level = tilted:average(0.04):level("line", "auto")
warned = warned_of(function() contact{ model = m, worn = { plate = level } } end)
ok(not warned:find "tilted", "a levelled worn shape gives no warning")
local apart_scar = trace(0, 4, 4001, function(x) return -shape(x - 2.1) end, 2e-5):average(0.02):depth()
warned = warned_of(function() contact{ model = m, worn = { plate = apart_scar } } end)
holds(warned, "the centre of the scar is at x = 2.1", "a scar that is not at x = 0 gives a warning")
local centred = apart_scar:center()
warned = warned_of(function() contact{ model = m, worn = { plate = centred } } end)
ok(not warned:find "centre of the scar", "a centred scar gives no warning")
ok(math.abs(centred.scar.from + centred.scar.to) < 1e-12 and math.abs(apart_scar.x[1] - centred.x[1] - 2.1) < 0.1,
  "p:center shifts points and scar")
ok(math.abs(trace(0, 4, 401, function() return 0 end):center().x[1] + 2) < 1e-12, "without a scar the trace is centred")
local aside = trace(0, 4, 4001, function(x) return 0.02 * x - shape(x - 2.1) end, 2e-5)
plot.profile(w, "plate", { measured = aside, file = folder .. ".gp" })
holds(assert(io.open(folder .. ".gp")):read "a", "measured, x moved by -2.1", "the title states the shift of a measured profile")
plot.profile(aside, { file = folder .. ".gp" })
holds(assert(io.open(folder .. ".gp")):read "a", { "height / µm", "measured profile" },
  "plot.profile of a measured trace alone")
plot.profile(aside:depth(), tilted:depth(), { titles = { "after", "before" }, file = folder .. ".gp" })
holds(assert(io.open(folder .. ".gp")):read "a", { "wear depth / µm", "after", "before" },
  "plot.profile of two measured profiles")
fails(function() plot.profile(aside, aside:depth()) end,
  "argument 2: expected a profile of heights like the first",
  "plot.profile of heights and depths together")
os.remove(folder .. ".gp")

-- Tests the stated uncertainty where few points are beside the scar: the true area is within two standard errors
-- in 95 % of all traces.
do
  local within, count, points = 0, 200, 4
  warnings.keep()
  for _ = 1, count do
    local depths = trace(-0.6, 0.6, 40, function(x) return 0.01 * math.max(0, 1 - (x / 0.38) ^ 2) * -1 end, 1.5e-4)
      :depth{ scar = { -0.4, 0.4 } }
    local area = depths:volume()
    if math.abs(area.area - 0.01 * 0.38 * 4 / 3) < 2 * area.error then within = within + 1 end
    points = math.max(points, depths.scatter.points)
  end
  is(points, 4, "largest number of points beside the scar of a short trace")
  ok(within >= 180, "areas of short traces are within two standard errors: " .. within .. " of 200")
  holds(warnings.take(), "the line is fitted to 4 of 40 points", "a line through few points gives a warning")
end

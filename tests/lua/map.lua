-- Tests maps: points and values, sections, levelling, cropping, resampling, differences, volumes.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- which would only slow it down.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds
local abs, max, sqrt = math.abs, math.max, math.sqrt

local function even(from, to, count)
  local list = {}
  for i = 1, count do list[i] = from + (to - from) * (i - 1) / (count - 1) end
  return list
end

local function sampled(f, nx, nz) return map{ x = even(-2, 4, nx or 61), z = even(1, 2, nz or 31), y = f } end

-- Returns the largest difference between the map and the function f at the points of the map.
local function apart(t, f)
  local most = 0
  for i, x in ipairs(t.x) do
    for j, z in ipairs(t.z) do most = max(most, abs(t.y[(i - 1) * #t.z + j] - f(x, z))) end
  end
  return most
end

local function zero() return 0 end

-- --- points and values ----------------------------------------------------------------------------------

local t = map{ x = { 0, 1, 2 }, z = { 10, 20 }, y = { 1, 2, 3, 4, 5, 6 } }
is(t:at(0, 20), 2, "y is x-major: the second value is at the first x and second z")
is(t:at(1, 10), 3, "y is x-major: the third value is at the second x and first z")
is(t:at(2, 20), 6, "the last value is at the largest x and z")
is(t:at(0.5, 15), 2.5, "the value between four points is their mean")
is(t.size[1] * 10 + t.size[2], 32, "number of points along x and z")
is(t.unit .. t.name, "mmheight", "default unit and name of a map")
local given = { 0, 1, 2 }
local own = map{ x = given, z = { 0, 1 }, y = { 1, 2, 3, 4, 5, 6 } }
given[2] = 7
is(own.x[2], 1, "the lists of the caller are copied")
local function bilinear(x, z) return 0.3 + 0.2 * x - 0.7 * z + 0.05 * x * z end
t = sampled(bilinear)
for _, at in ipairs{ { -2, 1 }, { 4, 2 }, { 0.123, 1.987 }, { 3.9999, 1.0001 }, { -2, 1.5 } } do
  near(t:at(at[1], at[2]), bilinear(at[1], at[2]), 1e-13, ("a bilinear surface at %g, %g"):format(at[1], at[2]))
end
holds(tostring(map{ x = { 0, 1 }, z = { 0, 1 }, y = { 0, 100, 0, 7 }, unit = "MPa", name = "pressure" }),
  { "map: pressure at 2 x 2 points", "x 0 to 1 mm, step 1000 um", "0 to 100 MPa" }, "print")

fails(function() map{ x = { 0, 1 }, z = { 0, 1 } } end,
  "field 'y': expected a list of numbers, or a function (x, z) -> number, got nil",
  "a map without values")
local ended = coroutine.wrap(function() return 1 end)
local fine, why = pcall(map, { x = { 0, 1 }, z = { 0, 1 }, y = ended })
is(why, "cannot resume dead coroutine", "an error of a user function has no position in a script of archard")
fails(function() map{ x = { 0, 1 }, z = { 0, 1 }, y = { 1, 2, 3 } } end,
  { "field 'y': expected 2 x 2 = 4 values", "got 3" },
  "a map with too few values")
fails(function() map{ x = { 0, 1 }, z = { 0, 1 }, y = { 1, 2, 0 / 0, 3 } } end,
  { "field 'y[3]': expected a finite number (at x = 1, z = 0 mm), got" }, "a value that is not a number")
fails(function() map{ x = { 0, 1, 3 }, z = { 0, 1 }, y = zero } end,
  "field 'x': expected increasing points with even steps of 1.5 mm, got 1 mm after 0 mm", "uneven steps")
fails(function() map{ x = { 1, 0 }, z = { 0, 1 }, y = zero } end, "field 'x': expected increasing points",
  "decreasing positions")
fails(function() map{ x = { 1 }, z = { 0, 1 }, y = zero } end, "field 'x': expected at least 2 points, got 1",
  "a single position")
fails(function() map{ x = { 0, "a" }, z = { 0, 1 }, y = zero } end,
  "field 'x[2]': expected a finite number in mm, got \"a\"",
  "a text among the positions")
fails(function() map{ x = { 0, 1 }, z = { 0, 1 }, y = function() end } end,
  "field 'y[1]': expected a finite number",
  "a function that returns nothing")
fails(function() map{ x = { 0, 1 }, z = { 0, 1 }, hight = zero } end, "unknown field 'hight'", "an unknown field")
fails(function() t:at(5, 1) end, "map:at: field 'x': expected a number in [-2, 4] mm, got 5",
  "a point outside the map")
fails(function() t:at(0) end, "field 'z': expected a number in [1, 2] mm, got nil", "a point without z")
fails(function() return t.hights end, "no field 'hights'", "reading of an unknown field")
fails(function() t.at(3, 4) end, "expected a map object, got 3", "a method called with a dot")

-- --- sections -------------------------------------------------------------------------------------------

local line = t:profile{ z = 1.234 }
is(#line.x, 61, "a section along x has all points")
near(line.y[17], bilinear(line.x[17], 1.234), 1e-13, "values of a section between two rows")
line = t:profile{ x = 4 }
is(#line.y, 31, "a section along z has all points")
near(line.y[31], bilinear(4, 2), 1e-13, "a section has the value at the map's corner")
near(line.x[1], 1, 0, "x of a section along z are the positions z")
near(profile(t:profile{ z = 1.5 }):level().form == "line" and 1 or 0, 1, 0, "a section is a profile object")
fails(function() t:profile{} end, "expected the position of the section in one of them, got none",
  "a section without a position")
fails(function() t:profile{ x = 0, z = 1 } end, "in one of them, got both", "a section at x and at z")
fails(function() t:profile{ z = 3 } end, "field 'z': expected a number in [1, 2] mm, got 3",
  "a section outside the map")

-- --- levelling ------------------------------------------------------------------------------------------

local function plane(x, z) return 40 + 0.3 * x - 0.1 * z end
ok(apart(sampled(plane):level(), zero) < 1e-13, "a levelled plane is zero up to rounding")
is(sampled(plane):level().form, "plane", "form of a levelled map")
for _, case in ipairs{ { 10, 1, 1.5, 1 }, { 10, 3, 0, -1 }, { 500, -20, 30, 1 }, { 6, -1, 1, 1 } } do
  local radius, x0, z0, sign = table.unpack(case)
  local ball = sampled(function(x, z) return 7 + sign * sqrt(radius ^ 2 - (x - x0) ^ 2 - (z - z0) ^ 2) end)
  local flat = ball:level("sphere")
  ok(apart(flat, zero) < 3e-13 * radius,
    ("a levelled sphere of %g mm about %g, %g is zero up to rounding"):format(radius, x0, z0))
  near(flat.radius, radius, 1e-9, "radius of the fitted sphere")
end
ok(apart(sampled(plane):level("sphere"), zero) < 1e-12, "a plane levelled as a sphere is zero up to rounding")
local function scar(x, z) return abs(x - 1) < 0.5 and abs(z - 1.5) < 0.2 and -1e-3 or 0 end
local worn = sampled(function(x, z) return plane(x, z) + scar(x, z) end):level("plane", { 0.4, 1.6, 1.2, 1.8 })
ok(apart(worn, scar) < 1e-13, "a scar excluded from the fit has its true depth")
ok(apart(sampled(function(x, z) return plane(x, z) + scar(x, z) end):level(), scar) > 1e-5,
  "a scar included in the fit changes its depth")
holds(tostring(sampled(function(x, z) return -(x * x + z * z) / 80 end):level("sphere")), "minus a sphere of radius 40", "print")
fails(function() t:level("circle") end, 'field \'level\': expected "plane" or "sphere", got "circle"',
  "levelling by an unknown form")
fails(function() t:level("plane", { -3, 5, 0, 2.5 }) end, "do not determine a plane outside the scar",
  "a scar larger than the map")
fails(function() t:level("plane", { 1, 0, 0, 1 }) end, "field 'scar': expected { x0, x1, z0, z1 } in mm",
  "a scar with its ends exchanged")

-- --- cropping and resampling -----------------------------------------------------------------------------

local part = t:crop{ x = { 0, 1 }, z = { 1.5 } }
is(part.size[1], 11, "cropping includes both ends")
is(part.size[2], 16, "cropping with one end only")
ok(apart(part, bilinear) < 1e-13, "a cropped map has the same values")
fails(function() t:crop{ x = { 0.01, 0.02 } } end, { "field 'x': expected a range with at least 2 of the points from -2 to 4 mm",
  "got { 0.01, 0.02 }" }, "a part with fewer than two points")
fails(function() t:crop{ y = { 0, 1 } } end, "unknown field 'y'", "cropping by heights")

local finer = t:resample(0.03)
is(finer.size[1], 201, "resampling to smaller steps")
ok(apart(finer, bilinear) < 1e-12, "resampling interpolates linearly")
local function waves(x) return math.cos(2 * math.pi * x / 0.2) end
local coarser = sampled(waves, 601):resample(0.2)
ok(apart(coarser:crop{ x = { -1.7, 3.7 } }, zero) < 1e-3,
  "resampling to larger steps averages: a wave as long as the step vanishes")
near(sampled(bilinear, 601, 301):resample(0.05):at(1, 1.5), bilinear(1, 1.5), 1e-12,
  "resampling does not change a bilinear surface")
local middle = sampled(bilinear, 11, 21):center()
near(middle.x[1] + middle.x[#middle.x], 0, 1e-12, "center moves x = 0 to the middle")
near(middle.z[1] + middle.z[#middle.z], 0, 1e-12, "center moves z = 0 to the middle")
is(middle.y[5], sampled(bilinear, 11, 21).y[5], "center does not change the values")
fails(function() t:resample(0) end, "field 'size': expected a step in mm in",
  "resampling with a step of zero")
fails(function() t:resample(1e-9) end, "got 1e-09", "resampling to too many points")
fails(function() t:resample(2) end, "1]", "resampling with a step larger than the map")

-- --- differences and volumes -------------------------------------------------------------------------------

local before = sampled(bilinear)
ok(apart(t - before, zero) == 0, "the difference of a map and itself is zero")
local shifted = map{ x = even(-1.03, 2, 77), z = even(0, 1.41, 13), y = bilinear }
local difference = before - shifted
ok(apart(difference, zero) < 1e-13, "the second map is interpolated at the points of the first")
near(difference.x[1], -1, 1e-12, "a difference covers the common part of two maps")
ok(apart(before + before, function(x, z) return 2 * bilinear(x, z) end) < 1e-13, "the sum of two maps")
near((before - 0.5):at(0, 1), bilinear(0, 1) - 0.5, 1e-14, "a map minus a number")
fails(function() return before - map{ x = { 8, 9 }, z = { 0, 1 }, y = zero } end, "expected overlapping maps",
  "the difference of maps that do not overlap")
fails(function() return before - map{ x = before.x, z = before.z, y = zero, unit = "MPa" } end, "expected maps with the same unit, got mm and MPa",
  "the difference of maps with different units")
fails(function() return before - "b" end,
  'expected two maps, or a map and a number, got a map object and "b"',
  "the difference of a map and a text")

local cap = map{ x = even(-1, 1, 401), z = even(-1, 1, 401), y = function(x, z) return max(0, 1e-3 * (1 - (x * x + z * z) / 0.64)) end }
near(cap:volume().above, math.pi * 0.64 * 1e-3 / 2, 1e-4, "volume of a paraboloid")
near(cap:volume().area, math.pi * 0.64, 2e-3, "area of a paraboloid")
is(cap:volume().below, 0, "a paraboloid has no volume below zero")
local v = cap:volume(5e-4)
near(v.above, math.pi * 0.64 * 1e-3 / 8, 1e-3, "volume of a paraboloid above half of its height")
near(v.net, v.above - v.below, 1e-12, "the net volume is the volume above minus the volume below")
fails(function() cap:volume("all") end, "field 'level': expected a number in mm, got \"all\"",
  "a level that is not a number")

-- --- pictures ---------------------------------------------------------------------------------------------

local name = os.tmpname()
local function drawn(f, t, options)
  options = options or {}
  options.file = name .. ".txt"
  f(t, options)
  local file <close> = assert(io.open(name .. ".txt"))
  return file:read "a"
end
local ramp = map{ x = even(0, 2, 41), z = even(0, 1, 21), y = function(x) return 1e-3 * x end, name = "depth" }
local text = drawn(plot.map, ramp, { size = { 70, 20 } })
holds(text, { "depth", "x / mm", "z / mm", "@   1.78 to 2", ".   0 to 0.222" }, "plot.map in characters has a scale in um")
local row = text:match "|([%.,:;oxO#@]+)|"
ok(row and row:find "^%.+,+:+;+o+x+O+#+@+$", "values increase to the right")
local wide, high = #row, select(2, text:gsub("|[%.,:;oxO#@]+|", ""))
ok(abs(wide / high / 2 - 2) < 0.3, "a map of 2 x 1 mm has a picture with this aspect ratio")
text = drawn(plot.map, map{ x = even(0, 2, 41), z = even(0, 1, 21), y = function(_, z) return z end, unit = "MPa", name = "pressure" })
ok(text:find "@+|[^\n]*\n.*%.+|", "the largest z is at the top")
holds(drawn(plot.surface, ramp), { "depth, exaggerated 200 times", "z / mm" },
  "plot.surface shows the exaggeration of heights")
holds(drawn(plot.surface, ramp, { exaggeration = 20 }), "exaggerated 20 times",
  "plot.surface with a given exaggeration")
holds(drawn(plot.surface, map{ x = { 0, 1 }, z = { 0, 1 }, y = zero }), "exaggerated 1 times",
  "plot.surface of a flat map")
plot.surface(map{ x = even(0, 1, 41), z = even(0, 0.05, 5), y = function(x) return 1e-4 * math.sin(3 * x) end }, { file = name .. ".gp" })
do
  local file <close> = assert(io.open(name .. ".gp"))
  local script = file:read "a"
  local low, high = script:match "set cbrange %[(%S+):(%S+)%]"
  ok((high - low) / tonumber(script:match "set cbtics (%S+)\n") < 4, "a low colour scale has few numbers")
  os.remove(name .. ".gp")
end
plot.map(sampled(bilinear, 600, 300), { file = name .. ".png" })
local file <close> = assert(io.open(name .. ".png", "rb"))
is(file:read(4), "\x89PNG", "picture of a large map")
local pressed = contact{ model = model{ geometry = "3-D" }, load = 10 }
holds(drawn(plot.map, pressed), { "pressure", "@" }, "plot.map of a contact in three dimensions")
os.remove(name)
os.remove(name .. ".txt")
os.remove(name .. ".png")
fails(function() plot.map({}) end, "plot.map: expected a map as the first argument, got a table",
  "plot.map of an empty table")
fails(function() plot.surface(ramp, { exaggeration = 0 }) end,
  "field 'exaggeration': expected a number > 0, got 0",
  "an exaggeration of zero")

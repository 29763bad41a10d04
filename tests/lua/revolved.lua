-- Tests bodies of revolution and thin plates: refused input, printed text, files.
local tap = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/tap.lua")
local is, ok, fails = tap.is, tap.ok, tap.fails
local warnings = require "archard.warnings"

local mesh = { size = 0.05, height = 0.05, zone = { cylinder = 1, plate = 1 } }
local function ball(changes)
  local all = { geometry = "axisymmetric", mesh = mesh }
  for name, value in pairs(changes or {}) do all[name] = value end
  return all
end
local function pin(changes)
  local all = { model = ball(), load = 50, slide = "z", alpha = 1, k = 1e-8, track = 20, cycles = 2 }
  for name, value in pairs(changes or {}) do all[name] = value ~= "none" and value or nil end
  return wear(all)
end

-- --- models -------------------------------------------------------------------------------------

fails(function() model{ geometry = "moving" } end,
  [[expected "plane strain", "plane stress", "axisymmetric", "springs" or "3-D"]],
  "an unknown geometry")
fails(function() model{ axis = 3 } end,
  [[field 'axis': expected geometry = "axisymmetric" beside it, got "plane strain"]],
  "an axis of plane bodies")
fails(function() model(ball{ thickness = 2 }) end,
  "field 'thickness': bodies of revolution have no thickness, got 2 mm",
  "a thickness of a body of revolution")
fails(function() model(ball{ axis = 4 }) end,
  "field 'axis': expected 0 or more than 10 mm, as the upper body extends so far",
  "an axis inside the body")
fails(function() model(ball{ upper = body.disc{ radius = 9.9 }, lower = body.ring{ inner = 10, outer = 20 } }) end,
  "for a hole (lower.kind = \"ring\" held by its outer rim)", "a hole in a body of revolution")
fails(function() model(ball{ upper = body.profile{ y = function(x) return 1e-3 * x end, width = 4, height = 2 } }) end,
  "field 'upper.y': expected the same height at x and -x", "an asymmetric profile")
ok(pcall(model, ball{ upper = body.profile{ y = function(x) return -x * x / 20 end, width = 4, height = 2 }, mesh = { size = 0.05, zone = { cylinder = 1, plate = 1 } } }),
  "a symmetric profile")

local m = model(ball())
is(m.geometry, "axisymmetric", "geometry of a model")
is(m.axis, 0, "position of the axis")
is(m.mesh.plate.element, "CAX4", "element type of a body of revolution")
ok(tostring(m):find("model: radius 10 mm, axisymmetric, elements", 1, true),
  "print of an axisymmetric model: " .. tostring(m))
ok(tostring(model(ball{ axis = 40 })):find("axisymmetric about x = -40 mm", 1, true),
  "print of the position of the axis")
local thin = model{ geometry = "plane stress", mesh = mesh }
is(thin.mesh.plate.element, "CPS4", "element type in plane stress")
ok(tostring(thin):find("thickness 1 mm, plane stress", 1, true), "print of plane stress")
is(model{ geometry = "plane strain", mesh = mesh }.mesh.plate.element, "CPE4", "plane strain is the default")
ok(tostring(hertz{ geometry = "axisymmetric", load = 50 }):find("hertz: ball, radius 10 mm, load 50 N\n", 1,
  true),
  "print of Hertz theory for a ball")

-- --- contacts -----------------------------------------------------------------------------------

fails(function() contact{ model = m, x = 0.1 } end, "field 'x': expected 0 mm for bodies of revolution",
  "a ball at a position other than the axis")
fails(function() contact{ model = m, friction = 0.1 } end,
  "field 'friction': expected 0 for bodies of revolution",
  "friction of a body of revolution")
local doubled = contact{ model = { geometry = "plane stress", thickness = 2, mesh = mesh }, load = 200 }
is(doubled.p_max, contact{ model = thin, load = 100 }.p_max, "the pressure depends on the load per thickness")

-- --- runs ---------------------------------------------------------------------------------------

fails(function() pin{ slide = "x" } end, [[field 'slide': expected "z" for bodies of revolution]],
  "a stroke along x")
fails(function() pin{ alpha = 0.5, track = "none", distance = 10, cycles = "none" } end,
  "field 'alpha': expected 1 if neither track nor spin is set",
    "a disc that does not move, with wear of both bodies")
fails(function() pin{ friction = 0.1 } end, "field 'friction': expected 0", "a run with friction")
fails(function() pin{ track = 0.1 } end,
  "field 'track': expected more than the contact's radius, about 0.15055",
  "a track within the contact")
fails(function() pin{ spin = 1 } end, "field 'track': expected none together with spin",
  "track and spin together")
fails(function() pin{ procedure = "SP" } end, [[field 'procedure': expected "NSP" with track]],
  "a track with procedure SP")
fails(function() pin{ model = ball{ axis = 40 } } end, "field 'track': expected model.axis = 0",
  "a ring on a track")
fails(function() wear{ track = 3 } end, "field 'track': expected 0, or an axisymmetric model",
  "a track of plane bodies")
fails(function() wear{ spin = 3 } end, "field 'spin': expected 0, or an axisymmetric model",
  "a spin of plane bodies")
fails(function() pin{ slip = "total" } end, "field 'slip'", "total slip of a body of revolution")

local w = pin{ alpha = 0.5 }:run()
tap.near(w.distance, 2 * 2 * math.pi * 20, 1e-9, "a cycle is a revolution along the track")
tap.near(w.stroke, math.pi * 20, 1e-9, "the stroke is half of the track's circumference")
ok(tostring(w):find("(mean over its track)", 1, true), "print states that the disc's depth is a mean")
ok(tostring(w):find("slide z, track 20 mm", 1, true), "print of the track")
local name = os.tmpname()
w:save(name .. ".wear")
local back = wear.open(name .. ".wear")
is(back.model.geometry, "axisymmetric", "a run file stores the geometry")
is(back.track, 20, "a run file stores the track")
is(("%a %a"):format(back.depth_plate, back.volume_plate), ("%a %a"):format(w.depth_plate, w.volume_plate),
  "a run file stores depth and volume")
fails(function() export.inp(w, name .. ".inp") end, [[field 'geometry': expected "plane strain" for a deck]],
  "a contact deck of bodies of revolution")
local function deck_of(mesh)
  mesh:write(name .. ".inp")
  local file = io.open(name .. ".inp")
  local text = file:read("a")
  file:close()
  return text
end
-- Returns the number of elements in a deck, and the smallest radius of their nodes.
local function rings_of(text)
  local x, count, least = {}, 0, math.huge
  for number, at in text:match("%*NODE[^\n]*\n([^*]*)"):gmatch("(%d+), ([^,]+),[^\n]*\n") do x[number] = tonumber(at) end
  for rows in text:gmatch("%*ELEMENT[^\n]*\n([^*]*)") do
    for row in rows:gmatch("%d+(,[^\n]*)") do
      count = count + 1
      for node in row:gmatch("%d+") do least = math.min(least, x[node]) end
    end
  end
  return count, least
end
local deck = deck_of(m.mesh.plate)
ok(deck:find("TYPE=CAX4", 1, true) and deck:find("TYPE=CAX3", 1, true), "the deck of a single mesh")
local count, least = rings_of(deck)
is(2 * count, m.mesh.plate.elements_count, "the deck contains half of the section")
is(least, 0.0, "the half section starts at the axis")
local first, last = deck:match("wear%-box, GENERATE\n(%d+), (%d+), 1")
is(tonumber(last), 2 * (tonumber(first) - 1), "node rows of the wear box in the half section")
local offset = model(ball{ axis = 40 }).mesh.cylinder
count, least = rings_of(deck_of(offset))
is(count, offset.elements_count, "the deck of a ring contains the whole section")
tap.near(least, 30, 1e-9, "the coordinates of a ring are radii")
for _, ending in ipairs{ "", ".wear", ".inp" } do os.remove(name .. ending) end

-- Tests the warning about a ball that has worn flat, whose radius has few elements.
local function scatters(size, distance)
  warnings.keep()
  wear{ model = ball{ radius = 10, mesh = { size = size } }, load = 50, slide = "z", track = 20, k = 1e-7, alpha = 0.9, distance = distance }:run()
  return (warnings.take() or ""):find("the contact has worn flat", 1, true) ~= nil
end
ok(scatters(0.04, 5e3), "a worn flat with few elements causes a warning")
ok(not scatters(0.008, 1e3), "a worn flat with many elements causes none")
ok(not scatters(0.04, 10), "a ball that has not worn flat causes none")

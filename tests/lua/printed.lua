-- Tests the printed text of pairs with layers, and warnings for values in a wrong unit.
package.path = arg[0]:gsub("[^/]*$", "") .. "lib/?.lua;" .. package.path
local tap = require "tap"
local ok = tap.ok
local warnings = require "archard.warnings"

local function has(text, what, name) ok(tostring(text):find(what, 1, true), name .. ": " .. what) end

-- --- layers ------------------------------------------------------------------------------------

local roller = body.cylinder{ name = "roller", radius = 5, E = 2.1e5, k = 1e-8,
  layers = { { thickness = 0.003, E = 4e5, k = 1e-10 } } }
local w = wear{ model = { upper = roller, lower = body.block{ name = "base", E = 2.1e5, k = 1e-9 },
  mesh = { size = 0.05, height = 0.05 } }, load = 100, distance = 100 }
local layer = "0.003 mm of E 400000 MPa nu 0.3"
has(w, "layers    roller " .. layer, "a run shows its layers")
has(w, "k 1.1e-09 mm2/N = 1.1e-06 mm3/(N m), alpha 0.0909091 at the present surfaces",
  "coefficients at the present surfaces")
has(w.model, "roller (cylinder of radius 5 mm) on base (block)", "a model shows its bodies")
has(w.model, "layer   " .. layer .. " k 1e-10 mm2/N = 1e-07 mm3/(N m)", "layers of a model")
ok(not tostring(w.model):find("radius 10", 1, true), "a model with its own bodies shows no default radius")
w:run{ progress = false }
has(w, "in a cycle ", "the largest pressure of a cycle is printed")

local thin = { { thickness = 5e-4, E = 3e5, k = 1e-10 }, { thickness = 5e-4, E = 3e5, k = 1e-10 } }
local coat = wear{ model = { upper = body.cylinder{ k = 1e-9 }, lower = body.block{ layers = thin, k = 1e-9 },
  mesh = { size = 0.05, height = 0.05 } }, stroke = 0.5, distance = 1e5 }
ok(not tostring(coat):find("worn through", 1, true), "a new layer is not worn through")
coat:run{ depth = { plate = 7e-4 }, progress = false }
local _, through = tostring(coat):gsub(", worn through", "")
tap.is(through, 1, "one of two layers is worn through")
local file = os.tmpname()
plot.profile(coat, "plate", { file = file .. ".gp" })
local script = assert(io.open(file .. ".gp")):read("a")
ok(script:find("bottoms of the layers", 1, true) and script:find("\n[%-%d.e]+ 0?%.5%D") and script:find("\n[%-%d.e]+ 1%D"),
  "plot.profile draws the bottoms of both layers in um")
os.remove(file)
os.remove(file .. ".gp")

-- --- position of the largest pressure --------------------------------------------------------

local punch = { upper = body.punch{ flat = 3.6, radius = 0.2 }, mesh = { size = 0.1 } }
warnings.keep()
has(contact{ model = punch, load = 50 }, "MPa (x = +-1.8 mm)",
  "a contact shows the position of its largest pressure")
has(wear{ model = punch, load = 50, stroke = 1 }, " (x = +-1.8 mm)",
  "a run shows the position of its largest pressure")
has(contact{ model = punch, load = 50, friction = 0.2 }, "tangential force 0 N",
  "a tangential force of rounding size is shown as zero")
warnings.take()
ok(not tostring(contact{ load = 100 }):find("(x =", 1, true),
  "a largest pressure at the centre has no position")
has(wear{ friction = 0.3, stroke = 0.02, cycles = 1 }:loop(), "energy = ", "print(w:loop())")

-- --- units -------------------------------------------------------------------------------------

local coarse = { mesh = { size = 0.05, height = 0.05 } }
local function warned(make)
  warnings.keep()
  make()
  return warnings.take() or ""
end
local function pair(E)
  return function() contact{ model = { cylinder = { E = E }, mesh = coarse.mesh }, load = 0.1 } end
end
has(warned(pair(210)),
  "E = 210 MPa of the cylinder is the modulus of a soft plastic or rubber: was 210 GPa meant",
  "E given in GPa")
has(warned(pair(210e9)), "was 2.1e+11 Pa meant", "E given in Pa")
local function moving(x)
  return function() wear{ model = coarse, loading = { x = x, load = 10, increments = 8 }, distance = 1 } end
end
has(warned(moving(function(t) return 0.1 * math.sin(t) end)), "loading.x begins at 0 and ends at 0.0841471", "a cycle that is not closed")
ok(not warned(moving(function(t) return 0.1 * math.sin(2 * math.pi * t) end)):find "begins at", "a closed cycle")
has(warned(function() calibrate{ volume = { plate = 1e-3, cylinder = 2e-3 }, load = 100, distance = 1.32 } end),
  "are the volumes in mm3 and the distance in mm?", "a distance in m")
has(warned(function() contact{ model = coarse, load = 3e4 } end), "more than a fiftieth of E",
  "a pressure above E / 50")
local function step(fields)
  return function()
    fields.model = coarse
    wear(fields):step()
  end
end
has(warned(step{ k = 2e-6, jump = 1 }), "k = 2e-06 mm2/N is 0.002 mm3/(N m): was 2e-06 mm3/(N m) meant",
  "k given in mm3/(N m)")
has(warned(step{ k = 1e-14, jump = 1 }),
  "k = 1e-14 mm2/N is 1e-11 mm3/(N m): was 1e-14 m2/N meant (k = 1e-08)",
  "k given in m2/N")
has(warned(step{ friction = 12, stroke = 0.01, jump = 1 }),
  "friction = 12 is a coefficient, force / load: was 12 % meant (0.12)?",
  "friction given in per cent")
has(warned(function() contact{ model = coarse, load = 1, friction = 4 } end), "was 4 % meant (0.04)",
  "friction of a contact given in per cent")
has(warned(step{ stroke = 4e-4 }), "was 0.4 mm meant", "a stroke given in m")
for what, make in pairs{ ["the usual numbers"] = step{}, polyethylene = pair(700), diamond = pair(1.2e6) } do
  ok(not warned(make):find("meant", 1, true), what .. " causes no warning about units")
end

-- --- values quoted in error messages -----------------------------------------------------------
local shown = require "archard.names".shown
tap.is(shown(("a"):rep(200)), '"' .. ("a"):rep(200) .. '"', "a text of 200 characters is quoted whole")
tap.is(shown(("é"):rep(150)), '"' .. ("é"):rep(100) .. '..." (300 characters)',
  "a quoted text is shortened between characters")
tap.is(shown("| a |\n" .. ("b"):rep(500)), '"| a |..." (506 characters)',
  "a quoted text is shortened to its first line")

-- --- printed bodies and materials ----------------------------------------------------------------
local dlc = material{ name = "DLC", E = 2e5, k = 1e-10 }
tap.is(tostring(dlc),
  "material DLC: E 200000 MPa, nu 0.3, E_star 219780 MPa, k 1e-10 mm2/N = 1e-07 mm3/(N m)",
  "print of a named material")
local coated = body.block{ name = "coated", material = material{ name = "100Cr6", E = 21e4 }, layers = { { thickness = 0.05, material = dlc } } }
tap.is(tostring(coated), "coated (block): 100Cr6, E 210000 MPa nu 0.3\n  0.05 mm of DLC, E 200000 MPa nu 0.3 k 1e-10 mm2/N = 1e-07 mm3/(N m)",
  "print(body)")
local flat_map = body.map{ E = 1e5, y = map{ x = { 0, 1, 2, 3 }, z = { 0, 1, 2, 3 }, y = function() return 0 end } }
local hostile = material{ E = 2e5, nu = 0.3, name = "a\27[2J\u{202E}" }
for what, printed in pairs{ material = hostile, body = body.block{ material = hostile }, model = model{ lower = body.block{ material = hostile } } } do
  has(printed, "a\\x1b[2J\\xe2\\x80\\xae", "name of a material in the print of a " .. what)
  ok(not tostring(printed):find("\27", 1, true), "no control characters in the print of a " .. what)
end
local walk = os.tmpname() .. "\27[2J"
do
  local file <close> = io.open(walk, "w")
  file:write "t,flexion,adduction,rotation,load\n0,0,0,0,1000\n0.5,10,0,0,1000\n1,0,0,0,1000\n"
end
has(gait.read(walk), "\\x1b[2J", "name of the file in the print of a gait")
has(wear{ model = joint{}, loading = gait.read(walk) }, "\\x1b[2J", "name of the file in the print of a joint's run")
os.remove(walk)
tap.is(tostring(flat_map), "map: E 100000 MPa nu 0.3", "print of a body.map")
local named = model{ lower = coated, cylinder = { name = "bronze", E = 1e5 }, mesh = coarse.mesh and { size = 0.1, height = 0.1 } }
tap.is(named.cylinder.name, "bronze", "the name of a material is stored in the model")
tap.is(tostring(named.lower), tostring(coated), "print of a body in a model")
for _, part in ipairs{ "of bronze", "of 100Cr6", "0.05 mm of DLC" } do
  tap.ok(tostring(named):find(part, 1, true), "print of a model contains: " .. part)
end
tap.ok(tostring(select(2, pcall(material, { name = ("x"):rep(32) }))):find("up to 31 characters", 1, true), "a name of 32 characters is refused")
tap.ok(tostring(select(2, pcall(wear, { geometry = "3-D" }))):find('give model = { geometry = "3-D" }', 1, true), "a geometry of bodies in wear{}")

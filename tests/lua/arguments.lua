-- Tests that invalid fields of definition tables are refused, and tests the error messages and error objects.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails = tap.ok, tap.is, tap.near, tap.fails

-- Tests the error messages for unknown field names.
fails(function() wear{ aplha = 0.3 } end, "unknown field 'aplha' (did you mean 'alpha'?)",
  "swapped letters")
fails(function() wear{ amplitude = 0.1 } end, "(did you mean 'stroke', twice the amplitude?)", "half of the value")
fails(function() wear{ storke = 0.3 } end, "(did you mean 'stroke'?)", "swapped letters, longer name")
fails(function() wear{ increment = 10 } end, "(did you mean 'increments'?)", "missing letter")
fails(function() wear{ Alpha = 0.3 } end, "(did you mean 'alpha'?)", "wrong case")
fails(function() model{ mesh = { sise = 1 } } end,
  "model: unknown field 'mesh.sise' (did you mean 'size'?)", "nested table")
fails(function() model{ mesh = { zone = { pin = 1 } } } end,
  { "unknown field 'mesh.zone.pin'", "known: cylinder, plate" }, "nothing near: the known names")
fails(function() material{ 200e3 } end, "fields are given by name; found [1]", "positional value")
fails(function() wear{ load = 100, stroke = 0,11 } end, "found [1] (numbers have a decimal point, as in 0.11)", "a decimal comma")
fails(function() hertz{ cylinder = { e = 1 } } end, "unknown field 'cylinder.e' (did you mean 'E'?)",
  "material written as a table")
fails(function() wear{ model = { raduis = 9 } } end, "'model.raduis' (did you mean 'radius'?)",
  "model written as a table")

-- Tests values that are not among the choices of a field.
fails(function() model{ geometry = "3D" } end, 'or "3-D", got "3D"; did you mean "3-D"?', "a choice nearly right")
fails(function() wear{ scheme = "backward" } end, '"explicit" or "implicit", got "backward"', "a choice far from all")

-- Tests that values of a wrong type or out of range are refused.
fails(function() wear(3) end, "wear: expected a table of named fields, got 3", "no table")
fails(function() wear{ alpha = 1.5 } end, "field 'alpha': expected a number in [0, 1], got 1.5",
  "above the range")
fails(function() wear{ alpha = -0.1 } end, "got -0.1", "below the range")
fails(function() wear{ alpha = 0 / 0 } end, { "field 'alpha'", "nan" }, "not a number")
fails(function() wear{ k = math.huge } end, "field 'k': expected a number >= 0 mm2/N, got inf", "infinite")
fails(function() wear{ load = 0 } end, "field 'load': expected a number > 0 N, got 0", "open end")
fails(function() wear{ load = function() return 1 end } end,
  "field 'load': expected a number > 0 N, or loading = { load = f } for a load that varies in a cycle, got a function",
  "a load over the cycle")
fails(function() wear{ load = "100" } end, [[field 'load': expected a number > 0 N, got "100"]],
  "text is no number")
fails(function() wear{ stroke = true } end, "got true", "boolean")
fails(function() wear{ stroke = {} } end, "got a table", "table")
fails(function() wear{ load = material{} } end, "got a material object", "object")
fails(function() wear{ increments = 10.5 } end, "field 'increments': expected an even number",
  "fraction")
fails(function() wear{ increments = 7 } end, { "increments", "even", "7" }, "odd increments")
fails(function() material{ nu = 0.5 } end, "field 'nu': expected a number in (-1, 0.5), got 0.5",
  "both ends open")
fails(function() model{ mesh = { rows = 0 } } end, "field 'mesh.rows': expected a whole number in",
  "whole number in a range")
fails(function() model{ mesh = 3 } end, "field 'mesh': expected a table", "number for a table")
fails(function() model{ cylinder = 3 } end, "field 'cylinder': expected a material object", "material")
fails(function() wear{ model = 3 } end, "field 'model': expected a model object", "model")
fails(function() wear{ worn = 3 } end, "field 'worn': expected a wear object or a table", "worn")
fails(function() contact{ x = "left" } end, [[field 'x': expected a number in mm, got "left"]],
  "number without a range")

-- Tests that the message for a wrong choice lists all valid values.
fails(function() wear{ procedure = "sp" } end,
  [[field 'procedure': expected "auto", "SP" or "NSP", got "sp"]], "enumeration lists its values")
fails(function() wear{ slip = 1 } end, [[expected "rigid" or "total", got 1]], "enumeration of two")
fails(function() model{ mesh = { element = "CPE8" } } end, [[expected "auto", "CPE4" or "CPE4I"]], "element")
fails(function() wear{}:profile("pin") end,
  [[wear:profile: field 'body': expected "cylinder" or "plate", got "pin"]], "body of a method")

-- Tests fields that exclude each other.
fails(function() wear{ distance = 10, cycles = 10 } end, "expected one of them, got both",
  "distance and cycles")
fails(function() wear{ jump = "often" } end, [[field 'jump': expected a number > 0 cycles, "auto" or a function of the state, got "often"]],
  "other text for jump")
fails(function() wear{ k = { distance = { 1, 0 }, value = { 1, 1 } } } end,
  { "k.distance[2]", "increasing", "two equal ones define a jump" }, "a series by distance: distances increase")
fails(function() wear{ k = { distance = { 0, 5, 5, 5 }, value = { 1, 1, 2, 3 } } } end,
  { "k.distance[4]", "got 5 for the third time" }, "a jump has two values")
fails(function() wear{ alpha = { distance = { 0, 1 }, value = { 0, 2 } } } end,
  { "alpha.value[2]", "in [0, 1], got 2" }, "its values are in the range")
fails(function() wear{ alpha = { distance = { 0, 1 }, value = { 0 } } } end, "equal length, got 2 and 1",
  "and as many as distances")
fails(function() wear{ alpha = { distanc = {} } } end,
  "unknown field 'alpha.distanc' (did you mean 'distance'?)", "names in a series")
fails(function() wear{ tolerance = 1e-3 } end, { "tolerance", "implicit" }, "a tolerance is for the implicit scheme")
fails(function() wear{ order = 3 } end, "field 'order': expected a whole number in [1, 2], got 3", "order")
fails(function() wear{ law = "coulomb" } end, [[expected "archard", "power", ]], "law")

-- Tests the fields of error objects.
local err = fails(function() wear{ alpha = 2 } end, "arguments.lua:", "position of the caller")
is(err.code, "ARGUMENT", "error.code")
is(err.where, "wear", "error.where")
is(err.step, nil, "error.step outside a run")
is(err.message, "field 'alpha': expected a number in [0, 1], got 2", "error.message")
is("failed: " .. err, "failed: " .. tostring(err), "errors can be joined with text")

-- Tests that strokes, element sizes and procedures that do not fit the model are refused.
fails(function() wear{ stroke = 30 } end, { "stroke", "30" }, "stroke over the plate")
fails(function() wear{ procedure = "NSP" } end, { "NSP", "alpha" }, "NSP where the plate does not stay flat")
fails(function() model{ mesh = { size = 100 } } end, { "size" }, "element larger than the body")
ok(pcall(wear), "no table at all: the defaults")

-- Tests the messages for a field of another definition and for a field that cannot be set.
fails(function() wear{ radius = 6 } end, "it is a field of model{}", "a field of a model in wear{}")
fails(function() wear{}.k = 3 end, "change it by w:set{ field = value }", "a field that cannot be set")

-- Tests that invalid file names and case numbers are refused.
for where, call in pairs{ ["wear.open"] = wear.open, ["csv.read"] = csv.read, ["study.open"] = study.open,
  ["session.open"] = session.open, ["session.save"] = session.save, ["profile.read"] = profile.read } do
  fails(function() call "a\0b" end, { where, [[got "a\0b"]] }, where .. ": a zero byte in a name is refused, not its end")
  fails(function() call "" end, { where, 'got ""' }, where .. ": a name of nothing")
end
fails(function() export.csv({ x = { 1 } }, "a\0.csv") end, [[got "a\0.csv"]], "export.csv: likewise")
fails(function() model{ mesh = "a\0.msh" } end, [[field 'mesh': expected a file name without zero bytes, got "a\0.msh"]], "a mesh: likewise")
fails(function() plot{ { x = { 1 }, y = { 1 } }, file = "a\0.png" } end, [[got "a\0.png"]], "a picture: likewise")
for _, case in ipairs{ 0, -1, 1.5, 2 ^ 31, 2 ^ 62, 0 / 0, "1" } do
  fails(function() wear.open("x.archard", case) end, "wear.open: field 'case': expected a whole number in [1, 1000000000]",
    ("case %s"):format(case))
end

-- Tests that tables that contain themselves and studies with too many cases are refused.
local endless, many = {}, {}
endless.k = endless
for i = 1, 1000 do many[i] = i end
local fit_of = { unknown = { k = 1e-8 }, data = { { of = "volume", distance = 1, value = 1e-6, relative = 0.1 } } }
for name, call in pairs{ ["a base"] = function() study{ base = endless } end, vary = function() study{ vary = endless } end,
  cases = function() study{ cases = { endless } } end, samples = function() study{ sample = endless } end,
  ["study.paper"] = function() study.paper(endless) end, ["study.converge"] = function() study.converge{ base = endless } end,
  ["the model of a fit"] = function() fit{ model = endless, unknown = fit_of.unknown, data = fit_of.data } end } do
  fails(call, { "at most 20 levels of tables, got 21 (does a table contain itself?)" }, name .. " that holds itself is refused")
end
fails(function() study{ vary = { load = many, alpha = many, stroke = many } } end,
  "field 'vary': expected at most 1000000 cases, got 1000000000 (1000 of alpha times 1000 of load times 1000 of stroke)",
  "a thousand million cases are refused before they are made")
local pairs_of = {}
for _, name in ipairs{ "alpha", "load", "stroke", "k", "p", "distance", "jump", "tolerance", "increments", "friction",
  "thickness", "refresh", "law_pressure", "law_exponent", "law_threshold", "cycles", "spin", "track", "fill" } do
  pairs_of[name] = { 0.1, 0.2 }
end
fails(function() study{ vary = pairs_of } end, "field 'vary': expected at most 4000000 values in all cases, got 9961472",
  "half a million cases of 19 values each, too")
fails(function() study{ n = 1000000, indices = true, sample = { k = uniform{ 1, 2 }, load = uniform{ 1, 2 } } } end,
  "expected at most 1000000 cases, got 4000000 (1000000 samples, with indices 4 cases each)", "samples likewise")

-- Tests the messages for fields that belong to another object, and for textbook symbols used as field names.
for _, case in ipairs{
  { function() wear{ geometry = "axisymmetric" } end, "field 'geometry'", "give model = { geometry = \"axisymmetric\" }" },
  { function() wear{ plate = { E = 1e5 } } end, "unknown field 'plate': it is a field of model{}" },
  { function() contact{ radius = 3 } end, "unknown field 'radius': it is a field of model{}" },
  { function() material{ v = 0.3 } end, "unknown field 'v' (did you mean 'nu'?)" },
  { function() model{ plate = { v = 0.3 } } end, "unknown field 'plate.v' (did you mean 'nu'?)" },
  { function() wear{ mu = 0.3 } end, "unknown field 'mu' (did you mean 'friction'?)" },
  { function() wear{ k = 1e-8, model = { lower = body.block{ layers = { { thickness = 0.02, E = 3000, nu = 0.4, k = 1e-6 } } } } } end,
    "layer 1 of the plate has its own wear coefficient, 1e-06 mm2/N" },
  { function() contact{ P = 3 } end, "unknown field 'P' (did you mean 'load'?)" },
} do fails(case[1], table.move(case, 2, #case, 1, {}), case[2]) end
local flat = model{ upper = body.punch{ flat = 1 }, mesh = { size = 0.05 } }
ok(not tostring(flat):find("radius 10", 1, true), "a flat punch takes no radius from the model")
tap.holds(tostring(wear{ model = flat, friction = 0.3, tangential = 10, load = 100, distance = 1 }), "done      cycle 0 of ", "cycles of a distance")

-- Tests that an element keeps its aspect ratio if only its width is given.
local fine = model{ mesh = { size = 0.04 } }
near(fine.mesh.height, 0.05, 1e-15, "the height follows the size")
is(model{ mesh = { size = 0.04, height = 0.03 } }.mesh.height, 0.03, "unless it is given")

-- Tests that invalid fields of definition tables are refused, and tests the error messages and error objects.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails = tap.ok, tap.is, tap.near, tap.fails

-- Tests the error messages for unknown field names.
fails(function() wear{ aplha = 0.3 } end, "unknown field 'aplha' (did you mean 'alpha'?)",
  "two letters of a field name swapped")
fails(function() wear{ amplitude = 0.1 } end, "(did you mean 'stroke', twice the amplitude?)",
  "amplitude instead of stroke")
fails(function() wear{ storke = 0.3 } end, "(did you mean 'stroke'?)", "letters swapped in a longer name")
fails(function() wear{ increment = 10 } end, "(did you mean 'increments'?)",
  "a letter missing in a field name")
fails(function() wear{ Alpha = 0.3 } end, "(did you mean 'alpha'?)", "a field name in the wrong case")
fails(function() model{ mesh = { sise = 1 } } end,
  "model: unknown field 'mesh.sise' (did you mean 'size'?)", "an unknown field in a nested table")
fails(function() model{ mesh = { zone = { pin = 1 } } } end,
  { "unknown field 'mesh.zone.pin'", "known: cylinder, plate" },
    "without a similar name the message lists the known names")
fails(function() material{ 200e3 } end, "fields are given by name; found [1]",
  "a positional value instead of a named field")
fails(function() wear{ load = 100, stroke = 0,11 } end,
  "found [1] (numbers have a decimal point, as in 0.11)",
  "a number with a decimal comma")
fails(function() hertz{ cylinder = { e = 1 } } end, "unknown field 'cylinder.e' (did you mean 'E'?)",
  "an unknown field of a material given as a table")
fails(function() wear{ model = { raduis = 9 } } end, "'model.raduis' (did you mean 'radius'?)",
  "an unknown field of a model given as a table")

-- Tests values that are not among the choices of a field.
fails(function() model{ geometry = "3D" } end, 'or "3-D", got "3D"; did you mean "3-D"?',
  "a misspelt choice is corrected")
fails(function() wear{ scheme = "backward" } end, '"explicit" or "implicit", got "backward"',
  "a choice unlike all valid ones")

-- Tests that values of a wrong type or out of range are refused.
fails(function() wear(3) end, "wear: expected a table of named fields, got 3",
  "a number instead of the table of fields")
fails(function() wear{ alpha = 1.5 } end, "field 'alpha': expected a number in [0, 1], got 1.5",
  "a value above the range")
fails(function() wear{ alpha = -0.1 } end, "got -0.1", "a value below the range")
fails(function() wear{ alpha = 0 / 0 } end, { "field 'alpha'", "nan" }, "not a number")
fails(function() wear{ k = math.huge } end, "field 'k': expected a number >= 0 mm2/N, got inf", "infinite")
fails(function() wear{ load = 0 } end, "field 'load': expected a number > 0 N, got 0",
  "a value equal to the excluded limit of its range")
fails(function() wear{ load = function() return 1 end } end,
  "field 'load': expected a number > 0 N, or loading = { load = f } for a load that varies in a cycle, got a function",
  "a function as load names the field loading")
fails(function() wear{ load = "100" } end, [[field 'load': expected a number > 0 N, got "100"]],
  "a text instead of a number")
fails(function() wear{ stroke = true } end, "got true", "boolean")
fails(function() wear{ stroke = {} } end, "got a table", "table")
fails(function() wear{ load = material{} } end, "got a material object", "object")
fails(function() wear{ increments = 10.5 } end, "field 'increments': expected an even number",
  "a fraction of an increment")
fails(function() wear{ increments = 7 } end, { "increments", "even", "7" }, "an odd number of increments")
fails(function() material{ nu = 0.5 } end, "field 'nu': expected a number in (-1, 0.5), got 0.5",
  "a range without both of its limits")
fails(function() model{ mesh = { rows = 0 } } end, "field 'mesh.rows': expected a whole number in",
  "a whole number out of range")
fails(function() model{ mesh = 3 } end, "field 'mesh': expected a table", "a number instead of a table")
fails(function() model{ cylinder = 3 } end, "field 'cylinder': expected a material object", "material")
fails(function() wear{ model = 3 } end, "field 'model': expected a model object", "model")
fails(function() wear{ worn = 3 } end, "field 'worn': expected a wear object or a table", "worn")
fails(function() contact{ x = "left" } end, [[field 'x': expected a number in mm, got "left"]],
  "a text for a number of any size")

-- Tests that the message for a wrong choice lists all valid values.
fails(function() wear{ procedure = "sp" } end,
  [[field 'procedure': expected "auto", "SP" or "NSP", got "sp"]],
    "a wrong choice: the valid values are listed")
fails(function() wear{ slip = 1 } end, [[expected "rigid" or "total", got 1]], "a choice between two values")
fails(function() model{ mesh = { element = "CPE8" } } end, [[expected "auto", "CPE4" or "CPE4I"]], "element")
fails(function() wear{}:profile("pin") end,
  [[wear:profile: field 'body': expected "cylinder" or "plate", got "pin"]],
    "an unknown body as argument of a method")

-- Tests fields that exclude each other.
fails(function() wear{ distance = 10, cycles = 10 } end, "expected one of them, got both",
  "distance and cycles together")
fails(function() wear{ jump = "often" } end, [[field 'jump': expected a number > 0 cycles, "auto" or a function of the state, got "often"]],
  "an unknown text for jump")
fails(function() wear{ k = { distance = { 1, 0 }, value = { 1, 1 } } } end,
  { "k.distance[2]", "increasing", "two equal ones define a jump" },
    "distances of a series that do not increase")
fails(function() wear{ k = { distance = { 0, 5, 5, 5 }, value = { 1, 1, 2, 3 } } } end,
  { "k.distance[4]", "got 5 for the third time" }, "a series with three values at one distance")
fails(function() wear{ alpha = { distance = { 0, 1 }, value = { 0, 2 } } } end,
  { "alpha.value[2]", "in [0, 1], got 2" }, "a value of a series out of range")
fails(function() wear{ alpha = { distance = { 0, 1 }, value = { 0 } } } end, "equal length, got 2 and 1",
  "a series with fewer values than distances")
fails(function() wear{ alpha = { distanc = {} } } end,
  "unknown field 'alpha.distanc' (did you mean 'distance'?)", "a misspelt field of a series")
fails(function() wear{ scheme = "explicit", tolerance = 1e-3 } end, { "tolerance", "implicit" },
  "tolerance without the implicit scheme")
fails(function() wear{ order = 3 } end, "field 'order': expected a whole number in [1, 2], got 3", "order")
fails(function() wear{ law = "coulomb" } end, [[expected "archard", "power", ]], "law")

-- Tests the fields of error objects.
local err = fails(function() wear{ alpha = 2 } end, "arguments.lua:",
  "the error contains the position of the call")
is(err.code, "ARGUMENT", "error.code")
is(err.where, "wear", "error.where")
is(err.step, nil, "error.step is nil outside a run")
is(err.message, "field 'alpha': expected a number in [0, 1], got 2", "error.message")
is("failed: " .. err, "failed: " .. tostring(err), "errors can be concatenated with strings")

-- Tests that strokes, element sizes and procedures that do not fit the model are refused.
fails(function() wear{ stroke = 30 } end, { "stroke", "30" }, "a stroke longer than the plate")
fails(function() wear{ procedure = "NSP" } end, { "NSP", "alpha" },
  "NSP although the plate does not stay flat")
fails(function() model{ mesh = { size = 100 } } end, { "size" }, "an element larger than the body")
ok(pcall(wear), "a call without a table uses the defaults")

-- Tests the messages for a field of another definition and for a field that cannot be set.
fails(function() wear{ radius = 6 } end, "it is a field of model{}", "a field of model{} used in wear{}")
fails(function() wear{}.k = 3 end, "change it by w:set{ field = value }",
  "assignment to a field of a wear object")

-- Tests that invalid file names and case numbers are refused.
for where, call in pairs{ ["wear.open"] = wear.open, ["csv.read"] = csv.read, ["study.open"] = study.open,
  ["session.open"] = session.open, ["session.save"] = session.save, ["profile.read"] = profile.read } do
  fails(function() call "a\0b" end, { where, [[got "a\0b"]] }, where ..
    ": a file name with a zero byte is refused, not truncated")
  fails(function() call "" end, { where, 'got ""' }, where .. ": an empty file name")
end
fails(function() export.csv({ x = { 1 } }, "a\0.csv") end, [[got "a\0.csv"]],
  "export.csv: a file name with a zero byte")
fails(function() model{ mesh = "a\0.msh" } end,
  [[field 'mesh': expected a file name without zero bytes, got "a\0.msh"]],
  "a mesh file name with a zero byte")
fails(function() plot{ { x = { 1 }, y = { 1 } }, file = "a\0.png" } end, [[got "a\0.png"]],
  "a picture file name with a zero byte")
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
  fails(call, { "at most 20 levels of tables, got 21 (does a table contain itself?)" }, name ..
    " with a table that contains itself is refused")
end
fails(function() study{ vary = { load = many, alpha = many, stroke = many } } end,
  "field 'vary': expected at most 1000000 cases, got 1000000000 (1000 of alpha times 1000 of load times 1000 of stroke)",
  "a thousand million cases are refused before they are created")
local pairs_of = {}
for _, name in ipairs{ "alpha", "load", "stroke", "k", "p", "distance", "jump", "tolerance", "increments", "friction",
  "thickness", "refresh", "law_pressure", "law_exponent", "law_threshold", "cycles", "spin", "track", "fill" } do
  pairs_of[name] = { 0.1, 0.2 }
end
fails(function() study{ vary = pairs_of } end, "field 'vary': expected at most 4000000 values in total over all cases, got 9961472",
  "half a million cases with 19 values each are refused")
fails(function() study{ n = 1000000, indices = true, sample = { k = uniform{ 1, 2 }, load = uniform{ 1, 2 } } } end,
  "expected at most 1000000 cases, got 4000000 (1000000 samples, with indices 4 cases each)",
    "four million samples are refused")

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
ok(not tostring(flat):find("radius 10", 1, true), "a flat punch does not use the radius of the model")
tap.holds(tostring(wear{ model = flat, friction = 0.3, tangential = 10, load = 100, distance = 1 }),
  "done      cycle 0 of ",
  "a run over a distance shows its number of cycles")

-- Tests that an element keeps its aspect ratio if only its width is given.
local fine = model{ mesh = { size = 0.04 } }
near(fine.mesh.height, 0.05, 1e-15, "the height of an element is 1.25 times its width")
is(model{ mesh = { size = 0.04, height = 0.03 } }.mesh.height, 0.03,
  "an element height given by the user is used")

-- Tests tables that return other values when they are read again, and errors whose metamethods fail.
do
  local check = require "archard.lib.check"
  local reads = 0
  local changing = setmetatable({ 1 }, { __index = function()
    reads = reads + 1
    return reads > 1 and {} or 2
  end })
  local range = check.fields("here", { x = changing }, { x = check.range }).x
  ok(range[1] == 1 and range[2] == nil and reads == 0, "a range is copied without metamethods")
  local list = { 1, 2 }
  ok(check.fields("here", { x = list }, { x = check.list_of(check.number, "numbers") }).x ~= list, "a list is copied")
  local thrown = setmetatable({}, { __index = 5, __name = 5 })
  local fine, err = pcall(check.as, "here", error, thrown)
  ok(not fine and rawequal(err, thrown), "an error of the user with other metamethods is passed on")
  fine, err = pcall(check.call, coroutine.wrap(function() return 1 end))
  ok(fine and err == 1, "a function of the user is called")
  local ended = coroutine.wrap(function() end)
  ended()
  fails(function() check.call(ended) end, "cannot resume dead coroutine", "an ended coroutine of the user")
  ok(not tostring(select(2, pcall(check.call, ended))):find("scripts/", 1, true), "no position in a script of archard")
end

-- Values far from all materials and bodies: an error, or the exact volume.
fails(function() wear{ model = { cylinder = { E = 1e-300 }, mesh = { size = 0.1, height = 0.1 } } } end, "larger than the bodies allow",
  "a modulus of 1e-300 MPa")
require "archard.warnings".keep()
local thick = wear{ distance = 11, increments = 4, jump = 50, model = { thickness = 9e18, mesh = { size = 0.05, height = 0.05 } } }
thick:run()
tap.near(thick.volume.total, 1e-8 * 100 * 11, 1e-12, "volume of bodies that are 9e18 mm thick")

-- Tests session.save and session.open: objects are restored under their names, and restored runs are
-- identical to the bit. Also tests who(), time() and examples().
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- which would only slow it down.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, fails, holds = tap.ok, tap.is, tap.fails, tap.holds
local own = require "archard.session.own"
local leave = require "archard.session.leave"
local file_module = require "archard.session.file"

local folder = os.tmpname()
os.remove(folder)
assert(os.execute("mkdir " .. folder))
local function path(name) return folder .. "/" .. name end

-- Returns the text that a function prints.
local function printed(f, ...)
  local lines, kept = {}, print
  print = function(...)
    local words = table.pack(...)
    for i = 1, words.n do words[i] = tostring(words[i]) end
    lines[#lines + 1] = table.concat(words, "\t")
  end
  local results = table.pack(pcall(f, ...))
  print = kept
  assert(results[1], results[2])
  return table.concat(lines, "\n"), table.unpack(results, 2, results.n)
end

-- Removes all globals except the globals of Lua and archard.
local function forget()
  for _, each in ipairs(own.list()) do rawset(_G, each.name, nil) end
end

local base = { increments = 20, jump = 20, model = { mesh = { size = 0.04, height = 0.05 } } }
local function quickened(given)
  for name, value in pairs(base) do given[name] = value end
  return wear(given)
end

-- --- saved ---------------------------------------------------------------------------------------

is(leave.question(), nil, "no question in an empty session")
w = quickened{}
is(w.saved, false, "a new run is not saved")
is(leave.question(), nil, "no question if no run has results")
w:step(2)
holds(leave.question(), { "not saved: w\n", "session.archard before leaving? yes, no or stay" }, "a question about unsaved results")
w:save(path "w.archard")
is(w.saved, true, "a saved run is in a file")
is(w:clone().saved, true, "the clone of a saved run counts as saved")
is(leave.question(), nil, "no question after saving")
w:step()
is(w.saved, false, "a step makes a saved run unsaved")
is(wear.open(path "w.archard").saved, true, "an opened run is saved")

-- --- objects are restored by name ----------------------------------------------------------------

base.k = function() return 2e-8 end
driven = quickened{}
driven:step(2)
base.k = nil
m = w.model
steel = material{ E = 210e3 }
fitted = model{}
on_fitted = wear{ model = fitted }
runs = { w, pair = { quickened{ alpha = 0.25 } }, [7] = "text" }
runs.pair[1]:step(2)
plan = study{ name = "plan", vary = { alpha = { 0.25, 0.5 } }, base = { stroke = 0.2 } }
computed = study{ name = "done", base = base, vary = { alpha = { 0.5 } }, snapshots = 0 }
base.distance = 44
computed = study{ name = "done", base = base, cases = { { alpha = 0.5 } } }:run{ file = path "computed.archard", workers = 1,
  progress = false }
base.distance = nil
whole, share, text, yes, huge, numbers = 7, 0.1, "a\nb", true, math.maxinteger, { 1, 2.5, -0.0 }
long, wide = {}, { 1, (2^53 | 0) + 1 }
for i = 1, 200000 do long[i] = i end
told, odd = w.history, { 1, 0 / 0, math.huge, nothing = 0 / 0, nested = { -math.huge } }
touch = contact{ model = m }
pulled = contact{ model = m, friction = 0.3, increments = 4 }:move{ tangential = 10 }:move{ tangential = -10, increments = 2 }
on_worn = contact{ worn = runs.pair[1], load = 50 }
on_function = contact{ worn = { plate = function() return 1e-3 end } }
found = calibrate{ volume = { cylinder = { 0.1, 0.2 }, plate = { 0.3, 0.4 } }, load = 100, distance = 1320 }
trace = { x = {}, z = {} }
for i = 1, 50 do trace.x[i], trace.z[i] = 0.1 * i, 1e-3 * math.sin(i) end
trace = profile{ x = trace.x, z = trace.z, level = "line" }
results = { map{ x = { 0, 1 }, z = { 0, 1, 2 }, y = { 1, 2, 3, 4, 5, 6 } }, again = found }
function compute() return 1 end
local scar = { scar = { 2, 3 } }
before = { pulled = tostring(pulled), on_worn = tostring(on_worn), found = tostring(found), trace = tostring(trace),
  area = trace:volume(scar).error, map = tostring(results[1]), w = tostring(w), volume = driven.volume.total, pair = runs.pair[1].depth.plate }
holds(leave.question(), "not saved: driven, on_function, on_worn, ... 10 in all\n", "the question names each unsaved object once")

local said = session.save(path "s.archard")
holds(said, { "saved in " .. path "s.archard", "4 runs, 2 models, 2 studies, 3 contacts, 3 results", "not saved: compute (function), on_function (contact on surfaces given by functions)",
  "driven: pass its functions again to session.open (k)", "computed: the cases are stored in " .. path "computed.archard" },
  "session.save lists the stored objects and the others")
is(w.saved and driven.saved and runs.pair[1].saved, true, "session.save marks its runs as saved")
holds(leave.question(), "not saved: on_function\n", "a question about a contact that cannot be stored")
on_function = nil
is(leave.question(), nil, "no question after the contact is removed")
local w_next = w:clone():step(3)
local expected = { w_next.p_center, w_next.depth_plate, w_next.volume_cylinder }

local kept = table.move({ path, tap, expected }, 1, 3, 1, {})
forget()
is(rawget(_G, "w"), nil, "the session is empty")
fails(function() session.open(path "s.archard") end, { "session.open: driven: field 'k': expected a function, as when",
  "session.open(path, { driven = { k = f } })" }, "the error explains how to give the functions")
is(#own.list(), 0, "no object is opened without the functions")
holds(session.open(path "s.archard", { driven = { k = function() return 2e-8 end } }), "4 runs, 2 models, 2 studies, 3 contacts, 3 results", "a session opens with its functions")
is(leave.question(), nil, "no question after opening")
is(tostring(pulled), before.pulled, "print of a restored contact with motions")
is(tostring(on_worn), before.on_worn, "print of a restored contact on worn surfaces")
is(tostring(found), before.found, "print of a restored calibration")
ok(rawequal(results.again, found), "a calibration stored under two names is one object")
is(tostring(trace), before.trace, "print of a restored profile")
is(trace:volume{ scar = { 2, 3 } }.error, before.area, "standard error of an area of the restored profile")
is(tostring(results[1]), before.map, "print of a restored map")
is(tostring(w), before.w, "print of a restored run")
is(driven.volume.total, before.volume, "volume of a restored run with a function")
is(driven.k(), 2e-8, "the function is restored")
is(runs.pair[1].depth.plate, before.pair, "a run in a table is restored")
ok(rawequal(runs[1], w), "a run stored under two names is one object")
is(runs[7], "text", "keys of a list are restored")
is(w.model, m, "a run and its model are restored together")
is(on_fitted.model, fitted, "a run and its model of default size are restored together")
is(fitted.mesh.fineness, 1, "a restored model has its fineness")
is(steel.E, 210e3, "a material is restored")
is(math.type(whole) .. " " .. whole .. " " .. share .. " " .. tostring(yes) .. " " .. text,
  "integer 7 0.1 true a\nb",
  "values of simple types are restored")
is(huge, math.maxinteger, "the largest whole number")
is(#numbers .. " " .. 1 / numbers[3], "3 -inf", "a list is restored with the sign of zero")
is(#long .. " " .. math.type(long[9]) .. " " .. long[200000], "200000 integer 200000",
  "a long list is restored")
is(wide[2] - 1, 2^53 | 0, "integers beyond the range of doubles")
ok(told.depth_partition[1] ~= told.depth_partition[1] and told.distance[2] == w.history.distance[2],
  "a history with NaN is restored")
is(odd[1] .. " " .. tostring(odd[2] ~= odd[2]) .. " " .. odd[3] .. " " .. odd.nested[1], "1 true inf -inf",
  "infinite numbers in a table are restored")
ok(odd.nothing ~= odd.nothing, "NaN as a field is restored")
is(plan:cases()[2].stroke .. " " .. plan:cases()[2].alpha .. " " .. plan.name, "0.2 0.5 plan",
  "a study that has not run is restored")
is(computed:cases()[1].status, "done", "a study that has run is restored from its file")
w_next = w:step(3)
is(w_next.p_center == kept[3][1] and w_next.depth_plate == kept[3][2] and w_next.volume_cylinder == kept[3][3], true,
  "a restored run continues with identical bits")

-- --- nothing lost --------------------------------------------------------------------------------

fails(function() session.open(path "s.archard", { driven = { k = function() return 2e-8 end } }) end,
  { "session.open", "is a run that has not been saved" }, "an unsaved run is not overwritten")
is(w.update, 6, "the unsaved run is unchanged")
holds(session.save(), "saved in " .. path "s.archard", "session.save without a name uses the last file")
for _, case in ipairs{ false, 1, 2 } do
  fails(function() wear.open(path "s.archard", case or nil) end, { "got a session", "use session.open" },
    "wear.open of a session is refused")
end
fails(function() session.save(path "w.archard") end, { "session.save", "w.archard" },
  "session.save does not replace a run file")
is(wear.open(path "w.archard").update, 2, "the run file is unchanged")
fails(function() session.save(path "none/s.archard") end, "session.save", "session.save to a missing folder")
fails(function() session.open(path "w.archard") end, { "session.open", "expected a file of session.save, got a run file of kind wear; wear.open opens it" },
  "session.open of a run file")
fails(function() session.open(path "none") end, { "session.open", "none" }, "session.open of a missing file")
fails(function() session.open(3) end, "expected the name of a file, got 3", "session.open of a number")
os.remove(path "computed.archard")
local opened = session.open(path "s.archard", { driven = { k = function() return 2e-8 end } })
holds(opened, { "left out: computed: ", "computed.archard not found" }, "a study without its file is reported")

-- --- the question --------------------------------------------------------------------------------

w:step()
is(leave.answer "no", true, "the answer no ends the program")
is(leave.answer "s", false, "the answer stay continues the session")
is(leave.answer "what", nil, "another answer repeats the question")
is(file_module.suggested(), path "s.archard", "the suggested file is the file of the session")
holds(printed(leave.answer, "yes"), "saved in " .. path "s.archard", "the answer yes saves the session")
is(w.saved, true, "the run is saved")

-- --- untrusted sessions ----------------------------------------------------------------------------

-- Writes a session file that contains one value with the given settings.
local function stranger(settings)
  local file <close> = require "archard.store".replace(path "stranger", "session")
  file:begin()
  file:add(1, "x")
  file:set_values(1, "settings", settings)
  file:mark(1, "done")
  file:commit()
  file:publish()
  return path "stranger"
end

is(session.open(stranger{ kind = "number", is = 5, ["key.1"] = "five" }), "opened " .. path "stranger" .. ": 1 other value",
  "an intact session file is opened")
is(five, 5, "the value of an intact session file")
local kept = print
for what, settings in pairs{
  ["a global of the program as a name"] = { kind = "number", is = 5, ["key.1"] = "print" },
  ["a value without a name"] = { kind = "number", is = 5 },
  ["a list as a name"] = { kind = "number", is = 5, ["key.1"] = { 1, 2 } },
  ["a name with a control code"] = { kind = "number", is = 5, ["key.1"] = "a\27[2J" },
  ["a name with a line break"] = { kind = "number", is = 5, ["key.1"] = "a\nb" },
  ["a fraction as a key"] = { kind = "number", is = 5, ["key.1"] = "t", ["key.2"] = 0.5 },
  ["a missing table"] = { kind = "number", is = 5, ["key.1"] = "t", ["key.2"] = "x" },
  ["an unknown kind of value"] = { kind = "dragon", ["key.1"] = "t" },
  ["a value without a kind"] = { ["key.1"] = "t" },
  ["the model of a missing run"] = { kind = "model", of = 7, ["key.1"] = "t" },
  ["a reference to a missing value"] = { kind = "same", same = 7, ["key.1"] = "t" },
  ["a number as a list"] = { kind = "list", is = 3, ["key.1"] = "t" },
  ["a study with too many cases"] = { kind = "study", count = 1e9, ["key.1"] = "t" },
} do
  fails(function() session.open(stranger(settings)) end, { "session.open: ", "the file is damaged: case 1" }, what)
end
is(print, kept, "a function of Lua is not replaced")
is(rawget(_G, "t"), nil, "a damaged file creates no variable")
os.execute("mkfifo " .. path "pipe")
holds(session.open(stranger{ kind = "study", file = path "pipe", ["key.1"] = "s" }),
  { "left out: ", "s: file " .. path "pipe" .. " not found" }, "a pipe as the file of a study")
holds(session.open(stranger{ kind = "study", file = path "pi\27[2Jpe", ["key.1"] = "s" }),
  { "left out: ", path "pi\\x1b[2Jpe" .. " not found" }, "control codes in a file name are shown as text")
fails(function() study.open(path "pipe") end, { "not a file" }, "study.open of a pipe")
fails(function() wear.open(path "pipe") end, { "not a file" }, "wear.open of a pipe")

-- --- the functions who, time and examples ----------------------------------------------------------

forget()
holds(printed(who), "no variables yet", "who() in an empty session")
w, length, title = quickened{}, 0.5, "a title"
w:step()
local list = printed(who)
holds(list, { "length  number  0.5\n", "title   string  a title\n", "w       wear    cycle 20 of 6000, 1 update, not saved" }, "who() lists names, classes and states")
ok(not list:find "print" and not list:find "session", "who() does not list globals of the program")
broken = setmetatable({}, { __tostring = function() return {} end })
holds(printed(who), "broken  table   (its __tostring failed", "who() with an object that cannot be printed")
broken = nil
rawset(_G, "od\27d", 1)
title = "a\27[2J\194\155title"
list = printed(who)
holds(list, { "od\\x1bd", "a\\x1b[2J\\xc2\\x9btitle" }, "who() shows control codes as text")
ok(not list:find "\27" and not list:find "\155", "control characters are removed")
list = printed(require "archard.lib.prompt".show, title, { title })
holds(list, { "a\\x1b[2J\\xc2\\x9btitle", '"a\\27[2J\\xc2\\x9btitle"' },
  "the prompt shows control codes as text")
holds(session.save(path "odd"), "not saved: od\\x1bd (number)",
  "variables with control codes in their names are not saved")
rawset(_G, "od\27d", nil)
local told, a, b = printed(time, function(...) return ..., 5 end, 4)
holds(told, { "time: ", " ms, processors " }, "time() prints the times")
is(a + b, 9, "time() returns the results")
fails(function() time(3) end, { "time", "expected a function", "got 3" }, "time() of a number")
holds(printed(examples), { "01_contact", "05_running_in", "examples.run" }, "examples are listed")
tap.fails(function() examples.run "hip" end, { "did you mean 'metal_on_metal_hip' or 'hip_cross_shear'?" }, "examples with the word")
holds(printed(examples, "coating"), "local thickness", "an example is shown")
is(printed(examples, 6), printed(examples, "06_coating"),
  "an example is found by its number and by its full name")
fails(function() examples(0) end, "no example 0", "a missing example")
fails(function() examples "coatin" end, "did you mean 'coating'?", "a misspelt name of an example")
local script = arg
holds(printed(examples.run, "calibrate"), { "calibration from 3 measurements", "alpha" }, "an example is run")
is(arg, script, "an example does not change the arguments of the session")

os.execute("rm -r " .. folder)

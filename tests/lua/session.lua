-- Tests session.save and session.open: objects are restored under their names, and restored runs are
-- identical to the bit. Also tests who(), time() and examples().
-- Ordinary collector settings are used (see tests/run): continuous garbage collection would only slow this code down.
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

is(leave.question(), nil, "nothing made, nothing to ask")
w = quickened{}
is(w.saved, false, "a new run is in no file")
is(leave.question(), nil, "no question without unsaved results")
w:step(2)
holds(leave.question(), { "not saved: w\n", "session.archard before leaving? yes, no or stay" }, "a question about unsaved results")
w:save(path "w.archard")
is(w.saved, true, "a saved run is in a file")
is(w:clone().saved, true, "the clone of a saved run counts as saved")
is(leave.question(), nil, "nothing to ask then")
w:step()
is(w.saved, false, "a step makes it another")
is(wear.open(path "w.archard").saved, true, "an opened run is in a file")

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
  "it says what was kept and what was not")
is(w.saved and driven.saved and runs.pair[1].saved, true, "the runs are in a file now")
holds(leave.question(), "not saved: on_function\n", "a question about a run that cannot be stored")
on_function = nil
is(leave.question(), nil, "nothing to ask")
local w_next = w:clone():step(3)
local expected = { w_next.p_center, w_next.depth_plate, w_next.volume_cylinder }

local kept = table.move({ path, tap, expected }, 1, 3, 1, {})
forget()
is(rawget(_G, "w"), nil, "an empty session")
fails(function() session.open(path "s.archard") end, { "session.open: driven: field 'k': expected a function, as when",
  "session.open(path, { driven = { k = f } })" }, "the error explains how to give the functions")
is(#own.list(), 0, "nothing is opened without the functions")
holds(session.open(path "s.archard", { driven = { k = function() return 2e-8 end } }), "4 runs, 2 models, 2 studies, 3 contacts, 3 results", "a session opens with its functions")
is(leave.question(), nil, "no question after opening")
is(tostring(pulled), before.pulled, "a contact with its motions")
is(tostring(on_worn), before.on_worn, "one on worn surfaces")
is(tostring(found), before.found, "a calibration")
ok(rawequal(results.again, found), "under two names one")
is(tostring(trace), before.trace, "a measured profile")
is(trace:volume{ scar = { 2, 3 } }.error, before.area, "with the uncertainty of its level")
is(tostring(results[1]), before.map, "a map")
is(tostring(w), before.w, "a run as it was")
is(driven.volume.total, before.volume, "one with a function too")
is(driven.k(), 2e-8, "the function is restored")
is(runs.pair[1].depth.plate, before.pair, "a run in a table is restored")
ok(rawequal(runs[1], w), "one object under two names is one again")
is(runs[7], "text", "keys of a list are restored")
is(w.model, m, "the model is that of the run")
is(on_fitted.model, fitted, "also where its size followed from the load")
is(fitted.mesh.fineness, 1, "a fitted mesh keeps its fineness")
is(steel.E, 210e3, "a material")
is(math.type(whole) .. " " .. whole .. " " .. share .. " " .. tostring(yes) .. " " .. text, "integer 7 0.1 true a\nb", "plain values")
is(huge, math.maxinteger, "the largest whole number")
is(#numbers .. " " .. 1 / numbers[3], "3 -inf", "lists, with the sign of zero")
is(#long .. " " .. math.type(long[9]) .. " " .. long[200000], "200000 integer 200000", "long ones")
is(wide[2] - 1, 2^53 | 0, "integers beyond the range of doubles")
ok(told.depth_partition[1] ~= told.depth_partition[1] and told.distance[2] == w.history.distance[2], "a history, NaN in it")
is(odd[1] .. " " .. tostring(odd[2] ~= odd[2]) .. " " .. odd[3] .. " " .. odd.nested[1], "1 true inf -inf", "infinite numbers")
ok(odd.nothing ~= odd.nothing, "NaN alone")
is(plan:cases()[2].stroke .. " " .. plan:cases()[2].alpha .. " " .. plan.name, "0.2 0.5 plan", "a study that has not run")
is(computed:cases()[1].status, "done", "one that has, from its file")
w_next = w:step(3)
is(w_next.p_center == kept[3][1] and w_next.depth_plate == kept[3][2] and w_next.volume_cylinder == kept[3][3], true,
  "a run goes on to the same bits")

-- --- nothing lost --------------------------------------------------------------------------------

fails(function() session.open(path "s.archard", { driven = { k = function() return 2e-8 end } }) end,
  { "session.open", "is a run that has not been saved" }, "an unsaved run is not overwritten")
is(w.update, 6, "the unsaved run is unchanged")
holds(session.save(), "saved in " .. path "s.archard", "saved again without a name")
for _, case in ipairs{ false, 1, 2 } do
  fails(function() wear.open(path "s.archard", case or nil) end, { "got a session", "use session.open" },
    "wear.open takes no part of a session")
end
fails(function() session.save(path "w.archard") end, { "session.save", "w.archard" }, "another file is not replaced")
is(wear.open(path "w.archard").update, 2, "the run file is complete")
fails(function() session.save(path "none/s.archard") end, "session.save", "a folder that is not there")
fails(function() session.open(path "w.archard") end, { "session.open", "expected a file of session.save, got a run file of kind wear" },
  "a run is no session")
fails(function() session.open(path "none") end, { "session.open", "none" }, "a missing file")
fails(function() session.open(3) end, "expected the name of a file, got 3", "a number for a name")
os.remove(path "computed.archard")
local opened = session.open(path "s.archard", { driven = { k = function() return 2e-8 end } })
holds(opened, { "left out: computed: ", "computed.archard not found" }, "a study without its file is reported")

-- --- the question --------------------------------------------------------------------------------

w:step()
is(leave.answer "no", true, "the answer no leaves the program")
is(leave.answer "s", false, "stay stays")
is(leave.answer "what", nil, "another answer repeats the question")
is(file_module.suggested(), path "s.archard", "the suggested file is that of the session")
holds(printed(leave.answer, "yes"), "saved in " .. path "s.archard", "yes saves")
is(w.saved, true, "indeed")

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
  "a sound one")
is(five, 5, "is opened")
local kept = print
for what, settings in pairs{
  ["a name of the program's"] = { kind = "number", is = 5, ["key.1"] = "print" },
  ["no name"] = { kind = "number", is = 5 },
  ["a name that is none"] = { kind = "number", is = 5, ["key.1"] = { 1, 2 } },
  ["a name that a terminal obeys"] = { kind = "number", is = 5, ["key.1"] = "a\27[2J" },
  ["a name of two lines"] = { kind = "number", is = 5, ["key.1"] = "a\nb" },
  ["a key that is none"] = { kind = "number", is = 5, ["key.1"] = "t", ["key.2"] = 0.5 },
  ["a table that is not there"] = { kind = "number", is = 5, ["key.1"] = "t", ["key.2"] = "x" },
  ["an unknown kind"] = { kind = "dragon", ["key.1"] = "t" },
  ["no kind"] = { ["key.1"] = "t" },
  ["the model of a run that is not there"] = { kind = "model", of = 7, ["key.1"] = "t" },
  ["the same as what is not there"] = { kind = "same", same = 7, ["key.1"] = "t" },
  ["a list that is none"] = { kind = "list", is = 3, ["key.1"] = "t" },
  ["a study of far too many cases"] = { kind = "study", count = 1e9, ["key.1"] = "t" },
} do
  fails(function() session.open(stranger(settings)) end, { "session.open: ", "the file is damaged: case 1" }, what)
end
is(print, kept, "a function of Lua is not replaced")
is(rawget(_G, "t"), nil, "nothing was made")
os.execute("mkfifo " .. path "pipe")
holds(session.open(stranger{ kind = "study", file = path "pipe", ["key.1"] = "s" }),
  { "left out: ", "s: file " .. path "pipe" .. " not found" }, "a pipe is no file")
holds(session.open(stranger{ kind = "study", file = path "pi\27[2Jpe", ["key.1"] = "s" }),
  { "left out: ", path "pi\\x1b[2Jpe" .. " not found" }, "codes are shown")
fails(function() study.open(path "pipe") end, { "not a file" }, "a pipe as a study")
fails(function() wear.open(path "pipe") end, { "not a file" }, "a pipe as a run")

-- --- the functions who, time and examples ----------------------------------------------------------

forget()
holds(printed(who), "no variables yet", "an empty session")
w, length, title = quickened{}, 0.5, "a title"
w:step()
local list = printed(who)
holds(list, { "length  number  0.5\n", "title   string  a title\n", "w       wear    cycle 20 of 6000, 1 update, not saved" }, "who() lists names, classes and states")
ok(not list:find "print" and not list:find "session", "who() lists nothing else")
rawset(_G, "od\27d", 1)
title = "a\27[2J\194\155title"
list = printed(who)
holds(list, { "od\\x1bd", "a\\x1b[2J\\xc2\\x9btitle" }, "codes that a terminal obeys are shown")
ok(not list:find "\27" and not list:find "\155", "control characters are removed")
list = printed(require "archard.lib.prompt".show, title, { title })
holds(list, { "a\\x1b[2J\\xc2\\x9btitle", '"a\\27[2J\\xc2\\x9btitle"' }, "by the prompt too")
holds(session.save(path "odd"), "not saved: od\\x1bd (number)", "such names are in no file")
rawset(_G, "od\27d", nil)
local told, a, b = printed(time, function(...) return ..., 5 end, 4)
holds(told, { "time: ", " ms, processors " }, "time() prints the times")
is(a + b, 9, "time() returns the results")
fails(function() time(3) end, { "time", "expected a function", "got 3" }, "of a function")
holds(printed(examples), { "01_contact", "05_running_in", "examples.run" }, "examples are listed")
holds(printed(examples, "coating"), "local thickness", "an example is shown")
is(printed(examples, 6), printed(examples, "06_coating"), "by number as by full name")
fails(function() examples(0) end, "no example 0", "a missing example")
fails(function() examples "coatin" end, "did you mean 'coating'?", "by name")
local script = arg
holds(printed(examples.run, "calibrate"), { "calibration from 3 measurements", "alpha" }, "an example is run")
is(arg, script, "with arguments of their own")

os.execute("rm -r " .. folder)

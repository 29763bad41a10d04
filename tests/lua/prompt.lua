-- Tests the prompt: complete chunks, display of values, completion.
package.path = arg[0]:gsub("[^/]*$", "") .. "lib/?.lua;" .. package.path
local tap = require "tap"
local pretty = require "archard.lib.pretty"
local prompt = require "archard.lib.prompt"
local complete = require "archard.session.complete"
local help = require "archard.help"

-- --- chunks ------------------------------------------------------------------------------------

local function state(text)
  local chunk, message = prompt.compile(text, "=test", 1)
  if chunk then return table.pack(chunk())[1] end
  return message and "wrong" or "open"
end

tap.is(state("1 + 1"), 2, "an expression gives its value")
tap.is(state("= 6 * 7"), 42, "an expression after = gives its value")
tap.is(state("return 5"), 5, "return gives a value")
tap.is(state("-- nothing"), nil, "a comment is complete")
tap.is(state(""), nil, "an empty text is complete")
for _, text in ipairs { "for i = 1, 2 do", "x = {", "f(", "1 +", "[[ text", "a = [==[ x", "if x then",
  "function f()", "x =", "--[[ comment", "print('a',", "repeat", "w = wear{ k=1e-8,",
  "'text \\" } do
  tap.is(state(text), "open", "incomplete text: " .. text)
end
for _, text in ipairs { "x = = 1", "end", "a b", "'text", "for 1", "1 + + 2)" } do
  tap.is(state(text), "wrong", "wrong text: " .. text)
end
tap.is(state("local a = 2\na * 3"), 6, "the value of the last pasted line is shown")
tap.is(state("t = 0\nfor i = 1, 3 do\n  t = t + i\nend\nt"), 6,
  "a pasted loop runs to its end before the last line")
tap.is(state("n = 0\nfor i = 1, 3 do\n  n = n + 1\nend"), nil, "the end of a loop has no value")
tap.is(n, 3, "a pasted loop is run completely")
tap.is(state("a = 7\n-2"), nil, "a line that continues the previous line is not separated")
tap.is(a, 5, "the continued line has the value that Lua computes")
local _, message = prompt.compile("x = = 1", "=name", 12)
local comma
_, comma = prompt.compile("w = wear{ load=50,\n  stroke=4 k=2 }", "=name", 1)
tap.holds(comma, "near 'k'; a comma is missing before k", "a field without a comma before it")
_, comma = prompt.compile("x = (3 y)", "=name", 1)
tap.ok(not comma:find "comma", "no hint of a comma in other texts")
tap.is(message, "name:12: unexpected symbol near '='", "line numbers in messages start at the given line")
local function message_of(text) return select(2, prompt.compile(text, "=name", 1)) end
tap.is(message_of "w:run", "a method is called with () or {}: w:run()", "a method without parentheses does not wait for more lines")
tap.holds(message_of "x = 5 mm", 'numbers have no units: 5 instead of 5 mm (help "units")', "a unit after a blank")
tap.holds(message_of "x = 5mm", 'numbers have no units: 5 (help "units")', "a unit after a number")
tap.holds(message_of "k = 1.5e-6 mm3/(N m)", "numbers have no units: 1.5e-6 instead of 1.5e-6 mm3", "a compound unit")
tap.holds(message_of "w = wear{ distance = 20 km }", "numbers have no units: 20 instead of 20 km", "a unit in a table")
tap.is(message_of "for i = 1, 2 do\n  w:run", nil, "an open loop waits for more lines")

-- --- values ------------------------------------------------------------------------------------

local function looks(value, text, what) tap.is(pretty.format(value, { width = 80 }), text, what) end
looks(1.5, "1.5", "a number")
looks("a\tb", "a\tb", "a string is shown unchanged")
looks({ "a\n\"b\"\\" }, [[{ "a\n\"b\"\\" }]], "a string in a table is quoted")
looks({ "µm" }, '{ "µm" }', "UTF-8 in a table is shown unchanged")
looks({ "\xff\0" }, '{ "\\255\\0" }', "bytes that are not UTF-8 are shown as numbers")
looks({}, "{}", "an empty table")
looks({ b = 1, a = 2, [10] = 3, [true] = 4, 5 }, "{ 5, [10] = 3, a = 2, b = 1, [true] = 4 }",
  "keys of a table are sorted")
looks({ 0 / 0, -(0 / 0), -0.0, 1 / 0 }, "{ nan, nan, 0, inf }", "nan, negative zero and infinity")
looks({ ["end"] = 1, ["a b"] = 2 }, '{ ["a b"] = 2, ["end"] = 1 }', "keys that are not identifiers")
looks({ 1 / 3, 2 }, "{ 0.333333, 2 }", "numbers in a list have six digits")
looks({ x = 1 / 3 }, "{ x = 0.33333333333333 }", "numbers in a field have fourteen digits")
looks({ { { { { { 1 } } } } } }, "{ { { { { {...} } } } } }", "deep tables are shortened")
local cycle = {}
cycle.me = { cycle }
looks(cycle, "{ me = { <cycle> } }", "a table with a cycle")
local twice = { 1 }
looks({ twice, twice }, "{ { 1 }, { 1 } }", "a table shown twice is not a cycle")
looks(setmetatable({}, { __tostring = function() return "mine" end }), "mine",
  "an object is shown by its __tostring")
looks({ setmetatable({}, { __tostring = function() return "one\ntwo" end }) }, "{ one ... }",
  "an object in a table is shown on one line")
tap.holds(pretty.format(setmetatable({}, { __tostring = function() error("oops") end })), "oops",
  "an error in __tostring is shown")
looks(setmetatable({ 1 }, { __index = error, __pairs = error, __len = error }), "{ 1 }",
  "no metamethod except __tostring is called")
local long = {}
for i = 1, 1000 do long[i] = i end
tap.holds(pretty.format(long), { "..., 1000", "(1000 items)" }, "a long list is shortened")
tap.holds(pretty.format({ x = long }), "x = { 1, 2, 3, 4, ..., 1000 } (1000 items)",
  "a long list in a table is shortened further")
local wide = true
for width = 20, 120, 7 do
  local deep = { name = long, list = { { a = 1, b = "text" }, { a = 2, b = "more text" } }, long }
  for line in pretty.format(deep, { width = width }):gmatch("[^\n]+") do
    wide = wide and #line <= math.max(width, 60)
  end
end
tap.ok(wide, "lines fit the given width")
local huge = {}
for i = 1, 80 do
  huge[i] = {}
  for j = 1, 80 do huge[i]["k" .. j] = { j } end
end
tap.ok(#pretty.format(huge) < 100000, "the text of a large table is limited")
tap.is(pretty.format({ 1, "a" }, { colour = true }), "{ \27[36m1\27[0m, \27[32m\"a\"\27[0m }",
  "colours on request")

-- --- completion --------------------------------------------------------------------------------

local function words(text)
  local list, append = complete.words(text)
  if type(list) == "string" then return list end
  return table.concat(list, " ") .. (append ~= "" and "|" .. append or "")
end
local function offers(text, expected) tap.is(words(text), expected, "completions of: " .. text) end
local function has(text, wanted, unwanted)
  local list = " " .. words(text):gsub("|.*", "") .. " "
  for word in (wanted or ""):gmatch("%S+") do
    tap.ok(list:find(" " .. word .. " ", 1, true), "completion " .. word .. " for: " .. text)
  end
  for word in (unwanted or ""):gmatch("%S+") do
    tap.ok(not list:find(" " .. word .. " ", 1, true), "no completion " .. word .. " for: " .. text)
  end
end

_G.m = model { mesh = { size = 0.04, height = 0.05 } }
_G.w = wear { model = m }
_G.c = contact { model = m }
_G.data = { inner = { deep = { leaf = 1 } }, list = { { first = 1 } }, ["no name"] = 2 }

offers("wea", "wear")
has("", "wear model help print", "_VERSION _G")
offers("_VER", "_VERSION")
offers("data.", "inner list")
offers("data.inner.deep.", "leaf")
offers('data["inner"].de', "deep")
offers("data.list[1].", "first")
offers("nosuch.", "")
offers("f().", "")
has("w:", "step run clone profile pressure", "alpha depth stroke")
has("w.", "depth volume p_center step history")
offers("w.depth.", "cylinder plate")
offers("w.volume.t", "total")
local columns = {}
for name in pairs(w.history) do columns[#columns + 1] = name end
table.sort(columns)
offers("w.history.", table.concat(columns, " "))
has("wear{ k = function(state) return state.", "distance depth p_center k")
has("m.mesh.cylinder.", "nodes quads")
has("m.mesh.cylinder:", "quality node", "nodes")
has("w.model.mesh.plate.", "quads")
has("c:", "stress pressure")
has("plot.", "pressure history mesh")
offers("x = wear{ al", "alpha|=")
offers("x = wear{ alpha=0.5, al", "")
offers("x = wear {\n  k = 1e-8, -- the { couple\n  al", "alpha|=")
offers("wear({ k=1, str", "stroke|=")
offers("wear(data, wea", "wear")
has("plot.profile(w, ", "w c data", "measured")
offers("wear{ loading={ per", "periodic|=")
offers("wear{ model={ mesh={ he", "height|=")
offers("wear{ local_factor={ v", "vector|=")
offers("w:set{ al", "alpha|=")
offers("w:set{ loading={ { cy", "cycles|=")
has("w:set{ ", "alpha load loading stroke", "model worn geometry wear print")
has("w:set{ model={ ", "", "radius mesh")
for _, name in ipairs(complete.words "w:set{ ") do
  local _, err = pcall(w.set, w, { [name] = print })
  tap.ok(not tostring(err):find "unknown field" and not tostring(err):find "cannot be changed",
    "w:set accepts " .. name)
end
offers("w:run{ st", "stop_when|=")
offers("w:run{ depth={ c", "cylinder|=")
offers("csv.", "read")
has('gait "', "iso prosim", "rocking")
has('gait("', "iso prosim", "rocking")
has("model{ mesh={ zone={ ", "cylinder plate", "size")
offers("w:run{ pro", "progress|=")
has("plot.pressure(w, { ", "scaled body xlabel term")
has("study{ base={ al", "alpha")
has("study{ cases={ { alpha=1, st", "stroke")
has("plot{ {x={}, y={}}, { ti", "title")
has("wear{ alpha = ma", "math material")
offers('wear{ procedure="', "auto SP NSP")
offers("wear{ scheme = '", "explicit implicit")
offers('w:pressure("', "cylinder plate")
offers('w:profile "', "cylinder plate")
offers('io.open("', "files")
offers('wear{ k=f("', "files")
has('require "', "archard.term string")
has('help "', "wear.step wear{jump}")
offers("-- wea", "")
offers("--[[ wea", "")
offers("x = 'it' .. wea", "wear")
offers('print("a\\"b", wea', "wear")
has("{ wea", "wear")
has("f{ wea", "wear")
has("whi", "while")
has("string.", "format rep")
has("('x'):", "")

local called = false
_G.trap = setmetatable({}, { __index = function() called = true end, __pairs = error,
  __len = error, __eq = error })
offers("trap.x.", "")
offers("trap.", "")
tap.ok(not called, "completion calls no metamethod")
_G.broken = setmetatable({}, { __fields = function() error("no") end })
offers("broken.", "")

-- --- help --------------------------------------------------------------------------------------

tap.is(help.address_of(wear), "wear", "help address of a constructor")
tap.is(help.address_of(w), "wear", "help address of an object")
tap.is(help.address_of(w.step), "wear.step", "help address of a method")
tap.is(help.address_of(plot.pressure), "plot.pressure", "help address of a function")
tap.is(help.address_of(print), nil, "functions of Lua have no help address")
tap.is(#help.find("w:step()"), 1, "help finds a name written as a call")
for name, address in pairs{ ["c.slip"] = "contact.slip", ["c:stick"] = "contact.stick", ["t.volume"] = "map.volume" } do
  tap.is(help.find(name)[1].address, address, "help finds " .. name .. ", a variable of the help texts")
end
tap.ok(#help.find("alpha") >= 2, "help finds all entries of a name")
tap.holds(help.text("strok"), 'did you mean "stroke"', "help proposes the nearest name")
tap.holds(help.text(nil), "nil", "help of nil")
tap.holds(tostring(help), "archard simulates", "print(help) shows the overview")
for word, start in pairs{ roughness = "measured surface\n", ["plane stress"] = "model{geometry}",
  compare = "plot.profile(", ["wear rate over time"] = "wear rate\n", ["save figure"] = "plot.save(", cores = "wear{workers}", friction = "fretting\n", ["?"] = "prompt\n", undo = "prompt\n",
  thermal = "limits\n", ["2D"] = "model{geometry}", ["wear.roughness"] = "w:roughness", jump = "wear{jump}" } do
  tap.is(help.text(word):sub(1, #start), start, ("help %q begins with the best entry"):format(word))
end
tap.holds(help.text "rolling", "limits\n\n  Rolling is not simulated", "a word shows its paragraph of a long topic")
tap.holds(help.text "rolling", 'help "limits" shows the whole topic', "and names the topic")
tap.ok(not help.text("limits"):find("shows the whole topic", 1, true), "the topic's own name shows all paragraphs")

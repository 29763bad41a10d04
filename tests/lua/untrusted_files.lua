-- Tests untrusted study files: any content is either opened completely or gives one error that names the
-- damage; texts are shown without control codes for terminals.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, fails, holds = tap.ok, tap.is, tap.fails, tap.holds
local merged = require "archard.lib.merged"

local path = os.tmpname()
os.remove(path)

-- Writes a study file with valid checksums. `info` contains texts by name, `cases` the settings of each case.
local function stranger(given)
  local file <close> = require "archard.store".replace(path, "study")
  file:begin()
  for name, text in pairs(given.info or {}) do file:set_info(name, text) end
  for id, flat in pairs(given.cases) do
    file:add(id, "x\27[2J")
    file:set_values(id, "settings", flat)
    file:mark(id, given.status or "waiting")
  end
  file:commit()
  file:publish()
  return path
end

local function damaged(given, words, what)
  fails(function() study.open(stranger(given)) end,
    { "study.open: " .. path .. ": the file is damaged: ", table.unpack(words) }, what)
end

-- --- settings ------------------------------------------------------------------------------------

local two = { { alpha = 0.2 }, { alpha = 0.3 } }
local s = study.open(stranger{ cases = two, info = { name = "a\27b" } })
is(#s:cases(), 2, "an intact file is opened")
s = study.open(stranger{ cases = { { scheme = "explicit" }, { scheme = "\27[2J" } }, info = { name = "a\27b" } })
for _, text in ipairs{ tostring(s), s:table(), s:table{ format = "csv" }, s:table{ format = "markdown" }, tostring(s:cases()[2]),
  s.labels[2] } do
  ok(not text:find "\27", "no control code in " .. text:match "^[%w |]+")
end
holds(s:table(), "\\x1b[2J", "texts are shown without control characters")

for what, name in pairs{ ["an empty name of a setting"] = "", ["a name that is a dot"] = ".",
  ["a name that ends with a dot"] = "alpha.", ["a name with an empty part"] = "model..radius",
  ["a name with control codes"] = "alpha\27]0;x\7", ["a name with a line break"] = "alpha\nk",
  ["a name that is not UTF-8"] = "alph\xe4" } do
  damaged({ cases = { two[1], { [name] = 1 } } }, { "case 2 has a value with the unknown name" }, what)
end
damaged({ cases = { { alpha = 1, ["alpha.x"] = 2 } } }, { "case 1 has the settings 'alpha' and 'alpha.x'" },
  "a setting that has a value and fields")
damaged({ cases = { { alpha = math.huge } } }, { "'alpha' is not a finite number" },
  "an infinite number as a setting")
damaged({ cases = { two[1], [3] = two[2] } }, { "it has a case 3, but no case 2" }, "a gap in the cases")
damaged({ cases = {} }, { "it has no case" }, "a study without cases")
damaged({ cases = two, info = { looks = "-1" } }, { "-1 looks" }, "a negative number of snapshots")
damaged({ cases = two, info = { task = "dance" } }, { "'dance'" }, "an unknown task")
fails(function() study{ base = { [""] = 1 } } end, { 'study: unknown field ""', "ASCII" },
  "a study with an empty name of a field")
fails(function() study{ vary = { ["alp\0ha"] = { 1, 2 } } } end, [[unknown field "alp\0ha"]], "a varied name with a zero byte is shown completely")

-- --- samples -------------------------------------------------------------------------------------

local head, line = "sobol n=2 seed=1 indices=false", "\nalpha uniform{ low=0.1, high=0.4 }"
local function sampled(text, cases) return { cases = cases or two, info = { sample = text } } end
is(study.open(stranger(sampled(head .. line))).sample.fields[1].name, "alpha", "intact samples are read")
for _, text in ipairs{ "nonsense", "", head, head .. "\nalpha uniform{}", head .. line .. line, head .. " x" .. line, head .. line .. "\n",
  "grid n=2 seed=1 indices=false" .. line, "sobol n=1 seed=1 indices=false" .. line, "sobol n=2 seed=0 indices=false" .. line,
  "sobol n=1e9 seed=1 indices=false" .. line, "sobol n=2 seed=1 indices=maybe" .. line, head .. "\nalpha dance{ low=1 }",
  head .. "\nalpha uniform{ low=one }", ("9"):rep(400) .. line, "sobol n=" .. ("9"):rep(400) .. " seed=1 indices=false" .. line } do
  damaged(sampled(text), { "invalid samples: " }, ("samples %q"):format(text:sub(1, 50)))
end
damaged(sampled((head:gsub("n=2", "n=3")) .. line), { "its samples need 3 cases, the file has 2" },
  "fewer cases than samples")
damaged(sampled(head:gsub("false", "true") .. line), { "its samples need 6 cases, the file has 2" },
  "fewer cases than samples with indices")
for what, value in pairs{ ["a text"] = "x", ["a list"] = { 1, 2 }, ["a flag"] = true } do
  damaged(sampled(head .. line, { two[1], { alpha = value } }), { "case 2 has no number for the sampled field 'alpha'" }, what)
end
damaged(sampled(head .. line, { two[1], { k = 1 } }), { "case 2 has no number" },
  "a case without the sampled field")
damaged(sampled(head .. "\nbeta" .. line:sub(7)), { "case 1 has no number for the sampled field 'beta'" },
  "a sampled field that no case has")

-- Tests that every text written by studies can be read again.
for _, given in ipairs{ { sample = { alpha = uniform{ 0.1, 0.4 }, model = { plate = { E = normal{ 2e5, 1e4, low = 1e5 } } } }, n = 5 },
  { sample = { k = lognormal{ mean = 1e-8, variation = 0.3 } }, n = 16, indices = true, design = "latin", seed = 2 ^ 31 - 1 } } do
  given.base = { model = { mesh = { size = 0.04, height = 0.05 } } }
  local made = study(merged(given, {}))
  local text = require "archard.uncertainty.design".text(made.sample)
  local there = study.open(stranger{ cases = made.flat, info = { sample = text } }).sample
  is(require "archard.uncertainty.design".text(there), text, "samples of a study: " .. text:match "[^\n]+")
end

s = study.open(stranger(merged(sampled(head .. line), { status = "done" })))
for name, ask in pairs{ uncertainty = function() s:uncertainty() end, failure = function() s:failure{ of = "p_center", above = 1 } end } do
  fails(ask, { "study:" .. name, "the file is damaged: case 1 is done and has no history" }, name .. " of cases without a history")
end

-- Tests a plot of a case whose settings are texts instead of numbers: the error is the same as for a case
-- without results.
s = study.open(stranger{ cases = { { alpha = "x", stroke = "y", load = "z" } } })
fails(function() plot.profile(s:cases()[1], { file = path .. ".svg" }) end,
  "has no surface stored; its status is waiting",
  "plot.profile of a case with texts as settings")

-- --- wrong arguments of the functions of help ----------------------------------------------------

for _, name in ipairs{ "find", "option", "matches", "fields", "members", "definition", "entry" } do
  for _, value in ipairs{ false, 1, {}, print } do
    local fine, found = pcall(help[name], value)
    ok(fine and (type(found) ~= "table" or #found == 0),
      ("help.%s(%s) returns no entry"):format(name, type(value)))
    ok(pcall(help[name], "wear", value), ("help.%s('wear', %s)"):format(name, type(value)))
  end
end
fails(function() wear{ ["lo\0ad"] = 1 } end, [[unknown field 'lo\0ad']], "a name with a zero byte is shown completely")
fails(function() wear{ ["load\0"] = 1 } end, [[unknown field 'load\0']], "a field name with a zero byte")

os.remove(path)

-- Tests studies: settings, running, resuming, shards, tables, results of cases; wear:save and wear.open.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- with which it would be 40 times slower.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local is, near, fails, holds = tap.is, tap.near, tap.fails, tap.holds

local folder = os.tmpname()
os.remove(folder)
assert(os.execute("mkdir " .. folder))
local function path(name) return folder .. "/" .. name end

local coarse = { geometry = "frozen", increments = 8, distance = 220,
  model = { mesh = { size = 0.04, height = 0.05 } } }
local function small(given)
  given.base = coarse
  return study(given)
end

-- --- settings ----------------------------------------------------------------------------------
local settings = require "archard.definition.settings"
local nested = { alpha = 0.5, model = { mesh = { size = 0.04 }, plate = material{ E = 1e5 } },
  loading = { { x = { 0, 1 }, cycles = 3 }, { x = { 2 } } }, scheme = "explicit", flag = true }
local flat = settings.flatten("test", nested)
is(flat["model.mesh.size"], 0.04, "names of nested settings are joined by dots")
is(flat["model.plate.E"], 1e5, "a material becomes its fields")
is(#flat["loading.1.x"], 2, "a list of numbers remains a list")
local again = settings.nest(flat)
is(again.loading[2].x[1], 2, "list positions are restored as numbers")
is(settings.difference(flat, settings.flatten("test", again)), nil, "settings are restored after flattening")
is(settings.flatten("test", { model = model{ radius = 8 } })["model.mesh.element"], "auto",
  "a model becomes its definition")
fails(function() settings.flatten("test", { k = function() end }) end, { "'k'", "function" },
  "the refusal of a function names the setting")
fails(function() settings.flatten("test", { k = 0 / 0 }) end, { "'k'", "finite" }, "NaN is refused")
local grid = settings.grid("test", { stroke = { 1, 2 }, alpha = { 0, 1 }, model = { radius = { 8 } } })
is(#grid, 4, "a grid has all combinations")
is(grid[2].alpha .. " " .. grid[2].stroke .. " " .. grid[2]["model.radius"], "0 2 8",
  "the last name changes fastest")

-- Tests that settings of a case override settings of base, also if one is a number and the other a table.
local function joined(base, over) return settings.nest(settings.join("test", base, over)) end
is(joined({ k = { distance = { 0, 1 }, value = { 1, 2 } } }, { k = 3 }).k, 3, "a number replaces a series")
is(joined({ k = 3 }, { k = { distance = { 0, 1 }, value = { 1, 2 } } }).k.value[2], 2,
  "a series replaces a number")
local block = { x = { 0, 1, 0 }, load = 100, cycles = 10 }
is(joined({ loading = { block, block } }, { loading = { block } }).loading[2], nil,
  "a shorter list replaces a longer one completely")
is(joined({ loading = { block, block } }, { loading = block }).loading[1], nil,
  "a block replaces a list of blocks")
local reached = joined({ loading = { block, block } }, { ["loading.2.cycles"] = 7 }).loading
is(reached[2].cycles .. " " .. reached[1].cycles .. " " .. reached[2].load, "7 10 100",
  "a name with dots addresses a field in a list")
is(block.cycles, 10, "the user's table is unchanged")
local mixed = joined({ model = model{ radius = 8 } }, { model = { mesh = { size = 0.03 } } }).model
is(mixed.radius .. " " .. mixed.mesh.size, "8.0 0.03", "fields of a model are merged")

-- --- definitions -------------------------------------------------------------------------------
fails(function() study{ bas = {} } end, { "'bas'", "did you mean 'base'" }, "a misspelt field")
fails(function() study{ vary = { alpha = 3 } } end, { "vary.alpha", "list" }, "vary needs lists")
fails(function() study{ vary = { alpha = {} } } end, "empty", "an empty list in vary")
fails(function() study{ vary = { alpha = { 1 } }, cases = { {} } } end, "got both", "vary and cases together")
fails(function() study{ base = { alfa = 3 } } end,
  { "study.lua:", "study: unknown field 'alfa' (did you mean 'alpha'?)" },
  "a misspelt field of wear is refused immediately")
fails(function() study{ vary = { k = { 1e-9, 2e-9 }, foo = { 1 } } } end, "unknown field 'foo' (",
  "a misspelt field in vary")
fails(function() study{ cases = { { alpha = 1 }, { ["model.mesh.sise"] = 1 } } } end,
  "unknown field 'model.mesh.sise' (did you mean 'size'?)", "a misspelt field of the mesh in a case")
fails(function() study.paper{ model = { plate = { G = 1 } } } end,
  { "study.paper: ", "'model.plate.G' (known: E, k, name, nu)" }, "a misspelt field of a material")
fails(function() study{ base = { loading = { { x = { 0, 1, 0 }, lode = 1 } } } } end,
  "unknown field 'loading.lode' (did you mean 'load'?)", "a misspelt field of a loading")
fails(function() study{ base = { radius = 8 } } end, "'radius': it is a field of model{}",
  "a field of the model outside the table model")
fails(function() study{ base = { alpha = 3 } }:run{ file = path "never" } end,
  { "study.lua:", "study:run: case 1: ", "'alpha'" },
  "a value out of range is refused before the first run")
is(io.open(path "never"), nil, "a refused study writes no file")
is(#study.paper():cases(), 20, "the paper's 20 cases")
is(study.paper():cases()[6].jump, 40, "a case of the paper has the jump of Table 1")
holds(tostring(study.paper()), { "paper", "20 cases", "alpha, stroke" }, "print(study)")

local waiting = study{ vary = { alpha = { 0.25, 0.5 } } }
for _, form in ipairs{ "text", "csv", "markdown" } do
  holds(waiting:table{ format = form }, { "0.25", "waiting" },
    "a table of cases that have not run, format " .. form)
end
holds(tostring(waiting:cases()[1]), { "case 1", "waiting" }, "print of a case that has not run")

-- --- running -----------------------------------------------------------------------------------
local function new_study() return small{ vary = { alpha = { 0.25, 0.5 }, stroke = { 0.11, 0.2 } },
  snapshots = 2 } end

local content = dofile(here .. "/lib/content.lua")

local events = {}
local one = new_study():run{ workers = 1, file = path "one",
  progress = function(event) events[#events + 1] = event end }
is(#one.failed, 0, "all cases are done")
is(#events, 4, "the progress function is called once per case")
is(events[4].done, 4, "the last event has the number of cases")
local three = new_study():run{ workers = 3, file = path "three", progress = false }
is(content(three), content(one), "three workers store the same bits as one worker")

local direct = wear(settings.nest(settings.flatten("test", { geometry = "frozen", increments = 8,
  distance = 220, alpha = 0.5, stroke = 0.2, model = coarse.model })))
direct:run()
local case = one:cases()[4]
is(case.status, "done", "the status of a case")
is(case.label, "alpha 0.5, stroke 0.2", "the label of a case")
is(case.alpha, 0.5, "a setting of a case")
is(case.k, 1e-8, "the default of a setting is read from the stored definition")
is(case.p_center, direct.p_center, "the pressure of a case equals the pressure of the run")
is(case.depth.plate, direct.depth.plate, "the depth of a case equals the depth of the run")
near(case.volume.total, 1e-8 * 100 * 220, 1e-9, "volume of a case")
is(#case.history.distance, #direct.history.distance, "length of the history of a case")
is(#case:distances(), 3, "two snapshots are stored before the end")
is(case:distances()[1], 0, "the first snapshot is at distance 0")
is(case:profile("plate").h[30], direct:profile("plate").h[30], "profile of a case")
is(case:pressure("plate").p[30], direct:pressure("plate").p[30], "pressure of a case")
is(case:profile("plate", 0).h[30], 0, "profile of a case at distance 0")
local sum, theirs = case:combined(), direct:combined()
near(sum.h[31], theirs.h[31], 1e-12, "sum of both profiles of a case")
near(case:local_partition().value[5], direct:local_partition().value[5], 1e-12, "local partition of a case")
near(case.hertz.half_width, hertz{}.half_width, 1e-12, "Hertz contact of a case")
holds(tostring(case), { "case 4", "done", "MPa" }, "print(case)")
fails(function() case:profile("table") end, '"cylinder" or "plate"', "profile of an unknown body")

local run = case:wear()
run:run{ distance = 330 }
direct:run{ distance = 330 }
is(run.p_center, direct.p_center, "a stored case continues with identical bits")
is(wear.open(path "one", 4).distance, 220, "wear.open of a case")
fails(function() wear.open(path "one") end, "has 4 cases", "wear.open of a study without a case number")

-- --- resuming ----------------------------------------------------------------------------------
local seconds = one:cases()[1].seconds
one = new_study():run{ workers = 2, file = path "one", progress = false }
is(one:cases()[1].seconds, seconds, "finished cases are not computed again")
fails(function() small{ vary = { alpha = { 0.25 } } }:run{ file = path "one" } end,
  { "another study", "4 cases" }, "a file of another study is refused")
fails(function()
  small{ vary = { alpha = { 0.25, 0.5 }, stroke = { 0.11, 0.3 } } }:run{ file = path "one" }
end, { "another study", "case 2", "stroke" }, "the message shows the first difference")
do
  local letter = assert(io.open(path "letter", "w"))
  letter:write(("Dear Sir, "):rep(20))
  letter:close()
  fails(function() new_study():run{ file = path "letter" } end, "not a run file",
    "a file that is not a run file is refused")
  local refused = fails(function() study.open(path "letter") end, "not a run file",
    "study.open of a file that is not a run file")
  holds(refused.position, "study.lua:", "the error has the line of the user's script")
  refused = fails(function() study.open(path "none") end, "No such file", "a missing file")
  is(refused.where, "study.open", "the error names the call of the user")
  is(#assert(io.open(path "letter")):read("a"), 200, "a refused file is unchanged")
end

-- Tests that a failed case does not affect other cases and is computed again.
local bad = small{ cases = { { alpha = 0.5 }, { alpha = 2 }, { alpha = 0.25 } } }
local quiet = io.stderr
local errors = {}
io.stderr = { write = function(_, ...) errors[#errors + 1] = table.concat{ ... } end }
bad:run{ workers = 2, file = path "bad", progress = false }
io.stderr = quiet
is(#bad.failed, 1, "one case failed")
holds(bad.failed[1].message, { "alpha", "2" }, "a failed case has its message")
holds(table.concat(errors), { "case 2", "alpha 2" }, "the failed case is reported")
local cases = bad:cases()
is(cases[1].status .. cases[2].status .. cases[3].status, "donefaileddone", "other cases are done")
is(cases[2].message:find "wear: field 'alpha'", 1, "the message is stored without a position in a script of archard")
holds(bad:table(), { "done", "failed [1]", "\n[1] wear: field 'alpha'" }, "the table shows the message")
is(study.open(path "bad"):cases()[2].status, "failed", "study.open shows the failed case")

holds(bad:table{ format = "csv" }, '\n2,2,,,,,,,,,,,"failed: ', "empty cells in CSV")

-- Tests that a study reports the warnings of its runs.
errors = {}
io.stderr = { write = function(_, ...) errors[#errors + 1] = table.concat{ ... } end }
local ripples = small{ vary = { jump = { 50, 530 } } }:run{ file = path "ripples", progress = false }
local told = table.concat(errors)
errors = {}
small{ vary = { jump = { 50, 530, 540, 550, 560 } } }:run{ file = path "more", progress = false }
io.stderr = quiet
holds(told, { "case 2", "warning: jump = 530 cycles is past the stability limit" },
  "a jump above the stability limit is reported")
is(told:find("case 1", 1, true), nil, "only the cases with warnings are reported")
holds(table.concat(errors), "4 cases (2, 3, 4, 5) have warnings", "many warnings are printed in one line")
is(#errors, 1, "many warnings are printed at once")
ripples = study.open(path "ripples"):cases()
is(ripples[1].warning, nil, "a case without warnings")
holds(ripples[2].warning, "ripples will grow", "the run file contains the warning of a case")
holds(tostring(ripples[2]), "ripples will grow", "print(case) shows the warning")
holds(study.open(path "ripples"):table(), { "done [1]", "[1] warning: jump = 530 cycles is past" },
  "the table shows the warning")
holds(study.open(path "ripples"):table(), "half_w", "a table with warnings has all columns")

-- Tests that loadings and series are stored like other settings.
local blocks = study{ snapshots = 0, base = { geometry = "frozen", jump = 50, model = coarse.model,
  loading = { { x = { -0.05, 0.05, -0.05 }, load = { 80, 100, 80 }, cycles = 200 },
    { x = { -0.1, 0, 0.1, 0, -0.1 }, load = { 90, 90, 90, 90, 90 }, cycles = 100 } } },
  vary = { k = { { distance = { 0, 40 }, value = { 2e-8, 1e-8 } }, { distance = { 0, 40 },
    value = { 1e-8, 2e-8 } } } } }:run{ file = path "blocks", progress = false }
is(#blocks.failed, 0, "a study with blocks of loading and series of k")
local block_run = wear(blocks:cases()[2].settings)
block_run:run()
is(blocks:cases()[2].depth.plate, block_run.depth.plate,
  "a case with blocks of loading has the bits of a single run")

-- --- shares ------------------------------------------------------------------------------------
for i = 1, 3 do
  new_study():run{ workers = 1, file = path("share" .. i), shard = i .. "/3", progress = false }
end
local share = study.open(path "share2")
is(share:cases()[2].status .. share:cases()[1].status, "donewaiting", "a shard computes only its cases")
fails(function() new_study():run{ shard = "4/3", file = path "x" } end, "shard", "shard 4 of 3")
local merged = study.merge(path "share1", path "share2", path "share3", { file = path "merged" })
is(content(merged), content(one), "merged shards have the bits of the whole study")
fails(function() study.merge(path "share1", path "share3", { file = path "gap" }) end,
  { "1 cases", "not finished in any of the files", "2" }, "a merge with a missing case names the case")
is(io.open(path "gap"), nil, "an incomplete merge writes no file")
merged = study.merge(path "share1", path "merged", path "share1", { file = path "twice" })
is(content(merged), content(one), "a case in two shards is merged once")
fails(function() study.merge(path "share1", path "bad", { file = path "gap" }) end,
  "different studies", "a merge of shards of different studies")

-- --- a file left by a program that was killed at its start --------------------------------------
local function begun()
  os.remove(path "begun")
  require "archard.store".open(path "begun", "create"):close()
  return path "begun"
end
local empty = study.open(begun())
is(#empty:cases(), 0, "an empty file is a study without cases")
holds(empty, "0 cases", "print of a study without cases")
fails(function() empty:run() end, { "begun has no cases", "create the study again" }, "a study without cases is not run")
fails(function() study.merge(begun(), { file = path "gap" }) end, "begun: the file has no cases", "a study without cases is not merged")
is(content(study.merge(path "share1", begun(), path "merged", { file = path "twice" })), content(one),
  "a file without cases adds nothing to a merge")
is(content(study.merge(path "merged", { file = begun() })), content(one), "an empty file is replaced by a merged study")
is(content(new_study():run{ workers = 1, file = begun(), progress = false }), content(one), "an empty file is continued by a study")

-- --- tables ------------------------------------------------------------------------------------
holds(one:table(), { "alpha", "stroke", "p_center", "[MPa]", "done" }, "table")
local csv = one:table{ format = "csv" }
is(select(2, csv:gsub("\n", "\n")), 4, "CSV has a header and a line for each case")
holds(csv, "," .. require "archard.files".number(case.p_center) .. ",", "CSV shows numbers with all digits")
is(tonumber(require "archard.files".number(case.p_center)), case.p_center,
  "a number in CSV is read back exactly")
holds(one:table{ format = "markdown" }, "| --: |", "Markdown")
is(export.csv(one, path "exported"), path "exported.csv", "export.csv of a study returns its file")
is(io.open(path "exported.csv"):read "a", csv .. "\n", "export.csv writes the table")
local said, usual = {}, io.stderr
io.stderr = { write = function(_, ...) said[#said + 1] = table.concat{ ... } end }
is(one:table{ file = path "table.md" }, path "table.md", "table{ file = } returns the file name")
io.stderr = usual
is(table.concat(said), "archard: study:table: wrote " .. path "table.md" .. "\n", "the written table is reported")
holds(assert(io.open(path "table.md")):read("a"), "| --: |", "the file name extension selects the format")
fails(function() one:table{ format = "html" } end, '"markdown"', "an unknown format of a table")

-- --- figures -----------------------------------------------------------------------------------
local drawn = one:figures{ dir = path "figures" }
is(drawn[1].caption:find "cases", nil, "the caption of a picture of all cases has no note")
local nine = small{ vary = { alpha = { 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9 } }, snapshots = 0 }
  :run{ file = path "nine", progress = false }
drawn = nine:figures{ dir = path "figures" }
for _, each in ipairs(drawn) do
  holds(each.caption, "8 of 9 cases", "the caption states how many cases are shown, " .. each.name)
  holds(assert(io.open(each.files[1])):read("a"), "8 of 9 cases", "the picture shows the share of cases")
end

-- --- run files with one run --------------------------------------------------------------------
local w = wear{ geometry = "frozen", increments = 8, distance = 220, model = coarse.model }
w:step(5)
is(w:save(path "wear"), w, "wear:save returns the run")
local opened = wear.open(path "wear")
is(opened.update, 5, "wear.open of a run file")
w:run()
opened:run()
is(opened.p_center, w.p_center, "an opened run continues with identical bits")
opened:save(path "wear")
is(wear.open(path "wear").distance, 220, "a run can be saved again to its file")
local function falling(state) return 1e-8 / (1 + state.distance / 500) end
local f = wear{ geometry = "frozen", increments = 8, distance = 220, model = coarse.model, k = falling }
f:step(3)
f:save(path "function")
fails(function() wear.open(path "function") end, { "'k'", "a function, as when the run was saved" },
  "a function must be given again")
fails(function() wear.open(path "function", { k = falling, alpha = falling }) end, "'alpha'",
  "a function for another field")
fails(function() wear.open(path "function", { kay = falling }) end, "'kay'", "an unknown function given to wear.open")
local g = wear.open(path "function", { k = falling })
f:run()
g:run()
is(g.depth.plate, f.depth.plate, "a run with its function continues with identical bits")
fails(function() wear.open(path "wear", { k = falling }) end, "no value",
  "a function for a run without functions")
fails(function() small{ vary = { k = { falling } } }:run{ file = path "x" } end, { "k", "function" },
  "a function in a study")
fails(function() w:save(path "one") end, "not replaced", "wear:save to the file of a study")
fails(function() w:save(path "letter") end, "not a run file", "another file is not replaced")
fails(function() w:save "/no/such/folder/w" end, { "/no/such/folder/w", "No such file" },
  "wear:save to a missing folder")
fails(function() wear.open(path "absent") end, "absent", "wear.open of a missing file")
fails(function() study.open(path "wear") end, "kind study", "study.open of a run file")

os.execute("rm -r " .. folder)

-- Tests that tables have the units of the varied fields.
local with_units = study{ base = { distance = 44 }, vary = { k = { 1e-8, 2e-8 }, ["model.lower.E"] = { 1e5, 2e5 }, alpha = { 0.2, 0.3 },
  law = { "archard", "power" } } }
local head = with_units:table{ format = "csv" }:match "^[^\n]*"
holds(head, { ",k [mm2/N],", ".E [MPa],", ",law,", ",alpha," }, "units of the varied fields")

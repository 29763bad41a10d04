-- Tests wear{}: definition, stepping, running, records, measures, clones, failures during a run.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

-- Tests that the fields of a wear object return its definition.
local automatic = wear{}
for name, value in pairs{ k = 1e-8, alpha = 0.5, load = 100, stroke = 0.11, total_distance = 1320,
  jump = "auto", increments = "auto", strokes = 2, procedure = "SP", scheme = "explicit", slip = "rigid",
  rule = "trapezoid", geometry = "moving", distance = 0, cycle = 0, update = 0, done = false } do
  is(automatic[name], value, "wear{}." .. name)
end
local w = wear{ jump = 100 }
near(w.cycles, 6000, 1e-12, "cycles of the whole distance")
near(w.p_center, hertz{}.p_max, 5e-3, "unworn: Hertz' pressure")
is(w.volume.total, 0, "unworn: no volume")
ok(w.depth_partition ~= w.depth_partition, "unworn: no alpha-tilde")
fails(function() w.alpha = 0.3 end, "read-only", "fields are not set")
holds(tostring(w), { "stroke 0.11 mm", "cycle 0 of 6000", "none yet" }, "print(wear) at the start")

local other = wear{ alpha = 1, slip = "total", rule = "simple", geometry = "frozen", increments = 20,
  jump = 40, k = 2e-8, load = 50, stroke = 0.2, distance = 100, refresh = 0.1 }
for name, value in pairs{ k = 2e-8, alpha = 1, load = 50, stroke = 0.2, total_distance = 100, jump = 40,
  increments = 20, procedure = "NSP", slip = "total", rule = "simple", geometry = "frozen",
  refresh = 0.1 } do
  is(other[name], value, "as defined: " .. name)
end
near(wear{ cycles = 500 }.total_distance, 110, 1e-12, "cycles instead of distance")
near(wear{ cycles = 10, stroke = 20 }.total_distance, 200, 1e-12, "one stroke a cycle at 2R")
is(wear{ stroke = 20 }.procedure, "NSP", "2R: the plate stays flat")

-- Tests the results and the printed record of steps.
local record = w:step()
is(w.update, 1, "a step is one update")
is(w.cycle, 100, "of jump cycles")
near(w.distance, 22, 1e-12, "distance of the steps")
near(w.volume.total, 1e-8 * 100 * 22, 1e-9, "volume = k L d")
near(w.volume.cylinder, w.volume.plate, 1e-9, "alpha = 0.5 shares it evenly")
is(record.p_center, w.p_center, "the record is the state")
is(record.depth_cylinder, w.depth.cylinder, "depths too")
local line = tostring(record)
holds(line, { "cycle", "22.0 mm", "MPa", "um", "mm3" }, "a record prints")
ok(not line:find("\n") and #line <= 80, "an error of one line with 80 columns")
is(#line, #tostring(w:step()), "lines align")
local _, lines = tostring(w:step(10)):gsub("\n", "\n")
is(lines, 11, "ten steps print a table")
_, lines = tostring(wear{ jump = 10, increments = 4, geometry = "frozen" }:step(100)):gsub("\n", "\n")
is(lines, 21, "a hundred print twenty lines of it")
is(w.update, 12, "twelve updates in all")
fails(function() w:step(0) end, "wear:step: field 'n': expected a whole number in", "no step at all")
fails(function() w:step(1.5) end, "whole number", "half a step")
fails(function() w:step("x") end, [[got "x"]], "steps by name")
fails(function() w.step() end, { "wear:step", "called with a colon" }, "w.step()")
fails(function() w.step(material{}) end, { "expected a wear object", "material" }, "another object")

-- Tests the columns of the history and its first and last row.
local history = w.history
is(#history.distance, 13, "a row a step, and one before")
for _, name in ipairs{ "update", "cycle", "distance", "jump", "k", "alpha", "load", "travel", "p_center", "p_max",
  "p_peak", "half_width", "depth_cylinder", "error", "depth_plate", "volume_cylinder", "volume_plate", "load_distance", "depth_partition",
  "solutions" } do
  is(#history[name], 13, "history." .. name)
end
is(history.p_center[13], w.p_center, "its end is the state")
is(history.distance[1], 0, "its beginning the start")

-- Tests Eq. (15) of the reference paper: the volume of each body is the body's k times the integral of p ds
-- dA, the load integrated over the sliding path, for every motion, step and procedure.
for name, case in pairs{ explicit = {}, by_half = { rule = "simple" },
  implicit = { scheme = "implicit", tolerance = 1e-3 }, over_the_plate = { stroke = 20, increments = 10 },
  increments = { update = "increment", geometry = "frozen" },
  moving_increments = { update = "increment", k = 1e-6, jump = 1, distance = 22, increments = 20 },
  thick = { model = { thickness = 3 }, load = 300 },
  loading = { distance = false, loading = { increments = 20, cycles = 40,
    x = function(t) return 0.055 * math.sin(2 * math.pi * t) end,
    load = function(t) return 100 + 50 * math.cos(2 * math.pi * t) end } },
  once = { distance = false, k = 1e-6, loading = { x = { 0, 0.05, -0.05, 0.1 }, t = { 0, 0.3, 0.6, 1 }, load = 80,
    increments = 20, periodic = false } } } do
  local def = { k = 1e-8, alpha = 0.25, jump = 10, distance = 40 }
  for key, value in pairs(case) do def[key] = value or nil end
  local run = wear(def)
  run:run()
  local sum = run.load_distance
  if not run.loading then near(sum / (run.load * run.distance), 1, 1e-12, name .. ": the load over the way") end
  near(run.volume.cylinder / (0.25 * def.k * sum), 1, 1e-12, name .. ": volume of the cylinder over k_c times it")
  near(run.volume.plate / (0.75 * def.k * sum), 1, 1e-12, name .. ": volume of the plate over k_p times it")
  is(run.history.load_distance[#run.history.load_distance], sum, name .. ": in the history")
end

-- Tests that the largest pressure during the cycle equals the largest pressure of contacts along the path on
-- the surfaces of the same row.
do
  local run = wear{ increments = 8, jump = 50 }
  is(run.p_peak, run.p_max, "p_peak before any update")
  run:step(20)
  local largest = 0
  for i = 0, 4 do
    largest = math.max(largest, contact{ model = run.model, worn = run, x = 0.11 * (i / 4 - 0.5) }.p_max)
  end
  near(run.p_peak, largest, 1e-9, "p_peak: the largest pressure of the cycle")
  ok(run.p_peak > 1.1 * run.p_max, "the peak pressure exceeds that at x = 0")
  local alone = wear{ increments = 8, jump = 50 }
  alone:step(19)
  local copy = alone:clone()
  alone:step()
  copy:step()
  ok(alone.p_peak == run.p_peak and copy.p_peak == run.p_peak and copy.solutions == run.solutions,
    "by single steps and in a copy too, with as many solutions counted")
  local loaded = wear{ alpha = 0.3, loading = { x = { 0, 0.2, 0 }, load = { 50, 200, 50 } }, jump = 10, distance = 300 }:run()
  local cycle, most = loaded.loading[1], 0
  for i, x in ipairs(cycle.x) do
    most = math.max(most, contact{ model = loaded.model, worn = loaded, x = x, load = cycle.load[i] }.p_max)
  end
  near(loaded.p_peak, most, 1e-9, "p_peak under a loading")
  ok(loaded.p_peak < 0.9 * loaded.p_max, "the peak pressure under a varying load")
  local implicit = wear{ scheme = "implicit", jump = 200, increments = 8, order = 1 }
  implicit:step(4)
  local after = contact{ model = implicit.model, worn = implicit, x = -0.055 }.p_max
  near(implicit.p_peak, after, 5e-3, "an implicit step's is that of its end")
  local still = wear{ alpha = 0, stroke = 20, jump = 1 }
  still:step()
  is(still.p_peak, still.p_max, "nothing but Hertz' contact")
end

-- Tests that profiles, pressures and measures of a run agree with its record.
local profile = w:profile("plate")
is(#profile.x, #profile.h, "profile: depths")
is(#profile.x, #profile.y, "profile: heights")
near(math.max(table.unpack(profile.h)), w.depth.plate, 1e-15, "the largest is the depth")
near(w.vector_depth.plate, w.depth.plate, 1e-3, "vector and scalar sum agree")
local pressure = w:pressure("cylinder")
near(pressure.p[(#pressure.p + 1) // 2], w.p_center, 1e-12, "pressure at the centre")
is(w:contact().p_max, w.p_max, "the contact behind it")
is(w:contact().half_width, w.half_width, "its width")
local combined = w:combined()
near(combined.h[(#combined.h + 1) // 2], w.depth.cylinder + w.depth.plate, 1e-9, "Eq. (31) at the centre")
local partition = w:local_partition()
near(partition.value[(#partition.x + 1) // 2], w.depth_partition, 1e-6, "Eq. (30) at the centre")
is(#partition.x, #partition.value, "Eq. (30): as many values as x")
ok(#partition.x < #combined.x, "partition only where something is worn")
ok(w:roughness("cylinder") < 1e-2, "smooth at jump = 100")
local stability = w:stability()
near(stability.jump_limit, 2 / stability.eigenvalue, 1e-12, "stability limit")
ok(stability.jump_limit > 100, "jump = 100 is below the stability limit")

-- Tests a run to its end, a clone of the run, and the end conditions.
local bits = w:clone()
is(bits.p_center, w.p_center, "a clone is the same state")
bits:step()
is(w.update, 12, "a clone is independent")
is(w:run(), w, "run returns the object")
bits:run()
is(bits.p_center, w.p_center, "both go on to the same bits")
near(w.distance, 1320, 1e-12, "run ends at the distance")
is(w.done, true, "done")
near(w.volume.total, 1.32e-3, 1e-9, "reference case: volume")
near(w.depth.cylinder, 1.8269e-3, 3e-3, "reference case: cylinder depth")
near(w.depth.plate, 1.6945e-3, 3e-3, "reference case: plate depth")
near(w.p_center, 188.0, 1e-2, "reference case: centre pressure")
is(w:step().update, w.update, "a step at the end does nothing")
is(w.update, 60, "nothing at all")
near(w:run{ distance = 1340 }.distance, 1340, 1e-12, "further than defined")
near(w.total_distance, 1340, 1e-12, "a new total distance")
fails(function() w:run{ distance = 10 } end, { "wear:run", "already at 1340 mm" }, "backwards")
near(wear{}:run{ cycles = 250 }.cycle, 250, 1e-12, "run by cycles, a shorter last step")
fails(function() w:run{ cycles = 1, distance = 1 } end, "got both", "run by both")
fails(function() w:run{ progres = print } end, "did you mean 'progress'?", "misspelt option")
fails(function() w:run{ progress = 3 } end, "expected a function", "progress is a function")

-- Tests that the progress function is called after each step and can end the run.
local seen = {}
local p = wear{ increments = 10 }
p:run{ progress = function(run) seen[#seen + 1] = run.update return run.update == 3 end }
is(#seen, 3, "progress is called after each step until it returns true")
is(p.update, 3, "the run after a failed function")
local err = fails(function() p:run{ progress = function(run) error("no " .. run.update) end } end,
  { "wear:run: progress failed", "no 4" }, "an error in progress")
is(err.code, "CALLBACK", "its code")
is(p.update, 4, "the step before it stays")
err = fails(function() p:run{ progress = function() error{ answer = 42 } end } end, "progress failed",
  "an error that is a table")
is(err.cause.answer, 42, "is handed on as the cause")
fails(function() p:run{ progress = function(run) run:close() end } end, "a wear object cannot be closed while it is running",
  "closed from within")
fails(function() p:run{ progress = function(run) run:step() end } end, "already running",
  "stepped from within")
ok(pcall(p.step, p), "afterwards it runs on")
is(coroutine.wrap(function() return wear{ increments = 4 }:run{ distance = 100 }.distance end)(), 100,
  "a run within a coroutine")

-- Tests that a failure leaves the run unchanged.
local deep = wear{ k = 1e-6, jump = 1000, increments = 4, distance = 1e6,
  model = model{ mesh = { zone = { cylinder = 1, plate = 1.2 } } } }
local before, state
err = nil
for _ = 1, 50 do
  before, state = deep:profile("cylinder"), tostring(deep)
  local done, problem = pcall(deep.step, deep)
  if not done then err = problem break end
end
if ok(err ~= nil, "a run that must fail fails") then
  is(err.where, "wear:step", "error.where")
  is(err.step, deep.update + 1, "error.step: the update it failed in")
  is(tostring(deep), state, "the state is that of before the step")
  local after, same = deep:profile("cylinder"), true
  for i, h in ipairs(before.h) do same = same and h == after.h[i] end
  ok(same, "to the same bits")
end

-- Tests that schemes, steps, laws and series are passed to the engine.
local implicit = wear{ scheme = "implicit", tolerance = 1e-3 }
is(implicit.tolerance, 1e-3, "tolerance can be read back")
holds(tostring(implicit), { "implicit", "tolerance 0.001" }, "print of an implicit run")
implicit:run()
near(implicit.depth.cylinder, w.depth.cylinder, 2e-2, "implicit: the depth of the explicit run, nearly")
ok(implicit.update < w.update, "implicit: in fewer steps")
local auto = wear{ jump = "auto" }
is(auto.jump, "auto", [[jump = "auto" can be read back]])
auto:run()
near(auto.volume.total, 1.32e-3, 1e-9, "auto: the volume")
ok(auto.history.jump[2] > 0 and auto.history.jump[2] ~= auto.history.jump[10], "auto: the jumps vary")
local ramp = wear{ k = { distance = { 0, 1320 }, value = { 0, 2e-8 } }, alpha = { distance = { 0 }, value = { 1 } } }
is(ramp.k.value[2], 2e-8, "a series can be read back")
ramp:run()
near(ramp.volume.total, 1.32e-3, 1e-9, "a ramp of k gives the wear of its mean")
is(ramp.volume.plate, 0, "alpha = 1 by a series: no wear of the plate")
local law = wear{ law = "threshold", law_pressure = 1e4, distance = 22 }:run()
is(law.volume.total, 0, "no wear under the threshold pressure")
is(law.law, "threshold", "law can be read back")
is(wear{ update = "increment", jump = 1, increments = 4, distance = 0.22 }.update_at, "increment",
  "quasi-continuous can be read back")

-- Tests runs that start from worn shapes.
local start = wear{}:run{ distance = 220 }
local onward = wear{ worn = start }
is(onward.model, start.model, "worn: the same model")
is(onward.distance, 0, "worn: a new run")
is(onward.p_center, start.p_center, "worn: the same shape")
near(wear{ worn = start, alpha = 1, k = 0 }:step().p_center, start.p_center, 1e-9, "k = 0 wears nothing")
local resampled = wear{ worn = { cylinder = start:profile("cylinder"), plate = start:profile("plate") } }
near(resampled.p_center, start.p_center, 2e-3, "worn: from profiles")
ok(wear{ worn = { plate = function(x) return math.max(0, 1e-3 - x * x / 20) end } }.p_center
  < start.p_center * 1.5, "worn: from a function")
local wider = wear{ worn = start, stroke = 0.9 }
ok(wider.model.mesh.zone.plate > start.model.mesh.zone.plate, "worn: a wider zone where it is needed")
near(wider.p_center, start.p_center, 5e-3, "a worn start on another mesh")
near(wear{ model = model{}, stroke = 3 }.model.mesh.zone.plate, wear{ stroke = 3 }.model.mesh.zone.plate, 1e-12, "a model object gets wider zones")

-- Tests that a step of a finished run gives a warning that the step has no effect.
do
  local warnings = require "archard.warnings"
  local run = wear{ increments = 8, jump = 10, distance = 2.2 }
  run:step()
  warnings.keep()
  warnings.take()
  is(run:step(3).update, 1, "a step at the end of the distance")
  holds(warnings.take(), { "wear:step: nothing to do", "its distance of 2.2 mm", "w:set{ distance" }, "a step of a finished run gives a warning")
  run:set{ distance = 4.4 }
  warnings.take()
  is(run:step(3).update, 2, "fewer steps than requested at the end")
  ok(not (warnings.take() or ""):find "nothing to do", "steps of a finished run warn once")
end

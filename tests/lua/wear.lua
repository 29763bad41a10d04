-- Tests wear{}: definition, stepping, running, records, measures, clones, failures during a run.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

-- Tests that the fields of a wear object return its definition.
local automatic = wear{}
for name, value in pairs{ k = 1e-8, alpha = 0.5, load = 100, stroke = 0.11, total_distance = 1320,
  jump = "auto", increments = "auto", strokes = 2, procedure = "SP", scheme = "implicit", tolerance = 1e-3, slip = "rigid",
  rule = "trapezoid", geometry = "moving", distance = 0, cycle = 0, update = 0, done = false } do
  is(automatic[name], value, "wear{}." .. name)
end
local w = wear{ jump = 100 }
near(w.cycles, 6000, 1e-12, "the number of cycles in the whole distance")
near(w.p_center, hertz{}.p_max, 5e-3, "the unworn pressure agrees with Hertz theory")
is(w.volume.total, 0, "the unworn volume is zero")
ok(w.depth_partition ~= w.depth_partition, "the unworn depth partition is NaN")
fails(function() w.alpha = 0.3 end, "read-only", "assignment to a field of a wear object")
holds(tostring(w), { "stroke 0.11 mm", "cycle 0 of 6000", "none yet" }, "print(wear) at the start")

local other = wear{ alpha = 1, slip = "total", rule = "simple", geometry = "frozen", increments = 20,
  jump = 40, k = 2e-8, load = 50, stroke = 0.2, distance = 100, refresh = 0.1 }
for name, value in pairs{ k = 2e-8, alpha = 1, load = 50, stroke = 0.2, total_distance = 100, jump = 40,
  increments = 20, procedure = "NSP", slip = "total", rule = "simple", geometry = "frozen",
  refresh = 0.1 } do
  is(other[name], value, "the definition is read back: " .. name)
end
near(wear{ cycles = 500 }.total_distance, 110, 1e-12, "the distance of a number of cycles")
near(wear{ cycles = 10, stroke = 20 }.total_distance, 200, 1e-12,
  "a cycle over the whole plate has one stroke")
is(wear{ stroke = 20 }.procedure, "NSP", "the plate stays flat with a stroke of 2R")
ok(tostring(wear{ stroke = 20 }):find("stroke 20 mm in one direction", 1, true), "print(w) of a stroke of 2R")

-- Tests the results and the printed record of steps.
local record = w:step()
is(w.update, 1, "a step is one update")
is(w.cycle, 100, "a step computes jump cycles")
near(w.distance, 22, 1e-12, "distance of the steps")
near(w.volume.total, 1e-8 * 100 * 22, 1e-9, "the volume is k L d")
near(w.volume.cylinder, w.volume.plate, 1e-9, "with alpha = 0.5 both volumes are equal")
is(record.p_center, w.p_center, "the pressure of the record is the pressure of the run")
is(record.depth_cylinder, w.depth.cylinder, "the depth of the record is the depth of the run")
local line = tostring(record)
holds(line, { "cycle", "22.0 mm", "MPa", "um", "mm3" }, "print of a record")
ok(not line:find("\n") and #line <= 80, "a record is printed on one line of at most 80 characters")
is(#line, #tostring(w:step()), "the printed records have the same length")
local _, lines = tostring(w:step(10)):gsub("\n", "\n")
is(lines, 11, "ten steps are printed as a table")
_, lines = tostring(wear{ jump = 10, increments = 4, geometry = "frozen" }:step(100)):gsub("\n", "\n")
is(lines, 21, "a hundred steps are printed on twenty lines")
is(w.update, 12, "number of updates")
fails(function() w:step(0) end, "wear:step: field 'n': expected a whole number in",
  "a number of steps of zero")
fails(function() w:step(1.5) end, "whole number", "half a step")
fails(function() w:step("x") end, [[got "x"]], "a text as the number of steps")
fails(function() w.step() end, { "wear:step", "called with a colon" }, "w.step() without an object")
fails(function() w.step(material{}) end, { "expected a wear object", "material" },
  "w.step() with another object")

-- Tests the columns of the history and its first and last row.
local history = w.history
is(#history.distance, 13, "the history has a row for each step and for the start")
for _, name in ipairs{ "update", "cycle", "distance", "jump", "k", "alpha", "load", "travel", "p_center", "p_max",
  "p_peak", "half_width", "depth_cylinder", "error", "depth_plate", "volume_cylinder", "volume_plate", "load_distance", "depth_partition",
  "solutions" } do
  is(#history[name], 13, "history." .. name)
end
is(history.p_center[13], w.p_center, "the last row is the present state")
is(history.distance[1], 0, "the first row is at distance 0")

-- Tests Eq. (15) of the reference paper for every motion, step and procedure: the volume of each body is the
-- body's k times the integral of the load over the sliding path.
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
  if not run.loading then near(sum / (run.load * run.distance), 1, 1e-12, name ..
    ": the load integrated over the distance") end
  near(run.volume.cylinder / (0.25 * def.k * sum), 1, 1e-12, name ..
    ": volume of the cylinder over k_c times the integral")
  near(run.volume.plate / (0.75 * def.k * sum), 1, 1e-12, name ..
    ": volume of the plate over k_p times the integral")
  is(run.history.load_distance[#run.history.load_distance], sum, name .. ": the integral in the history")
end

-- Tests the largest pressure during a cycle: it equals the largest pressure of separate contacts at positions
-- along the path, with the same worn surfaces.
do
  local run = wear{ increments = 8, jump = 50 }
  is(run.p_peak, run.p_max, "p_peak before the first update is p_max")
  run:step(20)
  local largest = 0
  for i = 0, 4 do
    largest = math.max(largest, contact{ model = run.model, worn = run, x = 0.11 * (i / 4 - 0.5) }.p_max)
  end
  near(run.p_peak, largest, 1e-9, "p_peak is the largest pressure along the path")
  ok(run.p_peak > 1.1 * run.p_max, "the peak pressure exceeds that at x = 0")
  local alone = wear{ increments = 8, jump = 50 }
  alone:step(19)
  local copy = alone:clone()
  alone:step()
  copy:step()
  ok(alone.p_peak == run.p_peak and copy.p_peak == run.p_peak and copy.solutions == run.solutions,
    "single steps and a copy give the same p_peak and number of solutions")
  local loaded = wear{ alpha = 0.3, loading = { x = { 0, 0.2, 0 }, load = { 50, 200, 50 } }, jump = 10, distance = 300 }:run()
  local cycle, most = loaded.loading[1], 0
  for i, x in ipairs(cycle.x) do
    most = math.max(most, contact{ model = loaded.model, worn = loaded, x = x, load = cycle.load[i] }.p_max)
  end
  near(loaded.p_peak, most, 1e-9, "p_peak of a loading")
  ok(loaded.p_peak < 0.9 * loaded.p_max, "the peak pressure under a varying load")
  local implicit = wear{ scheme = "implicit", jump = 200, increments = 8, order = 1 }
  implicit:step(4)
  local after = contact{ model = implicit.model, worn = implicit, x = -0.055 }.p_max
  near(implicit.p_peak, after, 5e-3, "p_peak of an implicit step is computed at the end of the step")
  local still = wear{ alpha = 0, stroke = 20, jump = 1 }
  still:step()
  is(still.p_peak, still.p_max, "p_peak with the Hertz pressure only")
end

-- Tests that profiles, pressures and measures of a run agree with its record.
local profile = w:profile("plate")
is(#profile.x, #profile.h, "the profile has a depth for each x")
is(#profile.x, #profile.y, "the profile has a height for each x")
near(math.max(table.unpack(profile.h)), w.depth.plate, 1e-15,
  "the largest depth of the profile is the depth of the run")
near(w.vector_depth.plate, w.depth.plate, 1e-3, "vector and scalar depths agree")
local pressure = w:pressure("cylinder")
near(pressure.p[(#pressure.p + 1) // 2], w.p_center, 1e-12, "pressure at the centre")
is(w:contact().p_max, w.p_max, "p_max of the contact of a run")
is(w:contact().half_width, w.half_width, "half width of the contact of a run")
local combined = w:combined()
near(combined.h[(#combined.h + 1) // 2], w.depth.cylinder + w.depth.plate, 1e-9,
  "the combined profile at the centre, Eq. (31)")
local partition = w:local_partition()
near(partition.value[(#partition.x + 1) // 2], w.depth_partition, 1e-6,
  "the local partition at the centre, Eq. (30)")
is(#partition.x, #partition.value, "the local partition has a value for each x")
ok(#partition.x < #combined.x, "the local partition covers the worn part only")
ok(w:roughness("cylinder") < 1e-2, "the surface is smooth at jump = 100")
local stability = w:stability()
near(stability.jump_limit, 2 / stability.eigenvalue, 1e-12, "stability limit")
ok(stability.jump_limit > 100, "jump = 100 is below the stability limit")

-- Tests a run to its end, a clone of the run, and the end conditions.
local bits = w:clone()
is(bits.p_center, w.p_center, "a clone has the same state")
bits:step()
is(w.update, 12, "a step of the clone does not change the run")
is(w:run(), w, "w:run returns the run")
bits:run()
is(bits.p_center, w.p_center, "the run and its clone end with identical bits")
near(w.distance, 1320, 1e-12, "run ends at the distance")
is(w.done, true, "the run is done")
near(w.volume.total, 1.32e-3, 1e-9, "reference case: volume")
near(w.depth.cylinder, 1.8269e-3, 3e-3, "reference case: cylinder depth")
near(w.depth.plate, 1.6945e-3, 3e-3, "reference case: plate depth")
near(w.p_center, 188.0, 1e-2, "reference case: centre pressure")
is(w:step().update, w.update, "a step at the end has no effect")
is(w.update, 60, "number of updates at the end")
near(w:run{ distance = 1340 }.distance, 1340, 1e-12, "w:run to a distance beyond the end")
near(w.total_distance, 1340, 1e-12, "a new total distance")
fails(function() w:run{ distance = 10 } end, { "wear:run", "already at 1340 mm" },
  "w:run to a distance already passed")
near(wear{}:run{ cycles = 250 }.cycle, 250, 1e-12, "w:run to a number of cycles shortens the last step")
fails(function() w:run{ cycles = 1, distance = 1 } end, "got both", "w:run with cycles and distance")
fails(function() w:run{ progres = print } end, "did you mean 'progress'?", "a misspelt option of w:run")
fails(function() w:run{ progress = 3 } end, "expected a function", "a number as the progress function")

-- Tests that the progress function is called after each step and can end the run.
local seen = {}
local p = wear{ increments = 10 }
p:run{ progress = function(run) seen[#seen + 1] = run.update return run.update == 3 end }
is(#seen, 3, "progress is called after each step until it returns true")
is(p.update, 3, "the run is at the step at which progress returned true")
local err = fails(function() p:run{ progress = function(run) error("no " .. run.update) end } end,
  { "wear:run: progress failed", "no 4" }, "an error in progress")
is(err.code, "CALLBACK", "error code of a failed progress function")
is(p.update, 4, "the step before the error is complete")
err = fails(function() p:run{ progress = function() error{ answer = 42 } end } end, "progress failed",
  "a progress function that raises a table")
is(err.cause.answer, 42, "the raised table is the cause of the error")
fails(function() p:run{ progress = function(run) run:close() end } end, "a wear object cannot be closed while it is running",
  "a run closed by its progress function")
fails(function() p:run{ progress = function(run) run:step() end } end, "already running",
  "a run stepped by its progress function")
ok(pcall(p.step, p), "the run continues afterwards")
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
  is(err.step, deep.update + 1, "error.step is the failed update")
  is(tostring(deep), state, "the failed step does not change the run")
  local after, same = deep:profile("cylinder"), true
  for i, h in ipairs(before.h) do same = same and h == after.h[i] end
  ok(same, "the failed step does not change the profile")
end

-- Tests that schemes, steps, laws and series are passed to the engine.
local implicit = wear{ scheme = "implicit", tolerance = 1e-3 }
is(implicit.tolerance, 1e-3, "the tolerance is read back")
holds(tostring(implicit), { "implicit", "tolerance 0.001" }, "print of an implicit run")
implicit:run()
near(implicit.depth.cylinder, w.depth.cylinder, 2e-2,
  "an implicit run has nearly the depth of the explicit run")
ok(implicit.update < w.update, "an implicit run has fewer steps")
local auto = wear{ jump = "auto" }
is(auto.jump, "auto", [[jump = "auto" is read back]])
auto:run()
near(auto.volume.total, 1.32e-3, 1e-9, "volume with automatic jumps")
ok(auto.history.jump[2] > 0 and auto.history.jump[2] ~= auto.history.jump[10], "automatic jumps vary")

-- Tests the steps of runs without their own: implicit, except where explicit steps are better.
local function of_steps(w) return ("%s %g %s"):format(w.scheme, w.tolerance or 0, (tostring(w.jump):gsub("%.0$", ""))) end
local controlled, staged = "implicit 0.001 auto", "explicit 0 auto"
for label, case in pairs{ ["jump = auto"] = { { jump = "auto" }, controlled }, ["a tolerance"] = { { tolerance = 1e-4 }, "implicit 0.0001 auto" },
  friction = { { friction = 0.5 }, staged }, ["elastic slip"] = { { slip = "total" }, staged }, ["a law that jumps"] = { { law = "threshold" }, staged },
  ["a law that jumps, in 3-D"] = { { law = "threshold", load = 10, model = { geometry = "3-D", upper = body.ball{ radius = 10 }, lower = body.block{} } }, staged },
  ["a power law"] = { { law = "power" }, controlled }, ["local factors"] = { { local_factor = function() return 1 end }, staged },
  ["updates in every increment"] = { { update = "increment" }, staged },
  ["a history"] = { { loading = { x = { 0, 0.1 }, load = 100, periodic = false } }, staged },
  ["a cycle"] = { { loading = { x = { 0, 0.1, 0 }, load = 100 } }, controlled }, ["a jump"] = { { jump = 50 }, "explicit 0 50" },
  ["friction and a tolerance"] = { { friction = 0.5, tolerance = 1e-3 }, controlled } } do
  is(of_steps(wear(case[1])), case[2], "steps with " .. label)
end
-- w:set keeps the scheme, unless a jump or a law needs another one.
local steps = wear{}
for _, change in ipairs{ { { slip = "total" }, controlled }, { { law = "threshold" }, staged }, { { law = "archard" }, staged },
  { { jump = 20 }, "explicit 0 20" }, { { load = 50 }, "explicit 0 20" }, { { slip = "rigid", jump = "auto" }, controlled },
  { { jump = 20 }, "implicit 0 20" }, { { jump = "auto", scheme = "implicit" }, controlled }, { { scheme = "explicit" }, staged },
  { { tolerance = 1e-4, scheme = "implicit" }, "implicit 0.0001 auto" }, { { load = 60 }, "implicit 0.0001 auto" } } do
  steps:set(change[1])
  is(of_steps(steps), change[2], "steps after a change of " .. next(change[1]))
end

local ramp = wear{ k = { distance = { 0, 1320 }, value = { 0, 2e-8 } }, alpha = { distance = { 0 }, value = { 1 } } }
is(ramp.k.value[2], 2e-8, "a series is read back")
ramp:run()
near(ramp.volume.total, 1.32e-3, 1e-9, "a linear series of k gives the volume of its mean")
is(ramp.volume.plate, 0, "alpha = 1 as a series: the plate does not wear")
local law = wear{ law = "threshold", law_pressure = 1e4, distance = 22 }:run()
is(law.volume.total, 0, "no wear below the threshold pressure")
is(law.law, "threshold", "the law is read back")
is(wear{ update = "increment", jump = 1, increments = 4, distance = 0.22 }.update_at, "increment",
  "updates within a cycle are read back")

-- Tests runs that start from worn shapes.
local start = wear{}:run{ distance = 220 }
local onward = wear{ worn = start }
is(onward.model, start.model, "a worn start uses the model of the run")
is(onward.distance, 0, "a worn start begins at distance 0")
is(onward.p_center, start.p_center, "a worn start has the pressure of the run")
near(wear{ worn = start, alpha = 1, k = 0 }:step().p_center, start.p_center, 1e-9,
  "a worn start with k = 0 does not wear")
local resampled = wear{ worn = { cylinder = start:profile("cylinder"), plate = start:profile("plate") } }
near(resampled.p_center, start.p_center, 2e-3, "a worn start from profiles")
ok(wear{ worn = { plate = function(x) return math.max(0, 1e-3 - x * x / 20) end } }.p_center
  < start.p_center * 1.5, "a worn start from a function")
local wider = wear{ worn = start, stroke = 0.9 }
ok(wider.model.mesh.zone.plate > start.model.mesh.zone.plate,
  "a worn start with a longer stroke has a wider zone")
near(wider.p_center, start.p_center, 5e-3, "a worn start on another mesh")
near(wear{ model = model{}, stroke = 3 }.model.mesh.zone.plate, wear{ stroke = 3 }.model.mesh.zone.plate,
  1e-12,
  "a model object is meshed again with wider zones")

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
  ok(not (warnings.take() or ""):find "nothing to do", "steps of a finished run give the warning once")
end

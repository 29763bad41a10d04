-- Tests which input is accepted and refused by functions in a definition, loading, w:set and end conditions.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds
local warnings = require "archard.warnings"

local bodies = model{ mesh = { zone = { cylinder = 1, plate = 1.3 } } }
local function run_of(fields)
  fields.model = fields.model or bodies
  fields.increments = fields.increments or not fields.loading and 4 or nil
  fields.jump = fields.jump or not fields.tolerance and 100 or nil
  return wear(fields)
end

-- Checks that a refused step leaves the run unchanged.
local function untouched(w, parts, what)
  local before
  local err = fails(function()
    for _ = 1, 5 do
      before = tostring(w)
      w:step()
    end
  end, parts, what)
  is(tostring(w), before, what .. ": a refused step leaves the run unchanged")
  return err
end

-- --- functions of the state -----------------------------------------------------------------------

local function half(_) return 0.5 end
local plain = run_of{}:run()
local called = run_of{ k = function() return 1e-8 end, alpha = half, jump = function() return 100 end }:run()
is(called.p_center, plain.p_center, "constant functions give the bits of numbers")
is(table.concat(called.functions, " "), "k alpha jump", "the run lists the fields that are functions")
is(#plain.functions, 0, "a run without functions has an empty list")
is(called.alpha, half, "a function can be read back")
is(plain.local_factor, false, "local_factor is false if it is not set")
holds(tostring(called), { "k by function", "alpha by function", "jump by function" },
  "print shows which settings are functions")

local seen, asked = {}, {}
local watch = run_of{ k = function(s)
  asked[#asked + 1] = s.distance
  seen = { distance = s.distance, cycle = s.cycle, update = s.update, depth = s.depth, volume = s.volume,
    p_center = s.p_center, flat = s.depth_plate, text = tostring(s), kept = s }
  return 1e-8
end }
watch:step()
asked = {}
watch:step()
ok(math.min(table.unpack(asked)) > 22 and math.max(table.unpack(asked)) < 44,
  "k is called for distances within the update")
ok(#asked >= 9 and math.min(table.unpack(asked)) < 22.001 and math.max(table.unpack(asked)) > 43.999,
  "k is called from the start to the end of the update")
near(seen.distance, 44, 1e-6, "the last call of an update is at its end: distance")
near(seen.cycle, 200, 1e-6, "the last call of an update is at its end: cycle")
is(seen.update, 1, "the number of the update in the state")
is(seen.flat, seen.depth.plate, "the depths of both bodies in the state")
near(seen.volume.total, 1e-8 * 100 * 44, 1e-3, "the volume in the state")
near(seen.volume.total, seen.volume.cylinder + seen.volume.plate, 1e-12,
  "the total volume is the sum of both volumes")
ok(seen.p_center > 400 and seen.p_center < 600,
  "the pressure in the state is the pressure of the last record")
holds(seen.text, { "cycle", "44.0 mm" }, "print(state)")
fails(function() return seen.kept.distance end, "during the call of your function",
  "a state is not readable after the call")
holds(tostring(seen.kept), "not readable after the call", "print of a state after the call")
fails(function() run_of{ k = function(s) return s.distanse end } end,
  { "k(state at distance 0 mm, cycle 0) failed", "unknown field 'distanse' (did you mean 'distance'?)" },
  "an unknown field of the state")
fails(function() run_of{ k = function(s) s.distance = 3 end } end, "read-only",
  "a function writes to the state")
fails(function() run_of{ k = function(s) return getmetatable(s).__index(3, "k") end } end, "state expected",
  "the methods of the state check their argument")

local function after_30(value)
  return function(s) return s.distance > 30 and value or 0.5 end
end
local err = untouched(run_of{ alpha = function(s) return s.distance > 30 and error("no alpha") or 0.5 end },
  { "wear:step: alpha(state at distance 30.", " mm, cycle 136.", ") failed", "no alpha", "stack traceback",
    "histories.lua" }, "an error in alpha")
is(err.code, "CALLBACK", "the error of a failed function has a code")
holds(err.cause, "no alpha", "the error of a failed function has its cause")
err = untouched(run_of{ k = function(s) return s.distance > 30 and error{ answer = 42 } or 1e-8 end }, "k(state",
  "a function that raises a table")
is(err.cause.answer, 42, "the raised table is the cause of the error")
untouched(run_of{ alpha = after_30(1.5) },
  { "wear:step: field 'alpha': expected a number in [0, 1], got 1.5 from its function at distance 30." }, "alpha above 1")
untouched(run_of{ alpha = after_30(0 / 0) }, "field 'alpha': expected a number in [0, 1]", "alpha NaN")
untouched(run_of{ alpha = after_30("much") }, { "alpha(state", "expected a number, got string" },
  "alpha as a text")
untouched(run_of{ k = function(s) return s.distance > 30 and -1 or 1e-8 end }, { "field 'k': expected a number >= 0 mm2/N, got -1 from its function" }, "k negative")
untouched(run_of{ jump = function(s) return s.distance > 30 and 0 or 100 end },
  { "field 'jump': expected a number > 0 cycles, got 0 from its function at distance 44 mm" }, "jump zero")
untouched(run_of{ scheme = "implicit", alpha = function(s) return s.distance > 30 and error("no alpha") or 0.5 end },
  { "alpha(state", "no alpha" }, "an error in alpha of an implicit run")
fails(function() run_of{ k = "much" } end,
  [[field 'k': expected a number >= 0 mm2/N, a function of the state or a table { distance=, value= }, got "much"]],
  "k a text")
fails(function() run_of{ alpha = true } end, "a function of the state or a table", "alpha a boolean")

-- Tests that a run refuses to be stepped or changed by one of its own functions.
local self
self = run_of{ k = function() if self then self:step() end return 1e-8 end }
untouched(self, { "k(state", "this wear object is already running" }, "a run stepped by its own function")
self = nil
self = run_of{ k = function() if self then self:set{ load = 3 } end return 1e-8 end }
untouched(self, "already running", "a run changed by its own function")
self = nil
self = run_of{ k = function() if self then self:close() end return 1e-8 end }
untouched(self, "a wear object cannot be closed while it is running", "a run closed by its own function")
self = nil
self = run_of{ k = function() if self then self:stability() end return 1e-8 end }
untouched(self, "already running", "stability of a run computed by its own function")
local depth, deep = 0
self = nil
self = run_of{ k = function(s)
  local own = s.distance
  if self and depth == 0 then
    depth = 1
    deep = self:clone():step().distance
    depth = 0
  end
  return s.distance == own and 1e-8 or -1
end }
near(self:run{ distance = 44 }.volume.total, 4.4e-5, 1e-9, "a function that steps a clone of its run")
ok(deep > 20, "the clone has been stepped")
local other = run_of{ k = function() return self:contact().p_center > 0 and 1e-8 end }
near(other:run().p_center, plain.p_center, 1e-12, "a function that computes the contact of another run")
is(coroutine.wrap(function()
  return run_of{ k = coroutine.wrap(function() while true do coroutine.yield(1e-8) end end) }:run().p_center
end)(), plain.p_center, "a coroutine as a function, in a coroutine")
fails(function() run_of{ k = function() coroutine.yield() end } end, "attempt to yield",
  "a function that yields out of a step")

-- Tests that the functions of a run are not collected as garbage while the run or its clone exists.
do
  local kept = setmetatable({}, { __mode = "v" })
  local copy
  do
    local f = function() return 1e-8 + 0 * #kept end
    kept[1] = f
    local original = run_of{ k = f }
    copy = original:clone()
    original:close()
  end
  collectgarbage() collectgarbage()
  ok(kept[1] ~= nil, "a clone refers to the functions of the closed run")
  ok(copy:step().volume_cylinder > 0, "a clone calls the functions")
  copy:close()
  copy = nil
  collectgarbage() collectgarbage()
  ok(kept[1] == nil, "a closed run releases its functions")
  local ring
  do
    local held = {}
    held.run = run_of{ k = function() return held and 1e-8 end }
    ring = setmetatable({ held }, { __mode = "v" })
  end
  collectgarbage() collectgarbage()
  ok(ring[1] == nil, "a run and a function that refer to each other are collected")
end

-- --- local factors ----------------------------------------------------------------------------------

local asked = { cylinder = 0, plate = 0 }
local one = run_of{ local_factor = function(body, x, p, s)
  asked[body] = asked[body] + 1
  assert(p > 0 and math.abs(x) < 1 and s.distance >= 0)
  return 1
end }:run()
is(one.p_center, plain.p_center, "a local factor of 1 gives the bits of a run without it")
ok(asked.cylinder > 100 and asked.plate > 100, "the local factor is called for both bodies")
local double = run_of{ local_factor = { vector = function(_, xs, ps)
  local factors = {}
  for i in ipairs(ps) do factors[i] = xs[i] and 2 end
  return factors
end }, k = 5e-9 }:run()
is(double.p_center, plain.p_center, "a vector of factors 2 with half of k gives the same bits")
untouched(run_of{ local_factor = function(_, x, _, s) return s.distance > 30 and x < 0 and {} or 1 end },
  { 'local_factor("cylinder", x = -', "MPa, state at distance", "expected a number, got table" },
  "a local factor that is a table")
untouched(run_of{ local_factor = function(_, _, _, s) return s.distance > 30 and -1 or 1 end },
  { "field 'local_factor': expected a number >= 0, got -1 for the cylinder at x = -" }, "a negative local factor")
err = fails(function() run_of{ local_factor = function() return -1 end } end, "got -1 for the cylinder",
  "a negative local factor in the first step")
is(tostring(err):find "mesh.zone", nil, "the message for a negative factor does not mention the mesh zones")
fails(function() run_of{ local_factor = { vector = function() return { 1 } end } } end,
  { "local_factor.vector(\"", "expected one number for each x, got nil for x[2]" },
    "a vector with too few factors")
fails(function() run_of{ local_factor = { vector = function() end } } end, "expected an array of factors, got nil",
  "a vector function that returns nothing")
fails(function() run_of{ local_factor = { vektor = print } } end, "did you mean 'vector'", "misspelt vector")
fails(function() run_of{ local_factor = 3 } end,
  "field 'local_factor': expected a function(body, x, p, state, z) or { vector = function }, got 3",
    "a number instead of a local factor")

fails(function() run_of{ law = "threshold", scheme = "implicit", tolerance = 1e-3 } end,
  "no step is short enough for law", "a discontinuous law with a tolerance")
near(run_of{ law = "threshold", law_pressure = 300, scheme = "implicit", distance = 440, increments = 20 }:run().distance,
  440, 1e-12, "a discontinuous law with implicit steps and no tolerance")

-- --- loading --------------------------------------------------------------------------------------

local function position(t) return 0.055 * math.cos(2 * math.pi * t) end
local calls = 0
local cosine = run_of{ loading = { x = function(t) calls = calls + 1 return position(t) end, increments = 20 } }
is(calls, 21, "x is called once for each point")
cosine:step(2)
is(calls, 21, "x is not called again")
is(#cosine.functions, 0, "sampled functions are not listed as functions")
is(#cosine.loading[1].x, 21, "sampled functions can be read back")
is(cosine.loading[1].x[6], position(0.25), "a sampled position is identical to the bit")
is(plain.loading, false, "loading is false if it is not set")
holds(tostring(cosine), "loading of 1 block", "print shows the loading")
near(cosine.total_distance, 1320, 1e-12, "a loading without cycles has the default distance")
near(run_of{ cycles = 30, loading = { x = position } }.total_distance, 30 * 0.22, 1e-12,
  "cycles of the run with a single block")
near(run_of{ loading = { x = position, cycles = 30 } }.total_distance, 30 * 0.22, 1e-12,
  "cycles of the block")
near(run_of{ loading = { { x = position, cycles = 30 }, { x = position, cycles = 20 } } }.total_distance, 50 * 0.22,
  1e-12, "the distances of the blocks add up")
is(run_of{ loading = { x = position, load = { 50, 80, 50 }, increments = 4 } }.load, 80,
  "the default nominal load is the largest load of the loading")
is(run_of{ load = 60, loading = { x = position, load = { 50, 80, 50 } } }.load, 60,
  "the nominal load can be given")
is(run_of{ load = 60, loading = { x = position } }.loading[1].load[3], 60,
  "the load of the run is the default of the loading")
local even = run_of{ loading = { t = { 10, 15, 20 }, x = { -0.05, 0.05, -0.05 }, load = function(t) return 100 + t end } }
is(#even.loading[1].x, 3, "lists have one point for each increment")
is(even.loading[1].load[2], 100.5, "times are scaled to the interval from 0 to 1")
local finer = run_of{ loading = { t = { 0, 1, 4 }, x = { -0.05, 0.05, -0.05 }, increments = 4 } }
near(finer.loading[1].x[3], 0.05 - 0.1 / 3, 1e-12, "lists are interpolated at equal times")

-- Tests that nothing wears under loads that are zero or almost zero.
local function swing(t) return 0.1 * math.sin(2 * math.pi * t) end
local function lifting(least)
  return run_of{ load = 100, distance = 2, jump = 5, loading = { x = swing,
    load = function(t) return math.max(least, 100 * math.cos(2 * math.pi * t)) end } }:run()
end
local lifted, nearly = lifting(0), lifting(1e-9) -- rounding makes cos(pi / 2) equal to 6e-17
near(lifted.volume.total, 1e-8 * lifted.load_distance, 1e-12, "the volume under a load that falls to zero")
ok(lifted.solutions < 5000, ("a load that falls to zero: %d solutions"):format(lifted.solutions))
near(nearly.volume.total, lifted.volume.total, 1e-9, "a load that almost lifts off gives the same volume")
local out = run_of{ slide = "z", geometry = "frozen", k = 1e-11, jump = 1, distance = 2000, loading = { x = { 0, 1000, 0 }, load = { 100, 50, 100 } } }:run()
near(out.volume.total, 1e-11 * 75 * 2000, 1e-12, "the volume of a long motion out of the plane")
ok(out.solutions < 1000,
  ("a long motion needs increments for its load only: %d solutions"):format(out.solutions))

local function bad(loading, parts, what) fails(function() run_of{ loading = loading } end, parts, what) end
bad({ x = { 0, 0.1, "a" } }, [[field 'loading.x[3]': expected a finite number, got "a"]],
  "a text in the list of positions")
bad({ x = { 0, 0 / 0 } }, "field 'loading.x[2]': expected a finite number", "NaN in x")
bad({ x = { 0, 0.1, 0 }, load = { 1, 2 } }, "field 'loading.load': expected 3 numbers", "too few loads")
bad({ x = { 0 } }, "at least 2", "a list with a single position")
bad({ x = { 0, 0.1 }, load = { 1, -2 } },
  "field 'loading[1].load[2]': expected a number > 0 N, or 0 for a lift-off, got -2",
  "a negative load")
bad({ x = { 0, 0 } }, "expected a plate that moves", "a plate that does not move")
bad({ load = 3 }, "field 'loading.x': expected a function of t or an array, got nil",
  "a loading without positions")
bad({ x = 3 }, "expected a function of t or an array, got 3", "a number instead of positions")
bad({ x = { 0, 1, 0 }, t = { 0, 1, 1 } }, "field 'loading.t[3]': expected increasing times, got 1 after 1",
  "two equal times")
bad({ x = { 0, 1 }, t = { 0 } }, "at least 2 points in time", "a list with a single time")
bad({ x = position, t = { 0, 1 }, increments = 3 }, "expected one of them", "times and increments together")
bad({ x = position, increments = 0 }, "field 'loading.increments': expected a whole number in",
  "zero increments of a loading")
bad({ x = position, cycles = -1 }, "field 'loading.cycles': expected a number > 0",
  "a negative number of cycles")
bad({ x = position, periodic = 1 }, "field 'loading.periodic': expected true or false, got 1",
  "a number for periodic")
bad({ x = position, periodic = false, cycles = 2 }, "expected 1 for a history that is not periodic, got 2",
  "two cycles of a history that is not periodic")
bad({ x = position, period = 1 }, "unknown field 'loading.period' (did you mean 'periodic'?)",
  "a misspelt field of a loading")
bad({ { x = position, cycles = 1 }, { x = position, lod = 1 } }, "unknown field 'loading[2].lod'", "an unknown field in the second block")
bad({ { x = position }, { x = position } }, "field 'loading[1].cycles': expected a number > 0 and finite",
  "a first block without an end")
bad({ { x = position }, 3 }, "loading[2].", "a number instead of a block")
bad(3, "field 'loading': expected a block { x=, load= } or a list of blocks, got 3",
  "a number instead of a loading")
bad({ x = function(t) return t < 0.5 and 0 end, increments = 4 },
  "loading.x(0.5): expected a finite number, got false", "a position function that returns false")
bad({ x = function() return "a" end }, 'loading.x(0): expected a finite number, got "a"',
  "a position function that returns a text")
bad({ x = function(t) return t < 0.5 and 0 or error("no x") end, increments = 4 },
  { "loading.x(0.5) failed", "no x", "stack traceback" }, "an error in a position function")
fails(function() run_of{ cycles = 3, loading = { x = position, cycles = 2 } } end, "field 'cycles': expected more than",
  "cycles of the run and of the block together")
fails(function() run_of{ stroke = 0.1, loading = { x = position } } end,
  "'stroke' and 'loading': expected one",
  "stroke and loading together")
fails(function() cosine:run{ cycles = 3 } end,
  "expected a distance instead, because the cycles of 'loading' may differ",
  "w:run with cycles of a loading")

-- --- changes --------------------------------------------------------------------------------------

local w = run_of{}
w:step(2)
is(w:set{ alpha = 1, load = 200 }, w, "w:set returns the run")
holds(tostring(w), { "stroke 0.11 mm, load 100 N until now, 200 N from here on\n  wears by  k 1e-08 mm2/N "
  .. "= 1e-05 mm3/(N m), alpha 0.5 until now, 1 from here on" }, "print shows the settings of the last record")
is(w.alpha, 1, "a changed setting")
is(w.k, 1e-8, "other settings are unchanged")
is(w.update, 2, "the history is unchanged")
is(w.procedure, "NSP", "the procedure changes with alpha")
w:step()
near(w.volume.total, 1e-8 * (100 * 44 + 200 * 22), 1e-9, "the run continues under the new load")
holds(tostring(w), { "load 200 N\n  wears by  k 1e-08 mm2/N = 1e-05 mm3/(N m), alpha 1\n" }, "print shows the new load")
w:set{ k = function() return 3e-8 end }
is(w.functions[1], "k", "a number is replaced by a function")
w:step()
is(w.history.k[#w.history.k], 3e-8, "the function is called")
w:set{ alpha = function() return 1 end }
is(#w.functions, 2, "functions that are not set remain")
w:set{ k = 1e-8, alpha = { distance = { 0, 5000 }, value = { 1, 0 } } }
is(#w.functions, 0, "numbers and tables replace functions")
is(w.alpha.value[2], 0, "a table as a new setting")
w:set{ alpha = 0.5, cycles = 700 }
near(w.total_distance, 88 + 300 * 0.22, 1e-12, "new cycles are counted from the start of the run")
w:set{ loading = { { x = { 0, 0.1, 0 }, load = 30, cycles = 50 }, { x = { 0, 0.2, 0 }, cycles = 40 } } }
near(w.total_distance, 88 + 50 * 0.2 + 40 * 0.4, 1e-12, "a new loading begins at its first point")
is(w.load, 200, "a new loading does not change the nominal load")
near(w.stroke, 0.1, 1e-15, "the stroke is the range of the loading")
holds(tostring(w), "loading of 2 blocks, now over 0.1 mm", "print shows the loading")
w:step()
is(w.travel .. " " .. w.history.load[#w.history.load], "0.1 30.0", "load and travel of the last update")
is(w.load_low .. " " .. w.load_reference, "30.0 200.0", "smallest and nominal load of the last update")
local swing = run_of{ loading = { x = { 0, 0.05, 0 }, load = { 50, 150, 50 } }, distance = 10 }
swing:step()
is(swing.history.load_low[2] .. " " .. swing.history.load_reference[2], "50.0 150.0",
  "smallest and nominal load of a varying load")
swing:set{ load = 20 }
holds(tostring(swing), "load 150 N until now, 20 N from here on",
  "print shows the change of the nominal load")
w:run{ distance = 105 }
is(w.travel .. " " .. w.history.load[#w.history.load], "0.2 200.0", "load and travel of the second block")
is(w.history.load[1] .. " " .. w.history.travel[1], "100.0 0.11", "load and travel of the first block")
local volume = w.volume.total
w:set{ k = 2e-8 }
w:run()
near(w.distance, 88 + 50 * 0.2 + 40 * 0.4, 1e-12, "other changes do not restart the loading")
near(w.volume.total - volume, 2e-8 * 200 * 9, 1e-9, "the volume continues with the load of the block")
w:set{ stroke = 0.2, distance = 200, scheme = "explicit", jump = "auto" }
is(w.loading, false, "w:set of a stroke removes the loading")
near(w:run().distance, 200, 1e-12, "the run continues with the stroke")
w:set{ scheme = "implicit", tolerance = 1e-3 }:set{ scheme = "explicit" }
is(w.tolerance, 0, "the explicit scheme removes the tolerance")
local before = tostring(w)
fails(function() w:set{ model = bodies } end, "wear:set: field 'model' cannot be changed in a run",
  "w:set of another model")
fails(function() w:set{ alpha = 2 } end, "wear:set: field 'alpha': expected a number in [0, 1], got 2",
  "w:set of alpha above 1")
fails(function() w:set{ alhpa = 0.2 } end, "did you mean 'alpha'", "w:set of a misspelt field")
fails(function() w:set{ distance = 3 } end, "the run is already at 200 mm",
  "w:set of a distance already passed")
fails(function() w:set{ procedure = "NSP" } end, "NSP needs a plate that stays flat",
  "w:set of settings that exclude each other")
fails(function() w:set{ loading = { x = { -8, 8, -8 } } } end, "zone",
  "w:set of a loading longer than the body")
fails(function() w:set{ local_factor = function() error("no factor") end } end, "no factor",
  "w:set of a function that fails")
is(tostring(w), before, "a refused w:set leaves the run unchanged")
w:set{ k = { distance = { 0, 1000 }, value = { 1e-8, 1e-8 } } }
fails(function() w:set{ loading = { x = function(at) w:set{ k = 2e-8 } return 0.05 * at end } } end,
  "this wear object is in use and cannot change", "w:set within a function called by w:set")
is(w.k.value[2], 1e-8, "a refused w:set within w:set has no effect")
fails(function() w:set{ loading = { x = function(at) w:close() return 0.05 * at end } } end, "has been closed",
  "a run closed within w:set")

-- --- end conditions of a run ----------------------------------------------------------------------

w = run_of{}
local again, why = w:run{ depth = { cylinder = 1e-3 } }
is(again, w, "run returns the run")
is(why, "depth.cylinder", "run returns the reason of its end")
near(w.depth.cylinder, 1e-3, 1e-9, "the run ends at the given depth")
is(select(2, w:run{ volume = { total = 9e-4 } }), "volume.total", "w:run returns the volume as the reason")
near(w.volume.total, 9e-4, 1e-9, "the run ends at the given volume")
near(w.distance, 900, 1e-9, "the distance of a volume follows from V = k L d")
is(select(2, w:run{ p_center = 205 }), "p_center", "w:run returns the pressure as the reason")
near(w.p_center, 205, 1e-9, "the run ends at the given pressure")
is(select(2, w:run{ half_width = 0.252, depth = { plate = 1 } }), "half_width",
  "the first of two conditions is the reason")
is(select(2, w:run{ stop_when = function(r) return r.update >= 62 and "enough" end }), "stop_when",
  "w:run returns stop_when as the reason")
is(w.update, 62, "stop_when ends the run after a step")
warnings.keep()
is(select(2, w:run{ depth = { plate = 1 } }), "distance",
  "the distance ends a run whose condition is not met")
ok(warnings.take():find "wear:run: depth.plate = 1 was not reached: it is %S+ at the end, 1320 mm",
  "a condition that is not met gives a warning")
near(w.distance, 1320, 1e-12, "the run ends at exactly its distance")
is(select("#", w:run()), 1, "w:run without conditions returns the run only")
fails(function() w:run{ depth = { plate = 1e-6 } } end, "field 'depth.plate': the run is already at",
  "a depth that is already exceeded")
fails(function() w:run{ depth = 3 } end, "field 'depth': expected a table { cylinder=, plate= }, got 3",
  "a number instead of depths of bodies")
fails(function() w:run{ depth = { total = 3 } } end, "unknown field 'depth.total'",
  "the sum of the depths as a condition")
fails(function() w:run{ p_center = -3 } end, "field 'p_center': expected a number > 0, got -3",
  "a negative pressure as a condition")
fails(function() w:run{ stop_when = true } end, "field 'stop_when': expected a function",
  "a boolean as stop_when")
w:set{ distance = 1400 }
err = fails(function() w:run{ stop_when = function() error("no end") end } end,
  { "wear:run: stop_when failed", "no end" }, "an error in stop_when")
near(w.distance, 1342, 1e-12, "an error in stop_when: the step is complete")

-- Tests that steps keep their sliding distance where a block of loading has much shorter cycles than the last.
local blocks = {}
for i = 1, 20 do
  local amplitude, long = i % 2 == 0 and 0.3 or 0.02, i % 2 == 0
  blocks[i] = { x = function(t) return amplitude * math.sin(2 * math.pi * t) end, load = long and 200 or 100, cycles = long and 200 or 3000 }
end
local unlike = wear{ model = { mesh = { size = 0.04 } }, loading = blocks }:run{ progress = false }
ok(unlike.update <= 40, "number of updates for 20 unlike blocks: " .. unlike.update)

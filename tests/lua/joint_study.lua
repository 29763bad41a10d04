-- Tests studies, samples, sensitivities, fits and sessions with joints.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- which would make it too slow.
local tap = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/tap.lua")
local is, ok, near, fails = tap.is, tap.ok, tap.near, tap.fails

local pe = material{ E = 1000, nu = 0.4 }
local springs = joint{ foundation = "winkler", mesh = { size = 6 }, cup = { clearance = 0.1, layers = { { thickness = 8, material = pe } } } }
local folder = os.tmpname()
os.remove(folder)
local function path(name) return folder .. name end

-- --- runs with the interface of wear{} -----------------------------------------------------
local w = wear{ model = springs, k = 1e-9, alpha = 0.3, cycles = 2e5, updates = 4 }:run{ progress = false }
is(w.cycle, 2e5, "the run has all cycles")
near(w.distance, 2e5 * gait("iso").track, 1e-12, "sliding distance of the load")
near(w.total_distance, w.distance, 1e-12, "the total sliding distance equals the distance at the end")
ok(w.done and w.update == 4, "the run is done after four updates")
is(w.history.depth_cup, w.history.depth_plate, "the history has columns by the names of the bodies")
is(w.depth.lower, w.depth.cup, "depths by role and by name")
fails(function() return w.history.depth_cap end, "no field 'depth_cap'", "an unknown column of the history")
fails(function() return w.dept end, "did you mean 'depth'", "an unknown field of the run")
local half = wear{ model = springs, k = 1e-9, alpha = 0.3, cycles = 2e5, jump = 5e4 }:run{ distance = w.total_distance / 2, progress = false }
near(half.cycle, 1e5, 1e-12, "w:run to a distance ends at the right cycle")
is(half.update, 2, "updates of a fixed number of cycles")
local by_function = wear{ model = springs, k = 1e-9, cycles = 2e5, jump = function(s) return s.cycle < 1e5 and 1e5 or 5e4 end }:run{ progress = false }
is(by_function.update, 3, "updates of a number of cycles given by a function")
fails(function() wear{ model = springs, jump = function() return 0 end }:run{ progress = false } end,
  "field 'jump'",
  "a function that returns zero cycles")
fails(function() wear{ model = springs, jump = 10, updates = 3 } end, "got both", "jump and updates together")
local fields = wear{ model = { cup = { clearance = 0.1 }, mesh = { size = 6 }, foundation = "winkler" }, cycles = 1, loading = { flexion = { 0, 20, 0 }, load = 900 } }
near(fields.loading.track, gait{ flexion = { 0, 20, 0 }, load = 900 }.track, 1e-12,
  "a joint and a gait given as tables")

-- --- studies ------------------------------------------------------------------------------------------
local base = { model = springs, k = 1e-9, alpha = 0.3, cycles = 2e5, updates = 4 }
local s = study{ base = base, vary = { clearance = { 0.08, 0.1, 0.15 }, alpha = { 0.3, 0.6 } } }
s:run{ file = path "s", workers = 2, progress = false }
is(wear.open(path "s", 1).volume.cup, s:cases()[1]:wear().volume.cup, "wear.open opens a case")
is(#s.failed, 0, "a study of clearances and alphas")
local third = s:cases()[2]
is(third.label, "alpha 0.3, model.cup.clearance 0.1", "label of a case")
is(third.volume.cup, w.volume.cup, "a case has the bits of the run")
is(third:wear():map("cup").values[900], w:map("cup").values[900], "maps of a case have the bits of the run")
is(third.model.cup.clearance, 0.1, "the joint of a case")
ok(s:table():find("0.15", 1, true) and s:table():find "h_head +h_cup" and not s:table():find "p_center",
  "table of a study: " .. s:table())
ok(tostring(third):find("p peak " .. ("%.2f"):format(third.p_peak), 1, true), "print of a case")
is(third.last.depth_head, w.depth.head, "last row of a case by the names of the bodies")
s:figures{ dir = path "pictures", term = "svg" }
ok(io.open(path "pictures" .. "/history.svg"):read "a":find "depth of head", "history picture of a study")
plot.response(s, { x = "alpha", y = "depth_head", by = "model.cup.clearance", term = "dumb", file = path "response" .. ".txt" })
ok(io.open(path "response" .. ".txt"):read "a":find "depth", "response plot of the depth of the head")
plot.history(w, { term = "dumb", file = path "response" .. ".txt" })
local drawn = io.open(path "response" .. ".txt"):read "a"
ok(drawn:find "largest pressure of a cycle / MPa" and drawn:find "cycle",
  "plot.history without a column shows the largest pressure over the cycles")
os.remove(path "response" .. ".txt")
os.remove(path "pictures" .. "/history.svg")
os.remove(path "pictures")
s:close()
local opened = study.open(path "s")
is(opened:cases()[2].history.volume_head[5], w.history.volume_head[5], "history of a case in an opened study")
opened:close()
fails(function() study{ base = base, vary = { clearence = { 1 } } } end, "clearence",
  "a misspelt field in a study")
fails(function() study{ base = base, vary = { ["cup.clearence"] = { 1 } } }:run{ file = path "t" } end,
  "did you mean 'clearance'",
  "a misspelt field of the cup in a study")
local gaits = study{ base = base, cases = { { loading = gait "iso" }, { loading = gait "prosim" } } }
gaits:run{ file = path "g", workers = 1, progress = false }
near(gaits:cases()[2].distance, 2e5 * gait("prosim").track, 1e-9, "a study of two gaits")
gaits:close()
local sampled = study{ base = base, sample = { k = normal{ mean = 1e-9, deviation = 1e-10 }, clearance = uniform{ low = 0.08, high = 0.12 } }, n = 16, seed = 3 }
sampled:run{ file = path "u", workers = 2, progress = false }
local spread = sampled:uncertainty{ of = "volume_plate" }
near(spread.volume_plate.mean[#spread.distance], w.volume.cup, 0.03, "mean volume of a sample")
local usual = sampled:uncertainty()
near(usual.depth_head.mean[#usual.distance], w.depth.head, 0.05,
  "uncertainty without columns includes the depths")
ok(usual.p_peak.mean[1] > 0, "uncertainty without columns includes the largest pressure")
is(sampled:failure{ of = "depth_head", above = 0 }.probability, 1,
  "failure probability by the depth of the head")
fails(function() sampled:uncertainty{ of = "depth_hed" } end, "no column 'depth_hed' in the history",
  "uncertainty of an unknown column")
sampled:close()

-- --- sensitivities ------------------------------------------------------------------------------------
local all = w:sensitivity{ to = "alpha" }
near(all.depth_head.alpha.elasticity[4], 1, 0.05, "sensitivity of the depth of the head to alpha")
local sens = w:sensitivity{ of = { "depth_cup", "volume_cup" }, to = { "k", "clearance" } }
near(sens.volume_cup.k.elasticity[4], 1.03, 0.02, "sensitivity of the volume to k")
near(sens.depth_cup.clearance.elasticity[4], 0.41, 0.1, "sensitivity of the depth to the clearance")
local held = wear{ model = springs, k = 1e-9, alpha = 0.3, cycles = 2e5 }:run{ progress = false }
near(held:sensitivity{ of = "volume_cup", to = "alpha" }.volume_cup.alpha.elasticity[#held.history.cycle - 1], -0.3 / 0.7, 0.02,
  "sensitivity of the volume to alpha with error-controlled steps")
fails(function() w:sensitivity{ to = "clearence" } end, "clearence", "sensitivity to an unknown setting")

-- --- fits ---------------------------------------------------------------------------------------------
local volumes = fit{ model = springs, base = { updates = 4 }, unknown = { k = 3e-10, alpha = 0.5 }, progress = false,
  data = { { of = "volume_head", cycle = 2e5, value = w.volume.head, relative = 0.01 },
    { of = "volume_cup", cycle = 2e5, value = w.volume.cup, relative = 0.01 } } }
near(volumes.value.k, 1e-9, 1e-4, "k fitted to the volumes of head and cup")
near(volumes.value.alpha, 0.3, 1e-3, "alpha fitted to the volumes of head and cup")
local maps = fit{ model = springs, base = { updates = 4 }, unknown = { k = 3e-10, alpha = 0.5 }, progress = false,
  data = { { map = w:map "head", body = "head", cycle = 2e5, error = 1e-3 }, { map = w:map "cup", body = "cup", cycle = 2e5, error = 1e-3 } } }
near(maps.value.k, 1e-9, 1e-3, "k fitted to the maps of head and cup")
near(maps.value.alpha, 0.3, 1e-3, "alpha fitted to the maps of head and cup")
local loose = fit{ model = springs, base = { alpha = 0.3, k = 1e-9, updates = 4 }, unknown = { clearance = { start = 0.2, low = 0.03, high = 0.4 } }, progress = false,
  data = { { map = w:map "cup", body = "cup", cycle = 2e5, error = 1e-3 } } }
near(loose.value.clearance, 0.1, 1e-3, "clearance fitted to the map of the cup")
local function refused(item, expected, what)
  fails(function() fit{ model = springs, unknown = { k = 1e-9 }, data = { item } } end, expected, what)
end
refused({ map = w:map "cup", body = "cap", cycle = 1 }, "\"head\" or \"cup\"", "a map of an unknown body")
refused({ map = { theta = { 1 }, phi = { 1 }, values = { 1, 2 } }, body = "cup", cycle = 1 }, "data[1].map",
  "a map whose values do not match its grid")
refused({ of = "volume_cap", cycle = 1e5, value = 1, error = 1 }, "volume_cap",
  "the volume of an unknown body")

-- --- sessions -----------------------------------------------------------------------------------------
session_contact = contact{ model = springs, load = 2000, direction = { 0.1, 0, 1 } }
session_joint, session_gait, session_run, session_k = springs, gait "prosim", w, wear{ model = springs, k = function() return 1e-9 end, updates = 1, cycles = 10 }
local said = session.save(path "session")
ok(said:find("2 runs, 1 model, 1 contact", 1, true) and not said:find "not kept",
  "a session stores joints, runs and contacts: " .. said)
ok(said:find("session_k: pass its functions again", 1, true),
  "a session reports which functions must be passed again")
local before = { w.volume.cup, springs.cup.clearance, session_gait.track }
local pressure, p_max = tostring(session_contact), session_contact.p_max
session_contact = nil
session_joint, session_gait, session_run, session_k = nil, nil, nil, nil
fails(function() session.open(path "session") end, "session_k = { k = f }",
  "a session opened without its functions")
session.open(path "session", { session_k = { k = function() return 1e-9 end } })
is(session_run.volume.cup, before[1], "volume of a run opened from a session")
is(tostring(session_contact), pressure, "print of a contact opened from a session")
is(session_contact.p_max, p_max, "pressure of a contact opened from a session")
is(session_joint.cup.clearance, before[2], "clearance of a joint opened from a session")
is(session_gait.track, before[3], "sliding track of a gait opened from a session")
session_run:run{ cycles = 3e5, progress = false }
is(session_run.volume.cup, w:run{ cycles = 3e5, progress = false }.volume.cup,
  "a run opened from a session continues with identical bits")
session_run:close()
ok(tostring(session_run):find "closed", "print of a closed run")
for _, name in ipairs{ "s", "t", "g", "u", "session" } do os.remove(path(name)) end

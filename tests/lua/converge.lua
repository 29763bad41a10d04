-- study.converge and calibrate: what they find, and that it is the right thing.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

local file = os.tmpname()
os.remove(file)
local coarse = { mesh = { size = 0.04, height = 0.05 } }

-- --- the mesh ------------------------------------------------------------------------------------
local search = require "archard.study.search"
local steps, good = search.mesh({}, 0.02)
ok(good, "a mesh within 2 % of Hertz' pressure is found")
is(good, steps[#steps - 1], "it is the last but one: the last confirms it")
ok(good.elements >= 8, "at least eight elements across the contact")
near(good.elements, 2 * hertz{}.half_width / good.size, 1e-12, "which are counted so")
is(steps[2].size, steps[1].size / 2, "the element size")
near(steps[2].error, steps[2].p_max / hertz{}.p_max - 1, 1e-12, "what it is off Hertz'")
ok(math.abs(good.error) < 0.02 and math.abs(steps[#steps].error) < 0.02, "both are near Hertz'")
ok(#steps == 3 or math.abs(steps[#steps - 2].error) > 0.02 or steps[#steps - 2].elements < 8,
  "it stops where it may")

-- Three elements across are within 1 % by luck here.
local lucky = { load = 40, model = { radius = 6, cylinder = material{ E = 410e3, nu = 0.14 } } }
steps, good = search.mesh(lucky, 0.01)
ok(good and good.elements >= 8, "luck on a coarse mesh is not taken")

-- --- the jump and the increments -----------------------------------------------------------------
local c = study.converge{ base = { alpha = 1, model = coarse }, mesh = false }
local found = c.cases[1].found
is(found.increments, nil, "a plate that does not slide needs no increments")
local limit = wear{ alpha = 1, model = coarse }:stability().jump_limit
local next_up, at = math.huge, nil
for i, jump in ipairs(found.jumps) do
  if jump > found.jump then
    ok(found.roughnesses[i] > found.smooth, "every larger jump that was tried is rough")
    next_up = math.min(next_up, jump)
  elseif jump == found.jump then
    at = found.roughnesses[i]
  end
end
ok(at <= found.smooth, "the jump found is smooth")
ok(found.capped or next_up / found.jump < 1.6, "the next larger one on the ladder is not")
ok(found.jump < limit and found.jump > limit / 3,
  ("and it is near the limit of stability (%g, %.0f)"):format(found.jump, limit))
near(found.limit, limit, 0.1, "which is told")
is(found.judged, math.min(100, math.ceil(6000 / found.jump)), "it is judged by the whole run")
ok(found.smooth > search.limits.smooth, "the limit of roughness that this mesh needs")
holds(tostring(c), { "jump", "roughness", "stable to", "was allowed" }, "print")

-- With a roughness that everything keeps to, only stability is left; or a tenth of all cycles.
c = study.converge{ base = { alpha = 1, model = coarse, geometry = "frozen" }, mesh = false, smooth = 0.99,
  symmetric = 0.99 }
found = c.cases[1].found
ok(found.capped and found.bound == "stability" and found.jump < limit and found.jump > limit / 1.6,
  "never past the limit of stability")
holds(c:notes()[1], { "limit of stability", "the only case" }, "which is said")
c = study.converge{ base = { alpha = 1, model = coarse, geometry = "frozen", cycles = 400 }, mesh = false,
  smooth = 0.99, symmetric = 0.99 }
found = c.cases[1].found
ok(found.bound == "cycles" and found.jump == 40, "nor past a tenth of all cycles")
holds(tostring(c), { "≥40", "up to a tenth of all cycles" }, "which is said")

c = study.converge{ base = { geometry = "frozen", model = coarse }, mesh = false,
  vary = { stroke = { 0.11, 0.2 } }, file = file, workers = 2, progress = false }
is(#c.cases, 2, "several cases are searched by workers")
for i, row in ipairs(c.cases) do
  is(row.status, "done", "case " .. i)
  ok(row.found.jump > 0 and row.found.increments >= 4 and row.found.increments <= 200,
    ("jump %g, increments %d"):format(row.found.jump, row.found.increments))
  ok(row.found.change <= search.limits.profile, "whose profiles are those of many increments")
end
is(c:table_1(), nil, "no Table 1 of other cases")
os.remove(file)
fails(function() study.converge{ bas = {} } end, "did you mean 'base'", "a misspelt field")
fails(function() study.converge(3) end, "expected a study or a table", "no table")
fails(function()
  study.converge{ base = { loading = { x = { 0, 0.1, 0 }, load = { 1, 1, 1 }, cycles = 9 } } }
end, "loading", "a loading history")
fails(function() study.converge{ smooth = 2 } end, "smooth", "a limit out of range")

-- The paper's table, from results as they might be.
local rows = {}
for i, case in ipairs(study.paper():cases()) do
  rows[i] = { settings = case.settings, found = { jump = i, increments = 16, capped = i == 4,
    bound = "cycles", roughnesses = {} } }
end
local table_1 = getmetatable(c).__index.table_1{ cases = rows }
is(table.concat(table_1[2], " "), "0 75 1 16 50 2 16 30 3 16 - ≥4 16", "Table 1, first row")
is(#table_1, 6, "a row for each alpha")

-- --- calibrate by volumes ------------------------------------------------------------------------
local one = calibrate{ volume = { cylinder = 3e-4, plate = 1e-4 }, load = 100, distance = 400 }
near(one.k, 1e-8, 1e-12, "k from volumes")
near(one.alpha, 0.75, 1e-12, "alpha from volumes")
near(one.k_cylinder + one.k_plate, one.k, 1e-12, "parts of k")
is(one.spread.k, nil, "one measurement has no spread")
local many = calibrate{ volume = { cylinder = { 1, 2, 3 }, plate = { 2, 2, 2 } }, load = 1, distance = 1 }
near(many.alpha, 0.5, 1e-12, "alpha of means")
near(many.spread.k_cylinder, 1, 1e-12, "standard deviation of k_cylinder")
near(many.spread.k, 1, 1e-12, "of k")
near(many.spread.alpha, 2 / 16, 1e-12, "of alpha, to first order")
holds(tostring(many), { "+-", "0.5000", "3 measurements" }, "print")

-- --- calibrate by depths -------------------------------------------------------------------------
local fields = { geometry = "frozen", increments = 8, distance = 440, stroke = 0.44, jump = 50,
  model = coarse }
local function with(more)
  for name, value in pairs(fields) do more[name] = value end
  return more
end
local truth = wear(with{ alpha = 0.3 })
truth:run()
local back = calibrate(with{ depth = { cylinder = truth.depth.cylinder, plate = truth.depth.plate },
  accuracy = 1e-6 })
near(back.alpha, 0.3, 1e-4, "the alpha of a simulation comes back from its depths")
near(back.simulated_depth, back.measured_depth, 1e-4, "and so do its depths")
ok(back.runs < 12, "in few runs: " .. back.runs)
local flat = calibrate(with{ depth = { cylinder = 1e-3, plate = 0 } })
is(flat.alpha, 1, "a plate that did not wear")
local spread = calibrate(with{ depth = { cylinder = { 1.0e-3, 1.1e-3 }, plate = { 1.1e-3, 1.0e-3 } } })
ok(spread.spread.alpha > 0.01 and spread.spread.alpha < 0.2, "spread of alpha by depths")

fails(function() calibrate{} end, "got neither", "volume or depth")
fails(function() calibrate{ volume = {}, depth = {} } end, "got both", "but not both")
fails(function() calibrate{ volume = { cylinder = 1 } } end, "load", "volumes need the test's load")
fails(function() calibrate{ volume = { plate = 1e-4 }, load = 40, distance = 2000 } end,
  { "'volume.cylinder'", "got none", "0: too little" }, "a body that is left out")
fails(function() calibrate(with{ depth = { cylinder = 1e-3 } }) end, "'depth.plate'", "also of depths")
fails(function()
  calibrate{ volume = { cylinder = { 1, 2, 3 }, plate = { 2, 2 } }, load = 1, distance = 1 }
end, { "'volume.cylinder'", "'volume.plate'", "got 3 and 2" }, "unequal numbers of measurements")
fails(function() calibrate{ volume = { cylinder = 1, plate = { 2, 2 } }, load = 1, distance = 1 } end,
  "got 1 and 2", "one against a list")
is(calibrate{ volume = { cylinder = 0, plate = { 2, 4 } }, load = 1, distance = 1 }.k, 3,
  "a plain 0 stands for all of a list")
fails(function() calibrate{ volume = { cylinder = -1 }, load = 1, distance = 1 } end,
  { "volume.cylinder", "-1" }, "no negative volume")
fails(function() calibrate{ volume = { cyl = 1 }, load = 1, distance = 1 } end, "volume.cyl",
  "a misspelt body")
fails(function() calibrate{ volume = { cylinder = 0, plate = 0 }, load = 1, distance = 1 } end, "got none",
  "no wear at all")

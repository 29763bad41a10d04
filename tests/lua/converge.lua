-- Tests study.converge and calibrate: results and messages.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- which would only slow it down.
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
is(good, steps[#steps - 1], "the size before the last one is used; the last one confirms it")
ok(good.elements >= 8, "at least eight elements across the contact")
near(good.elements, 2 * hertz{}.half_width / good.size, 1e-12, "number of elements in the contact width")
is(steps[2].size, steps[1].size / 2, "each element size is half of the previous one")
near(steps[2].error, steps[2].p_max / hertz{}.p_max - 1, 1e-12, "error of the pressure against Hertz theory")
ok(math.abs(good.error) < 0.02 and math.abs(steps[#steps].error) < 0.02,
  "the pressures at the chosen and at the last size agree with Hertz theory")
ok(#steps == 3 or math.abs(steps[#steps - 2].error) > 0.02 or steps[#steps - 2].elements < 8,
  "the search stops at the first sufficient size")

-- Tests that a coarse mesh that is accurate by chance is rejected: with three elements across this contact the
-- error is below 1 %.
local lucky = { load = 40, model = { radius = 6, cylinder = material{ E = 410e3, nu = 0.14 } } }
steps, good = search.mesh(lucky, 0.01)
ok(good and good.elements >= 8, "a coarse mesh that is accurate by chance is rejected")

-- --- search for jump and increments --------------------------------------------------------------
local c = study.converge{ base = { alpha = 1, model = coarse }, mesh = false }
local found = c.cases[1].found
is(found.increments, nil, "a plate that does not move needs no increments")
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
ok(at <= found.smooth, "the surface is smooth at the jump found")
ok(found.capped or next_up / found.jump < 1.6, "the next larger jump tried is less than 1.6 times as large")
ok(found.jump < limit and found.jump > limit / 3,
  ("the jump is near the stability limit (%g, %.0f)"):format(found.jump, limit))
near(found.limit, limit, 0.1, "the stability limit is reported")
is(found.judged, math.min(100, math.ceil(6000 / found.jump)), "the jump is judged by the whole run")
ok(found.smooth > search.limits.smooth, "the roughness limit is raised for this mesh")
holds(tostring(c), { "jump", "roughness", "stable to", "was allowed" }, "print")

-- Tests that a wear coefficient given as a function of the state yields the same settings as the equivalent
-- table.
local simple = study.converge{ base = { stroke = 0.15, rule = "simple", model = coarse }, mesh = false }
ok(tostring(simple):find("profiles are asymmetric"), "the note says that rule Eq. (5) causes the asymmetry")

local stepped = study.converge{ base = { alpha = 1, model = coarse,
  k = function(state) return state.distance < 300 and 2e-8 or 1e-8 end }, mesh = false }.cases[1].found
local tabled = study.converge{ base = { alpha = 1, model = coarse,
  k = { distance = { 0, 300, 301 }, value = { 2e-8, 2e-8, 1e-8 } } }, mesh = false }.cases[1].found
is(stepped.jump, tabled.jump, "k as a function gives the same jump as k as a table")
fails(function() study.converge{ base = { k = function() return 0 end, alpha = 1, model = coarse },
  mesh = false } end, "k > 0 mm2/N at distance 0", "a k of zero at the start")
fails(function() study.converge{ base = { k = function() return 1e-8 end }, vary = { alpha = { 0, 1 } } } end,
  { "field 'base.k'", "table over distance" }, "a function as k in a study of several cases")

-- Tests a large roughness limit: only the stability limit, or a tenth of all cycles, then limits the number
-- of cycles per update (jump).
c = study.converge{ base = { alpha = 1, model = coarse, geometry = "frozen" }, mesh = false, smooth = 0.99,
  symmetric = 0.99 }
found = c.cases[1].found
ok(found.capped and found.bound == "stability" and found.jump < limit and found.jump > limit / 1.6,
  "the jump does not exceed the stability limit")
holds(c:notes()[1], { "stability limit", "the only case" }, "the stability limit is noted")
c = study.converge{ base = { alpha = 1, model = coarse, geometry = "frozen", cycles = 400 }, mesh = false,
  smooth = 0.99, symmetric = 0.99 }
found = c.cases[1].found
ok(found.bound == "cycles" and found.jump == 40, "the jump is at most a tenth of all cycles")
holds(tostring(c), { "≥40", "stops at a tenth of all cycles" }, "the bound of a tenth of all cycles is noted")

c = study.converge{ base = { geometry = "frozen", model = coarse }, mesh = false,
  vary = { stroke = { 0.11, 0.2 } }, file = file, workers = 2, progress = false }
is(#c.cases, 2, "several cases are searched by workers")
for i, row in ipairs(c.cases) do
  is(row.status, "done", "case " .. i)
  ok(row.found.jump > 0 and row.found.increments >= 4 and row.found.increments <= 200,
    ("jump %g, increments %d"):format(row.found.jump, row.found.increments))
  ok(row.found.change <= search.limits.profile, "profiles agree with those of many increments")
end
is(c:table_1(), nil, "Table 1 is printed for the cases of the paper only")
os.remove(file)
fails(function() study.converge{ bas = {} } end, "did you mean 'base'", "a misspelt field")
fails(function() study.converge(3) end, "expected a study or a table", "no table")
fails(function()
  study.converge{ base = { loading = { x = { 0, 0.1, 0 }, load = { 1, 1, 1 }, cycles = 9 } } }
end, "loading", "a search with a loading history")
fails(function() study.converge{ smooth = 2 } end, "smooth", "a roughness limit out of range")

-- Tests that Table 1 of the reference paper is printed correctly, with invented results.
local rows = {}
for i, case in ipairs(study.paper():cases()) do
  rows[i] = { settings = case.settings, found = { jump = i, increments = 16, capped = i == 4,
    bound = "cycles", roughnesses = {} } }
end
local table_1 = setmetatable({ cases = rows }, getmetatable(c)):table_1()
is(table.concat(table_1[2], " "), "0 75 1 16 50 2 16 30 3 16 - ≥4 16", "the first row of Table 1")
is(#table_1, 6, "Table 1 has a row for each alpha and a header")

-- --- calibrate with volumes ----------------------------------------------------------------------
local one = calibrate{ volume = { cylinder = 3e-4, plate = 1e-4 }, load = 100, distance = 400 }
near(one.k, 1e-8, 1e-12, "k from volumes")
near(one.alpha, 0.75, 1e-12, "alpha from volumes")
near(one.k_cylinder + one.k_plate, one.k, 1e-12, "parts of k")
is(one.spread.k, nil, "a single measurement has no standard deviation")
local many = calibrate{ volume = { cylinder = { 1, 2, 3 }, plate = { 2, 2, 2 } }, load = 1, distance = 1 }
near(many.alpha, 0.5, 1e-12, "alpha is computed from the mean volumes")
near(many.spread.k_cylinder, 1, 1e-12, "standard deviation of k_cylinder")
near(many.spread.k, 1, 1e-12, "standard deviation of k")
near(many.spread.alpha, 2 / 16, 1e-12, "standard deviation of alpha to first order")
holds(tostring(many), { "+-", "0.5000", "3 measurements" }, "print")

-- Tests correlated wear volumes: the error of the total k is smaller than the error of each body's k.
local paired = calibrate{ load = 100, distance = 1320,
  volume = { cylinder = { 0.41e-3, 0.44e-3, 0.39e-3 }, plate = { 0.92e-3, 0.88e-3, 0.97e-3 } } }
near(paired.spread.k, 1.5771e-10, 1e-4, "standard deviation of k from paired volumes")
near(paired.spread.k_plate, 3.4164e-10, 1e-4, "standard deviation of k_plate")
local shares, sum = { 0.41 / 1.33, 0.44 / 1.32, 0.39 / 1.36 }, 0
for i = 1, 3 do sum = sum + (shares[i] - (shares[1] + shares[2] + shares[3]) / 3) ^ 2 end
near(paired.spread.alpha, math.sqrt(sum / 2), 0.02,
  "standard deviation of alpha equals that of the pairs' alphas")
near(paired.high.k - paired.k, 4.302653 * paired.spread.k / math.sqrt(3), 1e-6,
  "confidence interval of the mean by Student's t")
near(calibrate{ volume = { cylinder = 1, plate = 3 }, load = 1, distance = 1, error = 0.1 }.high.k_plate - 3,
  1.96 * 0.1, 1e-3, "confidence interval by a given error of the readings")
near(calibrate{ volume = { cylinder = { 1, 2 }, plate = { 1, 1 } }, load = 1, distance = 1,
  confidence = 0.5 }.high.k - 2.5, 0.5, 1e-9, "confidence interval at another confidence")

-- --- calibrate with volumes at several distances ---------------------------------------------------
local at = { 40, 100, 150, 300, 440 }
local function volumes(settled, fresh, factor)
  local list = {}
  for i, d in ipairs(at) do
    list[i] = factor * 100 * (settled * d + (fresh - settled) * 80 * (1 - math.exp(-d / 80)))
  end
  return list
end
local on_way = { cylinder = {}, plate = {} }
for i, factor in ipairs{ 0.97, 1, 1.03 } do
  on_way.cylinder[i], on_way.plate[i] = volumes(3e-9, 2e-8, factor), volumes(7e-9, 9e-9, 2 - factor)
end
local course = calibrate{ load = 100, distance = at, volume = on_way }
local run = wear{ k = course.k, alpha = course.alpha, geometry = "frozen", increments = 8, scheme = "explicit",
  model = coarse, distance = at[#at] }
for i, d in ipairs(at) do
  run:run{ distance = d }
  near(run.volume.cylinder, on_way.cylinder[2][i], 1e-9,
    ("a run with the tables of k and alpha has the cylinder's volume at %g mm"):format(d))
  near(run.volume.plate, on_way.plate[2][i], 1e-9,
    "a run with the tables of k and alpha has the plate's volume")
end
local worst_off, taken = 0, { cylinder = 0, plate = 0 }
for i, d in ipairs(course.k.distance) do
  near(course.k_cylinder.value[i] + course.k_plate.value[i], course.k.value[i], 1e-12,
    "k is the sum of k_cylinder and k_plate at each distance")
  near(course.k.value[i] * course.alpha.value[i], course.k_cylinder.value[i], 1e-12,
    "k_cylinder is alpha k at each distance")
  local before = course.k.distance[i - 1]
  for _, body in ipairs{ "cylinder", "plate" } do
    local v = course["k_" .. body].value
    if before then taken[body] = taken[body] + 100 * (d - before) * (v[i] + v[i - 1]) / 2 end
  end
end
for i, d in ipairs(course.band.k.distance) do
  worst_off = math.max(worst_off, math.abs(course.band.k.value[i] / (1e-8 + 1.9e-8 * math.exp(-d / 80)) - 1))
end
ok(worst_off < 0.06, ("k agrees with the k of the simulated tests (within %.3f)"):format(worst_off))
is(course.k.value[#course.k.value], course.band.k.value[#at],
  "the k of the last interval also applies after it")
near(taken.cylinder, on_way.cylinder[2][#at], 1e-9, "the integral of k_cylinder is the cylinder's volume")
near(taken.plate, on_way.plate[2][#at], 1e-9, "the integral of k_plate is the plate's volume")
is(#course.band.k.low, #at, "each interval of the distance has a confidence band")
-- the volumes of both bodies are exact also if alpha changes suddenly
for _, case in ipairs{ { { 1e-6, 2e-6, 4e-5, 8e-5 }, { 1e-5, 2e-5, 2.2e-5, 2.4e-5 } },
  { { 0, 1e-5, 1e-5, 1e-5 }, { 2e-5, 2e-5, 8e-5, 8e-5 } } } do
  local hard = { distance = { 50, 137, 140, 400 }, load = 50, volume = { cylinder = case[1], plate = case[2] } }
  local found = calibrate(hard)
  local slid = wear{ k = found.k, alpha = found.alpha, load = 50, geometry = "frozen", increments = 8, scheme = "explicit",
    model = coarse, distance = 400 }
  for i, d in ipairs(hard.distance) do
    slid:run{ distance = d }
    ok(math.abs(slid.volume.cylinder - case[1][i]) < 1e-13 and math.abs(slid.volume.plate - case[2][i]) < 1e-13,
      ("alpha with a sudden change: both volumes at %g mm"):format(d))
  end
end
for i = 1, #at do
  local band = course.band.alpha
  ok(band.low[i] < band.value[i] and band.value[i] < band.high[i] and band.high[i] <= 1,
    "confidence bands contain the mean")
end
near(course.mean.k, (on_way.cylinder[2][#at] + on_way.plate[2][#at]) / (100 * at[#at]), 1e-9,
  "mean of k over the whole distance")
holds(tostring(course), { "3 tests at 5 distances", "0 to 40", "whole distance" }, "print")
local single = calibrate{ load = 100, distance = at, volume = { cylinder = volumes(3e-9, 2e-8, 1), plate = 0 } }
is(single.alpha.value[4], 1, "alpha is 1 if the plate did not wear")
is(single.band.k.low[1], nil, "a single test has no confidence bands")
is(#calibrate{ load = 100, distance = at, error = 1e-6, volume = { cylinder = volumes(3e-9, 2e-8, 1),
  plate = 0 } }.band.k.low, #at, "a single test with a known error has confidence bands")
fails(function() calibrate{ load = 1, distance = at, volume = { cylinder = { 1, 2 }, plate = 0 } } end,
  { "volume.cylinder", "5 volumes" }, "fewer volumes than distances")
fails(function() calibrate{ load = 1, distance = { 1, 2 }, volume = { cylinder = { 2, 1 }, plate = 0 } } end,
  "but the volume at distance no. 2 is", "a volume that decreases with distance")
fails(function() calibrate{ load = 1, distance = { 2, 1 }, volume = { cylinder = { 1, 2 }, plate = 0 } } end,
  "increasing", "distances that decrease")
fails(function() calibrate{ distance = { 1, 2 }, depth = { cylinder = 1, plate = 1 } } end, "as 'depth' is given",
  "depths at several distances")

-- --- calibrate with depths -----------------------------------------------------------------------
local fields = { geometry = "frozen", increments = 8, distance = 440, load = 100, stroke = 0.44, jump = 50,
  model = coarse }
local function with(more)
  for name, value in pairs(fields) do more[name] = value end
  return more
end
local truth = wear(with{ alpha = 0.3, k = 2.5e-8, jump = 20 })
truth:run()
local back = calibrate(with{ depth = { cylinder = truth.depth.cylinder, plate = truth.depth.plate },
  accuracy = 1e-6, jump = 20 })
fields.jump = 20
near(back.alpha, 0.3, 1e-4, "the alpha of a simulation is recovered from its depths")
near(back.k, 2.5e-8, 1e-4, "the k of a simulation is recovered from its depths")
near(back.k_cylinder + back.k_plate, back.k, 1e-12, "k_cylinder and k_plate add up to k")
near(back.simulated_depth, back.measured_depth, 1e-5, "simulated depths equal the measured ones")
ok(back.runs < 12, "number of runs of a calibration: " .. back.runs)
holds(tostring(back), { "simulated with", "stroke 0.44 mm, load 100 N", "radius 10 mm", "both E 200000 MPa" },
  "print shows the conditions of the simulation")
local known = calibrate(with{ k = 2.5e-8, depth = { cylinder = truth.depth.cylinder, plate = truth.depth.plate } })
near(known.alpha, 0.3, 1e-3, "alpha is computed for a given k")
is(known.k, nil, "a given k is not computed")
fails(function() calibrate(with{ k = 1e-8, depth = { cylinder = truth.depth.cylinder, plate = truth.depth.plate } }) end,
  { "'k'", "without the field" }, "a given k that contradicts the depths is refused")
fails(function() calibrate(with{ depth = { cylinder = 0.31, plate = 0.62 } }) end, "are they in um?",
  "depths given in um")
fails(function() calibrate{ depth = { cylinder = 1e-3, plate = 1e-3 }, distance = 440 } end, "'load'",
  "depths without the load")
local flat = calibrate(with{ depth = { cylinder = 1e-3, plate = 0 } })
is(flat.alpha, 1, "alpha is 1 for a plate that did not wear")
is(flat.k_plate, 0, "k_plate is 0 for a plate that did not wear")
local spread = calibrate(with{ depth = { cylinder = { 1.0e-3, 1.1e-3 }, plate = { 1.1e-3, 1.0e-3 } } })
ok(spread.spread.alpha > 0.01 and spread.spread.alpha < 0.2, "standard deviation of alpha from depths")
ok(spread.spread.k < 0.05 * spread.k, "correlated depths reduce the standard deviation of k")
fails(function() calibrate(with{ depth = { cylinder = { 1e-3, 0 }, plate = { 1e-3, 0 } } }) end, "at least one body",
  "a test without wear is refused")

fails(function() calibrate{} end, "got neither", "neither volume nor depth")
fails(function() calibrate{ volume = {}, depth = {} } end, "got both", "volume and depth together")
fails(function() calibrate{ volume = { cylinder = 1 } } end, "load", "volumes without the load")
fails(function() calibrate{ volume = { plate = 1e-4 }, load = 40, distance = 2000 } end,
  { "'volume.cylinder'", "got none", "0 if it was too small" }, "volume of one body only")
fails(function() calibrate(with{ depth = { cylinder = 1e-3 } }) end, "'depth.plate'",
  "depth of one body only")
fails(function()
  calibrate{ volume = { cylinder = { 1, 2, 3 }, plate = { 2, 2 } }, load = 1, distance = 1 }
end, { "'volume.cylinder'", "'volume.plate'", "got 3 and 2" },
  "unequal numbers of measurements of the bodies")
fails(function() calibrate{ volume = { cylinder = 1, plate = { 2, 2 } }, load = 1, distance = 1 } end,
  "got 1 and 2", "a number for one body and a list for the other")
is(calibrate{ volume = { cylinder = 0, plate = { 2, 4 } }, load = 1, distance = 1 }.k, 3,
  "0 stands for a list of zeros")
fails(function() calibrate{ volume = { cylinder = -1 }, load = 1, distance = 1 } end,
  { "volume.cylinder", "-1" }, "a negative volume")
fails(function() calibrate{ volume = { cyl = 1 }, load = 1, distance = 1 } end, "volume.cyl",
  "a misspelt body")
fails(function() calibrate{ volume = { cylinder = 0, plate = 0 }, load = 1, distance = 1 } end, "got 0 for both",
  "zero volumes of both bodies")

-- Tests uncertainties: distributions, designs, Sobol's indices against closed forms, samples of studies,
-- failure probabilities, sensitivities and pictures.

-- Long
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/../lua/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

local folder = os.tmpname()
os.remove(folder)
assert(os.execute("mkdir " .. folder))
local function path(name) return folder .. "/" .. name end

local random = require "archard.random"
local indices = require "archard.uncertainty.indices"
local sampled = require "archard.uncertainty.sampled"
local statistics = require "archard.lib.statistics"

-- --- points --------------------------------------------------------------------------------------

-- Checks that 2^m consecutive Sobol points form a net: one point in each of 2^m equal slices of every axis.
local function one_a_slice(column)
  local seen = {}
  for _, value in ipairs(column) do
    local slice = math.floor(value * #column)
    if seen[slice] then return false end
    seen[slice] = true
  end
  return true
end
for _, design in ipairs{ "sobol", "latin" } do
  local even = true
  for _, column in ipairs(random.points(design, 256, 20, 3)) do even = even and one_a_slice(column) end
  ok(even, design .. ": one point in each slice of every axis")
end
ok(not one_a_slice(random.points("random", 256, 1, 3)[1]), "random: not one point in each slice")
local a, b = random.points("sobol", 64, 4, 7), random.points("sobol", 64, 4, 7)
local c = random.points("sobol", 64, 4, 8)
ok(a[4][64] == b[4][64] and a[1][1] == b[1][1], "equal seeds give equal points")
ok(a[4][64] ~= c[4][64], "different seeds give different points")

-- --- distributions -------------------------------------------------------------------------------
local function values_of(distribution, n)
  local list = {}
  for i, share in ipairs(random.points("sobol", n, 1, 1)[1]) do list[i] = distribution.value(share) end
  return list
end
local k = values_of(lognormal{ mean = 1e-8, variation = 0.4 }, 4096)
near(statistics.mean(k), 1e-8, 1e-3, "lognormal: mean of the samples")
near(statistics.deviation(k), 4e-9, 5e-3, "lognormal: standard deviation of the samples")
near(statistics.deviation(values_of(normal{ 100, 5 }, 4096)), 5, 2e-3,
  "normal given by two numbers: standard deviation")
near(statistics.deviation(values_of(uniform{ 0.3, 0.7 }, 4096)), 0.4 / math.sqrt(12), 1e-3,
  "uniform: standard deviation")
local cut = sampled.sorted(values_of(normal{ 100, 5, low = 98, high = 103 }, 512))
ok(cut[1] >= 98 and cut[#cut] <= 103, "normal with bounds: all samples are within the bounds")
-- A normal distribution that is cut off below its mean mu has the mean mu + sigma sqrt(2 / pi).
near(statistics.mean(values_of(normal{ 100, 5, low = 100 }, 4096)), 100 + 5 * math.sqrt(2 / math.pi), 1e-4,
  "normal with a lower bound at the mean: mean of the samples")
is(tostring(normal{ 100, 5 }), "normal{ mean=100, deviation=5 }", "print of a distribution")
fails(function() normal{ mean = 1, sigma = 2 } end, { "normal", "'sigma'", "known: " },
  "an unknown parameter of a distribution")
fails(function() normal{ 100 } end, { "'deviation'", "neither" }, "a normal distribution without deviation")
fails(function() normal{ 100, 5, variation = 0.1 } end, "both", "deviation and variation together")
fails(function() normal{ 100, -5 } end, { "'deviation'", "> 0" }, "a negative standard deviation")
fails(function() uniform{ 0.7, 0.3 } end, { "low < high", "0.7 and 0.3" },
  "a lower bound above the upper bound")
fails(function() lognormal{ -1, 1 } end, { "'mean'", "> 0" }, "a lognormal distribution with a negative mean")
fails(function() normal{ 100, 5, low = 200 } end, "is almost 0", "bounds that exclude almost all values")
fails(function() uniform(3) end, { "uniform", "table" }, "a number instead of a table")

-- --- Sobol's indices -----------------------------------------------------------------------------

-- Tests the indices of Ishigami's function, which are known in closed form and include strong interactions.
local function ishigami(x) return math.sin(x[1]) + 7 * math.sin(x[2]) ^ 2 + 0.1 * x[3] ^ 4 * math.sin(x[1]) end
local function at(columns, i, first)
  local x = {}
  for d = 1, 3 do x[d] = math.pi * (2 * columns[first + d][i] - 1) end
  return x
end
local function design_of(kind, n, seed)
  local columns, base, other, mixed = random.points(kind, n, 6, seed), {}, {}, { {}, {}, {} }
  for i = 1, n do
    local from, to = at(columns, i, 0), at(columns, i, 3)
    base[i], other[i] = ishigami(from), ishigami(to)
    for d = 1, 3 do
      local x = { table.unpack(from) }
      x[d] = to[d]
      mixed[d][i] = ishigami(x)
    end
  end
  return base, other, mixed
end
local v1 = 0.5 * (1 + 0.1 * math.pi ^ 4 / 5) ^ 2
local v2, v13 = 7 ^ 2 / 8, 0.1 ^ 2 * math.pi ^ 8 * (1 / 18 - 1 / 50)
local variance = v1 + v2 + v13
local first = { v1 / variance, v2 / variance, 0 }
local total = { (v1 + v13) / variance, v2 / variance, v13 / variance }
local base, other, mixed = design_of("sobol", 8192, 1)
for d = 1, 3 do
  local s, t = indices.of(base, other, mixed[d])
  near(s.value - first[d], 0, 0.005, ("Ishigami: first order of x%d"):format(d))
  near(t.value - total[d], 0, 0.005, ("Ishigami: total order of x%d"):format(d))
end
-- Tests that the 95 % confidence ranges contain the exact indices in about 95 % of the trials.
local held, trials = 0, 40
for seed = 1, trials do
  base, other, mixed = design_of("random", 512, seed)
  for d = 1, 3 do
    local s, t = indices.of(base, other, mixed[d])
    held = held + (math.abs(s.value - first[d]) <= 1.96 * s.error and 1 or 0)
    held = held + (math.abs(t.value - total[d]) <= 1.96 * t.error and 1 or 0)
  end
end
tap.note(("the ranges contain the exact index in %d of %d"):format(held, 6 * trials))
ok(held / (6 * trials) > 0.88 and held / (6 * trials) < 0.99,
  "about 95 % of the confidence ranges contain the exact index")
is(indices.of({ 1, 1 }, { 1, 1 }, { 1, 1 }), nil, "a constant result has no indices")

-- --- estimates -----------------------------------------------------------------------------------
is(sampled.quantile({ 1, 2, 3, 4, 5 }, 0.5), 3, "median of five values")
near(sampled.quantile({ 1, 2, 3, 4, 5 }, 0.9), 4.6, 1e-12, "a quantile between two values")
local low, high = sampled.share_range(0, 100, 0.95)
is(low, 0, "lower bound of a probability without events")
near(high, 1 - 0.025 ^ (1 / 100), 1e-9, "upper bound of a probability without events")
near(sampled.rank_correlation({ 1, 2, 3, 4 }, { 1, 8, 27, 64 }), 1, 1e-12,
  "rank correlation with the cubes is 1")
is(sampled.rank_correlation({ 1, 2, 3 }, { 5, 5, 5 }), nil, "no rank correlation with a constant")

-- --- definitions ---------------------------------------------------------------------------------
local coarse = { geometry = "frozen", increments = 8, distance = 220, jump = 50,
  model = { mesh = { size = 0.04, height = 0.05 } } }
local scatter = { k = lognormal{ mean = 1e-8, variation = 0.4 }, alpha = uniform{ 0.3, 0.7 },
  load = normal{ 100, 5 } }
local function with(given)
  given.base, given.sample = given.base or coarse, given.sample or scatter
  return study(given)
end
fails(function() with{ sample = { k = 3 } } end, { "'sample.k'", "uniform{}" },
  "a number instead of a distribution")
fails(function() with{ sample = {} } end, "at least one", "a sample without fields")
fails(function() with{ sample = { alfa = uniform{ 0, 1 } } } end, { "'alfa'", "'alpha'" }, "a misspelt field")
fails(function() with{ vary = { k = { 1 } } } end, "got both", "vary and sample together")
fails(function() study{ base = coarse, n = 100 } end, { "'n'", "sample" }, "n without samples")
fails(function() with{ n = 1 } end, { "'n'", "[2, 1000000]" }, "one sample")
fails(function() with{ n = 8, indices = true } end, { "'n'", "16" }, "too few samples for indices")
fails(function() with{ design = "halton" } end, { "'design'", '"sobol"' }, "an unknown design")
local function joined(list)
  return { k = scatter.k, alpha = scatter.alpha, load = scatter.load, correlated = list }
end
fails(function() with{ sample = joined{ { "k", "alfa", 0.5 } } } end, { "correlated", "'alfa'" },
  "a correlation of an unknown field")
fails(function() with{ sample = joined{ { "k", "alpha", 2 } } } end, { "correlated[1]", "(-1, 1)" },
  "a correlation above 1")
fails(function() with{ sample = joined{ { "k", "alpha", 0.9 }, { "k", "load", 0.9 }, { "alpha", "load", -0.9 } } }
end, "inconsistent", "correlations that contradict each other")
fails(function() with{ indices = true, sample = joined{ { "k", "alpha", 0.5 } } } end, { "'indices'", "correlated" },
  "indices of correlated fields")
local many = {}
for i = 1, 41 do many[("loading.%d.load"):format(i)] = uniform{ 1, 2 } end
fails(function() with{ sample = many } end, { "41", "40" }, "more fields than the Sobol sequence has")

-- Tests correlated normal scores: the ranks are correlated, and the distributions are unchanged.
local twins = with{ n = 1024, sample = joined{ { "k", "alpha", -0.5 } } }
local ks, alphas = {}, {}
for i, case in ipairs(twins:cases()) do ks[i], alphas[i] = case.k, case.alpha end
near(sampled.rank_correlation(ks, alphas), 6 / math.pi * math.asin(-0.25), 0.02, "rank correlation of the samples")
near(statistics.mean(ks), 1e-8, 0.01, "mean of correlated samples")

-- --- checks before the start ---------------------------------------------------------------------
fails(function() with{ n = 4, sample = { alpha = normal{ 0.5, 0.4 } } }:run{ file = path("out"), progress = false }
end, { "sample.alpha", "low=" }, "values out of range are reported before the start")
is(io.open(path("out")), nil, "a refused study writes no file")
fails(function() with{ n = 4, sample = { law_pressure = uniform{ 50, 150 } } }:run{ file = path("out"),
  progress = false } end, { "sample.law_pressure", "has no effect" }, "a sampled field without effect")
fails(function() with{ n = 4 }:uncertainty() end, "the study has no results yet", "no results yet")

-- --- a case with a known answer ------------------------------------------------------------------

-- Tests the wear volume of the cylinder, alpha k L d (load L, distance d). Its mean, standard deviation and
-- Sobol indices of first and total order are known in closed form.
local s = with{ n = 64, indices = true, name = "known", sample = { alpha = uniform{ 0.4, 0.6 },
  k = lognormal{ mean = 1e-8, variation = 0.1 }, load = normal{ 100, 5 } } }
s:run{ file = path("known"), workers = 2, progress = false }
local u = s:uncertainty{ of = { "volume_cylinder", "depth_cylinder" }, at = { 110, 220 } }
local cv = { k = 0.01, alpha = 0.2 ^ 2 / 12 / 0.25, load = 0.0025 }
local whole = (1 + cv.k) * (1 + cv.alpha) * (1 + cv.load) - 1
local v = u.volume_cylinder
near(v.mean[2], 0.5 * 1e-8 * 100 * 220, 0.01, "mean volume")
near(v.mean[1], v.mean[2] / 2, 1e-9, "mean volume at half the distance")
near(v.deviation[2] / v.mean[2], math.sqrt(whole), 0.05, "relative standard deviation of the volume")
for name, square in pairs(cv) do
  local by_itself, in_all = square / whole, square / whole * (1 + whole) / (1 + square)
  near(v.first[name].value[2] - by_itself, 0, math.min(0.1, v.first[name].error[2]), "first order of " .. name)
  near(v.total[name].value[2] - in_all, 0, math.min(0.1, v.total[name].error[2]), "total order of " .. name)
end
holds(tostring(u), { "128 samples (sobol, seed 1) at 220 mm", "from 64 to 128 samples" },
  "print of the uncertainty")
ok(v.quantiles[1].low[2] <= v.quantiles[1].value[2] and v.quantiles[1].value[2] <= v.quantiles[1].high[2],
  "a quantile is within its confidence range")
fails(function() s:uncertainty{ of = "depth" } end, { "'of'", "depth" }, "an unknown result")
fails(function() s:uncertainty{ at = { 500 } } end, { "'at'", "220" }, "a distance beyond the end")
fails(function() s:uncertainty{ quantiles = { 2 } } end, { "'quantiles[1]'", "(0, 1)", "got 2" },
  "a quantile of 2")

-- If only k is uncertain, the volume exceeds its limit exactly when k exceeds the corresponding limit.
local one = with{ n = 256, sample = { k = scatter.k } }
one:run{ file = path("one"), workers = 2, progress = false }
local limit = 1.3e-8
local width = math.sqrt(math.log(1.16))
local truth = 1 - random.normal_share((math.log(limit / 1e-8) + width * width / 2) / width)
local f = one:failure{ of = "volume_cylinder", above = 0.5 * limit * 100 * 110, before = 110 }
near(f.probability, truth, 2 / 256 / truth, "probability of a failure")
ok(f.low < truth and truth < f.high, "the confidence range contains the exact probability")
holds(tostring(f), { "above", "before 110 mm", "of 256 samples" }, "print of a failure probability")
is(one:failure{ of = "p_center", below = 0 }.probability, 0, "probability of an impossible event")
local warnings = require "archard.warnings"
warnings.keep()
is(one:failure{ of = "depth_plate", above = 1 }.probability, 0, "probability of a depth of 1 um, taken for mm")
ok((warnings.take() or ""):find("study:failure: the limit, 1 mm, is", 1, true), "a limit far above all values is questioned")
warnings.keep()
one:failure{ of = "depth_plate", above = 1e-3 }
is(warnings.take(), nil, "a limit near the values is not questioned")
fails(function() one:failure{ of = "p_center" } end, { "'above'", "neither" }, "a failure without a limit")
fails(function() one:failure{ above = 1 } end, { "'of'" }, "a failure without a result")
fails(function() one:failure{ of = "p_center", above = 1, before = 999 } end, { "'before'", "220" },
  "a failure before a distance beyond the end")
local ranks = one:uncertainty{ of = "volume_plate" }
near(ranks.volume_plate.rank.k, 1, 1e-12, "without indices the rank correlation is reported")

-- --- identical bits ------------------------------------------------------------------------------
local content = here .. "/../lua/lib/content.lua"
local function bits(file)
  local pipe = io.popen(("%s %s %s 2>/dev/null"):format(os.getenv("ARCHARD") or "build/archard", content, file))
  local text = pipe:read("a")
  pipe:close()
  return text
end
local function small() return with{ n = 16, indices = true, seed = 5, base = coarse } end
small():run{ file = path("w1"), workers = 1, progress = false }
local whole_one = small():run{ file = path("w3"), workers = 3, progress = false }
ok(#bits(path("w1")) > 1000, "the compared texts are long enough")
is(bits(path("w1")), bits(path("w3")), "one and three workers give identical bits")
for i = 1, 2 do small():run{ file = path("s" .. i), shard = i .. "/2", workers = 1, progress = false } end
local merged = study.merge(path("s2"), path("s1"), { file = path("merged") })
local opened = study.open(path("w1"))
is(tostring(merged:uncertainty()), tostring(whole_one:uncertainty()),
  "merged shards have the results of the whole study")
is(tostring(opened:uncertainty()), tostring(whole_one:uncertainty()),
  "an opened study has the results of the whole study")
fails(function() study.open(path("s1")):uncertainty() end, "have not run yet",
  "a single shard has no uncertainty")
fails(function() with{ n = 16, seed = 6, indices = true }:run{ file = path("w1"), progress = false } end,
  "another study", "another seed defines another study")

-- --- sensitivities -------------------------------------------------------------------------------
local thin = wear{ k = 1e-12, distance = 44, jump = 100 }
thin:run{ progress = false }
local t = thin:sensitivity{ of = { "depth_cylinder", "volume_plate" }, to = { "k", "load", "alpha" } }
near(t.depth_cylinder.k.elasticity[1], 1, 1e-8, "the depth of the first update is linear in k")
near(t.depth_cylinder.k.elasticity[2], 1, 1e-5, "elasticity of the depth to k after little wear")
near(t.volume_plate.k.elasticity[2], 1, 1e-10, "elasticity of the volume to k")
near(t.volume_plate.k.derivative[2], 0.5 * 100 * 44, 1e-10,
  "derivative of the volume with respect to k is alpha L d")
near(t.volume_plate.load.elasticity[2], 1, 1e-10, "elasticity of the volume to the load")
near(t.volume_plate.alpha.elasticity[2], -1, 1e-10, "elasticity of the plate's volume to alpha")

-- Tests sensitivities to a scale of all stresses (load and E increased, k decreased): at every distance and
-- for any mesh, the depth is constant and the pressure exactly proportional.
local w = wear{ distance = 330, jump = 100 }
w:run{ progress = false }
local g = w:sensitivity{ of = { "depth_cylinder", "depth_plate", "p_center" }, to = { "k", "load", "E" }, over = 0 }
local worst = 0
for _, name in ipairs(g.of) do
  for i = 1, #g.distance do
    local sum = g[name].load.elasticity[i] + g[name].E.elasticity[i] - g[name].k.elasticity[i]
    worst = math.max(worst, math.abs(sum - (name == "p_center" and 1 or 0)))
  end
end
tap.note(("scaling of stresses holds to %.1e"):format(worst))
ok(worst < 1e-4, "sensitivities obey the scaling of stresses to 1e-4")
-- Tests sensitivities against central differences with Richardson extrapolation.
local function depth(load)
  local run = wear{ distance = 330, jump = 100, load = load, model = w.model }
  run:run{ progress = false }
  return run.depth.cylinder
end
local function difference(h) return (depth(100 + h) - depth(100 - h)) / (2 * h) end
near(g.depth_cylinder.load.derivative[#g.distance], (4 * difference(5e-4) - difference(1e-3)) / 3, 1e-4,
  "derivative with respect to the load against extrapolated differences")
holds(tostring(g), { "sensitivities at 330 mm", "percent per percent" }, "print of sensitivities")
for _, given in ipairs{ { scheme = "implicit", tolerance = 1e-3 }, { jump = "auto" } } do
  given.distance, given.model = 220, w.model
  local run = wear(given)
  run:run{ progress = false }
  local e = run:sensitivity{ of = "depth_plate", to = { "k", "load", "E" } }.depth_plate
  local n = #e.k.elasticity
  near(e.load.elasticity[n] + e.E.elasticity[n] - e.k.elasticity[n], 0, 1e-3,
    "the scaling of stresses with automatic steps")
end
-- Tests automatic steps. The reported error includes the error of the steps, so its range must contain the
-- derivative extrapolated to short steps from jump = 10 and jump = 5.
local function sensitivity_of(given)
  given.distance, given.model, given.geometry = 220, w.model, "frozen"
  local run <close> = wear(given)
  run:run{ progress = false }
  local e = run:sensitivity{ of = { "depth_plate", "p_center" }, to = "k" }
  local last = {}
  for _, name in ipairs(e.of) do
    local one = e[name].k
    last[name] = { value = one.elasticity[#one.elasticity], error = one.elasticity_error[#one.elasticity] }
  end
  return last
end
local wide, narrow = sensitivity_of{ jump = 10 }, sensitivity_of{ jump = 5 }
for what, given in pairs{ implicit = { scheme = "implicit", tolerance = 1e-3 }, auto = { jump = "auto" } } do
  for name, one in pairs(sensitivity_of(given)) do
    local truth, doubt = 2 * narrow[name].value - wide[name].value, math.abs(narrow[name].value - wide[name].value)
    tap.note(("%s, sensitivity of %s to k: %.5f +- %.5f, with smaller steps %.5f"):format(what, name,
      one.value, one.error, truth))
    ok(math.abs(one.value - truth) < one.error + doubt,
      what .. ": the error range of " .. name .. " contains the exact value")
    near(one.value, truth, name == "p_center" and 5e-3 or 3e-4, "the derivative agrees with smaller steps")
  end
end
-- Tests quantities of the contact's edge, which moves from node to node: the reported derivative is the slope
-- over many nodes and agrees with finer elements.
local worn = wear{ jump = 100, distance = 660 }
worn:run{ progress = false }
local jumping = worn:sensitivity{ of = { "half_width", "p_center", "volume_plate" }, to = { "k", "alpha" } }
-- elasticities with respect to k on elements of 5 um
for name, truth in pairs{ half_width = 0.285, p_center = -0.336 } do
  local one, n = jumping[name].k, #jumping.distance
  tap.note(("sensitivity of %s to k: %.3f +- %.3f over %g"):format(name, one.elasticity[n],
    one.elasticity_error[n], one.over[n]))
  ok(math.abs(one.elasticity[n] - truth) < one.elasticity_error[n] + 0.01,
    name .. ": slope over many nodes against finer elements")
  ok(one.over[n] == 0.24, "the result states the range of the slope")
end
ok(jumping.volume_plate.k.over[1] == 0, "a smooth result has a local derivative")
local pair = { k = uniform{ 1e-8, 2e-8 }, alpha = uniform{ 0.3, 0.7 } }
pair.correlated = { { "k", "alpha", 0.9 }, { "alpha", "k", -0.9 } }
fails(function() study{ sample = pair } end, { "'sample.correlated[2]'", "given twice, first as 0.9" }, "a correlation given twice")
pair.correlated = { { "k", "alpha", 2 } }
fails(function() study{ sample = pair } end, { "'sample.correlated[1][3]'", "a number in (-1, 1), got 2" }, "a correlation of 2")
fails(function() study{ sample = { increments = uniform{ 10, 100 } } } end, { "'sample.increments'", "an even number" },
  "a distribution of an even number")
fails(function() lognormal{ 1e-8, 0.4 } end, { "'deviation'", "variation=" }, "a variation given as deviation")
fails(function() w:sensitivity{ over = 0.6 } end, { "'over'", "0.6" }, "a range of a slope that is too wide")
fails(function() w:sensitivity{ to = "distance" } end, { "'to'", "distance", "w.history" }, "sensitivity to the end of the run")
local plate_only = wear{ distance = 44, alpha = 0 }
plate_only:run{ progress = false }
fails(function() plate_only:sensitivity{ to = "alpha" } end, { "'to'", "alpha is 0" },
  "sensitivity to an alpha of 0")
near(plate_only:sensitivity{ of = "volume_plate", to = "k" }.volume_plate.k.elasticity[2], 1, 1e-10,
  "sensitivity to k with alpha = 0")
fails(function() w:sensitivity{ to = "kk" } end, { "'to'", "kk" }, "sensitivity to an unknown setting")
fails(function() w:sensitivity{ to = "scheme" } end, { "'to'", "scheme" }, "sensitivity to a text")
fails(function() w:sensitivity{ of = "depth" } end, { "'of'", "depth" }, "an unknown result")
fails(function() w:sensitivity{ off = 1 } end, { "'off'", "'of'" }, "a misspelt field")
fails(function() wear{}:sensitivity() end, "has not started", "sensitivities of a run that has not started")
local changed = wear{ distance = 110 }
changed:step()
changed:set{ load = 120 }
changed:run{ progress = false }
fails(function() changed:sensitivity() end, "cannot be repeated", "sensitivities of a run that was changed")
local two = wear{ distance = 110, model = { plate = { E = 1e5 } } }
two:run{ progress = false }
fails(function() two:sensitivity{ to = "E" } end, { "cylinder.E", "plate.E" },
  "sensitivity to E of bodies with different E")

-- --- pictures ------------------------------------------------------------------------------------
plot.bands(u, { of = "depth_cylinder", file = path("bands.txt") })
plot.bands(s, { of = { "depth_plate", "p_center" }, file = path("both.txt") })
plot.tornado(u, { of = "depth_cylinder", at = 100, file = path("tornado.txt") })
plot.tornado(ranks, { file = path("ranks.txt") })
plot.tornado(g, { of = "p_center", file = path("elastic.txt") })
local function text_of(name)
  local file = assert(io.open(path(name)))
  local text = file:read("a")
  file:close()
  return text
end
holds(text_of("bands.txt"), { "5 to 95 %", "50 %", "known" }, "bands show their quantiles")
holds(text_of("tornado.txt"), { "α", "load", "at 110 mm", "share of the variance" },
  "a tornado plot shows the fields and the distance")
holds(text_of("ranks.txt"), { "rank correlation" }, "a tornado plot without indices shows rank correlations")
holds(text_of("elastic.txt"), { "elasticity (% per %)", "pressure at the centre" },
  "a tornado plot of sensitivities shows elasticities")
fails(function() plot.bands(w) end, { "plot.bands", "wear" }, "plot.bands of a run")
fails(function() plot.bands(u, { of = "p_max" }) end, { "'of'", "p_max" }, "plot.bands of a missing column")
fails(function() plot.tornado{} end, "plot.tornado", "plot.tornado of an empty table")

os.execute("rm -r " .. folder)

-- Tests fit and fit.design: refused input, results, notes, run files, pictures.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- which would only slow it down.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

local file = os.tmpname()
os.remove(file)
local base = { jump = 50, stroke = 0.22, distance = 220, model = { mesh = { size = 0.04, height = 0.05 } } }

-- --- exact data ----------------------------------------------------------------------------------
local truth = wear{ k = 1.4e-8, alpha = 0.3, jump = 50, stroke = 0.22, distance = 220, model = base.model }
truth:run()
local function profile_of(body, shift, level)
  local profile, x, h = truth:profile(body), {}, {}
  for i = 1, #profile.x do x[i], h[i] = profile.x[i] + shift, profile.h[i] + level end
  return { body = body, distance = 220, profile = { x = x, h = h }, error = 2e-5 }
end
local data = { profile_of("cylinder", 0.004, 1e-4), profile_of("plate", -0.003, 0),
  { of = "volume_plate", distance = 220, value = truth.volume.plate, relative = 0.03 } }
local unknown = { k = { start = 1e-8 }, alpha = { start = 0.5 } }
local f = fit{ base = base, unknown = unknown, data = data }
near(f.value.k, 1.4e-8, 1e-5, "k from exact data")
near(f.value.alpha, 0.3, 1e-5, "alpha from exact data")
near(f.data[1].place.shift.value, 0.004, 1e-4, "the shift of a profile")
near(f.data[1].place.level.value, 1e-4, 1e-4, "the level of a profile")
ok(f.low.k < 1.4e-8 and f.high.k > 1.4e-8 and f.error.k > 0, "the 95 % range contains the true k")
ok(f.high.k - f.value.k >= (1 - 1e-12) * (f.times * f.error.k + 2 * math.abs(f.mesh.k)),
  "a range contains the standard error times f.times and twice the change with half the element size")
ok(f.high.k - f.value.k < f.times * f.error.k + 0.05 * f.value.k, "the error due to the mesh is small")
near(f.margins[1], f.high.alpha - f.value.alpha, 1e-12, "half widths of the ranges as a list")
is(f.freedom, #data[1].profile.x + #data[2].profile.x + 1 - 8, "degrees of freedom")
is(f.wear.distance, 220.0, "the run of a fit is at the last measured distance")
near(f.wear.k, f.value.k, 1e-15, "the run of a fit has the fitted k")
f.wear:run{ distance = 300 }
is(f.wear.distance, 300.0, "the run of a fit can be continued")
ok(f.data[2].low[20] < f.data[2].model[20] and f.data[2].model[20] < f.data[2].high[20],
  "the band contains the fitted profile")
holds(tostring(f), { "k ", "mm2/N", "correlations", "profile of the plate at 220 mm", "chi2",
  "rms of residual / error" }, "print(f)")

-- --- a profile with another origin of x ----------------------------------------------------------
local surface, aside = truth:profile "plate", { x = {}, z = {} }
for i = 1, #surface.x do
  if math.abs(surface.x[i]) < 1 then
    aside.x[#aside.x + 1], aside.z[#aside.z + 1] = surface.x[i] + 2.1, -surface.h[i]
  end
end
g = fit{ base = base, unknown = { k = { start = 1e-8 }, alpha = { start = 0.5 } }, data = {
  { body = "plate", distance = 220, profile = profile(aside):depth(), error = 2e-5 } } }
near(g.value.k, 1.4e-8, 1e-2, "k from a scar at x = 2.1 mm")
near(g.data[1].place.shift.value, 2.1, 1e-3, "shift of a scar at x = 2.1 mm")
fails(function()
  fit{ base = base, unknown = { k = { start = 1e-8 } }, data = { { body = "plate", distance = 220, profile = profile(aside), error = 2e-5 } } }
end, "expected depths, got heights: p:depth()", "a profile of heights instead of depths")
local lists = profile(aside):depth()
-- the body is called by the name that the user gave it
local named = { jump = 50, stroke = 0.22, distance = 220, model = { mesh = base.model.mesh, lower = body.block{ name = "Flat_2" } } }
g = fit{ base = named, unknown = { k = { start = 1e-8 }, alpha = { start = 0.5 } }, data = {
  { body = "Flat_2", distance = 220, x = lists.x, h = lists.h, error = 2e-5 } } }
near(g.value.k, 1.4e-8, 1e-2, "k from a profile of a body with a name")
g = fit{ base = base, unknown = { k = { start = 1e-8 }, alpha = { start = 0.5 } }, data = {
  { body = "plate", distance = 220, x = lists.x, h = lists.h, error = 2e-5 } } }
near(g.value.k, 1.4e-8, 1e-2, "lists x and h of a scar at x = 2.1 mm: fitted k")
near(g.data[1].place.shift.value, 2.1, 1e-3, "lists x and h of a scar at x = 2.1 mm: fitted shift")

-- --- standard errors by theory -------------------------------------------------------------------

-- Tests the standard error of k from volumes: after little wear the volume is k L d alpha, so the relative
-- error of k equals the relative error of the mean volume.
local volumes = { of = "volume", distance = { 55, 110, 165, 220 }, relative = 0.03,
  value = { 55e-6, 110e-6, 165e-6, 220e-6 } }
local g = fit{ base = base, unknown = { k = 2e-8 }, data = { volumes } }
near(g.value.k, 1e-8, 1e-6, "k from exact volumes")
near(g.error.k, 0.03 / 2 * 1e-8, 1e-4, "the standard error of k is that of the mean of four volumes")
near(g.times, 1.96, 1e-3, "ranges use the normal distribution for known errors")

-- Tests standard errors estimated from the residuals against the closed form of a line through the origin.
local plain = { of = "volume", distance = { 55, 110, 165, 220 }, value = { 56e-6, 109e-6, 166e-6, 219e-6 } }
g = fit{ base = base, unknown = { k = 2e-8 }, data = { plain } }
local sxx, sxy = 0, 0
for i, d in ipairs(plain.distance) do sxx, sxy = sxx + 1e4 * d * d, sxy + 100 * d * plain.value[i] end
local k, rest = sxy / sxx, 0
for i, d in ipairs(plain.distance) do rest = rest + (plain.value[i] - k * 100 * d) ^ 2 end
near(g.value.k, k, 1e-6, "k is the slope of the regression line")
near(g.error.k, math.sqrt(rest / 3 / sxx), 1e-4, "standard error of the slope from the residuals")
near(g.times, 3.1824, 1e-4, "ranges use Student's t for errors estimated from residuals")

-- --- friction loops ------------------------------------------------------------------------------

-- Tests a fit of the friction loop of a run with the friction coefficient 0.63. The loop is shifted in x and
-- force, and the compliance of a test rig, 1e-5 mm/N, is added.
local rubbing = { load = 92.5, k = 1e-8, jump = 50, model = { radius = 6, mesh = { size = 0.02 } } }
local function moving(given)
  for name, value in pairs(rubbing) do given[name] = value end
  return given
end
local function loop_of(given, every)
  given.friction, given.cycles = 0.63, 100
  local run <close> = wear(moving(given))
  run:run{ progress = false }
  local there, x, force = run:loop(), {}, {}
  for i = 1, #there.x - 1, every do
    local n = #x + 1
    force[n] = there.tangential[i] + 1.5
    x[n] = there.x[i] + 4e-4 + 1e-5 * force[n]
  end
  return { x = x, tangential = force }
end
local friction = { friction = { start = 0.4, low = 0, high = 1.2 } }
local slid = fit{ base = moving{ stroke = 0.02 }, unknown = friction, data = {
  { loop = loop_of({ stroke = 0.02 }, 2), cycle = 100, compliance = 1e-5, error = 0.5 } } }
near(slid.value.friction, 0.63, 1e-5, "friction from a loop in gross slip")
near(slid.data[1].place.shift.value, 4e-4, 1e-3, "shift of a friction loop along x")
near(slid.data[1].place.level.value, 1.5, 1e-3, "shift of a friction loop along the force")
is(slid.data[1].distance, 4.0, "cycle numbers are converted to sliding distances")
holds(tostring(slid), { "loop at 4 mm: 50 values", "level 1.5 +- ", " N" }, "print of a fitted loop")
plot.fit(slid, { file = file .. ".txt" })
os.remove(file .. ".txt")
-- Tests the fit to loops in partial slip under a given force: it compares computed and measured positions at
-- the measured forces.
local partial = loop_of({ tangential = 40 }, 1)
for i, force in ipairs(partial.tangential) do partial.x[i] = partial.x[i] - 1e-5 * force end
local stuck = fit{ base = moving{ tangential = 40 }, unknown = { friction = { start = 0.8, low = 0.5, high = 1.2 } },
  data = { { loop = partial, cycle = 100, error = 2e-6 } } }
near(stuck.value.friction, 0.63, 1e-3, "friction from a loop in partial slip")
local function refused_loop(change, what, why)
  local one = { loop = loop_of({ stroke = 0.02 }, 4), distance = 4, error = 0.5 }
  for name, value in pairs(change) do one[name] = value end
  fails(function() fit{ base = moving{ stroke = 0.02 }, unknown = friction, data = { one } } end, what, why)
end
refused_loop({ cycle = 3 }, { "'data[1].cycle'", "'data[1].distance'", "got both" },
  "cycle and distance together")
refused_loop({ loop = { x = { 1, 2 } } }, { "data[1].loop", "tangential [N]" }, "a loop without forces")
refused_loop({ body = "plate" }, { "'data[1].body'", "loop" }, "a loop with a body")
local thousands = loop_of({ stroke = 0.02 }, 4)
for i, x in ipairs(thousands.x) do thousands.x[i] = 1e3 * x end
refused_loop({ loop = thousands }, { "data[1].loop.x", "in mm" }, "a loop with positions in um")
fails(function()
  fit{ base = base, unknown = { k = 1e-8 }, data = { { of = "volume", distance = 55, value = 1e-4, compliance = 1 } } }
end, { "'data[1].compliance'", "loops" }, "compliance of a measurement that is not a loop")

-- --- curves --------------------------------------------------------------------------------------
local knots, values = { 0, 50, 220 }, { 0.7, 0.45, 0.35 }
local spline = require "archard.fit.spline"
local series = spline.series({ 0, 1, 2, 3 }, { 0, 1, 1, 4 })
local monotonic = true
for i = 2, #series.value do monotonic = monotonic and series.value[i] >= series.value[i - 1] end
ok(monotonic, "the spline is monotonic if its knots are monotonic")
is(series.value[9], 1, "the spline passes through the knots")
local curved = wear{ k = 1e-8, alpha = spline.series(knots, values), jump = 50, stroke = 0.22,
  model = base.model }
local shares = { of = "volume_cylinder", distance = {}, value = {}, relative = 0.01 }
for i = 1, 11 do
  curved:run{ distance = 20 * i }
  shares.distance[i], shares.value[i] = 20 * i, curved.volume.cylinder
end
local h = fit{ base = base, unknown = { alpha = { start = 0.5, knots = knots } }, data = { shares } }
for i, value in ipairs(values) do near(h.value.alpha[i], value, 1e-3, "alpha at knot " .. i) end
is(#h.curve.alpha.distance, 17, "the fitted curve is a table for wear{}")
ok(h.band.alpha.low[9] < 0.45 and h.band.alpha.high[9] > 0.45, "the fitted curve has a confidence band")
local smooth = fit{ base = base, data = { shares },
  unknown = { alpha = { start = 0.5, knots = { 0, 50, 130, 220 }, smooth = "auto" } } }
ok(smooth.smooth > 0, "cross-validation chooses a weight of smoothness")
near(smooth.value.alpha[4], 0.35, 0.05, "smoothing does not change the fitted values")

-- a run on a finer mesh that fails does not fail the fit
local function fails_on_finer_mesh(_, x)
  local size = math.abs(x)
  if size > 0.005 and size < 0.015 then error("a node near x = 0.01 mm") end
  return 1
end
local unrefined = fit{ base = { local_factor = fails_on_finer_mesh }, unknown = { k = 2e-8 },
  data = { { of = "depth_plate", distance = { 20, 40 }, value = { 1e-4, 2e-4 } } } }
is(unrefined.mesh, nil, "no error due to the mesh if the run on the finer mesh fails")
holds(tostring(unrefined), { "half the element size failed", "a node near" }, "the reason is a note")

is(fit{ base = { geometry = "frozen", model = { mesh = "examples/gmsh_pair.msh", radius = 10 } }, unknown = { k = 1e-8 },
  data = { { of = "depth_plate", distance = { 20, 40 }, value = { 1e-4, 2e-4 } } } }.mesh, nil,
  "an imported mesh is not refined")

-- --- run files -----------------------------------------------------------------------------------
local function stored(workers, other)
  return fit{ base = base, unknown = { k = other or 2e-8 }, data = { volumes }, file = file, workers = workers,
    progress = false }
end
local first = stored(2)
near(first.value.k, 1e-8, 1e-6, "a fit with two workers")
local again = stored(1)
is(again.value.k, first.value.k, "a fit read from its file has identical bits")
is(again.runs, 0, "a fit read from its file needs no run")
local unstable -- on the finer mesh jump = 1 is past the stability limit
for call = 1, 2 do
  unstable = fit{ base = { stroke = 0.22, jump = 1 }, unknown = { k = 7e-7 }, file = file .. ".unstable", progress = false,
    data = { { of = "depth_plate", distance = { 11, 22 }, relative = 0.03, value = { 1.13e-3, 1.83e-3 } } } }
  is(unstable.mesh, nil, "a stored run on the finer mesh that failed, call " .. call)
end
os.remove(file .. ".unstable")
g = fit{ base = base, unknown = { k = 2e-8 }, data = { volumes } }
is(g.value.k, first.value.k, "a fit in this process gives identical bits")
fails(function() fit{ unknown = { k = 2e-8 }, data = volumes } end,
  "field 'data': expected a list of measurements, got a single one: write data = { { ... } }",
    "a single measurement instead of a list")
fails(function() fit{ base = { jump = 40 }, unknown = { k = 2e-8 }, data = { volumes }, file = file } end,
  { file, "another fit" }, "a file of another fit")
os.remove(file)

-- --- notes ---------------------------------------------------------------------------------------
local one = { of = "volume_plate", distance = { 100, 220 }, value = { 5e-5, 1.1e-4 }, relative = 0.03 }
local three = { of = "volume_plate", distance = { 50, 100, 220 }, value = { 2.5e-5, 5e-5, 1.1e-4 }, relative = 0.03 }
g = fit{ base = base, unknown = unknown, data = { three } }
holds(tostring(g), { "the data determine only a combination of alpha and k", "without a standard error" },
  "the note says that only a combination of k and alpha is determined")
is(g.error.k, math.huge, "an undetermined value has no standard error")
three.value = { 1e-4, 2e-4, 4e-4 }
g = fit{ base = base, unknown = { alpha = 0.5 }, data = { three } }
holds(tostring(g), { "alpha is at its lower bound, 0", "times the given errors" },
  "the note says that alpha is at its bound")

local function refused(given, parts, what)
  given.base = given.base or base
  fails(function() fit(given) end, parts, what)
end
local bare = { of = "volume_plate", distance = { 100, 220 }, value = { 5e-5, 1.1e-4 } }
refused({ unknown = unknown, data = { bare } },
  { "fit.lua:", "too few data: 2 values for 2 unknowns", "if the data have the field 'error'" },
  "fewer values than unknowns")
refused({ unknown = { k = { start = 1e-8, low = 2e-8, high = 1e-9 } }, data = { one } },
  { "'unknown.k.low'", "low < high", "2e-08 and 1e-09" }, "a lower bound above the upper bound")
refused({ unknown = { alpha = { start = 0.5, high = 1.5 } }, data = { one } },
  { "'unknown.alpha.high'", "from 0 to 1, got 1.5" }, "a bound outside the range of the setting")
refused({ base = { k = 3e-9 }, unknown = { k = 1e-8 }, data = { one } }, { "'base.k'", "unknown.k" },
  "k as an unknown and as a fixed value")
refused({ unknown = { k = 1e-8 }, data = { { of = "volume", distance = { -5, 600 }, value = { 1, 2 } } } },
  { "'data[1].distance[1]'", "a number > 0, got -5" }, "a negative distance")
refused({ unknown = { k = 1e-8 }, data = { { of = "volume", distance = { 1, 600 }, value = { 1, 0 / 0 } } } },
  { "'data[1].value[2]'", "nan" }, "NaN among measured values")
refused({ unknown = { kk = 1 }, data = { one } }, "unknown field 'kk' (did you mean 'k'?)", "a misspelt unknown")
refused({ base = { radius = 1 }, unknown = unknown, data = { one } }, "it is a field of model{}",
  "an unknown in base that is a field of the model")
refused({ unknown = { scheme = 1 }, data = { one } }, { "unknown.scheme", "number" },
  "an unknown that is not a number")
refused({ unknown = { alpha = 1 }, data = { one } }, { "unknown.alpha.start", "inside the bounds 0" },
  "a start value at a bound")
refused({ unknown = { load = { start = 90, knots = { 0, 1 } } }, data = { one } }, "only k, alpha",
  "a curve of a setting that has no curve")
refused({ unknown = { law_exponent = 1 }, data = { three } }, "'law_exponent' has no effect",
  "an unknown without effect")
refused({ unknown = { k = 1e-8 }, data = { { of = "volume", distance = 220, value = { 1, 2 } } } },
  { "data[1].value", "expected 1 numbers", "got 2" }, "more values than distances")
refused({ unknown = { k = 1e-8 }, data = { { of = "volum", distance = 220, value = 1 } } }, "data[1].of",
  "an unknown measured quantity")
refused({ unknown = { k = 1e-8 }, data = { one, { of = "half_width", distance = 220, value = 0.1 } } },
  { "data[2]", "error" }, "several kinds of measurements without errors")
refused({ unknown = { k = 1e-8 }, data = { { body = "plate", distance = 220, error = 1e-9,
  x = { -0.2, -0.1, 0, 0.1, 0.2 }, h = { 1e-8, 2e-7, 3e-7, 2e-7, 1e-8 } } } }, "are they in m?",
    "depths given in m")
refused({ unknown = { k = 1e-8 }, data = { { body = "plate", distance = 220, error = 1e-5,
  x = { -200, -100, 0, 100, 200 }, h = { 1e-5, 2e-4, 3e-4, 2e-4, 1e-5 } } } }, "expected x in mm",
    "positions given in um")
refused({ unknown = { k = 1e-8 } }, "'data'", "a fit without data")

-- --- design --------------------------------------------------------------------------------------
local d = fit.design{ base = base, unknown = unknown, measure = {
  { profile = "cylinder", distance = { 110, 220 }, error = 5e-5 }, { of = "volume", distance = 220, relative = 0.03 },
  { of = "volume_plate", distance = 220, relative = 0.03 } } }
is(#d.alone, 4, "each measurement at each distance is evaluated alone")
ok(d.alone[2].error.alpha < d.alone[1].error.alpha, "a deeper scar has a smaller standard error")
near(d.alone[3].error.k, 1e-8 / math.sqrt(1 + 1 / 0.03 ^ 2), 1e-4,
  "standard error of k from the volume alone")
near(d.alone[3].error.alpha, 1 / math.sqrt(12), 1e-4, "the volume does not determine alpha")
is(#d.best, 3, "the best order of measurements")
ok(d.all.k <= d.best[3].error.k, "all measurements together have the smallest error")
holds(tostring(d), { "undetermined", "best", "together" }, "print(d)")
holds(d:table(), { "measurement,distance [mm],error of alpha", "volume_plate,220" }, "the result as a table")
fails(function() fit.design{ unknown = unknown, measure = { { of = "volume", distance = 1 } } } end,
  { "measure[1]", "error" }, "a planned measurement without an error")

-- Tests designs with measured widths. A computed width changes in steps from node to node, so derivatives
-- with respect to k need a wide range. With a quarter of the element size the standard errors of k from single
-- widths are 30, 28, 29 and 40 %, on the default mesh 27, 30, 27 and 29 %. Derivatives over the narrower range of a
-- fit would scatter more.
local widths = fit.design{ base = { stroke = 0.22, jump = 50 }, unknown = unknown,
  measure = { { of = "width", distance = { 150, 300, 660, 1320 }, relative = 0.02 } } }
for _, one in ipairs(widths.alone) do
  ok(one.error.k > 0.26e-8 and one.error.k < 0.39e-8,
    ("standard error of k from the width at %g mm: %.2g"):format(one.distance, one.error.k))
end

-- --- pictures ------------------------------------------------------------------------------------
for name, draw in pairs{ fit = function(o) plot.fit(f, o) end, design = function(o) plot.fit(d, o) end,
  curves = function(o) plot.fit(h, { curves = true, file = o.file }) end } do
  draw{ file = file .. ".svg" }
  local opened = io.open(file .. ".svg")
  holds(opened:read "a", "</svg>", "a picture of a " .. name)
  opened:close()
  os.remove(file .. ".svg")
end
local width = fit{ base = base, unknown = { k = 1e-8 }, data = { { of = "width", distance = { 110, 220 },
  value = { 0.23, 0.24 }, error = 0.01 } } }
plot.fit(width, { file = file .. ".gp" })
local script = io.open(file .. ".gp")
local commands = script:read "a"
holds(commands, '"width / mm"', "picture of a quantity that is not in the history")
holds(commands, "filledcurves closed", "the band is a closed area")
script:close()
os.remove(file .. ".gp")
fails(function() plot.fit({}) end, "expected a result of fit{}", "plot.fit of an empty table")

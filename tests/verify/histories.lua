-- Tests histories against exact results. On a plate that stays flat, runs with varying k and alpha depend
-- only on k_c d, the cylinder's coefficient times the distance. Volumes equal the integral of k times load,
-- and equivalent inputs give identical bits.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, about, below, ok = figures.within, figures.about, figures.below, figures.ok

local p_h = hertz{}.p_max

-- Reference values for a flat plate and any history of k: k_c d [mm2/N mm], centre pressure / p_H, depth
-- [um].
local rows = {
  { 1.1e-6, 0.7222, 0.5498 }, { 3.3e-6, 0.5048, 1.3195 },
  { 6.6e-6, 0.3962, 2.1816 }, { 1.32e-5, 0.3132, 3.5407 },
}

local function check(w, row, what)
  what = ("%s, k_c d = %g"):format(what, row[1])
  within(w.p_center / p_h, row[2], 0.01, what .. ": centre pressure / p_H")
  within(1000 * w.depth.cylinder, row[3], 3e-3, what .. ": depth [um]")
end

local function same_bits(a, b, what)
  local same = a.p_center == b.p_center and a.volume.total == b.volume.total
  for _, body in ipairs{ "cylinder", "plate" } do
    local left, right = a:profile(body).h, b:profile(body).h
    same = same and #left == #right
    for i, h in ipairs(left) do same = same and h == right[i] end
  end
  return ok(same, what .. ": identical bits")
end

-- --- k in time --------------------------------------------------------------------------------------

-- Tests a ramp of k from 0: with k = 2e-8 d / 1320 the product k_c d is 1e-8 d^2 / 1320.
local ramps = {
  { "a ramp of k by a table", { distance = { 0, 1320 }, value = { 0, 2e-8 } } },
  { "a ramp of k by a function", function(s) return 2e-8 * s.distance / 1320 end },
}
for _, ramp in ipairs(ramps) do
  local w = wear{ alpha = 1, k = ramp[2], jump = 5 }
  for _, row in ipairs(rows) do
    w:run{ distance = math.sqrt(row[1] * 1320 / 1e-8) }
    check(w, row, ramp[1])
    within(w.volume.total, row[1] * 100, 1e-9, ramp[1] .. ": volume [mm3]")
  end
end

-- Tests a coefficient that depends on the worn volume: dV/dd = k0 (1 - V / V1) L has the solution V = V1 (1 -
-- exp(-k0 L d / V1)). The integration along the predicted state is accurate for any step.
for _, jump in ipairs{ 200, 100, 50 } do
  local v1 = 1e-3
  local w = wear{ jump = jump, k = function(s) return 1e-8 * (1 - s.volume.total / v1) end, scheme = "implicit" }:run()
  local off = math.abs(w.volume.total / (v1 * (1 - math.exp(-1e-8 * 100 * 1320 / v1))) - 1)
  below(off, 1e-6, ("k that decreases with the volume, jump = %d: error of the volume"):format(jump))
end

-- Tests coefficients with steps, running-in and dependence on the cycle. The volume is the integral of k
-- times the load, with given or automatic updates, and the pressure never exceeds the unworn pressure.
local function steep(below_d, above_d, at)
  return { distance = { 0, at - 0.001, at + 0.001, 1320 }, value = { below_d, below_d, above_d, above_d } }
end
local function switched_k(below_d, above_d, at)
  return function(s) return s.distance < at and below_d or above_d end
end
local histories_of_k = { -- each row: name, k, its integral [mm3/N], tolerance, other fields
  { "0, then 1e-8 at 600 mm", switched_k(0, 1e-8, 600), 7.2e-6, 1e-6 },
  { "0, then 1e-8 at 600 mm, by a table", steep(0, 1e-8, 600), 7.2e-6, 1e-9 },
  { "0, then 1e-8, by two values at 600 mm",
    { distance = { 0, 600, 600, 1320 }, value = { 0, 0, 1e-8, 1e-8 } }, 7.2e-6, 1e-9 },
  { "of slopes with small and large steps", { distance = { 200, 200, 500, 500, 900, 900 },
    value = { 1e-8, 1.02e-8, 2e-8, 0, 1e-8, 0.95e-8 } }, 2e-6 + 4.53e-6 + 2e-6 + 3.99e-6, 1e-7 },
  { "1e-9, then 3e-8 at 333 mm", switched_k(1e-9, 3e-8, 333), 0.333e-6 + 29.61e-6, 1e-6 },
  { "1e-9, then 3e-8 at 333 mm, by a table", steep(1e-9, 3e-8, 333), 0.333e-6 + 29.61e-6, 1e-9 },
  { "tenfold, running in over 5 mm", function(s) return 1e-8 * (1 + 9 * math.exp(-s.distance / 5)) end,
    1e-8 * (1320 + 45 * (1 - math.exp(-264))), 1e-6 },
  { "as a function of the cycle, updates at increments", function(s) return 1e-8 * (1 - s.cycle / 12000) end,
    9.9e-6, 1e-6,
    { update = "increment", increments = 20 } },
}
for _, row in ipairs(histories_of_k) do
  for _, jump in ipairs{ "auto", 40 } do
    local fields = { k = row[2], jump = jump }
    for name, value in pairs(row[5] or {}) do fields[name] = value end
    local run = wear(fields):run()
    local what = ("k %s, jump = %s"):format(row[1], jump)
    within(run.volume.total, 100 * row[3], row[4], what .. ": volume [mm3]")
    below(math.max(table.unpack(run.history.p_max)) / p_h, 1.001,
      what .. ": largest pressure of the run / p_H")
  end
end

-- --- alpha over the distance ------------------------------------------------------------------------

-- Tests alpha switched from 1 to 0.25 at 440 mm with a stroke over the whole plate: k_c d is 1e-8 d, then
-- increases by 0.25e-8 d.
local switched = wear{ stroke = 20, jump = 0.1, alpha = function(s) return s.distance < 440 and 1 or 0.25 end,
  distance = 3960 }
switched:run{ distance = 330 }
check(switched, rows[2], "alpha switched, before the switch")
switched:run{ distance = 440 + (rows[3][1] - 4.4e-6) / 0.25e-8 }
check(switched, rows[3], "alpha switched, after the switch")
switched:run()
check(switched, rows[4], "alpha switched, end of the run")
within(switched.volume.cylinder, 1.32e-3, 1e-9, "alpha switched: volume of the cylinder [mm3]")
within(switched.volume.plate, 0.75e-6 * 3520, 1e-9, "alpha switched: volume of the plate [mm3]")

-- Tests that the switch by w:set, by a function and by tables with a step gives the same result if updates
-- end at the step.
local function step_at(s) return s.distance < 440 and 0.25 or 0.75 end
local by_function = wear{ alpha = step_at, jump = 100 }:run()
local by_set = wear{ alpha = 0.25, jump = 100 }:run{ distance = 440 }:set{ alpha = 0.75 }:run()
same_bits(by_function, by_set, "alpha switched by a function and by set")
within(by_set.volume.cylinder, 1e-6 * (0.25 * 440 + 0.75 * 880), 1e-9,
  "alpha switched by set: volume of the cylinder [mm3]")
local by_worn = wear{ alpha = 0.75, jump = 100, worn = wear{ alpha = 0.25, jump = 100 }:run{ distance = 440 }, distance = 880 }:run()
ok(by_worn.p_center == by_set.p_center and by_worn.depth.plate == by_set.depth.plate,
  "alpha switched by set and by a run from the worn shape: identical bits")

-- --- load and motion over the cycle -----------------------------------------------------------------

local function triangle(t) return 0.055 * (4 * math.abs(t - 0.5) - 1) end
local function saw(t) return 100 + 60 * math.sin(2 * math.pi * t) end

-- Tests the reciprocating stroke against the same stroke given as a loading.
local plain = wear{}:run()
local written = wear{ loading = { x = triangle } }:run()
within(written.depth.cylinder, plain.depth.cylinder, 1e-6, "a stroke as a loading: depth of the cylinder [mm]")
within(written.depth.plate, plain.depth.plate, 1e-6, "a stroke as a loading: depth of the plate [mm]")
within(written.p_center, plain.p_center, 1e-6, "a stroke as a loading: centre pressure [MPa]")

-- Returns the integral of the load over the motion, with the mean load of both ends of each increment (Eq.
-- 4). The volume is k times this integral.
local function integral(block)
  local sum = 0
  for i = 2, #block.x do
    sum = sum + (block.load[i] + block.load[i - 1]) / 2 * math.abs(block.x[i] - block.x[i - 1])
  end
  return sum
end
for _, scheme in ipairs{ "explicit", "implicit" } do
  local w = wear{ loading = { x = triangle, load = saw, increments = 60 }, cycles = 2000, scheme = scheme }:run()
  within(w.volume.total, 1e-8 * 2000 * integral(w.loading[1]), 1e-9, "load over the cycle, " .. scheme .. ": volume [mm3]")
  within(w.volume.cylinder, w.volume.total / 2, 1e-9,
    "load over the cycle, alpha = 0.5: half of the volume [mm3]")
  -- the load is 100 + 60 in one direction and 100 - 60 in the other: the mirrored loading is the same history
  -- in reverse
  local mirrored = wear{ loading = { x = function(t) return -triangle(t) end, load = saw, increments = 60 },
    cycles = 2000, scheme = scheme }:run()
  local h, g, worst = w:profile("plate").h, mirrored:profile("plate").h, 0
  for i, depth in ipairs(h) do worst = math.max(worst, math.abs(depth - g[#g + 1 - i])) end
  below(worst / w.depth.plate, 1e-9, "mirrored loading, " .. scheme .. ": difference of the profiles")
end

-- Tests functions against the same functions sampled as lists, with and without times.
local t, x, load = {}, {}, {}
for i = 0, 50 do t[i + 1], x[i + 1], load[i + 1] = i / 50, triangle(i / 50), saw(i / 50) end
local by_functions = wear{ loading = { x = triangle, load = saw, increments = 50 }, cycles = 1000 }:run()
same_bits(by_functions, wear{ loading = { x = x, load = load }, cycles = 1000 }:run(), "functions and lists")
same_bits(by_functions, wear{ loading = { t = t, x = x, load = load }, cycles = 1000 }:run(), "functions and timed lists")

-- Tests a load that vanishes during one direction, on a flat plate: half of the distance wears.
local lifted = wear{ alpha = 1, jump = 5, distance = 2640,
  loading = { x = triangle, load = function(at) return at < 0.5 and 100 or 0 end } }
for _, row in ipairs(rows) do
  -- By Eq. (4) an increment uses the mean of the loads at both ends. The load vanishes within one increment,
  -- whose mean is half of the load, so the mean load of the cycle is 49.5 of 100 N/mm.
  lifted:run{ distance = row[1] / 1e-8 / 0.495 }
  check(lifted, row, "no load in one direction")
end

-- Tests that increments are adapted to the contact: two end points define a stroke, and a long stroke wears
-- the plate uniformly.
local three_points = wear{ loading = { x = { -0.11, 0.11, -0.11 } }, distance = 660, jump = 50 }:run()
local stroke = wear{ stroke = 0.22, increments = 400, distance = 660, jump = 50 }:run()
within(three_points.depth.plate, stroke.depth.plate, 2e-3, "a stroke by its ends: depth of the plate [mm]")
within(three_points.depth.cylinder, stroke.depth.cylinder, 2e-3, "a stroke by its ends: depth of the cylinder [mm]")
within(three_points.p_center, stroke.p_center, 1e-2, "a stroke by its ends: centre pressure [MPa]")
local long = wear{ stroke = 12, scheme = "explicit", geometry = "frozen" }:run()
-- in the middle the whole pressure profile passes over each node once per stroke: depth = k_p L d / stroke
local scar = long:profile("plate").h
within(scar[#scar // 2 + 1], 0.5e-8 * 100 * 1320 / 12, 2e-3, "a stroke of 12 mm: depth of the plate [mm]")
within(long.depth.plate, 0.5e-8 * 100 * 1320 / 12, 5e-3, "a stroke of 12 mm: largest depth of the plate [mm]")

-- --- blocks of loading --------------------------------------------------------------------------------

local first = { x = triangle, load = 120, cycles = 1500, increments = 40 }
local second = { x = function(at) return 1.6 * triangle(at) end, load = saw, cycles = 700, increments = 60 }
local bodies = model{ mesh = { zone = { cylinder = 1, plate = 1.4 } } }
local function blocks(loading, more)
  local fields = { model = bodies, load = 100, loading = loading, jump = 100 }
  for name, value in pairs(more or {}) do fields[name] = value end
  return wear(fields)
end
local both = blocks({ first, second }):run()
same_bits(both, blocks({ first }):run():set{ loading = { second } }:run(),
  "two blocks, and a w:set between them")
local apart = blocks({ second }, { worn = blocks({ first }):run() }):run()
ok(apart.depth.cylinder == both.depth.cylinder and apart.p_center == both.p_center,
  "two blocks, and a run from the worn shape: identical bits")
within(both.volume.total, 1e-8 * (1500 * integral(both.loading[1]) + 700 * integral(both.loading[2])), 1e-9,
  "two blocks: volume [mm3]")
ok(both.cycle == 2200, "two blocks: number of cycles")

-- --- updates at every increment -----------------------------------------------------------------------

local wave = { t = {}, x = {}, load = {} }
for i = 0, 20 * 50 do
  wave.x[i + 1], wave.load[i + 1] = triangle(i % 50 / 50), saw(i % 50 / 50)
end
wave.t = nil
wave.periodic = false
local generic = wear{ k = 1e-6, loading = wave, load = 100 }:run()
local continuous = wear{ k = 1e-6, load = 100, loading = { x = triangle, load = saw, increments = 50, cycles = 20 },
  update = "increment", jump = 1 }:run()
ok(generic.update == 1000 and continuous.update == 1000,
  "20 cycles of 50 increments: 1000 updates in both runs")
within(generic.volume.total, 1e-6 * 20 * integral(continuous.loading[1]), 1e-9,
  "a loading that is not periodic: volume [mm3]")
within(continuous.volume.total, generic.volume.total, 1e-6, "updates within the cycle: volume [mm3]")
for _, body in ipairs{ "cylinder", "plate" } do
  within(generic.depth[body], continuous.depth[body], 5e-4,
    "updates within the cycle: depth of the " .. body .. " [mm]")
end
within(generic.p_center, continuous.p_center, 2e-3, "updates within the cycle: centre pressure [MPa]")

-- --- local factors --------------------------------------------------------------------------------------

-- Compares a power of the pressure given as a wear law with the same power given as a local factor. The results
-- differ slightly: the law uses a common pressure for each pair of opposite points, the factor uses the nodal
-- pressures of each body, whose nodes are not opposite to each other.
local function law_and_factor(alpha)
  local law = wear{ alpha = alpha, law = "power", law_pressure = 300, law_exponent = 0.5, distance = 440, jump = 100 }:run()
  local factor = wear{ alpha = alpha, local_factor = function(_, _, p) return (p / 300) ^ 0.5 end, distance = 440, jump = 100 }:run()
  return law, factor
end
local law, factor = law_and_factor(1)
within(factor.depth.cylinder, law.depth.cylinder, 1e-12,
  "a power law and the same local factor, alpha = 1: depth [mm]")
law, factor = law_and_factor(0.5)
within(factor.depth.cylinder, law.depth.cylinder, 3e-3,
  "a power law and the same local factor, alpha = 0.5: depth of the cylinder [mm]")
within(law.volume.plate, law.volume.cylinder, 1e-12,
  "power law: volumes in the ratio of the coefficients, Eq. (15) [mm3]")
-- Tests that a factor for each body equals a k for each body.
local bodies_factor = wear{ alpha = 0.5, distance = 440,
  local_factor = function(body) return body == "plate" and 0.5 or 1.5 end }:run()
local by_alpha = wear{ alpha = 0.75, distance = 440, scheme = "explicit" }:run()
within(bodies_factor.depth.plate, by_alpha.depth.plate, 1e-9,
  "local factors of the bodies against alpha: depth [mm]")

-- Computes k and alpha from measured largest depths. Simulations are repeated until the sum of both depths
-- and the cylinder's share of this sum equal the measured values. The search uses Broyden's method with the
-- unknowns ln k and alpha.

local check = require "archard.lib.check"
local run_counter = require "archard.lib.run_counter"
local statistics = require "archard.lib.statistics"

local depths = {}

local where = "calibrate"
local first_k = 1e-8        -- initial value of k in the search [mm2/N]
-- Largest plausible k [mm2/N], larger than the k of all known sliding pairs. If depths need a larger k, they
-- are probably not in mm.
local largest_k = 1e-5
local most_runs, farthest = 40, 5 -- largest number of runs in a search; largest step of ln k
local agreement = 0.05      -- relative tolerance of the simulated sum of depths, if the user gives k

-- --- one run ---------------------------------------------------------------------------------------

-- Returns the conditions of a run as a list of texts: motion and load, bodies, materials.
local function conditions(run)
  local text = tostring(run)
  return { text:match "^wear: ([^\n]*)", text:match "\n  bodies +([^\n]*)", text:match "\n  materials +([^\n]*)" }
end

-- Simulates a run with the given k and alpha. Returns the sum of both depths [mm], the cylinder's share of
-- this sum, and the conditions of the run.
local function simulate(fields, k, alpha, counter)
  local of_run = { alpha = alpha, k = k }
  for name, value in pairs(fields) do of_run[name] = of_run[name] or value end
  local run <close> = wear(of_run)
  run:run{ progress = function() end }
  counter:ran()
  return run.depth.cylinder + run.depth.plate, run.depth_partition, conditions(run)
end

-- Raises an error if the measured depths need an unrealistically large k, because the depths are then
-- probably not in mm.
local function check_unit(sum, simulated, k)
  local needed = k * (sum / simulated) ^ 1.5 -- the worn volume grows as about h^1.5
  if needed <= largest_k then return end
  check.fail(where, ("field 'depth': the sum of both depths, %.4g mm, would need a k of about %.1g mm2/N: "
    .. "expected depths in mm (are they in um?)"):format(sum, needed))
end

-- --- the search ------------------------------------------------------------------------------------

-- Returns the initial inverse Jacobian of the two residuals. It assumes that depths are proportional to
-- k^(2/3), and that the cylinder's share changes as much as alpha. The row and column of a fixed unknown are
-- zero.
local function begin_inverse(seeks)
  return { { seeks[1] and 1.5 or 0, 0 }, { 0, seeks[2] and 1 or 0 } }
end

-- Applies Broyden's update to the inverse Jacobian `h` after a step `dx`, which changed the residuals by
-- `df`.
local function update(h, dx, df)
  local to = { h[1][1] * df[1] + h[1][2] * df[2], h[2][1] * df[1] + h[2][2] * df[2] }
  local from = { dx[1] * h[1][1] + dx[2] * h[2][1], dx[1] * h[1][2] + dx[2] * h[2][2] }
  local size = dx[1] * to[1] + dx[2] * to[2]
  if size == 0 then return end
  for i = 1, 2 do
    for j = 1, 2 do h[i][j] = h[i][j] + (dx[i] - to[i]) * from[j] / size end
  end
end

-- Returns the next step of ln k and alpha. Alpha moves by at most nine tenths of its distance to 0 or 1.
local function step_from(x, h, f)
  local of_k = -(h[1][1] * f[1] + h[1][2] * f[2])
  local of_alpha = -(h[2][1] * f[1] + h[2][2] * f[2])
  return { math.max(-farthest, math.min(of_k, farthest)),
    math.max(-0.9 * x[2], math.min(of_alpha, 0.9 * (1 - x[2]))) }
end

-- Searches for k and alpha for which a run has the target depths. target: { sum= [mm], share= }; start: { ln
-- k, alpha }; options: fields (of wear{}), fixed (the user's k, or nil), accuracy, counter. Returns { k=,
-- alpha=, sum= (simulated, [mm]), runs=, x= (ln k and alpha), conditions= }.
local function search(target, start, options)
  local within = target.share > 0 and target.share < 1
  local seeks = { not options.fixed, within }
  local x = { start[1], within and math.min(math.max(start[2], 1e-3), 1 - 1e-3) or target.share }
  local h, dx, before = begin_inverse(seeks), nil, nil
  for run = 1, most_runs do
    local k = options.fixed or math.exp(x[1])
    local sum, share, under = simulate(options.fields, k, x[2], options.counter)
    if run == 1 and not options.fixed then check_unit(target.sum, sum, k) end
    options.counter:better(("k %.4g, alpha %.4g"):format(k, x[2]))
    local f = { seeks[1] and math.log(sum / target.sum) or 0, seeks[2] and share - target.share or 0 }
    if math.max(math.abs(f[1]), math.abs(f[2])) <= options.accuracy then
      return { k = k, alpha = x[2], sum = sum, runs = run, x = x, conditions = under }
    end
    if before then update(h, dx, { f[1] - before[1], f[2] - before[2] }) end
    dx, before = step_from(x, h, f), f
    x = { x[1] + dx[1], x[2] + dx[2] }
  end
  check.fail(where, ("no k and alpha found that give the measured depths (sum of both depths %.4g mm, depth of the "
    .. "cylinder / this sum = %.3g)"):format(target.sum, target.share), "NOT_CONVERGED")
end

-- --- all measurements ------------------------------------------------------------------------------

-- Raises an error if, with the user's k, the sum of the simulated depths differs from the measured sum by
-- more than the tolerance.
local function refuse_k(found, sum)
  if math.abs(found.sum / sum - 1) <= agreement then return end
  check.fail(where, ("field 'k': with this k the sum of both depths is %.4g mm, but the measured sum is %.4g mm; "
    .. "without the field, k is computed, too"):format(found.sum, sum))
end

-- Searches for k and alpha of each test separately. Returns their standard deviations over the tests, and the
-- number of runs.
local function spreads(cylinder, plate, from, options)
  local k, alpha, runs = {}, {}, 0
  for i, c in ipairs(cylinder) do
    local one = search({ sum = c + plate[i], share = c / (c + plate[i]) }, from.x, options)
    k[i], alpha[i], runs = one.k, one.alpha, runs + one.runs
  end
  return { k = not options.fixed and statistics.deviation(k) or nil, alpha = statistics.deviation(alpha) }, runs
end

-- Computes k and alpha from measured depths. cylinder, plate: depths of both bodies [mm], lists of equal
-- length. options: accuracy and fields (of wear{}; a k given there is not changed). Returns the fields of a
-- calibration.
function depths.find(cylinder, plate, options)
  local c, p = statistics.mean(cylinder), statistics.mean(plate)
  local share = c / (c + p)
  local counter <close> = run_counter.new(where, 6 * (#cylinder > 1 and #cylinder + 1 or 1))
  options = { fields = options.fields, accuracy = options.accuracy, fixed = options.fields.k, counter = counter }
  local found = search({ sum = c + p, share = share }, { math.log(first_k), share }, options)
  if options.fixed then refuse_k(found, c + p) end
  local k = not options.fixed and found.k or nil
  local result = { alpha = found.alpha, k = k, k_cylinder = k and k * found.alpha, k_plate = k and k * (1 - found.alpha),
    depth_partition = share, runs = found.runs, simulated_depth = found.sum, measured_depth = c + p, spread = {},
    conditions = found.conditions, measurements = #cylinder }
  if #cylinder > 1 then
    local runs
    result.spread, runs = spreads(cylinder, plate, found, options)
    result.runs = result.runs + runs
  end
  return result
end

return depths

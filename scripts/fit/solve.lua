-- The search for the best parameters of a problem, and how sure they are: standard errors,
-- correlations, what the data cannot tell, and the weight of smoothness by cross-validation. Leans on
-- archard.least_squares.

local check = require "archard.lib.check"
local least_squares = require "archard.least_squares"
local unknown = require "archard.fit.unknown"

local solve = {}

local most, small = 60, 1e-4 -- iterations; the last step, over what a variable can do

-- --- linear algebra of columns -------------------------------------------------------------------

local function flat_of(columns, scales)
  local flat, p = {}, #columns
  for j, column in ipairs(columns) do
    for i = 1, #column do flat[(i - 1) * p + j] = column[i] * (scales and scales[j] or 1) end
  end
  return flat
end

local function norm(list)
  local sum = 0
  for _, value in ipairs(list) do sum = sum + value * value end
  return math.sqrt(sum)
end

-- Singular values of columns brought to length 1: u, s, v flat row by row, and the lengths.
local function decompose(columns)
  local scales, lengths = {}, {}
  for j, column in ipairs(columns) do
    lengths[j] = norm(column)
    scales[j] = lengths[j] > 0 and 1 / lengths[j] or 0
  end
  local u, s, v = least_squares.svd{ a = flat_of(columns, scales), rows = #columns[1],
    columns = #columns }
  return { u = u, s = s, v = v, scales = scales, rows = #columns[1], size = #columns }
end

-- What is seen as 0 next to the largest singular value: derivatives by differences are not better.
local blind = 1e-5

-- Covariance of the parameters of columns; `unseen` lists the directions that the data do not see,
-- each a list of the parameters in it.
function solve.covariance(columns)
  local d = decompose(columns)
  local p, covariance, unseen = d.size, {}, {}
  for a = 1, p do
    covariance[a] = {}
    for b = 1, p do covariance[a][b] = 0 end
  end
  for k = 1, p do
    if d.s[k] <= blind * d.s[1] or d.s[k] == 0 then
      local list = {}
      for a = 1, p do
        if math.abs(d.v[(a - 1) * p + k]) > 0.2 then list[#list + 1] = a end
      end
      unseen[#unseen + 1] = list
    else
      for a = 1, p do
        for b = 1, p do
          covariance[a][b] = covariance[a][b] + d.v[(a - 1) * p + k] * d.v[(b - 1) * p + k]
            / d.s[k] ^ 2 * d.scales[a] * d.scales[b]
        end
      end
    end
  end
  return covariance, unseen
end

-- --- the search ----------------------------------------------------------------------------------

local function values_of(parameters, u)
  local values, slopes = {}, {}
  for i, one in ipairs(parameters) do values[i], slopes[i] = unknown.value(one, u[i]) end
  return values, slopes
end

-- What a run that fails on the way stands for: worse than the start, so that the step is shortened.
local function beyond_all(list)
  local far = {}
  for i = 1, #list do far[i] = 1e3 * (1 + norm(list)) end
  return far
end

-- Keeps the best values so far, for those who end the search.
local function keep_best(problem, values, residuals)
  local chi2 = norm(residuals) ^ 2
  if chi2 >= (problem.least or math.huge) then return end
  problem.least = chi2
  local best = { value = {}, chi2 = chi2, runs = problem.runs.count }
  for i, one in ipairs(problem.unknowns) do best.value[one.name] = values[i] end
  require "archard.fit".best = best
  problem.runs.counter:better(solve.shown(problem, values), "fit.best")
end

-- Searches from where each parameter's `start` is; returns the values and the iterations. With
-- derivatives to one side, which cost half as many runs, unless told otherwise.
local function search(problem, central)
  local parameters, first, far = problem.parameters, {}, nil
  for i = 1, #parameters do first[i] = 1 end
  local function residuals(at)
    local values = values_of(parameters, at)
    if not far then
      local list = problem:residuals(values)
      keep_best(problem, values, list)
      far = beyond_all(list)
      return list
    end
    local fine, list = pcall(problem.residuals, problem, values)
    if not fine and list.code == "STOPPED" then error(list, 0) end
    if fine then keep_best(problem, values, list) end
    return fine and list or far
  end
  local u, iterations = least_squares.solve{ x = first, iterations = most, tolerance = small,
    count = #problem.measured + #problem.rough,
    residuals = residuals,
    jacobian = function(at)
      local values, slopes = values_of(parameters, at)
      return flat_of(problem:with_roughness(problem:jacobian(values, central)), slopes)
    end }
  return values_of(parameters, u), iterations
end

-- How far the next step would go, over the standard errors, among parameters off their bounds; and the step.
local function unfinished(problem, values, columns, covariance)
  local residuals, gradient, worst, name, steps = problem:smoothed_residuals(values), {}, 0, nil, {}
  for j, column in ipairs(columns) do
    gradient[j] = 0
    for i, value in ipairs(column) do gradient[j] = gradient[j] + value * residuals[i] end
  end
  for a, row in ipairs(covariance) do
    local step = 0
    for b, value in ipairs(row) do step = step + value * gradient[b] end
    steps[a] = -step
    local off = row[a] > 0 and math.abs(step) / math.sqrt(row[a]) or 0
    if off > worst and not problem.parameters[a].bound then worst, name = off, problem.parameters[a].name end
  end
  return worst, name, steps
end

-- Marks parameters at their bounds, whose derivatives say nothing about the others' errors.
local function mark_bounds(problem, values)
  for i, one in ipairs(problem.parameters) do one.bound = unknown.at_bound(one, values[i]) end
end

local function without_bounds(problem, columns)
  local kept = {}
  for i, column in ipairs(columns) do
    local zero = {}
    for r = 1, #column do zero[r] = 0 end
    kept[i] = problem.parameters[i].bound and zero or column
  end
  return kept
end

local function finish(problem, values, iterations)
  mark_bounds(problem, values)
  local columns = problem:with_roughness(problem:jacobian(values, true))
  local covariance, unseen = solve.covariance(without_bounds(problem, columns))
  local worst, name, step = unfinished(problem, values, columns, covariance)
  return { values = values, columns = columns, covariance = covariance, unseen = unseen,
    iterations = iterations, off = worst, off_name = name, step = step }
end

-- How far the next step may go, over the standard errors: else derivatives to both sides are used,
-- and with those the noise of runs is allowed for.
local enough, tolerable = 0.1, 0.3

-- Values that jump from node to node stop the search at any of them: from there on steps go by the lines
-- through what they say.
local polishing = 8

local function polish(problem, found, beyond)
  local left = polishing
  while left > 0 and next(problem.rippled) and beyond(found, enough) do
    local values = {}
    for i, one in ipairs(problem.parameters) do
      values[i] = unknown.inside(one, found.values[i], one.bound and 0 or found.step[i])
    end
    found = finish(problem, values, found.iterations + 1)
    left = left - 1
  end
  return found
end

local function from(problem, values)
  for i, one in ipairs(problem.parameters) do
    local inside = not unknown.at_bound(one, values[i])
    one.start = inside and values[i] or one.start
  end
end

local function refuse_unsettled(problem, found)
  check.fail(problem.where, ("no convergence: after %d iterations %s is still %.2g standard errors from "
    .. "where it would go next (now %s). Start nearer, fix an unknown that the data hardly tell, or "
    .. "give steps that do not depend on the values (a fixed jump)"):format(found.iterations,
    found.off_name, found.off, solve.shown(problem, found.values)), "NOT_CONVERGED")
end

-- Searches, and once more from where it ended if that was too early. Where residuals are larger than
-- the errors given, standard errors are too small a measure.
local function settle(problem)
  local function beyond(found, limit)
    return found.off > limit and found.off > limit * problem:error_scale(found.values)
  end
  local found = finish(problem, search(problem))
  if not beyond(found, enough) then return found end
  from(problem, found.values)
  local before = found.iterations
  found = finish(problem, search(problem, true))
  found.iterations = found.iterations + before
  found = polish(problem, found, beyond)
  if beyond(found, tolerable) and #found.unseen == 0 then refuse_unsettled(problem, found) end
  return found
end

function solve.shown(problem, values)
  local words = {}
  for i, one in ipairs(problem.unknowns) do words[i] = ("%s %.5g"):format(one.name, values[i]) end
  return table.concat(words, ", ")
end

-- --- smoothness by cross-validation ---------------------------------------------------------------

-- The error in predicting each value from all others, to first order about a fit: residual over what
-- the value does not decide itself. `columns` without roughness.
local function left_out(problem, columns, residuals, values, weight)
  local before = problem.smooth
  problem:smooth_by(weight)
  local rough = problem:with_roughness(columns)
  local n, all = #problem.measured, table.move(residuals, 1, #residuals, 1, {})
  for r, row in ipairs(problem.rough) do
    all[n + r] = 0
    for j, factor in pairs(row) do all[n + r] = all[n + r] + math.sqrt(weight) * factor * values[j] end
  end
  local d, sum = decompose(rough), 0
  local p, along = d.size, {}
  for k = 1, p do
    along[k] = 0
    for i = 1, #all do along[k] = along[k] + d.u[(i - 1) * p + k] * all[i] end
  end
  for i = 1, n do
    local rest, leverage = all[i], 0
    for k = 1, p do
      local u = d.u[(i - 1) * p + k]
      rest, leverage = rest - u * along[k], leverage + u * u
    end
    sum = sum + (rest / math.max(1e-9, 1 - leverage)) ^ 2
  end
  for _, column in ipairs(columns) do
    for i = #column, n + 1, -1 do column[i] = nil end
  end
  problem:smooth_by(before)
  return sum / n
end

-- The weight of roughness that predicts best, of a row of them.
local function choose_weight(problem, found)
  problem:smooth_by(0)
  local residuals, columns = problem:residuals(found.values), problem:jacobian(found.values, true)
  local best, least = 0, math.huge
  for exponent = -4, 14 do
    local weight = 10 ^ (exponent / 2)
    local score = left_out(problem, columns, residuals, found.values, weight)
    if score < least then best, least = weight, score end
  end
  return best
end

-- --- all of it -----------------------------------------------------------------------------------

-- weight: of roughness, or "auto"; told: whether the data have their own errors
function solve.fit(problem, weight, told)
  local start = {}
  for i, one in ipairs(problem.parameters) do start[i] = one.start end
  problem:measure_noise(start)
  keep_best(problem, start, problem:residuals(start))
  problem:measure_ripple(start, told)
  problem:refuse_idle(problem:jacobian(start))
  problem:smooth_by(weight == "auto" and 1e-2 or weight)
  local found = settle(problem)
  if weight == "auto" then
    local chosen = choose_weight(problem, found)
    problem:smooth_by(chosen)
    from(problem, found.values)
    local before = found.iterations
    found = settle(problem)
    found.iterations = found.iterations + before
  end
  return found
end

return solve

-- Searches for the best parameters of a fit. Computes standard errors, correlations and undetermined
-- combinations of parameters, and chooses the weight of smoothness by cross-validation.

local check = require "archard.lib.check"
local least_squares = require "archard.least_squares"
local unknown = require "archard.fit.unknown"

local solve = {}

-- most: largest number of iterations; small: the search ends at steps below this fraction of a parameter's
-- typical range.
local most, small = 60, 1e-4

-- --- decomposition and covariance ----------------------------------------------------------------

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

-- Scales the columns to length 1 and returns their singular value decomposition: u, s and v as flat lists,
-- row by row, and the scale factors.
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

-- Singular values below this fraction of the largest one are treated as 0, because finite differences are
-- not more accurate than that.
local blind = 1e-5

-- Returns the covariance of the parameters for unit errors of the data, and a list of the combinations of
-- parameters that the data do not determine. Each combination is a list of parameter indices.
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

-- Returns the residuals that represent a failed run. They are much larger than the residuals `list` at the
-- start, so that the search shortens its step.
local function residuals_of_failure(list)
  local far = {}
  for i = 1, #list do far[i] = 1e3 * (1 + norm(list)) end
  return far
end

-- Stores the best values up to now in fit.best, where they remain available if the fit is interrupted.
local function keep_best(problem, values, residuals)
  local chi2 = norm(residuals) ^ 2
  if chi2 >= (problem.least or math.huge) then return end
  problem.least = chi2
  local best = { value = {}, chi2 = chi2, runs = problem.runs.count }
  for i, one in ipairs(problem.unknowns) do best.value[one.name] = values[i] end
  require "archard.fit".best = best
  problem.runs.counter:better(solve.shown(problem, values), "fit.best")
end

-- Searches for the best parameters from the `start` of each parameter. Returns their values and the number of
-- iterations. central: true for central derivatives; one-sided derivatives need half as many runs.
local function search(problem, central)
  local parameters, first, far = problem.parameters, {}, nil
  for i = 1, #parameters do first[i] = 1 end
  local function residuals(at)
    local values = values_of(parameters, at)
    if not far then
      local list = problem:residuals(values)
      keep_best(problem, values, list)
      far = residuals_of_failure(list)
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

-- Computes the next step of the search. Returns the largest component of the step relative to its standard
-- error, the name of its parameter, and the step. The largest component is chosen among the parameters that
-- are not at a bound.
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

-- Marks the parameters that are at a bound. They are assumed fixed in the standard errors of the others.
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

-- Limits of the next step, relative to its standard error. Above `enough` the search is repeated with central
-- derivatives. Above `tolerable`, which allows for numerical noise, the fit has not converged.
local enough, tolerable = 0.1, 0.3

-- Largest number of extra steps after the search. The search stops too early if simulated values change in
-- steps; the extra steps use regression lines through these values.
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
  check.fail(problem.where, ("no convergence: after %d iterations the next step of %s is still %.2g standard errors "
    .. "(now %s). Give better start values, fix an unknown that the data hardly determine, or "
    .. "give steps that do not depend on the values (a fixed jump)"):format(found.iterations,
    found.off_name, found.off, solve.shown(problem, found.values)), "NOT_CONVERGED")
end

-- Searches for the best parameters, and repeats the search with central derivatives if it stopped too
-- early. If the residuals exceed the given errors, the convergence limits are multiplied by the ratio of
-- the residuals to the errors.
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

-- Returns the mean square error of predicting each value from all other values (cross-validation). To first
-- order it is the mean square of residual / (1 - leverage). columns: derivatives without the rows of the
-- roughness.
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

-- Returns the roughness weight, from 0.01 to 1e7, with the smallest prediction error.
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

-- --- error due to the mesh -----------------------------------------------------------------------

-- Returns how much each parameter changes, to first order, if the runs have elements of half the size, and the
-- scatter of this change: the root of the sum of the squares of the changes due to each measured value. Both
-- are nil if the model has no element sizes, or if such a run fails; the third result is then the reason.
local function change_by_mesh(problem, found)
  local own = table.move(found.values, 1, #problem.unknowns, 1, {})
  local fine, readings = pcall(problem.runs.refined, problem.runs, own)
  if not fine then
    local message, code = check.reason(readings)
    if code == "STOPPED" then error(readings, 0) end
    return nil, nil, (message or tostring(readings)):match("[^\n]*")
  end
  if not readings then return nil end
  local usual, refined = problem:predict(problem:runs_at(own), found.values), problem:predict(readings, found.values)
  local change, scatter = {}, {}
  for a, row in ipairs(found.covariance) do
    local sum, squares = 0, 0
    for i, value in ipairs(usual) do
      local gain = 0
      for b, column in ipairs(found.columns) do gain = gain - row[b] * column[i] end
      sum, squares = sum + gain * (refined[i] - value), squares + (gain * (refined[i] - value)) ^ 2
    end
    change[a], scatter[a] = sum, math.sqrt(squares)
  end
  return change, scatter
end

-- --- complete fit ---------------------------------------------------------------------------------

-- Computes the best parameters of a problem. weight: weight of the roughness, or "auto" for cross-validation;
-- told: true if the user gave the errors of the data.
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
  found.by_mesh, found.mesh_scatter, found.mesh_failed = change_by_mesh(problem, found)
  return found
end

return solve

-- Lua method s:uncertainty{}: returns mean, deviation and quantiles of the results of all samples over the
-- distance, the contribution of each field, and the convergence of the estimates.

local aligned = require "archard.lib.aligned"
local check = require "archard.lib.check"
local indices = require "archard.uncertainty.indices"
local outcomes = require "archard.uncertainty.outcomes"
local sampled = require "archard.uncertainty.sampled"
local strict = require "archard.strict"

local where = "study:uncertainty"

local class = strict.class{ __name = "uncertainty", __fields = { "name", "of", "n", "failed", "distance",
  "fields", "confidence", "design", "seed", "indices" } }

-- --- the fields ----------------------------------------------------------------------------------

local fields = { of = check.any "names", quantiles = check.list_of(check.share, "a list of numbers in (0, 1)"),
  at = check.list_of(check.positive, "a list of distances > 0"), confidence = check.share }

-- --- estimates from samples ----------------------------------------------------------------------

-- Returns the indices of the used cases that are samples of the distributions (outcomes.is_sample).
local function samples_of(study, count)
  local list = {}
  for i = 1, count do
    if outcomes.is_sample(study, i) then list[#list + 1] = i end
  end
  return list
end

local function picked(values, positions)
  local list = {}
  for i, position in ipairs(positions) do list[i] = values[position] end
  return list
end

-- Adds the estimates from one list of samples to the columns of `result` in row `g`.
local function add_estimates(result, g, list, quantiles, reach)
  local sorted = sampled.sorted(list)
  result.mean[g], result.deviation[g], result.mean_error[g] = sampled.moments(list, reach)
  for q, share in ipairs(quantiles) do
    local column = result.quantiles[q]
    column.value[g] = sampled.quantile(sorted, share)
    column.low[g], column.high[g] = sampled.quantile_range(sorted, share, reach)
  end
end

local function columns_for(quantiles)
  local result = { mean = {}, deviation = {}, mean_error = {}, quantiles = {} }
  for q, share in ipairs(quantiles) do
    result.quantiles[q] = { share = share, value = {}, low = {}, high = {} }
  end
  return result
end

-- Returns the estimates at the last distance for increasing numbers of samples.
local function convergence(list, quantiles, reach)
  local result, counts, n = columns_for(quantiles), {}, #list
  while n >= 8 and #counts < 5 do
    table.insert(counts, 1, n)
    n = n // 2
  end
  for i, count in ipairs(counts) do
    add_estimates(result, i, table.move(list, 1, count, 1, {}), quantiles, reach)
  end
  result.n = counts
  return result
end

-- --- contribution of each field ------------------------------------------------------------------

-- Returns every group-th value of a list, from index `first` on.
local function strided(values, first, group)
  local list = {}
  for i = first, #values, group do list[#list + 1] = values[i] end
  return list
end

local function add_indices(result, g, values, names, reach)
  local group = #names + 2
  local a, b = strided(values, 1, group), strided(values, 2, group)
  for f, name in ipairs(names) do
    local first, total = indices.of(a, b, strided(values, f + 2, group))
    for kind, found in pairs{ first = first or {}, total = total or {} } do
      local column = result[kind][name]
      column.value[g], column.error[g] = found.value or 0 / 0, reach * (found.error or 0 / 0)
    end
  end
end

local function columns_by_name(names)
  local list = {}
  for _, name in ipairs(names) do list[name] = { value = {}, error = {} } end
  return list
end

-- Returns the rank correlation between each field and the values at the last distance.
local function rank_correlations(study, names, index, positions, last)
  local result = {}
  for _, name in ipairs(names) do
    local given = {}
    for i, position in ipairs(positions) do given[i] = study.flat[index[position]][name] end
    result[name] = sampled.rank_correlation(given, last)
  end
  return result
end

-- --- making --------------------------------------------------------------------------------------

local function estimate(study, self, name, found, options)
  local result, values = columns_for(options.quantiles), found.values[name]
  local positions = samples_of(study, found.n)
  if self.indices then result.first, result.total = columns_by_name(self.fields), columns_by_name(self.fields) end
  for g = 1, #found.distance do
    add_estimates(result, g, picked(values[g], positions), options.quantiles, options.reach)
    if self.indices then add_indices(result, g, values[g], self.fields, options.reach) end
  end
  local last = picked(values[#values], positions)
  result.convergence = convergence(last, options.quantiles, options.reach)
  result.rank = rank_correlations(study, self.fields, found.index, positions, last)
  self.n = #positions
  return result
end

-- --- showing -------------------------------------------------------------------------------------

local function number(value) return value == value and ("%.4g"):format(value) or "-" end

local function estimates_table(self, g)
  local head = { "", "mean", "+-", "deviation" }
  for _, column in ipairs(self[self.of[1]].quantiles) do
    head[#head + 1] = ("%g %%"):format(100 * column.share)
  end
  head[#head + 1] = "unit"
  local rows = { head }
  for _, name in ipairs(self.of) do
    local result = self[name]
    local row = { name, number(result.mean[g]), number(result.mean_error[g]), number(result.deviation[g]) }
    for _, column in ipairs(result.quantiles) do row[#row + 1] = number(column.value[g]) end
    row[#row + 1] = outcomes.unit(name)
    rows[#rows + 1] = row
  end
  return rows
end

local function causes_table(self, g)
  local rows = { self.indices and { "share of the variance", "first", "+-", "total", "+-", "of" }
    or { "correlation of ranks", "", "of" } }
  for _, name in ipairs(self.of) do
    local result = self[name]
    for _, field in ipairs(self.fields) do
      local first, total = self.indices and result.first[field], self.indices and result.total[field]
      rows[#rows + 1] = first and { field, ("%.3f"):format(first.value[g]), ("%.3f"):format(first.error[g]),
        ("%.3f"):format(total.value[g]), ("%.3f"):format(total.error[g]), name }
        or { field, result.rank[field] and ("%.3f"):format(result.rank[field]) or "-", name }
    end
  end
  return rows
end

local function add_rows(lines, rows)
  for _, line in ipairs(aligned(rows)) do lines[#lines + 1] = "  " .. line end
end

-- Returns a text about the last doubling of the number of samples: the relative changes of the mean, the
-- deviation and the highest quantile.
local function convergence_line(self, name)
  local course = self[name].convergence
  local n = #course.n
  if n < 2 then return nil end
  local last = course.quantiles[#course.quantiles]
  local function moved(list) return 100 * math.abs(list[n] / list[n - 1] - 1) end
  return ("  %s: from %d to %d samples the mean changed by %.2g %%, the deviation by %.2g %%, the %g %% "
    .. "quantile by %.2g %%"):format(name, course.n[n - 1], course.n[n], moved(course.mean),
    moved(course.deviation), 100 * last.share, moved(last.value))
end

function class.__tostring(self)
  local g = #self.distance
  local lines = { ("uncertainty of %s: %d samples (%s, seed %d) at %g mm, +- at %g %% confidence")
    :format(self.name, self.n, self.design, self.seed, self.distance[g], 100 * self.confidence) }
  if self.failed > 0 then
    lines[#lines + 1] = ("  %d cases failed and are omitted, which may bias the results")
      :format(self.failed)
  end
  add_rows(lines, estimates_table(self, g))
  add_rows(lines, causes_table(self, g))
  for _, name in ipairs(self.of) do lines[#lines + 1] = convergence_line(self, name) end
  if self.uneven then lines[#lines + 1] = "  " .. self.uneven end
  return table.concat(lines, "\n")
end

-- Returns a note if n is not a power of 2, since Sobol points are evenly distributed only for powers of 2.
local function uneven(sample)
  local power = 2 ^ math.floor(math.log(sample.n, 2) + 1e-9)
  if sample.design ~= "sobol" or sample.n == power then return nil end
  return ("n = %d is not a power of 2: Sobol's points are evenly distributed for n = %d or %d"):format(sample.n,
    math.tointeger(power), math.tointeger(2 * power))
end

-- s:uncertainty{ of=, at=, quantiles=, confidence= } returns the statistics of the results `of`.
return function(study, given)
  given = check.definition(where, given or {}, fields)
  local first = outcomes.first(study, where)
  local names = outcomes.names(where, given.of or outcomes.usual(first), first.history)
  local options = { quantiles = given.quantiles or { 0.05, 0.5, 0.95 },
    reach = sampled.reach(given.confidence or 0.95) }
  local found, uncertain = outcomes.read(study, where, names, given.at), {}
  for i, field in ipairs(study.sample.fields) do uncertain[i] = field.name end
  local self = { name = study.name, of = names, failed = found.failed, distance = found.distance,
    fields = uncertain, confidence = given.confidence or 0.95, design = study.sample.design,
    seed = study.sample.seed, indices = study.sample.indices, uneven = uneven(study.sample) }
  for _, name in ipairs(names) do self[name] = estimate(study, self, name, found, options) end
  return setmetatable(self, class)
end

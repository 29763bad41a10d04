-- Makes the cases of a sampled study. The values depend only on the distributions, the design and the seed.
-- Correlations apply to the normal scores of the fields: their values transformed to a normal distribution.
-- Therefore correlations do not change the distribution of a field.

local check = require "archard.lib.check"
local distributions = require "archard.uncertainty.distributions"
local number = require "archard.definition.number"
local own = require "archard.uncertainty.fields"
local random = require "archard.random"
local settings = require "archard.definition.settings"

local design = {}

-- --- the fields ----------------------------------------------------------------------------------

-- Returns the list of uncertain fields { name=, distribution= }, sorted by path. flat: flat settings of the
-- base case.
local function fields_of(where, given, flat)
  local list, there = {}, {}
  local function add(name, distribution)
    local path = number.path(where, "sample." .. name, name, flat)
    local setting = number.setting(path)
    if setting then number.check(where, "sample." .. name, setting) end
    if there[path] then
      check.fail(where, ("fields 'sample.%s' and 'sample.%s': both mean the field %s"):format(there[path], name, path))
    end
    list[#list + 1], there[path] = { name = path, distribution = distribution }, name
  end
  local function visit(prefix, inside)
    check.depth(where, "sample." .. prefix)
    for key, value in pairs(inside) do
      local name = prefix .. tostring(key)
      if distributions.is(value) then
        add(name, value)
      elseif type(value) == "table" and getmetatable(value) == nil and next(value) ~= nil
        and #value == 0 then
        visit(name .. ".", value)
      elseif name ~= "correlated" then
        check.refuse(where, "sample." .. name, "uniform{}, normal{} or lognormal{}", value)
      end
    end
  end
  visit("", given)
  table.sort(list, function(a, b) return a.name < b.name end)
  if #list == 0 then
    check.fail(where, "field 'sample': expected a distribution for at least one field, got none")
  end
  return list
end

local function position(where, fields, name, flat)
  local known, paths = {}, type(name) == "string" and number.paths(name, flat) or {}
  for i, field in ipairs(fields) do
    if field.name == paths[1] then return i end
    known[i] = field.name
  end
  check.fail(where, ("field 'sample.correlated': '%s' is not a sampled field%s"):format(tostring(name),
    check.hint(tostring(name), known)))
end

local function check_correlation(where, i, item)
  if type(item) ~= "table" or #item ~= 3 then
    check.refuse(where, ("sample.correlated[%d]"):format(i), '{ "field", "field", number }', item)
  end
  local value = item[3]
  if type(value) ~= "number" or not (math.abs(value) < 1) then
    check.refuse(where, ("sample.correlated[%d][3]"):format(i), "a number in (-1, 1)", value)
  end
end

-- Returns the correlation matrix of the fields, or nil without correlations. given: list { {"k", "alpha",
-- -0.5}, ... }.
local function correlation_of(where, fields, given, flat)
  if given == nil then return nil end
  if type(given) ~= "table" then
    check.refuse(where, "sample.correlated", "a list of { field, field, number }", given)
  end
  local matrix = {}
  for i = 1, #fields do
    matrix[i] = {}
    for j = 1, #fields do matrix[i][j] = i == j and 1 or 0 end
  end
  for i, item in ipairs(given) do
    check_correlation(where, i, item)
    local a, b = position(where, fields, item[1], flat), position(where, fields, item[2], flat)
    if a == b then
      check.refuse(where, ("sample.correlated[%d]"):format(i), "two different fields", item[1])
    end
    if matrix[a][b] ~= 0 then
      check.fail(where, ("field 'sample.correlated[%d]': the correlation of %s and %s is given twice, first as %g"):format(i,
        item[1], item[2], matrix[a][b]))
    end
    matrix[a][b], matrix[b][a] = item[3], item[3]
  end
  return matrix
end

-- Returns the lower triangular Cholesky factor of a correlation matrix. Raises an error if the matrix is not
-- positive definite.
local function cholesky(where, matrix)
  local lower = {}
  for i = 1, #matrix do
    lower[i] = {}
    for j = 1, i do
      local rest = matrix[i][j]
      for m = 1, j - 1 do rest = rest - lower[i][m] * lower[j][m] end
      if i > j then
        lower[i][j] = rest / lower[j][j]
      elseif rest > 1e-12 then
        lower[i][i] = math.sqrt(rest)
      else
        check.fail(where, "field 'sample.correlated': these correlations are inconsistent (their "
          .. "matrix is not positive definite)")
      end
    end
  end
  return lower
end

-- Returns the number of cases for each point of the design.
local function cases_each(sample) return sample.indices and #sample.fields + 2 or 1 end

local function check_count(where, sample)
  local each = cases_each(sample)
  settings.check_count(where, "n", sample.n * each, ("%d samples%s"):format(sample.n,
    sample.indices and (", with indices %d cases each"):format(each) or ""))
end

local function check_design(where, sample, given)
  check_count(where, sample)
  local most = sample.indices and random.most_dimensions // 2 or random.most_dimensions
  if #sample.fields > most then
    check.fail(where, ("field 'sample': %d fields exceed the limit of %d%s"):format(
      #sample.fields, most, sample.indices and " with indices" or ""))
  end
  if sample.n < 2 then check.refuse(where, "n", "a whole number >= 2", sample.n) end
  if sample.indices and sample.n < 16 then
    check.refuse(where, "n", "at least 16 with indices", sample.n)
  end
  if sample.indices and given.correlated ~= nil then
    check.fail(where, "field 'indices': expected no field 'sample.correlated', because indices divide "
      .. "the variance among independent fields")
  end
end

-- Reads the definition of the samples from the fields base, sample, n, design, seed and indices in `given`.
function design.read(where, given)
  local flat = settings.flatten(where, given.base or {})
  local sample = { n = given.n or 1024, design = given.design or "sobol", seed = given.seed or 1,
    indices = given.indices or false, fields = fields_of(where, given.sample, flat) }
  check_design(where, sample, given.sample)
  local matrix = correlation_of(where, sample.fields, given.sample.correlated, flat)
  sample.lower = matrix and cholesky(where, matrix)
  return sample
end

-- --- values --------------------------------------------------------------------------------------

-- Returns the values of all fields at point `i` of the design. columns[f][i]: cumulative probability of field
-- f.
local function values_at(sample, columns, i)
  local values, score = {}, {}
  for f, field in ipairs(sample.fields) do
    local share = columns[f][i]
    if sample.lower then
      score[f] = random.normal_quantile(share)
      local sum = 0
      for m = 1, f do sum = sum + sample.lower[f][m] * score[m] end
      share = random.normal_share(sum)
    end
    values[field.name] = field.distribution.value(share)
  end
  return values
end

-- Adds the cases of one point of Saltelli's design: a first set of values, a second set, and, for each field,
-- the first set with the field's value from the second set.
local function with_exchanges(sample, columns, i, cases)
  local second, count = {}, #sample.fields
  for f = 1, count do second[f] = columns[count + f] end
  local a, b = values_at(sample, columns, i), values_at(sample, second, i)
  cases[#cases + 1], cases[#cases + 2] = a, b
  for _, field in ipairs(sample.fields) do
    local mixed = {}
    for name, value in pairs(a) do mixed[name] = value end
    mixed[field.name] = b[field.name]
    cases[#cases + 1] = mixed
  end
end

-- Returns all cases of the design: n cases or, with indices, n * (number of fields + 2) cases.
function design.cases(sample)
  local dimensions = #sample.fields * (sample.indices and 2 or 1)
  local columns, cases = random.points(sample.design, sample.n, dimensions, sample.seed), {}
  for i = 1, sample.n do
    if sample.indices then
      with_exchanges(sample, columns, i, cases)
    else
      cases[i] = values_at(sample, columns, i)
    end
  end
  return cases
end

-- --- text in a run file --------------------------------------------------------------------------

-- Returns the definition of the samples as text for the run file. The text does not contain the sampled
-- values, which the file stores with the cases.
function design.text(sample)
  local lines = { ("%s n=%d seed=%d indices=%s"):format(sample.design, sample.n, sample.seed,
    tostring(sample.indices)) }
  for _, field in ipairs(sample.fields) do
    lines[#lines + 1] = field.name .. " " .. tostring(field.distribution)
  end
  return table.concat(lines, "\n")
end

-- Parses the lines after the first line and returns the list of fields. Returns nil if a line is invalid or a
-- field occurs twice.
local function parse_fields(lines)
  local fields, known = {}, {}
  if not lines:find "^\n" then return nil end
  for line in lines:gmatch "\n([^\n]*)" do
    local name, distribution = line:match "^(.-) (%a+{.*)$"
    if not name or known[name] or not distributions.is_text(distribution) then return nil end
    fields[#fields + 1], known[name] = { name = name, distribution = distribution }, true
  end
  return fields
end

-- Parses a text made by design.text. Returns the definition of the samples, or nil if the text is invalid.
function design.parse(text)
  local kind, n, seed, indices, lines = text:match "^(%a+) n=(%d+) seed=(%d+) indices=(%a+)(.*)$"
  local sample = { design = kind, n = math.tointeger(tonumber(n)), seed = math.tointeger(tonumber(seed)),
    indices = ({ ["true"] = true, ["false"] = false })[indices], fields = parse_fields(lines or ""), text = text }
  for name, kind in pairs(own) do
    if not kind.test(sample[name]) then return nil end
  end
  return sample.fields and sample.fields[1] and sample
end

-- Returns a text that describes how the cases of a run file differ from the design, or nil if they agree with
-- it.
function design.missing(sample, flat)
  local count = sample.n * cases_each(sample)
  if count ~= #flat then return ("its samples need %d cases, the file has %d"):format(count, #flat) end
  for id, case in ipairs(flat) do
    for _, field in ipairs(sample.fields) do
      if not check.number.test(case[field.name]) then
        return ("case %d has no number for the sampled field '%s'"):format(id, field.name)
      end
    end
  end
end

return design

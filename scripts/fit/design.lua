-- Lua function fit.design: computes, before a test, which measurements at which distances determine the
-- unknowns best. From the derivatives at the start values it computes the standard errors for each
-- measurement alone, and the best order of the measurements.

local aligned = require "archard.lib.aligned"
local check = require "archard.lib.check"
local data = require "archard.fit.data"
local merged = require "archard.lib.merged"
local solve = require "archard.fit.solve"
local strict = require "archard.strict"
local csv_text = require "archard.lib.csv_text"
local files = require "archard.files"
local written = require "archard.lib.written"

local where = "fit.design"

-- --- the fields ----------------------------------------------------------------------------------

local own = {
  of = data.fields.of, profile = data.kinds.body, section = data.kinds.section, distance = data.kinds.sizes, error = check.positive,
  relative = check.positive, x = data.kinds.list, points = check.whole(3, 100000), width = check.positive,
  title = check.text, shift = check.number, tilt = check.number, level = check.number,
}

-- Returns the default positions x [mm] of the points of a profile: evenly spaced over `width` [mm], with the
-- middle at x = 0.
local function places(given)
  local count, width = given.points or 61, given.width or 1
  local x = {}
  for i = 1, count do x[i] = width * ((i - 1) / (count - 1) - 0.5) end
  return x
end

local function zeros(x)
  local list = {}
  for i = 1, #x do list[i] = 0 end
  return list
end

local function check_one(number, given)
  local field = ("measure[%d]"):format(number)
  if type(given) ~= "table" then check.refuse(where, field, "a table", given) end
  given = check.fields(where, given, own, field .. ".")
  if (given.of == nil) == (given.profile == nil) then
    check.fail(where, ("field '%s': expected either of=\"volume_cylinder\" (or another column), or profile=\"cylinder\" or "
      .. "\"plate\", got %s"):format(field, given.of and "both" or "neither"))
  end
  if given.distance == nil then check.refuse(where, field .. ".distance", own.distance.expected, nil) end
  if (given.error == nil) == (given.relative == nil or given.profile ~= nil) then
    check.fail(where, ("field '%s': expected the error of the measurement, error=%s"):format(field,
      given.profile and " [mm]" or " in its unit, or relative= (exactly one of them)"))
  end
end

-- Returns a measurement with placeholder values. The first run later provides the expected values.
local function stand_in(one, distance)
  if not one.profile then
    return { of = one.of, distance = distance, value = 1, error = one.error or one.relative }
  end
  local x = one.x or places(one)
  return { x = x, h = zeros(x), body = one.profile, section = one.section, distance = distance, error = one.error,
    shift = one.shift, tilt = one.tilt, level = one.level }
end

-- Reads the user's planned measurements. Returns one item for each measurement and distance.
local function read(given)
  local items = {}
  for number, one in ipairs(given.measure) do
    check_one(number, one)
    local distances = type(one.distance) == "number" and { one.distance } or one.distance
    for i = 1, #distances do
      local item = data.item(where, ("measure[%d]"):format(number), stand_in(one, distances[i]), {})
      item.measure, item.at, item.relative = number, distances[i], one.relative
      item.title = one.title or (one.profile and "profile of the " .. one.profile or one.of)
      items[#items + 1] = item
    end
  end
  if #items == 0 then check.fail(where, "field 'measure': expected a list of measurements, got none") end
  return items
end

-- Computes absolute errors from relative errors and the simulated values of the first run.
local function size_errors(problem, readings)
  local still = { shift = 0, tilt = 0, level = 0 }
  for _, item in ipairs(problem.items) do
    if item.relative then
      for i, value in ipairs(data.values(item, readings, still)) do
        if value <= 0 then
          check.fail(where, ("%s at %g mm: the simulated value is %g, which has no relative error; give error=")
            :format(item.title, item.at, value))
        end
        item.error[i] = item.relative * value
      end
    end
  end
end

-- --- expected standard errors --------------------------------------------------------------------

-- Returns the rows that represent the prior knowledge, one for each unknown, with the value 1 / prior error.
-- The prior error is the standard deviation of a uniform distribution between the bounds, or the typical
-- range of the unknown. These rows limit the errors of unknowns that a measurement does not determine.
local function prior_rows(problem)
  local rows = {}
  for j, one in ipairs(problem.unknowns) do
    local width = one.low and one.high and (one.high - one.low) / math.sqrt(12) or one.span
    rows[j] = { [j] = 1 / width }
  end
  return rows
end

-- Returns the derivatives for the chosen items as a list of columns, each followed by the rows of the prior.
-- The position parameters of the other items are omitted.
local function columns_of(self, chosen)
  local columns = {}
  for j, one in ipairs(self.problem.parameters) do
    if not one.item or chosen[one.item] then
      local column = {}
      for number, rows in ipairs(self.rows) do
        if chosen[number] then table.move(self.all[j], rows[1], rows[2], #column + 1, column) end
      end
      for _, row in ipairs(self.prior) do column[#column + 1] = row[j] or 0 end
      columns[#columns + 1] = column
    end
  end
  return columns
end

-- Returns three results for the chosen items together: the standard errors of the unknowns, the covariance,
-- and the sum of log(error / typical range).
local function expected(self, chosen)
  local columns = columns_of(self, chosen)
  local covariance, errors, sum = solve.covariance(columns), {}, 0
  for j = 1, #self.problem.unknowns do
    errors[j] = math.sqrt(covariance[j][j])
    sum = sum + math.log(errors[j] / self.problem.unknowns[j].span)
  end
  return errors, covariance, sum
end

local function entry(self, number, errors)
  local item = self.problem.items[number]
  local named = {}
  for j, one in ipairs(self.problem.unknowns) do named[one.name] = errors[j] end
  return { title = item.title, distance = item.at, measure = item.measure, error = named }
end

local function alone(self)
  local list = {}
  for number in ipairs(self.problem.items) do
    list[number] = entry(self, number, (expected(self, { [number] = true })))
  end
  return list
end

-- Returns the measurements in their best order. Each step adds the measurement that, together with the
-- measurements already chosen, gives the smallest errors.
local function best_order(self, most)
  local chosen, list = {}, {}
  for _ = 1, math.min(most, #self.problem.items) do
    local best, least, errors = nil, math.huge, nil
    for number in ipairs(self.problem.items) do
      if not chosen[number] then
        chosen[number] = true
        local these, _, sum = expected(self, chosen)
        chosen[number] = nil
        if sum < least - 1e-12 then best, least, errors = number, sum, these end
      end
    end
    chosen[best] = true
    list[#list + 1] = entry(self, best, errors)
  end
  return list
end

local function together(self)
  local chosen, correlation = {}, {}
  for number in ipairs(self.problem.items) do chosen[number] = true end
  local errors, covariance = expected(self, chosen)
  for a = 1, #errors do
    correlation[a] = {}
    for b = 1, #errors do correlation[a][b] = covariance[a][b] / errors[a] / errors[b] end
  end
  return entry(self, 1, errors).error, correlation
end

-- --- showing -------------------------------------------------------------------------------------

local class = { __name = "design", __fields = { "names", "units", "start", "prior_error", "alone", "best", "all",
  "correlation", "runs" } }
local methods = {}
class.__methods = methods

-- Returns an error as text, with its percentage of the start value (omitted if the start value is 0). Returns
-- "undetermined" if the error is close to the prior error.
local function shown(self, name, value)
  local start, prior = self.start[name], self.prior_error[name]
  if value > 0.9 * prior then return "undetermined" end
  return start ~= 0 and ("%.2g (%.2g %%)"):format(value, 100 * value / math.abs(start)) or ("%.2g"):format(value)
end

local function row_of(self, first, one)
  local row = { first, one.title, ("%g"):format(one.distance) }
  for _, name in ipairs(self.names) do row[#row + 1] = shown(self, name, one.error[name]) end
  return row
end

-- Returns the titles of the table's columns: the arguments, followed by one title for each unknown.
local function heads(self, ...)
  local row = { ... }
  for i, name in ipairs(self.names) do
    row[#row + 1] = "error of " .. name .. (self.units[i] ~= "" and " [" .. self.units[i] .. "]" or "")
  end
  return row
end

local function add_rows(lines, rows)
  for _, line in ipairs(aligned(rows, true)) do lines[#lines + 1] = "  " .. line end
end

function class.__tostring(self)
  local lines, rows = { ("design of a test for %s: expected standard errors, %d runs"):format(
    table.concat(self.names, ", "), self.runs) }, { heads(self, "", "measurement", "at [mm]") }
  for _, one in ipairs(self.alone) do rows[#rows + 1] = row_of(self, "alone", one) end
  for i, one in ipairs(self.best) do rows[#rows + 1] = row_of(self, i == 1 and "best" or "then", one) end
  rows[#rows + 1] = row_of(self, "all", { title = "together", distance = 0, error = self.all })
  rows[#rows][3] = ""
  add_rows(lines, rows)
  return table.concat(lines, "\n")
end

-- Lua method d:table{ file= }: returns the standard errors of each measurement alone as CSV text, or writes
-- them to a file and returns its path.
function methods:table(options)
  options = check.fields("design:table", options or {}, { file = check.file })
  local rows = { heads(self, "measurement", "distance [mm]") }
  for _, one in ipairs(self.alone) do
    local row = { one.title, one.distance }
    for i, name in ipairs(self.names) do row[i + 2] = one.error[name] end
    rows[#rows + 1] = row
  end
  local text = csv_text(rows, #self.names + 2)
  if not (options and options.file) then return text end
  files.write("design:table", options.file, text)
  return written.returned("design:table", options.file)
end

strict.class(class)

-- --- making --------------------------------------------------------------------------------------

-- Parameters of a design for values that change in steps: half of the range over which their slopes are
-- computed, relative to the parameter's value, and the number of intervals. The range is wide, about one
-- prior standard deviation on both sides, because without data the unknowns can be far from their start
-- values.
local widest, intervals = 0.6, 16

local function sensitivities(problem)
  problem.widest, problem.many = widest, intervals
  local values = {}
  for i, one in ipairs(problem.parameters) do values[i] = one.start end
  local readings = problem:runs_at(values)
  size_errors(problem, readings)
  problem:measure_noise(values)
  problem:measure_ripple(values, true)
  local columns, rows, last = problem:jacobian(values, true), {}, 0
  for number, item in ipairs(problem.items) do
    rows[number] = { last + 1, last + #item.x }
    last = last + #item.x
  end
  return columns, rows
end

local function described(problem, self)
  local priors = prior_rows(problem)
  for j, one in ipairs(problem.unknowns) do
    self.names[j], self.units[j], self.start[one.name] = one.name, one.unit, one.start
    self.prior_error[one.name] = 1 / priors[j][j]
  end
  self.runs = problem.runs.count
  return setmetatable(self, class)
end

-- Computes a design. given: the fields of fit{}, with measure= instead of data=; common: the fields that
-- fit{} and fit.design{} share; prepare: function that makes the problem from the items.
return function(given, common, prepare)
  given = check.definition(where, given, merged(common, { measure = check.table, best = check.whole(1, 100) }))
  for _, name in ipairs{ "unknown", "measure" } do
    if given[name] == nil then check.refuse(where, name, "a table", nil) end
  end
  local problem = prepare(where, given, read(given), 2)
  local _ <close> = problem.runs.counter
  local self = { problem = problem, prior = prior_rows(problem) }
  self.all, self.rows = sensitivities(problem)
  local all, correlation = together(self)
  return described(problem, { names = {}, units = {}, start = {}, prior_error = {}, alone = alone(self),
    best = best_order(self, given.best or 3), all = all, correlation = correlation })
end

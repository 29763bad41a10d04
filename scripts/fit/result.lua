-- Defines the result of a fit: values, standard errors, confidence bands, residuals, notes on undetermined
-- unknowns, and the final run.

local data = require "archard.fit.data"
local statistics = require "archard.lib.statistics"
local strict = require "archard.strict"
local unknown = require "archard.fit.unknown"

local result = {}

-- Intervals include this many times the change of a value with half the element size, or its scatter if that is
-- larger. The error due to the mesh is at most twice this change if it decreases at least in proportion to the
-- element size. The changes due to single measured values can cancel by chance; their scatter does not.
local by_mesh = 2

-- --- numbers -------------------------------------------------------------------------------------

-- Returns the values of the unknowns in a table by name. The value of a curve is the list of its knot values.
local function by_path(problem, list)
  local named = {}
  for i, one in ipairs(problem.unknowns) do
    if one.distance then
      named[one.path] = named[one.path] or {}
      table.insert(named[one.path], list[i])
    else
      named[one.path] = list[i]
    end
  end
  return strict.table(named, "fit")
end

local function clipped(one, value)
  return math.max(one.low or -math.huge, math.min(one.high or math.huge, value))
end

-- Returns a table with true at the index of each parameter that has no standard error, because it is at a
-- bound or the data do not determine it.
local function undetermined(found, problem)
  local blind = {}
  for _, direction in ipairs(found.unseen) do
    for _, i in ipairs(direction) do blind[i] = true end
  end
  for i, one in ipairs(problem.parameters) do blind[i] = blind[i] or one.bound ~= nil end
  return blind
end

local function deviations(found, problem, scale)
  local blind, list = undetermined(found, problem), {}
  for i, row in ipairs(found.covariance) do
    list[i] = blind[i] and math.huge or scale * math.sqrt(row[i])
  end
  return list
end

local function correlations(found)
  local list = {}
  for a, row in ipairs(found.covariance) do
    list[a] = {}
    for b, value in ipairs(row) do
      local root = math.sqrt(row[a] * found.covariance[b][b])
      list[a][b] = root > 0 and value / root or 0
    end
  end
  return list
end

-- Returns the standard error of a function of the parameters. derivative: derivatives of the function with
-- respect to the parameters.
local function along(covariance, derivative)
  local sum = 0
  for a, row in ipairs(covariance) do
    if derivative[a] ~= 0 then
      for b, value in ipairs(row) do sum = sum + derivative[a] * value * derivative[b] end
    end
  end
  return math.sqrt(math.max(0, sum))
end

-- --- bands ---------------------------------------------------------------------------------------

-- Returns one table for each measurement, with the lists x (or distance), value, error, model (simulated
-- values), low and high (confidence band of the model), and residual = (value - model) / error.
local function described(self, problem, found, scale, deviation)
  local readings, row, list = problem:runs_at(found.values), 0, {}
  for number, item in ipairs(problem.items) do
    local position = problem:position(number, found.values)
    local model, low, high, residual, err = data.values(item, readings, position), {}, {}, {}, {}
    for i, value in ipairs(model) do
      row = row + 1
      local derivative = {}
      for j, column in ipairs(found.columns) do derivative[j] = column[row] end
      local margin = self.times * scale * item.error[i] * along(found.covariance, derivative)
      low[i], high[i], err[i] = value - margin, value + margin, (self.told and 1 or scale) * item.error[i]
      residual[i] = (item.value[i] - value) / err[i]
    end
    list[number] = { title = item.title, brief = item.brief, along = item.along, unit = item.unit, body = item.body, of = item.of, kind = item.kind,
      distance = item.distance or item.x, x = item.kind ~= "series" and item.x or nil, value = item.value,
      error = err, model = model, low = low, high = high, residual = residual }
    for i, one in ipairs(problem.positions) do
      if one.item == number then
        local at = #problem.unknowns + i
        list[number].place = list[number].place or {}
        list[number].place[one.kind] = { value = found.values[at], error = deviation[at], unit = one.unit }
      end
    end
  end
  return list
end

-- Returns the fitted curves over the distance as tables for wear{}, and their confidence bands.
local function curves(self, problem, found, scale)
  local list, bands = {}, {}
  for _, curve in ipairs(problem.unknowns.curves) do
    local series = unknown.series(curve, found.values)
    local low, high, shifted = {}, {}, {}
    for j = 0, #curve.knots - 1 do
      local values = table.move(found.values, 1, #problem.unknowns, 1, {})
      local step = 1e-4 * problem.unknowns[curve.first + j].span
      values[curve.first + j] = values[curve.first + j] + step
      shifted[curve.first + j] = { unknown.series(curve, values).value, step }
    end
    local one = problem.unknowns[curve.first]
    for i, value in ipairs(series.value) do
      local derivative = {}
      for a = 1, #found.covariance do
        derivative[a] = shifted[a] and (shifted[a][1][i] - value) / shifted[a][2] or 0
      end
      local change = 0
      for a, by in ipairs(found.by_mesh or {}) do change = change + derivative[a] * by end
      local margin = self.times * scale * along(found.covariance, derivative) + by_mesh * math.abs(change)
      low[i], high[i] = clipped(one, value - margin), clipped(one, value + margin)
    end
    list[curve.path] = series
    bands[curve.path] = { distance = series.distance, value = series.value, low = low, high = high }
  end
  return strict.table(list, "fit.curve"), strict.table(bands, "fit.band")
end

-- --- notes ---------------------------------------------------------------------------------------

local function names_of(problem, list)
  local words = {}
  for i, at in ipairs(list) do words[i] = problem.parameters[at].name end
  local last = table.remove(words)
  return #words > 0 and table.concat(words, ", ") .. " and " .. last or last
end

local function note_bounds(notes, problem)
  for _, one in ipairs(problem.parameters) do
    if one.bound then
      notes[#notes + 1] = ("%s is at its %s bound, %g: it has no standard error, and the other standard errors "
        .. "assume this value. Widen the bound, or check whether the model can reproduce the data"):format(
        one.name, one.bound == "low" and "lower" or "upper", one[one.bound])
    end
  end
end

local function note_unseen(notes, problem, found)
  local idle = {}
  for i, one in ipairs(problem.parameters) do idle[i] = one.bound end
  for _, direction in ipairs(found.unseen) do
    local free = {}
    for _, i in ipairs(direction) do
      if not idle[i] then free[#free + 1] = i end
    end
    if #free > 1 then
      notes[#notes + 1] = ("the data determine only a combination of %s")
        :format(names_of(problem, free))
    elseif #free == 1 then
      notes[#notes + 1] = ("the data do not determine %s"):format(names_of(problem, free))
    end
  end
end

local function note_correlated(notes, self, problem, found)
  local blind = undetermined(found, problem)
  for a = 1, #problem.unknowns do
    for b = 1, #problem.parameters do
      local value = self.correlation[a][b]
      if b > a and math.abs(value) > 0.95 and not (blind[a] and blind[b]) then
        notes[#notes + 1] = ("%s and %s are strongly correlated (%.3f); fit.design shows which "
          .. "measurements separate them"):format(problem.parameters[a].name, problem.parameters[b].name, value)
      end
    end
  end
end

local function note_vague(notes, problem, found, deviation)
  for i, one in ipairs(problem.unknowns) do
    local limit = one.low and one.high and (one.high - one.low) / 4 or math.abs(found.values[i]) / 2
    if deviation[i] < math.huge and deviation[i] > limit then
      notes[#notes + 1] = ("the data hardly determine %s"):format(one.name)
    end
  end
end

-- Adds a note on values that change in steps from node to node. Their scatter limits the accuracy on the
-- given mesh.
local function note_rippled(notes, problem)
  for _, item in ipairs(problem.items) do
    if item.rippled then
      notes[#notes + 1] = ("%s: the simulated values change in steps from node to node and scatter by up to %.2g %s, which "
        .. "is included in the errors; a smaller mesh.size reduces it"):format(item.title, item.rippled, item.unit)
    end
  end
end

local function note_residuals(notes, self, rippled)
  if not self.told or self.freedom < 1 then return end
  local off = (self.reduced - 1) / math.sqrt(2 / self.freedom)
  if off > 4 then
    notes[#notes + 1] = ("residuals are %.2g times the given errors: the errors are too small or the model "
      .. "is incomplete; the standard errors %s"):format(math.sqrt(self.reduced), rippled
      and "are increased by this factor" or "assume the given errors")
  elseif off < -4 then
    notes[#notes + 1] = ("residuals are only %.2g times the given errors: are the errors too large?"):format(
      math.sqrt(self.reduced))
  end
end

local function notes_of(self, problem, found, deviation)
  local notes = {}
  note_bounds(notes, problem)
  note_unseen(notes, problem, found)
  note_correlated(notes, self, problem, found)
  note_vague(notes, problem, found, deviation)
  note_rippled(notes, problem)
  if found.mesh_failed then
    notes[#notes + 1] = ("the error due to the mesh is unknown, because a run with half the element size failed: %s"):format(
      found.mesh_failed)
  end
  note_residuals(notes, self, next(problem.rippled) ~= nil)
  return notes
end

-- --- showing -------------------------------------------------------------------------------------

local class = { __name = "fitted", __methods = {}, __fields = { "value", "error", "low", "high", "names", "values", "errors",
  "correlation", "covariance", "confidence", "chi2", "freedom", "reduced", "told", "data", "curve", "band", "notes",
  "iterations", "runs", "noise", "smooth", "wear", "times", "margins", "mesh" } }

local function shown(value) return ("%.4g"):format(value) end

local function line_of(self, i, unit)
  local text = ("  %-16s %s"):format(self.names[i], shown(self.values[i]))
  unit = unit ~= "" and " " .. unit or ""
  if self.errors[i] == math.huge then return ("%s%s, without a standard error"):format(text, unit) end
  return ("%s +- %s%s, %s to %s"):format(text, ("%.2g"):format(self.errors[i]), unit,
    shown(clipped(self.bounds[i], self.values[i] - self.margins[i])),
    shown(clipped(self.bounds[i], self.values[i] + self.margins[i])))
end

local function rms(list)
  local sum = 0
  for _, value in ipairs(list) do sum = sum + value * value end
  return math.sqrt(sum / #list)
end

local function data_line(item)
  local line = ("  %s: %d value%s, rms of residual / error %.2f"):format(item.title, #item.value,
    #item.value == 1 and "" or "s", rms(item.residual))
  for _, name in ipairs{ "shift", "tilt", "level" } do
    local place = item.place and item.place[name]
    if place then
      local factor, unit = 1e3, name == "tilt" and "um/mm" or "um"
      if place.unit == "N" then factor, unit = 1, "N" end
      line = ("%s\n    %s %.3g +- %.2g %s"):format(line, name, factor * place.value, factor * place.error,
        unit)
    end
  end
  return line
end

-- Returns a line on the changes due to the mesh if they add at least a tenth to an interval, else nil.
local function mesh_line(self)
  local words, counts = {}, false
  for i, change in ipairs(self.changes) do
    if self.errors[i] < math.huge then
      words[#words + 1] = ("%s by %.2g"):format(self.names[i], change)
      counts = counts or self.margins[i] - self.times * self.errors[i] > 0.1 * self.margins[i]
    end
  end
  return counts and ("  mesh             half the element size changes %s; the ranges include at least twice this"):format(
    table.concat(words, ", ")) or nil
end

-- Adds the correlations to the lines, three pairs on each line. With more than ten pairs none is added.
local function add_correlations(lines, self)
  local words = {}
  for a = 1, #self.names do
    for b = a + 1, #self.names do
      words[#words + 1] = ("%s, %s %.3f"):format(self.names[a], self.names[b], self.correlation[a][b])
    end
  end
  for i = 1, #words <= 10 and #words or 0, 3 do
    lines[#lines + 1] = (i == 1 and "  correlations     " or (" "):rep(19))
      .. table.concat(words, "; ", i, math.min(i + 2, #words))
  end
end

-- Breaks a note into lines of about 100 characters at most.
local function wrapped(text)
  local lines, line = {}, "  note:"
  for word in text:gmatch("%S+") do
    if #line + #word > 98 then
      lines[#lines + 1], line = line, "   "
    end
    line = line .. " " .. word
  end
  lines[#lines + 1] = line
  return table.concat(lines, "\n")
end

function class.__tostring(self)
  local lines = { ("fit to %d values in %d set%s of data: %d iterations, %d runs"):format(self.count,
    #self.data, #self.data == 1 and "" or "s", self.iterations, self.runs) }
  for i in ipairs(self.names) do lines[#lines + 1] = line_of(self, i, self.units[i]) end
  lines[#lines + 1] = ("  +-: standard error; range: %g %% confidence%s"):format(100 * self.confidence,
    self.told and "" or "; errors of the data estimated from the residuals")
  lines[#lines + 1] = mesh_line(self)
  add_correlations(lines, self)
  if self.smooth > 0 then lines[#lines + 1] = ("  smoothness       weight %.3g"):format(self.smooth) end
  for _, item in ipairs(self.data) do lines[#lines + 1] = data_line(item) end
  if self.told then
    lines[#lines + 1] = ("  chi2 %.4g with %d degrees of freedom"):format(self.chi2, self.freedom)
  end
  for _, note in ipairs(self.notes) do lines[#lines + 1] = wrapped(note) end
  return table.concat(lines, "\n")
end

-- --- making --------------------------------------------------------------------------------------

local function sum_of_squares(problem, values)
  local residuals, sum = problem:residuals(values), 0
  for i = 1, #problem.measured do sum = sum + residuals[i] ^ 2 end
  return sum
end

-- Returns the factor from the errors of the data to the errors of the values. Residuals above the given errors
-- increase it only for values that change in steps, whose scatter is known only approximately.
local function scale_of(self, problem)
  if not self.told then return math.sqrt(self.reduced) end
  return next(problem.rippled) and math.sqrt(math.max(1, self.reduced)) or 1
end

local function head(list, count) return table.move(list, 1, count, 1, {}) end

-- Makes the result of a fit. problem: from fit/problem.lua; found: from fit/solve.lua; told: true if the user
-- gave the errors of the data; confidence: confidence level between 0 and 1.
function result.new(problem, found, told, confidence)
  local m, count = #problem.unknowns, #problem.measured
  local self = { told = told, confidence = confidence, count = count, iterations = found.iterations,
    runs = problem.runs.count, noise = problem.noise, smooth = problem.smooth, bounds = problem.unknowns }
  self.chi2, self.freedom = sum_of_squares(problem, found.values), count - #problem.parameters
  self.reduced = self.chi2 / math.max(1, self.freedom)
  local scale = scale_of(self, problem)
  self.times = statistics.student(confidence, told and statistics.known or self.freedom)
  local deviation = deviations(found, problem, scale)
  self.names, self.units, self.values, self.errors = {}, {}, head(found.values, m), head(deviation, m)
  self.margins, self.changes = {}, head(found.by_mesh or {}, m)
  self.mesh = found.by_mesh and by_path(problem, self.changes)
  local low, high = {}, {}
  for i, one in ipairs(problem.unknowns) do
    self.names[i], self.units[i] = one.name, one.unit
    self.margins[i] = self.times * self.errors[i]
      + (found.by_mesh and by_mesh * math.max(math.abs(self.changes[i]), found.mesh_scatter[i]) or 0)
    low[i] = clipped(one, self.values[i] - self.margins[i])
    high[i] = clipped(one, self.values[i] + self.margins[i])
  end
  self.value, self.error = by_path(problem, self.values), by_path(problem, self.errors)
  self.low, self.high = by_path(problem, low), by_path(problem, high)
  self.covariance, self.correlation = found.covariance, correlations(found)
  self.data = described(self, problem, found, scale, deviation)
  self.curve, self.band = curves(self, problem, found, scale)
  self.notes = notes_of(self, problem, found, deviation)
  self.wear = problem.runs:wear(self.values)
  return setmetatable(self, class)
end

strict.class(class)
return result

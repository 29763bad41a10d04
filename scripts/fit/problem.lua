-- Defines a fit as a least-squares problem. The parameters are the unknowns, followed by the positions of
-- profiles and loops. The module computes weighted residuals and their derivatives. Derivatives are
-- differences of runs, with steps that depend on the numerical noise of the runs.

local check = require "archard.lib.check"
local data = require "archard.fit.data"
local slope = require "archard.uncertainty.slope"
local unknown = require "archard.fit.unknown"

local problem = {}
problem.__index = problem

-- --- residuals -----------------------------------------------------------------------------------

-- Returns the position { shift=, tilt=, level= } of item `number`. values: the values of all parameters.
function problem:position(number, values)
  local fixed = self.items[number].fixed or {}
  local position = { shift = fixed.shift or 0, tilt = fixed.tilt or 0, level = fixed.level or 0 }
  for i, one in ipairs(self.positions) do
    if one.item == number then position[one.kind] = values[#self.unknowns + i] end
  end
  return position
end

-- Returns the simulated values at all data points in one list, each divided by the standard error of the
-- measured value.
function problem:predict(readings, values)
  local list = {}
  for number, item in ipairs(self.items) do
    for i, value in ipairs(data.values(item, readings, self:position(number, values))) do
      list[#list + 1] = value / item.error[i]
    end
  end
  return list
end

function problem:runs_at(values)
  return self.runs:one(table.move(values, 1, #self.unknowns, 1, {}))
end

-- Returns the residuals (simulated - measured) / error of all data, followed by the weighted roughness of the
-- fitted curves.
function problem:residuals(values)
  local list = self:predict(self:runs_at(values), values)
  for i, measured in ipairs(self.measured) do list[i] = list[i] - measured end
  for _, row in ipairs(self.rough) do
    local sum = 0
    for j, factor in pairs(row) do sum = sum + factor * values[j] end
    list[#list + 1] = math.sqrt(self.smooth) * sum
  end
  return list
end

-- Returns the residuals for the parameter values of the latest call of jacobian. Simulated values that change
-- in steps are replaced by the values of their regression lines.
function problem:smoothed_residuals(values)
  local list = self:residuals(values)
  for m, middle in pairs(self.rippled) do list[m] = middle - self.measured[m] end
  return list
end

-- Returns the root of the sum of squared residuals divided by the degrees of freedom. It is about 1 if the
-- given errors of the data are correct.
function problem:error_scale(values)
  local residuals, sum = self:residuals(values), 0
  for i = 1, #self.measured do sum = sum + residuals[i] ^ 2 end
  return math.sqrt(sum / math.max(1, #self.measured - #self.parameters))
end

-- --- derivatives ---------------------------------------------------------------------------------

local function changed(values, i, by)
  local copy = table.move(values, 1, #values, 1, {})
  copy[i] = copy[i] + by
  return copy
end

-- Returns the two steps of a difference quotient: up and down if `central` is true and the bounds allow
-- both, else one step and 0.
local function stencil(self, values, i, central)
  local one = self.parameters[i]
  local step = self.step[central and "central" or "forward"] * one.span
  if one.low and not one.high then step = step * (values[i] - one.low) / one.span end
  local up = not one.high or values[i] + step < one.high
  local down = not one.low or values[i] - step > one.low
  if central and up and down then return step, -step end
  return up and step or -step, 0
end

local function column_between(high, low, width)
  local column = {}
  for i = 1, #high do column[i] = (high[i] - low[i]) / width end
  return column
end

-- Returns the derivative of the simulated values with respect to a position parameter. This needs no new run.
local function position_column(self, readings, values, i)
  local step = 1e-3 * self.parameters[i].span
  local up, down = changed(values, i, step), changed(values, i, -step)
  return column_between(self:predict(readings, up), self:predict(readings, down), 2 * step)
end

-- Some simulated values change in steps, because the contact edge moves from node to node. Their
-- derivatives are computed over a wide range of the parameter. widest: half of this range, relative to the
-- parameter's value; many: number of intervals for the standard errors; few: number of intervals during the
-- search; closest: if a bound makes one side of the range shorter than this fraction of the value, this
-- side is omitted.
problem.widest, problem.many = 0.24, 8
local few, closest = 4, 0.05

local function wide_range(one, value, widest)
  local reach = widest * math.min(one.span, math.max(math.abs(value), one.span / 4))
  local down = math.min(reach, one.low and 0.9 * (value - one.low) or reach)
  local up = math.min(reach, one.high and 0.9 * (one.high - value) or reach)
  if down < closest * reach / widest then down = 0 end
  if up < closest * reach / widest then up = 0 end
  return -down, up
end

local function spread(low, high, intervals)
  local list = {}
  for j = 0, intervals do list[j + 1] = low + (high - low) * j / intervals end
  return list
end

-- Replaces the derivatives of values that change in small steps (such as widths, which are multiples of the
-- node spacing), because their difference quotients are meaningless. Column i is filled with slopes of
-- regression lines over a wide range of parameter i. The value of each line in the middle of the range,
-- averaged over the unknowns, is added to self.rippled.
local function fill_rippled(self, column, values, i, central)
  local low, high = wide_range(self.unknowns[i], values[i], self.widest)
  local points, list, rows = spread(low, high, central and self.many or few), {}, {}
  for p, by in ipairs(points) do list[p] = changed(table.move(values, 1, #self.unknowns, 1, {}), i, by) end
  for p, readings in ipairs(self.runs:many(list)) do rows[p] = self:predict(readings, values) end
  local unit = high - low
  for p, by in ipairs(points) do points[p] = by / unit end
  for m in pairs(self.rippled) do
    local y = {}
    for p in ipairs(points) do y[p] = rows[p][m] end
    local one = slope(points, y)
    column[m] = one.value / unit
    self.rippled[m] = self.rippled[m] + one.middle / #self.unknowns
  end
end

-- Returns the derivatives of the simulated values (divided by the errors), one column for each parameter.
-- central: true for central differences where the bounds allow them.
function problem:jacobian(values, central)
  local m, list, stencils = #self.unknowns, {}, {}
  local own = table.move(values, 1, m, 1, {})
  for i = 1, m do
    local high, low = stencil(self, values, i, central)
    stencils[i] = { high, low }
    list[2 * i - 1], list[2 * i] = changed(own, i, high), changed(own, i, low)
  end
  list[2 * m + 1] = own
  local readings, columns = self.runs:many(list), {}
  for row in pairs(self.rippled) do self.rippled[row] = 0 end
  for i = 1, m do
    columns[i] = column_between(self:predict(readings[2 * i - 1], values),
      self:predict(readings[2 * i], values), stencils[i][1] - stencils[i][2])
    if next(self.rippled) then fill_rippled(self, columns[i], values, i, central) end
  end
  for i = m + 1, #self.parameters do
    columns[i] = position_column(self, readings[2 * m + 1], values, i)
  end
  return columns
end

-- Appends the derivatives of the roughness to each column of derivatives. Returns the columns.
function problem:with_roughness(columns)
  for i, column in ipairs(columns) do
    for r, row in ipairs(self.rough) do
      column[#self.measured + r] = math.sqrt(self.smooth) * (row[i] or 0)
    end
  end
  return columns
end

-- --- noise ---------------------------------------------------------------------------------------

local samples, spacing = 5, 1e-3

-- Estimates the numerical noise of the runs and chooses the steps of the differences. The results of runs
-- with automatic steps scatter slightly with the values of the unknowns. This noise is estimated from fourth
-- differences of runs with close values (Hamming's method, as used by More and Wild). The chosen step
-- minimizes the sum of the errors caused by noise and by curvature.
function problem:measure_noise(values)
  local list = {}
  for s = 1, samples do
    list[s] = table.move(values, 1, #self.unknowns, 1, {})
    for i, one in ipairs(self.unknowns) do
      local inward = one.high and values[i] + samples * spacing * one.span > one.high and -1 or 1
      list[s][i] = values[i] + inward * (s - 1) * spacing * math.min(one.span, math.abs(values[i]) > 0
        and math.abs(values[i]) or one.span)
    end
  end
  local readings, rows = self.runs:many(list), {}
  for s = 1, samples do rows[s] = self:predict(readings[s], values) end
  local noise, slope, n = 0, 0, #rows[1]
  for i = 1, n do
    local a, b, c, d, e = rows[1][i], rows[2][i], rows[3][i], rows[4][i], rows[5][i]
    noise = noise + (a - 4 * b + 6 * c - 4 * d + e) ^ 2 / 70
    slope = slope + ((e - a) / 4 / spacing) ^ 2
  end
  self.noise = slope > 0 and math.sqrt(noise / slope) or 0
  local function bounded(step) return math.max(1e-4, math.min(step, 0.05)) end
  self.step = { forward = bounded(math.sqrt(2 * self.noise)), central = bounded(10 * self.noise ^ (1 / 3)) }
  self.step.central = math.max(self.step.central, 1e-3)
end

-- --- values that change in steps ------------------------------------------------------------------

-- Limits for values that change in steps. jumps_above: smallest jump between neighbours, relative to the
-- slope; counts: smallest scatter that is added to the error, relative to the error.
local jumps_above, counts = 0.03, 0.2

-- Computes runs in which all unknowns change together over a wide range. Returns the positions in the range
-- (-0.5 to 0.5) and the simulated values.
local function wide_rows(self, values)
  local points, list, rows = spread(-0.5, 0.5, 2 * self.many), {}, {}
  for p, t in ipairs(points) do
    list[p] = table.move(values, 1, #self.unknowns, 1, {})
    for i, one in ipairs(self.unknowns) do
      local low, high = wide_range(one, values[i], self.widest)
      list[p][i] = values[i] + low + (high - low) * (t + 0.5)
    end
  end
  for p, readings in ipairs(self.runs:many(list)) do rows[p] = self:predict(readings, values) end
  return points, rows
end

local function has_jumping(items)
  for _, item in ipairs(items) do
    if data.jumps(item) then return true end
  end
  return false
end

-- Marks the simulated values that change in steps. If the user gave errors, the scatter of these values is
-- added to the errors.
function problem:measure_ripple(values, told)
  if not has_jumping(self.items) then return end
  local points, rows = wide_rows(self, values)
  local m = 0
  for _, item in ipairs(self.items) do
    for i = 1, #item.x do
      m = m + 1
      local y = {}
      for p in ipairs(points) do y[p] = rows[p][m] end
      local one = slope(points, y)
      if data.jumps(item) and one.ripple > jumps_above then
        self.rippled[m] = 0
        if told and one.scatter > counts then
          item.rippled = math.max(item.rippled or 0, one.scatter * item.error[i])
          item.error[i] = item.error[i] * math.sqrt(1 + one.scatter ^ 2)
        end
      end
    end
  end
  self:weigh()
end

-- --- making --------------------------------------------------------------------------------------

-- Raises an error if an unknown has no effect on any measured value.
function problem:refuse_idle(columns)
  for i, one in ipairs(self.unknowns) do
    local sum = 0
    for _, value in ipairs(columns[i]) do sum = sum + value * value end
    if math.sqrt(sum) * one.span <= 1e-6 then
      check.fail(self.where, ("unknown '%s' has no effect on any measured value; "
        .. "remove it, or add a measurement that depends on it"):format(one.name))
    end
  end
end

-- Makes the problem of a fit. unknowns: parameters from fit/unknown.lua; items: measurements from
-- fit/data.lua; runs: collection of runs from fit/runs.lua.
function problem.new(where, unknowns, items, runs)
  local self = setmetatable({ where = where, unknowns = unknowns, items = items, runs = runs,
    -- rippled: values of the regression lines in the middle of the range, by index of the residual
    positions = data.positions(items), parameters = {}, rough = {}, smooth = 0, rippled = {},
    step = { forward = 1e-4, central = 1e-3 } }, problem)
  for _, one in ipairs(unknowns) do self.parameters[#self.parameters + 1] = one end
  for _, one in ipairs(self.positions) do self.parameters[#self.parameters + 1] = one end
  self:weigh()
  return self
end

-- Divides the measured values by their errors and stores the list in self.measured.
function problem:weigh()
  self.measured = {}
  for _, item in ipairs(self.items) do
    for i, value in ipairs(item.value) do self.measured[#self.measured + 1] = value / item.error[i] end
  end
end

-- Sets the weight of the roughness of the fitted curves.
function problem:smooth_by(weight)
  self.smooth = weight
  self.rough = weight > 0 and unknown.roughness(self.unknowns) or {}
end

return problem

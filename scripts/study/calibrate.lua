-- calibrate: from measured wear to k and alpha. Volumes give them directly (Eqs. 1, 12), with the
-- spread of repeated measurements; depths need the simulation, whose alpha is searched.

local check = require "archard.lib.check"

local where = "calibrate"

-- --- what is given -------------------------------------------------------------------------------

local pair = check.kind("a table { cylinder=, plate= } of numbers or lists of numbers",
  check.table.test)
local fields = { volume = pair, depth = pair, load = check.positive, distance = check.positive,
  accuracy = check.share }
-- A search by depth may have the fields of wear{}, but not the one it looks for, another load, or a
-- shape to start from.
for _, setting in ipairs(require "archard.settings".wear) do
  fields[setting.name] = fields[setting.name] or check.any "a field of wear{}"
end
fields.alpha, fields.loading, fields.worn = nil, nil, nil

local function measurements(name, given)
  if given == nil then
    check.fail(where, ("field '%s': expected the measured wear, got none (0: too little to measure)")
      :format(name))
  end
  local list = type(given) == "table" and given or { given }
  for i = 1, math.max(#list, 1) do
    local value = list[i]
    if type(value) ~= "number" or value ~= value or value < 0 or value == math.huge then
      check.refuse(where, name, "a number >= 0 or a list of them", value)
    end
  end
  return list
end

-- Both bodies' measurements, as many of one as of the other: each pair is of one test. A plain 0
-- stands for a body whose wear was too little to measure in all of them.
local function read_pair(name, given)
  check.fields(where, given, { cylinder = check.any "numbers", plate = check.any "numbers" },
    name .. ".")
  local cylinder = measurements(name .. ".cylinder", given.cylinder)
  local plate = measurements(name .. ".plate", given.plate)
  if #cylinder ~= #plate and given.cylinder ~= 0 and given.plate ~= 0 then
    check.fail(where, ("fields '%s.cylinder' and '%s.plate': expected as many measurements of one as "
      .. "of the other, got %d and %d"):format(name, name, #cylinder, #plate))
  end
  return cylinder, plate
end

-- --- statistics ----------------------------------------------------------------------------------

local function mean(list)
  local sum = 0
  for _, value in ipairs(list) do sum = sum + value end
  return sum / #list
end

-- Standard deviation of the sample; nil for one measurement.
local function deviation(list)
  if #list < 2 then return nil end
  local middle, sum = mean(list), 0
  for _, value in ipairs(list) do sum = sum + (value - middle) ^ 2 end
  return math.sqrt(sum / (#list - 1))
end

-- Of a sum and of a share, from the deviations of its two parts (errors that do not know of each
-- other; first order).
local function spread_of_sum(a, b)
  if not (a or b) then return nil end
  return math.sqrt((a or 0) ^ 2 + (b or 0) ^ 2)
end

local function spread_of_share(c, p, spread_c, spread_p)
  if not (spread_c or spread_p) then return nil end
  local total = c + p
  return math.sqrt((p * (spread_c or 0)) ^ 2 + (c * (spread_p or 0)) ^ 2) / total ^ 2
end

-- --- from volumes --------------------------------------------------------------------------------

local function from_volumes(given)
  if not (given.load and given.distance) then
    check.fail(where, "volumes need the fields 'load' [N] and 'distance' [mm] of the test")
  end
  local cylinder, plate = read_pair("volume", given.volume)
  local c, p = mean(cylinder), mean(plate)
  if c + p <= 0 then
    check.fail(where, "field 'volume': expected wear of at least one body, got none")
  end
  local work = given.load * given.distance
  local spread_c, spread_p = deviation(cylinder), deviation(plate)
  local function over_work(value) return value and value / work end
  return { k = (c + p) / work, k_cylinder = c / work, k_plate = p / work, alpha = c / (c + p),
    spread = { k = over_work(spread_of_sum(spread_c, spread_p)), k_cylinder = over_work(spread_c),
      k_plate = over_work(spread_p), alpha = spread_of_share(c, p, spread_c, spread_p) },
    measurements = math.max(#cylinder, #plate) }
end

-- --- from depths ---------------------------------------------------------------------------------

local not_of_wear = { volume = true, depth = true, accuracy = true }

-- The simulated alpha-tilde at the end, for an alpha.
local function simulated(given, alpha)
  local run_fields = { alpha = alpha }
  for name, value in pairs(given) do
    if not not_of_wear[name] then run_fields[name] = value end
  end
  local run <close> = wear(run_fields)
  run:run{ progress = function() end }
  return run.depth_partition, run.depth.cylinder + run.depth.plate
end

-- The alpha in [0, 1] whose alpha-tilde is `wanted`: it grows with alpha. Straight lines between the
-- last two brackets, halved where those crawl. Returns alpha, the sum of depths there, the runs.
local function search(given, wanted, room)
  if wanted <= 0 or wanted >= 1 then return wanted, nil, 0 end
  local low, high = { 0, -wanted }, { 1, 1 - wanted }
  local side = 0
  for run = 1, 40 do
    local alpha = low[1] - low[2] * (high[1] - low[1]) / (high[2] - low[2])
    local share, sum = simulated(given, alpha)
    local off = share - wanted
    if math.abs(off) <= room then return alpha, sum, run end
    if off < 0 then
      low = { alpha, off }
      if side == -1 then high[2] = high[2] / 2 end
      side = -1
    else
      high = { alpha, off }
      if side == 1 then low[2] = low[2] / 2 end
      side = 1
    end
  end
  check.fail(where, ("no alpha found whose depths share as measured (%g of the sum in the cylinder)")
    :format(wanted), "NOT_CONVERGED")
end

local function from_depths(given)
  local cylinder, plate = read_pair("depth", given.depth)
  local c, p = mean(cylinder), mean(plate)
  if c + p <= 0 then
    check.fail(where, "field 'depth': expected wear of at least one body, got none")
  end
  local wanted, room = c / (c + p), given.accuracy or 1e-4
  local alpha, sum, runs = search(given, wanted, room)
  local spread = spread_of_share(c, p, deviation(cylinder), deviation(plate))
  local result = { alpha = alpha, depth_partition = wanted, runs = runs, simulated_depth = sum,
    measured_depth = c + p, spread = { depth_partition = spread },
    measurements = math.max(#cylinder, #plate) }
  if spread and wanted > 0 and wanted < 1 then
    local above = search(given, math.min(wanted + spread, 1), room)
    local below = search(given, math.max(wanted - spread, 0), room)
    result.spread.alpha = (above - below) / 2
  end
  return result
end

-- --- showing -------------------------------------------------------------------------------------

local shown = {
  { "alpha", "%.4f", "wear partition factor" },
  { "k", "%.4g", "mm2/N, of the couple" },
  { "k_cylinder", "%.4g", "mm2/N" },
  { "k_plate", "%.4g", "mm2/N" },
  { "depth_partition", "%.4f", "measured alpha-tilde" },
}

local class = { __name = "calibration" }

function class.__tostring(self)
  local lines = { ("calibration from %s"):format(self.measurements == 1 and "one measurement"
    or self.measurements .. " measurements") }
  for _, each in ipairs(shown) do
    local value, spread = self[each[1]], self.spread[each[1]]
    if value then
      lines[#lines + 1] = ("  %-16s %s%s  %s"):format(each[1], each[2]:format(value),
        spread and " +- " .. each[2]:format(spread) or "", each[3])
    end
  end
  if self.simulated_depth then
    lines[#lines + 1] = ("  depths together  %.4g um simulated, %.4g um measured"):format(
      1e3 * self.simulated_depth, 1e3 * self.measured_depth)
  end
  return table.concat(lines, "\n")
end

-- calibrate{ volume={cylinder=,plate=}, load=, distance= } -> k, k_cylinder, k_plate, alpha
-- calibrate{ depth={cylinder=,plate=}, stroke=, ... fields of wear{} } -> alpha
return function(given)
  check.definition(where, given, fields)
  if (given.volume == nil) == (given.depth == nil) then
    check.fail(where, "fields 'volume' and 'depth': expected one of them, got "
      .. (given.volume and "both" or "neither"))
  end
  return setmetatable(given.volume and from_volumes(given) or from_depths(given), class)
end

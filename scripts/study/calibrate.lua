-- Lua function calibrate: computes k and alpha from measured wear. Measured volumes determine both directly
-- (Eqs. 1, 12), as numbers with the spread of repeated measurements or as tables over the sliding distance
-- (study/volumes.lua). Measured depths need repeated simulations (study/depths.lua).

local check = require "archard.lib.check"
local k_doubt = require "archard.lib.k_doubt"
local depths = require "archard.study.depths"
local merged = require "archard.lib.merged"
local statistics = require "archard.lib.statistics"
local strict = require "archard.strict"
local volumes = require "archard.study.volumes"

local where = "calibrate"

-- --- the fields ----------------------------------------------------------------------------------

local pair = check.kind("a table { cylinder=, plate= } of numbers or lists of numbers",
  check.table.test)
local distances = check.list_of(check.positive, "a list of increasing numbers > 0", true)
local fields = { volume = pair, depth = pair, load = check.positive, accuracy = check.share,
  confidence = check.share, error = check.positive,
  distance = check.kind("a number > 0 or a list of increasing numbers", function(v)
    return check.positive.test(v) or distances.test(v)
  end) }
-- Calibration with measured depths also accepts the fields of wear{}, except alpha, loading and worn.
for _, setting in ipairs(require "archard.settings".wear) do
  fields[setting.name] = fields[setting.name] or check.any "a field of wear{}"
end
fields.alpha, fields.loading, fields.worn = nil, nil, nil

local function measurements(name, given)
  if given == nil then
    check.fail(where, ("field '%s': expected the measured wear, got none (0 if it was too small to measure or "
      .. "not measured)"):format(name))
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

-- Reads the measurements of both bodies as two lists. Values with the same index belong to the same test. A
-- single 0 instead of a list means that the wear of this body was too small to measure in all tests.
local function read_pair(name, given)
  given = check.fields(where, given, { cylinder = check.any "numbers", plate = check.any "numbers" },
    name .. ".")
  local cylinder = measurements(name .. ".cylinder", given.cylinder)
  local plate = measurements(name .. ".plate", given.plate)
  if #cylinder ~= #plate and given.cylinder ~= 0 and given.plate ~= 0 then
    check.fail(where, ("fields '%s.cylinder' and '%s.plate': expected the same number of "
      .. "measurements, got %d and %d"):format(name, name, #cylinder, #plate))
  end
  return cylinder, plate
end

-- --- from volumes --------------------------------------------------------------------------------

local function filled(count, value)
  local list = {}
  for i = 1, count do list[i] = value end
  return list
end

-- If one list has a single value, repeats the value, so that both lists have equal lengths.
local function even(cylinder, plate)
  local count = math.max(#cylinder, #plate)
  if #cylinder < count then cylinder = filled(count, cylinder[1]) end
  if #plate < count then plate = filled(count, plate[1]) end
  return cylinder, plate
end

local function refuse_none(c, p, name)
  if c + p <= 0 then
    check.fail(where, ("field '%s': expected wear > 0 of at least one body, got 0 for both"):format(name))
  end
end

local function from_volumes(given)
  local cylinder, plate = even(read_pair("volume", given.volume))
  refuse_none(statistics.mean(cylinder), statistics.mean(plate), "volume")
  local whole = volumes.stretch(cylinder, plate, given.load * given.distance, given.confidence,
    given.error)
  local result = whole.mean
  result.spread, result.low, result.high = whole.spread, whole.low, whole.high
  result.measurements, result.confidence = #cylinder, given.confidence
  return result
end

-- --- from volumes at several distances -------------------------------------------------------------

-- Returns the volumes of one body as a list of tests. Each test is a list with one volume for each distance.
local function read_tests(name, given, count)
  if given == 0 then return { filled(count, 0) } end
  local tests = type(given) == "table" and type(given[1]) == "table" and given or { given }
  for i, test in ipairs(tests) do
    local label = name .. (#tests > 1 and ("[%d]"):format(i) or "")
    if type(test) ~= "table" or #test ~= count then
      check.refuse(where, label, ("a list of %d volumes, one for each distance"):format(count), test)
    end
    measurements(label, test)
  end
  return tests
end

-- Returns the volumes of all tests at the distance with index `i`.
local function column(tests, i)
  local list = {}
  for t, test in ipairs(tests) do list[t] = test[i] end
  return list
end

local function refuse_falling(name, tests, count)
  for i = 2, count do
    if statistics.mean(column(tests, i)) < statistics.mean(column(tests, i - 1)) then
      check.fail(where, ("field '%s': expected the volume lost since the start, but the volume at distance no. %d is "
        .. "smaller than at no. %d"):format(name, i, i - 1))
    end
  end
end

local function from_courses(given)
  local count = #given.distance
  local volume = check.fields(where, given.volume, { cylinder = check.any "lists", plate = check.any "lists" }, "volume.")
  local cylinder = read_tests("volume.cylinder", volume.cylinder, count)
  local plate = read_tests("volume.plate", volume.plate, count)
  if #cylinder ~= #plate and volume.cylinder ~= 0 and volume.plate ~= 0 then
    check.fail(where, ("fields 'volume.cylinder' and 'volume.plate': expected the same number "
      .. "of tests, got %d and %d"):format(#cylinder, #plate))
  end
  cylinder, plate = even(cylinder, plate)
  refuse_falling("volume.cylinder", cylinder, count)
  refuse_falling("volume.plate", plate, count)
  local last = { cylinder = column(cylinder, count), plate = column(plate, count) }
  local mean = from_volumes{ volume = last, load = given.load, distance = given.distance[count],
    confidence = given.confidence, error = given.error }
  local result, bands = volumes.course(given.distance, cylinder, plate, given)
  result.mean, result.band, result.spread = mean, bands, mean.spread
  result.measurements, result.points, result.confidence = #cylinder, count, given.confidence
  return result
end

local function with_confidence(given)
  if not (given.load and given.distance) then
    check.fail(where, "with measured volumes, give the fields 'load' [N] and 'distance' [mm] of the test")
  end
  return merged(given, { confidence = given.confidence or 0.95 })
end

-- --- from depths ---------------------------------------------------------------------------------

local not_of_wear = { volume = true, depth = true, accuracy = true, confidence = true, error = true }

-- Raises an error if the load or the sliding distance of the test is missing. Calibration with measured
-- depths needs both.
local function need_test(given)
  if given.load and (given.distance or given.cycles) then return end
  check.fail(where, "with measured depths, give the fields 'load' [N] and 'distance' [mm] (or 'cycles') of the test")
end

local function from_depths(given)
  need_test(given)
  local cylinder, plate = even(read_pair("depth", given.depth))
  for i, c in ipairs(cylinder) do refuse_none(c, plate[i], "depth") end
  local of_wear = {}
  for name, value in pairs(given) do
    if not not_of_wear[name] then of_wear[name] = value end
  end
  local result = depths.find(cylinder, plate, { fields = of_wear, accuracy = given.accuracy or 1e-4 })
  result.spread.depth_partition = volumes.stretch(cylinder, plate, 1, 0.95).spread.alpha
  return result
end

-- --- showing -------------------------------------------------------------------------------------

local shown = {
  { "alpha", "%.4f", "wear partition factor" },
  { "k", "%.4g", "mm2/N, sum of both bodies" },
  { "k_cylinder", "%.4g", "mm2/N" },
  { "k_plate", "%.4g", "mm2/N" },
  { "depth_partition", "%.4f", "the cylinder's share of the measured depths" },
}

local class = strict.class{ __name = "calibration", __fields = { "k", "alpha", "k_cylinder", "k_plate",
  "depth_partition", "spread", "low", "high", "confidence", "measurements", "points", "band", "mean",
  "simulated_depth", "measured_depth", "conditions", "runs" } }

-- Returns a line of text with the value of a quantity and, if known, its spread and its confidence interval.
local function number_line(self, name, format, text)
  local value, spread = self[name], self.spread[name]
  local low, high = (self.low or {})[name], (self.high or {})[name]
  return ("  %-16s %s%s%s  %s"):format(name, format:format(value),
    spread and " +- " .. format:format(spread) or "",
    low and (", %s to %s"):format(format:format(low), format:format(high)) or "",
    (text:gsub("mm2/N", ("mm2/N = %.4g mm3/(N m)"):format(1e3 * value))))
end

local function add_numbers(lines, self)
  for _, each in ipairs(shown) do
    if self[each[1]] then lines[#lines + 1] = number_line(self, table.unpack(each)) end
  end
  if self.low and next(self.low) then
    lines[#lines + 1] = ("  +-: standard deviation of one test; range: of the mean at %g %% confidence"):format(
      100 * self.confidence)
  end
end

-- Adds the table of k and alpha over the sliding distance to `lines`, with one line for each interval.
local function add_course(lines, self)
  lines[#lines + 1] = "  distance [mm]   k [mm2/N]                        alpha"
  local k, alpha = self.band.k, self.band.alpha
  for i = 1, #k.value do
    local from, to = self.k.distance[2 * i - 1], self.k.distance[2 * i]
    local function range(band, format)
      local range_of = band.low[i] and (" (%s to %s)"):format(format:format(band.low[i]),
        format:format(band.high[i])) or ""
      return format:format(band.value[i]) .. range_of
    end
    lines[#lines + 1] = ("  %-14s  %-31s  %s"):format(("%g to %g"):format(from, to),
      range(k, "%.3g"), range(alpha, "%.3f"))
  end
  lines[#lines + 1] = "  over the whole distance:"
  add_numbers(lines, self.mean)
end

function class.__tostring(self)
  local lines = { ("calibration from %s"):format(self.measurements == 1 and "one measurement"
    or self.measurements .. " measurements") }
  if self.band then
    lines[1] = ("calibration from %d test%s at %d distances"):format(self.measurements,
      self.measurements == 1 and "" or "s", self.points)
    add_course(lines, self)
  else
    add_numbers(lines, self)
  end
  if self.simulated_depth then
    lines[#lines + 1] = ("  sum of both depths  %.4g um simulated, %.4g um measured"):format(
      1e3 * self.simulated_depth, 1e3 * self.measured_depth)
    for i, condition in ipairs(self.conditions or {}) do
      lines[#lines + 1] = ("  %-19s%s"):format(i == 1 and "simulated with" or "", condition)
    end
  end
  return table.concat(lines, "\n")
end

local function find(given)
  if given.depth then return from_depths(given) end
  given = with_confidence(given)
  return type(given.distance) == "table" and from_courses(given) or from_volumes(given)
end

-- calibrate{ volume={cylinder=,plate=}, load=, distance= } returns k, k_cylinder, k_plate, alpha.
-- calibrate{ distance={...}, volume={cylinder={...},plate={...}}, load= } returns these quantities as tables
-- over the distance.
-- calibrate{ depth={cylinder=,plate=}, load=, distance=, stroke=, ... fields of wear{} } returns k and alpha.
return function(given)
  given = check.definition(where, given, fields)
  if (given.volume == nil) == (given.depth == nil) then
    check.fail(where, "fields 'volume' and 'depth': expected one of them, got "
      .. (given.volume and "both" or "neither"))
  end
  if given.depth and type(given.distance) == "table" then
    check.refuse(where, "distance", "a number > 0, as 'depth' is given", given.distance)
  end
  local found = setmetatable(find(given), class)
  k_doubt(where, found.k, "are the volumes in mm3 and the distance in mm?")
  return found
end

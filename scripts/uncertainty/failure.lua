-- Lua method s:failure{}: returns the probability that a result exceeds a limit at any time in a run, or up
-- to a distance. The probability is estimated as the fraction of the samples that exceed the limit.

local check = require "archard.lib.check"
local history_at = require "archard.lib.history_at"
local outcomes = require "archard.uncertainty.outcomes"
local sampled = require "archard.uncertainty.sampled"
local strict = require "archard.strict"

local where = "study:failure"

local class = strict.class{ __name = "failure", __fields = { "of", "above", "below", "before", "n", "count",
  "failed", "probability", "low", "high", "confidence", "course" } }

local fields = { of = check.text, above = check.number, below = check.number, before = check.positive,
  confidence = check.share }

-- Returns a function(value) that returns true if the value exceeds the limit.
local function test_of(given)
  if (given.above == nil) == (given.below == nil) then
    check.fail(where, ("fields 'above' and 'below': expected one of them, got %s"):format(
      given.above and "both" or "neither"))
  end
  if given.above then return function(value) return value > given.above end end
  return function(value) return value < given.below end
end

local function check_reached(history, before)
  local last = history.distance[#history.distance]
  if before and before > last * (1 + 1e-9) then
    check.fail(where, ("field 'before': expected at most %g mm, the distance at which a case ends, got %g")
      :format(last, before))
  end
end

-- Returns true if the result exceeds the limit in any row of the history up to the distance `before` [mm], or
-- at this distance. Without `before`, all rows are checked.
local function passes(history, name, past, before)
  check_reached(history, before)
  for i, d in ipairs(history.distance) do
    if before and d > before then break end
    if past(history[name][i]) then return true end
  end
  return before ~= nil and past(history_at(history, name, before))
end

-- Warns if a limit is far above all values, which are then probably in another unit.
local function warn_of_unit(given, largest)
  local far = 100 -- ratio of limit and value; scatter is smaller
  if not given.above or given.above <= far * largest or largest <= 0 then return end
  warn(("%s: the limit, %g %s, is %.2g times the largest %s of all samples, %.3g %s: is it in this unit?"):format(
    where, given.above, outcomes.unit(given.of), given.above / largest, given.of, largest, outcomes.unit(given.of)))
end

function class.__tostring(self)
  return ("probability that %s is %s %g %s%s: %.4g\n  %.4g to %.4g at %g %% confidence\n"
    .. "  %d of %d samples are beyond the limit%s\n  probability from the first half of the samples: %.4g"):format(
    self.of, self.above and "above" or "below", self.above or self.below, outcomes.unit(self.of),
    self.before and (" before %g mm"):format(self.before) or "", self.probability, self.low, self.high,
    100 * self.confidence, self.count, self.n,
    self.failed > 0 and ("; %d failed cases are omitted"):format(self.failed) or "",
    self.course.probability[1])
end

return function(study, given)
  given = check.definition(where, given, fields)
  if given.of == nil then check.refuse(where, "of", "the name of a column of the history", nil) end
  outcomes.names(where, given.of, outcomes.first(study, where).history)
  local past, passed, largest = test_of(given), {}, 0
  local failed = outcomes.each(study, where, function(number, history)
    if not outcomes.is_sample(study, number) then return end
    passed[#passed + 1] = passes(history, given.of, past, given.before)
    for _, value in ipairs(history[given.of]) do if value > largest then largest = value end end
  end)
  warn_of_unit(given, largest)
  local count, half = 0, 0
  for i, yes in ipairs(passed) do
    count = count + (yes and 1 or 0)
    if i == #passed // 2 then half = count end
  end
  local confidence = given.confidence or 0.95
  local low, high = sampled.share_range(count, #passed, confidence)
  return setmetatable({ of = given.of, above = given.above, below = given.below, before = given.before,
    n = #passed, count = count, failed = failed, probability = count / #passed, low = low, high = high,
    confidence = confidence, course = { n = { #passed // 2, #passed },
      probability = { half / (#passed // 2), count / #passed } } }, class)
end

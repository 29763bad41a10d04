-- Searches for the numerical settings of a wear run (Sec. 4.4 of the paper). The first search determines the
-- element size from the unworn contact. The second determines the cycles per update and the increments per
-- cycle, such that the surfaces remain smooth and symmetric.
-- search(given, on_progress) returns the results. given: the fields of wear{}; given.converge may contain
-- limits that replace the limits below.

local hertz_of = require "archard.lib.hertz_of"
local measure = require "archard.measure"
local merged = require "archard.lib.merged"
local quiet = require "archard.lib.quiet"

local limits = {
  pressure = 0.01,     -- largest error of the contact pressure, as a fraction of the Hertz pressure
  -- largest allowed oscillation of the pressure from node to node (sawtooth) in the middle of the contact,
  -- as a fraction of p_center, minus the oscillation in a run with a small jump
  smooth = 0.005,
  -- largest allowed difference between a profile and its mirror image, as a fraction of the depth
  symmetric = 1e-3,
  -- largest allowed difference between a profile and a profile computed with many increments per cycle, as
  -- a fraction of the depth
  profile = 0.005,
  updates = 100,       -- largest number of updates in a trial run
  first_depth = 1e-4,  -- depth of the first update at the initial guess of the jump, Eq. (28) [mm]
}

local usual_increments = 200 -- increments per cycle during the search for the jump

local search = { limits = limits }

-- --- the mesh --------------------------------------------------------------------------------------

-- Rounds a number > 0 to one significant digit.
local function rounded(value)
  local unit = 10 ^ math.floor(math.log(value, 10))
  return math.floor(value / unit + 0.5) * unit
end

local function with_size(model_given, size)
  local model = merged(model_given)
  model.mesh = merged(model.mesh, { size = size, height = 1.25 * size })
  return model
end

-- Smallest number of elements across the contact. With fewer, the pressure agrees with Hertz only by chance.
local fewest_elements = 8

-- Halves the element size until, at two successive sizes, the largest pressure of the unworn contact agrees
-- with Hertz within `limit`. The larger size must have enough elements across the contact. Returns the list
-- of sizes tried, { size=, elements=, p_max=, error=, change= }, and the entry of the larger size, or nil
-- if no size was good. error: deviation from Hertz; change: change from the previous size; both relative to
-- the Hertz pressure.
function search.mesh(given, limit, on_step)
  local m = given.model or {}
  local h = hertz_of(m, given.load)
  local size, steps = rounded(0.75 * h.half_width), {}
  for i = 1, 7 do
    -- The first sizes are intentionally coarse, so warnings are suppressed.
    local c = quiet(contact, { model = with_size(m, size), load = given.load })
    local before = steps[i - 1]
    steps[i] = { size = size, elements = 2 * h.half_width / size, p_max = c.p_max,
      error = c.p_max / h.p_max - 1,
      change = before and (c.p_max - before.p_max) / h.p_max }
    c:close()
    if on_step then on_step(steps[i]) end
    if before and before.elements >= fewest_elements and math.abs(before.error) < limit
      and math.abs(steps[i].error) < limit then
      return steps, before
    end
    size = size / 2
  end
  return steps, nil
end

-- --- smoothness and symmetry -----------------------------------------------------------------------

-- Returns the sawtooth of the pressure in the middle of the contact relative to p_center, at most 1. The
-- edges are excluded, because pressure peaks there are physical.
local function roughness(run)
  local pressure = run:pressure("upper")
  local value = measure.sawtooth(pressure.x, pressure.p, 0.6 * run.half_width) / run.p_center
  return value == value and math.min(value, 1) or 1
end

local function deepest(profile) return math.max(table.unpack(profile.h)) end

local function asymmetry(run)
  local worst = 0
  for _, body in ipairs{ "upper", "lower" } do
    local profile = run:profile(body)
    local depth, h = deepest(profile), profile.h
    for i = 1, depth > 0 and #h // 2 or 0 do
      worst = math.max(worst, math.abs(h[i] - h[#h + 1 - i]) / depth)
    end
  end
  return worst
end

-- Returns the largest difference between the profiles of two runs, relative to the largest depth of run `b`.
local function difference(a, b)
  local worst = 0
  for _, body in ipairs{ "upper", "lower" } do
    local one, two = a:profile(body), b:profile(body)
    local depth = deepest(two)
    for i = 1, depth > 0 and #one.h or 0 do
      worst = math.max(worst, math.abs(one.h[i] - two.h[i]) / depth)
    end
  end
  return worst
end

-- --- trials ----------------------------------------------------------------------------------------

-- Trials: runs that test a jump and a number of increments. Coarse meshes, and kinks that move through the
-- contact, also make the pressure rough. The roughness of a reference run is therefore subtracted from the
-- roughness of a trial. The steps of the reference run are too small for ripples to grow.

local trial = {}
trial.__index = trial

local stages = 5 -- number of evaluations of the stability limit in the reference run

function trial:new_run(jump, increments)
  return wear(merged(self.given, { model = self.model, jump = jump, increments = increments }))
end

local function course_jump(self, unworn_limit)
  return math.min(self.guess / 2, 0.4 * unworn_limit, self.cycles / 40)
end

-- Computes the reference run. Sets self.course to a list of { distance, roughness } and self.stable to the
-- lowest stability limit [cycles] of this run.
local function run_course(self)
  local run <close> = self:new_run(self.guess, usual_increments)
  self.stable = run:stability().jump_limit
  run:set{ jump = course_jump(self, self.stable) }
  self.course = { { 0, roughness(run) } }
  local most = 4 * self.limit.updates
  local every = math.max(1, math.min(most, self.cycles / course_jump(self, self.stable)) // stages)
  for i = 1, most do
    if run.done then break end
    run:step()
    self.course[i + 1] = { run.distance, roughness(run) }
    if i % every == 0 then self.stable = math.min(self.stable, run:stability().jump_limit) end
    if i % 10 == 0 then self.report(0.3 * i / most) end
  end
  -- a coarse mesh makes the pressure rough at different distances in different runs
  self.allowed = math.max(self.limit.smooth, self:own_roughness(0, math.huge) / 4)
end

local function new_trial(given, limit, on_progress)
  local first <close> = wear(given)
  local self = setmetatable({ given = given, limit = limit, model = first.model, count = 0,
    strokes = first.strokes, cycles = first.cycles, procedure = first.procedure,
    stroke = first.stroke, k = first.k_cylinder + first.k_plate, report = on_progress, jumps = {}, roughnesses = {} }, trial)
  self.p_hertz = hertz_of(first.model, first.load).p_max
  if not (self.k > 0) then
    error("study.converge: field 'k': k = 0 at the start, so that no jump can be "
      .. "judged; expected a k > 0 mm2/N at distance 0", 0)
  end
  self.guess = limit.first_depth / (self.k * self.p_hertz * self.strokes * self.stroke)
  run_course(self)
  return self
end

-- Returns the largest roughness of the reference run between the distances `from` and `to` [mm]. The next
-- point on each side is included.
function trial:own_roughness(from, to)
  local course, worst = self.course, 0
  for i, point in ipairs(course) do
    local before, after = course[i - 1], course[i + 1]
    if (not after or after[1] >= from) and (not before or before[1] <= to) then
      worst = math.max(worst, point[2])
    end
  end
  return worst
end

-- Computes a run of at most limit.updates updates. Returns the run and the largest difference between its
-- roughness and the roughness of the reference run.
function trial:run(jump, increments)
  local run = self:new_run(jump, increments)
  local worst, span = 0, jump * self.strokes * self.stroke
  for _ = 1, self.limit.updates do
    if run.done then break end
    run:step()
    worst = math.max(worst, roughness(run)
      - self:own_roughness(run.distance - span, run.distance + span))
  end
  self.count = self.count + 1
  self.report(math.min(0.95, 0.3 + self.count / 30))
  return run, worst
end

-- Returns true if a jump gives smooth and symmetric surfaces. Returns false if it does not, or if the engine
-- refuses a step. Further results: roughness, asymmetry and number of updates.
function trial:good(jump, increments)
  local fine, run, worst = pcall(self.run, self, jump, increments)
  local even, updates = 1, 0
  if fine then
    even, updates = asymmetry(run), run.update
    run:close()
  elseif tostring(run):find("interrupted", 1, true) then
    error(run, 0)
  else
    worst = 1
  end
  self.jumps[#self.jumps + 1], self.roughnesses[#self.roughnesses + 1] = jump, worst
  local smooth, symmetric = worst <= self.allowed, even <= self.limit.symmetric
  if smooth and not symmetric then self.lopsided = even end
  return smooth and symmetric, worst, even, updates
end

-- The search tries the round values 1, 1.5, 2, 2.5, 3, 4, 5, 6, 7.5, 10, ... of the jump. rung(i) returns the
-- value with index i, rung_of(value) the index of the largest round value <= value.
local steps = { 1, 1.5, 2, 2.5, 3, 4, 5, 6, 7.5 }
local function rung(i) return steps[i % #steps + 1] * 10.0 ^ (i // #steps) end
local function rung_of(value)
  local i = math.floor(math.log(value, 10)) * #steps
  while rung(i + 1) <= value * (1 + 1e-9) do i = i + 1 end
  return i
end

-- Searches downward for the largest good jump among the round values. The search starts at the stability
-- limit or at a tenth of all cycles, whichever is smaller, and stores its results in `found`.
function trial:largest_jump(found, increments)
  local highest = self.cycles / 10
  local i = rung_of(math.min(highest, self.stable))
  found.limit = self.stable < math.huge and self.stable or nil
  found.bound = self.stable < highest and "stability" or "cycles"
  found.capped = true
  while rung(i) >= 1e-3 * self.guess do
    local good, worst, even, updates = self:good(rung(i), increments)
    if good then
      found.jump, found.roughness, found.asymmetry, found.judged = rung(i), worst, even, updates
      return
    end
    i, found.capped = i - 1, false
  end
end

-- trial:fewest_increments() returns the smallest number of increments in `ladder` for which the profiles are
-- smooth, symmetric and equal to the profiles with `many` increments.
local many, ladder = 400, { 200, 100, 64, 40, 32, 20, 16, 10, 8, 4 }
search.most_increments, search.fewest_increments, search.ladder = many, ladder[#ladder], ladder

function trial:fewest_increments(jump)
  local reference <close> = self:run(jump, many)
  local found, change = many, 0
  for _, increments in ipairs(ladder) do
    local run <close>, worst = self:run(jump, increments)
    local off = difference(run, reference)
    if off > self.limit.profile or worst > self.allowed
      or asymmetry(run) > self.limit.symmetric then
      break
    end
    found, change = increments, off
  end
  return found, change
end

-- --- the search ------------------------------------------------------------------------------------

local function without_limits(given)
  local copy = merged(given)
  copy.converge, copy.jump, copy.increments = nil, nil, nil
  return copy
end

-- Fields of the result `found`:
--   jump: largest good jump; nil if none was good
--   limit: lowest stability limit [cycles]; nil if there is none
--   capped: true if no larger jump was tried
--   bound: reason for this, "stability" or "cycles" (a tenth of all cycles)
--   judged: number of updates of the trial with the best jump
--   increments: increments per cycle; nil if the plate does not slide
--   roughness, asymmetry: values of the trial with the best jump
--   smooth: allowed roughness, if it is larger than the limit
--   lopsided: asymmetry of the smooth runs, if it is the reason that no jump was good
--   change: difference between the profiles with these and with `many` increments
--   first_depth: depth of the first update [mm]
--   trials: number of trials
--   jumps, roughnesses: lists with the jump and the roughness of each trial
local function find(given, on_progress)
  local self = new_trial(without_limits(given), merged(limits, given.converge), on_progress or print)
  local found = {}
  self:largest_jump(found, usual_increments)
  -- this asymmetry does not depend on the jump, but more increments may reduce it
  if not found.jump and self.lopsided then self:largest_jump(found, many) end
  found.lopsided = not found.jump and self.lopsided or nil
  if found.jump then
    found.first_depth = found.jump * self.k * self.p_hertz * self.strokes * self.stroke
    if self.procedure == "SP" then
      found.increments, found.change = self:fewest_increments(found.jump)
    end
  end
  if self.allowed > self.limit.smooth then found.smooth = self.allowed end
  found.trials, found.jumps, found.roughnesses = self.count, self.jumps, self.roughnesses
  return found
end

return setmetatable(search, { __call = function(_, given, on_progress)
  return find(given, on_progress)
end })

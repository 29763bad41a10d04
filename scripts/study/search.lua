-- Finds the settings a wear run needs, as Sec. 4.4 does by hand: the element size from the unworn
-- contact, then the cycles per update and the increments per cycle from how smooth and symmetric
-- the surfaces are after some updates. Returns search(given, on_progress); `given` holds the fields
-- of wear{} and, as `converge`, limits to replace those below.

local hertz_of = require "archard.lib.hertz_of"
local measure = require "archard.measure"
local merged = require "archard.lib.merged"

local limits = {
  pressure = 0.01,     -- mesh: largest pressure against Hertz' [share]
  smooth = 0.005,      -- sawtooth in the pressure of the contact's middle [share of p_center]
  symmetric = 1e-3,    -- difference of a profile to its mirror image [share of the depth]
  profile = 0.005,     -- increments: change of the profiles against many increments [share]
  updates = 20,        -- how many updates are looked at
  first_depth = 1e-4,  -- first guess of the jump: depth of the first update, Eq. (28) [mm]
}

local search = { limits = limits }

-- --- the mesh --------------------------------------------------------------------------------------

-- The first digit alone: a number people would choose.
local function rounded(value)
  local unit = 10 ^ math.floor(math.log(value, 10))
  return math.floor(value / unit + 0.5) * unit
end

local function with_size(model_given, size)
  local model = merged(model_given)
  model.mesh = merged(model.mesh, { size = size, height = 1.25 * size })
  return model
end

local fewest_elements = 8 -- across the contact: fewer are near Hertz' pressure by luck alone

-- Halves the element size until it and the one before both bring the largest pressure of the unworn
-- contact within the limit of Hertz', the one before with elements enough across the contact.
-- Returns the list of { size=, elements=, p_max=, error=, change= } that were tried, and the one
-- before, or nil where none was good enough; error and change (from the size before) are shares of
-- Hertz' pressure.
function search.mesh(given, limit, on_step)
  local m = given.model or {}
  local h = hertz_of(m, given.load)
  local size, steps = rounded(0.75 * h.half_width), {}
  for i = 1, 7 do
    local c = contact{ model = with_size(m, size), load = given.load }
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

-- Of the pressure, whose peaks at the contact's edges are physics: only the middle counts.
local function roughness(run)
  local pressure = run:pressure("cylinder")
  local value = measure.sawtooth(pressure.x, pressure.p, 0.6 * run.half_width) / run.p_center
  return value == value and math.min(value, 1) or 1
end

local function deepest(profile) return math.max(table.unpack(profile.h)) end

local function asymmetry(run)
  local worst = 0
  for _, body in ipairs{ "cylinder", "plate" } do
    local profile = run:profile(body)
    local depth, h = deepest(profile), profile.h
    for i = 1, depth > 0 and #h // 2 or 0 do
      worst = math.max(worst, math.abs(h[i] - h[#h + 1 - i]) / depth)
    end
  end
  return worst
end

-- Largest difference of two runs' profiles, as a share of the depth.
local function difference(a, b)
  local worst = 0
  for _, body in ipairs{ "cylinder", "plate" } do
    local one, two = a:profile(body), b:profile(body)
    local depth = deepest(two)
    for i = 1, depth > 0 and #one.h or 0 do
      worst = math.max(worst, math.abs(one.h[i] - two.h[i]) / depth)
    end
  end
  return worst
end

-- --- trials ----------------------------------------------------------------------------------------

local trial = {}
trial.__index = trial

local function new_trial(given, limit, on_progress)
  local first = wear(given)
  local self = setmetatable({ given = given, limit = limit, model = first.model, count = 0,
    strokes = first.strokes, cycles = first.cycles, procedure = first.procedure,
    stroke = first.stroke, k = first.k, tell = on_progress, jumps = {}, roughnesses = {} }, trial)
  self.p_hertz = hertz_of(first.model, first.load).p_max
  -- on a coarse mesh the unworn pressure itself is not smooth from node to node
  self.allowed = math.max(limit.smooth, 1.5 * roughness(first))
  first:close()
  return self
end

-- A run of some updates, and the worst roughness of its later half.
function trial:run(jump, increments)
  local run = wear(merged(self.given, { model = self.model, jump = jump, increments = increments }))
  local worst = 0
  for i = 1, self.limit.updates do
    run:step()
    if 2 * i >= self.limit.updates then worst = math.max(worst, roughness(run)) end
  end
  self.count = self.count + 1
  self.tell(math.min(0.95, self.count / 25))
  return run, worst
end

-- Whether a jump is good: smooth and symmetric. A step that the engine refuses is not.
function trial:good(jump, increments)
  local fine, run, worst = pcall(self.run, self, jump, increments)
  if not fine then
    if tostring(run):find("interrupted", 1, true) then error(run, 0) end
    worst = 1
  end
  local even = fine and asymmetry(run) or 1
  if fine then run:close() end
  self.jumps[#self.jumps + 1], self.roughnesses[#self.roughnesses + 1] = jump, worst
  return worst <= self.allowed and even <= self.limit.symmetric, worst, even
end

-- Numbers people would choose: 1, 1.5, 2, 2.5, 3, 4, 5, 6, 7.5, 10, ...
local steps = { 1, 1.5, 2, 2.5, 3, 4, 5, 6, 7.5 }
local function rung(i) return steps[i % #steps + 1] * 10.0 ^ (i // #steps) end
local function rung_of(value)
  local i = math.floor(math.log(value, 10)) * #steps
  while rung(i + 1) <= value * (1 + 1e-9) do i = i + 1 end
  return i
end

-- The largest good jump: from the first guess up or down by about twofold, then rung by rung.
function trial:largest_jump(increments)
  local guess = self.limit.first_depth / (self.k * self.p_hertz * self.strokes * self.stroke)
  local highest = rung_of(self.cycles / 10)
  local low = math.min(rung_of(guess), highest)
  while not self:good(rung(low), increments) do
    low = low - 3
    if rung(low) < 1e-3 * guess then return nil end
  end
  local high = low + 3
  while high <= highest and self:good(rung(high), increments) do low, high = high, high + 3 end
  high = math.min(high, highest + 1)
  while high - low > 1 do
    local middle = (low + high) // 2
    if self:good(rung(middle), increments) then low = middle else high = middle end
  end
  return rung(low), low == highest
end

-- The fewest increments whose profiles are those of many, and that are smooth and symmetric.
local many, ladder = 400, { 200, 100, 64, 40, 32, 20, 16, 10, 8, 4 }
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

-- found: jump (nil: none was good), capped (whether it is a tenth of all cycles, the largest that
-- is tried), smooth (the limit of roughness where the unworn contact is rougher than the one asked
-- for, else nil), increments (nil where the plate does not slide), roughness, asymmetry, change (of
-- the profiles by these increments), first_depth [mm], trials, and what was tried as lists jumps and
-- roughnesses.
local function find(given, on_progress)
  local self = new_trial(without_limits(given), merged(limits, given.converge), on_progress or print)
  local slides = self.procedure == "SP"
  local found = { trials = 0 }
  local jump, capped = self:largest_jump(200)
  if jump then
    local _, worst, even = self:good(jump, 200)
    found.jump, found.roughness, found.asymmetry = jump, worst, even
    found.capped = capped
    found.first_depth = jump * self.k * self.p_hertz * self.strokes * self.stroke
    if slides then found.increments, found.change = self:fewest_increments(jump) end
  end
  if self.allowed > self.limit.smooth then found.smooth = self.allowed end
  found.trials, found.jumps, found.roughnesses = self.count, self.jumps, self.roughnesses
  return found
end

return setmetatable(search, { __call = function(_, given, on_progress)
  return find(given, on_progress)
end })

-- Class profile: a measured trace with positions x and heights z (or depths h) in mm, its noise, and a record
-- of the processing. The methods here return a new profile; evaluate.lua adds methods that return results.

local average = require "archard.profile.average"
local check = require "archard.lib.check"
local form = require "archard.profile.form"
local gaussian = require "archard.profile.gaussian"
local merged = require "archard.lib.merged"
local noise = require "archard.profile.noise"
local scar = require "archard.profile.scar"
local strict = require "archard.strict"

local methods = {}
local class = { __name = "profile", __methods = methods, __fields = { "x", "z", "h", "error", "correlation",
  "form", "radius", "scar", "scatter", "cutoff", "missing", "path" } }

local profile = { class = class, methods = methods }

function profile.is(value) return getmetatable(value) == class end

function profile.self(where, value)
  if not profile.is(value) then
    check.fail(where, "expected a profile, called as p:" .. where:match("[^.:]+$") .. "(...), got "
      .. check.shown(value))
  end
  return value
end

-- --- making ---------------------------------------------------------------------------------------

-- Returns the heights of a profile. The heights of a profile of depths are the negative depths.
function profile.heights(p)
  if p.z then return p.z end
  local z = {}
  for i = 1, #p.h do z[i] = -p.h[i] end
  return z
end

function profile.step(p) return (p.x[#p.x] - p.x[1]) / (#p.x - 1) end

-- Returns a copy of profile p with positions x, heights z and the fields in `changes`. into: "z" to store
-- heights, "h" to store depths; default: as in p.
function profile.derived(p, x, z, changes, into)
  local result = merged(p, changes)
  result.x, result.z, result.h = x, z, nil
  if into == "h" or not into and p.h then
    result.z, result.h = nil, {}
    for i = 1, #z do result.h[i] = -z[i] end
  end
  return setmetatable(result, class)
end

-- Checks the points and returns them with increasing x, without points that contain NaN. The third result is
-- the number of removed points.
local function clean(where, x, z, name)
  local cx, cz, missing = {}, {}, 0
  for i = 1, #x do
    if x[i] ~= x[i] or z[i] ~= z[i] then
      missing = missing + 1
    else
      cx[#cx + 1], cz[#cz + 1] = x[i], z[i]
    end
  end
  if #cx > 1 and cx[1] > cx[#cx] then
    for i = 1, #cx // 2 do
      local j = #cx + 1 - i
      cx[i], cx[j], cz[i], cz[j] = cx[j], cx[i], cz[j], cz[i]
    end
  end
  if #cx < 8 then
    check.fail(where, ("fields 'x' and '%s': expected at least 8 points, got %d"):format(name, #cx))
  end
  for i = 1, #cx do
    if math.abs(cx[i]) == math.huge or math.abs(cz[i]) == math.huge then
      check.fail(where, ("fields 'x' and '%s': expected finite numbers, got %g and %g"):format(name, cx[i], cz[i]))
    end
    if i > 1 and cx[i] <= cx[i - 1] then
      check.fail(where, ("field 'x': expected strictly increasing or decreasing positions, got %.9g mm after %.9g mm")
        :format(cx[i], cx[i - 1]))
    end
  end
  return cx, cz, missing
end

-- Checks lists of positions and values [mm] and makes a profile from them. name: "z" for heights, "h" for
-- depths; given: standard deviation of the noise [mm], or nil to estimate it; path: file of the trace, or
-- nil.
function profile.new(where, x, values, name, given, path)
  if #x ~= #values then
    check.fail(where, ("fields 'x' and '%s': expected lists of equal length, got %d and %d")
      :format(name, #x, #values))
  end
  local cx, cz, missing = clean(where, x, values, name)
  local self = { x = cx, [name] = cz, missing = missing, path = path }
  self.error = given or noise.estimate(cx, cz)
  self.correlation = profile.step(self)
  return setmetatable(self, class)
end

-- --- levelling --------------------------------------------------------------------------------------

local range = check.kind('"auto" or { from, to } in mm, from < to', function(v)
  return v == "auto" or type(v) == "table" and check.range.test(v) and v[1] ~= nil and v[2] ~= nil and v[1] < v[2]
end)
profile.range, profile.level_kind = range, check.one_of(form.kinds)

-- Returns the heights of a profile before a line or circle was subtracted.
local function original(p)
  local z, off = profile.heights(p), p.removed
  if not off then return z end
  local result = {}
  for i = 1, #z do result[i] = z[i] + off:height(p.x[i]) end
  return result
end

local function fitted(where, p, z, kind, worn)
  local found, from, to, is_used
  if worn == "auto" then
    found, from, to, is_used = scar.find(p.x, z, kind)
  elseif worn then
    found, from, to, is_used = scar.fit(p.x, z, kind, worn[1], worn[2])
  else
    found = form.fit(kind, p.x, z)
  end
  if not found or not (found:height(p.x[1]) and found:height(p.x[#p.x])) then
    check.fail(where, ("field 'level': the points of this trace do not determine a %s%s"):format(kind,
      worn and " beside the scar; give the ends of the scar, scar = { from, to }, or a longer trace" or ""))
  end
  return found, from and { from, to }, is_used
end

-- Warns if few points determine the form that is subtracted.
local function warn_few(where, kind, points, all)
  local few = 8
  if points >= few or points == all then return end
  warn(("%s: the %s is fitted to %d of %d points, those more than a fifth of the scar's width beside the scar: errors of areas "
    .. "and depths are uncertain; use a longer trace"):format(where, kind, points, all))
end

-- Returns a profile minus a fitted line or circle (the form). The form is fitted to all points or, if `worn`
-- is given, to the points beside the scar.
function profile.level(where, p, kind, worn)
  local z = original(p)
  local found, scar_at, is_used = fitted(where, p, z, kind, worn)
  local rest, depth = {}, {}
  for i = 1, #z do
    rest[i] = z[i] - found:height(p.x[i])
    depth[i] = -rest[i]
  end
  local deviation, length, points = scar.scatter(p.x, depth, is_used, form.parameters[kind])
  warn_few(where, kind, points, #z)
  local result = profile.derived(p, p.x, rest, { form = kind, scatter = strict.table({
    deviation = math.max(deviation, p.error), length = length, points = points }, "profile.scatter") })
  result.radius = kind == "circle" and found:radius() or nil
  result.scar = scar_at and strict.table({ from = scar_at[1], to = scar_at[2] }, "profile.scar") or nil
  result.removed = found -- the form, needed for repeated levelling and for the uncertainty of areas
  return result
end

function methods:level(kind, worn)
  local where = "profile:level"
  profile.self(where, self)
  kind = kind or "line"
  if not profile.level_kind.test(kind) then check.refuse(where, "level", profile.level_kind.expected, kind) end
  if worn ~= nil and not range.test(worn) then check.refuse(where, "scar", range.expected, worn) end
  return profile.level(where, self, kind, worn)
end

-- --- filter, mean, cut ------------------------------------------------------------------------------

-- Returns the mean step of x. Raises an error if a point is more than a twentieth of a step from its evenly
-- spaced position.
function profile.even_step(where, p)
  local step = profile.step(p)
  for i = 2, #p.x do
    if math.abs(p.x[i] - p.x[1] - (i - 1) * step) > 0.05 * step then
      check.fail(where, ("expected even steps of x, got %.6g mm at x = %.6g mm among steps of %.6g mm; "
        .. "p:average(step) makes them even"):format(p.x[i] - p.x[i - 1], p.x[i], step))
    end
  end
  return step
end

-- Returns the long-wave part of the heights, and the step of x. Raises an error if the cut-off is below two
-- steps or above the length of the trace. name: name of the cut-off in this error.
function profile.long_waves(where, p, z, cutoff, name)
  local step, whole = profile.even_step(where, p), p.x[#p.x] - p.x[1]
  if not (check.positive.test(cutoff) and cutoff >= 2 * step and cutoff <= whole) then
    check.refuse(where, name, ("a cut-off in mm in [%.4g, %.4g] (from two steps to the length of the trace)"):format(2 * step, whole),
      cutoff)
  end
  return gaussian.long(z, step, cutoff), step
end

-- Lua method p:filter(cutoff [, "long" | "short"]): returns the long-wave part (default) or the short-wave
-- part of the profile. cutoff: cut-off wavelength [mm].
function methods:filter(cutoff, part)
  local where, kinds = "profile:filter", check.one_of{ "long", "short" }
  profile.self(where, self)
  if part ~= nil and not kinds.test(part) then check.refuse(where, "part", kinds.expected, part) end
  local z = profile.heights(self)
  local long, step = profile.long_waves(where, self, z, cutoff, "filter")
  local kept, rest, length = gaussian.noise(self.correlation, self.correlation <= 1.01 * step, cutoff)
  if part ~= "short" then
    return profile.derived(self, self.x, long, { cutoff = cutoff, error = self.error * math.sqrt(kept),
      correlation = length })
  end
  for i = 1, #z do long[i] = z[i] - long[i] end
  return profile.derived(self, self.x, long, { cutoff = cutoff, error = self.error * math.sqrt(rest) })
end

-- Lua method p:average(step): returns the profile averaged over cells of length `step` [mm].
function methods:average(step)
  local where, old = "profile:average", profile.step(profile.self("profile:average", self))
  local most = (self.x[#self.x] - self.x[1]) / 4
  if not (check.positive.test(step) and step <= most) then
    check.refuse(where, "step", ("a length in mm in (0, %.4g], a quarter of the trace"):format(most), step)
  end
  local x, z = average.cells(self.x, profile.heights(self), step)
  if not x then
    check.refuse(where, "step", ("cells that all contain points (the points are %.4g mm apart; there is none near x = %.6g mm)")
      :format(old, z), step)
  end
  return profile.derived(self, x, z, { error = self.error * math.sqrt(math.min(1, self.correlation / step)),
    correlation = math.max(step, self.correlation) })
end

-- Lua method p:cut(from, to): returns the part of the profile between two positions [mm].
function methods:cut(from, to)
  local where = "profile:cut"
  profile.self(where, self)
  if not (check.number.test(from) and check.number.test(to) and from < to) then
    check.fail(where, ("expected two positions in mm, from < to, got %s and %s"):format(check.shown(from), check.shown(to)))
  end
  local x, z, all = {}, {}, profile.heights(self)
  for i = 1, #all do
    if self.x[i] >= from and self.x[i] <= to then x[#x + 1], z[#z + 1] = self.x[i], all[i] end
  end
  if #x < 8 then
    check.fail(where, ("expected at least 8 points between %g and %g mm, got %d"):format(from, to, #x))
  end
  return profile.derived(self, x, z)
end

-- Returns the centre of the scar [mm], or of the trace if no scar was detected.
function profile.middle(p)
  if p.scar then return (p.scar.from + p.scar.to) / 2 end
  return (p.x[1] + p.x[#p.x]) / 2
end

-- Lua method p:center(): returns the profile shifted so that the centre of its scar, or of the trace, is at x = 0.
function methods:center()
  profile.self("profile:center", self)
  local x, by = {}, profile.middle(self)
  for i = 1, #self.x do x[i] = self.x[i] - by end
  local found = self.scar and strict.table({ from = self.scar.from - by, to = self.scar.to - by }, "profile.scar") or nil
  return profile.derived(self, x, profile.heights(self), { scar = found })
end

-- Returns a copy of the list part of a table, or an empty list if `given` is not a table.
local function copied(given)
  local list = {}
  for i, item in ipairs(type(given) == "table" and given or {}) do list[i] = item end
  return list
end

-- Lua function profile.mean{ p1, p2, ... }: returns the mean of several profiles over their common range of
-- x, at the positions of the first profile.
function profile.mean(given)
  local where = "profile.mean"
  local from, to, traces = -math.huge, math.huge, copied(given)
  if #traces < 2 then
    check.fail(where, "expected a list of at least two profiles, got " .. check.shown(given))
  end
  local first = traces[1]
  for i, p in ipairs(traces) do
    if not profile.is(p) or (p.z == nil) ~= (first.z == nil) then
      local of = i > 1 and (" of " .. (first.z == nil and "depths" or "heights")) or ""
      check.fail(where, ("item %d: expected a profile%s, got %s"):format(i, of, check.shown(p)))
    end
    from, to = math.max(from, p.x[1]), math.min(to, p.x[#p.x])
  end
  if from >= to then check.fail(where, "expected traces that overlap, got none") end
  local shared, lists, errors = first:cut(from, to), {}, {}
  for i, p in ipairs(traces) do
    lists[i], errors[i] = average.at(p.x, profile.heights(p), shared.x), p.error
  end
  local z, sum = nil, 0
  z, shared.error = average.traces(lists, errors)
  for _, e in ipairs(errors) do sum = sum + (e > 0 and 1 / e ^ 2 or math.huge) end
  local result = profile.derived(shared, shared.x, z, { error = math.max(shared.error, math.sqrt(1 / sum)) })
  result.path = nil
  return result
end

-- --- printing -----------------------------------------------------------------------------------------

local uneven = 30 -- if the scatter about a line exceeds this multiple of the noise, the surface may be round

local function um(value) return ("%.4g um"):format(1000 * value) end

function class.__tostring(p)
  local low, high = math.huge, -math.huge
  for _, value in ipairs(p.z or p.h) do low, high = math.min(low, value), math.max(high, value) end
  local lines = { ("profile: %d points, x %.6g to %.6g mm, step %s"):format(#p.x, p.x[1], p.x[#p.x], um(profile.step(p))),
    ("  %s %.4g to %s, noise %s%s"):format(p.z and "heights" or "depths", 1000 * low + 0.0, um(high), um(p.error),
      p.correlation > 1.5 * profile.step(p) and (" over %.4g mm"):format(p.correlation) or "") }
  if p.form then
    local is_round = p.form == "line" and p.error > 0 and p.scatter.deviation > uneven * p.error
    lines[#lines + 1] = ("  minus a %s%s through %d points, scatter about it %s%s"):format(p.form,
      p.radius and (" of radius %.6g mm"):format(p.radius) or "", p.scatter.points, um(p.scatter.deviation),
      is_round and ': is the surface round? level = "circle" subtracts a circle' or "")
  end
  if p.scar then lines[#lines + 1] = ("  worn from x %.4g to %.4g mm"):format(p.scar.from, p.scar.to) end
  if p.cutoff then lines[#lines + 1] = ("  Gaussian filter, cut-off %.4g mm"):format(p.cutoff) end
  if p.missing > 0 then lines[#lines + 1] = ("  %d points without a value were removed"):format(p.missing) end
  return table.concat(lines, "\n")
end

return profile

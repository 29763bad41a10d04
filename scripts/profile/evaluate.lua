-- Adds methods that return results to the class profile (class.lua): depths below a reference, area and
-- volume of the scar with their uncertainty, roughness, and the initial surface of a run.

local average = require "archard.profile.average"
local check = require "archard.lib.check"
local form = require "archard.profile.form"
local merged = require "archard.lib.merged"
local profile = require "archard.profile.class"
local roughness = require "archard.profile.roughness"
local scar = require "archard.profile.scar"
local strict = require "archard.strict"

local methods = profile.methods

-- --- depth -------------------------------------------------------------------------------------------

local depth_fields = { level = profile.level_kind, scar = profile.range,
  reference = check.kind("a profile of heights", function(v) return profile.is(v) and v.z ~= nil end) }

-- Returns the heights of p minus the heights of a reference trace as a profile, over the common range of
-- both.
local function change(where, p, reference)
  local from, to = math.max(p.x[1], reference.x[1]), math.min(p.x[#p.x], reference.x[#reference.x])
  if from >= to then
    check.fail(where, ("field 'reference': expected a profile that overlaps x %g to %g mm, got x %g to %g mm"):format(
      p.x[1], p.x[#p.x], reference.x[1], reference.x[#reference.x]))
  end
  local part = p:cut(from, to)
  local before, z = average.at(reference.x, reference.z, part.x), {}
  for i = 1, #before do z[i] = part.z[i] - before[i] end
  local result = profile.derived(part, part.x, z, { form = "line",
    error = math.sqrt(p.error ^ 2 + reference.error ^ 2) })
  result.removed = nil
  return result
end

-- Lua method p:depth(), p:depth(reference) or p:depth{ reference=, level=, scar= }: returns the depths below
-- a line or circle fitted beside the scar. A reference trace is subtracted first.
function methods:depth(given)
  local where = "profile:depth"
  profile.self(where, self)
  local options = profile.is(given) and { reference = given } or given or {}
  options = check.definition(where, options, depth_fields, "a profile or ")
  local p = self
  if options.reference then
    if not p.z then check.fail(where, "field 'reference': not allowed for a profile of depths") end
    p = change(where, p, options.reference)
  end
  p = profile.level(where, p, options.level or p.form or "line", options.scar or "auto")
  return profile.derived(p, p.x, profile.heights(p), nil, "h")
end

-- --- volume ------------------------------------------------------------------------------------------

local volume_fields = { scar = profile.range, length = check.positive }

-- Piled-up material is integrated on each side of the scar, over this fraction of the scar's width. The value
-- equals scar.margin, because the line or circle is fitted outside this margin.
local piled_share = 0.2

local function dot(weights, values)
  local sum = 0
  for i = 1, #values do sum = sum + weights[i] * values[i] end
  return sum
end

-- Returns a profile of depths and the positions of both ends of its scar. Heights are levelled by a fit
-- beside the scar; depths are levelled again only if options.scar is "auto".
local function scar_of(p, options)
  if p.h and options.scar ~= "auto" then
    local at = options.scar or p.scar and { p.scar.from, p.scar.to } or { p.x[1], p.x[#p.x] }
    return p, at[1], at[2]
  end
  local depths = p:depth{ scar = options.scar }
  if not depths.scar then
    check.fail("profile:volume", ("no scar is clearly deeper than the scatter of %.3g um; give its position, scar = { from, to }")
      :format(1000 * depths.scatter.deviation), "MISSING")
  end
  return depths, depths.scar.from, depths.scar.to
end

-- Returns two standard errors of the weighted sum of the depths: one from the scatter within the scar, the
-- other from the fitted line or circle. width: width of the scar [mm].
local function errors_of(p, weights, width)
  local deviation = p.scatter and p.scatter.deviation or p.error
  local length = p.scatter and p.scatter.length or p.correlation
  local found = p.removed
  local level = found and found:variance(p.x, weights) * math.max(1, length / profile.step(p)) or 0
  return deviation * math.sqrt(length * width), deviation * math.sqrt(level)
end

-- Returns the largest depth of a scar [mm]. To reduce noise, depths are averaged over cells of a fiftieth of
-- the scar's width, or of one step if that is longer.
local function deepest(p, from, to)
  local cell = math.max((to - from) / 50, profile.step(p))
  local part = p:cut(from, to)
  local x, h = average.cells(part.x, part.h, cell)
  if not x then h = part.h end
  return math.max(table.unpack(h, 1, math.min(#h, 200)))
end

-- Lua method p:volume{ scar=, length= }: returns the area, volume and depth of the scar, and the standard
-- errors of area and volume.
function methods:volume(given)
  local where = "profile:volume"
  profile.self(where, self)
  local options = check.definition(where, given or {}, volume_fields)
  local p, from, to = scar_of(self, options)
  from, to = math.max(from, p.x[1]), math.min(to, p.x[#p.x])
  local weights, width, length = scar.weights(p.x, from, to), to - from, options.length or 1
  local side = piled_share * width
  local piled = -dot(scar.weights(p.x, from - side, from), p.h) - dot(scar.weights(p.x, to, to + side), p.h)
  local area, scatter, level = dot(weights, p.h), errors_of(p, weights, width)
  local total = math.sqrt(scatter ^ 2 + level ^ 2)
  return strict.table({ area = area, error = total, scatter = scatter, level = level, volume = area * length,
    volume_error = total * length, length = length, from = from, to = to, width = width, mean_depth = area / width,
    depth = deepest(p, from, to), piled = piled }, "profile:volume")
end

-- --- roughness ----------------------------------------------------------------------------------------

local roughness_fields = { short = check.positive, sections = check.whole(1, 1000), cutoff = check.kind(
  "a number > 0 in mm, or false for the whole profile (P-parameters)", function(v)
    return v == false or check.positive.test(v)
  end) }
local usual_cutoff, usual_sections = 0.8, 5 -- defaults: cut-off [mm] and number of sections (ISO 21920-3)

local function without_line(x, z)
  local line, rest = form.fit("line", x, z), {}
  for i = 1, #z do rest[i] = z[i] - line:height(x[i]) end
  return rest
end

-- Returns the number of points in a sampling length, and the number of sampling lengths. Half a cut-off at
-- each end of the trace is excluded.
local function section_counts(where, p, step, cutoff, wanted)
  local size = math.floor(cutoff / step + 0.5)
  local there = (#p.x - 2 * math.ceil(cutoff / step / 2)) // size
  if there < (wanted or 1) then
    check.fail(where, ("expected a trace of at least %.4g mm (%d sections of the cut-off %g mm plus half a cut-off at both ends), "
      .. "got %.4g mm"):format(((wanted or 1) + 1) * cutoff, wanted or 1, cutoff, p.x[#p.x] - p.x[1]))
  end
  return size, wanted or math.min(usual_sections, there)
end

local function middle_part(z, count)
  local first = (#z - count) // 2
  return table.move(z, first + 1, first + count, 1, {})
end

-- Lua method p:roughness{ cutoff=, short=, sections= }: returns the roughness parameters of the profile.
function methods:roughness(given)
  local where = "profile:roughness"
  profile.self(where, self)
  local options = check.definition(where, given or {}, roughness_fields)
  local step, z = profile.even_step(where, self), profile.heights(self)
  if options.short then z = profile.long_waves(where, self, z, options.short, "short") end
  local cutoff, letter, size, count = options.cutoff, "R", nil, nil
  if cutoff == nil then cutoff = usual_cutoff end
  if cutoff then
    size, count = section_counts(where, self, step, cutoff, options.sections)
    local long = profile.long_waves(where, self, z, cutoff, "cutoff")
    local short = {}
    for i = 1, #z do short[i] = z[i] - long[i] end
    z = middle_part(short, size * count)
  else
    letter, count = "P", options.sections or 1
    z, size = without_line(self.x, z), #z // count
  end
  local result = roughness.of(z, step, size, count, letter)
  result[letter .. "Sm"] = result[letter .. "Sm"] or 0 / 0
  return strict.table(merged(result, { cutoff = cutoff, short = options.short, sections = count,
    length = #z * step, noise = self.error }), "profile:roughness")
end

-- --- initial surface of a run --------------------------------------------------------------------------

-- Returns the list of initial depths [mm] of a run. Heights are converted to depths below the highest
-- point. Negative depths in a profile of depths become 0, but a depth below -5 times the scatter (piled-up
-- material) is an error.
local function start_of(p)
  local h, top = {}, -math.huge
  if p.z then
    for i = 1, #p.z do top = math.max(top, p.z[i]) end
    for i = 1, #p.z do h[i] = top - p.z[i] end
    return h
  end
  local margin = 5 * math.max(p.error, p.scatter and p.scatter.deviation or 0)
  for i = 1, #p.h do
    if p.h[i] < -margin then
      check.fail("profile", ("expected no depth below -5 times the scatter (-%.3g um), got a depth of %.4g "
        .. "um at x = %.4g mm; for piled-up material, start from the heights, or level beside the scar"):format(
        1000 * margin, 1000 * p.h[i], p.x[i]))
    end
    h[i] = math.max(0, p.h[i])
  end
  return h
end

local clear = 5 -- smallest difference between both ends that is reported as a tilt, in multiples of the scatter

-- Warns if a trace that was not levelled is clearly tilted, since the instrument may have caused the tilt.
local function warn_of_tilt(p)
  local line = p.z and not p.form and scar.find(p.x, p.z, "line")
  if not line then return end
  local length = p.x[#p.x] - p.x[1]
  local rise = line:height(p.x[#p.x]) - line:height(p.x[1])
  if math.abs(rise) > clear * math.max(p.error, line.deviation) then
    warn(("worn: the profile is tilted by %.3g um/mm, %.3g um over its length, and the run starts with this tilt; to remove "
      .. "it use p:level()"):format(1000 * rise / length, 1000 * rise))
  end
end

local most_aside = 0.1 -- largest distance of the scar's centre from x = 0 without a warning, in widths of the scar

-- Warns if a detected scar is not at x = 0, where the bodies touch.
local function warn_of_place(p)
  local middle = p.scar and profile.middle(p)
  if not middle or math.abs(middle) <= most_aside * (p.scar.to - p.scar.from) then return end
  warn(("worn: the centre of the scar is at x = %.4g mm, but the bodies touch at x = 0; to shift it use p:center()"):format(middle))
end

-- Returns the initial depths { x=, h= } of a run for which the user sets worn = { plate = p }.
function profile.class.__worn(p)
  warn_of_tilt(p)
  warn_of_place(p)
  return { x = p.x, h = start_of(p) }
end

strict.class(profile.class)

return profile

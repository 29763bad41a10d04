-- The option `measured` of plot.profile: draws a measured trace as points over the curves, with few enough
-- points to be readable.

local check = require "archard.lib.check"

local measured = {}

local most, with_bars = 160, 60 -- largest numbers of points drawn without and with error bars

local function is_profile(value) return require "archard.profile.class".is(value) end

measured.is_profile = is_profile

measured.kind = check.kind("a profile, or a table { x=, h= }", function(v)
  return is_profile(v) or type(v) == "table" and type(v.x) == "table" and type(v.h) == "table" and #v.x == #v.h
end)

-- Returns the trace, averaged over groups of points such that about `most` points lie between `from` and
-- `to`.
local function thinned(p, from, to)
  local length = p.x[#p.x] - p.x[1]
  local shown = math.min(to - from, length)
  return shown / length * #p.x > most and p:average(shown / most) or p
end

-- Returns the points of a trace in µm for the option `points` of plot{}, and half the width of the range of
-- x, widened to show the scar. Only points with |x| <= reach are used, or all points if `reach` is 0. A scar
-- entirely on one side of x = 0 means that the trace has another origin: its points are shifted such that the
-- middle of the scar is at 0, and the title states the shift.
function measured.points(p, reach)
  local points, by, bar = { x = {}, y = {}, title = "measured" }, 0, nil
  if is_profile(p) then
    if p.z then p = p:depth() end
    local at = p.scar
    if at and at.from * at.to > 0 then
      by = -(at.from + at.to) / 2
      points.title = ("measured, x moved by %.4g mm"):format(by)
    end
    if at then reach = math.max(reach, 1.25 * math.max(math.abs(at.from + by), math.abs(at.to + by))) end
    p = reach > 0 and thinned(p, -reach - by, reach - by) or p
    bar = p.error
  end
  for i = 1, #p.x do
    local x = p.x[i] + by
    if reach == 0 or math.abs(x) <= reach then
      points.x[#points.x + 1], points.y[#points.y + 1] = x, 1000 * p.h[i]
    end
  end
  if bar and bar > 0 and #points.x <= with_bars then
    points.error = {}
    for i = 1, #points.x do points.error[i] = 1000 * bar end
  end
  return points, reach
end

return measured

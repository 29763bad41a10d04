-- The option `measured` of plot.profile: a trace as points over the curves, with few enough of them to be told
-- apart. Leans on what users can ask of a profile.

local check = require "archard.lib.check"

local measured = {}

local most, with_bars = 160, 60 -- points over what is shown; up to which number bars tell their scatter

local function is_profile(value) return require "archard.profile.class".is(value) end

measured.kind = check.kind("a profile, or a table { x=, h= }", function(v)
  return is_profile(v) or type(v) == "table" and type(v.x) == "table" and type(v.h) == "table" and #v.x == #v.h
end)

-- Depths, with the mean of as many points for each as leaves `most` of them between -reach and reach.
local function thinned(p, reach)
  if p.z then p = p:depth() end
  local shown = math.min(2 * reach, p.x[#p.x] - p.x[1])
  local there = shown / (p.x[#p.x] - p.x[1]) * #p.x
  return there > most and p:average(shown / most) or p, there
end

-- How far from x = 0 the scar of a trace is.
function measured.reach(p)
  if not is_profile(p) then return 0 end
  local scar = p.scar or p.z and p:depth().scar
  return scar and 1.25 * math.max(math.abs(scar.from), math.abs(scar.to)) or 0
end

-- The points, in um, for the option `points` of a plot that shows x from -reach to reach.
function measured.points(p, reach)
  local points = { x = {}, y = {}, title = "measured" }
  local bar
  if is_profile(p) then
    p = thinned(p, reach > 0 and reach or math.huge)
    bar = p.error
  end
  for i = 1, #p.x do
    if reach == 0 or math.abs(p.x[i]) <= reach then
      points.x[#points.x + 1], points.y[#points.y + 1] = p.x[i], 1000 * p.h[i]
    end
  end
  if bar and bar > 0 and #points.x <= with_bars then
    points.error = {}
    for i = 1, #points.x do points.error[i] = 1000 * bar end
  end
  return points
end

return measured

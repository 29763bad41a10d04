-- Closed form for a bush of radius R and clearance c = gap that wears alone. At the angle t from the load,
-- the depth is delta cos t - c and the pressure p0 cos t within the contact |t| < e, where cos e = c / delta.
-- The worn volume is 2 R c (tan e - e).
local bush = {}

-- Returns the half angle e of the contact [rad] for a worn volume.
function bush.angle_of(R, gap, volume)
  local low, high = 0, math.pi / 2 - 1e-9
  for _ = 1, 80 do
    local e = (low + high) / 2
    if 2 * R * gap * (math.tan(e) - e) < volume then low = e else high = e end
  end
  return low
end

-- Returns the largest deviation of a worn bush's pressures from the closed form over nine tenths of the
-- contact, under a load at the angle `at` [rad].
function bush.deviation(w, R, gap, at)
  local e, worst = bush.angle_of(R, gap, w.volume.bush), 0
  local p0 = w.load / (R * (e + math.sin(e) * math.cos(e)))
  local pressure = w:pressure("bush")
  for i, x in ipairs(pressure.x) do
    local t = x / R - (at or 0)
    if math.abs(t) < 0.9 * e then worst = math.max(worst, math.abs(pressure.p[i] / (p0 * math.cos(t)) - 1)) end
  end
  return worst
end

return bush

-- What is known of a bush that alone wears: h = delta cos t - c and p = p0 cos t with cos e = c / delta and
-- V = 2 R c (tan e - e), for the radius R and the clearance c = gap.
local bush = {}

-- The half angle e of the contact from the volume.
function bush.angle_of(R, gap, volume)
  local low, high = 0, math.pi / 2 - 1e-9
  for _ = 1, 80 do
    local e = (low + high) / 2
    if 2 * R * gap * (math.tan(e) - e) < volume then low = e else high = e end
  end
  return low
end

return bush

-- Converts maps of spheres to flat maps of the half sphere about the load, by an azimuthal equal-area
-- projection. In the flat map, x is anterior and z is along the axis of flexion, in mm. Values are 0
-- outside the half sphere.

local made = require "archard.map.made"

local points = 121 -- number of points along each side of a map

local flat = {}

-- Returns the value of a lattice in a direction n (a unit vector), by linear interpolation between cells.
function flat.sampled(rows, values, n)
  local row = math.acos(math.max(-1, math.min(1, n[1]))) / math.pi * rows + 0.5
  local column = (math.atan(n[2], n[3]) + math.pi) / math.pi * rows + 0.5
  local i = math.max(1, math.min(rows - 1, math.floor(row)))
  local k = math.floor(column)
  local s, t = row - i, column - k
  local function at(a, b) return values[(a - 1) * 2 * rows + (b - 1) % (2 * rows) + 1] end
  return (1 - s) * ((1 - t) * at(i, k) + t * at(i, k + 1)) + s * ((1 - t) * at(i + 1, k) + t * at(i + 1, k + 1))
end

-- Returns the position x, z [mm] of a direction in the flat map, or nil outside the half sphere.
function flat.point(radius, n)
  if n[3] < 0 then return nil end
  local share = radius * math.sqrt(2 / (1 + n[3]))
  return share * n[2], share * n[1]
end

-- Returns a curve in the flat map. n(s): direction of the point at s in [0, 1] of the curve. Points outside
-- the half sphere become gaps (NaN).
function flat.curve(radius, n, count)
  local x, y = {}, {}
  for i = 0, count do
    local px, py = flat.point(radius, n(i / count))
    x[i + 1], y[i + 1] = px or 0 / 0, py or 0 / 0
  end
  return { x = x, y = y }
end

-- Returns the rim of the cup's opening as a curve in the flat map. The rim is `cover` degrees from the axis
-- of the cup.
function flat.rim(joint)
  local tilt, cover = math.rad(joint.cup.inclination), math.rad(joint.cup.cover)
  local c, s = math.cos(tilt), math.sin(tilt)
  return flat.curve(joint.head.radius, function(t)
    local a = 2 * math.pi * t
    local x, y, z = math.sin(cover) * math.cos(a), math.sin(cover) * math.sin(a), math.cos(cover)
    return { c * x + s * z, y, c * z - s * x + 1e-12 }
  end, 180)
end

-- Returns the direction at a position x, z [mm] of the flat map, or nil outside the half sphere.
function flat.direction(radius, x, z)
  local r = math.sqrt(x ^ 2 + z ^ 2)
  if r > math.sqrt(2) * radius then return nil end
  local angle = 2 * math.asin(math.min(1, r / (2 * radius)))
  local share = r > 0 and math.sin(angle) / r or 0
  return { share * z, share * x, math.cos(angle) }
end

-- Returns a function(n) that returns true if the cup covers the direction n.
function flat.cover(cup)
  local tilt, least = math.rad(cup.inclination), math.cos(math.rad(cup.cover))
  return function(n) return n[1] * math.sin(tilt) + n[3] * math.cos(tilt) >= least end
end

-- Returns the flat map of the values of a lattice. rows: rows of the lattice; values: the list from
-- sphere.map; radius: radius of the sphere [mm].
function flat.map(rows, values, radius, name, unit)
  local reach, x, y = math.sqrt(2) * radius, {}, {}
  for i = 1, points do x[i] = reach * (2 * (i - 1) / (points - 1) - 1) end
  for i = 1, points do
    for k = 1, points do
      local n = flat.direction(radius, x[i], x[k])
      y[#y + 1] = n and flat.sampled(rows, values, n) or 0
    end
  end
  return made.new{ x = x, z = table.move(x, 1, points, 1, {}), y = y, unit = unit, name = name }
end

return flat

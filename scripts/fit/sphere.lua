-- Depth maps of the head or the cup of a joint as measurements of a fit. The directions of the depths are
-- given by the angles theta and phi in the body's own frame.

local check = require "archard.lib.check"
local flat = require "archard.joint.flat"

local sphere = {}

local angles = check.list_of(check.number, "angles")
sphere.kind = check.kind("a map of angles theta, phi [degree] and values [mm], with phi varying fastest, as returned by w:map", function(v)
  return type(v) == "table" and angles.test(v.theta) and angles.test(v.phi) and angles.test(v.values)
    and #v.values == #v.theta * #v.phi
end)

local function direction(theta, phi)
  local s = math.sin(theta)
  return { math.cos(theta), s * math.sin(phi), s * math.cos(phi) }
end

-- Makes an item of data from a map of a joint. from: the checked fields map, body, distance and title;
-- errors: list of standard errors, or nil.
function sphere.item(from, errors)
  local map, at, x = from.map, {}, {}
  for _, theta in ipairs(map.theta) do
    for _, phi in ipairs(map.phi) do
      at[#at + 1] = direction(math.rad(theta), math.rad(phi))
      x[#x + 1] = math.deg(math.acos(math.max(-1, math.min(1, at[#at][3]))))
    end
  end
  return { kind = "sphere", body = from.body, surface = "map_" .. from.body, distance = from.distance, at = at, x = x,
    value = table.move(map.values, 1, #map.values, 1, {}), error = errors, unit = "mm", fixed = {},
    title = from.title or ("map of the %s at %g mm"):format(from.body, from.distance) }
end

-- Returns the simulated depths at the points of an item. surface.h: depths of the map of a run.
function sphere.values(item, surface)
  local rows, list = math.tointeger(math.sqrt(#surface.h / 2)), {}
  for i, n in ipairs(item.at) do list[i] = flat.sampled(rows, surface.h, n) end
  return list
end

return sphere

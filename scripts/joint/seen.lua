-- What is read of a joint's lattice, and warned of its contact: for single contacts and runs.

local check = require "archard.lib.check"
local sphere = require "archard.sphere"
local strict = require "archard.strict"

local seen = {}

-- A map over theta and phi in degrees, values with phi fastest.
function seen.map(engine, what)
  local rows, values = sphere.map(engine, what)
  local d = 180 / rows
  local map = { theta = {}, phi = {}, values = values }
  for i = 1, rows do map.theta[i] = (i - 0.5) * d end
  for k = 1, 2 * rows do map.phi[k] = (k - 0.5) * d - 180 end
  return strict.table(map, "map")
end

-- The largest depth of a body [mm].
function seen.deepest(engine, body)
  local most, _, depth = 0, sphere.map(engine, body)
  for i = 1, #depth do most = math.max(most, depth[i]) end
  return most
end

-- Nearer to the rim than this the complete spheres are off by more than about 1 %.
function seen.warn_of_rim(where, def, margin)
  local liner = def.cup_layers[1]
  local is_soft = liner.E < 1e4
  local least = is_soft and math.deg(liner.thickness / def.radius) or 25
  if (is_soft or #def.cup_layers > 1) and margin < least then
    warn(("%s: contact comes within %.3g degrees of the cup's rim; spheres are complete here, which is off by percents below %.3g"):format(
      where, margin, least))
  end
end

local fewest, enough = 3, 6 -- cells across a contact

-- Cells across a contact of a half angle in degrees: an error below three, a warning below six.
function seen.check_cells(where, engine, half_angle)
  local size = 180 / (sphere.map(engine, "pressure"))
  local across = 2 * half_angle / size
  if across >= enough then return end
  local text = ("field 'mesh.size': expected cells small enough for the contact, got %.3g of %.3g degrees across its %.3g; %.2g is advised"):format(
    across, size, 2 * half_angle, 2 * half_angle / 10)
  if across < fewest then check.fail(where, text) end
  warn(("%s: %s"):format(where, text))
end

return seen

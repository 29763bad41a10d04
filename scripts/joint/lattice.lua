-- Makes maps of joints and checks their contacts, for single contacts and for runs.

local check = require "archard.lib.check"
local sphere = require "archard.sphere"
local strict = require "archard.strict"

local lattice = {}

-- Returns a map over theta and phi [degree]. phi varies fastest in the list of values.
function lattice.map(engine, what)
  local rows, values = sphere.map(engine, what)
  local d = 180 / rows
  local map = { theta = {}, phi = {}, values = values }
  for i = 1, rows do map.theta[i] = (i - 0.5) * d end
  for k = 1, 2 * rows do map.phi[k] = (k - 0.5) * d - 180 end
  return strict.table(map, "map")
end

-- Returns the largest depth of a body [mm].
function lattice.deepest(engine, body)
  local most, _, depth = 0, sphere.map(engine, body)
  for i = 1, #depth do most = math.max(most, depth[i]) end
  return most
end

-- Warns if the contact is less than a cell from the cup's rim, or so near the rim that the error of the
-- model, which assumes complete spheres, exceeds about 1 %. margin: distance of the contact from the rim
-- [degree]; warned: table of the warnings printed so far; share: multiplies the smallest distance without a
-- warning, default 1. The model differs from finite elements by 0.7 % if the distance is half the liner's
-- thickness.
function lattice.warn_of_rim(where, joint, margin, warned, share)
  if warned.reached then return end
  if margin < joint.mesh.size then
    warned.reached = true
    warn(("%s: the contact reaches the cup's rim (its outermost cell is %.2g degrees from the rim, less than the cell size %.2g); the model does not include edge loading"):format(
      where, margin, joint.mesh.size))
    return
  end
  local layers = joint.cup.layers
  local is_soft = layers[1].material.E < 1e4
  local least = is_soft and math.min(math.deg(layers[1].thickness / joint.head.radius), joint.cup.cover) or 25
  least = least * (share or 1)
  if not warned.near and (is_soft or #layers > 1) and margin < least then
    warned.near = true
    warn(("%s: the contact is %.3g degrees from the cup's rim; the model assumes complete spheres, with errors of a few percent below %.3g degrees"):format(
      where, margin, least))
  end
end

local fewest, enough = 3, 6 -- limits of the number of cells across a contact

-- Checks the number of cells across a contact with the half angle `half_angle` [degree]. Fewer than three
-- cells are an error; fewer than six cause a warning.
function lattice.check_cells(where, engine, half_angle)
  local size = 180 / (sphere.map(engine, "pressure"))
  local across = 2 * half_angle / size
  if across >= enough then return end
  local text = ("field 'mesh.size': expected at least 6 cells across the contact, got %.3g cells of %.3g degrees across %.3g degrees; use %.2g"):format(
    across, size, 2 * half_angle, 2 * half_angle / 10)
  if across < fewest then check.fail(where, text) end
  warn(("%s: %s"):format(where, text))
end

return lattice

-- Solves exported decks with CalculiX and tests that CalculiX reproduces archard's pressures and stresses.
-- The test is skipped without CalculiX. It uses a coarse mesh for speed; `make peer` compares on the default
-- mesh.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/../lua/lib/tap.lua")
local ccx = dofile(here .. "/../../scripts/tools/ccx.lua")
if not ccx.there() then
  print("ok 1 - no CalculiX (Debian package calculix-ccx): decks not run # SKIP")
  return
end

local folder = os.tmpname()
os.remove(folder)
assert(os.execute("mkdir " .. folder))

local function largest(values)
  local most = 0
  for _, value in ipairs(values) do most = math.max(most, value) end
  return most
end

-- Returns the result of CalculiX for an exported object, or nil.
local function solve(name, object, c)
  export.inp(object, ("%s/%s.inp"):format(folder, name))
  local mesh = c.model.mesh
  local result, said = ccx.solve(folder, name, mesh.cylinder.nodes, mesh.cylinder.nodes + mesh.plate.nodes)
  if not tap.ok(result, name .. ": CalculiX runs the deck unchanged") then tap.note(said:sub(-2000)) end
  return result
end

local function compare(name, object, c, room)
  local r = solve(name, object, c)
  if not r then return end
  local stress = c:stress()
  tap.near(r.force, c.load, 1e-6, name .. ": total contact force")
  -- CalculiX extrapolates pressures from integration points to nodes. For an elliptic pressure the nodal
  -- values are too high by 1 / (12 n^2), where n is the number of elements in the half width.
  local elements = c.half_width / c.model.mesh.size
  tap.near(r.p_center, c.p_center, 0.01 + 1 / (12 * elements ^ 2), name .. ": centre pressure")
  for _, body in ipairs{ "cylinder", "plate" } do
    tap.near(r.mises[body], largest(stress[body].mises), room.mises, ("%s: von Mises of the %s"):format(name, body))
  end
  tap.near(r.approach, c.approach, room.approach, name .. ": approach")
end

-- Tests a radius, thickness, load and position other than the defaults, and a contact worn by a smooth scar.
local function scar(x) return 2e-3 * math.max(0, 1 - (x / 0.4) ^ 2) ^ 2 end
local steel = model{ radius = 8, thickness = 2, mesh = { size = 0.04, height = 0.05, far = 2, zone = { cylinder = 1, plate = 1.4 } } }
local unworn = contact{ model = steel, load = 300, x = 0.08 }
compare("unworn", unworn, unworn, { mises = 0.015, approach = 0.003 })
local worn = contact{ model = steel, load = 300, worn = { cylinder = scar, plate = scar } }
compare("worn", worn, worn, { mises = 0.015, approach = 0.003 })
local soft = model{ plate = { E = 1000, nu = 0.495 }, mesh = { size = 0.04, height = 0.05, far = 2,
  zone = { cylinder = 1, plate = 1.2 } } }
tap.is(soft.mesh.plate.element, "CPE4I", "soft bodies have incompatible modes")
local pressed = contact{ model = soft, load = 2 }
compare("soft", pressed, pressed, { mises = 0.05, approach = 0.01 })

os.execute("rm -r " .. folder)

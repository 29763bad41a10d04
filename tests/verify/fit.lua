-- Tests the default mesh sizes: for every radius and load, the error of the centre pressure of the unworn
-- contact must not exceed a limit. For steel, the limit is slightly above the error in the case of the
-- reference paper (README.md).

-- Long
local here = arg[0]:match("^(.*)/") or "."
local figures = dofile(here .. "/lib/figures.lua")
local below, ok = figures.below, figures.ok
local steel, soft = material{}, material{ E = 1000, nu = 0.45 }

-- Returns the relative errors of the centre pressure against Hertz theory and against a mesh three times as
-- fine, the half width over the radius, and the contact.
local function errors(R, load, plate)
  local h = hertz{ radius = R, load = load, plate = plate }
  local c <close> = contact{ load = load, model = { radius = R, plate = plate } }
  local finer <close> = contact{ load = load, model = { radius = R, plate = plate, mesh = { fineness = 3 } } }
  return math.abs(c.p_center / h.p_max - 1), math.abs(c.p_center / finer.p_center - 1), h.half_width / R, c
end

-- Hertz theory is compared only for narrow contacts: half-planes approximate the bodies only if the contact
-- is narrow compared with the bodies.
local narrow, against_hertz, against_finer, soft_one = 0.03, 0, 0, 0
for _, R in ipairs{ 0.5, 2, 10, 50, 200, 1000 } do
  for _, load in ipairs{ 1, 100, 10000 } do
    local off, change, share = errors(R, load, steel)
    if share < narrow then
      against_hertz, against_finer = math.max(against_hertz, off), math.max(against_finer, change)
    end
    off, change, share = errors(R, load / 1000, soft)
    if share < narrow then soft_one = math.max(soft_one, off) end
  end
end
below(against_hertz, 0.0005, "steel, radii 0.5 to 1000 mm, 1 to 10000 N: centre pressure against Hertz")
below(against_finer, 0.0008, "steel: centre pressure against elements of a third of the size")
below(soft_one, 0.002, "polyethylene (nu = 0.45) against steel: centre pressure against Hertz")

-- Tests that the mesh of the reference case is unchanged.
local c = contact{}
ok(c.model.mesh.size == 0.02 and c.model.mesh.height == 0.025 and c.model.mesh.far == 1
  and c.model.mesh.zone.cylinder == 1, "the mesh of the reference case is unchanged to the bit")

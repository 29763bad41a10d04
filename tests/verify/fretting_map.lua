-- Tests the fretting map against half-planes, and its mesh error: the transitions between stick, partial slip
-- and gross slip, and the edges of the stick zone, from which the first transition is computed.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, below, note = figures.within, figures.below, figures.note

local mu = 0.6

-- --- stick zone ---------------------------------------------------------------------------------

-- Compares the half width of the stick zone with Cattaneo and Mindlin's, over contacts whose edges move
-- across an element. Returns the largest and the mean error, in elements.
local function edges_off(fineness, share)
  local first = contact{ model = { mesh = { fineness = fineness } }, friction = mu }
  local size, a, most, sum, count = first.model.mesh.size, first.half_width, 0, 0, 12
  for i = 1, count do
    local load = 100 * (1 + ((i - 0.5) / count - 0.5) * size / a) ^ 2
    local zone = contact{ model = first.model, friction = mu, load = load }:move{ tangential = share * mu * load }.stick[1]
    local off = ((zone.right - zone.left) / 2 - hertz{ load = load }.half_width * math.sqrt(1 - share)) / size
    most, sum = math.max(most, math.abs(off)), sum + off / count
  end
  return most, sum
end

for _, share in ipairs{ 0.3, 0.5, 0.7 } do
  for fineness, allowed in pairs{ [0.4] = 0.09, [1] = 0.07 } do
    local most, mean = edges_off(fineness, share)
    note(("fineness %g, %g of the force: mean %+.3f elements"):format(fineness, share, mean))
    below(most, allowed,
      ("fineness %g, %g of the force: largest error of the stick zone's edge in elements"):format(fineness,
        share))
  end
end

-- --- borders ------------------------------------------------------------------------------------

-- By the theory of Cattaneo and Mindlin, a share s of the width slips under the fraction 1 - (1 - s)^2 of the
-- sliding force. The motion under this force is computed by a contact with little slip, which has no mesh error.
local function motion_at(load, share)
  return contact{ friction = mu, load = load }:move{ tangential = share * mu * load }.x
end

local loads = { 50, 200 }
for _, annulus in ipairs{ 0.05, 0.1, 0.2 } do
  local exact = {}
  for i, load in ipairs(loads) do exact[i] = motion_at(load, 1 - (1 - annulus) ^ 2) end
  for fineness, allowed in pairs{ [0.2] = 0.09, [1] = 0.01 } do
    local map = study.fretting_map{ load = loads, motion = { 1e-3 }, friction = mu, annulus = annulus,
      model = { mesh = { fineness = fineness } } }
    for i, load in ipairs(loads) do
      within(map.partial_from[i], exact[i], allowed,
        ("fineness %g, %g N, %g %% of the width: transition to partial slip [mm]"):format(fineness, load,
          100 * annulus))
    end
  end
end

-- Tests the displacement at the start of gross slip under 100 N/mm against half-planes of the same length as
-- the bodies (7.23 R).
for fineness = 1, 2 do
  local map = study.fretting_map{ load = { 100 }, motion = { 1e-3 }, friction = mu, model = { mesh = { fineness = fineness } } }
  within(map.gross_from[1], 2.677e-3, 0.006, ("fineness %d: transition to gross slip [mm]"):format(fineness))
end

-- Tests dissimilar bodies, which slip first on one side. They have no closed form, but the result must not
-- depend on the mesh.
local function dissimilar(fineness)
  return study.fretting_map{ load = { 100 }, motion = { 1e-3 }, friction = mu,
    model = { plate = { E = 70e3, nu = 0.33 }, mesh = { fineness = fineness } } }
end
local fine, map = dissimilar(3), dissimilar(1)
within(map.partial_from[1], fine.partial_from[1], 0.03,
  "dissimilar bodies, fineness 1 to 3: transition to partial slip [mm]")
within(map.gross_from[1], fine.gross_from[1], 0.005,
  "dissimilar bodies, fineness 1 to 3: transition to gross slip [mm]")

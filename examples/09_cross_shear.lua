-- Cross-shear as a local factor on k: polymers such as UHMWPE wear faster where the direction of sliding
-- changes. Here the counterface also moves across the plane, with an amplitude that grows with the distance
-- from the middle. The factor depends on CS, the share of the friction work that is done across the main
-- direction.
--   archard examples/09_cross_shear.lua

local reach = 0.25 -- distance from the middle at which the angle of the motion is largest [mm]
local unidirectional, across = 0.4, 2.4 -- factor on k at CS = 0, and its increase with CS

local function cross_shear(x)
  local angle = math.rad(35) * math.min(1, math.abs(x) / reach) -- angle of the motion at x
  return math.sin(angle) ^ 2
end

-- Only the plate is a polymer; the cylinder's k is not changed.
local function factor(body, x, p, state)
  if body == "cylinder" then return 1 end
  return unidirectional + across * cross_shear(x)
end

local function run(local_factor)
  return wear{ alpha = 0.1, stroke = 0.22, jump = 40, distance = 660, local_factor = local_factor }:run()
end

local plain, turned = run(), run(factor)
for _, row in ipairs{ { "uniform k", plain }, { "cross-shear", turned } } do
  local w = row[2]
  print(("%-12s plate %.4f um deep, %.3e mm3; pressure %.1f MPa at the centre, %.1f MPa at most"):format(row[1],
    1e3 * w.depth.plate, w.volume.plate, w.p_center, w.p_max))
end
print()

local titles = { "uniform k", "cross-shear" }
plot.profile(plain, turned, "plate", { titles = titles, title = "Wear of the plate" })
plot.pressure(plain, turned, { titles = titles, title = "Contact pressure" })

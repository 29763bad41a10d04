-- Tests rotation as motion and loads at an angle in pairs with a hole: results that must not depend on
-- rotation or angle, the cosine law of a bush that wears alone, and volumes.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local bush_law = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/bush.lua")
local within, below = figures.within, figures.below

local R, gap, P, k = 10, 0.05, 1000, 1e-6
local mesh = { size = 0.25, height = 0.1, rows = 4, far = 1, zone = { cylinder = 26, plate = 26 } }
local function pin() return body.disc{ radius = R - gap, name = "pin" } end
local function bush() return body.ring{ inner = R, outer = 20, name = "bush" } end
-- the pin rotates under a load fixed to the bush
local journal = model{ upper = bush(), lower = pin(), mesh = mesh }
-- the bush rotates under a load fixed to the pin
local hip = model{ upper = pin(), lower = bush(), mesh = mesh }

-- --- unworn round bodies: no effect of rotation or load angle ------------------------------------

for name, m in pairs{ journal = journal, hip = hip } do
  local straight = contact{ model = m, load = P }
  for _, at in ipairs{ { 20, 0 }, { -20, 0 }, { 0, 20 }, { 20, 20 }, { -15, 20 } } do
    local angle, turned = at[1], R * math.rad(at[2])
    local c = contact{ model = m, load = P, load_angle = angle, x = turned }
    local of = ("%s, load at %g degrees, rotated by %g degrees: "):format(name, angle, at[2])
    within(c.p_center, straight.p_center, 3e-4, of .. "centre pressure without rotation [MPa]")
    within(c.normal_force, straight.normal_force, 1e-4, of .. "normal force without rotation [N]")
    below(math.abs(math.deg((c.edges.left + c.edges.right) / 2 / R) - angle), 0.05, of ..
      "the contact is centred under the load [degrees]")
  end
end
local right = contact{ model = hip, load = P, load_angle = 17 }:pressure("pin").p
local left = contact{ model = hip, load = P, load_angle = -17 }:pressure("pin").p
local lopsided = 0
for i = 1, #right do lopsided = math.max(lopsided, math.abs(right[i] - left[#left + 1 - i]) / P) end
below(lopsided, 1e-10, "loads at opposite angles have mirrored pressures")

-- Tests that stresses are given at the present position of the body: the field is the field of a vertical
-- load, rotated with the bush.
local straight, turned = contact{ model = hip, load = P }:stress(), contact{ model = hip, load = P, load_angle = 20,
  x = R * math.rad(20) }:stress()
local function largest(field)
  local at = 1
  for i, v in ipairs(field.mises) do if v > field.mises[at] then at = i end end
  return field.mises[at], field.x[at], field.y[at]
end
local s0, x0, y0 = largest(straight.bush)
local s1, x1, y1 = largest(turned.bush)
local c, s = math.cos(math.rad(20)), math.sin(math.rad(20))
within(s1, s0, 1e-3, "a bush rotated with its load: largest von Mises stress [MPa]")
below(math.max(math.abs(x1 - (c * x0 - s * (y0 - R))), math.abs(y1 - (R + s * x0 + c * (y0 - R)))), 1e-9,
  "error of the position of the largest stress after rotation [mm]")

-- --- the cosine law -------------------------------------------------------------------------------

-- Returns the largest deviation of the pressures from the cosine law over nine tenths of the contact.
local function deviation(w, at) return bush_law.deviation(w, R, gap, at) end
local function swing(t) return 15 * math.sin(2 * math.pi * t) end
local function run(m, angle, share, to_bush)
  local w = wear{ model = m, k_cylinder = k * to_bush, k_plate = k * (1 - to_bush), load = P, scheme = "explicit", load_angle = angle,
    loading = { rotation = swing }, distance = share * R * gap / (k * P) }
  w:run()
  return w
end
local last
for _, goal in ipairs{ { 0.5, 0.09 }, { 1, 0.036 }, { 2, 0.014 } } do
  local share, off = table.unpack(goal)
  local of = ("a rotating pin wears its bush to k P s = %g R c: "):format(share)
  last = run(journal, 0, share, 1)
  below(deviation(last, 0), off + 0.005, of .. "deviation of the pressures from the cosine law")
  within(last.volume.bush, k * last.load_distance, 1e-12,
    of .. "volume by the integral of the normal force [mm3]")
  local h, uneven = last:profile("bush").h, 0
  for i = 1, #h do uneven = math.max(uneven, math.abs(h[i] - h[#h + 1 - i])) end
  below(uneven / last.depth.bush, 1e-9, of .. "asymmetry of the depths")
end
local aside = run(journal, 12, 1, 1)
below(deviation(aside, math.rad(12)), 0.045,
  "load at 12 degrees: deviation of the pressures from the cosine law")
local other = run(journal, -12, 1, 1)
within(other.depth.bush, aside.depth.bush, 1e-9, "depth under a load at -12 degrees [mm]")

-- --- both bodies wear, and the bush rotates -------------------------------------------------------

local both = run(journal, 0, 0.5, 0.5)
within(both.volume.bush, k / 2 * both.load_distance, 1e-12, "both bodies wear: volume of the bush [mm3]")
within(both.volume.pin, k / 2 * both.load_distance, 1e-12, "both bodies wear: volume of the pin [mm3]")
figures.ok(both.depth.pin < both.depth.bush, "the rotating pin has a smaller depth than the bush")

-- Tests that a load that follows the swinging bush wears the bush like a load fixed to a resting bush.
local led = wear{ model = hip, k_cylinder = 0, k_plate = k, load = P, geometry = "frozen", distance = 50,
  loading = { rotation = swing, load_angle = swing }, jump = 0.5 }
local fixed = wear{ model = journal, k_cylinder = k, k_plate = 0, load = P, geometry = "frozen", distance = 50,
  loading = { rotation = swing }, jump = 0.5 }
led:run()
fixed:run()
within(led.volume.bush, fixed.volume.bush, 2e-3, "a load that follows the bush: volume of the bush [mm3]")
within(led.depth.bush, fixed.depth.bush, 1e-2, "a load that follows the bush: depth of the bush [mm]")

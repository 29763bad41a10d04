-- A hip with a polyethylene liner of 8 mm, inclined by 30 degrees, over five million cycles of walking: penetration of
-- the head of 28 mm by creep and by wear. Creep comes first and removes no volume.
--   archard examples/39_polyethylene_liner.lua
-- The angles and the load of walking have the ranges of the standard; the curves between these ranges are
-- approximate. The constants of creep are typical of a conventional polyethylene and have no source: use
-- the constants of your own tests. The model does not include edge loading, microseparation and
-- lubrication, which cause many clinical failures.
-- Springs (foundation = "winkler") are accurate to 4 % for this material, and the error vanishes as the
-- liner wears. Without this setting, the full elastic problem is solved in about a minute.

warn "@off" -- the contact approaches the rim, which causes a warning; its distance is printed below

local pe = material{ E = 1000, nu = 0.4 }
local liner = joint{ head = { radius = 14, material = material{ E = 230e3, nu = 0.3 } }, foundation = "winkler", mesh = { size = 3 },
  cup = { clearance = 0.1, inclination = 30, layers = { { thickness = 8, material = pe } } } }
local c = contact{ model = liner, load = 3000 }
print(("unworn, 3 kN: %.1f MPa, contact to %.0f degrees, %.0f degrees from the rim"):format(c.p_max, c.half_angle, c.rim_margin))

local function creep(s) -- depth in mm; s.cycle / 60: minutes at one cycle a second
  local strain = 3.491e-3 + 7.966e-4 * (math.log(math.max(s.cycle, 1) / 60, 10) - 4) -- per MPa
  return s.thickness * math.max(0, strain) * s.p_mean
end

local w = wear{ model = liner, loading = gait "iso", k = 1e-9, alpha = 0, creep = creep, cycles = 5e6 }
print(" cycles  wear [um]  creep [um]  volume [mm3]  largest pressure [MPa]")
for _, cycles in ipairs{ 1e5, 5e5, 1e6, 2e6, 5e6 } do
  w:run{ cycles = cycles }
  local most = 0
  for _, depth in ipairs(w:map("creep").values) do most = math.max(most, depth) end
  print(("%7.0e %9.1f %11.1f %13.2f %13.2f"):format(cycles, 1000 * w.depth.cup, 1000 * most, w.volume.cup, w.p_peak))
end
print(w)
plot.map(w, "cup")

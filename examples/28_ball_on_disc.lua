-- A steel ball on a rotating disc. The ball wears flat, and the disc wears along its track. The load is the
-- total force, and the volumes are those of the whole ball and the whole track. The disc's depth is the
-- mean over the track.
--   archard examples/28_ball_on_disc.lua

local radius, load, track = 10, 50, 20 -- mm, N, mm
local exact = hertz{ geometry = "axisymmetric", radius = radius, load = load }
local pair = model{ geometry = "axisymmetric", radius = radius, mesh = { size = 0.01, height = 0.02, rows = 4,
  zone = { cylinder = 2.6, plate = 2.6 } } }
local new = contact{ model = pair, load = load }
print(("new: %.1f MPa, %.2f um together; by Hertz %.1f MPa, %.2f um"):format(new.p_center, 1e3 * new.approach, exact.p_max,
  1e3 * exact.approach))

local w = wear{ model = pair, load = load, slide = "z", track = track, k_cylinder = 1e-7, k_plate = 2e-8,
  cycles = 200 }
local contacts, titles = { new }, { "new" }
for _, turns in ipairs{ 2, 20, 200 } do
  w:run{ cycles = turns }
  local h, wanted = 0, w.volume_cylinder -- height of the worn cap of the ball: V = pi h^2 (3 R - h) / 3
  for _ = 1, 60 do h = math.sqrt(3 * wanted / (math.pi * (3 * radius - h))) end
  print(("%3.0f turns: %6.1f MPa, spot %.3f mm wide, ball worn by %.2f um (cap %.2f), track by %.3f um"):format(w.cycle,
    w.p_center, 2 * w.half_width, 1e3 * w.depth_cylinder, 1e3 * h, 1e3 * w.depth_plate))
  contacts[#contacts + 1], titles[#titles + 1] = w:contact(), ("%g turns"):format(turns)
end
plot.pressure(contacts[1], contacts[2], contacts[3], contacts[4], { titles = titles, logy = true,
  title = "A ball on a disc" })

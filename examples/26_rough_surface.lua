-- A wavy surface that is pressed flat and worn flat. At first the crests carry the load, then the pressure
-- becomes uniform.
--   archard examples/26_rough_surface.lua

local length, height = 0.1, 0.1e-3 -- mm
local rough = model{
  upper = body.profile{ width = 4, height = 2, k = 1e-8,
    y = function(x) return height * math.cos(2 * math.pi * x / length) - x * x / 440 end },
  lower = body.block{ width = 4, height = 2 },
  mesh = { size = 0.005, far = 0.2, rows = 2, zone = { cylinder = 1.4, plate = 1.5 } } }
local contacts, titles = {}, {}
for i, load in ipairs{ 10, 30, 80 } do -- N
  local c = contact{ model = rough, load = load }
  contacts[i], titles[i] = c, ("%g N"):format(load)
  print(("%3g N: crest at %.0f MPa, contact over %.3f mm"):format(load, c.p_center, 2 * c.half_width))
end
plot.pressure(contacts[1], contacts[2], contacts[3], { titles = titles, title = "Waves of 0.1 µm" })

-- A ball with a measured roughness on a flat: where it touches, and how the peaks wear off. The map stands for a file,
-- map.read("ball.sdf"):level("sphere"); here it is a sum of waves of all directions, 0.1 um rms.
--   archard examples/34_rough_ball.lua

local step, reach, waves = 0.005, 0.3, {}
for k = 1, 60 do
  local turn, length, start = 2.4 * k, 0.04 + 0.0015 * k, 1.7 * k * k -- directions, wavelengths [mm], phases
  waves[k] = { math.cos(turn) * 2 * math.pi / length, math.sin(turn) * 2 * math.pi / length, start }
end
local function height(x, z)
  local sum = 0
  for _, wave in ipairs(waves) do sum = sum + math.cos(wave[1] * x + wave[2] * z + wave[3]) end
  return 1e-4 * sum / math.sqrt(#waves / 2)
end
local places = {}
for i = 0, 2 * reach / step do places[#places + 1] = -reach + i * step end
local rough = map{ x = places, z = places, y = height }

local flat = body.block{}
local smooth = contact{ load = 5, model = { geometry = "3-D", upper = body.ball{ radius = 5 }, lower = flat } }
local pair = model{ geometry = "3-D", upper = body.map{ y = rough, radius = 5, name = "rough" }, lower = flat, mesh = { size = step } }
local new = contact{ model = pair, load = 5 }
print(("smooth: %.0f MPa at most on %.4f mm2; rough: %.0f MPa on %.4f mm2"):format(smooth.p_max, smooth.area, new.p_max, new.area))

local w = wear{ model = pair, load = 5, stroke = 0.05, alpha = 0.5, k = 1e-8, distance = 100 }
for _, distance in ipairs{ 10, 30, 100 } do
  w:run{ distance = distance }
  print(("%3g mm: %.0f MPa at most on %.4f mm2; ball worn by %.2f um"):format(w.distance, w.p_max, w.area, 1e3 * w.depth.rough))
end
plot.map(w:map("rough", "pressure"))
plot.map(new, { title = "Pressure of a rough ball, unworn" })

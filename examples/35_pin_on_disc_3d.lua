-- A ball on a rotating disc in three dimensions; both bodies wear, and the disc gets a track. The cap worn
-- off the ball and the track conform to each other. On a disc that remains flat, the cap would have the
-- height h = sqrt(V / (pi R)).
--   archard examples/35_pin_on_disc_3d.lua

local radius, load, track = 5, 10, 10 -- mm, N, mm
local w = wear{ model = { geometry = "3-D", upper = body.ball{ radius = radius }, lower = body.block{} }, load = load, track = track,
  k_cylinder = 2e-8, k_plate = 2e-7, cycles = 100 }
local lines = {}
for _, turns in ipairs{ 5, 25, 100 } do
  w:run{ cycles = turns }
  local section = w:profile("block", { x = 0 })
  local cap = math.sqrt(w.volume.ball / (math.pi * radius))
  print(("%3.0f turns: %5.0f MPa, contact %.3f mm wide; ball worn by %.3f um (a cap of its volume: %.3f), track %.3f um deep"):format(
    w.cycle, w.p_center, 2 * w.half_width_z, 1e3 * w.depth.ball, 1e3 * cap, 1e3 * w.depth.block))
  local depths = {}
  for i, h in ipairs(section.h) do depths[i] = 1e3 * h end
  lines[#lines + 1] = { x = section.x, y = depths, title = ("%g turns"):format(turns) }
end
plot{ title = "Track of a disc, across the motion", xlabel = "z / mm", ylabel = "wear depth / µm", ydown = true, table.unpack(lines) }

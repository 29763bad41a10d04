-- Energy wear: the worn volume is proportional to the energy dissipated by friction, V = k E. Three pairs
-- with different friction have the same volume per N mm of energy, but not per cycle.
--   archard examples/17_energy_law.lua

local bodies = model{ mesh = { size = 0.02, height = 0.025 } }
local k = 2e-8 -- mm3 per N mm
local curves, most = {}, 0
print "friction  energy / N mm  volume / mm3     V / E   depth of the plate / um"
for i, friction in ipairs{ 0.3, 0.6, 0.9 } do
  local w = wear{ model = bodies, friction = friction, load = 100, stroke = 0.05, k = k, law = "energy",
    cycles = 3000, increments = 60 }
  w:run{ progress = false }
  print(("%8.1f %14.1f %13.4e %9.3e %12.4f"):format(friction, w.energy, w.volume.total, w.volume.total / w.energy,
    1e3 * w.depth.plate))
  curves[i] = { x = {}, y = {}, style = "points", title = ("friction %g"):format(friction) }
  for j = i, #w.history.energy, 3 do -- every third point, so that the curves do not hide each other
    table.insert(curves[i].x, w.history.energy[j])
    table.insert(curves[i].y, w.history.volume_cylinder[j] + w.history.volume_plate[j])
  end
  most = math.max(most, w.energy)
end
print()

curves[4] = { x = { 0, most }, y = { 0, k * most }, colour = "black", title = "V = k E" }
curves.xlabel, curves.ylabel, curves.title = "energy / N mm", "volume / mm³", "One line for all"
plot(curves)

-- The fretting case of McColl, Ding and Leen (Wear 256, 2004): a cylinder of radius 6 mm on a flat, 18.5 N
-- per mm, an amplitude of 25 um, friction 0.9, and 18000 cycles in gross slip. The depths of the flat are
-- compared with published depths, which were computed by mesh motion and by level sets and took hours.
--   archard examples/16_mccoll.lua

local cycles = { 1000, 5000, 10000, 18000 }
local mesh_motion = { 0.3727, 1.1249, 1.8079, 2.7055 } -- um
local level_set = { 0.3784, 1.1311, 1.8145, 2.7130 }   -- um

local w = wear{
  model = { radius = 6, mesh = { size = 0.01, height = 0.01 } },
  friction = 0.9, load = 18.5, stroke = 0.05, increments = 40,
  k_cylinder = 1.9e-8, k_plate = 2.9e-8, cycles = 18000,
}
local start = os.clock()
print "   cycles  depth of the flat / um: here  level set  mesh motion"
local here = {} -- um
for i, count in ipairs(cycles) do
  w:run{ cycles = count, progress = false }
  here[count] = 1e3 * w.depth.plate
  print(("%9d %29.4f %10.4f %12.4f"):format(count, 1e3 * w.depth.plate, level_set[i], mesh_motion[i]))
end
print(("in %.1f s, %d updates; %.4g N mm were dissipated"):format(os.clock() - start, w.update, w.energy))
print()

local depth, off = {}, { {}, {} }
for i, h in ipairs(w.history.depth_plate) do depth[i] = 1e3 * h end
for i, published in ipairs{ level_set, mesh_motion } do
  for n, count in ipairs(cycles) do off[i][n] = 100 * (published[n] / here[count] - 1) end
end
plot{ layout = { 1, 2 }, title = "McColl's fretting case", panels = {
  { { x = w.history.cycle, y = depth, title = "archard" },
    { x = cycles, y = level_set, style = "points", title = "level set" },
    { x = cycles, y = mesh_motion, style = "points", series = 4, title = "mesh motion" },
    xlabel = "cycles", ylabel = "depth of the flat / µm" },
  { { x = { 0, 20000 }, y = { 0, 0 }, title = "archard" },
    { x = cycles, y = off[1], style = "points", title = "level set" },
    { x = cycles, y = off[2], style = "points", series = 4, title = "mesh motion" },
    xlabel = "cycles", ylabel = "difference in depth / %", yrange = { -2, 0.5 } },
} }

-- The paper's reference case in one command: a cylinder and a plate wear each other over 1320 mm of sliding.
-- Run it with `make demo`, or build/archard examples/demo.lua.

local w = wear{ stroke = 0.11, alpha = 0.5, jump = 100, increments = 100, cycles = 6000 }
local unworn = w:clone()
local hertz = hertz{ radius = 10, load = 100 }

io.write(string.format("half cylinder R = %g mm on a plate, %g N per mm, k = %g mm2/N\n", w.model.radius, w.load, w.k))
io.write(string.format(
  "stroke %g mm, alpha = %g, %g cycles, geometry update every %g cycles, %d increments a cycle\n", w.stroke,
  w.alpha, w.cycles, w.jump, w.increments))
io.write(string.format("meshes: %d and %d elements, built in %.2f s\n\n", w.model.mesh.cylinder.elements_count,
  w.model.mesh.plate.elements_count, w.model.seconds))

local start = os.clock()
w:run{ progress = false }
local seconds = os.clock() - start

local rows = {
  { "distance", "%.0f mm", 0, w.distance },
  { "centre pressure", "%.1f MPa", unworn.p_center, w.p_center },
  { "  by Hertz, unworn", "%.1f MPa", hertz.p_max },
  { "half contact width", "%.4f mm", unworn.half_width, w.half_width },
  { "depth of the cylinder", "%.4f um", 0, 1e3 * w.depth.cylinder },
  { "depth of the plate", "%.4f um", 0, 1e3 * w.depth.plate },
  { "volume of the cylinder", "%.3e mm3", 0, w.volume.cylinder },
  { "volume of the plate", "%.3e mm3", 0, w.volume.plate },
  { "total volume", "%.3e mm3", 0, w.volume.total },
  { "alpha-tilde", "%.4f", nil, w.depth_partition },
}
io.write(string.format("%-24s %18s %18s\n", "", "unworn", "worn"))
for _, row in ipairs(rows) do
  local function cell(value) return value and string.format(row[2], value) or "" end
  io.write(string.format("%-24s %18s %18s\n", row[1], cell(row[3]), cell(row[4])))
end
io.write(string.format("\n%d updates, %d contact solutions in %.2f s\n\n", w.update, w.solutions, seconds))

plot.pressure(unworn, w, { title = "Contact pressure, unworn and worn" })
io.write("\n")
plot.profile(w, { title = "Wear profiles" })
io.write("\n")
plot.history(w, "p_center", { title = "Pressure at the centre" })

-- A ball with a measured roughness on a flat: areas of contact, and wear of the peaks.
--   archard examples/34_rough_ball.lua [ball.sdf]
--   archard examples/34_rough_ball.lua make ball.sdf    writes such a map
-- The map of this example is generated and not measured: a ball of radius 5 mm with waves of all directions
-- (0.1 um rms), a tilt, noise from a seeded generator and points without a value. The file has the format
-- of an instrument (ISO 25178-71, heights in nm).

local step, count = 0.006, 81 -- mm, points along x and z

local function rough(x, z)
  local sum = 0
  for k = 1, 60 do
    local turn, length = 2.4 * k, 0.04 + 0.0015 * k -- direction, wavelength [mm]
    sum = sum + math.cos((math.cos(turn) * x + math.sin(turn) * z) * 2 * math.pi / length + 1.7 * k * k)
  end
  return 1e-4 * sum / math.sqrt(30)
end

local function make(path)
  math.randomseed(34)
  local lines = { "aISO-1.0", "ManufacID = archard", "CreateDate = 241120261200", "ModDate = 241120261200", "NumPoints = " .. count,
    "NumProfiles = " .. count, "Xscale = 6e-6", "Yscale = 6e-6", "Zscale = 1e-9", "Zresolution = -1", "Compression = 0",
    "DataType = 6", "CheckType = 0", "*" }
  for j = 0, count - 1 do
    local row = {}
    for i = 0, count - 1 do
      local x, z = (i - (count - 1) / 2) * step, (j - (count - 1) / 2) * step
      local y = rough(x, z) - (x * x + z * z) / 10 + 2e-3 * x - 1e-3 * z + 1e-5 * (math.random() - 0.5)
      row[#row + 1] = math.random() < 0.002 and "BAD" or ("%.0f"):format(1e6 * y)
    end
    lines[#lines + 1] = table.concat(row, " ")
  end
  local file <close> = assert(io.open(path, "w"))
  file:write(table.concat(lines, "\n"), "\n")
end

if arg[1] == "make" then return make(arg[2]) end
local measured = map.read(arg[1] or (arg[0]:match "^(.*)/" or ".") .. "/34_rough_ball.sdf", { fill = true, level = "sphere" }):center()
print(("%d x %d points, %d of them filled; a sphere of %.3f mm was subtracted"):format(#measured.x, #measured.z, measured.missing,
  measured.radius))

local flat = body.block{}
local smooth = contact{ load = 5, model = { geometry = "3-D", upper = body.ball{ radius = 5 }, lower = flat } }
local pair = model{ geometry = "3-D", upper = body.map{ y = measured, radius = 5, name = "rough" }, lower = flat, mesh = { size = step } }
local new = contact{ model = pair, load = 5 }
print(("smooth: %.0f MPa at most on %.4f mm2; rough: %.0f MPa on %.4f mm2"):format(smooth.p_max, smooth.area, new.p_max, new.area))

local w = wear{ model = pair, load = 5, stroke = 0.05, alpha = 0.5, k = 1e-8, distance = 100 }
for _, distance in ipairs{ 10, 30, 100 } do
  w:run{ distance = distance }
  print(("%3g mm: %.0f MPa at most on %.4f mm2; ball worn by %.2f um"):format(w.distance, w.p_max, w.area, 1e3 * w.depth.rough))
end
plot.map(w:map("rough", "pressure"))
plot.map(new, { title = "Pressure of a rough ball, unworn" })

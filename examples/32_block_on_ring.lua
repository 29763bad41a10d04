-- A steel ring that rotates on a block over 3600 m. Only the block wears, and the scar becomes 25 times as
-- wide as the first contact. The depths are compared with depths published for a level-set method, and with
-- the depths of a rigid ring.
--   archard examples/32_block_on_ring.lua

local radius, width, load, k, metres = 20, 6, 65, 2e-9, { 800, 1600, 3600 } -- mm, mm, N, mm2/N, m
local published = { 16.155, 25.709, 44.280 } -- um; computed in 18.5 hours (25 hours with mesh motion)

local began = os.clock()
local w = wear{ model = { radius = radius, thickness = width }, load = load, k_cylinder = 0, k_plate = k, slide = "z",
  distance = 1000 * metres[#metres], tolerance = 1e-2 }

-- Returns the depth [mm] of the scar of a rigid ring: a circular segment with the worn area [mm2].
local function rigid(area)
  local low, high = 0, radius
  for _ = 1, 60 do
    local h = (low + high) / 2
    local angle = math.acos(1 - h / radius)
    if radius ^ 2 * (angle - math.sin(2 * angle) / 2) < area then low = h else high = h end
  end
  return low
end

local curves = {}
print "      m   depth um   published   rigid    half width mm   updates"
for i, m in ipairs(metres) do
  w:run{ distance = 1000 * m }
  print(("%7d   %8.3f   %9.3f  %7.3f   %10.3f   %10d"):format(m, 1e3 * w.depth.plate, published[i],
    1e3 * rigid(k * load / width * 1000 * m), w.half_width, w.update))
  local p = w:profile "plate"
  local curve = { x = p.x, y = {}, title = m .. " m" }
  for j, h in ipairs(p.h) do curve.y[j] = 1e3 * h end
  curves[i] = curve
end
print(("%.1f s of computing"):format(os.clock() - began))

plot{ curves[1], curves[2], curves[3], title = "A block worn by a ring", xlabel = "x / mm",
  ylabel = "wear depth / µm", ydown = true }

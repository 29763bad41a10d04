-- The partition factor: depths and scars of both bodies for several alpha. The volume is the same in all cases. The scar
-- of the moving body is longer by the stroke, so depths differ even at alpha = 0.5.
--   archard examples/03_partition.lua

local m = model{}
local cylinder = { title = "Cylinder", xlabel = "x / mm", ylabel = "wear depth / µm", ydown = true }
local plate = { title = "Plate", xlabel = "x / mm", ylabel = "wear depth / µm", ydown = true }

local function add(panel, w, body)
  local profile, depth = w:profile(body), {}
  for i, h in ipairs(profile.h) do depth[i] = 1e3 * h end
  panel[#panel + 1] = { x = profile.x, y = depth, title = ("α = %g"):format(w.alpha) }
end

print(" alpha  cylinder  plate [um]  their share  centre pressure [MPa]")
for _, alpha in ipairs{ 0, 0.25, 0.5, 0.75, 1 } do
  local w = wear{ model = m, alpha = alpha, stroke = 0.22, jump = 25 }:run{ progress = false }
  print(("%6.2f %9.4f %11.4f %12.3f %22.1f"):format(alpha, 1e3 * w.depth.cylinder, 1e3 * w.depth.plate,
    w.depth_partition, w.p_center))
  add(cylinder, w, "cylinder")
  add(plate, w, "plate")
end
print()

plot{ panels = { cylinder, plate }, yrange = { 0 } }

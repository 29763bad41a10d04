-- A block with a hard coating of 2 um, which wears through. The coating is stiffer than the steel below it
-- and wears ten times slower, so the wear rate rises afterwards.
--   archard examples/25_coating_wear_through.lua

local w = wear{ load = 100, stroke = 0.2, distance = 6000, model = {
  lower = body.block{ width = 20, height = 10, k = 2e-8,
    layers = { { thickness = 2e-3, material = material{ E = 400e3, nu = 0.25, k = 2e-9 } } } },
  mesh = { size = 0.04, height = 0.03 } } }
local _, why = w:run{ depth = { plate = 2e-3 } }
local through = w:clone()
print(("the coat is through after %.0f mm (%s)"):format(w.distance, why))
w:run()
print(("after %.0f mm: %.2f um deep, %.4f mm3; the coat alone would have lost %.4f mm3"):format(w.distance,
  1e3 * w.depth_plate, w.volume_plate, 2e-9 * w.load_distance))
plot.profile(through, w, "plate", { titles = { "through", "end" }, title = "Wear through a coat" })

-- Fit of k and alpha as curves over the distance during running-in, from volumes measured at intervals. The
-- smoothness of the curves is chosen by cross-validation: each volume is predicted from the others.
--   archard examples/21_running_in_fit.lua

local measured = csv.read((arg[0]:match("^(.*)/") or ".") .. "/running_in_fit.csv",
  { distance = "distance [mm]", cylinder = "cylinder [mm3]", plate = "plate [mm3]" })

-- Volumes do not depend on the mesh; a coarse mesh is sufficient.
local knots = { 0, 150, 500, 1320 }
local f = fit{
  base = { stroke = 0.22, jump = 50, increments = 20, geometry = "frozen",
    model = { mesh = { size = 0.04, height = 0.05 } } },
  unknown = { k = { start = 1e-8, knots = knots, smooth = "auto" },
    alpha = { start = 0.5, knots = knots, smooth = "auto" } },
  data = {
    { of = "volume_cylinder", distance = measured.distance, value = measured.cylinder, relative = 0.03 },
    { of = "volume_plate", distance = measured.distance, value = measured.plate, relative = 0.03 },
  },
}
print(f)
plot.fit(f, { curves = true })

-- wear{} accepts the fitted curves.
local w = wear{ k = f.curve.k, alpha = f.curve.alpha, stroke = 0.22 }
w:run()
print(w)

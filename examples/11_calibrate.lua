-- Calibration: k and alpha are computed from volumes measured on three specimens. The depths after twice
-- the distance are then predicted.
--   archard examples/11_calibrate.lua

local measured = calibrate{
  volume = { cylinder = { 0.41e-3, 0.44e-3, 0.39e-3 }, plate = { 0.92e-3, 0.88e-3, 0.97e-3 } },
  load = 100, distance = 1320,
}
print(measured)

local forecast = wear{ k = measured.k, alpha = measured.alpha, stroke = 0.22, jump = 50,
  distance = 2640 }
forecast:run()
print(forecast)

-- Measured depths also give k and alpha; this needs a few runs.
print(calibrate{ depth = { cylinder = forecast.depth.cylinder, plate = forecast.depth.plate },
  load = 100, stroke = 0.22, jump = 50, distance = 2640 })

-- Volumes at intermediate distances give k and alpha as functions of the distance. Here: three tests with
-- six readings each.
local course = calibrate{
  distance = { 60, 150, 300, 600, 900, 1320 }, load = 100,
  volume = {
    cylinder = { { 0.107e-3, 0.203e-3, 0.283e-3, 0.381e-3, 0.462e-3, 0.571e-3 },
      { 0.101e-3, 0.192e-3, 0.268e-3, 0.374e-3, 0.459e-3, 0.578e-3 },
      { 0.112e-3, 0.207e-3, 0.279e-3, 0.383e-3, 0.471e-3, 0.583e-3 } },
    plate = { { 0.081e-3, 0.178e-3, 0.312e-3, 0.532e-3, 0.749e-3, 1.041e-3 },
      { 0.088e-3, 0.191e-3, 0.331e-3, 0.547e-3, 0.761e-3, 1.028e-3 },
      { 0.079e-3, 0.183e-3, 0.318e-3, 0.541e-3, 0.752e-3, 1.035e-3 } } },
}
print(course)
local band, ends = course.band.k, { 0, 60, 150, 300, 600, 900, 1320 }
local range = { x = {}, y = {}, style = "filled", series = 2, title = "range of its mean" } -- lower limits, then upper limits backwards
local function add(i, value)
  range.x[#range.x + 1], range.y[#range.y + 1] = ends[i], value
end
for i, low in ipairs(band.low) do add(i, low) add(i + 1, low) end
for i = #band.high, 1, -1 do add(i + 1, band.high[i]) add(i, band.high[i]) end
plot{ range, { x = course.k.distance, y = course.k.value, title = "k", style = "lines", series = 1 },
  xlabel = "distance / mm", ylabel = "k / (mm²/N)" }

local running_in = wear{ k = course.k, alpha = course.alpha, stroke = 0.22 }
running_in:run()
print(("volumes %.4g and %.4g mm3, measured %.4g and %.4g mm3"):format(running_in.volume.cylinder,
  running_in.volume.plate, course.mean.k_cylinder * 100 * 1320, course.mean.k_plate * 100 * 1320))

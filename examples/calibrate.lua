-- From a worn pair to the numbers of the model, and to a forecast: volumes measured on three
-- specimens give k and alpha, and those the depths after twice the distance.
local measured = calibrate{
  volume = { cylinder = { 0.41e-3, 0.44e-3, 0.39e-3 }, plate = { 0.92e-3, 0.88e-3, 0.97e-3 } },
  load = 100, distance = 1320,
}
print(measured)

local forecast = wear{ k = measured.k, alpha = measured.alpha, stroke = 0.22, jump = 50,
  distance = 2640 }
forecast:run()
print(forecast)

-- Depths alone cannot tell k, but which alpha shares them so.
print(calibrate{ depth = { cylinder = forecast.depth.cylinder, plate = forecast.depth.plate },
  k = measured.k, stroke = 0.22, jump = 50, distance = 2640 })

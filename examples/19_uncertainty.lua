-- Uncertainty of a prediction: quantiles, the inputs that cause the scatter, and the probability of a depth above 1.5 um.
-- Wear coefficients scatter by 40 % from test to test, alpha is hardly ever measured, and loads drift.
--   archard examples/19_uncertainty.lua [run file]
local w = wear{ geometry = "frozen", distance = 660 }
w:run{ progress = false }
local s = w:sensitivity{ of = { "depth_cylinder", "p_center" }, to = { "k", "alpha", "load", "E" } }
print(s)
plot.tornado(s, { of = "p_center" })

local samples = study{
  name = "scatter", base = { geometry = "frozen", distance = 660, jump = 40, increments = 20 },
  sample = { k = lognormal{ mean = 1e-8, variation = 0.4 }, alpha = uniform{ 0.3, 0.7 }, load = normal{ 100, 5 } },
  n = 64, indices = true, seed = 1,
}
samples:run{ file = arg[1] or "uncertainty.archard" }
local u = samples:uncertainty{ of = { "depth_cylinder", "p_center" } }
print(u)
print(samples:failure{ of = "depth_cylinder", above = 1.5e-3, before = 600 })
plot.bands(u, { of = "depth_cylinder" })
plot.tornado(u)

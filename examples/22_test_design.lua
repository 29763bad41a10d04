-- Design of a test: the measurements that determine k and alpha best. The standard errors for each
-- measurement alone and the best order of the measurements are computed before the test.
--   archard examples/22_test_design.lua

local d = fit.design{
  base = { stroke = 0.22, jump = 50 },
  unknown = { k = { start = 1e-8 }, alpha = { start = 0.5 } },
  measure = {
    { profile = "cylinder", distance = { 150, 300, 660, 1320 }, error = 2e-4 },
    { profile = "plate", distance = { 150, 300, 660, 1320 }, error = 2e-4 },
    { of = "volume", distance = { 150, 300, 660, 1320 }, relative = 0.05, title = "weight loss of both" },
    { of = "width", distance = { 150, 300, 660, 1320 }, relative = 0.02, title = "width of the scar" },
  },
}
print(d)
plot.fit(d)

-- k and alpha from one pair of measured profiles, with standard errors. Shift, tilt and offset of the traces are fitted
-- as well.
--   archard examples/20_fit_profile.lua

local folder = (arg[0]:match("^(.*)/") or ".") .. "/"
local function trace(body)
  return csv.read(folder .. "fit_" .. body .. ".csv", { x = "x [mm]", h = "h [mm]" })
end

local f = fit{
  base = { stroke = 0.22, jump = 50 },
  unknown = { k = { start = 1e-8 }, alpha = { start = 0.5 } },
  data = {
    { profile = trace "cylinder", body = "cylinder", distance = 1320, error = 5e-5 },
    { profile = trace "plate", body = "plate", distance = 1320, error = 5e-5 },
  },
}
print(f)
plot.fit(f)

-- The run with the fitted values continues to a larger distance.
f.wear:run{ distance = 2640 }
print(f.wear)

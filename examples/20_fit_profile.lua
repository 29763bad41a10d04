-- k and alpha from one pair of measured profiles, and how sure they are. The traces lie a little beside,
-- tilted and lifted: that is fitted along.
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

-- The run with these values goes on: what will it come to?
f.wear:run{ distance = 2640 }
print(f.wear)

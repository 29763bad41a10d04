-- k and alpha of a ball test from microscope data: profiles of the ball's scar along and across the motion,
-- a trace across the scar of the flat, and the worn volume of the flat. Shift, tilt and offset of each
-- trace are fitted too. The data are generated here by a run with k = 1.3e-8 mm2/N and alpha = 0.4, with
-- noise of 0.01 um and 1 %.
--   archard examples/36_fit_scar.lua

local test = { model = { geometry = "3-D", upper = body.ball{ radius = 5 }, lower = body.block{}, mesh = { fineness = 0.5 } }, load = 10,
  stroke = 0.2, distance = 600 }

local truth = { k = 1.3e-8, alpha = 0.4 }
for name, value in pairs(test) do truth[name] = value end
local worn = wear(truth)
worn:run()
math.randomseed(36)
local function noise(size) return size * (math.random() + math.random() + math.random() - 1.5) * 2 end
local function trace(body, section, aside, level)
  local line, x, h = worn:profile(body, section), {}, {}
  for i = 1, #line.x do x[i], h[i] = line.x[i] + aside, line.h[i] + level + noise(1e-5) end
  return { x = x, h = h, body = body, section = section, distance = 600, error = 1e-5 }
end

local f = fit{
  base = test,
  unknown = { k = { start = 1e-8 }, alpha = { start = 0.5 } },
  data = {
    trace("cylinder", { z = 0 }, 0.004, 1e-4), -- the ball along the motion
    trace("cylinder", { x = 0 }, -0.006, 0), -- the ball across the motion
    trace("plate", { x = 0 }, 0.005, 5e-5),
    { of = "volume_plate", distance = 600, value = worn.volume.block * (1 + noise(0.01)), relative = 0.01 },
  },
}
print(f)
plot.profile(f.wear, "ball")
plot.fit(f)

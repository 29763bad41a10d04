-- Writes the measurements for examples/20_fit_profile.lua and examples/21_running_in_fit.lua: results of runs
-- with known values, and random noise of a realistic size. The noise is the same in every call.
--
--   archard scripts/tools/fit_data.lua

math.randomseed(20, 26)
for _ = 1, 200 do math.random() end
local function normal()
  return math.sqrt(-2 * math.log(1 - math.random())) * math.cos(2 * math.pi * math.random())
end

local function write(path, text, ...)
  local file <close> = assert(io.open("examples/" .. path, "w"))
  file:write(text:format(...))
end

local function at(surface, x)
  for i = 2, #surface.x do
    if x <= surface.x[i] then
      local share = (x - surface.x[i - 1]) / (surface.x[i] - surface.x[i - 1])
      return surface.h[i - 1] + share * (surface.h[i] - surface.h[i - 1])
    end
  end
end

-- Writes a measured profile of a body with points every 10 um from -0.5 to 0.5 mm. Its noise is 0.05 um. Its
-- position has a shift [mm], a tilt [mm/mm] and a level [mm].
local function trace(run, body, shift, tilt, level)
  local surface, lines = run:profile(body), {}
  for i = -50, 50 do
    local x = i / 100
    local h = at(surface, x - shift) + tilt * x + level + 5e-5 * normal()
    lines[#lines + 1] = ("%.2f,%.7f"):format(x, h)
  end
  write("fit_" .. body .. ".csv", "# Made by scripts/tools/fit_data.lua: k 1.3e-8 mm2/N, alpha 0.35, noise "
    .. "0.05 um,\n# shift %g mm, tilt %g um/mm, level %g um.\nx [mm],h [mm]\n%s\n", shift, 1e3 * tilt,
    1e3 * level, table.concat(lines, "\n"))
end

local worn <close> = wear{ k = 1.3e-8, alpha = 0.35, stroke = 0.22, jump = 50 }
worn:run()
trace(worn, "cylinder", 0.006, 1.5e-4, -2e-4)
trace(worn, "plate", -0.004, -1e-4, 3e-4)

-- Writes the wear volumes of both bodies at several distances, with errors of 3 %. During running-in, k falls
-- to a third of its initial value.
local function k(state) return 1e-8 * (1 + 2 * math.exp(-state.distance / 200)) end
local function alpha(state) return 0.35 + 0.3 * math.exp(-state.distance / 300) end
local run <close> = wear{ k = k, alpha = alpha, stroke = 0.22, jump = 25 }
local lines = {}
for _, distance in ipairs{ 30, 60, 100, 150, 220, 300, 420, 600, 800, 1000, 1160, 1320 } do
  run:run{ distance = distance, progress = function() end }
  lines[#lines + 1] = ("%g,%.3e,%.3e"):format(distance, run.volume.cylinder * (1 + 0.03 * normal()),
    run.volume.plate * (1 + 0.03 * normal()))
end
write("running_in_fit.csv", "# Made by scripts/tools/fit_data.lua: k = 1e-8 (1 + 2 exp(-d / 200 mm)) mm2/N,\n"
  .. "# alpha = 0.35 + 0.3 exp(-d / 300 mm), volumes with 3 %% of noise.\n"
  .. "distance [mm],cylinder [mm3],plate [mm3]\n%s\n", table.concat(lines, "\n"))

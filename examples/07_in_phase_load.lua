-- Reciprocating motion under a load that varies in phase with the position or with the speed. A load in
-- phase with the position wears one side of the plate more; a load in phase with the speed wears both sides
-- equally. The load varies between 40 and 160 N, and the motion is a sine with a stroke of 0.22 mm. The
-- worn volume is the same in both cases.
--   archard examples/07_in_phase_load.lua

local amplitude = 0.11 -- mm

local function position(t) return amplitude * math.sin(2 * math.pi * t) end
local function with_position(t) return 100 + 60 * math.sin(2 * math.pi * t) end
local function with_speed(t) return 100 + 60 * math.cos(2 * math.pi * t) end

local function run(load)
  return wear{
    load = 100, -- reference load of the reported pressures
    loading = { x = position, load = load, increments = 100, cycles = 3000 },
    jump = 40,
  }:run()
end

-- Returns the position of the centroid of the plate's wear [mm].
local function centre(profile)
  local sum, moment = 0, 0
  for i, h in ipairs(profile.h) do
    sum, moment = sum + h, moment + h * profile.x[i]
  end
  return moment / sum
end

local runs = { run(with_position), run(with_speed) }
local titles = { "load in phase with the position", "in phase with the speed" }
for i, w in ipairs(runs) do
  print(("%-32s volume %.4e mm3, plate %.4f um deep, its centre %+.4f mm off the middle"):format(titles[i],
    w.volume.total, 1e3 * w.depth.plate, centre(w:profile("plate"))))
end
print()

plot.profile(runs[1], runs[2], "plate", { titles = titles, title = "Wear of the plate" })

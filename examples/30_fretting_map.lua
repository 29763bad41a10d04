-- The running condition fretting map of a steel cylinder on a plate with friction 0.6: the loads and
-- amplitudes of motion with stick, partial slip and gross slip. The borders between these conditions are
-- computed at each load.
--   archard examples/30_fretting_map.lua

local began = os.clock()
local map = study.fretting_map{ friction = 0.6, load = { 20, 50, 100, 150, 200 }, motion = { 0.0003, 0.0008, 0.002, 0.004 } }
print(map)

-- Theory of Cattaneo and Mindlin: force / (friction times load) = 1 - (stick width / contact width)^2. The
-- value 0.19 belongs to a stick zone of 0.9 of the width.
local at_100 = contact{ friction = 0.6, load = 100 }
print(("\nat 100 N partial slip begins at %.3f um, for half-planes at %.2f N: %.3f um; %.1f s in all"):format(
  1e3 * map.partial_from[3], 0.19 * 60, 1e3 * at_100:move{ tangential = 0.19 * 60 }.x, os.clock() - began))

plot.fretting_map(map)

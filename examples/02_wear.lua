-- The reference case: wear of a cylinder and a plate over 1320 mm of sliding, with intermediate results.
--   make demo, or archard examples/02_wear.lua

local w = wear{ stroke = 0.11, alpha = 0.5, k = 1e-8, load = 100, distance = 1320 }
print(w)
print()

-- step() and run() continue from the present state of a run. clone() copies the run in this state.
local states = { w:clone() }
local start = os.clock()
for _, distance in ipairs{ 22, 66, 220, 660, 1320 } do
  w:run{ distance = distance, progress = false }
  states[#states + 1] = w:clone()
end
local seconds = os.clock() - start

print("distance  centre pressure  half width  cylinder    plate       volume")
print("    [mm]            [MPa]        [mm]      [um]     [um]        [mm3]")
for _, state in ipairs(states) do
  print(("%8.0f %16.1f %11.4f %9.4f %8.4f %12.3e"):format(state.distance, state.p_center,
    state.half_width, 1e3 * state.depth.cylinder, 1e3 * state.depth.plate, state.volume.total))
end
print(("\nk L d = %.3e mm3; %d updates, %d contact solutions in %.2f s\n"):format(w.k * w.load * w.distance,
  w.update, w.solutions, seconds))

plot.profile(w, { title = "Wear after 1320 mm" })
print()
states[#states + 1] = { title = "Contact pressure while the surfaces wear" }
plot.pressure(table.unpack(states))

-- Running-in: the wear coefficient decays to a fifth, with a decay length of 100 mm of sliding. Automatic steps are
-- short while k falls and long afterwards.
--   archard examples/05_running_in.lua

local settled, fresh, length = 1e-8, 5e-8, 100 -- mm2/N, mm2/N, mm

local function running_in(state)
  return settled + (fresh - settled) * math.exp(-state.distance / length)
end

local steady = wear{ k = settled }:run()
local w = wear{ k = running_in }:run()

-- The volume is the load times the integral of k over the distance.
local d = w.distance
local expected = w.load * (settled * d + (fresh - settled) * length * (1 - math.exp(-d / length)))
print(("volume %.4e mm3, by the integral of k %.4e mm3 (%+.3f %%); at the settled k alone %.4e mm3"):format(
  w.volume.total, expected, 100 * (w.volume.total / expected - 1), steady.volume.total))

print("\nsteps of the run, in cycles:")
for i, jump in ipairs(w.history.jump) do
  if i > 1 then io.write(("%.0f "):format(jump)) end
end
print("\n")

plot.history(w, steady, "k", "p_center", { titles = { "running in", "settled from the start" } })

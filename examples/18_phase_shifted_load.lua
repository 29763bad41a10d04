-- Fretting under a load that varies with a phase shift to the tangential force: load 100 +- 40 N, force
-- +-30 N, friction 0.6. At a shift of 90 degrees, where the load falls as the force rises, more of the
-- contact slips than in phase, and the same forces dissipate several times as much energy.
--   archard examples/18_phase_shifted_load.lua

local bodies = model{ mesh = { size = 0.01, height = 0.0125 } }
local loops, titles = {}, {}
print "shift / deg  energy / N mm a cycle  stick / mm  plate after 2000 cycles / um"
for i, degrees in ipairs{ 0, 45, 90 } do
  local shift = math.rad(degrees)
  local w = wear{
    model = bodies, friction = 0.6, load = 100, k = 1e-7, jump = 200,
    loading = {
      tangential = function(t) return 30 * math.sin(2 * math.pi * t) end,
      load = function(t) return 100 + 40 * math.sin(2 * math.pi * t + shift) end,
      increments = 60, cycles = 2000,
    },
  }
  loops[i], titles[i] = w:loop(), ("%d degrees"):format(degrees)
  w:run{ progress = false }
  print(("%11d %22.3e %11.4f %24.5f"):format(degrees, loops[i].energy, w.stick_width, 1e3 * w.depth.plate))
end
print()

-- Most of the motion is elastic. This part is subtracted, since the loops would overlap otherwise.
local top, bottom = 1, 1
for i, force in ipairs(loops[1].tangential) do
  if force > loops[1].tangential[top] then top = i end
  if force < loops[1].tangential[bottom] then bottom = i end
end
local compliance = (loops[1].x[top] - loops[1].x[bottom])
  / (loops[1].tangential[top] - loops[1].tangential[bottom])
local curves = { xlabel = "tangential force / N", xrange = { -35, 35 }, ylabel = "inelastic motion / µm",
  title = "Fretting loops at three shifts of phase" }
for i, loop in ipairs(loops) do
  local left = {}
  for j, x in ipairs(loop.x) do left[j] = 1e3 * (x - compliance * loop.tangential[j]) end
  curves[i] = { x = loop.tangential, y = left,
    title = ("%s, %.2e N mm a loop"):format(titles[i], loop.energy) }
end
plot(curves)

-- Tests a wavy profile on a flat against Westergaard's closed form.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, below = figures.within, figures.below

-- --- waves --------------------------------------------------------------------------------------

-- By Westergaard's theory, waves of amplitude D and length l that touch over the width 2 a of each wave carry
-- the mean pressure p* sin^2(pi a / l) with p* = pi E* D / l. The pressure at the crest is the mean pressure
-- times 2 / sin(pi a / l). On a crowned profile this holds for the wave in the middle.
local length, height = 0.1, 1e-4
local star = math.pi * 109890.1 * height / length
local rough = contact{ load = 50, average = 0, model = {
  upper = body.profile{ width = 4, height = 2,
    y = function(x) return height * math.cos(2 * math.pi * x / length) - x * x / 440 end },
  lower = body.block{ width = 4, height = 2 },
  mesh = { size = 0.002, height = 0.0025, far = 0.2, zone = { cylinder = 1.2, plate = 1.2 } } } }
local at = rough:pressure("cylinder")
local force, touching = 0, 0
for i, x in ipairs(at.x) do
  -- fraction of the node's tributary width that is inside the middle wave
  local share = math.max(0, math.min(1, (length / 2 - math.abs(x)) / 0.002 + 0.5))
  force = force + share * at.p[i] * 0.002
  if at.p[i] > 0 then touching = touching + share * 0.002 end
end
local mean, sine = force / length, math.sin(math.pi * touching / 2 / length)
figures.about(touching / length, 2 / math.pi * math.asin(math.sqrt(mean / star)), 0.02,
  "waves: fraction of the length in contact, to an element")
within(rough.p_center, 2 * mean / math.sqrt(mean / star), 0.01, "waves: pressure at a crest [MPa]")

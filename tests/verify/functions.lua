-- Tests coefficients as functions of the state. The integral of k includes peaks within an update or a cycle,
-- and functions of pressure, width and depth do not reduce the order of convergence of the time steps.
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, below = figures.within, figures.below
local merged = require "archard.lib.merged"

local function run(fields) return wear(fields):run{ progress = false } end

-- --- k by distance and cycle: the volume is the integral of k L --------------------------------------

local function wave(length)
  return function(s) return 1e-8 * (1 + 0.5 * math.sin(2 * math.pi * s.distance / length)) end
end
local courses = { -- each row: name, k, its integral over 1320 mm [mm3/N], other fields
  { "k tenfold in 5 of every 100 cycles", function(s) return s.cycle % 100 < 5 and 1e-7 or 1e-8 end,
    1320 * 1.45e-8 },
  { "k tenfold in 5 of every 100 cycles, fixed jumps of 150",
    function(s) return s.cycle % 100 < 5 and 1e-7 or 1e-8 end, 1320 * 1.45e-8,
    { jump = 150, model = { mesh = { size = 0.04, height = 0.05 } } } },
  { "k fivefold in 20 of every 200 cycles", function(s) return s.cycle % 200 < 20 and 5e-8 or 1e-8 end,
    1320 * 1.4e-8 },
  { "k tenfold in 6 of every 60 mm", function(s) return s.distance % 60 < 6 and 1e-7 or 1e-8 end,
    1320 * 1.9e-8 },
  { "k with waves of 10 mm", wave(10), 1.32e-5 },
  { "k with waves of 22 mm", wave(22), 1.32e-5 },
  { "k a hundredfold for 1 mm", function(s) return math.abs(s.distance - 700.5) < 0.5 and 1e-6 or 1e-8 end,
    1.419e-5 },
  { "k in 3 of every 132 mm, implicit", function(s) return s.distance % 132 < 3 and 1e-7 or 0 end, 3e-6,
    { scheme = "implicit", tolerance = 1e-3 } },
}
for _, course in ipairs(courses) do
  local name, k, integral, more = table.unpack(course)
  local fields = merged({ k = k }, more or { scheme = "explicit" })
  within(run(fields).volume.total, 100 * integral, 1e-4, name .. ": volume [mm3]")
end

-- --- k and alpha by results ----------------------------------------------------------------------------

-- The references are results of small explicit steps, extrapolated to step length zero. The error of these steps is
-- of first order in these cases.
local measured = { -- each row: name, fields, compared result, tolerances of auto and implicit
  { "k as a function of the pressure", { k = function(s) return 1e-8 * (s.p_center / 500) ^ 2 end },
    function(w) return w.volume.total end, 4e-3, 5e-4 },
  { "alpha as a function of the pressure", { alpha = function(s) return math.min(1, s.p_center / 600) end },
    function(w) return w.volume.cylinder end, 4e-3, 5e-4 },
  { "k as a function of the width", { k = function(s) return 1e-8 * (s.half_width / 0.1) ^ 2 end,
    distance = 330 },
    function(w) return w.volume.total end, 1.5e-2, 8e-3 },
}
for _, case in ipairs(measured) do
  local name, fields, quantity, of_auto, of_implicit = table.unpack(case)
  fields.distance = fields.distance or 660
  local fine = quantity(run(merged(fields, { jump = 1 })))
  local coarse = quantity(run(merged(fields, { jump = 2 })))
  local expected = 2 * fine - coarse
  within(quantity(run(merged(fields, { scheme = "explicit" }))), expected, of_auto, name .. ", auto: volume [mm3]")
  within(quantity(run(merged(fields, { scheme = "implicit", tolerance = 1e-3 }))), expected, of_implicit,
    name .. ", implicit: volume [mm3]")
end

-- The width in the last of these cases changes from node to node. Compares its default mesh with elements of a quarter of the size.
do
  local fields, V = merged(measured[3][2], { scheme = "implicit", tolerance = 1e-3 }), {}
  for i, fineness in ipairs{ 1, 4 } do V[i] = run(merged(fields, { model = { mesh = { fineness = fineness } } })).volume.total end
  within(V[1], V[2], 0.025, "k as a function of the width, default mesh: volume [mm3]")
end

-- Tests a k that drops to a tenth when the pressure has decreased to a limit. The exact distance of the drop
-- is computed by a run with the first k.
local there = wear{ k = 2e-8, jump = 1 }:run{ p_center = 350, progress = false }.distance
local jumping = run{ k = function(s) return s.p_center > 350 and 2e-8 or 2e-9 end, distance = 660,
  scheme = "implicit", tolerance = 1e-3 }
within(jumping.volume.total, 100 * (2e-8 * there + 2e-9 * (660 - there)), 3e-3,
  "k with a step at a given pressure: volume [mm3]")

-- Tests implicit steps of fixed length, about a twentieth of the run, against steps an eighth as long.
local steps = {}
for i, jump in ipairs{ 150, 18.75 } do
  steps[i] = run{ k = measured[1][2].k, distance = 660, scheme = "implicit", jump = jump }.volume.total
end
below(math.abs(steps[1] / steps[2] - 1), 1e-3,
  "k as a function of the pressure, implicit: difference of volumes by long and short steps")

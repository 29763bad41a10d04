-- Tests that inputs changed by their last bits give the same results up to rounding errors: the steps, meshes
-- and iterations of a run must not depend on the last bit of a number. Round numbers are the critical ones.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local below = figures.below
local with = require "archard.lib.merged"

local soft = { thickness = 0.05, E = 3000, nu = 0.35 }
local runs = {
  { "reference pair", { distance = 440 } },
  { "explicit steps", { scheme = "explicit", distance = 440 } },
  { "fixed jump", { jump = 50, distance = 440 } },
  { "first order", { order = 1, distance = 440 } },
  { "frozen geometry", { geometry = "frozen", distance = 440 } },
  { "a stroke of 19 half widths", { stroke = 2, distance = 2000 } },
  { "alpha = 1", { alpha = 1, k = 1e-7, distance = 100 } },
  { "slide = z", { slide = "z", distance = 440 } },
  { "power law", { law = "power", law_exponent = 1.5, distance = 220 } },
  { "threshold law", { law = "threshold", law_pressure = 250, distance = 220 } },
  { "two blocks", { loading = { { load = 100, x = { 0, 0.1, 0, -0.1, 0 }, cycles = 500 }, { load = 200, x = { 0, 0.05, 0 }, cycles = 500 } } } },
  { "a soft layer", { load = 50, distance = 220, model = { lower = body.block{ layers = { soft } } } } },
  { "a ball on a track", { load = 50, distance = 300, track = 20, slide = "z", model = { geometry = "axisymmetric" } } },
  { "partial slip", { friction = 0.6, tangential = 30, k = 1e-7, cycles = 3000 } },
  { "gross slip", { friction = 0.3, stroke = 0.01, k = 1e-7, cycles = 3000 } },
  { "partial slip of unlike bodies", { friction = 0.3, stroke = 0.004, k = 1e-7, cycles = 3000, model = { plate = { E = 70e3, nu = 0.33 } } } },
  { "a ball in 3-D", { load = 10, stroke = 0.04, k = 1e-7, distance = 100, model = { geometry = "3-D", upper = body.ball{ radius = 10 },
    lower = body.block{} } } },
  { "partial slip in 3-D", { load = 10, friction = 0.5, tangential = 3, k = 1e-7, cycles = 1000, model = { geometry = "3-D",
    upper = body.ball{ radius = 10 }, lower = body.block{} } } },
}

-- Each function returns the definition with one input multiplied by `by`, or nil if the run has no such input.
local inputs = {
  load = function(d, by) return not d.loading and with(d, { load = (d.load or 100) * by }) end,
  k = function(d, by) return with(d, { k = (d.k or 1e-8) * by }) end,
  stroke = function(d, by) return d.stroke and with(d, { stroke = d.stroke * by }) end,
  friction = function(d, by) return d.friction and with(d, { friction = d.friction * by }) end,
  force = function(d, by) return d.tangential and with(d, { tangential = d.tangential * by }) end,
  E = function(d, by)
    local m = with(d.model, {})
    if m.upper then
      m.upper = body.ball{ radius = 10, E = 200e3 * by }
    elseif m.lower then
      return nil
    else
      m.plate = with(m.plate or { nu = 0.3 }, { E = (m.plate and m.plate.E or 200e3) * by })
    end
    return with(d, { model = m })
  end,
  radius = function(d, by)
    local m = with(d.model, {})
    if m.upper then m.upper = body.ball{ radius = 10 * by } else m.radius = not m.lower and 10 * by or nil end
    return with(d, { model = m })
  end,
}

local function results(definition)
  local w = wear(definition):run{ progress = false }
  local h, last = w.history, #w.history.distance
  return { updates = w.update, V = w.volume.total, depth = h.depth_cylinder[last], other = h.depth_plate[last], p_center = w.p_center }
end

for _, run in ipairs(runs) do
  local name, definition = table.unpack(run)
  local before, most, which = results(definition), 0, "no input"
  for input, change in pairs(inputs) do
    for _, bits in ipairs{ 1e-15, -2e-15 } do
      local changed = change(definition, 1 + bits)
      for result, value in pairs(changed and results(changed) or {}) do
        local off = before[result] == value and 0 or math.abs(value / before[result] - 1)
        if off > most then most, which = off, ("%s by %s"):format(result, input) end
      end
    end
  end
  below(most, 1e-9, ("%s: largest relative change by last bits (%s)"):format(name, which))
end

-- Tests the continuity of friction in three dimensions: results vary smoothly over sweeps of the input. The
-- stick zone of a contact consists of whole cells, and a run chooses its cells so that the stick zone has the
-- right area. Results therefore have steps smaller than the discretization error.

-- Long
local sweeps = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/sweep.lua")
local sweep, sweep_cells, sweep_runs = sweeps(5e-3, 1e-6), sweeps(2.5e-2, 1e-6), sweeps(2.5e-2, 1e-6, 12)

local function steel(radius)
  return { geometry = "3-D", upper = body.ball{ radius = radius or 10 }, lower = body.block{} }
end

local function moved(definition)
  return function(x)
    local d = { load = 10, friction = 0.5, tangential = 3 }
    for name, value in pairs(definition(x)) do d[name] = value end
    local c = contact{ model = d.model or steel(), load = d.load, friction = d.friction }:move{ tangential = d.tangential }
    return { energy = c.energy, stick = c.stick, x = c.x }
  end
end

local function worn(definition)
  return function(x)
    local d = { model = steel(), load = 10, friction = 0.5, tangential = 3, k = 1e-6, cycles = 1000 }
    for name, value in pairs(definition(x)) do d[name] = value end
    if d.stroke then d.tangential = nil end
    local w = wear(d):run{ progress = false }
    return { V = w.volume.total, depth = w.depth.upper, energy = w.energy }
  end
end

local force = moved(function(x) return { tangential = x } end)
sweep("the tangential force", 1.5, 4.5, { "energy", "x" }, force)
sweep_cells("the tangential force", 1.5, 4.5, { "stick" }, force)
sweep("the load of a contact", 9, 11, { "energy", "x" }, moved(function(x) return { load = x } end))
sweep("friction", 0.4, 0.8, { "energy", "x" }, moved(function(x) return { friction = x } end))
sweep("the radius", 8, 12, { "energy", "stick", "x" }, moved(function(x) return { model = steel(x) } end))
sweep_runs("the force of a run", 2.2, 4.6, { "V", "depth", "energy" }, worn(function(x) return { tangential = x } end))
sweep_runs("the load of a run", 9, 11, { "V", "depth", "energy" }, worn(function(x) return { load = x } end))
sweep_runs("the stroke of a run", 4e-4, 2e-3, { "V", "depth", "energy" }, worn(function(x) return { stroke = x } end))

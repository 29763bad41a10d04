-- Runs trials of fit with known true values: simulates a run, adds noise to its results, fits them, and
-- checks whether the true values are in the ranges of the fit. Returns the function trial(seed, kind), which
-- returns { name = inside } and the seconds, and the list of the kinds: "pair" (k and alpha from one pair of
-- profiles and the volumes), "curve" (alpha at three knots from four pairs), "width" (k from the contact's
-- widths, which change in steps from node to node), "fine" and "fine width" (k and alpha from profiles, or k
-- from half widths, of a run on a mesh four times as fine, with so little noise that the error due to the mesh
-- of the fit counts).

local spline = require "archard.fit.spline"

local noise, share = 5e-5, 0.03 -- noise of profiles [mm]; relative error of volumes

local function normal()
  return math.sqrt(-2 * math.log(1 - math.random())) * math.cos(2 * math.pi * math.random())
end

-- Seeds the generator with widely different numbers, because consecutive small seeds give similar first
-- numbers.
local function seed_well(seed)
  math.randomseed(7919 * seed + 13, 104729 * seed)
  for _ = 1, 200 do math.random() end
end

local function base()
  return { jump = 50, stroke = 0.22, model = { mesh = { size = 0.04, height = 0.05 } } }
end

-- Returns profiles that resemble measured ones: points between the nodes, shifted in x and h, tilted, noisy.
local function measured(run, body)
  local shift, tilt, level = 0.004 * normal(), 1e-4 * normal(), 2e-4 * normal()
  local surface, x, h = run:profile(body), {}, {}
  for i = 1, #surface.x - 1 do
    local middle = (surface.x[i] + surface.x[i + 1]) / 2
    x[i] = middle + shift
    h[i] = (surface.h[i] + surface.h[i + 1]) / 2 + tilt * x[i] + level + noise * normal()
  end
  return { body = body, distance = run.distance, x = x, h = h, error = noise }
end

local function add_pair(data, run)
  for _, body in ipairs{ "cylinder", "plate" } do data[#data + 1] = measured(run, body) end
end

local function add_volumes(data, run)
  for _, body in ipairs{ "cylinder", "plate" } do
    data[#data + 1] = { of = "volume_" .. body, distance = run.distance, relative = share,
      value = run.volume[body] * (1 + share * normal()) }
  end
end

local kinds = {}

function kinds.pair()
  local given, data = base(), {}
  given.k, given.alpha = 1.3e-8, 0.35
  local run <close> = wear(given)
  run:run()
  add_pair(data, run)
  add_volumes(data, run)
  return data, { k = 1e-8, alpha = 0.5 }, { k = 1.3e-8, alpha = 0.35 }
end

function kinds.curve()
  local given, data, knots, value = base(), {}, { 0, 300, 1320 }, { 0.7, 0.45, 0.35 }
  given.k, given.alpha = 1.3e-8, spline.series(knots, value)
  local run <close> = wear(given)
  for _, distance in ipairs{ 150, 300, 700, 1320 } do
    run:run{ distance = distance }
    add_pair(data, run)
  end
  local truth = { k = 1.3e-8 }
  for i, distance in ipairs(knots) do truth[("alpha at %g mm"):format(distance)] = value[i] end
  return data, { k = 1e-8, alpha = { start = 0.5, knots = knots } }, truth
end

function kinds.width()
  local given, distance, value = base(), {}, {}
  given.k, given.distance, given.model = 1.3e-8, 660, nil
  local run <close> = wear(given)
  for i = 1, 6 do
    distance[i] = 110 * i
    run:run{ distance = distance[i] }
    value[i] = 2 * run.history.half_width[#run.history.half_width] * (1 + 0.01 * normal())
  end
  return { { of = "width", distance = distance, value = value, relative = 0.01 } }, { k = 1e-8 }, { k = 1.3e-8 },
    { jump = 50, stroke = 0.22 }
end

-- Returns results of a run on a fine mesh: distances, half widths and the last profiles.
local fine
local function on_fine_mesh()
  if fine then return fine end
  local run <close> = wear{ k = 1.3e-8, alpha = 0.35, stroke = 0.22, distance = 660, tolerance = 1e-4,
    model = { mesh = { fineness = 4 } } }
  fine = { distance = {}, half_width = {}, surface = {} }
  for i = 1, 6 do
    run:run{ distance = 110 * i, progress = false }
    fine.distance[i], fine.half_width[i] = run.distance, run.half_width
  end
  for _, body in ipairs{ "cylinder", "plate" } do fine.surface[body] = run:profile(body) end
  return fine
end

local nanometres, tenths = 3e-6, 5e-4 -- noise of profiles and of half widths [mm]

kinds["fine"] = function()
  local data = {}
  for _, body in ipairs{ "cylinder", "plate" } do
    local surface, x, h = on_fine_mesh().surface[body], {}, {}
    for i = 1, #surface.x, 4 do
      x[#x + 1], h[#h + 1] = surface.x[i], surface.h[i] + nanometres * normal()
    end
    data[#data + 1] = { body = body, distance = 660, x = x, h = h, error = nanometres, shift = 0, tilt = 0,
      level = 0 }
  end
  return data, { k = 1e-8, alpha = 0.5 }, { k = 1.3e-8, alpha = 0.35 }, { stroke = 0.22 }
end

kinds["fine width"] = function()
  local value = {}
  for i, width in ipairs(on_fine_mesh().half_width) do value[i] = width + tenths * normal() end
  return { { of = "half_width", distance = on_fine_mesh().distance, value = value, error = tenths } },
    { k = 1e-8 }, { k = 1.3e-8 }, { stroke = 0.22, alpha = 0.35 }
end

local function trial(seed, kind)
  seed_well(seed)
  local data, unknown, truth, given = kinds[kind]()
  local start = os.clock()
  local f = fit{ base = given or base(), unknown = unknown, data = data }
  local seconds, inside = os.clock() - start, {}
  for i, name in ipairs(f.names) do
    inside[name] = math.abs(f.values[i] - truth[name]) <= f.margins[i]
  end
  f.wear:close()
  return inside, seconds
end

return trial, { "pair", "curve", "width", "fine", "fine width" }

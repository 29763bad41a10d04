-- Tests bodies from height maps in three dimensions: as upper and lower body, with and without a ball's
-- radius; edges of maps; invalid maps.
local tap = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/tap.lua")
local is, ok, near, fails = tap.is, tap.ok, tap.near, tap.fails

local function even(from, to, count)
  local list = {}
  for i = 1, count do list[i] = from + (to - from) * (i - 1) / (count - 1) end
  return list
end
local x, z = even(-0.5, 0.5, 51), even(-0.6, 0.6, 61)
local cap = map{ x = x, z = z, y = function(u, v) return -(u * u + v * v) / 20 end }
local flat = map{ x = x, z = z, y = function() return 0 end }
local function pair(upper, lower) return model{ geometry = "3-D", upper = upper, lower = lower } end

-- --- one contact, defined by bodies and maps in five forms -----------------------------------------
local ball, block = body.ball{ radius = 10 }, body.block{}
local c = contact{ model = pair(ball, block), load = 10 }
for what, m in pairs{
  ["a cap above"] = pair(body.map{ y = cap }, block), ["a cap below"] = pair(block, body.map(cap)),
  ["a flat map under a ball"] = pair(ball, body.map{ x = x, z = z, y = flat.y }), ["a flat map on a ball"] = pair(body.map{ y = flat, radius = 10 }, block),
} do
  local d = contact{ model = m, load = 10 }
  near(d.p_max, c.p_max, 1e-9, what .. ": pressure")
  near(d.approach, c.approach, 1e-9, what .. ": approach")
end

-- --- roughness, worn -------------------------------------------------------------------------------
local function waves(u, v) return 2e-4 * math.cos(2 * math.pi * u / 0.05) * math.cos(2 * math.pi * v / 0.05) end
local rough = map{ x = even(-0.4, 0.4, 161), z = even(-0.4, 0.4, 161), y = waves }
local m = pair(body.map{ y = rough, radius = 10, E = 210e3 }, block)
local smooth = contact{ model = pair(body.ball{ radius = 10, E = 210e3 }, block), load = 10 }
local spots = contact{ model = m, load = 10 }
ok(spots.p_max > 1.3 * smooth.p_max and spots.area < 0.9 * smooth.area,
  "waves on a ball increase the pressure and reduce the area")
near(spots:pressure():volume().net, 10, 1e-3, "the pressures of separate spots balance the load")
local w = wear{ model = m, load = 10, stroke = 0.04, alpha = 0.5, distance = 40 }
w:run{ distance = 20 }
local file = os.tmpname()
os.remove(file)
w:save(file)
local opened = wear.open(file)
os.remove(file)
w:run()
opened:run()
is(opened.depth.block, w.depth.block, "a run on a map continues from its file with identical bits")
near(w.volume.total, 1e-8 * 10 * 40, 1e-9, "the volume of a run on a map is k L d")
is(#opened.model.upper.y, 161 * 161, "the run file contains the map")
ok(w.p_max < 0.95 * w.history.p_max[1], "wear reduces the pressure on waves")
local below = wear{ model = pair(ball, body.map{ y = rough }), load = 10, stroke = 0.04, alpha = 0, distance = 10 }
below:run()
near(below.volume.lower, 1e-8 * 10 * 10, 1e-9, "volume of a rough lower flat that moves")

local function loop(pair)
  local d = contact{ model = pair, load = 10, friction = 0.5 }:move{ tangential = 3 }
  return d.x, d.energy
end
near(loop(pair(body.map{ y = cap }, block)), loop(model{ geometry = "3-D" }), 1e-4,
  "displacement under friction on a map")

-- --- periodic surfaces --------------------------------------------------------------------------------
local points = even(0, 0.1 * 31 / 32, 32)
local waved = map{ x = points, z = points, y = function(u, v) return 1e-4 * math.cos(20 * math.pi * u) * math.cos(20 * math.pi * v) end }
local function repeated(upper, lower) return model{ geometry = "3-D", periodic = true, upper = upper, lower = lower } end
local endless = repeated(body.map{ y = waved }, block)
is(endless.periodic, true, "a periodic model")
is(model{}.periodic, false, "models are not periodic by default")
local full = math.sqrt(2) * math.pi * 200e3 / 0.91 / 2 * 1e-3
near(contact{ model = endless, load = 1.5 * full * 0.01 }.p_max, 2.5 * full, 1e-3,
  "full contact: the largest pressure is the mean plus a wave")
local partial = contact{ model = endless, load = 0.2 * full * 0.01 }
ok(math.abs(partial.area / 0.01 - 0.341) < 0.02, "partial contact: area of an independent program")
near(partial:pressure():volume().net * (32 / 31) ^ 2, 0.2 * full * 0.01, 0.2,
  "partial contact: the pressures balance the load")
near(contact{ model = repeated(body.map{ y = waved }, body.map{ y = waved }), load = 0.4 * full * 0.01 }.area,
  partial.area, 1e-9,
  "equal waves on both bodies with twice the pressure: same area")
local function worn_waves() return wear{ model = endless, load = 5, stroke = 0.05, alpha = 1, distance = 4 } end
local evened = worn_waves()
evened:run{ distance = 2 }
evened:save(file)
local rest = wear.open(file)
os.remove(file)
evened:run()
rest:run()
is(rest.depth.upper, evened.depth.upper,
  "a run on periodic waves continues from its file with identical bits")
near(evened.volume.total, 1e-8 * 5 * 4, 1e-9, "the volume of a run on periodic waves is k L d")
ok(evened.p_max < evened.history.p_max[1], "wear reduces the pressure on the crests")
local worn = wear{ model = endless, worn = { upper = evened:map "upper" }, load = 5, stroke = 0.05, alpha = 1, distance = 4 }
near(worn.p_max, evened.p_max, 1e-6, "worn waves as the start of another run")
local function grooved(y, changes)
  local pair = repeated(body.map{ y = map{ x = points, z = points, y = y } }, block)
  local all = { model = pair, load = 5, stroke = 1, alpha = 0.5, distance = 4 }
  for name, value in pairs(changes or {}) do all[name] = value end
  local run = wear(all)
  run:run()
  return run
end
local function ridges(_, v) return 1e-4 * math.cos(20 * math.pi * v) end
local both, one = grooved(ridges), grooved(ridges, { alpha = 1 })
near(both.depth.upper + both.depth.lower, one.depth.upper, 1e-3,
  "ridges along the motion: the sum of depths does not depend on alpha")
near(both.depth.upper, both.depth.lower, 1e-6, "ridges along the motion: both bodies have the same depth")
near(both.volume.lower, 0.5 * 1e-8 * 5 * 4, 1e-9, "volume of the lower body in a period")
local even_wear = grooved(function(u) return 1e-4 * math.cos(20 * math.pi * u) end, { alpha = 0 })
near(even_wear.depth.lower, 1e-8 * 5 / 0.01 * 4, 1e-9, "ridges across the motion wear the plate uniformly")
near(even_wear.p_max, even_wear.history.p_max[1], 1e-6, "uniform wear does not change the pressure of ridges")
for what, wrong in pairs{
  ["'track'"] = function() wear{ model = endless, load = 5, alpha = 1, track = 5 } end,
  ["at least 2 periods, 0.2 mm, got 0.11 mm; or alpha = 1"] = function() wear{ model = endless, load = 5, alpha = 0.5 } end,
  ["'procedure'"] = function() wear{ model = endless, load = 5, alpha = 1, procedure = "SP" } end,
  ["'lower'"] = function() wear{ model = repeated(body.map{ y = waved }, body.map{ y = waved }), load = 5, alpha = 1 } end,
  ["'x'"] = function() contact{ model = endless, load = 5, x = 0.1 } end,
  ["'friction'"] = function() contact{ model = endless, load = 5, friction = 0.1 } end,
  ["'upper.radius'"] = function() repeated(body.map{ y = waved, radius = 5 }, block) end,
  ["'upper'"] = function() repeated(ball, block) end,
  ["mesh.size"] = function() model{ geometry = "3-D", periodic = true, upper = body.map{ y = waved }, lower = block, mesh = { size = 0.01 } } end,
  ["even number of points"] = function() repeated(body.map{ y = cap }, block) end,
  ["one period on both bodies"] = function()
    local double = even(0, 0.2 * 31 / 32, 32)
    repeated(body.map{ y = waved }, body.map{ y = map{ x = double, z = points, y = function() return 0 end } })
  end,
  ["false or true, got 1"] = function() model{ geometry = "3-D", periodic = 1 } end,
  ["3-D"] = function() model{ periodic = true } end,
} do
  fails(wrong, what, "refused for periodic surfaces: " .. what)
end

-- --- edges of maps, and invalid bodies ---------------------------------------------------------------
fails(function() contact{ model = pair(body.map(cap), block), load = 3000 } end,
  "reaches the end of the part of a map",
  "a contact that reaches the end of the map")
fails(function() pair(body.map(flat), block) end,
  "expected surfaces between which the gap grows on all sides",
  "two flat surfaces")
local cup = map{ x = x, z = z, y = function(u, v) return (u * u + v * v) / 20.4 end }
fails(function() pair(ball, body.map(cup)) end, "joint{}", "a ball in a socket")
fails(function() model{ upper = body.map(cap) } end, "a map needs geometry = \"3-D\"",
  "a map in a plane model")
fails(function() body.map{ x = { 0, 1, 2, 3, 5 }, z = z, y = function() return 0 end } end, "even steps",
  "a map with uneven steps")
fails(function() body.map{ x = { 0, 1, 2 }, z = { 0, 1, 2 }, y = function() return 0 end } end,
  "at least 4 points",
  "a map with three points")
fails(function() body.map{ x = x, z = z, y = 3 } end, "field 'y'", "a map with a single height")
fails(function() body.map{ y = cap, width = 3 } end, "unknown field 'width' of a map", "a map with a width")
fails(function() body.map{ y = map{ x = x, z = z, y = cap.y, unit = "MPa" } } end, "a map of heights in mm",
  "a map of pressures as heights")

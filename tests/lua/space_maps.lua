-- Tests of bodies from height maps in three dimensions: as upper and lower body, with and without a ball's radius;
-- edges of maps; invalid maps.
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

-- --- the same contact in five forms ----------------------------------------------------------------
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
ok(spots.p_max > 1.3 * smooth.p_max and spots.area < 0.9 * smooth.area, "waves on a ball: higher pressures on less area")
near(spots:pressure():volume().net, 10, 1e-3, "separate spots carry the load")
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
near(w.volume.total, 1e-8 * 10 * 40, 1e-9, "its volume is k L d")
is(#opened.model.upper.y, 161 * 161, "the map is in the file")
ok(w.p_max < 0.95 * w.history.p_max[1], "waves wear off")
local below = wear{ model = pair(ball, body.map{ y = rough }), load = 10, stroke = 0.04, alpha = 0, distance = 10 }
below:run()
near(below.volume.lower, 1e-8 * 10 * 10, 1e-9, "a rough flat below, which moves")

-- --- edges of maps, and invalid bodies ---------------------------------------------------------------
fails(function() contact{ model = pair(body.map(cap), block), load = 3000 } end, "reaches the end of the part of a map", "a contact beyond the map")
fails(function() pair(body.map(flat), block) end, "expected surfaces between which the gap grows on all sides", "two flats")
local cup = map{ x = x, z = z, y = function(u, v) return (u * u + v * v) / 20.4 end }
fails(function() pair(ball, body.map(cup)) end, "joint{}", "a ball in its socket")
fails(function() model{ upper = body.map(cap) } end, "a map needs geometry = \"3-D\"", "a map in the plane")
fails(function() body.map{ x = { 0, 1, 2, 3, 5 }, z = z, y = function() return 0 end } end, "even steps", "uneven steps")
fails(function() body.map{ x = { 0, 1, 2 }, z = { 0, 1, 2 }, y = function() return 0 end } end, "at least 4 points", "three points")
fails(function() body.map{ x = x, z = z, y = 3 } end, "field 'y'", "a number")
fails(function() body.map{ y = cap, width = 3 } end, "unknown field 'width' of a map", "a width")
fails(function() body.map{ y = map{ x = x, z = z, y = cap.y, unit = "MPa" } } end, "a map of heights in mm", "pressures as heights")

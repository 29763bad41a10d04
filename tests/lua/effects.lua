-- Tests that each setting has an effect in each kind of pair that accepts it: a run with another value must
-- differ in a result, or the kind must refuse the setting. A new row of settings fails this test until every
-- kind uses it or refuses it, or until it is among the exceptions below, with a reason.
-- Ordinary collector settings: hundreds of runs would need minutes with continuous garbage collection.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok = tap.ok
local known = require "archard.settings"
local lib = dofile(here .. "/lib/rows.lua")
local merged, others = lib.merged, lib.others
warn "@off"

-- Small runs of each kind of pair.
local kinds = {
  plane = { mesh = { size = 0.1, height = 0.1, far = 2, zone = { cylinder = 2.4, plate = 3 } } },
  ["3-D"] = { geometry = "3-D", mesh = { size = 0.05 } },
  springs = { geometry = "springs", mesh = { size = 0.05, zone = { cylinder = 2.4, plate = 3 } } },
}
local start = { load = 50, stroke = 0.4, alpha = 0.4, k = 5e-7, distance = 8, jump = 1, increments = 8 }

-- Settings without an effect in all kinds or in one of them, with the reason.
local no_effect = { ["wear.workers"] = "threads give identical bits" }
for _, name in ipairs{ "geometry", "refresh", "corrections" } do
  no_effect["wear." .. name .. " in 3-D"] = "wear does not change the stiffness of half-spaces"
  no_effect["wear." .. name .. " in springs"] = "wear does not change the stiffness of springs"
end
for _, name in ipairs{ "increments", "rule", "slide", "procedure" } do
  no_effect["wear." .. name .. " in springs"] = "one contact represents the whole stroke"
end
no_effect["wear.load_angle in springs"] = "they have no angle"
no_effect["model.axis in springs"] = "they have no axis"
for _, name in ipairs{ "height", "far", "rows", "element" } do
  no_effect["model.mesh." .. name .. " in springs"] = "they have no elements"
end

-- Returns all results of a run as numbers: the last row of history and the final surfaces.
local function results(w)
  local list = {}
  for _, column in ipairs(known.columns) do
    local found, values = pcall(function() return w.history[column.name] end)
    if found then list[#list + 1] = values[#values] end
  end
  for _, side in ipairs{ "upper", "lower" } do
    for _, h in ipairs(w:profile(side).h) do list[#list + 1] = h end
  end
  return list
end

local function differ(a, b)
  if #a ~= #b then return true end
  for i = 1, #a do if a[i] ~= b[i] and (a[i] == a[i] or b[i] == b[i]) then return true end end
  return false
end

local function run(fields)
  local w <close> = wear(fields)
  w:run{ distance = math.min(w.total_distance, start.distance), progress = false }
  return results(w)
end

local values = { refresh = { 0 }, tangential = { 10 } } -- values that have an effect where the usual other ones have none

-- Returns true if a kind of pair accepts a value of a row other than its default, and true if the results with
-- two values differ. define(value) returns the definition of a run with a value; nil is the default. A flag that
-- makes a definition valid has an effect, too.
local function check(row, define)
  local accepted, reference = false, select(2, pcall(run, define(nil)))
  local flag = type(reference) ~= "table" and row.type == "false or true"
  for _, value in ipairs(values[row.path] or others(row)) do
    local made, results_with = pcall(run, define(value))
    accepted = accepted or made
    if made and (flag or type(reference) == "table" and differ(results_with, reference)) then return true, true end
    if made and type(reference) ~= "table" then reference = results_with end
  end
  return accepted, false
end

-- Checks one row in each kind of pair.
local function in_every_kind(name, row, define)
  local uses = 0
  for kind, bodies in pairs(kinds) do
    local accepted, used = check(row, function(value) return define(merged(bodies), value, kind) end)
    if used then uses = uses + 1 end
    local where = ("%s in %s"):format(name, kind)
    if no_effect[name] or no_effect[where] then
      ok(accepted and not used, where .. " has no effect")
    else
      ok(used or not accepted, where .. " has an effect or is refused")
    end
  end
  ok(uses > 0 or no_effect[name] ~= nil, name .. " has an effect in some kind of pair")
end

local grid = {}
for i = 1, 8 do grid[i] = 0.1 * i end
local waved = map{ x = grid, z = grid, y = function(x, z) return 1e-3 * math.cos(x) * math.cos(z) end }
local turning = { plane = { geometry = "axisymmetric" } }
local beside = { -- each row: a setting, and the other fields of a run in which it has an effect; false: without it
  press = { friction = 0.3, stroke = 0.002, cycles = 4, distance = false },
  tangential = { friction = 0.3, stroke = false, cycles = 4, distance = false }, order = { scheme = "implicit", jump = false },
  tolerance = { scheme = "implicit", jump = false }, procedure = { alpha = 1 }, law_pressure = { law = "power", law_exponent = 0.5 },
  law_exponent = { law = "power" }, spin = { slide = "z", alpha = 1 },
  track = { slide = "z", alpha = 1, stroke = false }, periodic = { alpha = 1 }, axis = { slide = "z", alpha = 1 },
}
local bodies_beside = { -- the same for fields of the model, by kind of pair
  press = { plane = { lower = body.block{ E = 1e5 } }, ["3-D"] = { lower = body.block{ E = 1e5 } } },
  load_angle = { plane = { lower = body.ring{ inner = 10.2, outer = 14 }, mesh = { size = 0.1, height = 0.1, far = 2 } } },
  spin = turning, track = turning, axis = turning,
  periodic = { ["3-D"] = { upper = body.map{ y = waved }, lower = body.block{}, mesh = false } },
}

-- Returns a copy of a definition without its fields that are false.
local function without(fields)
  for name, value in pairs(fields) do if value == false then fields[name] = nil end end
  return fields
end

local function bodies_of(name, bodies, kind) return without(merged(bodies, (bodies_beside[name] or {})[kind] or {})) end

for _, row in ipairs(known.wear) do
  local name = row.path
  if row.plain then
    in_every_kind("wear." .. name, row, function(bodies, value, kind)
      return without(merged(start, { model = bodies_of(name, bodies, kind) }, beside[name] or {}, { [name] = value }))
    end)
  end
end

for _, row in ipairs(known.material) do
  local name = row.name
  if name ~= "name" then
    in_every_kind("material." .. name, row, function(bodies, value)
      local with = name == "k" and { k = value or 1e-7 } or { k = 1e-7, [name] = value }
      local pair = merged(bodies, { upper = body.cylinder{ k = 1e-7 }, lower = body.block(with) })
      if bodies.geometry == "3-D" then pair.upper = body.ball{ radius = 10, k = 1e-7 } end
      return without(merged(start, { model = pair, k = false, alpha = false }))
    end)
  end
end

for _, row in ipairs(known.body) do
  local name = row.path:match "^layer1%.(.*)"
  if name and not row.group and name ~= "name" then
    in_every_kind("layer." .. name, row, function(bodies, value)
      local layer = merged({ thickness = 0.4, E = 1e5 }, { [name] = value })
      return merged(start, { model = merged(bodies, { lower = body.block{ layers = { layer } } }) })
    end)
  end
end

for _, row in ipairs(known.model) do
  local group, name = row.path:match "^(.*)%.([^.]+)$"
  if not row.group and row.plain and not (group or ""):find "zone" then
    in_every_kind("model." .. row.path, row, function(bodies, value, kind)
      local with = bodies_of(row.path, bodies, kind)
      if row.path == "axis" then value = value and 40 * value end
      if row.path == "mesh.fineness" then
        with.mesh = { fineness = value }
      elseif group == "mesh" then
        with.mesh = merged(with.mesh, { [name] = value and name == "size" and value / 20 or value })
      else
        with[row.path] = value
      end
      return merged(start, { model = with }, beside[row.path] or {})
    end)
  end
end

-- Tests that each column of the history is computed: after the start of one of these runs it is neither 0 nor NaN.
local varied = {
  merged(start, { model = kinds.plane, scheme = "implicit", jump = "auto" }), merged(start, { model = kinds["3-D"] }),
  { model = kinds.plane, friction = 0.3, tangential = 10, cycles = 30, jump = 10, k = 1e-6, increments = 8 },
  { model = kinds.plane, friction = 0.1, stroke = 0.4, cycles = 3, jump = 1, increments = 8 },
}
local computed = {}
for _, fields in ipairs(varied) do
  local made <close> = wear(fields)
  made:run{ progress = false }
  for _, column in ipairs(known.columns) do
    local found, list = pcall(function() return made.history[column.name] end)
    for i = 2, found and #list or 0 do
      if list[i] ~= 0 and list[i] == list[i] then computed[column.name] = true end
    end
  end
end
for _, column in ipairs(known.columns) do ok(computed[column.name], column.name .. " is computed in some run") end

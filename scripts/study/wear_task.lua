-- A wear run of a study: its surfaces are looked at on the way, and it is kept in the run file now and
-- then, from which it goes on after its process was killed. Leans on wear and archard.store.

local term = require "archard.term"
local transaction = require "archard.study.transaction"

-- Which updates to look at: `count` on the way, the unworn surfaces among them, at the first update not
-- before each share of the distance. The last look is the store's.
local function looker(count, total)
  local next_look = 0
  return function(distance)
    if total <= 0 or next_look >= count or distance < next_look / count * total then return false end
    next_look = math.floor(distance / total * count) + 1
    return true
  end
end

local function look(run, list)
  for i, body in ipairs { "cylinder", "plate" } do
    local role = i == 1 and "upper" or "lower"
    local profile, pressure = run:profile(role), run:pressure(role)
    list[#list + 1] = { body = body, update = run.update, distance = run.distance,
      x = profile.x, h = profile.h, y = profile.y, p = pressure.p }
  end
end

-- What had been looked at when the run was kept: its present surfaces were kept with it.
local function looked_at(run, surfaces, is_due)
  local due, list, history = {}, {}, run.history
  for i, distance in ipairs(history.distance) do
    if is_due(distance) then due[history.update[i]] = true end
  end
  for _, surface in ipairs(surfaces) do
    if due[surface.update] then list[#list + 1] = surface end
  end
  return list
end

-- The run as it was kept, nil where there is none.
local function kept(store, id)
  local fine, run = pcall(store.wear, store, id)
  if fine and run.update > 0 and not run.done then return run, store:surfaces(id) end
end

-- (store, id, given = fields of wear{}, looks = how many, every = seconds after which it is kept,
-- on_progress) -> the run at its end, what was looked at
return function(store, id, given, looks, every, on_progress)
  local run, surfaces = kept(store, id)
  run = run or wear(given)
  local total, last = run.total_distance, term.clock()
  local is_due = looker(looks, total)
  local list = surfaces and looked_at(run, surfaces, is_due) or {}
  if not surfaces and is_due(run.distance) then look(run, list) end
  run:run{ progress = function()
    if not run.done and is_due(run.distance) then look(run, list) end
    on_progress(run.distance / total)
    if term.clock() - last < every or run.done then return end
    transaction(store, store.save, store, id, run, list)
    last = term.clock()
  end }
  return run, list
end

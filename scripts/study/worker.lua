-- A worker of a study: reads "case ID" lines, computes, stores the results in the run file itself,
-- and says how it goes. What it says: "at ID SHARE", "done ID", "failed ID TEXT" (the case),
-- "warned ID TEXT" (before the end of a case), "broken TEXT" (the file: nobody can go on). Leans on
-- archard.store; what it warns of goes by archard.warnings.

local stores = require "archard.store"
local columns = require "archard.settings".columns
local settings = require "archard.study.settings"
local term = require "archard.term"
local warnings = require "archard.warnings"

local pause = 0.2 -- seconds between two words on progress

-- Where in this file it went wrong says nothing to the user.
local function one_line(value)
  if type(value) == "table" then value.position = nil end
  return (tostring(value):gsub("%s+", " "):sub(1, 480))
end

local function say(...)
  io.write(table.concat({ ... }, " "), "\n")
  io.flush()
end

-- --- a run of wear -----------------------------------------------------------------------------

local function look(run, list)
  for i, body in ipairs { "cylinder", "plate" } do
    local role = i == 1 and "upper" or "lower"
    local profile, pressure = run:profile(role), run:pressure(role)
    list[#list + 1] = { body = body, update = run.update, distance = run.distance,
      x = profile.x, h = profile.h, y = profile.y, p = pressure.p }
  end
end

-- Runs to the end; looks at the surfaces `count` times on the way, the unworn ones among them, at
-- the first update not before each share of the distance. The last look is the store's.
local function compute(given, count, on_progress)
  local run = wear(given)
  local list, next_look, total = {}, 0, run.total_distance
  local function look_on()
    if total > 0 and next_look < count and run.distance >= next_look / count * total and not run.done then
      look(run, list)
      next_look = math.floor(run.distance / total * count) + 1
    end
  end
  look_on()
  run:run{ progress = function()
    look_on()
    on_progress(run.distance / total)
  end }
  return run, list
end

local tasks = {}

-- The columns of the last record by name.
local function last_record(run)
  local values, history = {}, run.history
  for _, column in ipairs(columns) do
    local list = history[column.name]
    values[column.name] = list[#list]
  end
  return values
end

function tasks.wear(store, id, on_progress)
  local looks = tonumber(store:info("looks")) or 0
  local run, list = compute(settings.nest(store:values(id, "settings")), looks, on_progress)
  return function()
    store:save(id, run, list)
    store:set_values(id, "results", last_record(run))
  end
end

-- Finds the settings that a case needs, and keeps them as its results.
function tasks.converge(store, id, on_progress)
  local search = require "archard.study.search"
  local found = search(settings.nest(store:values(id, "settings")), on_progress)
  return function() store:set_values(id, "results", settings.flatten("converge", found)) end
end

-- A trial of a fit: what the fit looks at are its results.
function tasks.fit(store, id, on_progress)
  local observe = require "archard.fit.observe"
  local looks, run = observe.run(settings.nest(store:values(id, "settings")),
    observe.read(store:info("observe")), on_progress)
  run:close()
  return function() store:set_values(id, "results", settings.flatten("fit", { looks = looks })) end
end

-- --- one case after the other ------------------------------------------------------------------

local function speaker(id)
  local last = -math.huge
  return function(share)
    local now = term.clock()
    if now - last < pause then return end
    last = now
    say("at", id, ("%.3f"):format(share))
  end
end

-- What the engine warned of in this case is part of what the user must know of it. A search goes
-- past every limit on purpose.
local function tell_warning(store, id)
  local text = warnings.take()
  if not text or store:info("task") == "converge" then return end
  local results = store:values(id, "results")
  results.warning = text
  store:set_values(id, "results", results)
  say("warned", id, one_line(text))
end

-- Stores what `keep` does and the mark in one transaction.
local function finish(store, id, seconds, keep)
  store:begin()
  local fine, why = pcall(function()
    keep()
    tell_warning(store, id)
    store:mark(id, "done", nil, seconds)
    store:commit()
  end)
  if not fine then
    store:rollback()
    error(why, 0)
  end
end

local function do_case(store, id)
  local start = term.clock()
  warnings.take()
  store:mark(id, "running")
  local task = tasks[store:info("task") or "wear"]
  local fine, keep = pcall(task, store, id, speaker(id))
  if not fine then
    tell_warning(store, id)
    store:mark(id, "failed", one_line(keep))
    return say("failed", id, one_line(keep))
  end
  finish(store, id, term.clock() - start, keep)
  say("done", id)
end

return function(path)
  local store = stores.open(path, "write")
  warnings.keep()
  for line in io.lines() do
    local id = math.tointeger(tonumber(line:match("^case (%d+)$")))
    if not id then error("worker: cannot make sense of " .. line) end
    local fine, why = pcall(do_case, store, id)
    if not fine then say("broken", one_line(why)) end
  end
end

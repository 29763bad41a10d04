-- One share of a submitted study, in a process of its own: every n-th of the cases that wait in the
-- plan, computed into a run file of its own. ARCHARD_SHARE in the environment is its number. Leans
-- on study/definitions.lua and study/run.lua.

local definitions = require "archard.study.definitions"

-- The ids of share i of n.
local function chosen(cases, i, n)
  local ids, position = {}, 0
  for _, case in ipairs(cases) do
    if case.status == "waiting" then
      position = position + 1
      if (position - i) % n == 0 then ids[case.id] = true end
    end
  end
  return function(id) return ids[id] end
end

-- plan: the run file of the whole study; path: of the share, with {} for its number.
return function(plan, path, shares, workers)
  local i = assert(math.tointeger(tonumber(os.getenv "ARCHARD_SHARE")), "ARCHARD_SHARE: no number")
  local whole = study.open(plan)
  local mine = chosen(whole:store():cases(), i, shares)
  whole:close()
  local store = definitions.for_run(whole, (path:gsub("{}", i)))
  require "archard.study.run"(store, { workers = workers, chosen = mine, progress = "lines" })
  store:close()
end

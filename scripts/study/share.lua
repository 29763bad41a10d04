-- One share of a submitted study, in a process of its own: every n-th of the cases that wait in the
-- whole, computed into a run file of its own. ARCHARD_SHARE in the environment is its number. Leans
-- on archard.store and study/run.lua.

local definitions = require "archard.study.definitions"
local files = require "archard.files"
local text_file = require "archard.lib.text_file"

local where = "study:submit"

-- The ids of share i of n.
local function chosen(whole, i, n)
  local store <close> = definitions.open(where, whole, "read")
  local ids, position = {}, 0
  for _, case in ipairs(store:cases()) do
    if case.status == "waiting" then
      position = position + 1
      if (position - i) % n == 0 then ids[case.id] = true end
    end
  end
  return function(id) return ids[id] end
end

-- whole: the run file of the study; folder: that of the job, where a run file with its definitions and
-- no results is, and a share's comes. One that was begun, by a task that Slurm starts again, is gone on with.
return function(whole, folder, shares, workers)
  local i = assert(math.tointeger(tonumber(os.getenv "ARCHARD_SHARE")), "ARCHARD_SHARE: no number")
  local mine, blank = ("%s/%d-of-%d.archard"):format(folder, i, shares), folder .. "/blank.archard"
  if not text_file.exists(mine) then files.write(where, mine, assert(text_file.read(blank))) end
  local store <close> = definitions.open(where, mine, "write")
  require "archard.study.run"(store, { workers = workers, chosen = chosen(whole, i, shares),
    progress = "lines" })
end

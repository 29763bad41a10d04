-- Computes one share of a submitted study in a separate process: every n-th waiting case. The results are
-- written to a separate run file. The environment variable ARCHARD_SHARE contains the number of the share.

local definitions = require "archard.study.definitions"
local files = require "archard.files"
local text_file = require "archard.lib.text_file"

local where = "study:submit"

-- Returns a function(id) that returns true for the cases that belong to share i of n.
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

-- Computes a share. whole: run file of the study; folder: folder of the job, with the run files of the shares
-- and blank.archard (the definitions without results). If Slurm restarts a task, the run file of its share is
-- continued.
return function(whole, folder, shares, workers)
  local i = assert(math.tointeger(tonumber(os.getenv "ARCHARD_SHARE")), "ARCHARD_SHARE: expected an integer")
  local mine, blank = ("%s/%d-of-%d.archard"):format(folder, i, shares), folder .. "/blank.archard"
  if not text_file.exists(mine) then files.write(where, mine, assert(text_file.read(blank))) end
  local store <close> = definitions.open(where, mine, "write")
  require "archard.study.run"(store, { workers = workers, chosen = chosen(whole, i, shares),
    progress = "lines" })
end

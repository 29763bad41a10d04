-- Shares of a study as a Slurm job array. Leans on sbatch and squeue. The interface is that of every
-- engine of study/submit.lua:
--   program               what has to be in PATH
--   start(job)            starts the shares; returns the job's name to ask for, or nil and why not
--   state(job)            what its shares do, as text; nil when all have ended; false and why when
--                         nobody can tell

local shell = require "archard.lib.shell"

local array = { program = "sbatch" }

function array.start(job)
  local words = { "sbatch", "--parsable", "--job-name=archard", "--array=1-" .. job.shares,
    "--cpus-per-task=" .. job.workers, "--output=" .. job.log("%a"), "--open-mode=truncate" }
  table.move(job.options, 1, #job.options, #words + 1, words)
  words[#words + 1] = job.script
  local said, fine = shell.ask(shell.line(words))
  local name = fine and said:match("(%d+)[;%d%w]*$")
  if not name then return nil, said end
  return name
end

-- "2 running, 6 pending" from a line a share
local function count(lines)
  local states, order = {}, {}
  for state in lines:gmatch("%S+") do
    if not states[state] then order[#order + 1] = state end
    states[state] = (states[state] or 0) + 1
  end
  for i, state in ipairs(order) do order[i] = states[state] .. " " .. state:lower() end
  return table.concat(order, ", ")
end

-- A job that ended long ago is unknown to Slurm.
function array.state(job)
  local said, fine = shell.ask(shell.line{ "squeue", "--noheader", "--array", "--format=%T",
    "--jobs=" .. job.name })
  if not fine then
    if said:find("Invalid job id", 1, true) then return nil end
    return false, said
  end
  return said ~= "" and count(said) or nil
end

return array

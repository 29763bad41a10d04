-- Runs the parts (shares) of a study as a Slurm job array with sbatch and squeue. All engines of study/submit.lua
-- have this interface:
--   program               name of a program that must be in PATH
--   start(job)            starts the shares; returns the name of the job, or nil and the reason
--   is_name(text)         true if a job can have this name
--   state(job)            states of the shares as text; nil if all have ended; false and the reason
--                         if the query failed

local shell = require "archard.lib.shell"

local array = { program = "sbatch" }

function array.is_name(text) return text:find "^%d+;?[%w_-]*$" ~= nil end

-- Starts the job. In --output, Slurm replaces % sequences, so each % is doubled. If the path contains a
-- backslash, Slurm replaces nothing, so such paths are refused.
function array.start(job)
  if job.folder:find("\\", 1, true) then return nil, "Slurm writes no logs to a folder with a backslash in its name" end
  local log = ("%s/%%a-of-%d.log"):format(job.folder:gsub("%%", "%%%%"), job.shares)
  local words = { "sbatch", "--parsable", "--job-name=archard", "--array=1-" .. job.shares,
    "--cpus-per-task=" .. job.workers, "--output=" .. log, "--open-mode=truncate" }
  table.move(job.options, 1, #job.options, #words + 1, words)
  words[#words + 1] = job.script
  local said, fine = shell.ask(shell.line(words))
  local name = fine and said:match("%f[^%z\n](%d+;?[%w_-]*)$")
  if not name then return nil, said end
  return name -- with several clusters, the name includes the cluster, such as "4242;north"
end

local function ask(name)
  local number, cluster = name:match("^(%d+);?(.*)$")
  local words = { "squeue", "--noheader", "--array", "--format=%T", "--jobs=" .. number }
  if cluster ~= "" then words[#words + 1] = "--clusters=" .. cluster end
  return shell.ask(shell.line(words))
end

-- Counts the shares by state. `lines` has one line for each share. Returns a text such as "2 running, 6
-- pending", or nil if no line contains a state.
local function count(lines)
  local states, order = {}, {}
  for state in lines:gmatch("%f[^%z\n](%u[%u_]+)%s*%f[%z\n]") do
    if not states[state] then order[#order + 1] = state end
    states[state] = (states[state] or 0) + 1
  end
  for i, state in ipairs(order) do order[i] = states[state] .. " " .. state:lower() end
  return order[1] and table.concat(order, ", ")
end

-- Returns the number of shares in each state as text. Returns nil if all shares have ended or Slurm no longer
-- has a record of the job, and false and the reason if the query failed.
function array.state(job)
  local said, fine = ask(job.name)
  if not fine then
    if said:find("Invalid job id", 1, true) then return nil end
    return false, said
  end
  return count(said)
end

return array

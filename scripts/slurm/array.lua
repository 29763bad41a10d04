-- Shares of a study as a Slurm job array. Leans on sbatch and squeue. The interface is that of every
-- engine of study/submit.lua:
--   program               what has to be in PATH
--   start(job)            starts the shares; returns the job's name to ask for, or nil and why not
--   is_name(text)         whether a job can have this name
--   state(job)            what its shares do, as text; nil when all have ended; false and why when
--                         nobody can tell

local shell = require "archard.lib.shell"

local array = { program = "sbatch" }

function array.is_name(text) return text:find "^%d+;?[%w_-]*$" ~= nil end

-- Within --output % is Slurm's, and a backslash anywhere makes it everybody else's.
function array.start(job)
  if job.folder:find("\\", 1, true) then return nil, "it writes no logs where a folder has a backslash in its name" end
  local log = ("%s/%%a-of-%d.log"):format(job.folder:gsub("%%", "%%%%"), job.shares)
  local words = { "sbatch", "--parsable", "--job-name=archard", "--array=1-" .. job.shares,
    "--cpus-per-task=" .. job.workers, "--output=" .. log, "--open-mode=truncate" }
  table.move(job.options, 1, #job.options, #words + 1, words)
  words[#words + 1] = job.script
  local said, fine = shell.ask(shell.line(words))
  local name = fine and said:match("%f[^%z\n](%d+;?[%w_-]*)$")
  if not name then return nil, said end
  return name -- with its cluster where there are several: "4242;north"
end

local function ask(name)
  local number, cluster = name:match("^(%d+);?(.*)$")
  local words = { "squeue", "--noheader", "--array", "--format=%T", "--jobs=" .. number }
  if cluster ~= "" then words[#words + 1] = "--clusters=" .. cluster end
  return shell.ask(shell.line(words))
end

-- "2 running, 6 pending" from a line a share; nil where none tells a state.
local function count(lines)
  local states, order = {}, {}
  for state in lines:gmatch("%f[^%z\n](%u[%u_]+)%s*%f[%z\n]") do
    if not states[state] then order[#order + 1] = state end
    states[state] = (states[state] or 0) + 1
  end
  for i, state in ipairs(order) do order[i] = states[state] .. " " .. state:lower() end
  return order[1] and table.concat(order, ", ")
end

-- A job that ended long ago is unknown to Slurm.
function array.state(job)
  local said, fine = ask(job.name)
  if not fine then
    if said:find("Invalid job id", 1, true) then return nil end
    return false, said
  end
  return count(said)
end

return array

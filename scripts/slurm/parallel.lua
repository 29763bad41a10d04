-- Shares of a study under GNU parallel, on this machine or, with --sshlogin among the options, on
-- several that share its files. The interface is that of slurm/array.lua.

local shell = require "archard.lib.shell"
local text_file = require "archard.lib.text_file"

local parallel = { program = "parallel" }

function parallel.is_name(text) return text:find "^%d+$" ~= nil end

-- A path within a command, where parallel replaces {}, {#}, {= Perl =} and the like (and \xAF<, which it
-- makes of the latter): an empty text in between makes them none.
local function literal(path) return (shell.quote(path):gsub("[{\xAF]", "%0''")) end

-- In a session of its own: it outlives this program, and no Ctrl-C reaches it.
function parallel.start(job)
  local words = { "setsid", "parallel" }
  table.move(job.options, 1, #job.options, 3, words)
  words[#words + 1] = ("sh %s {} >%s/{}-of-%d.log 2>&1"):format(literal(job.script), literal(job.folder), job.shares)
  words[#words + 1] = ":::"
  for i = 1, job.shares do words[#words + 1] = i end
  local said, fine = shell.ask(("%s </dev/null >%s 2>&1 & echo $!"):format(shell.line(words),
    shell.quote(job.log("parallel"))))
  if not fine then return nil, said end
  return said
end

-- By the words of the process, for another one may have got its number. They are empty for a moment
-- while one program makes way for another, and for good once it has died.
function parallel.state(job)
  local status = text_file.read(("/proc/%s/status"):format(job.name))
  local words = text_file.read(("/proc/%s/cmdline"):format(job.name))
  if not status or not words or status:find("\nState:%s+[ZX]") then return nil end
  return (words == "" or words:find("parallel", 1, true)) and "running" or nil
end

return parallel

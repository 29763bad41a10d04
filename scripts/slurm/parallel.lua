-- Runs the shares of a study with GNU parallel: on this machine or, with --sshlogin in the options, on
-- several machines with a common file system. slurm/array.lua describes the interface.

local shell = require "archard.lib.shell"
local text_file = require "archard.lib.text_file"

local parallel = { program = "parallel" }

function parallel.is_name(text) return text:find "^%d+$" ~= nil end

-- Quotes a path for a command of GNU parallel, which replaces {}, {#} and {= Perl =}, and also \xAF<, a
-- synonym of {=. An empty string after the first character prevents the replacement.
local function literal(path) return (shell.quote(path):gsub("[{\xAF]", "%0''")) end

-- Starts the job in a new session, so that it continues after this program ends and Ctrl-C does not stop it.
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

-- Returns "running" if the job has not ended, else nil. The command line of the process is checked, because
-- another process may have the same process id by then. While one program replaces another, and after the end
-- of the process, the command line is briefly empty.
function parallel.state(job)
  local status = text_file.read(("/proc/%s/status"):format(job.name))
  local words = text_file.read(("/proc/%s/cmdline"):format(job.name))
  if not status or not words or status:find("\nState:%s+[ZX]") then return nil end
  return (words == "" or words:find("parallel", 1, true)) and "running" or nil
end

return parallel

-- Shares of a study under GNU parallel, on this machine or, with --sshlogin among the options, on
-- several that share its files. The interface is that of slurm/array.lua.

local shell = require "archard.lib.shell"

local parallel = { program = "parallel" }

-- In a session of its own: it outlives this program, and no Ctrl-C reaches it.
function parallel.start(job)
  local words = { "setsid", "parallel" }
  table.move(job.options, 1, #job.options, 3, words)
  local share = ("sh %s {} >%s 2>&1"):format(shell.quote(job.script),
    shell.quote(job.log("{}")):gsub("{}", "'{}'"))
  words[#words + 1] = share
  words[#words + 1] = ":::"
  for i = 1, job.shares do words[#words + 1] = i end
  local said, fine = shell.ask(("%s </dev/null >%s 2>&1 & echo $!"):format(shell.line(words),
    shell.quote(job.log("parallel"))))
  if not fine then return nil, said end
  return said
end

-- By the command line of the process: another one may have got its number.
function parallel.state(job)
  local alive = select(2, shell.ask(("grep -qsF -- %s /proc/%d/cmdline"):format(
    shell.quote(job.script), job.name)))
  return alive and "running" or nil
end

return parallel

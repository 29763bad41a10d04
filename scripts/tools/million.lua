-- Runs a quasi-continuous wear history at full length: 10000 cycles of 100 increments, with a geometry update
-- at every increment. The run has a million contact solutions with frozen stiffness. The script also measures
-- the time of user functions in such a run. `archard scripts/tools/million.lua` prints the times; require
-- "million" returns the function.

local function timed(f)
  collectgarbage()
  local start = os.clock()
  f()
  return os.clock() - start
end

local function quasi_continuous(fields, cycles)
  local definition = { geometry = "frozen", update = "increment", jump = 1, increments = 100, cycles = cycles }
  for name, value in pairs(fields) do definition[name] = value end
  return wear(definition)
end

-- Returns the CPU time per increment [us] of a run with a given number of cycles, and the run.
local function cost(fields, cycles)
  local w = quasi_continuous(fields, cycles)
  local seconds = timed(function() w:run{ progress = false } end)
  return 1e6 * seconds / (100 * cycles), w
end

-- User function that computes the local factors of all nodes at once. It may overwrite the list of pressures
-- with them.
local function with_vector(_, xs, ps)
  for i = 1, #ps do ps[i] = 1 + 1e-6 * ps[i] + xs[i] end
  return ps
end

local functions = {
  { "k as a function of the state", { k = function(s) return 1e-8 * (1 + 1e-6 * s.distance) end } },
  { "local_factor, node by node", { local_factor = function(_, x, p) return 1 + 1e-6 * p + x end } },
  { "local_factor, all nodes at once", { local_factor = { vector = with_vector } } },
}

-- Calls line(what, value, unit, goal) for each line of the benchmark. cycles: number of cycles (default
-- 10000); fewer cycles shorten the runs.
local function million(line, cycles)
  cycles = cycles or 10000
  local plain, w = cost({}, cycles)
  line(("quasi-continuous, %d contact solutions"):format(w.solutions), ("%.2f"):format(plain * cycles * 1e-4), "s",
    cycles == 10000 and "30")
  line("time per increment", ("%.2f"):format(plain), "us")
  local part = math.max(1, cycles // 4)
  plain = cost({}, part)
  for _, row in ipairs(functions) do
    local with = cost(row[2], part)
    line("  more for " .. row[1], ("%.2f"):format(with - plain), "us", ("below %.2f"):format(plain))
  end
end

if ... ~= "million" then
  million(function(what, value, unit, goal)
    print(("%-52s %9s %-4s %s"):format(what, value, unit or "", goal and "goal " .. goal or ""))
  end, tonumber((...)))
end
return million

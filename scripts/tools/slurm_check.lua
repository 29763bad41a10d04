-- Runs a study through Slurm and on this machine, checks that the results are identical in all bits, and
-- prints the cases per minute.
--
--   scripts/slurm/node build/archard scripts/tools/slurm_check.lua [CASES] [SHARES] [FOLDER]
--
-- The cases are small (elements of 40 um, five updates), so most of the time is overhead.

local count, shares = tonumber(arg[1]) or 1000, tonumber(arg[2]) or 8
local folder = arg[3] or os.tmpname()
os.remove(folder)
assert(require "archard.process".make_folder(folder))
local content = dofile((arg[0]:match("^(.*)scripts/tools/") or "") .. "tests/lua/lib/content.lua")
local clock = require "archard.term".clock

-- Returns a study whose cases differ in alpha and load.
local function small_cases()
  local cases = {}
  for i = 1, count do cases[i] = { alpha = (i - 1) % 101 / 100, load = 80 + 40 * (i - 1) / count } end
  return study{ name = "small", snapshots = 2, cases = cases, base = { geometry = "frozen", increments = 8,
    distance = 110, model = { mesh = { size = 0.04, height = 0.05 } } } }
end

local function timed(engine)
  local s, start = small_cases(), clock()
  s:submit{ engine = engine, shares = engine == "slurm" and shares or nil, progress = false,
    file = ("%s/%s.archard"):format(folder, engine) }
  local seconds = clock() - start
  assert(#s.failed == 0, "cases failed")
  return s, seconds
end

print(("%-10s %8s %8s %10s %14s"):format("engine", "cases", "shares", "seconds", "cases/minute"))
local texts = {}
for _, engine in ipairs{ "slurm", "local" } do
  local s, seconds = timed(engine)
  print(("%-10s %8d %8s %10.1f %14.0f"):format(engine, count, engine == "slurm" and shares or "-", seconds,
    60 * count / seconds))
  texts[engine] = content(s, 100)
  s:close()
end
local same = texts.slurm == texts["local"] and #texts.slurm > 0
print(same and "the merged file and the file of the local run have identical contents" or "THE RESULTS DIFFER")
os.execute("rm -rf '" .. folder .. "'")
os.exit(same, true)

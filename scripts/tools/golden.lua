-- Prints a hash of all results of the paper's 20 cases: all history columns at all updates, and the final
-- surfaces.
--
--   archard scripts/tools/golden.lua WORKERS [broken]
--
-- With `broken`, each case is saved after three updates and continued from its file.

local workers, broken = math.tointeger(arg[1]) or 1, arg[2] == "broken"

-- Adds bytes to a 64-bit FNV-1a hash. Returns the new hash.
local function add(sum, bytes)
  for i = 1, #bytes do sum = (sum ~ bytes:byte(i)) * 1099511628211 end
  return sum
end

local function add_numbers(sum, list)
  for i = 1, #list do sum = add(sum, string.pack("<d", list[i])) end
  return sum
end

local function of_run(sum, w)
  local history = w.history
  for _, column in ipairs(require "archard.settings".columns) do
    if column.name ~= "area" and column.name ~= "half_width_z" then -- these columns exist only in 3-D
      sum = add_numbers(sum, history[column.name])
    end
  end
  for _, body in ipairs{ "cylinder", "plate" } do
    sum = add_numbers(add_numbers(sum, w:profile(body).h), w:pressure(body).p)
  end
  return sum
end

local function in_two(case, file)
  local w = wear(case)
  for _ = 1, 3 do w:step() end
  w:save(file)
  local rest = wear.open(file)
  rest:run()
  return rest
end

local file = os.tmpname()
os.remove(file)
local s, sum = study.paper(), -3750763034362895579
if not broken then s:run{ file = file, workers = workers, progress = false } end
local settings = require "archard.definition.settings"
for i, case in ipairs(broken and s.flat or s:cases()) do
  sum = of_run(sum, broken and in_two(settings.nest(case), file) or case:wear())
  if broken then os.remove(file) end
end
s:close()
os.remove(file)
print(("%016x"):format(sum))

-- What users do, piece by piece, with memory that runs out at every point of it (or at as many as
-- ARCHARD_POINTS says, spread evenly): an error of memory, or success; the program goes on, and the
-- same piece then works. Prints TAP.

local folder, points = os.getenv "TMPDIR", tonumber(os.getenv "ARCHARD_POINTS") or 40
local counted = folder .. "/count"

local function disarm() -- more than once: what it takes may itself be among those that fail
  for _ = 1, 10 do pcall(string.rep, "x", (1 << 30) - 4096) end
end
local function arm(n) pcall(string.rep, "x", (1 << 30) + n * 64) end

local small = { radius = 10, mesh = { size = 0.08 } }
local function run_of(distance)
  local w = wear{ model = model(small), distance = 400, increments = 20, jump = 20 }
  for _ = 1, distance do w:step() end
  return w
end
local w = run_of(2)
local s = study{ base = { model = small, increments = 10, jump = 100, distance = 100 }, vary = { alpha = { 0, 1 } } }
local file = folder .. "/kept"
warn "@off"

local pieces = {
  { "a contact", function() contact{ model = model(small), load = 60 + math.random() } end },
  { "friction", function() contact{ model = model(small), load = 60, friction = 0.3 }:move{ x = 0.01 } end },
  { "a step", function() run_of(1) end },
  { "a function for k", function()
    wear{ model = model(small), k = function(at) return 1e-8 * (1 + at.distance) end, jump = 20 }:step()
  end },
  { "history and profile", function() return #w.history.update + #w:profile("plate").x + #w:pressure("plate").p end },
  { "stresses", function() return w:contact():stress() end },
  { "text", function() return tostring(w) .. tostring(w:contact()) .. tostring(w.mesh) end },
  { "a clone that changes", function() local c = w:clone() c:set{ load = 80 } c:step() end },
  { "csv", function() export.csv(w.history, file .. ".csv") return csv.read(file .. ".csv") end },
  { "vtu", function() export.vtk(w, file .. ".vtu") end },
  { "inp", function() export.inp(w, file .. ".inp") end },
  { "json", function() export.json(w, file .. ".json") end },
  { "save and open", function() w:save(file .. ".archard") wear.open(file .. ".archard"):step() end },
  { "a plot", function() plot.profile(w, { file = file .. ".txt" }) end },
  { "a picture", function() plot.pressure(w, { file = file .. ".svg" }) end },
  { "a study that is read", function() return s:table() end },
  { "help", function() return help.text and help.text "wear" end },
}

local number = 0
local function ok(fine, what)
  number = number + 1
  print(("%s %d - %s"):format(fine and "ok" or "not ok", number, what))
end

-- Lua's own error is a string, ours a table with a code.
local function of_memory(why)
  local code = type(why) == "table" and why.code
  return code == "MEMORY" or tostring(why):find("memory", 1, true) ~= nil
end

local function count_of(work)
  arm(1 << 23)
  pcall(work)
  disarm()
  local at <close> = assert(io.open(counted))
  return at:read "n"
end

s:run{ file = folder .. "/study.archard", progress = false }
local only = arg[1]
for _, piece in ipairs(pieces) do
  local name, work = piece[1], piece[2]
  if not only or name == only then
    work()
    collectgarbage()
    local count = count_of(work)
    local other
    for k = 0, points - 1 do
      local n = points < count and k * count // points or k
      if n >= count then break end
      collectgarbage()
      arm(n)
      local fine, why = pcall(work)
      disarm()
      if not fine and not of_memory(why) then other = other or ("point %d of %d: %s"):format(n, count, tostring(why)) end
    end
    ok(not other, ("%s: %d allocations, %d of them fail%s"):format(name, count, math.min(points, count),
      other and "; " .. other or ""))
    ok(pcall(work), name .. " works again")
  end
end
print("1.." .. number)

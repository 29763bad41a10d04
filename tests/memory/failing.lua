-- Runs typical uses of archard with a failure in the first and in the last call at each call site, or in
-- ARCHARD_POINTS evenly spaced calls. Each use must succeed or report the failure; afterwards the same use
-- must succeed. Prints TAP. Usage:
--   failing.lua memory|system [piece]

local what, only = arg[1], arg[2]
local folder, points = os.getenv "TMPDIR", tonumber(os.getenv "ARCHARD_POINTS")
warn "@off"
local counted = folder .. "/count"
local pieces = assert(loadfile "tests/memory/pieces.lua")(folder)


-- The next functions send commands to tests/memory/failing.c by allocations of special sizes.
local function order(size) pcall(string.rep, "x", size) end
local function arm(n) order((what == "memory" and 1 << 30 or 3 << 29) + n * 64) end
local function disarm() -- repeated because the command itself may fail
  for _ = 1, 10 do order((1 << 30) - 4096) end
end

local number = 0
local function ok(fine, says)
  number = number + 1
  print(("%s %d - %s"):format(fine and "ok" or "not ok", number, says))
end

-- Functions that return true if an error reports the failure. Lua's own errors are strings; archard's errors
-- are tables with a code.
local told = {}

function told.memory(why)
  return type(why) == "table" and why.code == "MEMORY" or tostring(why):find("memory", 1, true) ~= nil
end

function told.system(why) return type(why) == "table" and why.code == "IO" end

-- Returns the number of allocations, each of which can be made to fail, and a list of the first and the last
-- allocation at each call site.
local function points_of(work)
  arm(1 << 22)
  pcall(work)
  disarm()
  local at <close> = assert(io.open(counted))
  local count, list, seen = at:read "n", {}, {}
  for n in function() return at:read "n" end do
    if not seen[n] then list[#list + 1] = n end
    seen[n] = true
  end
  table.sort(list)
  return count, list
end

-- Runs a use with failures at `tried` points of the list; returns the first problem found, or nothing.
local function try(piece, list, tried)
  for k = 0, tried - 1 do
    local n = list[1 + k * #list // tried]
    collectgarbage()
    arm(n)
    local fine, why = pcall(piece[2])
    disarm()
    if not fine and not told[what](why) then return ("time %d: %s"):format(n, tostring(why)) end
    if piece.whole and not pcall(piece.whole) then return ("time %d: what was there is lost"):format(n) end
  end
end

for _, piece in ipairs(pieces) do
  if (not only or piece[1] == only) and (what == "memory" or piece.files) then
    piece[2]()
    collectgarbage()
    local count, list = points_of(piece[2])
    local tried = math.min(points, #list)
    local wrong = try(piece, list, tried)
    ok(not wrong, ("%s: %d times, %d of them the first or last of a place, %d of these fail%s"):format(piece[1], count,
      #list, tried, wrong and "; " .. wrong or ""))
    ok(pcall(piece[2]), piece[1] .. " works again")
  end
end
print("1.." .. number)

-- Tests joint runs in files: opened and continued runs have identical bits.
local tap = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/tap.lua")
local is, ok, fails = tap.is, tap.ok, tap.fails

local pe = material{ E = 1000, nu = 0.4 }
local liner = joint{ head = { material = material{ E = 1e15 }, layers = { { thickness = 2, material = pe } } },
  cup = { clearance = 0.1, inclination = 20, cover = 85, layers = { { thickness = 8, material = pe }, { thickness = 2, material = pe } } },
  mesh = { size = 6 } }

local function bits(list)
  local words = {}
  for i = 1, #list do words[i] = ("%a"):format(list[i]) end
  return table.concat(words, " ")
end
local function same(a, b, what)
  is(("%a"):format(b.cycle), ("%a"):format(a.cycle), what .. ": cycle")
  is(b.record.solutions, a.record.solutions, what .. ": number of contact solutions")
  for _, map in ipairs{ "head", "cup", "cross shear", "creep", "pressure" } do
    ok(bits(b:map(map).values) == bits(a:map(map).values), what .. ": " .. map)
  end
  local differ = {}
  for name, column in pairs(a.history) do
    if bits(b.history[name]) ~= bits(column) then differ[#differ + 1] = name end
  end
  is(table.concat(differ, " "), "", what .. ": columns of the history that differ")
end
local kept = os.tmpname()
os.remove(kept)
local function sheared(s) return 1e-9 * math.min(0.2 + 3.2 * s.cross_shear, 1) end
for what, def in pairs{ steps = { k = 1e-9 }, updates = { k = 1e-9, updates = 8 }, shear = { k = sheared, updates = 4, alpha = function(s) return s.cycle / 1e7 end, creep = function(s) return 1e-3 * s.p_mean end },
  blocks = { k = 1e-9, loading = { { gait = gait "prosim", cycles = 2e5 }, { gait = gait.rocking() } } },
  explicit = { k = 1e-9, cycles = 2e5, scheme = "explicit" } } do
  def.model, def.cycles = liner, def.cycles or 5e5
  local whole, first = wear(def):run{ progress = false }, wear(def)
  pcall(first.run, first, { progress = function(r) if r.cycle > 0.1 * def.cycles then error "stop" end end })
  ok(first.cycle < def.cycles, what .. ": the run is stopped at cycle " .. first.cycle)
  first:save(kept)
  if what == "shear" then fails(function() joint.open(kept) end, "field 'k'",
    "a function must be given again") end
  local again = joint.open(kept, { k = sheared, alpha = def.alpha, creep = def.creep })
  same(first, again, what .. ", opened")
  same(first, wear.open(kept, { k = sheared, alpha = def.alpha, creep = def.creep }),
    what .. ", opened by wear.open")
  is(tostring(again), tostring(first), what .. ": printed text")
  same(whole, again:run{ progress = false }, what .. ", continued")
end
local named = material{ E = 1000, nu = 0.4, name = "UHMWPE" }
wear{ model = joint{ mesh = { size = 4 }, cup = { layers = { { thickness = 8, material = named } } } } }:save(kept)
ok(tostring(wear.open(kept)):find("cup       8 mm of UHMWPE, E 1000 MPa", 1, true),
  "the names of materials are stored")
fails(function() joint.open(kept .. ".none") end, "none", "a missing file")
local foreign = io.open(kept, "w")
foreign:write "mine"
foreign:close()
fails(function() joint.open(kept) end, "run file", "a file that is not a run file")
fails(function() wear{ model = liner }:save(kept) end, kept, "a file that is not a run file is not replaced")
os.remove(kept)


-- Tests the lifetime of objects: sharing, closing, garbage collection.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, fails, holds = tap.ok, tap.is, tap.fails, tap.holds

-- Tests that models with equal definitions are shared.
local a, b = wear{}, wear{ alpha = 0.25 }
is(a.model, b.model, "two runs share the default model")
is(model{ radius = 7 }, model{ radius = 7 }, "equal definitions give the same model")
ok(model{ radius = 7 } ~= model{ radius = 7.5 }, "different definitions give different models")
is(wear{ model = { radius = 10 } }.model, a.model, "a table of default values gives the default model")

-- Tests that each part of an object keeps a reference to this object.
local mesh = model{ radius = 6 }.mesh.plate
local contact_alone = wear{ model = model{ radius = 6 } }:contact()
collectgarbage() collectgarbage()
ok(mesh:node(1) ~= nil, "a mesh exists longer than its model")
ok(contact_alone:stress().plate.x[1] ~= nil, "a contact exists longer than its run and model")
is(contact_alone.model.radius, 6, "a contact refers to its model")

-- Tests close.
local w = wear{}
local m = w.model
w:close()
w:close()
fails(function() w:step() end, "this wear object has been closed", "closed: methods")
fails(function() return w.distance end, "has been closed", "closed: fields")
fails(function() contact{ worn = w } end, "has been closed", "closed: as an argument")
holds(tostring(w), "wear (closed)", "closed: print")
is(m.radius, 10, "the model of a closed run remains usable")
local run = wear{ model = m }
m:close()
fails(function() wear{ model = m } end, "this model object has been closed", "a closed model as an argument")
run:step()
is(run.update, 1, "a run can use its model after the model is closed")
local reused = wear{}
do
  local scoped <close> = reused
end
fails(function() return reused.cycle end, "closed", "a to-be-closed variable closes its object")
fails(function() w.close(3) end, "call this method with a colon: object:close()",
  "close called with a number")
fails(function() return material{}.close end, "no field 'close'", "materials have no method close")

-- Tests a user function that closes the object being used.
local doomed = model{ radius = 6.5 }
local survived = pcall(contact, { model = doomed, worn = { plate = function(x)
  doomed:close()
  collectgarbage()
  return 0
end } })
ok(survived, "a model closed while a contact is computed on it")

-- Tests that metatables have the entries for completion and help. (A model lists its bodies only if they are
-- not the default pair.)
local own = model{ upper = body.punch{ flat = 1, radius = 2 }, lower = body.block{}, mesh = { size = 0.08, height = 0.1 } }
for _, object in ipairs{ wear{}, contact{}, own, model{}.mesh.plate, hertz{}, material{ name = "steel" } } do
  local meta = debug.getmetatable(object)
  local known = true
  for _, name in ipairs(meta.__fields) do known = known and object[name] ~= nil end
  ok(#meta.__fields > 0 and known, meta.__name .. ": every name in __fields has a value")
  ok(debug.getregistry()["archard." .. meta.__name] == meta, meta.__name ..
    ": the registry contains the metatable")
  for name, f in pairs(meta.__methods) do known = known and object[name] == f end
  ok(known, meta.__name .. ": every function in __methods is a method")
  ok(pcall(meta.__gc or print), meta.__name .. ": __gc without an object has no effect")
end

-- Tests that the lines of printed objects have at most 80 characters.
local run = wear{}:run{ progress = false }
for _, object in ipairs{ run, wear{}, run:contact(), run:contact():stress(), run.model,
  run.model.mesh.plate, hertz{}, material{}, run:step(), wear{}:step(70) } do
  local longest = 0
  for line in tostring(object):gmatch("[^\n]+") do longest = math.max(longest, #line) end
  ok(longest <= 80, tostring(object):match("^%s*%a+") .. ": printed lines have at most 80 characters")
end

-- Tests that the garbage collector counts the memory of objects. The test is skipped with a sanitizer, which
-- delays freeing memory.
local function memory() -- resident [MB]
  for line in io.lines("/proc/self/status") do
    local kilobytes = line:match("^VmRSS:%s*(%d+)")
    if kilobytes then return tonumber(kilobytes) / 1024 end
  end
end
local function growth(count, make)
  local before = memory()
  for i = 1, count do make(i) end
  return memory() - before
end
local function drop_run() wear{ increments = 200 } end
local function drop_model(i) model{ radius = 8 + i / 100, mesh = { far = 0.4 } } end
if (os.getenv "SANITIZER" or "") == "" then
  growth(20, drop_run)
  local runs, models = growth(300, drop_run), growth(12, drop_model)
  ok(runs < 100, ("300 discarded runs are freed (%+.0f MB)"):format(runs))
  ok(models < 60, ("12 discarded models are freed (%+.0f MB)"):format(models))
end

-- --- changes by scripts to objects in use ------------------------------------------------------------

local small = { mesh = { size = 0.1, height = 0.1, far = 2, rows = 2 } }
warn "@off"
local function run_of(definition)
  definition.model, definition.distance, definition.jump = small, 44, 50
  return wear(definition)
end

for _, length in ipairs{ 2^61, 1 << 61, -1, "10" } do
  local list = setmetatable({ 0, 1, 0 }, { __len = function() return length end })
  is(#run_of{ loading = { x = list } }.loading[1].x, 3,
    ("the length of a list is not its __len, %s"):format(length))
end
fails(function() run_of{ k = { distance = setmetatable({}, { __index = function() return 1 end }), value = { 1 } } } end,
  "expected two arrays of equal length", "items of a list are not computed by __index")
local endless = setmetatable({}, { __len = function() return 1 << 61 end, __index = function() return 1 end })
for what, call in pairs{ x = function() profile{ x = endless, z = endless } end,
  options = function() study{}:submit{ engine = "slurm", options = endless } end,
  vary = function() study{ vary = { alpha = endless } } end } do
  fails(call, { "field '" .. (what == "x" and "" or what) },
    "a list whose __len is too large is refused: " .. what)
end

-- Tests an object that is closed by a metamethod of the table being read: its data exist as long as the call
-- uses them.
local shape = run_of{}
shape:step()
local made = contact{ model = small, worn = setmetatable({ plate = shape:profile "plate" }, { __index = function()
  shape:close()
end }) }
ok(made.p_max > 0, "a profile exists longer than its run")
shape = run_of{}
shape:step()
fails(function() contact(setmetatable({ worn = shape }, { __index = function() shape:close() end })) end,
  "this wear object has been closed", "a run closed before its shape is read")
shape = run_of{}
shape:step()
local depth = setmetatable({}, { __index = function(_, name) shape:close() collectgarbage() return name == "h" and { 0, 0 } end })
fails(function() contact{ model = small, worn = { plate = depth, cylinder = shape } } end, "field",
  "a run closed while its shape is read")

-- Tests finalizers that step a run while its history and profile are read.
local stepped = run_of{}
stepped:step()
collectgarbage("generational", 1)
local refused = 0
for _ = 1, 200 do
  setmetatable({}, { __gc = function()
    local fine, why = pcall(function() stepped:step() end)
    if not fine and tostring(why):find "is in use and cannot change" then refused = refused + 1 end
  end })
  local history, profile = stepped.history, stepped:profile "plate"
  if #history.distance < 2 or #profile.x ~= #profile.h then refused = -math.huge end
end
collectgarbage "incremental"
ok(refused > 0 and stepped.distance % 11 == 0, "a finalizer can step a run only between calls of the run")
tap.note(("%d refused, at %g mm"):format(refused, stepped.distance))

-- Tests that objects with the metatable of another class are refused.
local steel, other = material{}, run_of{}
debug.setmetatable(steel, getmetatable(other))
fails(function() return steel.distance end, "expected a wear object", "a material with the metatable of runs")
local streams = debug.getmetatable(io.stdout)
debug.setmetatable(io.stdout, getmetatable(other))
fails(function() return io.stdout.distance end, "expected a wear object", "a file with the metatable of runs")
debug.setmetatable(io.stdout, streams)
ok(not pcall(getmetatable(other).__methods.step, setmetatable({}, getmetatable(other))),
  "a table with the metatable of runs")
debug.setmetatable(steel, getmetatable(material{}))
is(steel.E, 200e3, "a material with its own metatable again")

-- Tests error values that cannot be converted to a string.
fails(function() run_of{ k = function() error(setmetatable({}, { __tostring = error })) end } end,
  "k(state at distance 0 mm, cycle 0) failed: (error value is a table)",
    "an error value that cannot be converted to text")
local files = os.tmpname()
os.remove(files)
run_of{}:save(files)
local store <close> = require "archard.store".open(files, "write")
fails(function() store:publish() end, "was not made to replace a file",
  "publish of a store that replaces no file")
is(#store:cases(), 1, "the store remains open after the error")

-- A finalizer that opens and closes a run file would release the locks of a transaction in this file.
local finalized
require "archard.study.transaction"(store, function()
  setmetatable({}, { __gc = function() finalized = wear.open(files).distance end })
  local garbage
  for i = 1, 3e5 do garbage = { i, garbage and garbage[1] } end
end)
ok(not finalized, "no finalizer is called during a transaction")
ok(collectgarbage "isrunning", "garbage is collected again after a transaction")
collectgarbage()
is(finalized, 0, "the finalizer is called afterwards")
os.remove(files)
fails(function() run_of{ slide = "x", loading = { x = { 0, 1e300, 0 } } } end, "expected a path of at most 100000 increments",
  "a motion of too many increments")
for _, value in ipairs{ stepped.history, stepped.depth, contact{ model = small }:stress(), _G, math } do
  local metatable = debug.getmetatable(value)
  pcall(metatable.__index, 5, "radius")
  ok(not pcall(metatable.__newindex or error, 5, 5, 5), "metamethods of archard called with a number")
end
local co = coroutine.create(function()
  return profile{ x = { 0, 1, 2, 3, 4, 5, 6, 7 }, z = { 0, 1, 0, 1, 0, 1, 0, 1 } }.roughness(5)
end)
holds(select(2, coroutine.resume(co)), "profile: expected a profile object, got 5",
  "a method of a class written in Lua, called with a number")
ok(not tostring(select(2, coroutine.resume(coroutine.create(uniform)))):find "scripts/",
  "the message contains no position in a script of archard")

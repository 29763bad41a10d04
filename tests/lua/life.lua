-- Objects come and go: sharing, closing, the collector.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, fails, holds = tap.ok, tap.is, tap.fails, tap.holds

-- models of one definition are one
local a, b = wear{}, wear{ alpha = 0.25 }
is(a.model, b.model, "two runs share a model")
is(model{ radius = 7 }, model{ radius = 7 }, "two equal definitions are one model")
ok(model{ radius = 7 } ~= model{ radius = 7.5 }, "two others are not")
is(wear{ model = { radius = 10 } }.model, a.model, "a table of defaults is the default")

-- children keep their parents
local mesh = model{ radius = 6 }.mesh.plate
local contact_alone = wear{ model = model{ radius = 6 } }:contact()
collectgarbage() collectgarbage()
ok(mesh:node(1) ~= nil, "a mesh outlives its model's name")
ok(contact_alone:stress().plate.x[1] ~= nil, "a contact outlives run and model")
is(contact_alone.model.radius, 6, "and still knows its model")

-- close
local w = wear{}
local m = w.model
w:close()
w:close()
fails(function() w:step() end, "this wear object has been closed", "closed: methods")
fails(function() return w.distance end, "has been closed", "closed: fields")
fails(function() contact{ worn = w } end, "has been closed", "closed: as an argument")
holds(tostring(w), "wear (closed)", "closed: print")
is(m.radius, 10, "its model stays")
local run = wear{ model = m }
m:close()
fails(function() wear{ model = m } end, "this model object has been closed", "closed model as an argument")
run:step()
is(run.update, 1, "a run goes on without its model's object")
local reused = wear{}
do
  local scoped <close> = reused
end
fails(function() return reused.cycle end, "closed", "to-be-closed variables close")
fails(function() w.close(3) end, "close is called as object:close()", "close of a number")
fails(function() return material{}.close end, "no field 'close'", "values need no closing")

-- a user function that closes what is being used
local doomed = model{ radius = 6.5 }
local survived = pcall(contact, { model = doomed, worn = { plate = function(x)
  doomed:close()
  collectgarbage()
  return 0
end } })
ok(survived, "a model closed while a contact is being made on it")

-- metatables as completion and help expect them
-- (a model says its bodies where they are not the usual pair)
local own = model{ upper = body.punch{ flat = 1, radius = 2 }, lower = body.block{}, mesh = { size = 0.08, height = 0.1 } }
for _, object in ipairs{ wear{}, contact{}, own, model{}.mesh.plate, hertz{}, material{} } do
  local meta = debug.getmetatable(object)
  local known = true
  for _, name in ipairs(meta.__fields) do known = known and object[name] ~= nil end
  ok(#meta.__fields > 0 and known, meta.__name .. ": every name in __fields has a value")
  ok(debug.getregistry()["archard." .. meta.__name] == meta, meta.__name .. ": the registry knows it")
  for name, f in pairs(meta.__methods) do known = known and object[name] == f end
  ok(known, meta.__name .. ": every function in __methods is a method")
  ok(pcall(meta.__gc or print), meta.__name .. ": __gc of nothing is harmless")
end

-- what print shows fits a terminal
local run = wear{}:run{ progress = false }
for _, object in ipairs{ run, wear{}, run:contact(), run:contact():stress(), run.model,
  run.model.mesh.plate, hertz{}, material{}, run:step(), wear{}:step(70) } do
  local longest = 0
  for line in tostring(object):gmatch("[^\n]+") do longest = math.max(longest, #line) end
  ok(longest <= 80, tostring(object):match("^%s*%a+") .. ": print fits 80 columns")
end

-- the collector hears of what objects weigh; a sanitizer holds freed memory back, so not there
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
  ok(runs < 100, ("300 dropped runs leave no heap of memory (%+.0f MB)"):format(runs))
  ok(models < 60, ("12 dropped models neither (%+.0f MB)"):format(models))
end

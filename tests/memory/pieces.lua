-- Typical uses of archard, each with a name and a function. The field `files` marks a use that writes files in
-- the given folder; the function `whole` fails if existing data are lost.

local folder = ...
local small = { radius = 10, mesh = { size = 0.08 } }
-- a new model each time, which is not shared
local function new() return model{ radius = 10 + math.random() / 1000, mesh = small.mesh } end
local function run_of(distance)
  local w = wear{ model = model(small), distance = 400, increments = 20, jump = 20 }
  for _ = 1, distance do w:step() end
  return w
end
w = run_of(2)
s = study{ base = { model = small, increments = 10, jump = 100, distance = 100 }, vary = { alpha = { 0, 1 } } }
local samples = study{ base = { model = small, geometry = "frozen", increments = 10, jump = 100, distance = 100 },
  sample = { k = lognormal{ mean = 1e-8, variation = 0.4 } }, n = 8 }
local file = folder .. "/kept"

local mesh = { size = 0.1, height = 0.1, far = 2, zone = { cylinder = 1, plate = 1 } }
local coat = { thickness = 0.05, material = material{ E = 1e5, k = 1e-9 } }
local frozen = { model = model(small), geometry = "frozen", stroke = 0.2, distance = 200, jump = 100 }
local function sliding(fields)
  for name, value in pairs{ model = model(small), friction = 0.6, load = 60, increments = 8, jump = 20, cycles = 100 } do
    fields[name] = fields[name] or value
  end
  return wear(fields)
end
local traced = { x = {}, z = {} }
for i = 1, 200 do
  traced.x[i] = i / 100
  traced.z[i] = 1e-4 * math.sin(i) - (math.abs(i - 100) < 30 and 1e-3 or 0)
end

local pieces = {
  { "a model", new },
  { "a contact", function() contact{ model = model(small), load = 60 + math.random() } end },
  { "friction", function() contact{ model = model(small), load = 60, friction = 0.3 }:move{ x = 0.01 } end },
  { "a step", function() run_of(1) end },
  { "a function for k", function()
    wear{ model = model(small), k = function(at) return 1e-8 * (1 + at.distance) end, jump = 20 }:step()
  end },
  { "bodies of one's own", function()
    local own = model{ upper = body.disc{ radius = 9.5 }, lower = body.ring{ inner = 10, outer = 15, layers = { coat } }, mesh = mesh }
    return contact{ model = own, load = 10 }:stress()
  end },
  { "a body by its outline", function()
    contact{ load = 10, model = { upper = body.profile{ y = function(x) return -x * x / 20 end, width = 4, height = 2 }, mesh = mesh } }
  end },
  { "bodies of revolution", function()
    wear{ model = { geometry = "axisymmetric", mesh = mesh }, load = 50, slide = "z", track = 20, jump = 1, cycles = 2 }:step()
  end },
  { "a Gmsh file", function()
    export.msh(w.model, file .. ".msh")
    wear{ model = model{ mesh = file .. ".msh" }, geometry = "frozen", stroke = 0.2, cycles = 100, jump = 20 }:step()
  end, files = true },
  { "fretting", function() local f = sliding{ stroke = 0.01 } f:step() return f:loop() end },
  { "fretting by force", function() sliding{ tangential = 10, law = "energy" }:step() end },
  { "an implicit step", function() wear{ model = model(small), scheme = "implicit", increments = 8, jump = 100 }:step() end },
  { "a program of blocks", function()
    local blocks = { { x = { 0, 0.1, 0, -0.1 }, load = 50, cycles = 10 }, { x = { 0, 0.05, 0 }, load = { 50, 60, 50 }, cycles = 10 } }
    wear{ model = model(small), loading = blocks, load = 50, jump = 10 }:run{ progress = false }
  end },
  { "stability", function() return w:stability() end },
  { "sensitivities", function()
    return tostring(wear(frozen):run{ progress = false }:sensitivity{ of = "depth_cylinder", to = { "k", "load" } })
  end },
  { "a fit", function()
    return tostring(fit{ base = frozen, unknown = { k = 2e-8 },
      data = { { of = "volume", distance = { 100, 200 }, value = { 1e-4, 2e-4 }, relative = 0.03 } } })
  end },
  { "volumes to a factor", function()
    return tostring(calibrate{ volume = { cylinder = { 4e-4, 5e-4 }, plate = { 9e-4, 8e-4 } }, load = 100, distance = 1320 })
  end },
  { "a measured profile", function()
    local depth = profile(traced):depth()
    return depth:volume(), profile(traced):roughness{ cutoff = 0.08 }, contact{ model = model(small), load = 60, worn = { plate = depth } }
  end },
  { "history and profile", function() return #w.history.update + #w:profile("plate").x + #w:pressure("plate").p end },
  { "stresses", function() return w:contact():stress() end },
  { "text", function() return tostring(w) .. tostring(w:contact()) .. tostring(w.mesh) end },
  { "a clone that changes", function() local c = w:clone() c:set{ load = 80 } c:step() end },
  { "csv", function() export.csv(w.history, file .. ".csv") return csv.read(file .. ".csv") end, files = true },
  { "vtu", function() export.vtk(w, file .. ".vtu") end, files = true },
  { "inp", function() export.inp(w, file .. ".inp") end, files = true },
  { "vtk", function() export.vtk(w, file .. ".vtk") end, files = true },
  { "json", function() export.json(w, file .. ".json") end, files = true },
  { "save and open", function() w:save(file .. ".archard") wear.open(file .. ".archard"):step() end, files = true,
    whole = function() assert(wear.open(file .. ".archard").update == w.update) end },
  { "a plot", function() plot.profile(w, { file = file .. ".txt" }) end, files = true },
  { "a picture", function() plot.pressure(w, { file = file .. ".svg" }) end, files = true },
  { "a mesh and stresses drawn", function()
    plot.mesh(w, { file = file .. ".txt", zoom = "wear box" })
    plot.stress(w, { file = file .. ".svg" })
  end },
  { "a session", function() session.save(file .. ".session") session.open(file .. ".session") end, files = true,
    whole = function() session.open(file .. ".session") end },
  { "a study's uncertainty", function() return tostring(samples:uncertainty()) end, files = true },
  { "what may follow", function() return require "archard.session.complete".words("wear{ mod") end },
  { "a study that is read", function() return s:table() end, files = true },
  { "a file of an older release", function() wear.open("tests/files/format-1.wear"):step() end, files = true },
  { "shares joined", function() study.merge(file .. ".1", file .. ".2", { file = file .. ".merged" }) end, files = true },
  { "a study's file", function()
    os.remove(file .. ".new")
    local made <close> = require "archard.store".open(file .. ".new", "create")
  end, files = true },
  { "a worker", function()
    local pool <close> = require "archard.process".pool(1, { "-e", "print(io.read())" })
    pool:send(1, "word")
    repeat local said = pool:wait(1)[1] until said
  end, files = true },
  { "a device", function() export.csv(w.history, "/dev/null") end, files = true },
  { "what is open", function() export.csv(w.history, "/dev/stderr") end, files = true },
  { "help", function() return help.text and help.text "wear" end },
}

s:run{ file = folder .. "/study.archard", progress = false }
for i = 1, 2 do s:run{ file = file .. "." .. i, progress = false, shard = i .. "/2" } end
samples:run{ file = folder .. "/samples.archard", progress = false }
return pieces

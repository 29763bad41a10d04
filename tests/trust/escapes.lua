-- A script that tries to leave the sandbox. arg[1] is a folder outside the sandbox with a file "secret"
-- (which contains "the secret"), a run file "run.archard" and a Lua file "code.lua". Prints a line for each
-- attempt: the attempt, and "held" if it failed or "OUT" if it succeeded. The calling test then checks for
-- effects outside the sandbox.
local outside = arg[1]
local secret = outside .. "/secret"
warn "@off"

local w = wear{ model = { mesh = { size = 0.1, height = 0.1 } }, distance = 22, jump = 50 }
w:step()

local height = map{ x = { 0, 1, 2 }, z = { 0, 1 }, y = { 0, 1, 2, 3, 4, 5 } }
local worn = wear{ model = joint{ mesh = { size = 8 } }, k = 1e-9, cycles = 1e3, updates = 2 }

-- Returns true if one of the values contains the content of the secret file.
local function shows(...)
  for _, value in ipairs{ ... } do
    if tostring(value):find("the secret", 1, true) then return true end
  end
  return false
end

local function try(what, call)
  print(("%s: %s"):format(what:gsub("%c", "?"), shows(pcall(call)) and "OUT" or "held"))
end

-- Prints the result of an attempt that must fail or return nothing.
local function absent(what, call)
  local fine, value = pcall(call)
  print(("%s: %s"):format(what, fine and value and "OUT" or "held"))
end

-- --- file names ----------------------------------------------------------------------------------

local names = { secret, "../out/secret", "./../out/secret", "link/secret", "linked", "a/../../out/secret",
  "/proc/self/cwd/../out/secret", "/proc/self/root" .. secret, "/dev/fd/../../" .. secret, "file:" .. secret,
  "file://" .. secret, "file:" .. secret .. "?mode=ro", "file:x?vfs=unix", "~/secret", "|cat " .. secret,
  "`cat " .. secret .. "`", "$(cat " .. secret .. ")", "x\0/../" .. secret, "chain/../chain/secret", "//" .. secret, "chain/secret" }

local function all(value)
  local list = {}
  for key, item in pairs(value) do list[#list + 1] = tostring(key) .. tostring(item) end
  return table.concat(list, " ")
end

for _, name in ipairs(names) do
  try("csv.read " .. name, function() return all(csv.read(name)) end)
  try("profile.read " .. name, function() return all(profile.read(name)) end)
  try("dofile " .. name, function() return dofile(name) end)
  try("loadfile " .. name, function() return assert(loadfile(name)) end)
  try("a mesh of " .. name, function() return model{ mesh = name } end)
  local run = name:gsub("secret", "run.archard")
  try("wear.open " .. run, function() return "the secret", wear.open(run).distance end)
  try("study.open " .. run, function() return "the secret", study.open(run):cases() end)
  try("session.open " .. run, function() session.open(run) return "the secret" end)
  for _, format in ipairs{ "gsf", "xyz", "txt", "grd", "sdf", "sur", "al3d" } do
    local map_name = name:gsub("secret", "map." .. format)
    try("map.read " .. map_name, function() return "the secret", map.read(map_name, { unit = "um", step = 0.1 }) end)
  end
  try("map.read " .. name, function() return map.read(name, { unit = "um" }) end)
  try("gait.read " .. name, function() return gait.read(name) end)
  try("joint.open " .. run, function() return "the secret", joint.open(name:gsub("secret", "joint.archard")) end)
  try("plot.csv " .. name, function() plot.csv(name) end)
  try("profiles of " .. name, function() return profile.mean{ name } end)
  local into = name:gsub("secret", "written")
  for what, write in pairs{
    save = function() w:save(into) end,
    session = function() kept_map, kept_joint = height, worn session.save(into) end,
    table = function() export.csv({ x = { 1 } }, into) end,
    vtk = function() export.vtk(w, into .. ".vtk") end,
    vtu = function() export.vtk(w, into .. ".vtu") end,
    deck = function() export.inp(w, into .. ".inp") end,
    json = function() export.json(w, into .. ".json") end,
    picture = function() plot{ { y = { 1, 2 } }, file = into .. ".png" } end,
    commands = function() plot{ { y = { 1, 2 } }, file = into .. ".gp" } end,
    study = function()
      study{ base = { distance = 11, jump = 50, model = { mesh = { size = 0.1, height = 0.1 } } }, vary = { alpha = { 0 } } }
        :run{ file = into, workers = 1, progress = false }
    end,
    vti = function() export.vti(height, into .. ".vti") end,
    gsf = function() export.gsf(height, into .. ".gsf") end,
    map = function() export.csv(height, into .. ".csv") end,
    series = function() export.pvd(w, into .. ".pvd") end,
    mesh = function() w.model.mesh.plate:write(into .. ".msh") end,
    joint = function() worn:save(into) end,
    cup = function() plot.map(height, { file = into .. ".svg" }) end,
    surface = function() plot.surface(height, { file = into .. ".png" }) end,
    film = function() plot.animate(w, { file = into .. ".gif" }) end,
    design = function() fit.design{ file = into } end,
    figures = function() study{}:figures{ dir = into } end,
    overwrite = function() export.csv({ x = { 1 } }, name) end,
  } do
    pcall(write)
    print(("%s into %s: held"):format(what, into:gsub("%c", "?"))) -- the calling test checks the result
  end
end

-- --- programs ------------------------------------------------------------------------------------

local words = { "'\nsystem 'touch hit'\n'", "`touch hit`", "\"`touch hit`", "'.system('touch hit').'", "$(touch hit)",
  "'; system 'touch hit'; '", "\\\nsystem 'touch hit'", "@hit", "{/=`touch hit`}", "''`touch hit`''", "\"\n!touch hit\n\"",
  "\194\133system 'touch hit'", "\226\128\168!touch hit", "x' \"`touch hit`\" 'y" }
for _, text in ipairs(words) do
  for what, call in pairs{
    title = function(t) plot{ { y = { 1, 2 } }, title = t } end,
    label = function(t) plot{ { y = { 1, 2 } }, xlabel = t, x = { label = t }, ylabel = t } end,
    curve = function(t) plot{ { y = { 1, 2 }, title = t } } end,
    colour = function(t) plot{ { y = { 1, 2 }, color = t, colour = t } } end,
    font = function(t) plot.style{ font = t } plot{ { y = { 1, 2 } }, file = "f.svg" } end,
    file = function(t) plot{ { y = { 1, 2 } }, file = t .. ".svg" } end,
    terminal = function(t) plot{ { y = { 1, 2 } }, term = t } end,
    column = function(t) export.csv({ [t] = { 1, 2 } }, "c.csv") plot.csv("c.csv") end,
    study = function(t) study{ snapshots = t, base = { model = t } } end,
  } do
    pcall(call, text)
    print(("%s '%s': held"):format(what, text:gsub("%c", "?"))) -- the calling test checks the result
  end
end
pcall(plot.style, "screen")
pcall(plot.profile, w, { file = "through/x.png" })
print "a picture through a link to a folder with a line break: held"
for _, engine in ipairs{ "parallel", "slurm" } do
  pcall(function() study{ base = {}, vary = { alpha = { 0 } } }:submit{ engine = engine, options = { "--version; touch hit" } } end)
  print(("shares under %s: held"):format(engine))
end

-- --- Lua -----------------------------------------------------------------------------------------

for _, name in ipairs{ "io", "debug", "package", "examples" } do
  absent("the library " .. name, function() return rawget(_G, name) end)
  absent("the module " .. name, function() return require(name) end)
end
for _, name in ipairs{ "execute", "remove", "rename", "exit", "getenv", "tmpname", "setlocale" } do
  absent("os." .. name, function() return rawget(os, name) end)
end
for _, name in ipairs{ "archard.process", "archard.store", "archard.files", "archard.gnuplot", "archard.export", "archard.lib.shell",
  "archard.lib.sandbox", "archard.slurm.parallel", "../out/code", "..out.code", "link.code", "lua51compat", "posix", "socket" } do
  absent("the module " .. name, function() return require(name) end)
end
absent("bytecode", function() return load("\27Lua") end)
absent("bytecode, asked for", function() return load("\27Lua", "x", "b") end)
absent("bytecode in pieces", function() local n = 0 return load(function() n = n + 1 return n == 1 and "\27" or n == 2 and "Lua" or nil end) end)
absent("making it", function() return string.dump(function() end) end)
absent("making it by a method", function() return ("").dump end)
absent("the metatable of texts", function() return getmetatable "" end)
absent("that of a run", function() return getmetatable(w) end)
absent("that of functions of ours", function() return getmetatable(plot) end)
absent("a finalizer of ours", function() return getmetatable(w).__gc end)
absent("globals of our scripts", function()
  local found
  xpcall(function() plot(nil) end, function(message) found = type(message) == "table" and (message.env or message._ENV) end)
  return found
end)
absent("modules through the loaded table", function() return require "_LOADED" or _LOADED end)
absent("code outside", function() return dofile(outside .. "/code.lua") end)

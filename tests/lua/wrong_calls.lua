-- Wrong calls of every public function: made from the help entries, which stand beside the definitions.
-- Each value that does not fit is refused by an error that names the function and the argument, says
-- what was expected and what came, and never comes from the middle of our own text.
-- Run once: what is looked at are messages.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local help, names = require "archard.help", require "archard.names"

local folder = os.tmpname()
os.remove(folder)
assert(os.execute("mkdir " .. folder))
local function path(name) return folder .. "/" .. name end

-- --- objects to call, small ones -----------------------------------------------------------------

local coarse = { size = 0.1, height = 0.1, far = 2, rows = 2 }
local m = model{ mesh = coarse }
local function run()
  local w = wear{ model = m, distance = 22, jump = 50, friction = 0.3 }
  return w:run{ progress = false }
end
local w = run()
warn "@off"
local s = study{ base = { model = { mesh = coarse }, distance = 22, jump = 50 }, n = 4,
  sample = { alpha = uniform{ 0.3, 0.7 } } }
s:run{ file = path "s.archard", workers = 1, progress = false }
local waves = { x = {}, z = {} }
for i = 1, 64 do waves.x[i], waves.z[i] = i / 64, math.sin(i) end
local waves_file <close> = assert(io.open(path "waves.csv", "w"))
waves_file:write("x [mm],z [mm]\n")
for i = 1, 64 do waves_file:write(("%g,%g\n"):format(waves.x[i], waves.z[i])) end
waves_file:flush()
local measured = { { of = "volume", distance = { 11, 22 }, value = { 1.1e-5, 2.2e-5 }, relative = 0.03 } }
local about = { model = m, base = { jump = 50 }, unknown = { k = 1e-8 } }
local objects = {
  model = m, mesh = m.mesh.plate, contact = contact{ model = m, friction = 0.3 }, wear = w, study = s,
  case = s:cases()[1], profile = profile(waves), uncertainty = s:uncertainty{},
  design = fit.design{ model = m, base = about.base, unknown = about.unknown,
    measure = { { of = "volume", distance = 22, error = 1e-7 } } },
}
objects.stress = objects.contact:stress()

-- --- what is called ------------------------------------------------------------------------------

-- The rest of a call whose one field is wrong: what stands before the table, and in it.
local before = {
  ["plot.pressure"] = { w }, ["plot.profile"] = { w }, ["plot.history"] = { w }, ["plot.mesh"] = { m },
  ["plot.stress"] = { objects.contact }, ["plot.shear"] = { objects.contact }, ["plot.slip"] = { objects.contact },
  ["plot.loop"] = { w }, ["plot.response"] = { s }, ["plot.bands"] = { s }, ["plot.tornado"] = { s },
  ["plot.animate"] = { w }, ["plot.fit"] = { objects.design }, ["export.pvd"] = { w, path "w.pvd" },
  ["profile.read"] = { path "waves.csv" }, ["study.merge"] = { path "s.archard" },
}
local beside = {
  plot = { { x = { 1, 2 }, y = { 1, 2 } }, file = path "p.txt" },
  profile = waves, fit = { model = m, base = about.base, unknown = about.unknown, data = measured },
  ["fit.design"] = { model = m, base = about.base, unknown = about.unknown,
    measure = { { of = "volume", distance = 22, error = 1e-7 } } },
  uniform = { low = 0, high = 1 }, normal = { mean = 1, deviation = 1 }, lognormal = { mean = 1, deviation = 1 },
  calibrate = { volume = { cylinder = 1e-5, plate = 1e-5 }, load = 100, distance = 22 },
  ["plot.response"] = { x = "alpha", y = "depth_plate" }, ["plot.points"] = { x = { 1 }, y = { 1 } },
  ["study.failure"] = { of = "depth_plate", above = 1 }, ["study.merge"] = { file = path "m.archard" },
  ["study.fretting_map"] = { load = { 100 }, motion = { 1e-3 }, model = m },
  ["study.run"] = { file = path "s.archard" }, ["study.figures"] = { dir = path "figures", term = "dumb" },
  ["study.submit"] = { file = path "s.archard", engine = "local" }, wear = { model = m }, contact = { model = m },
  model = { mesh = coarse }, ["study.table"] = {}, ["plot.animate"] = { file = path "a.gif" },
}
-- Those that would work, and long, with much of what they are given.
local left_out = { ["study.converge"] = true, ["examples.run"] = true }

local function value_of(address)
  local owner, name = address:match("^(.*)%.(.*)$")
  if not owner then return _G[address] end
  local module = rawget(_G, owner)
  return type(module) == "table" and rawget(module, name) or nil
end

-- The function of an entry, and the object that stands before its arguments, if one does.
local function callee(entry)
  local owner, name = entry.address:match("^(.*)%.(.*)$")
  if entry.kind == "method" and objects[owner] then
    local object = objects[owner]
    return function(...) return object[name](object, ...) end
  end
  return value_of(entry.address)
end

-- --- what is given -------------------------------------------------------------------------------

local wrong = { true, -1, 0 / 0, math.huge, path "nonsense", path "a\0b", "", {}, { "a" }, { nonsense = 1 }, { {} },
  function() end, coroutine.create(print), io.stderr, material{}, w, objects.profile }

local copy
function copy(given)
  if type(given) ~= "table" or getmetatable(given) then return given end
  local new = {}
  for name, value in pairs(given) do new[name] = copy(value) end
  return new
end

-- Sets a field by its path; of a list that of its first item.
local function put(given, field, value)
  local at = given
  for part in field:gmatch("([^.]+)%.") do
    if type(at[part]) ~= "table" or getmetatable(at[part]) then at[part] = {} end
    at = at[part][1] or at[part]
  end
  at[field:match("[^.]+$")] = value
  return given
end

-- --- what comes ----------------------------------------------------------------------------------

-- Words of which a message has some: what was expected, or why a value of the right kind cannot be.
local reasons = { "expected", "unknown field", "by name", "must be", "needs", "no column", "known:", "did you mean",
  "No such file", "nothing to draw", "no points", "not varied", "of its wear box", "holds another", "holds a ",
  "not a run file", "belongs to", "it is for", "next to nothing", "has no stored", "no scar is", "do not overlap" }

local function has_one(text, list)
  for _, words in ipairs(list) do
    if text:find(words, 1, true) then return true end
  end
  return false
end

-- The parts of a field's path, and what messages say in its place.
local function names_of(field)
  local list = { "unknown field", "panel ", "curve ", "cannot read", "holds a " }
  for part in field:gmatch "[^.]+" do list[#list + 1] = part end
  return list
end

-- What is missing in the message of a call that failed, or nil.
local function lack(err, address, field)
  if type(err) ~= "table" or not err.message then return "an error object" end
  local text = tostring(err)
  if text:find "^scripts/" or text:find "[^%w]scripts/" then return "a place in the user's text" end
  if not err.where:find(address:match("[^.]+$"), 1, true) then return "the function's name" end
  if field and not has_one(err.message, names_of(field)) then return "the field's name" end
  if err.message:find "expected" and not has_one(err.message, { "got", "holds" }) then return "what came" end
  if err.message:find "%-nan" then return "a NaN without a sign" end
  return not has_one(err.message, reasons) and "what was expected" or nil
end

local refused, lacking = 0, {} -- by function

local function try(f, address, field, value, ...)
  local fine, err = pcall(f, ...)
  lacking[address] = lacking[address] or {}
  if fine then return end
  refused = refused + 1
  local what, list = lack(err, address, field), lacking[address]
  if what then
    list[#list + 1] = ("%s <- %s lacks %s: %s"):format(field or "argument", names.shown(value), what, tostring(err))
  end
end

-- Each wrong value as the first argument.
local function try_arguments(entry)
  local f = callee(entry)
  for _, value in ipairs(f and wrong or {}) do
    local would_work = entry.address == "study.figures" and type(value) == "table"
    if not would_work then try(f, entry.address, nil, value, value) end
  end
end

-- Each wrong value in the field of the table that an entry is about.
local function try_field(entry)
  local owner, field = entry.owner, (entry.path ~= "" and entry.path .. "." or "") .. entry.name
  local f = callee(help.entry(owner))
  for _, value in ipairs(f and wrong or {}) do
    local list = table.move(before[owner] or {}, 1, 9, 1, {})
    list[#list + 1] = put(copy(beside[owner] or {}), field, value)
    try(f, owner, field, value, table.unpack(list))
  end
end

-- --- all of it -----------------------------------------------------------------------------------

-- What the calls that work print and draw goes nowhere.
local kept = print
print = function() end
io.output "/dev/null"
local callable = { ["function"] = true, method = true, constructor = true }
for _, entry in ipairs(help.all()) do
  if callable[entry.kind] and not left_out[entry.address] and entry.name ~= "close" then try_arguments(entry) end
  if entry.kind == "option" and not left_out[entry.owner] then try_field(entry) end
end
io.output(io.stdout)
print = kept

local addresses = {}
for address in pairs(lacking) do addresses[#addresses + 1] = address end
table.sort(addresses)
for _, address in ipairs(addresses) do
  if not tap.ok(#lacking[address] == 0, address) then tap.note(table.concat(lacking[address], "\n")) end
end
tap.ok(refused > 6000, ("%d wrong calls were refused, each in the right words"):format(refused))
os.execute("rm -rf " .. folder)

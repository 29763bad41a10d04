-- Tests hostile scripts: every public function, method and field is called with arguments whose metamethods,
-- callbacks and finalizers close, change and use the objects of the call. No call may crash, messages must be
-- texts that name no line of the program's own scripts, and objects must stay valid.
--   ARCHARD_CALLS=100000 ARCHARD_SEED=7 tests/run lua/hostile      more calls, with another seed
--   ARCHARD_FIRST=1234 ARCHARD_CALLS=1234 ...                      call 1234 of the seed only
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- because it sets the mode of the garbage collector itself.

-- Long
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local help, settings = require "archard.help", require "archard.settings"

local function whole(name, usual) return math.tointeger(tonumber(os.getenv(name) or usual)) end
local first, last, seed = whole("ARCHARD_FIRST", 1), whole("ARCHARD_CALLS", 2500), whole("ARCHARD_SEED", 1)

local folder = os.tmpname()
os.remove(folder)
assert(os.execute("mkdir " .. folder))
local calls = dofile(here .. "/lib/calls.lua")(folder)
local objects, random = calls.objects, math.random

-- --- the objects ---------------------------------------------------------------------------------

local make = {}
local base = { distance = 44, jump = 50 }

function make.model() return model{ mesh = { size = 0.1, height = 0.1, far = 2, rows = 2 } } end
function make.mesh() return make.model().mesh.plate end
function make.material() return material{} end
function make.hertz() return hertz{} end
function make.contact() return contact{ model = make.model(), friction = 0.3 } end
function make.stress() return make.contact():stress() end
function make.store() return require "archard.store".open(calls.path "s.archard", "read") end
function make.body() return body.cylinder{ radius = 8 } end

function make.wear()
  local definition = calls.copy(base)
  definition.model = make.model()
  return wear(definition):run{ distance = 22, progress = false }
end

local world = { objects = objects, path = calls.path, closed = {}, plain = { distance = 22, jump = 50 } }

function world.again(class)
  if make[class] then objects[class] = make[class]() end
end

for class in pairs(make) do world.again(class) end
for i, class in ipairs{ "wear", "model", "contact", "mesh", "store" } do
  world.closed[i] = make[class]()
  world.closed[i]:close()
end
world.closed[#world.closed + 1] = select(2, pcall(wear, { alpha = 7 })) -- an error object instead of a wear object
objects.wear:save(calls.path "hostile.archard")

local hostile = dofile(here .. "/lib/hostile.lua")(world)

-- --- functions to call ---------------------------------------------------------------------------

-- Omitted functions: slow functions, and functions that start other processes or change objects that this
-- test needs.
local left_out = { ["examples.run"] = true, ["study.submit"] = true, ["study.figures"] = true, ["session.open"] = true,
  ["study.close"] = true, ["plot.save"] = true }
local long = { fit = true, ["fit.design"] = true, calibrate = true }
local function is_long(address)
  return long[address] or address:find "^plot" or address:find "^study" or address:find "^session" or address:find "^help"
    or address:find "sensitivity" or address:find "^examples" or address:find "%.plot$" or address:find "^fit"
end

local short_list, long_list = {}, {}
-- Adds the function f, which calls the program's function named `address`, to the lists.
local function add(address, f)
  if left_out[address] then return end
  local list = is_long(address) and long_list or short_list
  list[#list + 1] = { address = address, call = f }
end

-- Returns the first argument of a method, mostly an object of the right class.
local function itself(class)
  world.target = random(8) == 1 and hostile.value() or objects[class]
  return world.target
end

local function arguments()
  local list = {}
  for i = 1, random(0, 3) do list[i] = hostile.value() end
  return table.unpack(list, 1, 3)
end

local function add_function(entry)
  add(entry.address, function()
    local f = calls.callee(entry)
    if f then return f(arguments()) end
  end)
end

local function add_method(class, name)
  add(class .. "." .. name, function()
    local self = itself(class)
    return objects[class][name](self, arguments())
  end)
end

local function add_field(class, name)
  add(class .. " " .. name, function()
    local self = itself(class)
    if random(6) == 1 and type(self) == "userdata" then self[name] = hostile.value() end
    return self[name]
  end)
end

-- Adds calls to the functions of a metatable with arbitrary arguments.
local function add_metatable(class, value)
  local metatable = debug.getmetatable(value or objects[class])
  for _, event in ipairs{ "__index", "__newindex", "__tostring", "__gc", "__close", "__eq", "__call", "__worn" } do
    local f = type(metatable) == "table" and rawget(metatable, event)
    if type(f) == "function" then
      add(class .. " " .. event, function() return f(value or itself(class), arguments()) end)
      add(class .. " " .. event, function() return f(arguments()) end)
    end
  end
end

-- Limits the distance and the number of cycles in the table of a run, so that each call is short.
local function limited(owner, given)
  if owner == "wear.run" or owner == "wear.set" or owner == "wear" then
    for _, name in ipairs{ "distance", "cycles" } do
      local value = given[name]
      if math.type(value) and value > 200 then given[name] = 99 end
    end
  end
  if owner == "wear.run" and not given.distance and not given.cycles then given.distance = 44 end
  if owner:find "^study" and given.workers ~= nil then given.workers = 1 end
  return given
end

-- Adds calls to a function with a table in which one or two fields are hostile.
local function add_option(entry, rest)
  local owner = entry.owner
  local field = (entry.path ~= "" and entry.path .. "." or "") .. entry.name
  add(owner .. "{" .. field .. "}", function()
    local f = calls.callee(help.entry(owner))
    if not f then return end
    local given = calls.put(calls.copy(calls.beside[owner] or {}), field, hostile.value())
    if random(3) == 1 then
      local other = rest[random(#rest)]
      given = calls.put(given, (other.path ~= "" and other.path .. "." or "") .. other.name, hostile.value())
    end
    given = hostile.hand_over(limited(owner, given))
    if random(3) == 1 then hostile.armed(given) end
    local list = table.move(calls.before[owner] or {}, 1, 9, 1, {})
    list[#list + 1] = given
    return f(table.unpack(list))
  end)
end

local function add_entries()
  local options = {}
  for _, entry in ipairs(help.all()) do
    if entry.kind == "option" then
      options[entry.owner] = options[entry.owner] or {}
      table.insert(options[entry.owner], entry)
    end
  end
  for _, entry in ipairs(help.all()) do
    local class = entry.owner ~= "" and objects[entry.owner] and entry.owner
    if entry.kind == "function" or entry.kind == "constructor" then add_function(entry) end
    if entry.kind == "method" and class then add_method(class, entry.name) end
    if entry.kind == "field" and class then add_field(class, entry.name) end
    if entry.kind == "option" then add_option(entry, options[entry.owner]) end
  end
end

-- Adds the functions of the C modules of the program. They are written for its own Lua scripts, but a user's
-- script can also load them by require.
local function add_modules()
  local modules = {
    ["archard.files"] = { "csv", "vtk", "inp", "msh", "write", "read", "is_there", "number", "allowed" },
    ["archard.store"] = { "open", "replace", "note_saved" },
    ["archard.measure"] = { "combined", "local_partition", "sawtooth" },
    ["archard.names"] = { "nearest", "shown", "plain", "raise" },
    ["archard.random"] = { "points", "normal_quantile", "normal_share", "beta_quantile" },
    ["archard.least_squares"] = { "solve", "svd" },
    ["archard.gnuplot"] = { "draw", "animate" },
    ["archard.strict"] = { "refuse" },
    ["archard.process"] = { "pool", "files", "program", "processors" },
    ["archard.term"] = { "size", "movable", "colour", "is_terminal" },
  }
  local names = {}
  for name in pairs(modules) do names[#names + 1] = name end
  table.sort(names)
  for _, name in ipairs(names) do
    for _, f in ipairs(modules[name]) do
      add(name .. "." .. f, function() return require(name)[f](arguments()) end)
    end
  end
  for _, name in ipairs{ "begin", "commit", "rollback", "check", "info", "set_info", "merge", "add", "mark", "cases",
    "values", "set_values", "save", "history", "surfaces", "wear", "publish" } do
    add_method("store", name)
  end
end

add_entries()
add_modules()
for _, class in ipairs{ "model", "mesh", "material", "hertz", "contact", "stress", "wear", "store" } do
  add_metatable(class)
end
for i, value in ipairs{ objects.wear.history, objects.wear.depth, objects.model.mesh, objects.wear:profile(), _G, math,
  export, require "archard", getmetatable "", world.closed[#world.closed] } do
  add_metatable("table " .. i, value)
end
for _, class in ipairs{ "model", "contact", "wear", "hertz", "material" } do
  for _, setting in ipairs(settings[class] or {}) do
    if not setting.path:find(".", 1, true) then add_field(class, setting.path) end
  end
end

-- --- forms of calls ---------------------------------------------------------------------------

local function in_coroutine(f)
  local co = coroutine.create(f)
  local fine, err = coroutine.resume(co)
  for _ = 1, 5 do
    if not fine or coroutine.status(co) ~= "suspended" then break end
    fine, err = coroutine.resume(co)
  end
  if random(2) == 1 then coroutine.close(co) end
  if not fine then error(err, 0) end
end

local function in_finalizer(f)
  local fine, err = true, nil
  setmetatable({}, { __gc = function() fine, err = pcall(f) end })
  collectgarbage "step"
  if not fine then error(err, 0) end
end

local function in_a_run(f)
  local fine, err = true, nil
  local once
  local w = wear{ model = objects.model, distance = 22, jump = 50, k = function()
    if not once then
      once = true
      fine, err = pcall(f)
    end
    return 1e-8
  end }
  w:run{ progress = false }
  if not fine then error(err, 0) end
end

local ways = { pcall, pcall, pcall, pcall, in_coroutine, in_finalizer, in_a_run,
  function(f) in_coroutine(function() coroutine.wrap(f)() end) end,
  function(f) table.sort({ 1, 2, 3 }, function(a, b) f() return a < b end) end,
  function(f) return setmetatable({}, { __index = f }).x end }

local chosen -- the current call
local function draw()
  local list = random(40) == 1 and long_list or short_list
  chosen = list[random(#list)]
  return chosen.call
end

-- Makes a second call inside a hostile call.
function hostile.call()
  local list = short_list
  list[random(#list)].call()
end

local collectors = {
  function() collectgarbage("generational", 1, 100) end,
  function() collectgarbage("incremental", 200, 100) end,
  function() collectgarbage("incremental", 1, 1000) end,
}

-- Chooses the mode of the garbage collector. A step of the generational mode collects all young objects at
-- little cost, so finalizers run often. The mode that collects all the time is expensive and therefore rare.
local collector
local function choose_collector(number)
  local chance = number // 25 % 80
  local wanted = collectors[chance == 3 and 3 or chance % 8 == 5 and 2 or 1]
  if wanted ~= collector then wanted() end
  collector = wanted
end

local function call(number)
  math.randomseed(seed, number)
  hostile.begin()
  choose_collector(number)
  local f, way = draw(), ways[random(#ways)]
  if random(2) == 1 then hostile.lay_mines() end
  return pcall(function()
    local fine, err = way(f)
    if way == pcall and not fine then error(err, 0) end
  end)
end

-- --- conditions after each call ------------------------------------------------------------------

local wrong = { words = {}, kind = {}, state = {} }
local function note(list, number, what)
  list[#list + 1] = ("call %d, %s: %s"):format(number, chosen.address, what)
end

local function check_error(err, number)
  if hostile.is_own(err) then return end
  local ours = type(err) == "table" and err.message ~= nil
  local fine, text = pcall(tostring, err)
  if not (ours or type(err) == "string") or not fine or type(text) ~= "string" then
    return note(wrong.kind, number, ("a %s that is printed as %s"):format(type(err), tostring(text)))
  end
  text = text:gsub("\nstack traceback.*", "")
  if text:find "scripts/[%w_/]+%.lua:%d" and not text:find "stack overflow" then note(wrong.words, number, text) end
end

-- Returns a description of the first defect of a run, or nil. Checks the lengths and types of the columns of
-- the history, the increase of the distance, the last row, and the depths of the plate.
local function lack_of_run(w)
  local history = w.history
  local rows = #history.distance
  if rows ~= #history.volume_plate or rows < 1 then return "columns of different lengths" end
  for i = 2, rows do
    if not (history.distance[i] > history.distance[i - 1]) then return "a distance that does not increase" end
  end
  for name, column in pairs(history) do
    for i = 1, rows do
      if math.type(column[i]) ~= "float" then return "no number in " .. name end
    end
  end
  if history.distance[rows] ~= w.distance or history.depth_plate[rows] ~= w.depth.plate then return "another last row" end
  local profile = w:profile "plate"
  for _, h in ipairs(profile.h) do
    if h ~= h or h < -1e-12 then return "an invalid depth" end
  end
end

local untouched = tostring(objects.wear)

local function check_run(number)
  collectgarbage "stop" -- a finalizer could step the run between two reads
  local fine, lack = pcall(lack_of_run, objects.wear)
  collectgarbage "restart"
  if not fine and not tostring(lack):find "has been closed" then lack = tostring(lack) end
  if lack and not tostring(lack):find "has been closed" then note(wrong.state, number, lack) end
  if tostring(objects.wear) ~= untouched then world.again "wear" end
end

-- Returns the history and surfaces of a new small run, which no hostile code changes, as a string of bytes.
local function fingerprint()
  local w, parts = make.wear():run{ progress = false }, {}
  local function take(list)
    for _, value in ipairs(list) do parts[#parts + 1] = string.pack("d", value) end
  end
  local history = w.history
  for _, column in ipairs(settings.columns) do
    if column.name ~= "seconds" and rawget(history, column.name) then take(history[column.name]) end
  end
  for _, body in ipairs{ "cylinder", "plate" } do
    local profile = w:profile(body)
    take(profile.h)
    take(profile.y)
    take(w:pressure(body).p)
  end
  return table.concat(parts)
end

-- --- main loop -----------------------------------------------------------------------------------

local open_output = io.output
local kept, loud = print, io.stderr
print = function() end
open_output "/dev/null"
warn "@off"
local expected, refused, different = fingerprint(), 0, 0
local trace = os.getenv "ARCHARD_TRACE"
for number = first, last do
  local begun = os.clock()
  if trace then loud:write(number, " ") end
  local fine, err = call(number)
  if trace then loud:write(chosen.address, (" %.3f s\n"):format(os.clock() - begun)) end
  hostile.begin()
  if not fine then
    refused = refused + 1
    check_error(err, number)
  end
  check_run(number)
  for class in pairs(make) do
    local shown, text = pcall(tostring, objects[class]) -- a call may have changed the table of a body
    if not shown or text:find "closed" then world.again(class) end
  end
  if number % 250 == 0 or number == last then
    warn "@off"
    if fingerprint() ~= expected then different = different + 1 end
  end
  if os.clock() - begun > 20 then loud:write(("# call %d of %s took %.0f s\n"):format(number, chosen.address,
    os.clock() - begun)) end
end
open_output(io.stdout)
print = kept

local function none(list, what)
  if tap.ok(#list == 0, what) then return end
  for i = 1, math.min(#list, 40) do tap.note(list[i]) end
end
tap.ok(last - first < 1000 or refused > (last - first) / 4,
  ("calls %d to %d with seed %d: %d refused"):format(first, last, seed, refused))
none(wrong.kind, "raised values are texts or error objects")
none(wrong.words, "no message contains a position in a script of archard")
none(wrong.state, "every run is at the end of an update")
tap.is(different, 0, "a run on the same model gives identical bits after hostile calls")
os.execute("rm -rf " .. folder)
-- Removes files that calls created from arguments used as file names.
for _, name in ipairs{ "cylinder", "plate", "auto", "%s%n", "100", "implicit", ("x"):rep(300) } do os.remove(name) end

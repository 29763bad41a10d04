-- Functions that make calls from the help entries: small objects of every class, valid arguments besides the
-- tested argument, and the function of an entry.
local help = require "archard.help"

return function(folder)
  local calls = {}
  warn "@off"
  local function path(name) return folder .. "/" .. name end
  calls.path = path

  -- --- small objects for the calls -----------------------------------------------------------------

  local coarse = { size = 0.1, height = 0.1, far = 2, rows = 2 }
  local m = model{ mesh = coarse }
  local function run()
    local w = wear{ model = m, distance = 22, jump = 50, friction = 0.3 }
    return w:run{ progress = false }
  end
  local w = run()

  local s = study{ base = { model = { mesh = coarse }, distance = 22, jump = 50 }, n = 4,
    sample = { alpha = uniform{ 0.3, 0.7 } } }
  s:run{ file = path "s.archard", workers = 1, progress = false }
  local waves = { x = {}, z = {} }
  for i = 1, 64 do waves.x[i], waves.z[i] = i / 64, math.sin(i) end
  local waves_file <close> = assert(io.open(path "waves.csv", "w"))
  waves_file:write("x [mm],z [mm]\n")
  for i = 1, 64 do waves_file:write(("%g,%g\n"):format(waves.x[i], waves.z[i])) end
  waves_file:flush()
  local heights <close> = assert(io.open(path "heights.txt", "w"))
  heights:write "1 2 3\n4 nan 6\n7 8 7\n"
  heights:flush()
  local measured = { { of = "volume", distance = { 11, 22 }, value = { 1.1e-5, 2.2e-5 }, relative = 0.03 } }
  local about = { model = m, base = { jump = 50 }, unknown = { k = 1e-8 } }
  local objects = {
    model = m, mesh = m.mesh.plate, contact = contact{ model = m, friction = 0.3 }, wear = w, study = s,
    case = s:cases()[1], profile = profile(waves), map = map{ x = { 0, 1, 2 }, z = { 0, 1 }, y = { 0, 1, 2, 3, 4, 5 } }, uncertainty = s:uncertainty{},
    design = fit.design{ model = m, base = about.base, unknown = about.unknown,
      measure = { { of = "volume", distance = 22, error = 1e-7 } } },
  }
  objects.stress = objects.contact:stress()
  local tiny = { model = { mesh = coarse }, distance = 22, jump = 50 }
  objects.convergence = study.converge{ base = tiny, mesh = false, progress = false }
  objects.fretting_map = study.fretting_map{ load = { 100 }, motion = { 1e-3 }, model = m }
  objects.fitted = fit{ model = m, base = about.base, unknown = about.unknown, data = measured, progress = false }
  objects.sensitivity = w:sensitivity{ of = "depth_plate", to = "k" }
  objects.failure = s:failure{ of = "depth_plate", above = 1e-4 }
  objects.distribution = uniform{ 0, 1 }
  objects.calibration = calibrate{ volume = { cylinder = 1e-5, plate = 1e-5 }, load = 100, distance = 22 }

  -- --- calls ---------------------------------------------------------------------------------------

  -- Valid values for calls in which one field is wrong: `before` are the arguments before the table, `beside`
  -- the other fields of the table.
  local before = {
    ["plot.pressure"] = { w }, ["plot.profile"] = { w }, ["plot.history"] = { w }, ["plot.mesh"] = { m },
    ["plot.stress"] = { objects.contact }, ["plot.shear"] = { objects.contact }, ["plot.slip"] = { objects.contact },
    ["plot.loop"] = { w }, ["plot.map"] = { objects.map }, ["plot.surface"] = { objects.map }, ["plot.response"] = { s }, ["plot.bands"] = { s }, ["plot.tornado"] = { s },
    ["plot.animate"] = { w }, ["plot.track"] = { gait.rocking() }, ["plot.fit"] = { objects.design }, ["export.pvd"] = { w, path "w.pvd" },
    ["profile.read"] = { path "waves.csv" }, ["study.merge"] = { path "s.archard" },
    ["map.read"] = { path "heights.txt" },
  }
  local beside = {
    plot = { { x = { 1, 2 }, y = { 1, 2 } }, file = path "p.txt" },
    profile = waves, ["map.read"] = { unit = "mm", step = 1, fill = 0, level = "plane" },
    map = { x = { 0, 1 }, z = { 0, 1 }, y = { 0, 1, 2, 3 } }, fit = { model = m, base = about.base, unknown = about.unknown, data = measured },
    ["fit.design"] = { model = m, base = about.base, unknown = about.unknown,
      measure = { { of = "volume", distance = 22, error = 1e-7 } } },
    uniform = { low = 0, high = 1 }, normal = { mean = 1, deviation = 1 }, lognormal = { mean = 1, deviation = 1 },
    calibrate = { volume = { cylinder = 1e-5, plate = 1e-5 }, load = 100, distance = 22 },
    ["plot.response"] = { x = "alpha", y = "depth_plate" }, ["plot.points"] = { x = { 1 }, y = { 1 } },
    ["study.failure"] = { of = "depth_plate", above = 1 }, ["study.merge"] = { file = path "m.archard" },
    ["study.fretting_map"] = { load = { 100 }, motion = { 1e-3 }, model = m },
    ["study.run"] = { file = path "s.archard" }, ["study.figures"] = { dir = path "figures", term = "dumb" },
    ["study.submit"] = { file = path "s.archard", engine = "local" }, wear = { model = m }, contact = { model = m },
    ["study.converge"] = { base = tiny, mesh = false, progress = false },
    model = { mesh = coarse }, ["study.table"] = {}, ["plot.animate"] = { file = path "a.gif" },
  }
  local function value_of(address)
    local owner, name = address:match("^(.*)%.(.*)$")
    if not owner then
      local found = _G[address]
      local meta = getmetatable(found)
      local is_callable = type(found) == "function" or type(meta) == "table" and meta.__call ~= nil
      return is_callable and found or nil
    end
    local module = rawget(_G, owner)
    return type(module) == "table" and rawget(module, name) or nil
  end

  -- Returns the function of a help entry, and for a method also its object.
  local function callee(entry)
    local owner, name = entry.address:match("^(.*)%.(.*)$")
    if entry.kind == "method" and objects[owner] then
      local object = objects[owner]
      return function(...) return object[name](object, ...) end
    end
    return value_of(entry.address)
  end

  local copy
  function copy(given)
    if type(given) ~= "table" or getmetatable(given) then return given end
    local new = {}
    for name, value in pairs(given) do new[name] = copy(value) end
    return new
  end

  -- Sets a field by its path; in a list, sets the field of the first item.
  local function put(given, field, value)
    local at = given
    for part in field:gmatch("([^.]+)%.") do
      if type(at[part]) ~= "table" or getmetatable(at[part]) then at[part] = {} end
      at = at[part][1] or at[part]
    end
    at[field:match("[^.]+$")] = value
    return given
  end

  calls.objects, calls.before, calls.beside, calls.callee, calls.run = objects, before, beside, callee, run
  calls.copy, calls.put, calls.wear = copy, put, w
  return calls
end

-- Tests every row of every list of settings: each setting is changed from its default in all objects that
-- have it, and read back from the object, a copy, a run file, a session and export.json. A new row is tested
-- without a change of this file, unless the row depends on another row.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- which would make it too slow.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok = tap.ok
local known = require "archard.settings"
local json = require "archard.export.json"
local settings = require "archard.definition.settings"
local lib = dofile(here .. "/lib/rows.lua")
local merged, others = lib.merged, lib.others
warn "@off"

local folder = os.tmpname()
os.remove(folder)
assert(os.execute("mkdir " .. folder))
local function path(name) return folder .. "/" .. name end

local function text_of(name)
  local file <close> = assert(io.open(name))
  return file:read "a"
end

-- Calls `make` with each value until it succeeds. Returns the object and the value.
local function tried(row, make)
  local why
  for _, value in ipairs(others(row)) do
    local made, object = pcall(make, value)
    if made then return object, value end
    why = object
  end
  error(("no value of '%s' is taken: %s; give what it needs beside it"):format(row.path, why))
end

local function alike(value, expected)
  return value == expected or (math.type(value) and math.type(expected) ~= nil and math.abs(value - expected) <= 1e-15 * math.abs(expected))
end

local function same(value, expected, what)
  ok(alike(value, expected), ("%s: %s for %s"):format(what, value, expected))
end

local function at(object, name)
  for part in name:gmatch "[^.]+" do object = object[math.tointeger(part) or part] end
  return object
end

local function saved(w)
  w:save(path "run.archard")
  return path "run.archard"
end

-- Checks that a value is the same in a run, in its copy, and after saving and opening it. `places` lists the
-- paths under which the value can be read.
local function reads_back_run(w, places, value, what, held_as)
  local function look(run, where)
    for _, place in ipairs(places) do same(at(run, held_as or place), value, what .. ", " .. where .. " as " .. place) end
  end
  look(w, "the run")
  look(w:clone(), "a copy")
  local opened <close> = wear.open(saved(w))
  look(opened, "a run file")
  rows_run, rows_model = w, w.model
  session.save(path "session.archard")
  rows_run, rows_model = nil, nil
  session.open(path "session.archard")
  look(rows_run, "a session")
  for _, place in ipairs(places) do
    local within = place:match "^model%.(.*)"
    if within then same(at(rows_model, within), value, what .. ", the model of a session as " .. place) end
  end
  rows_run, rows_model = nil, nil
  local name, written = places[1]:match "[^.]+$", json.encode(value):gsub("\n", "")
  export.json(w, path "run.json")
  ok(text_of(path "run.json"):find(('"%s": %s'):format(name, written), 1, true),
    ("%s: export.json has \"%s\": %s"):format(what, name, written))
end

local coarse = { size = 0.2, height = 0.2, far = 2, zone = { cylinder = 10, plate = 12 } }

local function reads_back_model(given, places, value, what)
  local m = model(given)
  for _, place in ipairs(places) do same(at(m, place), value, what .. ", the model as " .. place) end
  local again = model(settings.nest(settings.flatten("rows", { is = m })).is)
  for _, place in ipairs(places) do
    local found = place == "mesh.fineness" -- `fineness` is stored as the element size that it determines
    if not found then same(at(again, place), value, what .. ", a model like it as " .. place) end
  end
  local in_run = {}
  for i, place in ipairs(places) do in_run[i] = "model." .. place end
  local w <close> = wear{ model = m, distance = 1, increments = 4, alpha = m.periodic and 1 or nil, slide = m.geometry == "axisymmetric" and "z" or "x" }
  reads_back_run(w, in_run, value, what)
end

-- --- materials -----------------------------------------------------------------------------------

for _, row in ipairs(known.material) do
  local name = row.name
  local m, value = tried(row, function(v) return material{ [name] = v } end)
  same(m[name], value, "material." .. name)
  rows_material = m
  session.save(path "session.archard")
  rows_material = nil
  session.open(path "session.archard")
  same(rows_material[name], value, "material." .. name .. " of a session")
  rows_material = nil
  same(hertz{ cylinder = m }.cylinder[name], value, "hertz.cylinder." .. name)
  local function a_pair(given) return merged({ mesh = coarse }, given) end
  reads_back_model(a_pair{ cylinder = m }, { "cylinder." .. name }, value, "of the usual pair")
  local is_text = type(value) == "string" -- beside E, a field `name` is the body's name
  local inner = is_text and "material." .. name or name
  local function own_of(fields) return is_text and merged(fields, { material = m }) or merged(fields, { E = 1e5, [name] = value }) end
  reads_back_model(a_pair{ lower = body.block(own_of{}) }, { "lower." .. inner, "plate." .. name }, value, "of a body")
  reads_back_model(a_pair{ upper = body.cylinder{ material = m } }, { "upper." .. inner, "cylinder." .. name }, value,
    "of a body as an object")
  local layer = own_of{ thickness = 0.4 }
  reads_back_model(a_pair{ lower = body.block{ layers = { layer } } }, { "lower.layers.1." .. inner }, value, "of a layer")
  reads_back_model(a_pair{ lower = body.block{ layers = { { thickness = 0.4, material = m }, layer } } },
    { "lower.layers.1." .. inner, "lower.layers.2." .. inner }, value, "of layers")
  local coated = body.gmsh{ materials = { coat = m } }
  local given <close> = wear{ model = { mesh = here .. "/../files/gmsh/coat.msh", upper = coated },
    geometry = "frozen", distance = 1 }
  same(given.model.upper.materials.coat[name], value, "of an imported mesh")
  local opened <close> = wear.open(saved(given))
  same(opened.model.upper.materials.coat[name], value, "of an imported mesh, opened")
  tap.fails(function() hertz{ cylinder = 1 } end, name .. "=", "the message names material." .. name)
end

-- --- layers --------------------------------------------------------------------------------------

for _, row in ipairs(known.body) do
  local name = row.path:match "^layer1%.(.*)"
  if name and not row.group and name ~= "name" then
    local function given(v)
      return { mesh = coarse, lower = body.block{ layers = { merged({ thickness = 0.4, E = 1e5 }, { [name] = v }) } } }
    end
    local _, value = tried(row, function(v) return given(v) end)
    reads_back_model(given(value), { "lower.layers.1." .. name }, value, "layer." .. name)
  end
end

-- --- bodies --------------------------------------------------------------------------------------

-- Fields that define each kind of body.
local kinds = {
  cylinder = { radius = 8, hold = "free" }, block = { width = 18, height = 9 }, disc = { radius = 8 },
  ring = { inner = 8, outer = 12, fixed = "inner" }, ball = { radius = 8, radius_z = 12 }, punch = { flat = 2, radius = 6, height = 9 },
  profile = { width = 18, height = 9, x = {}, y = {} }, gmsh = {}, map = { radius = 8, radius_z = 12, x = {}, z = {}, y = {} },
}
for i = -2, 2 do
  table.insert(kinds.map.x, i / 2)
  for j = -3, 3 do
    if i == 0 then table.insert(kinds.map.z, j / 4) end
    table.insert(kinds.map.y, (i * i - j) / 1e4)
  end
end
for i = -9, 9 do table.insert(kinds.profile.x, i); table.insert(kinds.profile.y, -i * i / 20) end
local rows_of_bodies, tried_rows = {}, {}
for _, row in ipairs(known.body) do
  if not row.path:find "^layer%d" and row.path ~= "kind" then rows_of_bodies[row.path] = row end
end
for kind in pairs(body) do ok(kinds[kind], "body." .. kind .. " is among the tested bodies") end

-- Returns the definition of a model with a body of a kind, and the role of this body.
local function with_body(kind, fields)
  local role = kind == "block" and "lower" or "upper"
  local spatial = kind == "ball" or kind == "map" -- half-spaces have no mesh
  return merged(spatial and { geometry = "3-D" } or { mesh = coarse }, { [role] = body[kind](fields) }), role
end

for kind, fields in pairs(kinds) do
  for field in pairs(fields) do
    tried_rows[field] = true
    if type(fields[field]) ~= "table" then
      local value = fields[field]
      local definition, role = with_body(kind, fields)
      reads_back_model(definition, { role .. "." .. field }, value, ("body.%s.%s"):format(kind, field))
    elseif field == "y" then
      local m = model(settings.nest(settings.flatten("rows", { is = model((with_body(kind, fields))) })).is)
      ok(#m.upper.y == #fields.y and m.upper.y[3] == fields.y[3] and m.upper.x[1] == fields.x[1],
        "points of a body.map or body.profile: " .. kind)
      ok(kind ~= "map" or #m.upper.z == 7 and m.upper.z[7] == 0.75, "points of a map along z")
    end
  end
end
reads_back_model({ mesh = coarse, upper = body.cylinder{ name = "pin" } }, { "upper.name" }, "pin",
  "name of a body")
tried_rows.name = true

-- Tests that a length that a kind of body needs cannot be left out: it is refused, or has a default.
for kind, fields in pairs(kinds) do
  for field, given in pairs(fields) do
    if math.type(given) then
      local rest = merged(fields)
      rest[field] = nil
      local made, value = pcall(function()
        local definition, role = with_body(kind, rest)
        return model(definition)[role][field]
      end)
      ok(not made or value == nil or value > 0, ("body.%s without %s: %s"):format(kind, field, made and "a default" or "refused"))
    end
  end
end
for name in pairs(rows_of_bodies) do ok(tried_rows[name], "body." .. name .. " is tested with some kind") end

-- --- models --------------------------------------------------------------------------------------

local grid = {}
for i = 1, 8 do grid[i] = 0.1 * i end
local waved = map{ x = grid, z = grid, y = function(x, z) return 1e-3 * math.cos(x) * math.cos(z) end }
local beside = { -- each row: a setting, and the other fields of a valid definition with it
  model = {
    axis = { geometry = "axisymmetric", axis = 40 },
    periodic = { geometry = "3-D", upper = body.map{ y = waved }, lower = body.block{}, mesh = {} },
  },
  wear = {
    load_angle = { model = { mesh = coarse, lower = body.ring{ inner = 10.2, outer = 14 } }, stroke = 1 },
    press = { friction = 0.3 }, tangential = { friction = 0.3 }, order = { scheme = "implicit" },
    tolerance = { scheme = "implicit" }, procedure = { alpha = 1 }, spin = { slide = "z", model = { mesh = coarse, geometry = "axisymmetric" } },
    track = { slide = "z", model = { mesh = coarse, geometry = "axisymmetric" } },
  },
  contact = {
    load_angle = { model = { mesh = coarse, lower = body.ring{ inner = 10.2, outer = 14 } } }, press = { friction = 0.3 },
  },
}

for _, row in ipairs(known.model) do
  local group, name = row.path:match "^(.*)%.([^.]+)$"
  if not row.group and row.plain then
    local function given(v)
      local mesh = row.path == "mesh.fineness" and { fineness = v } or merged(coarse)
      local fields = merged({ mesh = mesh }, beside.model[row.path] or {})
      if row.path == "axis" then v = 40 * v end
      if group == "mesh" then mesh[name] = v elseif group then mesh.zone = { [name] = 5 * v } else fields[row.path] = v end
      model(fields)
      return fields
    end
    local fields, value = tried(row, given)
    if row.path == "axis" then value = 40 * value end
    if group == "mesh.zone" then value = 5 * value end
    reads_back_model(fields, { row.path }, value, "model." .. row.path)
  end
end

-- --- contacts and runs ---------------------------------------------------------------------------

local plain_model = model{ mesh = coarse }

for _, row in ipairs(known.contact) do
  if row.plain then
    local c, value = tried(row, function(v)
      return contact(merged({ model = plain_model }, beside.contact[row.path] or {}, { [row.path] = v }))
    end)
    same(c[row.path], value, "contact." .. row.path)
  end
end

for _, row in ipairs(known.hertz) do
  if not row.group then
    local h, value = tried(row, function(v) return hertz{ geometry = row.path == "radius_z" and "3-D" or nil, [row.path] = v } end)
    same(h[row.path], value, "hertz." .. row.path)
  end
end

local held_as = { distance = "total_distance", update = "update_at" }
for _, row in ipairs(known.wear) do
  if row.plain then
    local w, value = tried(row, function(v)
      return wear(merged({ model = plain_model }, beside.wear[row.path] or {}, { [row.path] = v }))
    end)
    reads_back_run(w, { row.path }, value, "wear." .. row.path, held_as[row.path])
    w:close()
  end
end

os.execute("rm -r " .. folder)

-- Reads and changes single numbers in the definition of a run by their names, for w:sensitivity{}.

local check = require "archard.lib.check"
local known = require "archard.settings"
local merged = require "archard.lib.merged"
local number = require "archard.definition.number"
local settings = require "archard.definition.settings"

local changer = {}

local where = "wear:sensitivity"

local function short(path) return (path:gsub("^model%.", "")) end

-- Numbers that only set the length of a run. They have no effect on the results before the end of the run.
local ends = { distance = true, cycles = true }

-- --- names ---------------------------------------------------------------------------------------

-- Returns the names of all numbers in a definition: fields of wear{} and of the bodies, but not of the mesh.
local function names_of(definition)
  local names = {}
  for name, value in pairs(definition) do
    if type(value) == "number" and not ends[name] then names[#names + 1] = name end
  end
  for path, value in pairs(definition.flat) do
    if type(value) == "number" and not path:match("^model%.mesh%.") then names[#names + 1] = short(path) end
  end
  return names
end

-- Returns the names of all wear coefficients of the model that are above 0, such as "plate.k".
local function coefficients(definition)
  local names = {}
  for path, value in pairs(definition.flat) do
    if path:match("%.k$") and value > 0 then names[#names + 1] = short(path) end
  end
  table.sort(names)
  return names
end

-- Returns the names of the numbers that a sensitivity varies by default.
function changer.usual(definition)
  local names = coefficients(definition)
  if #names == 0 then names = { "k", "alpha" } end
  if definition.load then names[#names + 1] = "load" end
  return names
end

local couple = { k = true, alpha = true, k_cylinder = true, k_plate = true }

local function refuse(run, name, definition)
  local own = coefficients(definition)
  if couple[name] and #own > 0 then
    check.fail(where, ("field 'to': %s follows from the coefficients of the bodies; use one of these: %s"):format(name,
      table.concat(own, ", ")))
  end
  for _, setting in ipairs(known.wear) do
    if setting.name == name and setting.plain and run[name] == 0 then
      check.fail(where, ("field 'to': %s is 0 and cannot be changed by a percentage"):format(name))
    end
  end
  check.fail(where, ("field 'to': \"%s\" is not a number of this run's definition%s"):format(name,
    check.hint(name, names_of(definition))))
end

-- --- changing a number ---------------------------------------------------------------------------

-- Returns the value of k_cylinder or k_plate, and a function that returns the definition with a new value. In
-- the new definition these two coefficients replace k and alpha.
local function of_couple(run, name, definition)
  local there = { k_cylinder = run.k_cylinder, k_plate = run.k_plate }
  return there[name], function(value)
    local changed = merged(definition, there, { [name] = value })
    changed.k, changed.alpha = nil, nil
    return changed
  end
end

-- Returns the value at a path, or nil. For a body without its own radius, the path "radius" means the
-- radius of the model.
local function value_at(flat, path)
  return flat[path] or path:match("%.radius$") and flat["model.radius"]
end

-- Returns the value of a number of the model, and a function that returns the definition with a new value.
-- A name without a body, such as "E", may mean both bodies. Their values must then be equal, and both are
-- changed.
local function of_model(run, name, definition)
  local flat, paths = definition.flat, number.paths(name, definition.flat)
  local there = value_at(flat, paths[1])
  if type(there) ~= "number" then refuse(run, name, definition) end
  if paths[2] and flat[paths[2]] ~= there then
    check.fail(where, ("field 'to': %s is %g for one body and %g for the other; choose one: \"%s\" or \"%s\""):format(
      name, there, flat[paths[2]], short(paths[1]), short(paths[2])))
  end
  return there, function(value)
    local copy = merged(flat)
    for _, path in ipairs(paths) do copy[path] = value end
    return merged(definition, { model = settings.nest(copy).model })
  end
end

-- Returns the value of a number, and a function set(value) that returns the definition with a new value.
function changer.of(run, name, definition)
  if ends[name] then
    check.fail(where, ("field 'to': %s only sets the end of the run; for results over the distance see "
      .. "w.history and plot.history"):format(name))
  end
  if type(definition[name]) == "number" then
    return definition[name], function(value) return merged(definition, { [name] = value }) end
  end
  if couple[name] and type(definition.k) == "number" and type(definition.alpha) == "number" then
    return of_couple(run, name, definition)
  end
  if definition[name] ~= nil and number.of_run(name) then
    check.fail(where, ("field 'to': expected the name of a number, but %s is %s"):format(name,
      check.shown(definition[name])))
  end
  return of_model(run, name, definition)
end

return changer

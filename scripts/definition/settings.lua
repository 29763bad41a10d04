-- Settings of the cases of a study: converts between nested tables and flat names ("model.mesh.size") for
-- the run file, makes grids of varied fields, and labels cases.

local check = require "archard.lib.check"
local files = require "archard.files"
local known = require "archard.settings"
local merged = require "archard.lib.merged"
local number = require "archard.definition.number"

local settings = {}

-- --- conversion of flat and nested settings ----------------------------------------------------

local function is_numbers(value)
  for i = 1, #value do
    if type(value[i]) ~= "number" then return false end
  end
  return next(value) == nil or (#value > 0 and next(value, #value) == nil)
end

-- Returns the value of an object at a path such as "mesh.zone.plate".
function settings.value_at(object, path)
  for name in path:gmatch("[^.]+") do object = object[name] end
  return object
end

-- Returns true if a setting of a material or model is not stored, since another setting determines it: the size
-- of a mesh determines its fineness.
local function is_implied(path, value)
  return path == "mesh.fineness" and (type(value.mesh.size) == "number" or value.mesh.fineness == 0)
end

-- Returns flat settings from which a copy of a material or model can be created.
local function as_table(where, name, value)
  local class = (getmetatable(value) or {}).__name
  if class ~= "material" and class ~= "model" then
    check.fail(where, ("field '%s': a %s cannot be stored in a run file; expected a number, a string, "
      .. "a boolean, a material, a model or a table of them"):format(name, class or type(value)))
  end
  local flat, outside = {}, class == "model" and (value.mesh.upper or {}).rows == 0
  for _, setting in ipairs(known[class]) do
    local own = (not setting.group or setting.class) and not is_implied(setting.path, value)
    local body = class == "model" and number.role_of[setting.path:match("^%l+")] -- role of a material's body
    local left = outside and setting.path:match("^mesh%.") or body and value[body]
    if own and not left then flat[setting.path] = settings.value_at(value, setting.path) end
  end
  if outside then flat.mesh = files.msh(value) end -- an imported mesh has no settings: store the mesh itself
  return flat
end

-- Checks and returns a name for a run file. It must have printable ASCII characters, with parts separated
-- by points and no empty part.
local function check_path(where, name)
  if name:find "^[ -~]+$" and not ("." .. name .. "."):find("..", 1, true) then return name end
  check.fail(where, ("unknown field %s: expected printable ASCII characters"):format(check.shown(name)))
end

-- Returns the form in which a value is stored: for an object of a Lua class with __settings, the fields
-- from which the object can be created; else the value itself.
local function own_fields(value)
  local class = getmetatable(value)
  local of = type(class) == "table" and rawget(class, "__settings")
  return of and of(value) or value
end

local function flatten(where, into, prefix, given)
  check.depth(where, prefix)
  for key, value in pairs(own_fields(given)) do
    value = own_fields(value)
    local name = check_path(where, prefix .. tostring(key))
    local kind = type(value)
    if kind == "number" and (value ~= value or math.abs(value) == math.huge) then
      check.refuse(where, name, "a finite number", value)
    elseif kind == "number" or kind == "string" or kind == "boolean" then
      into[name] = value
    elseif kind == "table" and is_numbers(value) then
      into[name] = value
    elseif kind == "table" then
      flatten(where, into, name .. ".", value)
    else
      flatten(where, into, name .. ".", as_table(where, name, value))
    end
  end
  return into
end

-- Returns a function that replaces the name of a mesh file in flat settings by the content of the file, since the
-- file may change before a case runs.
function settings.carrier(where)
  local texts = {}
  return function(flat)
    local path = flat["model.mesh"]
    if type(path) ~= "string" or path:find("\n", 1, true) then return flat end
    texts[path] = texts[path] or files.read(where, path)
    return merged(flat, { ["model.mesh"] = texts[path] })
  end
end

-- Converts { model = { radius = 8 } } to { ["model.radius"] = 8 }.
function settings.flatten(where, given) return flatten(where, {}, "", given) end

-- Returns the table inside `nested` that contains a field such as "mesh.size", and the key of the field in
-- this table. Missing tables are made. Whole numbers in the name are list indices.
function settings.place(nested, name)
  local at, last = nested, nil
  for part in name:gmatch("[^.]+") do
    if last ~= nil then
      if type(at[last]) ~= "table" then at[last] = {} end
      at = at[last]
    end
    last = math.tointeger(tonumber(part)) or part
  end
  return at, last
end

-- Converts flat settings to nested tables and returns them.
function settings.nest(flat)
  local nested = {}
  for name, value in pairs(flat) do
    local at, last = settings.place(nested, name)
    at[last] = value
  end
  return nested
end

local most_cases, most_values = 1000000, 4000000 -- largest numbers of cases and varied values in a study

-- Raises an error if a study has too many cases. how: text in the message that explains the number `count`.
function settings.check_count(where, name, count, how)
  if count <= most_cases then return end
  check.fail(where, ("field '%s': expected at most %d cases, got %.0f (%s)"):format(name, most_cases, count, how))
end

-- --- grids -------------------------------------------------------------------------------------

-- Returns the varied names and their lists of values as { name=, values= }, sorted by name.
local function axes_of(where, vary)
  local axes = {}
  local function visit(prefix, given)
    check.depth(where, "vary." .. prefix)
    for key, list in pairs(given) do
      local name = prefix .. tostring(key)
      if type(list) ~= "table" then
        check.refuse(where, "vary." .. name, "a list of values", list)
      elseif #list > 0 then
        axes[#axes + 1] = { name = name, values = list }
      elseif next(list) ~= nil then
        visit(name .. ".", list)
      else
        check.fail(where, ("field 'vary.%s': expected a list of values, got an empty one")
          :format(name))
      end
    end
  end
  visit("", vary)
  table.sort(axes, function(a, b) return a.name < b.name end)
  return axes
end

-- Raises an error if a grid has too many cases or values, before their tables are made.
local function refuse_many(where, axes)
  local count, words = 1, {}
  for i, axis in ipairs(axes) do
    count, words[i] = count * #axis.values, ("%d of %s"):format(#axis.values, axis.name)
  end
  local how, values = table.concat(words, " times "), count * #axes
  settings.check_count(where, "vary", count, how)
  if values <= most_values then return end
  check.fail(where, ("field 'vary': expected at most %d values in total over all cases, got %.0f (%s)"):format(most_values, values, how))
end

-- Returns all combinations of the varied values, one table of flat settings for each case. The last name
-- changes fastest.
function settings.grid(where, vary)
  local cases, axes = { {} }, axes_of(where, vary)
  refuse_many(where, axes)
  for _, axis in ipairs(axes) do
    local longer = {}
    for _, case in ipairs(cases) do
      for _, value in ipairs(axis.values) do
        longer[#longer + 1] = merged(case, { [axis.name] = value })
      end
    end
    cases = longer
  end
  return cases
end

local function is_fields(value)
  return type(value) == "table" and value[1] == nil and next(value) ~= nil
end

local function sorted_names(given)
  local names = {}
  for name in pairs(given) do names[#names + 1] = name end
  table.sort(names, function(a, b) return tostring(a) < tostring(b) end)
  return names
end

-- Merges `over` into `base` field by field. Lists and values of `over` replace the lists and values of `base`; a name
-- with points sets an inner field.
local function lay_over(where, base, over)
  for _, name in ipairs(sorted_names(over)) do
    local at, last = settings.place(base, tostring(name))
    local value = over[name]
    if is_fields(at[last]) and is_fields(value) then
      lay_over(where, at[last], value)
    else
      at[last] = settings.nest(settings.flatten(where, { value = value })).value
    end
  end
end

-- Merges two tables of settings and returns the flat result. The settings of `over` have priority and can
-- have any name that number.paths accepts.
function settings.join(where, base, over)
  local names = settings.flatten(where, over) -- flattened first, so that error messages contain the full name
  local joined = settings.nest(settings.flatten(where, base))
  lay_over(where, joined, over)
  return number.rename(settings.flatten(where, joined), names)
end

-- --- comparison and labels of cases ------------------------------------------------------------

function settings.same(a, b)
  if type(a) ~= "table" or type(b) ~= "table" then return a == b end
  if #a ~= #b then return false end
  for i = 1, #a do
    if a[i] ~= b[i] then return false end
  end
  return true
end

-- Returns a short text for a value. Control characters are removed from strings, since a string can be from
-- an untrusted file.
function settings.shown(value)
  if type(value) == "number" then return ("%.6g"):format(value) end
  if type(value) == "table" then return ("(%d numbers)"):format(#value) end
  local text = tostring(value)
  return #text < 100 and check.plain(text) or ("(%d characters)"):format(#text)
end

-- Returns the first name, in alphabetical order, whose value differs between two flat tables; nil
-- if they are equal.
function settings.difference(a, b)
  local names = {}
  for name, value in pairs(a) do
    if not settings.same(value, b[name]) then names[#names + 1] = name end
  end
  for name in pairs(b) do
    if a[name] == nil then names[#names + 1] = name end
  end
  table.sort(names)
  return names[1]
end

-- Returns the names whose values differ between cases: first the names in `familiar`, then the others
-- alphabetically.
local familiar = { alpha = 1, stroke = 2, load = 3, k = 4 }
function settings.varied(cases)
  local found, names = {}, {}
  for _, case in ipairs(cases) do
    for name in pairs(case) do found[name] = true end
  end
  for name in pairs(found) do
    for _, case in ipairs(cases) do
      if not settings.same(case[name], cases[1][name]) then
        names[#names + 1] = name
        break
      end
    end
  end
  table.sort(names, function(a, b)
    local first, second = familiar[a] or 9, familiar[b] or 9
    if first ~= second then return first < second end
    return a < b
  end)
  return names
end

-- Returns the label of a case, such as "alpha 0.25, stroke 0.11".
function settings.label(case, names)
  local parts = {}
  for _, name in ipairs(names) do
    if case[name] ~= nil then parts[#parts + 1] = name .. " " .. settings.shown(case[name]) end
  end
  return #parts > 0 and table.concat(parts, ", ") or "the only case"
end

return settings

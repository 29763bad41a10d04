-- Makes the titles of the objects in a picture. Several objects are named by the settings in which they
-- differ, a single object by its main settings and their ranges during the run.

local check = require "archard.lib.check"
local known = require "archard.settings"

local naming = {}

-- Returns a field of an object, or nil if reading it raises an error.
function naming.get(object, name)
  local ok, value = pcall(function() return object[name] end)
  if ok then return value end
end
local get = naming.get

-- Types of the fields of drawable objects. naming.part() returns nil if the object has no field of this name
-- and type.
local kinds = { pressure = "function", profile = "function", stress = "function", history = "table", mesh = "table" }

function naming.part(object, name)
  if type(object) ~= "table" and type(object) ~= "userdata" then return nil end
  local part, kind = get(object, name), kinds[name]
  return (not kind or type(part) == kind or type(part) == "userdata") and part or nil
end

-- --- bodies ------------------------------------------------------------------------------------

local usual = { "cylinder", "plate" }

-- Returns the names of the two bodies of an object, the upper body first. The object is a model, or has a
-- field `model`, or has a contact with a model.
function naming.bodies(object)
  local model = get(object, "model") or get(get(object, "contact"), "model") or object
  local names = get(model, "bodies")
  return names and { names.upper, names.lower } or usual
end

-- Returns the name of the body that a word describes. The word may be a name, a role or a kind of body.
-- Returns nil if no body matches.
local function called(object, word)
  local model = get(object, "model") or get(get(object, "contact"), "model") or object
  local names = get(model, "bodies")
  if names then return get(names, word) end
  return (word == "upper" or word == usual[1]) and usual[1] or (word == "lower" or word == usual[2]) and usual[2] or nil
end

function naming.body(where, object, word)
  local name, known = called(object, word), naming.bodies(object)
  if not name then
    check.refuse(where, "body", ('"%s" or "%s"'):format(known[1], known[2]), word)
  end
  return name
end

-- Returns the history column for a name, such as depth_cylinder for "depth_pin", and the name of its body.
-- For columns that belong to no body, returns the name only.
function naming.column(object, name)
  local what, word = name:match("^(%l+)_([%w_]+)$")
  if what ~= "depth" and what ~= "volume" then return name end
  local body, known = called(object, word), naming.bodies(object)
  if not body then return name end
  return what .. "_" .. usual[body == known[1] and 1 or 2], body
end

-- --- one setting of an object --------------------------------------------------------------------

-- Settings that occur in titles. Fields: name of the setting, format of the value, symbol used if the value
-- is a function or table. `axis` is the axis label. `follows` is true if other settings determine the
-- setting.
local settings = {
  { "alpha", "α = %g", "α", axis = "α" }, { "stroke", "s = %g mm", axis = "s / mm" },
  { "load", "load %g N", axis = "load / N" }, { "k", "k = %g mm²/N", "k", axis = "k / (mm²/N)" },
  { "x", "x = %g mm", axis = "x / mm" }, { "jump", "jump %s", "jump", axis = "cycles per update" },
  { "procedure", "procedure %s", follows = true }, { "scheme", "scheme %s" },
  { "tolerance", "tolerance %g", axis = "tolerance" },
  { "increments", "%s increments", axis = "increments" }, { "law", "law %s" },
  { "law_exponent", "exponent %g", axis = "exponent" },
  { "local_factor", "local factor %s", "local factor" }, { "geometry", "%s geometry" },
  { "slip", "%s slip" }, { "cycle", "%.6g cycles", follows = true, axis = "cycles" },
  { "friction", "μ = %g", axis = "μ" }, { "tangential", "%.4g N tangential" },
}

-- Settings that state the progress of a run. At most one of them is used in a name.
local courses = { distance = true, update = true, cycles = true }

-- Settings without an entry above are shown with name and unit.
local worded = {}
for _, setting in ipairs(settings) do worded[setting[1]] = true end
for _, setting in ipairs(known.wear) do
  if setting.plain and not worded[setting.name] then
    local unit = setting.unit and setting.unit ~= "" and setting.unit
    settings[#settings + 1] = { setting.name, follows = courses[setting.name], setting.name .. " %s" .. (unit and " " .. unit or ""),
      axis = setting.name .. (unit and " / " .. unit or "") }
  end
end

local by_name = {}
for _, setting in ipairs(settings) do by_name[setting[1]] = setting end

-- Returns the axis label of a setting. Unknown names, such as the path "model.radius" in a study, are
-- returned unchanged.
function naming.axis_of(name) return by_name[name] and by_name[name].axis or name end

local words = { alpha = "α", friction = "μ", p_center = "pressure at the centre", p_max = "largest pressure",
  p_peak = "largest pressure of a cycle" }

-- Returns a setting or a history column in words for a title, such as "α" or "wear depth of the plate".
function naming.word_of(name)
  local what, body = name:match "^(%l+)_([%w_]+)$"
  if words[name] then return words[name] end
  if (what == "depth" or what == "volume") and body ~= "partition" then return ("wear %s of the %s"):format(what, body) end
  return (name:gsub("_", " "))
end

-- Returns the text of a setting with its value, such as "α = 0.5".
function naming.value_of(name, value)
  local setting = by_name[name]
  local form = setting and setting[2]:gsub("%%s", "%%g") or name .. " = %g"
  if type(value) == "number" then return form:format(value) end
  return name .. " = " .. tostring(value)
end

local unnamed = { ["function"] = "%s by function", table = "%s by table" }

-- History columns with the values of a setting during the run, by the name of the setting. A changed setting
-- applies from the next update on.
local course = { load = "load", alpha = "alpha", stroke = "travel", k = "k",
  load_low = "load_low", load_reference = "load_reference" }

-- Returns the smallest and the largest value of a setting in the history, from the first update on. Returns
-- nil if the setting has no history column.
local function span_of(object, name)
  local history = course[name] and get(object, "history")
  local column = history and get(history, course[name])
  if not column then return nil end
  local low, high = math.huge, -math.huge
  for i = math.min(2, #column), #column do
    if column[i] == column[i] then low, high = math.min(low, column[i]), math.max(high, column[i]) end
  end
  if low <= high then return low, high end
end

local function same(low, high) return high - low <= 1e-9 * math.max(math.abs(low), math.abs(high)) end

-- Returns a range as text, such as "0.5" or "0.5 to 0.9".
local function show_span(low, high)
  return same(low, high) and ("%g"):format(low) or ("%g to %g"):format(low, high)
end

-- Returns the load as text, from its smallest to its largest value in a cycle. If pressures are reported at
-- another load, the text contains this load too.
local function load_text(object, low, high)
  low = span_of(object, "load_low") or low
  local from, to = span_of(object, "load_reference")
  local text = ("load %s N"):format(show_span(low, high))
  if from and not (same(from, high) and same(to, high)) and not same(low, high) then
    text = text .. (", pressures under %s N"):format(show_span(from, to))
  end
  return text
end

-- Returns the stroke or load of a run with a loading as text, with its range in the history. Returns nil if
-- the history has no such column.
local function under_loading(object, setting)
  local low, high = span_of(object, setting[1])
  if not low then return nil end
  if setting[1] == "load" then return load_text(object, low, high) end
  return ("travel %s mm"):format(show_span(low, high))
end

-- Settings that are omitted if they are 0. The stroke or the tangential force is 0 if the other one drives
-- the run; the tolerance is 0 without error control.
local none_at_zero = { stroke = true, tangential = true, tolerance = true }

-- Returns a setting as text, with its range during the run or, without a history column, with its current
-- value. Returns nil if the setting is omitted.
local function setting_text(object, setting)
  local name = setting[1]
  if (name == "stroke" or name == "load") and get(object, "loading") then
    return under_loading(object, setting)
  end
  local value = get(object, name)
  local track = name == "stroke" and get(object, "track")
  if type(track) == "number" and track > 0 then return ("track of %g mm"):format(track) end
  local form = setting[3] and unnamed[type(value)]
  if form then return form:format(setting[3]) end
  local low, high = span_of(object, name)
  if none_at_zero[name] and get(object, "stroke") and (high or value) == 0 then return nil end
  if low then return (setting[2]:gsub("%%g", "%%s")):format(show_span(low, high)) end
  if name == "cycle" and type(value) == "number" and value >= 100 then value = math.floor(value + 0.5) end
  local as_word = setting[2]:find("%s", 1, true)
  if type(value) == "number" then return setting[2]:format(as_word and ("%g"):format(value) or value) end
  -- A value from a run file may be of any type.
  return as_word and type(value) == "string" and setting[2]:format(value) or nil
end

-- --- several objects -----------------------------------------------------------------------------

-- Returns the texts of a setting for all objects, or nil if all texts are equal.
local function differing(objects, setting)
  local first, differs, all = setting_text(objects[1], setting), false, {}
  for i, object in ipairs(objects) do
    all[i] = setting_text(object, setting) or false
    differs = differs or (all[i] or nil) ~= first
  end
  return differs and all or nil
end

local function count_names(parts)
  local seen, count = {}, 0
  for _, part in ipairs(parts) do
    local name = table.concat(part, ", ")
    if not seen[name] then seen[name], count = true, count + 1 end
  end
  return count
end

local function with_texts(parts, all)
  local longer = {}
  for i, part in ipairs(parts) do
    longer[i] = table.move(part, 1, #part, 1, {})
    if all[i] then longer[i][#part + 1] = all[i] end
  end
  return longer
end

-- Returns for each object the texts of the settings in which the objects differ, and the list of these
-- settings. A setting determined by other settings is included only if it distinguishes more objects.
local function parts_of(objects)
  local parts, used = {}, {}
  for i in ipairs(objects) do parts[i] = {} end
  for _, follows in ipairs { false, true } do
    for _, setting in ipairs(settings) do
      local all = not setting.follows == not follows and differing(objects, setting)
      local longer = all and with_texts(parts, all)
      if longer and (not follows or count_names(longer) > count_names(parts)) then
        parts, used[#used + 1] = longer, setting
      end
    end
  end
  return parts, used
end

local most_in_key = 8

-- Returns label and values of a colour scale, or nil. A colour scale is used for more than eight objects that
-- differ only in one numeric setting.
local function scale_of(objects, used)
  if #objects <= most_in_key or #used ~= 1 or not used[1].axis then return nil end
  local values = {}
  for i, object in ipairs(objects) do
    values[i] = get(object, used[1][1])
    if type(values[i]) ~= "number" then return nil end
  end
  return { label = used[1].axis, values = values }
end

-- Returns the name of each object: `titles` or, without titles, the settings in which the objects differ.
-- Also returns a colour scale { label=, values= } if more than eight objects differ in only one number.
function naming.names_of(where, objects, titles)
  if titles and #titles ~= #objects then
    check.fail(where, ("field 'titles': expected one for each of %d objects, got %d"):format(
      #objects, #titles))
  end
  local names, parts, used = {}, nil, {}
  if not titles then parts, used = parts_of(objects) end
  for i in ipairs(objects) do
    names[i] = titles and tostring(titles[i]) or table.concat(parts[i], ", ")
    if names[i] == "" then names[i] = tostring(i) end
  end
  return names, not titles and scale_of(objects, used) or nil
end

-- --- one object ----------------------------------------------------------------------------------

-- Returns true if a body has layers or materials, which may differ in k. No single alpha applies to such a
-- run.
local function is_layered(object)
  local model = get(object, "model")
  for _, role in ipairs{ "upper", "lower" } do
    local body = get(model, role)
    if get(body, "layers") or get(body, "materials") then return true end
  end
  return false
end

-- Returns a text with the main settings of an object, for a picture that shows only this object.
function naming.summary(object)
  local parts, layered = {}, is_layered(object)
  for _, name in ipairs { "stroke", get(object, "stroke") and "tangential" or false, "alpha", "load", "cycle" } do
    parts[#parts + 1] = name and not (layered and name == "alpha") and setting_text(object, by_name[name]) or nil
  end
  return table.concat(parts, ", ")
end

function naming.title_of(what, objects, options)
  local about = #objects == 1 and not options.titles and naming.summary(objects[1]) or ""
  return about == "" and what or what .. ": " .. about
end

return naming

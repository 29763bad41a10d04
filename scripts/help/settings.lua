-- Generates help entries from the engine's lists of settings and history columns (archard.settings), and joins
-- them with the entries written in help/engine.lua. A new setting or column therefore needs no change here.

local settings = require "archard.settings"

-- Converts "a number > 0" to "number > 0".
local function bare(text) return (text:gsub("^an? ", "")) end

local function option_of(class, setting)
  local choice = setting.choice
  return { ("%s{%s}"):format(class, setting.path), values = setting.values, class = setting.class,
    type = not choice and bare(setting.type) or nil, unit = setting.unit, fixed = setting.fixed,
    default = setting.default and choice and ("%q"):format(setting.default) or setting.default,
    text = setting.text }
end

-- Returns entries for the fields distance and value of a table over the distance, such as wear{k.distance}
-- and wear{k.value}.
local function series_of(class, setting)
  local address = ("%s{%s."):format(class, setting.path)
  return {
    { address .. "distance}", type = "list", unit = "mm",
      text = ("Distances of the table, increasing; %s is interpolated linearly between them."):format(setting.name) },
    { address .. "value}", type = "list", unit = setting.unit, text = "Values at the distances of the table." },
  }
end

local function options_of(class)
  local list = {}
  for _, setting in ipairs(settings[class]) do
    list[#list + 1] = option_of(class, setting)
    for _, entry in ipairs(setting.series and series_of(class, setting) or {}) do
      list[#list + 1] = entry
    end
  end
  return list
end

-- Returns entries for those settings that the object also has as fields, such as wear.alpha. Bodies and
-- methods have no such fields.
local function fields_of(class)
  local list = {}
  if class == "body" or class:find(".", 1, true) then return list end
  for _, setting in ipairs(settings[class]) do
    if setting.plain and setting.path == setting.name then
      local sentence = setting.text:match("^(.-%.)%s%u")
      list[#list + 1] = { class .. "." .. setting.name, kind = "field", unit = setting.unit,
        class = setting.class,
        text = sentence and ("%s See %s{%s}."):format(sentence, class, setting.name) or setting.text }
    end
  end
  return list
end

local function unit_of(column) return column.unit ~= "" and column.unit or nil end

local function sentence(text) return text:sub(1, 1):upper() .. text:sub(2) .. "." end

local function history()
  local keys, lines = {}, { "History columns by name, each with one value per update, starting at update 0 (unworn):", "" }
  for _, column in ipairs(settings.columns) do
    keys[#keys + 1] = column.name
    lines[#lines + 1] = ("  %-16s %s%s"):format(column.name,
      column.unit ~= "" and "[" .. column.unit .. "] " or "", column.text)
  end
  return { "wear.history", kind = "field", keys = keys, text = table.concat(lines, "\n") }
end

-- Returns entries for the columns of the history as fields of a class. Columns that are also settings of
-- the class are omitted.
local function columns_of(class)
  local list, set = {}, {}
  for _, setting in ipairs(settings[class] or {}) do set[setting.name] = setting.name ~= "distance" end
  for _, column in ipairs(settings.columns) do
    if not set[column.name] then
      list[#list + 1] = { class .. "." .. column.name, kind = "field", unit = unit_of(column),
        text = sentence(column.text) }
    end
  end
  return list
end

-- Returns the entries in help/engine.lua for options inside another option, such as "wear{loading.x}" inside
-- "wear{loading}".
local function inside(written, option)
  local start = option:sub(1, -2) .. "."
  local list = {}
  for _, entry in ipairs(written) do
    if entry[1]:sub(1, #start) == start then list[#list + 1] = entry end
  end
  return list
end

local made = { wear = columns_of "wear", state = columns_of "state" }
table.insert(made.wear, 1, history())

-- Returns the help entries that follow the entry of a class. These are the entries of its options, each
-- followed by the options inside it from help/engine.lua (`written`), and then the entries of its fields.
local function behind(class, written)
  local list = {}
  for _, option in ipairs(settings[class] and options_of(class) or {}) do
    list[#list + 1] = option
    for _, entry in ipairs(inside(written, option[1])) do list[#list + 1] = entry end
  end
  for _, entry in ipairs(made[class] or {}) do list[#list + 1] = entry end
  for _, entry in ipairs(settings[class] and fields_of(class) or {}) do list[#list + 1] = entry end
  return list
end

-- Returns the entries of help/engine.lua (`written`) together with the generated entries. A written entry
-- replaces a generated entry with the same address.
return function(written)
  local known, joined, placed = {}, {}, {}
  for _, entry in ipairs(written) do known[entry[1]] = true end
  for _, entry in ipairs(written) do
    if not placed[entry] then joined[#joined + 1] = entry end
    for _, other in ipairs(behind(entry[1], written)) do
      if known[other[1]] ~= true or other.kind == nil then
        joined[#joined + 1] = other
        placed[other] = true
      end
    end
  end
  return joined
end

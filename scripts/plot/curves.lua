-- plot.pressure, plot.profile and plot.history: draw curves of one or several wear and contact objects, with
-- units on the axes.

local check = require "archard.lib.check"
local known = require "archard.settings"
local draw = require "archard.plot.draw"
local keys = require "archard.lib.keys"
local hertz_of = require "archard.lib.hertz_of"
local measured = require "archard.plot.measured"
local naming = require "archard.plot.naming"
local shapes = require "archard.plot.shapes"
local strict = require "archard.strict"

local curves = {}

local roles = { "upper", "lower" }

-- --- arguments ----------------------------------------------------------------------------------

local get, title_of = naming.get, naming.title_of

local body_kind = check.text

-- Sorts the arguments (object, ..., word, ..., { options }) into objects, words and options. An object is an
-- argument with the method or field `mark`. The options may contain the fields of plot{} and of `own`.
local function split(where, mark, own, ...)
  local objects, words, options = {}, {}, {}
  for i = 1, select("#", ...) do
    local value = select(i, ...)
    if type(value) == "string" then
      words[#words + 1] = value
    elseif naming.part(value, mark) then
      objects[#objects + 1] = value
    elseif type(value) == "table" and not getmetatable(value) and i == select("#", ...) then
      if type(value[1]) == "string" then
        check.fail(where, ("expected %s as an argument, as in %s(w, %q, { ... }), got it in a table"):format(check.shown(value[1]), where,
          value[1]))
      end
      options = value
    else
      check.fail(where, ("argument %d: expected an object with .%s, a string, or a table of options as the last "
        .. "argument, got %s%s"):format(i, mark, check.shown(value),
        naming.get(value, "flat") and " (use plot.map for the maps of a joint)" or ""))
    end
  end
  if #objects == 0 then
    check.fail(where, ("expected at least one object with .%s, got %s"):format(mark, words[1] and check.shown(words[1]) or "none"))
  end
  return objects, words, draw.options(where, options, own)
end

-- --- numbers ------------------------------------------------------------------------------------

local scaled = shapes.scaled

-- Returns half the width of a range around x = 0 that contains all nonzero values and the zeros next to them,
-- with a margin. The result is at least `reach`.
local function reach_of(x, values, reach)
  for i = 1, #x do
    local at = math.abs(x[i])
    if values[i] ~= 0 then
      reach = math.max(reach, 1.25 * at)
    elseif (values[i - 1] or 0) ~= 0 or (values[i + 1] or 0) ~= 0 then
      reach = math.max(reach, 1.05 * at)
    end
  end
  return reach
end

-- Returns the range of x, from -reach to reach. Returns nil if `reach` is 0, which means that all values are
-- zero; the axis then shows all points.
local function range_of(reach) return reach > 0 and { -reach, reach } or nil end

-- Returns the Hertz contact of an object: the field `hertz` or, without this field, the Hertz contact of its
-- model and load.
local function scale_of(where, object)
  local known = get(object, "hertz")
  if known then return known end
  local model, load = get(object, "model"), get(object, "load")
  if not (model and load) then
    check.fail(where, "scaled=true: expected objects with .hertz, or with .model and .load")
  end
  return hertz_of(model, load)
end

-- Returns the name of the selected body in the first object, and the word that selects it: the last of
-- `words`, else options.body. Raises an error if an object has no such body.
local function body_word(where, objects, words, options)
  local body = words[#words] or options.body
  for _, word in ipairs(words) do naming.body(where, objects[1], word) end
  for _, object in ipairs(body and objects or {}) do naming.body(where, object, body) end
  return body and naming.body(where, objects[1], body), body
end

-- --- the pictures -------------------------------------------------------------------------------

-- Returns the positions x and pressures p from the last zero before the contact to the first zero after it.
local function over_contact(x, p)
  local first, last = 1, #p
  while first < #p and p[first + 1] == 0 do first = first + 1 end
  while last > first and p[last - 1] == 0 do last = last - 1 end
  if last - first < 2 then return x, p end -- no contact
  return table.move(x, first, last, 1, {}), table.move(p, first, last, 1, {})
end

-- plot.pressure(w1, w2, ..., { scaled=, body=, ... }) draws the contact pressures of runs and contacts.
function curves.pressure(...)
  local where = "plot.pressure"
  local objects, words, options = split(where, "pressure", { scaled = check.flag, body = body_kind,
    titles = check.table }, ...)
  local body, word = body_word(where, objects, words, options)
  body, word = body or naming.bodies(objects[1])[1], word or "upper"
  local names, scale = naming.names_of(where, objects, options.titles)
  local given, reach, named = {}, 0, #objects > 1 or options.titles
  for i, object in ipairs(objects) do
    local pressure = object:pressure(naming.body(where, object, word))
    local a, p_h = 1, 1
    if options.scaled then
      local hertz = scale_of(where, object)
      a, p_h = hertz.half_width, hertz.p_max
    end
    local x, p = over_contact(scaled(pressure.x, 1 / a), scaled(pressure.p, 1 / p_h))
    reach = reach_of(x, p, reach)
    given[i] = { x = x, y = p, title = named and names[i] or nil,
      value = scale and scale.values[i] }
  end
  given = draw.over({
    xlabel = options.scaled and "x / a" or "x / mm",
    ylabel = options.scaled and "p / p_H" or "p / MPa",
    xrange = range_of(reach), yrange = not options.logy and { 0 } or nil, vlabel = scale and scale.label,
    title = title_of("contact pressure of the " .. body, objects, options),
    table.unpack(given),
  }, options)
  draw.draw(where, given)
end

local function largest(values)
  local result = 0
  for _, value in ipairs(values) do result = math.max(result, value) end
  return result
end

-- Adds a dashed line at the bottom of each layer if the body is worn by at least half of the depth of this line.
local function add_layers(panel, object, body, depth)
  for _, role in ipairs(roles) do
    local layers = naming.body("plot.profile", object, role) == body and get(get(get(object, "model"), role), "layers")
    local bottom = 0 -- [mm]
    for i, layer in ipairs(layers or {}) do
      bottom = bottom + layer.thickness
      if bottom > 2 * depth then break end
      panel[#panel + 1] = { x = {}, y = { 1000 * bottom, 1000 * bottom }, series = 8, dash = 3,
        title = i == 1 and (#layers > 1 and "bottoms of the layers" or "bottom of the layer") or nil }
    end
  end
end

-- Returns a panel with the wear depths [µm] of the selected bodies of all objects. The depth axis starts at
-- 0. A single run has lines for the layers.
local function profile_panel(where, objects, names, of_body, scale, section)
  local panel, reach = {}, 0
  for i, object in ipairs(objects) do
    for _, word in ipairs(of_body) do
      local body = naming.body(where, object, word)
      local profile = object:profile(body, section)
      reach = reach_of(profile.x, profile.h, reach)
      panel[#panel + 1] = { x = profile.x, y = scaled(profile.h, 1000),
        title = #of_body > 1 and body or #objects > 1 and names[i] or nil,
        value = scale and scale.values[i] }
      if #objects == 1 then add_layers(panel, object, body, largest(profile.h)) end
    end
  end
  panel.xrange, panel.yrange, panel.vlabel = range_of(reach), { 0 }, scale and scale.label
  for _, curve in ipairs(panel) do
    if #curve.x == 0 then curve.x = { -reach, reach } end
  end
  return panel
end

local function is_spatial(object)
  local has, model = pcall(function() return object.model end)
  return has and type(model) == "userdata" and model.geometry == "3-D"
end

-- Returns two panels for a run in three dimensions: the profile along x at z = 0 and the profile along z at x
-- = 0.
local function sections(where, objects, names, of_body, scale, options)
  local panels = {}
  for i, axis in ipairs{ "x", "z" } do
    panels[i] = profile_panel(where, objects, names, of_body, scale, { [axis == "x" and "z" or "x"] = 0 })
    panels[i].xlabel = axis .. " / mm"
  end
  return panels
end

-- Returns the section to draw of runs in three dimensions, or nil for the default.
local function section_of(where, options, spatial)
  if options.section and not spatial then
    check.fail(where, 'field \'section\': only allowed for runs with geometry = "3-D"')
  elseif options.measured and spatial and not options.section then
    check.fail(where, "field 'measured': expected section = { x = 0 } (a trace across the motion) or section = { z = 0 } "
      .. "(along it) with it, got none")
  end
  return options.section
end

-- Adds a measured trace to a panel. The range of y is then automatic, because a trace may have values above
-- the original surface.
local function add_measured(where, panel, given)
  if panel.panels then
    check.fail(where, "field 'measured': expected one body if several runs are drawn, got both bodies")
  end
  local reach = panel.xrange and panel.xrange[2] or 0
  if #panel == 1 then panel[1].title = panel[1].title or "simulated" end
  panel.points, reach = measured.points(given, reach)
  panel.xrange, panel.yrange = range_of(reach), nil
end

-- plot.profile(w1, w2, ..., body, { ... }) draws the wear profiles of runs; without a body it draws both
-- bodies.
-- plot.profile(p1, p2, ..., { ... }) draws measured profiles.
function curves.profile(...)
  local where = "plot.profile"
  if measured.is_profile((...)) then return require "archard.plot.trace" (where, ...) end
  local objects, words, options = split(where, "profile", { body = body_kind,
    titles = check.table, measured = measured.kind, section = check.section }, ...)
  local body, word = body_word(where, objects, words, options)
  local spatial = is_spatial(objects[1])
  local section = section_of(where, options, spatial)
  local names, scale = naming.names_of(where, objects, options.titles)
  local defaults = { xlabel = (section and section.x and "z" or "x") .. " / mm", ylabel = "wear depth / µm", ydown = true }
  if (body or #objects == 1) and spatial and not section then
    defaults.panels, defaults.layout = sections(where, objects, names, body and { word } or roles, scale, options), { 1, 2 }
    defaults.title = title_of(body and "wear of the " .. body or "wear", objects, options)
  elseif body or #objects == 1 then
    for name, value in pairs(profile_panel(where, objects, names, body and { word } or roles, scale, section)) do
      defaults[name] = value
    end
    defaults.title = title_of(body and "wear of the " .. body or "wear", objects, options)
  else
    defaults.panels, defaults.layout = {}, { 1, 2 }
    for i, each in ipairs(roles) do
      defaults.panels[i] = profile_panel(where, objects, names, { each }, scale, section)
      defaults.panels[i].title = naming.body(where, objects[1], each)
    end
  end
  for _, panel in ipairs(defaults.panels or {}) do
    panel.xrange, panel.yrange = options.xrange or panel.xrange, options.yrange or panel.yrange
  end
  if options.measured then add_measured(where, defaults, options.measured) end
  draw.draw(where, draw.over(defaults, options))
end

-- --- history ------------------------------------------------------------------------------------

-- Quantities in the history, each as { pattern of the column names, axis label, factor from the unit of the
-- column to the unit of the label }. Columns of the same quantity are drawn in one panel.
local quantities = {
  { "^p_", "pressure / MPa", 1 },
  { "^depth_partition$", "wear depth partition", 1 },
  { "^depth_", "wear depth / µm", 1000 },
  { "^volume_", "wear volume / mm³", 1 },
  { "^half_width$", "half width / mm", 1 },
  { "^half_width_z$", "half width across the motion / mm", 1 },
  { "^area$", "contact area / mm²", 1 },
  { "^stick_width$", "width of the stick zone / mm", 1 },
  { "^largest_shear$", "largest tangential force of a cycle / N", 1 },
  { "^energy$", "dissipated energy / (N mm)", 1 },
  { "^cycle_energy$", "energy dissipated in a cycle / (N mm)", 1 },
  { "^load_distance$", "load times distance / (N mm)", 1 },
  { "^gross$", "gross slip (1: yes)", 1 },
  { "^error$", "estimated error / tolerance", 1 },
  { "^solutions$", "contact solutions", 1 },
  { "^elements$", "elements", 1 },
  { "^box_rows$", "rows of the wear box", 1 },
  { "^k$", "k / (mm²/N)", 1 },
  { "^alpha$", "α", 1 },
  { "^jump$", "cycles per update", 1 },
}
for _, column in ipairs(known.columns) do
  local unit = column.unit ~= "" and " / " .. column.unit or ""
  quantities[#quantities + 1] = { "^" .. column.name .. "$", column.name .. unit, 1 }
end
local short_titles = { p_center = "centre", p_max = "largest", p_peak = "largest of a cycle" }
local against = { distance = "distance / mm", cycle = "cycles", update = "updates" }

-- Returns the axis label of a history column and the factor to the unit of the label. Returns nil for an
-- unknown column.
local function quantity_of(name)
  for _, quantity in ipairs(quantities) do
    if name:find(quantity[1]) then return quantity[2], quantity[3] end
  end
end

local function column_of(where, history, name)
  local column = get(history, name)
  if column then return column end
  check.fail(where, ("no column '%s' in the history%s"):format(name, check.hint(name, keys(history))))
end

-- Returns one panel for each quantity of the columns, in the order of the columns.
local function history_panels(columns)
  local panels, by_label = {}, {}
  for _, name in ipairs(columns) do
    local label, factor = quantity_of(name)
    label = label or name
    local panel = by_label[label]
    if not panel then
      panel = { ylabel = label, factor = factor or 1, columns = {} }
      panels[#panels + 1], by_label[label] = panel, panel
    end
    panel.columns[#panel.columns + 1] = name
  end
  for _, panel in ipairs(panels) do -- if a panel has only one pressure, the axis label names it
    local only = #panel.columns == 1 and panel.columns[1]
    if only and only:find "^p_" then panel.ylabel = naming.word_of(only) .. " / MPa" end
  end
  return panels
end

local function from_second(list)
  local result = {}
  for i = 2, #list do result[i - 1] = list[i] end
  return result
end

-- History columns that contain the settings of an update. They are drawn as steps, because the value in a row
-- was constant since the previous row.
local chosen = { alpha = true, load = true, travel = true }

local function steps_of(x, y)
  local xs, ys = {}, {}
  for i = 1, #x do
    local row = math.max(i, 2) -- the first row is the state before the first update
    if i > 1 and y[i] ~= y[i - 1] and i > 2 then xs[#xs + 1], ys[#ys + 1] = x[i - 1], y[i] end
    xs[#xs + 1], ys[#ys + 1] = x[i], y[row] or y[i]
  end
  return xs, ys
end

-- History columns that belong to an update. Their first row is omitted, because no update precedes it.
local of_update = { jump = true, error = true, cycle_energy = true, largest_shear = true, stick_width = true, gross = true }

-- Returns x and y of the history column `jump` (cycles per update). The last row is omitted if the end of the run
-- shortened its update.
local function jumps_of(x, y)
  if #y > 2 and y[#y] < y[#y - 1] then
    x, y = table.move(x, 1, #x - 1, 1, {}), table.move(y, 1, #y - 1, 1, {})
  end
  return x, y
end

local function history_curve(where, history, abscissa, column, factor)
  local x, y = column_of(where, history, abscissa), column_of(where, history, column)
  if of_update[column] and #y > 1 and y[1] == 0 then x, y = from_second(x), from_second(y) end
  if column == "jump" then x, y = jumps_of(x, y) end
  if chosen[column] then x, y = steps_of(x, y) end
  return { x = x, y = scaled(y, factor) }
end

-- Returns the title of a curve, such as "plate, α = 0.5". It contains only the parts that differ between the
-- curves of a panel.
local function history_title(column, body, name, several_columns, several_objects)
  local parts = {}
  if several_columns then parts[1] = body or short_titles[column] or column end
  if several_objects then parts[#parts + 1] = name end
  return parts[1] and table.concat(parts, ", ") or nil
end

-- Returns the title of the picture. It names the body if there is only one column and the column belongs to a
-- body.
local function history_name(object, columns)
  local _, body = naming.column(object, columns[1])
  return #columns == 1 and body and "history of the " .. body or "history"
end

-- plot.history(w1, ..., "p_center", ..., { against="cycle", ... }) draws columns of the histories of runs.
function curves.history(...)
  local where = "plot.history"
  local objects, columns, options = split(where, "history", { titles = check.table,
    against = check.one_of { "distance", "cycle", "update" } }, ...)
  if not columns[1] then columns = { get(objects[1].history, "p_center") and "p_center" or "p_peak" } end
  local names, scale = naming.names_of(where, objects, options.titles)
  local abscissa = options.against or strict.is(objects[1], "joint_wear") and "cycle" or "distance"
  local panels = history_panels(columns)
  for i, object in ipairs(objects) do
    local history = object.history
    for _, panel in ipairs(panels) do
      for c, column in ipairs(panel.columns) do
        local own, body = naming.column(object, column)
        local curve = history_curve(where, history, abscissa, own, panel.factor)
        curve.series, curve.dash = #objects > 1 and i or c, #panel.columns > 1 and c or nil
        curve.value = scale and #panel.columns == 1 and scale.values[i] or nil
        curve.title = history_title(column, body, names[i], #panel.columns > 1, #objects > 1 or options.titles)
        panel[#panel + 1] = curve
      end
    end
  end
  for _, panel in ipairs(panels) do
    panel.factor, panel.columns, panel.vlabel = nil, nil, scale and scale.label
  end
  local defaults = #panels == 1 and panels[1] or { panels = panels, layout = { #panels, 1 } }
  defaults.xlabel = against[abscissa] or abscissa
  defaults.title = title_of(history_name(objects[1], columns), objects, options)
  draw.draw(where, draw.over(defaults, options, "stacked"))
end

curves.get, curves.summary, curves.quantity_of = get, naming.summary, quantity_of
curves.profile_panel, curves.range_of = profile_panel, range_of
curves.split = split

return curves

-- Checks the options of plot{...}, makes a figure from them, and draws the figure with archard.gnuplot.
-- plot/output.lua chooses the output.

local files = require "archard.files"
local gnuplot = require "archard.gnuplot"
local check = require "archard.lib.check"
local keys = require "archard.lib.keys"
local output = require "archard.plot.output"
local csv = require "archard.plot.csv"
local merged = require "archard.lib.merged"
local strict = require "archard.strict"
local style = require "archard.plot.style"
local units = require "archard.plot.units"
local written = require "archard.lib.written"

local draw = {}

-- Default options set by the user: term, size (of pictures in the terminal), file_size, colour and key.
draw.default = output.default

-- --- the options --------------------------------------------------------------------------------

local styles, key_places = gnuplot.styles, gnuplot.keys
local terms = output.terms
draw.terms = terms

local curve_fields = {
  x = check.list, y = check.list, error = check.list, title = check.text,
  value = check.kind("a number, or a list of numbers for a field", function(v)
    return type(v) == "number" or check.list.test(v)
  end),
  style = check.one_of(styles), colour = check.text, series = check.count, dash = check.count,
  width = check.positive, on = check.one_of(output.surfaces),
}
draw.curve_fields = curve_fields
local places = check.kind("{ at = { numbers }, words = { strings } } of equal length", function(v)
  return type(v) == "table" and type(v.at) == "table" and type(v.words) == "table"
    and #v.at == #v.words and #v.at > 0
end)
local title = check.kind("a string, or false for no title", function(v) return type(v) == "string" or v == false end)
local panel_fields = {
  title = title, xlabel = check.text, ylabel = check.text, xrange = check.range,
  yrange = check.range, logx = check.flag, logy = check.flag, xdown = check.flag,
  ydown = check.flag, key = check.one_of(key_places, check.flag), style = check.one_of(styles),
  equal = check.flag, levels = check.count, vlabel = check.text, vrange = check.range,
  x = check.list, y = check.list, points = check.table, xplaces = places,
  yplaces = places,
}
local output_fields = {
  term = check.one_of(terms), file = check.file, size = check.size,
  colour = check.one_of({ "grey" }, check.flag),
}
local figure_fields = merged(panel_fields, output_fields,
  { panels = check.table, layout = check.grid, letters = check.flag })
draw.fields = figure_fields -- the fields of plot{}, for functions that also accept other options

-- Checks the options of a picture. Allowed are the fields of plot{} and the fields in `own`.
function draw.options(where, options, own)
  if options ~= nil and type(options) ~= "table" then
    check.fail(where, "expected a table of options, got " .. check.shown(options))
  end
  return check.fields(where, options or {}, merged(figure_fields, own))
end

-- Properties of option tables, stored by draw.over() under the option table as the key. `titled`: the title
-- was chosen by the drawing function. `stacked`: the panels may also be drawn side by side. `x`, `y`: the
-- unit of this axis may be changed.
local made = setmetatable({}, { __mode = "k" })

-- Returns the defaults of a drawing function, overridden by the user's options of plot{}. nature: "stacked"
-- if panels may be drawn side by side.
function draw.over(defaults, options, nature)
  made[defaults] = { titled = options.title == nil, stacked = nature == "stacked" and not options.layout,
    x = options.xlabel == nil, y = options.ylabel == nil }
  for name, value in pairs(options) do
    if figure_fields[name] then defaults[name] = value end
  end
  return defaults
end

-- --- from options to a figure -------------------------------------------------------------------

-- Replaces zero bytes in a text by spaces, because a zero byte ends a C string.
local function words(text) return text and (text:gsub("%z", " ")) or nil end

local function counted(list)
  local numbers = {}
  for i = 1, #list do numbers[i] = i end
  return numbers
end

local function to_curve(where, given, number, panel)
  local prefix = ("curve %d: "):format(number)
  if type(given) ~= "table" then
    check.fail(where, ("curve %d: expected a table { x=, y= }, got %s"):format(number,
      check.shown(given)))
  end
  given = check.fields(where, given, curve_fields, prefix)
  if not given.y then check.refuse(where, prefix .. "y", check.list.expected, nil) end
  return {
    x = given.x or counted(given.y), y = given.y, title = words(given.title),
    style = given.style or panel.style, colour = words(given.colour), series = given.series,
    dash = given.dash, width = given.width, error = given.error, on = given.on,
    value = type(given.value) == "number" and given.value or nil,
  }
end

-- Returns an axis as a table. On a reversed axis the limits in `range` may be in either order.
local function to_axis(label, range, log, down, places)
  local low, high = range and range[1], range and range[2]
  if down and low and high then low, high = math.max(low, high), math.min(low, high) end
  return { label = words(label), min = low, max = high, log = log, reverse = down, places = places }
end

-- Adds the curves in the list part of the options to a panel. One item may be a field of values: a table in
-- which `value` is a list.
local function to_curves(where, given, panel)
  if given.x or given.y then
    panel.curves[1] = to_curve(where, { x = given.x, y = given.y }, 1, given)
  end
  for number, item in ipairs(given) do
    if type(item) == "table" and item.value and type(item.value) ~= "number" then
      item = check.fields(where, item, curve_fields, ("field %d: "):format(number))
      if not (item.x and item.y) then
        check.fail(where, "a field of values needs lists x and y with the four corners of each polygon")
      end
      panel.field = { x = item.x, y = item.y, value = item.value }
    else
      panel.curves[#panel.curves + 1] = to_curve(where, item, number, given)
    end
  end
end

-- Adds measured points to a panel as black points.
local function add_points(where, panel, points)
  if not points then return end
  local curve = to_curve(where, merged({ style = "points", colour = "black" }, points),
    #panel.curves + 1, {})
  panel.curves[#panel.curves + 1] = curve
end

local function same_numbers(a, b)
  if a == nil or b == nil or #a ~= #b then return a == b end
  for i = 1, #a do
    if a[i] ~= b[i] then return false end
  end
  return true
end

-- Adds measured points to a panel and removes earlier curves with the same points.
local function put_points(where, panel, points)
  add_points(where, panel, points)
  local new = panel.curves[#panel.curves]
  for i = #panel.curves - 1, 1, -1 do
    local old = panel.curves[i]
    local again = old.style == new.style and same_numbers(old.x, new.x) and same_numbers(old.y, new.y)
      and same_numbers(old.error, new.error)
    if again then table.remove(panel.curves, i) end
  end
end

local most_in_key = 8

-- Labels the curves at their ends if there are too many titles for a key. Curves on a colour scale are not
-- counted.
local function name_at_ends(panel)
  local titled = 0
  for _, curve in ipairs(panel.curves) do
    if curve.title and not curve.value and curve.on ~= "characters" then titled = titled + 1 end
  end
  for _, curve in ipairs(panel.curves) do curve.labelled = titled > most_in_key and curve.title ~= nil end
end

local function to_panel(where, given)
  local key = given.key
  if key == nil then key = draw.default.key end
  local panel = {
    title = words(given.title),
    x = to_axis(given.xlabel, given.xrange, given.logx, given.xdown, given.xplaces),
    y = to_axis(given.ylabel, given.yrange, given.logy, given.ydown, given.yplaces),
    value = to_axis(given.vlabel, given.vrange),
    key = key == false and "none" or key ~= true and key or "below",
    equal = given.equal, levels = given.levels, curves = {},
  }
  to_curves(where, given, panel)
  add_points(where, panel, given.points)
  if key == nil then name_at_ends(panel) end
  return panel
end

-- Returns a copy of the panel; fields that the panel does not set are copied from the figure, except the
-- title.
local function inherit(panel, figure)
  local inherited = {}
  for name in pairs(panel_fields) do
    if name ~= "title" and name ~= "x" and name ~= "y" and name ~= "points" then inherited[name] = figure[name] end
  end
  return merged(inherited, panel)
end

-- Adds "(a)", "(b)", ... at the start of the panel titles. The field `name` of a panel stores the title
-- without the letter.
local function letter(panels)
  for i = 1, #panels > 1 and #panels <= 26 and #panels or 0 do
    local panel = panels[i]
    panel.name = panel.title
    panel.title = ("(%c) %s"):format(96 + i, panel.title or ""):gsub(" $", "")
  end
end

-- Returns the figure of the options of plot{}, and a copy of the options, which were read once.
local function to_figure(where, given)
  local nature = made[given] or {}
  given = check.fields(where, given, figure_fields)
  if not given.panels then
    return { panels = { to_panel(where, given) }, nature = nature }, given
  end
  if #given.panels == 0 then check.refuse(where, "panels", "a list of panels", given.panels) end
  local layout = given.layout or {}
  local figure = { title = words(given.title), rows = layout[1], columns = layout[2], panels = {},
    one_key = given.key == nil, nature = nature }
  for number, panel in ipairs(given.panels) do
    if type(panel) ~= "table" then
      check.fail(where, ("panel %d: expected a table, got %s"):format(number,
        check.shown(panel)))
    end
    panel = check.fields(where, panel, panel_fields, ("panel %d: "):format(number))
    figure.one_key = figure.one_key and panel.key == nil
    figure.panels[number] = to_panel(where, inherit(panel, given))
  end
  if given.letters ~= false then letter(figure.panels) end
  return figure, given
end

-- --- drawing ------------------------------------------------------------------------------------

local last, last_given -- the last figure drawn and its options, for plot.save, again() and points()

-- Calls a function of archard.gnuplot and reports an error as an error of `where`.
local function run(where, f, ...)
  local ok, result, message, code = pcall(f, ...)
  if not ok then check.fail(where, tostring(result)) end
  if not result then check.fail(where, message, code) end
  return result
end

-- A line is drawn with a mark at each point if it has at least `fewest` points and no curve over the same
-- axis has more than `few` points.
local fewest, few = 4, 30

-- Returns how many points of a curve lie in the range of the axis. Of consecutive zeros only the first is
-- counted. Returns nil if x does not increase.
local function count_shown(curve, axis)
  local low, high = math.min(axis.min or -math.huge, axis.max or -math.huge), math.max(axis.max or math.huge, axis.min or math.huge)
  local count = 0
  for i, x in ipairs(curve.x) do
    if i > 1 and not (x > curve.x[i - 1]) then return nil end
    if x >= low and x <= high and (curve.y[i] ~= 0 or curve.y[i - 1] ~= 0) then count = count + 1 end
  end
  return count
end

-- Returns a function(panel, curve) that returns true if the curve is drawn with a mark at each point.
local function marked_of(figure)
  local counts, most = {}, {}
  for _, panel in ipairs(figure.panels) do
    local axis = panel.x.label or ""
    for _, curve in ipairs(panel.curves) do
      local count = not curve.style and not curve.error and not curve.value and count_shown(curve, panel.x)
      counts[curve], most[axis] = count or 0, math.max(most[axis] or 0, count or 0)
    end
  end
  return function(panel, curve) return counts[curve] >= fewest and most[panel.x.label or ""] <= few end
end

-- Appends the label of the colour values to a title. Pictures made of characters need this, because they have
-- no colour scale that could show the label.
local function with_label(title, label)
  if not label or not title or title:find(label, 1, true) then return title or label end
  return label:sub(1, #title) == title and label or title .. ", " .. label
end

-- Returns the figure for the output `surface`, "pixels" or "characters": with suitable units, without the
-- curves for the other output. In pixels, lines of few points have marks.
local function on(figure, surface)
  local panels = {}
  for _, name in ipairs{ "x", "y" } do
    if figure.nature[name] then figure = units.shown(figure, name) end
    if surface == "pixels" then figure = units.with_powers(figure, name) end
  end
  local marked = surface == "pixels" and marked_of(figure)
  for i, panel in ipairs(figure.panels) do
    local curves = {}
    for _, curve in ipairs(panel.curves) do
      if curve.on == nil or curve.on == surface then
        curves[#curves + 1] = marked and marked(panel, curve) and merged(curve, { style = "linespoints" }) or curve
      end
    end
    panels[i] = merged(panel, { curves = curves })
    if surface == "characters" and panel.field then panels[i].title = with_label(panel.title, panel.value.label) end
  end
  return merged(figure, { panels = panels })
end

-- Returns the figure for a file in the current style. Stacked panels may be put side by side, and a default
-- title is removed if the style omits titles.
local function styled(figure)
  local result = merged(figure)
  if figure.nature.stacked then result.rows, result.columns = style.grid(figure.rows, figure.columns) end
  if not figure.nature.titled or style.titled() then return result end
  result.title = nil
  if not figure.rows and #figure.panels == 1 then
    local panel = merged(figure.panels[1])
    panel.title, result.panels = nil, { panel }
  end
  return result
end

-- Draws a figure on its output. Returns the picture as text if the output is the terminal, else nil.
local function paint(where, figure, given, moving)
  local shown = given.file and styled(figure) or figure
  local to = output.choose(where, shown, given, moving)
  local picture = run(where, gnuplot.draw, on(shown, output.surface(to)), to)
  last, last_given = figure, given
  if given.file then written.note(where, given.file) end
  return type(picture) == "string" and output.written(picture, to) or nil
end

local function show(picture)
  if not picture then return end
  io.write(picture)
  io.flush()
end

local default_fields = { term = check.one_of(terms), size = check.size, file_size = check.size,
  colour = output_fields.colour, key = check.one_of(key_places, check.flag) }
local default_names = keys(default_fields)

-- Unknown names in plot.default raise an error on reading and on writing.
setmetatable(draw.default, { __plain = true,
  __index = function(_, name) return strict.refuse("plot.default", name, default_names) end,
  __newindex = function(default, name, value)
    if value ~= nil then check.fields("plot.default", { [name] = value }, default_fields) end
    rawset(default, name, value)
  end })

-- Checks the options and draws the figure. Returns the picture as text if the output is the terminal, else
-- nil.
local function render(where, given, moving)
  check.fields(where .. ": plot.default", draw.default, default_fields)
  local figure, read_once = to_figure(where, given)
  return paint(where, figure, read_once, moving)
end

-- Draws a figure from options of plot{}. A picture for the terminal is printed.
function draw.draw(where, given) show(render(where, given)) end

-- Draws a figure and returns the picture as text, for functions that redraw it repeatedly.
function draw.picture(where, given) return render(where, given, true) end

-- Returns only the options that choose output, size and colour.
local function placed(options)
  return { term = options.term, size = options.size, colour = options.colour }
end

-- again(): draws the last picture again at the present size of the terminal or window.
function draw.again(where)
  if not last then check.fail(where, "no picture has been drawn yet") end
  local on_screen = last_given.file and {} or placed(last_given)
  show(paint(where, last, on_screen))
end

-- points{ x=, y=, error=, file=, ... }: adds measured points to the last picture and draws it again.
function draw.points(where, given)
  if type(given) ~= "table" then
    check.fail(where, "expected a table { x=, y=, error= }, got " .. check.shown(given))
  end
  given = check.fields(where, given, merged(curve_fields, output_fields, { panel = check.count }))
  local number, figure = given.panel or 1, last and merged(last) or { nature = {}, panels = { { x = {}, y = {},
    value = {}, key = "below", curves = {} } } }
  if not figure.panels[number] then
    check.fail(where, ("field 'panel': expected one of the %d panels of the last picture, got %d")
      :format(#figure.panels, number))
  end
  local curve, placement = {}, {}
  for name, value in pairs(given) do
    if name ~= "panel" then (output_fields[name] and name ~= "colour" and placement or curve)[name] = value end
  end
  local panel = merged(figure.panels[number])
  panel.curves = table.move(panel.curves, 1, #panel.curves, 1, {})
  put_points(where, panel, curve)
  figure.panels = table.move(figure.panels, 1, #figure.panels, 1, {})
  figure.panels[number] = panel
  show(paint(where, figure, merged(last_given and placed(last_given) or {}, placement)))
end

-- Writes an animated gif. `frames` is a list of option tables of plot{}, `delay` the time per frame [s].
function draw.film(where, frames, delay, given)
  local figures = {}
  for i, frame in ipairs(frames) do figures[i] = on((to_figure(where, frame)), "pixels") end
  local to = output.to_file(where, figures[1], given.file, "gif", given.size)
  run(where, gnuplot.animate, figures, delay, to)
  written.note(where, given.file)
end

-- Draws a figure to a file and writes its data to a CSV file with the same base name.
local function save(where, figure, file, options)
  local given = { file = file, size = options.size, term = options.term, colour = options.colour }
  paint(where, figure, given)
  local data = file:gsub("%.[^./]*$", "") .. ".csv"
  files.write(where, data, csv(figure))
  written.note(where, data)
end

-- plot.save("p.png" [, options]) saves the last picture. plot.save{ ..., file="p.png" } draws and saves a new
-- picture.
function draw.save(where, given, options)
  if type(given) == "table" and given.file then
    save(where, to_figure(where, given), given.file, given)
  elseif type(given) == "string" then
    if not last then check.fail(where, "no picture has been drawn yet") end
    save(where, last, given, check.fields(where, options or {}, output_fields))
  else
    check.fail(where, "expected the name of a file, or the table of plot{} with file=, got "
      .. (type(given) == "table" and "a table without file" or check.shown(given)))
  end
end

return draw

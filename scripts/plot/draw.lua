-- From a table of options to a picture: what plot{...} may be given, the figure made of it, and
-- where that is drawn. Leans on archard.gnuplot to draw, on archard.term for the terminal.

local files = require "archard.files"
local gnuplot = require "archard.gnuplot"
local term = require "archard.term"
local check = require "archard.lib.check"
local csv = require "archard.plot.csv"
local merged = require "archard.lib.merged"

local draw = {}

-- Used where a call does not say otherwise: term, size, colour, key. The user's to change.
draw.default = {}

-- --- what may be given --------------------------------------------------------------------------

local styles, keys = gnuplot.styles, gnuplot.keys
local windows = { window = true, qt = true, wxt = true, x11 = true }
local terms = { "dumb", "sixel", "window", "qt", "wxt", "x11" }
local file_kinds = {}
for ending in gnuplot.endings:gmatch("%S+") do
  terms[#terms + 1], file_kinds[ending] = ending, true
end
draw.terms = terms

local curve_fields = {
  x = check.list, y = check.list, value = check.list, title = check.text,
  style = check.one_of(styles), colour = check.text, series = check.count, dash = check.count,
  width = check.positive,
}
local panel_fields = {
  title = check.text, xlabel = check.text, ylabel = check.text, xrange = check.range,
  yrange = check.range, logx = check.flag, logy = check.flag, xdown = check.flag,
  ydown = check.flag, key = check.one_of(keys, check.flag), style = check.one_of(styles),
  equal = check.flag, levels = check.count, vlabel = check.text, vrange = check.range,
  x = check.list, y = check.list,
}
local output_fields = {
  term = check.one_of(terms), file = check.text, size = check.size, colour = check.flag,
}
local figure_fields = merged(panel_fields, output_fields,
  { panels = check.table, layout = check.grid })
draw.fields = figure_fields -- for functions that take these options and more

-- Checks the options of a picture that takes those of plot{} and its own.
function draw.options(where, options, own)
  if options ~= nil and type(options) ~= "table" then
    check.fail(where, "expected a table of options, got " .. check.shown(options))
  end
  return check.fields(where, options or {}, merged(figure_fields, own))
end

-- A picture as its function means it, with the options of plot{} before what it says itself.
function draw.over(defaults, options)
  for name, value in pairs(options) do
    if figure_fields[name] then defaults[name] = value end
  end
  return defaults
end

-- --- from options to a figure -------------------------------------------------------------------

-- C strings end at a zero.
local function words(text) return text and (text:gsub("%z", " ")) end

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
  check.fields(where, given, curve_fields, prefix)
  if not given.y then check.refuse(where, prefix .. "y", check.list.expected, nil) end
  return {
    x = given.x or counted(given.y), y = given.y, title = words(given.title),
    style = given.style or panel.style, colour = words(given.colour), series = given.series,
    dash = given.dash, width = given.width,
  }
end

local function to_axis(label, range, log, down)
  return { label = words(label), min = range and range[1], max = range and range[2], log = log,
    reverse = down }
end

-- The list part: curves, and at most one table with values, which is the field.
local function to_curves(where, given, panel)
  if given.x or given.y then
    panel.curves[1] = to_curve(where, { x = given.x, y = given.y }, 1, given)
  end
  for number, item in ipairs(given) do
    if type(item) == "table" and item.value then
      check.fields(where, item, curve_fields, ("field %d: "):format(number))
      if not (item.x and item.y) then
        check.fail(where, "a field of values needs x and y, four corners a polygon")
      end
      panel.field = { x = item.x, y = item.y, value = item.value }
    else
      panel.curves[#panel.curves + 1] = to_curve(where, item, number, given)
    end
  end
end

local function to_panel(where, given)
  local key = given.key
  if key == nil then key = draw.default.key end
  local panel = {
    title = words(given.title),
    x = to_axis(given.xlabel, given.xrange, given.logx, given.xdown),
    y = to_axis(given.ylabel, given.yrange, given.logy, given.ydown),
    value = to_axis(given.vlabel, given.vrange),
    key = key == false and "none" or key ~= true and key or "below",
    equal = given.equal, levels = given.levels, curves = {},
  }
  to_curves(where, given, panel)
  return panel
end

-- A panel takes from the figure what it does not say itself, but the title.
local function inherit(panel, figure)
  local taken = {}
  for name in pairs(panel_fields) do
    if name ~= "title" and name ~= "x" and name ~= "y" then taken[name] = figure[name] end
  end
  return merged(taken, panel)
end

local function to_figure(where, given)
  check.fields(where, given, figure_fields)
  if not given.panels then
    return { panels = { to_panel(where, given) } }
  end
  local layout = given.layout or {}
  local figure = { title = words(given.title), rows = layout[1], columns = layout[2], panels = {},
    one_key = given.key == nil }
  for number, panel in ipairs(given.panels) do
    if type(panel) ~= "table" then
      check.fail(where, ("panel %d: expected a table, got %s"):format(number,
        check.shown(panel)))
    end
    check.fields(where, panel, panel_fields, ("panel %d: "):format(number))
    figure.one_key = figure.one_key and panel.key == nil
    figure.panels[number] = to_panel(where, inherit(panel, given))
  end
  return figure
end

-- --- where to draw ------------------------------------------------------------------------------

-- As wide as the terminal, as high as it can be read without scrolling away; panels in rows need
-- more.
local function text_size(figure)
  local columns, lines = term.size()
  local width = math.max(40, math.min(columns, 160))
  local height = math.min(math.max(24, width * 9 // 25), math.max(16, lines - 2))
  local count = #figure.panels
  local across = figure.columns or math.ceil(math.sqrt(count))
  local rows = figure.rows or math.ceil(count / across)
  return width, math.max(height, rows > 1 and 12 * rows + 2 or 0)
end

local function to_text(figure, given)
  local width, height = text_size(figure)
  local colour = given.colour
  if colour == nil then colour = draw.default.colour end
  if colour == nil then colour = term.colour() end
  return { medium = "text", width = width, height = height, colour = colour,
    ascii = not term.utf8() }
end

local function to_window(where, name)
  local screen = (os.getenv("DISPLAY") or "") .. (os.getenv("WAYLAND_DISPLAY") or "")
  if screen == "" then
    check.fail(where, "there is no screen for a window: neither DISPLAY nor WAYLAND_DISPLAY is "
      .. "set. Leave out term to draw in the terminal, or give file=", "MISSING")
  end
  return { medium = "window", terminal = name ~= "window" and name or nil }
end

local function to_file(where, file, kind)
  local ending = file:match("%.([^./]+)$") or ""
  if not file_kinds[ending:lower()] or (kind and kind ~= ending:lower()) then
    check.fail(where, ("field 'file': expected a name that ends in .%s, got \"%s\""):format(
      kind or gnuplot.endings:gsub(" ", ", ."):gsub(", (%S+)$", " or %1"), file))
  end
  if file:find("%z") then check.fail(where, "field 'file': a zero byte in the name") end
  return { medium = "file", file = file, ascii = false }
end

local function to_output(where, figure, given)
  local kind = given.term
  if not kind and not given.file then kind = draw.default.term end
  local output
  if given.file then
    local of_file = kind and file_kinds[kind]
    if kind and not of_file and kind ~= "dumb" then
      check.fail(where, ("field 'term': \"%s\" draws on the screen, but there is a file"):format(
        kind))
    end
    output = to_file(where, given.file, kind == "dumb" and "txt" or kind)
  elseif file_kinds[kind] then
    check.fail(where, ('field \'file\': term="%s" needs the name of a file, got nil'):format(kind))
  elseif windows[kind] then
    output = to_window(where, kind)
  elseif kind == "sixel" then
    output = { medium = "sixel" }
  else
    output = to_text(figure, given)
  end
  local size = given.size or (not given.file and draw.default.size)
  if size then output.width, output.height = size[1], size[2] end
  return output
end

-- --- drawing ------------------------------------------------------------------------------------

local last -- the figure drawn last, for plot.save

-- Calls a function of archard.gnuplot; what it raises or refuses becomes an error of `where`.
local function run(where, f, ...)
  local ok, result, message, code = pcall(f, ...)
  if not ok then check.fail(where, tostring(result)) end
  if not result then check.fail(where, message, code) end
  return result
end

-- Checks the options, draws, and returns the picture where it is one for the terminal.
local function render(where, given)
  check.fields(where .. ": plot.default", draw.default,
    { term = check.one_of(terms), size = check.size, colour = check.flag,
      key = check.one_of(keys, check.flag) })
  local figure = to_figure(where, given)
  local output = to_output(where, figure, given)
  local picture = run(where, gnuplot.draw, figure, output)
  last = figure
  return type(picture) == "string" and picture or nil
end

-- Draws what the options say; a picture for the terminal is printed.
function draw.draw(where, given)
  local picture = render(where, given)
  if picture then
    io.write(picture, picture:sub(-1) == "\n" and "" or "\n")
    io.flush()
  end
end

-- The picture as a string, for one who writes it in another way.
function draw.picture(where, given) return render(where, given) end

-- Writes a gif that moves: a list of options as plot{} takes them, each one frame.
function draw.film(where, frames, delay, given)
  local figures = {}
  for i, frame in ipairs(frames) do figures[i] = to_figure(where, frame) end
  local output = to_file(where, given.file, "gif")
  if given.size then output.width, output.height = given.size[1], given.size[2] end
  run(where, gnuplot.animate, figures, delay, output)
end

-- Writes a figure to a file, and its data beside it.
local function save(where, figure, file, options)
  local output = to_output(where, figure, { file = file, size = options.size, term = options.term })
  run(where, gnuplot.draw, figure, output)
  files.write(where, file:gsub("%.[^./]*$", "") .. ".csv", csv(figure))
  last = figure
end

-- save("p.png" [, options]): the last picture; save{ ..., file="p.png" }: this one.
function draw.save(where, given, options)
  if type(given) == "table" and given.file then
    save(where, to_figure(where, given), given.file, given)
  elseif type(given) == "string" then
    if not last then check.fail(where, "nothing has been drawn yet that could be saved") end
    save(where, last, given, check.fields(where, options or {}, output_fields))
  else
    check.fail(where, "expected the name of a file, or the table of plot{} with file=, got "
      .. (type(given) == "table" and "a table without file" or check.shown(given)))
  end
end

return draw

-- plot.style: sets the size of figures, letters and lines for print, slides or the screen.

local check = require "archard.lib.check"
local keys = require "archard.lib.keys"
local merged = require "archard.lib.merged"
local strict = require "archard.strict"

local style = {}

-- Presets of the styles. Widths are in mm, letter sizes in points, line widths relative to the style
-- "screen". `shape` is the ratio of height to width of a figure with one panel. The style "screen" has no
-- width in mm, because its figures are sized in pixels.
local presets = {
  screen = { name = "screen" },
  paper = { name = "paper", column = 85, page = 170, points = 8, lines = 0.8, dpi = 600,
    shape = 0.72 },
  journal = { name = "journal", column = 85, page = 170, points = 8, lines = 0.8, dpi = 600,
    shape = 0.72, title = false },
  slides = { name = "slides", column = 254, page = 254, points = 20, lines = 1.8, dpi = 150,
    shape = 0.5625 },
}
style.names = { "paper", "journal", "slides", "screen" }

local current = presets.screen

local function of_numbers(low, high)
  return check.kind(("a number in [%g, %g]"):format(low, high), function(v)
    return type(v) == "number" and v >= low and v <= high
  end)
end

-- An .svg file has the name of the font as an attribute, in which gnuplot escapes nothing.
local font = check.kind("the name of a font, without the characters \" < > & and control characters", function(v)
  return type(v) == "string" and not v:find '["<>&%c]'
end)

local fields = {
  width = check.one_of({ "column", "page", "single", "double" }, of_numbers(20, 1000)), height = of_numbers(15, 1000),
  font = font, points = of_numbers(3, 72), dpi = of_numbers(30, 2400),
  lines = of_numbers(0.1, 10), title = check.flag, colour = check.one_of({ "grey" }, check.flag),
}

-- Names of all fields of a style: the options and the fields of a preset.
local names = keys(merged(fields, { name = true, column = true, page = true, shape = true }))
local held = { __plain = true, __index = function(_, name) return strict.refuse("plot.style", name, names) end }

local as_column = { single = "column", double = "page" } -- names that journals use for these widths

local function shown(chosen) return setmetatable(merged(chosen), held) end

local function refuse_on_screen(given)
  for _, name in ipairs { "width", "height", "dpi" } do
    if given[name] ~= nil then
      check.fail("plot.style", ("field '%s': figures for the screen have their size in pixels, set by the field size "
        .. 'of plot{}; use "paper", "journal" or "slides" for a size in mm'):format(name))
    end
  end
end

-- plot.style "paper", plot.style{ "paper", width="page", ... }: sets the style of all following files.
-- Returns the current style.
function style.choose(given)
  if given == nil then return shown(current) end
  if type(given) == "string" then given = { given } end
  if type(given) ~= "table" then
    check.fail("plot.style", "expected a name or a table of options, got " .. check.shown(given))
  end
  local name, options = given[1] == nil and current.name or given[1], {}
  if not presets[name] then
    check.fail("plot.style", 'expected "paper", "journal", "slides" or "screen", got ' .. check.shown(name))
  end
  for key, value in pairs(given) do
    if key ~= 1 then options[key] = value end
  end
  options = check.fields("plot.style", options, fields)
  options.width = as_column[options.width] or options.width
  if name == "screen" then refuse_on_screen(options) end
  current = merged(given[1] == nil and current or presets[name], options)
  return shown(current)
end

-- --- the size of a figure ------------------------------------------------------------------------

-- Returns the width [mm] of a figure. A figure with several columns of panels is as wide as the page.
local function width_of(columns)
  local width = current.width or (columns > 1 and "page" or "column")
  return current[width] or width
end

local highest_panel, highest = 60, 240 -- largest height of a panel, height of a journal page [mm]

-- Returns the height [mm] of a figure. With one panel it follows from the field `shape`; panels in a grid are
-- slightly lower than wide.
local function height_of(width, rows, columns, size)
  if current.height then return current.height end
  if size then return width * size[2] / size[1] end
  if rows * columns == 1 then return width * current.shape end
  return math.min(highest, width / columns * 0.85 * rows + 8 + (columns > 2 and 16 or 0), highest_panel * rows + 8)
end

-- Returns the numbers of rows and columns of panels in a file. Stacked panels, which would be too flat, are
-- drawn side by side: up to two panels, or three if the style has a page width.
function style.grid(rows, columns)
  local most = current.page and 3 or 2
  if columns == 1 and rows <= most and current.width ~= "column" then return 1, rows end
  return rows, columns
end

-- Units per inch in vector formats: 96 in svg, as in browsers; 1000 in pdf and eps, which makes rounding
-- errors small.
local units = { svg = 96, pdf = 1000, eps = 1000 }

-- Sets size, resolution, letters and lines of an output to a file. `size`: size given by the caller [pixels],
-- which is scaled to the width of the style.
function style.apply(output, rows, columns, size, ending)
  output.points, output.lines, output.family = current.points, current.lines, current.font
  if not current.column then return end
  local width = width_of(columns)
  local height = height_of(width, rows, columns, size)
  local dpi = units[ending] or size and size[1] / (width / 25.4) or current.dpi
  output.dpi = dpi
  output.width = math.floor(width / 25.4 * dpi + 0.5)
  output.height = math.floor(height / 25.4 * dpi + 0.5)
end

-- Returns true if the style sets the size of pictures in mm.
function style.in_mm() return current.column ~= nil end
-- Returns false if the style omits default titles. A title given in the call is drawn in all styles.
function style.titled() return current.title ~= false end

-- Returns the colours of the style: true, false or "grey", or nil if the style does not set them.
function style.colour() return current.colour end

return style

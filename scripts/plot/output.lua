-- Chooses the output and the size of a figure: characters, dots or pixels in the terminal, a window, or a
-- file.

local gnuplot = require "archard.gnuplot"
local term = require "archard.term"
local check = require "archard.lib.check"
local style = require "archard.plot.style"

local output = {}

output.default = {} -- defaults of term, size, colour and key, set by the user

local windows = { window = true, qt = true, wxt = true, x11 = true }
local file_kinds = {}
output.terms = { "dumb", "dots", "kitty", "sixel", "window", "qt", "wxt", "x11" }
for ending in gnuplot.endings:gmatch("%S+") do
  output.terms[#output.terms + 1], file_kinds[ending] = ending, true
end

local function grid_of(figure)
  local count = #figure.panels
  local columns = figure.columns or figure.rows and math.ceil(count / figure.rows)
    or math.ceil(math.sqrt(count))
  return figure.rows or math.ceil(count / columns), columns
end

-- --- the terminal --------------------------------------------------------------------------------

-- Returns the size of a picture in characters: the width of the terminal and a height that fits without
-- scrolling. The height is larger if the panels are in several rows.
local function text_size(figure)
  local columns, lines = term.size()
  local width = math.max(40, math.min(columns, 160))
  local height = math.min(math.max(24, width * 9 // 25), math.max(16, lines - 2))
  local rows = grid_of(figure)
  return width, math.max(height, rows > 1 and 12 * rows + 2 or 0)
end

-- Returns the user's choice of colours in the call or in plot.default: true for colours, false for greys or
-- plain characters, nil if the user made no choice.
local function colours_of(given)
  local colour = given.colour
  if colour == nil then colour = output.default.colour end
  if colour == "grey" then return false end
  return colour
end

local function to_text(figure, given, fine)
  local width, height = text_size(figure)
  local colour = colours_of(given)
  if colour == nil then colour = fine or term.colour() end
  return { medium = "text", width = width, height = height, colour = colour, fine = fine,
    ascii = not term.utf8() }
end

-- Returns the output for a picture in pixels. The picture is as large as a picture of characters, and its
-- letters are as large as those of the terminal. If the terminal does not report its size in pixels, cells of
-- 8 by 16 pixels are assumed.
local function to_pixels(figure, kind)
  local columns, lines = term.size()
  local wide, high = term.pixels()
  local cell_x, cell_y = (wide or 8 * columns) / columns, (high or 16 * lines) / lines
  local width, height = text_size(figure)
  return { medium = kind == "kitty" and "png" or kind, shown_by = kind,
    width = math.floor(math.min(width, 110) * cell_x), height = math.floor(height * cell_y),
    dpi = math.max(50, 100 * cell_y / 18) }
end

-- Returns true if the terminal can show Braille dots. The usual fonts of xterm have no such glyphs; other
-- terminals use fallback fonts.
local function shows_dots() return term.utf8() and not os.getenv "XTERM_VERSION" end

-- Returns the best output of the terminal: pixels if they are supported, else coloured dots in a UTF-8
-- terminal, else characters.
local function best(figure, given, moving)
  local colour = colours_of(given)
  if colour == nil then colour = term.colour() end
  if not colour or not term.is_terminal() then return to_text(figure, given, false) end
  local pictures = not moving and term.pictures()
  if pictures == "kitty" then return to_pixels(figure, pictures) end
  if pictures == "sixel" and select(2, gnuplot.about()):find(" sixelgd ", 1, true) then
    return to_pixels(figure, pictures)
  end
  return to_text(figure, given, shows_dots())
end

local function to_window(where, name)
  local screen = (os.getenv("DISPLAY") or "") .. (os.getenv("WAYLAND_DISPLAY") or "")
  if screen == "" then
    check.fail(where, "no screen for a window: neither DISPLAY nor WAYLAND_DISPLAY is "
      .. "set. Leave out term to draw in the terminal, or give file=", "MISSING")
  end
  return { medium = "window", terminal = name ~= "window" and name or nil }
end

-- Returns the output for a picture on the screen. If `moving` is true, the picture is part of an animation,
-- for which output in pixels is too slow.
local function to_screen(where, figure, given, kind, moving)
  if windows[kind] then return to_window(where, kind) end
  if kind == "sixel" or kind == "kitty" then return to_pixels(figure, kind) end
  if kind then return to_text(figure, given, kind == "dots") end
  return best(figure, given, moving)
end

-- --- files ---------------------------------------------------------------------------------------

function output.to_file(where, figure, file, kind, size)
  local ending = (file:match("%.([^./]+)$") or ""):lower()
  if not file_kinds[ending] or (kind and kind ~= ending) then
    check.fail(where, ("field 'file': expected a name that ends in .%s, got \"%s\""):format(
      kind or gnuplot.endings:gsub(" ", ", ."):gsub(", (%S+)$", " or %1"), file))
  end
  if file:find("%z") then check.fail(where, "field 'file': the name contains a zero byte") end
  local to = { medium = "file", file = file, ascii = false }
  if size then to.width, to.height = size[1], size[2] end
  if ending ~= "txt" then
    local rows, columns = grid_of(figure)
    style.apply(to, rows, columns, size, ending)
  end
  return to
end

-- --- choice of the output ------------------------------------------------------------------------

-- Returns true if the picture has greys only. This is set in the call, in plot.default or, for files without
-- such a setting, in the style.
local function is_grey(given)
  local colour = colours_of(given)
  if colour == nil and given.file then colour = style.colour() end
  return colour == false or colour == "grey"
end

local function chosen(where, figure, given, moving)
  local kind = given.term
  if given.file then
    if kind and not file_kinds[kind] and kind ~= "dumb" then
      check.fail(where, ("field 'term': \"%s\" draws on the screen, but a file is given"):format(
        kind))
    end
    return output.to_file(where, figure, given.file, kind == "dumb" and "txt" or kind,
      given.size or output.default.file_size)
  end
  kind = kind or output.default.term
  if file_kinds[kind] then
    check.fail(where, ('field \'file\': term="%s" needs the name of a file, got nil'):format(kind))
  end
  local to = to_screen(where, figure, given, kind, moving)
  local size = given.size or output.default.size
  -- The size is in characters if the program chose the terminal output, else in the unit of the output.
  if size and not (to.shown_by and not given.term and not output.default.term) then
    to.width, to.height = size[1], size[2]
  elseif size then -- convert from characters to pixels
    local columns, lines = term.size()
    local wide, high = term.pixels()
    to.width = math.floor(size[1] * (wide or 8 * columns) / columns)
    to.height = math.floor(size[2] * (high or 16 * lines) / lines)
  end
  return to
end

function output.choose(where, figure, given, moving)
  local to = chosen(where, figure, given, moving)
  to.grey = is_grey(given)
  return to
end

-- Kinds of output to which a curve may be restricted. Characters cannot show overlapping areas.
output.surfaces = { "pixels", "characters" }

function output.surface(to)
  local characters = to.medium == "text" or to.file and to.file:lower():find "%.txt$"
  return characters and "characters" or "pixels"
end

-- --- pictures for the terminal -------------------------------------------------------------------

local letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/"

local function base64(bytes)
  local out = {}
  for i = 1, #bytes, 3 do
    local a, b, c = bytes:byte(i, i + 2)
    local n = a << 16 | (b or 0) << 8 | (c or 0)
    for k = 3, 0, -1 do
      local at = (n >> 6 * k & 63) + 1
      out[#out + 1] = (k == 1 and not b or k == 0 and not c) and "=" or letters:sub(at, at)
    end
  end
  return table.concat(out)
end

-- Returns the escape sequences that show a PNG picture in kitty. The protocol allows at most 4096 characters
-- of data per sequence.
local function for_kitty(png)
  local text, pieces = base64(png), {}
  for i = 1, #text, 4096 do
    local more = i + 4096 <= #text and 1 or 0
    pieces[#pieces + 1] = ("\27_G%sm=%d;%s\27\\"):format(i == 1 and "a=T,f=100,q=2," or "", more,
      text:sub(i, i + 4095))
  end
  return table.concat(pieces) .. "\n"
end

-- Returns the bytes that show a picture in the terminal.
function output.written(picture, to)
  if to.shown_by == "kitty" then return for_kitty(picture) end
  return picture:sub(-1) == "\n" and picture or picture .. "\n"
end

return output

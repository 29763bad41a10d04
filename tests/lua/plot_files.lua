-- Tests the files of plot{...}: formats, sizes for print, file names that contain commands, and a missing,
-- old or slow gnuplot.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local pictures = dofile(here .. "/lib/pictures.lua")
local ok, has, refused = tap.ok, tap.holds, tap.fails
local folder, read, picture_of, line = pictures.folder, pictures.read, pictures.picture_of, pictures.line
local gnuplot = require "archard.gnuplot"

-- --- commands in texts are not executed ---------------------------------------------------------

do
  local ran = folder .. "/ran"
  local evil = ("`touch %s` ' \n!touch %s\n\"; system('touch %s') \\ |<\0\27[31m"):format(ran, ran,
    ran)
  local text = picture_of(function(file)
    plot { { x = { 1, 2 }, y = { 1, 2 }, title = evil }, title = evil, xlabel = evil,
      ylabel = evil, size = { 300, 24 }, file = file }
  end)
  has(text, "`touch " .. ran .. "`", "a title is shown unchanged")
  ok(not text:find("\27"), "a text file contains no escape code")
  plot { { x = { 1, 2 }, y = { 1, 2 }, title = "a]]>b" }, title = "]]>", xlabel = "x_1]]>", file = folder .. "/xml.svg" }
  ok(not read "xml.svg":find("]]>", 1, true), "an .svg has no end of a CDATA section, which XML does not allow in texts")
  pcall(plot, { line, file = folder .. "/`touch ran`.png" })
  pcall(plot, { line, file = "|touch " .. ran .. ".png" })
  os.remove("|touch " .. ran .. ".png")
  ok(not read("ran") and not read("ran.png"), "commands in texts and file names are not executed")
end

-- --- keys ---------------------------------------------------------------------------------------

-- Tests that the key below three panels has all entries, also in an .svg, in which gnuplot assumes wider letters.
do
  plot.style "journal"
  local panel = {}
  for i = 1, 8 do panel[i] = { y = { i, 2 * i }, title = ("α = 0.%d5, s = 0.%d2 mm"):format(i, i) } end
  plot { panels = { panel, panel, panel }, layout = { 1, 3 }, file = folder .. "/key.svg" }
  plot.style "screen"
  local text, missing = read "key.svg", {}
  for _, curve in ipairs(panel) do
    if not text:find("<text>" .. curve.title, 1, true) then missing[#missing + 1] = curve.title end
  end
  tap.is(table.concat(missing, "; "), "", "all eight titles are in the key of an .svg of a journal's page")
end

-- --- files --------------------------------------------------------------------------------------

local first_bytes = { png = "\137PNG", svg = "<?xml", pdf = "%PDF", gif = "GIF8", gp = "# Draw" }
for ending, first in pairs(first_bytes) do
  plot { line, file = folder .. "/f." .. ending }
  ok((read("f." .. ending) or ""):sub(1, #first) == first, "a file of kind " .. ending)
end
refused(function() plot { line, file = folder .. "/no/f.png" } end, "No such file",
  "a missing folder")

do
  plot.save { line, { x = { 1, 2 }, y = { 0.1, 0 / 0 }, title = 'a "b", c' }, xlabel = "x / mm",
    file = folder .. "/s.png" }
  local lines = {}
  for row in (read("s.csv") or ""):gmatch("[^\n]+") do lines[#lines + 1] = row end
  ok(read("s.png"), "plot.save draws a picture")
  ok(lines[1] == 'squares: x / mm,squares: y,"a ""b"", c: x / mm","a ""b"", c: y"',
    "plot.save writes the names of the columns")
  ok(lines[2] == "0,0,1,0.1", "plot.save writes the shortest numbers that are read back exactly")
  ok(lines[3] == "1,1,2,nan" and lines[5] == "3,9,,",
    "plot.save writes nan; shorter columns have empty cells")
  plot { { x = { 7, 8 }, y = { 1, 2 } }, file = folder .. "/shown.txt" }
  plot.save(folder .. "/again.svg")
  has(read("again.csv") or "", "\n8,2\n", "plot.save(path) saves the last picture")
  refused(function() plot.save {} end, "without file", "plot.save without a file")
  refused(function() plot.save(folder .. "/x.svg", { siez = 1 }) end, "did you mean 'size'",
    "plot.save checks its options")
end

-- --- for print -----------------------------------------------------------------------------------

-- Returns the width and height of a PNG file [pixels], and its pixels per metre if the file states them.
local function png_size(name)
  local png = read(name) or ""
  if #png < 24 then return 0, 0 end
  return string.unpack(">I4", png, 17), string.unpack(">I4", png, 21)
end

do
  plot.style "paper"
  plot { line, file = folder .. "/c.png" }
  local width, height = png_size("c.png")
  ok(width == 2008 and height == 1446, "style paper: a column of 85 mm at 600 dpi (" .. width .. ")")
  plot { panels = { { line }, { line } }, layout = { 1, 2 }, file = folder .. "/c.png" }
  ok(png_size("c.png") == 4016, "panels side by side have the page's width of 170 mm")
  plot.style { width = "page", dpi = 300 }
  plot { line, file = folder .. "/c.png" }
  ok(png_size("c.png") == 2008, "a later option of the style applies to later files")
  plot { line, file = folder .. "/c.png", size = { 1000, 500 } }
  width, height = png_size("c.png")
  ok(width == 1000 and height == 500, "a size given in pixels")
  for _, evil in ipairs{ 'x" onload="alert(1)', "a\nb", "<b>" } do
    refused(function() plot.style{ font = evil } end, "plot.style: field 'font': expected the name of a font", "a font that is no name: " .. evil:gsub("%c", " "))
  end
  plot.style { "paper", font = "Serif" }
  plot { line, file = folder .. "/c.pdf" }
  local box_x, box_y = (read("c.pdf") or ""):match("/MediaBox %[ 0 0 (%d+) (%d+) ?%]")
  ok(box_x == "240" and box_y == "173", "a PDF file has the printed size, 240 by 173 pt")
  local held = plot.style()
  ok(held.name == "paper" and held.points == 8 and held.font == "Serif", "plot.style() returns the style")
  plot.style "slides"
  plot { line, file = folder .. "/c.png" }
  ok(png_size("c.png") == 1500, "style slides: 254 mm at 150 dpi")
  refused(function() plot.style "poster" end, '"paper", "journal", "slides" or "screen"', "an unknown style")
  refused(function() plot.style { "paper", widht = 3 } end, "did you mean 'width'",
    "a misspelt option of a style")
  refused(function() plot.style { "paper", width = 5 } end, "a number in [20, 1000]",
    "a style with a width of 5 mm")
  refused(function() plot.style { "screen", width = 85 } end, "size in pixels",
    "a width in mm for the screen")
  plot.style "screen"
  plot { line, file = folder .. "/c.png" }
  ok(png_size("c.png") == 900, "the screen style restores the sizes")
end

-- --- a defective gnuplot ------------------------------------------------------------------------

local function fake(name, body)
  local path = folder .. "/" .. name
  local file = io.open(path, "w")
  file:write("#!/bin/sh\n", body, "\n")
  file:close()
  os.execute("chmod 755 " .. path)
  gnuplot.use(path)
end

do
  gnuplot.use("no-such-gnuplot")
  refused(function() plot { line } end, "apt-get install gnuplot-nox", "gnuplot is missing")
  local _, problem = pcall(plot, { line })
  ok(problem.code == "MISSING", "the error code MISSING")
  fake("dying", "exit 3")
  refused(function() plot { line } end, "exit status 3", "gnuplot ends when it is started")
  fake("slow", "sleep 0.5; exec gnuplot \"$@\"")
  has(picture_of(function(file) plot { line, file = file } end), "squares",
    "a gnuplot that starts slowly is used")
  gnuplot.use("gnuplot")
  has(picture_of(function(file) plot { line, file = file } end), "squares", "drawing works again after a failure")
  local version, terminals = gnuplot.about()
  ok(version >= 5.2 and terminals:find(" dumb "), "about() returns version and terminals")
end

pictures.remove()

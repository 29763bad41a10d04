-- Tests plot{...}: curves, panels, axes, keys, refused input. Pictures are written to .txt or .gp files and
-- read back.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local pictures = dofile(here .. "/lib/pictures.lua")
local ok, has, refused = tap.ok, tap.holds, tap.fails
local folder, read, picture_of, script_of, line = pictures.folder, pictures.read, pictures.picture_of, pictures.script_of, pictures.line

-- --- curves -------------------------------------------------------------------------------------

do
  local text = picture_of(function(file)
    plot { line, title = "a title", xlabel = "x / mm", ylabel = "y / µm", file = file }
  end)
  has(text, "a title", "a plot shows its title")
  has(text, "x / mm", "a plot shows the label of x")
  has(text, "y / µm", "a plot shows the label of y in UTF-8")
  has(text, "* squares", "the key names the curve")
  ok(not text:find("\27"), "a text file contains no colours")

  text = picture_of(function(file) plot { y = { 3, 1, 2 }, file = file } end)
  ok(#text > 100, "a curve without x is drawn over 1, 2, 3")

  text = picture_of(function(file)
    plot { line, { x = { 0, 3 }, y = { 0, 9 } }, key = false, file = file }
  end)
  ok(not text:find("squares"), "key=false draws no key")

  text = picture_of(function(file)
    plot { { x = { 1, 10, 100 }, y = { 1, 100, 10000 } }, logx = true, logy = true, file = file }
  end)
  has(text, "10000", "logarithmic axes")

  text = picture_of(function(file) plot { line, xrange = { 3, 0 }, file = file } end)
  ok(text:match("\n +3%.0 .* 0%.0\n"), "a reversed range reverses the axis")
end

for _, style in ipairs { "lines", "points", "linespoints", "steps", "filled", "impulses" } do
  local text = picture_of(function(file) plot { line, style = style, file = file } end)
  has(text, "squares", "style " .. style)
end

-- --- panels -------------------------------------------------------------------------------------

do
  local panels = {}
  for i = 1, 12 do panels[i] = { line, title = "panel " .. i } end
  local text = picture_of(function(file)
    plot { panels = panels, layout = { 4, 3 }, size = { 100, 60 }, title = "all", file = file }
  end)
  has(text, "panel 12", "twelve panels are drawn")
  local keys = select(2, text:gsub("squares", ""))
  ok(keys == 1, "twelve panels have one key")
  refused(function() plot { panels = panels, layout = { 2, 2 } } end, "do not fit",
    "a layout with too few panels")
end

-- --- numbers on axes ------------------------------------------------------------------------------

do
  local text = picture_of(function(file)
    plot { x = { 0, 1 }, y = { 1e-8, 2e-9 }, ylabel = "k", file = file }
  end)
  has(text, " 2e-9 +", "small numbers have a short form")
  local small = { x = { 0, 1 }, y = { 1e-8, 2e-9 }, ylabel = "k", xlabel = "d" }
  local large = { x = { 0, 1 }, y = { 1.0000001, 1.0000004 }, ylabel = "p", xlabel = "d" }
  plot { panels = { small, large }, layout = { 2, 1 }, file = folder .. "/n.gp" }
  local script = read("n.gp") or ""
  has(script, { 'set ylabel "k / 10⁻⁸"', "\n0 1\n1 0.2" }, "files divide small numbers by a power of ten")
  has(script, "set format y '%.8f'", "enough digits to distinguish neighbouring numbers")
  plot { x = { 0, 1 }, y = { 1e-8, 2e-9 }, file = folder .. "/b.gp" }
  has(read "b.gp", "set format y '%.0t×10^{%T}'", "an axis without a label has powers of ten at its numbers")
  plot { x = { 1, 2e6 }, y = { 1e-8, 2e-9 }, xlabel = "cycles", ylabel = "k / (mm²/N)", logx = true, file = folder .. "/b.gp" }
  has(read "b.gp", { 'set xlabel "cycles"', 'set ylabel "k / (10⁻⁸ mm²/N)"' }, "a logarithmic axis is not divided")
  local margins = {}
  for left in script:gmatch("set lmargin at screen ([%d.]+)\nset rm") do
    margins[#margins + 1] = tonumber(left)
  end
  ok(#margins == 2 and margins[1] == margins[2], "the frames of two panels are aligned")
  ok(margins[1] and margins[1] * 900 / 8 > 9 + 3.2, "the margin contains the longest number and the label")
  local narrow = { x = { -0.1, 0, 0.1 }, y = { 0, 1, 0 }, xrange = { -0.1, 0.1 } }
  plot { panels = { narrow, narrow }, layout = { 1, 2 }, file = folder .. "/x.gp" }
  local step = (read("x.gp") or ""):match("set xtics ([%d.e-]+)")
  ok(tonumber(step) and tonumber(step) > 0.02, "the distance of the numbers on the x axis is large enough")
  narrow.xrange = { -0.47, 0.47 }
  plot { panels = { narrow, narrow }, layout = { 1, 2 }, size = { 340, 200 }, file = folder .. "/x.gp" }
  step = (read("x.gp") or ""):match("set xtics ([%d.e-]+)")
  ok(tonumber(step) and tonumber(step) <= 0.47, "a narrow axis has more than one number")
end

-- --- figures with many curves, panel letters ----------------------------------------------------

do
  local curves = {}
  for i = 1, 8 do curves[i] = { x = { 0, 1 }, y = { 0, i }, title = "curve " .. i } end
  local script, dashes = script_of(function(file) curves.file = file plot(curves) end), {}
  local different = 0
  for dash in script:gmatch("dashtype (%S+)") do
    if not dashes[dash] then dashes[dash], different = true, different + 1 end
  end
  ok(different == 7, "eight curves have seven dash patterns and a solid line")
  for i = 9, 12 do curves[i] = { x = { 0, 1 }, y = { 0, i }, title = "curve " .. i } end
  script = script_of(function(file) curves.file = file plot(curves) end)
  has(script, "unset key", "more than eight curves have no key")
  has(script, 'set label 12 "curve 12" noenhanced at graph 1.015, graph 1', "many curves are labelled at their ends")
  ok(not script:find("title \"curve"), "many curves have no key")
  for i = 1, 12 do curves[i].value = i end
  curves.vlabel = "\\alpha"
  script = script_of(function(file) curves.file = file plot(curves) end)
  has(script, "linecolor palette cb 7", "curves with values have colours of a scale")
  has(script, 'set cblabel "α"', "the colour scale has a label")
  curves.file, curves.size = folder .. "/s.txt", { 100, 40 }
  plot(curves)
  local named = select(2, (read("s.txt") or ""):gsub("curve %d", ""))
  ok(named == 8, "a text picture names eight of twelve curves (" .. named .. ")")
end

do
  local script = script_of(function(file)
    plot { panels = { { line, title = "left" }, { line } }, file = file }
  end)
  has(script, 'set title "(a) left"', "a panel with a title has a letter")
  has(script, 'set title "(b)"', "a panel without a title has a letter")
  script = script_of(function(file)
    plot { panels = { { line, title = "left" }, { line } }, letters = false, file = file }
  end)
  has(script, 'set title "left"', "letters=false draws no letters")
  script = script_of(function(file)
    plot { line, title = ("a long title of many words, "):rep(6), file = file }
  end)
  ok(script:match('set title "[^\n]+,"%."\\n"%."a long'), "a long title is broken into lines")
  script = script_of(function(file) plot { x = { 0, 1 }, y = { 0, 7e-4 }, file = file } end)
  has(script, "set format y '%.0t×10^{%T}'", "an axis of small numbers uses powers of ten")
  script = script_of(function(file) plot { x = { 0, 1 }, y = { 0, 0.7 }, file = file } end)
  has(script, "set format y '%.1f'", "other numbers have as many decimals as their step")
end

-- --- refused input ------------------------------------------------------------------------------

local function refusals(list)
  for _, case in ipairs(list) do
    refused(function() plot(case[1]) end, case[2], "refused: " .. case[2])
  end
end

refusals {
  { { line, tilte = "x" }, "unknown field 'tilte' (did you mean 'title'?)" },
  { { { x = { 1 }, y = { 1 }, tytle = "" } }, "unknown field 'curve 1: tytle' (did you mean 'title'?)" },
  { { line, style = "line" }, "field 'style': expected \"lines\"" },
  { { line, xrange = { 1, 1 } }, "field 'xrange': expected { low, high }" },
  { { line, size = { 0, 1 } }, "field 'size'" },
  { { line, term = "ps" }, "field 'term'" },
  { { line, term = "png" }, "needs the name of a file" },
  { { line, file = "a.bmp" }, "ends in .png" },
  { { line, file = "a" }, "ends in .png" },
  { { line, term = "svg", file = "a.png" }, "ends in .svg" },
  { { line, term = "sixel", file = "a.png" }, "draws on the screen" },
  { { { x = { 1, 2 }, y = { 1 } } }, "x has 2 numbers, y has 1" },
  { { { x = { 1, "2" }, y = { 1, 2 } } }, "x[2] must be a number, got string" },
  { { { x = { 0 / 0 }, y = { 1 } } }, "no point whose x and y are both finite" },
  { { { x = { 1 }, y = { 1 }, colour = "reddish" } }, "colour must be" },
  { {}, "nothing to draw" },
  { { { x = {}, y = {} } }, "has no points" },
  { { { x = { 1 }, y = { -1 } }, logy = true }, "no positive point" },
  { { line, xrange = { 5, 6 } }, "no point lies in the x range 5 to 6" },
  { { "words" }, "curve 1: expected a table" },
}

do
  local _, problem = pcall(plot, { line, tilte = "x" })
  ok(problem.code == "ARGUMENT" and problem.where == "plot", "an error has a code and a function")
  local chunk = load("\nplot{ tilte = 1 }", "=mine")
  _, problem = pcall(chunk)
  has(tostring(problem), "mine:2: plot: unknown field", "an error contains the line of the user's script")
  refused(function() plot(nil) end, "got nil", "plot without a table")
  refused(function() plot.default.term = "dump" end, "plot.default: field 'term'",
    "an invalid default is refused")
  plot.default.term = "dumb"
  plot.default.term = "dump"
  refused(function() plot { line } end, "plot.default: field 'term'", "a wrong default is reported by any plot")
  plot.default.term = nil
  refused(function() plot.default.sise = { 60, 12 } end, "plot.default: unknown field 'sise' (did you mean 'size'?)",
    "an unknown default is refused")
  refused(function() return plot.default.siz end, "plot.default: no field 'siz'; did you mean 'size'?",
    "reading of an unknown default is refused")
  ok(plot.default.size == nil, "a default that is not set is nil")
  plot.default.file_size = { 44, 11 }
  local small = picture_of(function(file) plot { line, file = file } end)
  local longest = 0
  for row in small:gmatch("[^\n]+") do longest = math.max(longest, utf8.len(row)) end
  ok(longest > 30 and longest <= 44, ("files have their own default size (%d columns)"):format(longest))
  plot.default.file_size = nil
end

-- --- downwards --------------------------------------------------------------------------------------
do
  local function first_tick(options)
    local text = picture_of(function(file)
      plot { line, yrange = options[1], ydown = options[2], size = { 60, 14 }, file = file }
    end)
    return text:match("(%d+) +%+")
  end
  ok(first_tick{ { 0, 20 }, false } == "20", "the larger end of the range is at the top")
  ok(first_tick{ { 0, 20 }, true } == "0", "ydown reverses a range")
  ok(first_tick{ { 20, 0 }, true } == "0", "ydown reverses a range given in either order")
end

pictures.remove()

-- Tests a key of three lines below a picture drawn by characters.
do
  local titles, given = { "a", "a long title that takes half of it", "c", "d", "e" }, { term = "dots", size = { 90, 22 } }
  for i, title in ipairs(titles) do
    given[i] = { x = { 1, 2 }, y = { i, i + 1 }, style = i > 2 and "points" or "lines", title = title }
  end
  local words = require "archard.plot.draw".picture("plot", given):gsub("\27%[[%d;]*m", "")
  for _, title in ipairs(titles) do ok(words:find(title .. "%s", 1), "key of dots: " .. title) end
end

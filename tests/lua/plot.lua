-- plot{...} and plot.*: with tables that stand in for the objects of the engine, and with a gnuplot
-- that is missing, old or slow. Pictures go to files that end in .txt, and are read back.

local gnuplot = require "archard.gnuplot"

local number, failed = 0, 0

local function ok(condition, what)
  number = number + 1
  if not condition then failed = failed + 1 end
  print((condition and "ok %d - %s" or "not ok %d - %s"):format(number, what))
end

local folder = os.tmpname()
os.remove(folder)
os.execute("mkdir " .. folder)

local function read(name)
  local file = io.open(folder .. "/" .. name, "rb")
  if not file then return nil end
  local text = file:read("a")
  file:close()
  return text
end

-- The picture in characters of what the function draws; it must hand `file` on.
local function picture_of(draw)
  os.remove(folder .. "/p.txt")
  draw(folder .. "/p.txt")
  return read("p.txt") or ""
end

local function has(text, words, what)
  local found = text:find(words, 1, true)
  if not found then print("# no '" .. words .. "' in:\n# " .. text:gsub("\n", "\n# ")) end
  ok(found, what)
end

local function refused(f, words, what)
  local fine, message = pcall(f)
  message = tostring(message)
  local right = not fine and message:find(words, 1, true)
  if not right then print("# got: " .. message) end
  ok(right, what)
end

-- --- curves -------------------------------------------------------------------------------------

local line = { x = { 0, 1, 2, 3 }, y = { 0, 1, 4, 9 }, title = "squares" }

do
  local text = picture_of(function(file)
    plot { line, title = "a title", xlabel = "x / mm", ylabel = "y / µm", file = file }
  end)
  has(text, "a title", "the title is there")
  has(text, "x / mm", "the label of x is there")
  has(text, "y / µm", "the label of y is there, in UTF-8")
  has(text, "* squares", "the key names the curve")
  ok(not text:find("\27"), "a file of characters has no colours")

  text = picture_of(function(file) plot { y = { 3, 1, 2 }, file = file } end)
  ok(#text > 100, "a curve without x is drawn against 1, 2, 3")

  text = picture_of(function(file)
    plot { line, { x = { 0, 3 }, y = { 0, 9 } }, key = false, file = file }
  end)
  ok(not text:find("squares"), "key=false draws no key")

  text = picture_of(function(file)
    plot { { x = { 1, 10, 100 }, y = { 1, 100, 10000 } }, logx = true, logy = true, file = file }
  end)
  has(text, "10000", "logarithmic axes")

  text = picture_of(function(file) plot { line, xrange = { 3, 0 }, file = file } end)
  ok(text:match("\n +3 .* 0\n"), "a range can be turned round")
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
  has(text, "panel 12", "twelve panels")
  local keys = select(2, text:gsub("squares", ""))
  ok(keys == 1, "one key for all of them")
  refused(function() plot { panels = panels, layout = { 2, 2 } } end, "do not fit",
    "a layout that is too small")
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
  has(script, "set format y '%.0t×10^{%T}'", "as a power of ten in files")
  has(script, "set format y '%.9g'", "and as many digits as neighbours need")
  local margins = {}
  for left in script:gmatch("set lmargin at screen ([%d.]+)\nset rm") do
    margins[#margins + 1] = tonumber(left)
  end
  ok(#margins == 2 and margins[1] == margins[2], "frames stand in line")
  ok(margins[1] and margins[1] * 900 / 8 > 9 + 3.2, "with room for the longest number and the label")
  local narrow = { x = { -0.1, 0, 0.1 }, y = { 0, 1, 0 }, xrange = { -0.1, 0.1 } }
  plot { panels = { narrow, narrow }, layout = { 1, 2 }, file = folder .. "/x.gp" }
  local step = (read("x.gp") or ""):match("set xtics ([%d.e-]+)")
  ok(tonumber(step) and tonumber(step) > 0.02, "numbers of x do not touch")
end

-- --- what is refused ----------------------------------------------------------------------------

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
  { { { x = { 1, 2 }, y = { 1 } } }, "x holds 2 numbers and y 1" },
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
  ok(problem.code == "ARGUMENT" and problem.where == "plot", "an error has a code and a place")
  local chunk = load("\nplot{ tilte = 1 }", "=mine")
  _, problem = pcall(chunk)
  has(tostring(problem), "mine:2: plot: unknown field", "an error names the user's line")
  refused(function() plot(nil) end, "got nil", "plot without a table")
  refused(function() plot.default.term = "dump" end, "plot.default: field 'term'", "a wrong default")
  plot.default.term = "dumb"
  plot.default.term = "dump"
  refused(function() plot { line } end, "plot.default: field 'term'", "also in the place of another")
  plot.default.term = nil
  refused(function() plot.default.sise = { 60, 12 } end, "plot.default: unknown field 'sise' (did you mean 'size'?)",
    "an unknown one")
  refused(function() return plot.default.siz end, "plot.default: no field 'siz'; did you mean 'size'?", "read, too")
  ok(plot.default.size == nil, "none by itself")
  plot.default.file_size = { 44, 11 }
  local small = picture_of(function(file) plot { line, file = file } end)
  local longest = 0
  for row in small:gmatch("[^\n]+") do longest = math.max(longest, utf8.len(row)) end
  ok(longest > 30 and longest <= 44, ("files have a default size of their own (%d columns)"):format(longest))
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
  ok(first_tick{ { 0, 20 }, false } == "20", "the larger end of the range is above")
  ok(first_tick{ { 0, 20 }, true } == "0", "ydown turns a range")
  ok(first_tick{ { 20, 0 }, true } == "0", "whichever end it names first")
end

-- --- nothing is run -----------------------------------------------------------------------------

do
  local ran = folder .. "/ran"
  local evil = ("`touch %s` ' \n!touch %s\n\"; system('touch %s') \\ |<\0\27[31m"):format(ran, ran,
    ran)
  local text = picture_of(function(file)
    plot { { x = { 1, 2 }, y = { 1, 2 }, title = evil }, title = evil, xlabel = evil,
      ylabel = evil, size = { 300, 24 }, file = file }
  end)
  has(text, "`touch " .. ran .. "`", "a title is shown as it stands")
  ok(not text:find("\27"), "no escape code gets through")
  pcall(plot, { line, file = folder .. "/`touch ran`.png" })
  pcall(plot, { line, file = "|touch " .. ran .. ".png" })
  os.remove("|touch " .. ran .. ".png")
  ok(not read("ran") and not read("ran.png"), "nothing of it runs")
end

-- --- files --------------------------------------------------------------------------------------

local first_bytes = { png = "\137PNG", svg = "<?xml", pdf = "%PDF", gif = "GIF8", gp = "# Draw" }
for ending, first in pairs(first_bytes) do
  plot { line, file = folder .. "/f." .. ending }
  ok((read("f." .. ending) or ""):sub(1, #first) == first, "a file of kind " .. ending)
end
refused(function() plot { line, file = folder .. "/no/f.png" } end, "No such file",
  "a folder that is not there")

do
  plot.save { line, { x = { 1, 2 }, y = { 0.1, 0 / 0 }, title = 'a "b", c' }, xlabel = "x / mm",
    file = folder .. "/s.png" }
  local lines = {}
  for row in (read("s.csv") or ""):gmatch("[^\n]+") do lines[#lines + 1] = row end
  ok(read("s.png"), "plot.save draws")
  ok(lines[1] == 'squares: x / mm,squares: y,"a ""b"", c: x / mm","a ""b"", c: y"',
    "and names the columns")
  ok(lines[2] == "0,0,1,0.1", "the shortest numbers that read back to the same bits")
  ok(lines[3] == "1,1,2,nan" and lines[5] == "3,9,,", "nan, and shorter columns end early")
  plot { { x = { 7, 8 }, y = { 1, 2 } }, file = folder .. "/shown.txt" }
  plot.save(folder .. "/again.svg")
  has(read("again.csv") or "", "\n8,2\n", "plot.save(path) saves the last picture")
  refused(function() plot.save {} end, "without file", "plot.save without a file")
  refused(function() plot.save(folder .. "/x.svg", { siez = 1 }) end, "did you mean 'size'",
    "plot.save checks its options")
end

-- --- objects ------------------------------------------------------------------------------------

-- A stand-in for a wear object; refuses names it does not know, as objects do.
local function stand_in(fields)
  fields.pressure = function(_, body)
    return { x = { -0.2, -0.1, 0, 0.1, 0.2 }, p = { 0, 300, body == "plate" and 500 or 400, 300, 0 } }
  end
  fields.profile = function(_, body)
    return { x = { -0.2, -0.1, 0, 0.1, 0.2 }, h = { 0, 1e-3, body == "plate" and 2e-3 or 1.5e-3,
      1e-3, 0 }, y = { 0, 0, 0, 0, 0 } }
  end
  fields.history = { distance = { 0, 10, 20 }, cycle = { 0, 100, 200 }, p_center = { 570, 300, 250 },
    depth_plate = { 0, 1e-3, 2e-3 }, depth_cylinder = { 0, 1e-3, 1.5e-3 },
    depth_partition = { 0 / 0, 0.5, 0.51 } }
  fields.hertz = { half_width = 0.1, p_max = 500 }
  return setmetatable({}, { __index = function(_, name)
    local value = fields[name]
    if value == nil then error("no field " .. name) end
    return value
  end })
end
local one = stand_in { alpha = 0.25, stroke = 0.11, load = 100 }
local two = stand_in { alpha = 0.75, stroke = 0.11, load = 100 }

do
  local text = picture_of(function(file) plot.pressure(one, { file = file }) end)
  has(text, "p / MPa", "plot.pressure has units")
  has(text, "contact pressure of the cylinder: s = 0.11 mm, α = 0.25", "and says of what")
  text = picture_of(function(file) plot.pressure(one, two, { file = file }) end)
  local coarse = { pressure = function()
    return { x = { -3, -1, 0, 1, 3 }, p = { 0, 300, 400, 300, 0 } }
  end }
  plot.pressure(setmetatable(coarse, {}), { file = folder .. "/z.gp" })
  local low, high = (read("z.gp") or ""):match("set xrange %[([%d.-]+):([%d.-]+)%]")
  ok(low and tonumber(low) <= -3 and tonumber(high) >= 3, "the curve comes down to zero in sight")
  has(text, "α = 0.25", "several objects are told apart by what differs")
  ok(text:find("α = 0.75") and not text:find("0.11"), "and by nothing else")
  text = picture_of(function(file) plot.pressure(one, "plate", { scaled = true, file = file }) end)
  has(text, "p / p_H", "scaled as the paper does")
  has(text, "x / a", "and x too")
  ok(text:match("\n +1 [+|]"), "the plate's largest pressure is that of Hertz here")
  text = picture_of(function(file)
    plot.pressure(one, two, { titles = { "before", "after" }, file = file })
  end)
  ok(text:find("before") and text:find("after"), "titles of the user's")
  refused(function() plot.pressure(one, { titles = { "a", "b" } }) end, "expected one for each of 1",
    "too many titles")
  refused(function() plot.pressure() end, "at least one object", "no object")
  refused(function() plot.pressure(7) end, "argument 1", "a number is no object")
  refused(function() plot.pressure(one, "plat") end, '"cylinder" or "plate"', "no such body")
  refused(function() plot.pressure(one, { scale = true }) end, "did you mean 'scaled'",
    "an unknown option")
end

do
  local text = picture_of(function(file) plot.profile(one, { file = file }) end)
  ok(text:find("* cylinder", 1, true) and text:find("# plate", 1, true), "plot.profile: both bodies")
  has(text, "wear depth / µm", "in micrometres")
  local zero, two_um = text:find("\n +0 [+]"), text:find("\n +2 [+]")
  ok(zero and two_um and zero < two_um, "depth grows downwards")
  text = picture_of(function(file) plot.profile(one, "plate", { file = file }) end)
  has(text, "wear of the plate", "one body")
  text = picture_of(function(file) plot.profile(one, two, { file = file, size = { 100, 30 } }) end)
  ok(text:match("%(a%) cylinder +%(b%) plate\n"), "several objects: a panel for each body")
end

do
  local text = picture_of(function(file) plot.history(one, { file = file }) end)
  has(text, "pressure / MPa", "plot.history draws the centre pressure unless told otherwise")
  has(text, "distance / mm", "against the distance")
  text = picture_of(function(file)
    plot.history(one, two, "p_center", "depth_plate", "depth_cylinder", "depth_partition",
      { file = file, against = "cycle", size = { 100, 70 } })
  end)
  has(text, "pressure / MPa", "a panel for each quantity: pressure")
  has(text, "wear depth / µm", "depth")
  has(text, "wear depth partition", "partition")
  has(text, "plate, α = 0.75", "columns and objects are told apart")
  has(text, "cycles", "against cycles")
  local k = function() return 1e-8 end
  local first = stand_in { k = k, jump = "auto", scheme = "explicit" }
  local second = stand_in { k = 1e-8, jump = 100, scheme = "implicit" }
  text = picture_of(function(file)
    plot.history(first, second, { file = file, size = { 120, 30 } })
  end)
  has(text, "k by function, jump auto, scheme explicit", "every setting that differs is named")
  has(text, "k = 1e-08, jump 100, scheme implicit", "for every curve")
  first.history.jump = { 0, 40, 60 }
  plot.history(first, "jump", { file = folder .. "/jump.gp" })
  ok((read("jump.gp") or ""):find("END\n10 40\n20 60\nEND", 1, true), "jumps begin at the first update")
  refused(function() plot.history(one, "p_centre") end, "did you mean 'p_center'",
    "an unknown column")
  refused(function() plot.history(one, "pressure") end, "no column 'pressure' in the history",
    "and one that is like none")
end

-- --- meshes and fields --------------------------------------------------------------------------

-- Two squares, the second cut into triangles; `side` 1 above, -1 below.
local function stand_in_mesh(side)
  local x, y = { 0, 1, 1, 0, 2, 2 }, { 0, 0, side, side, 0, side }
  return { nodes = 6, rows = 1, node = function(_, i) return x[i], y[i] end,
    elements = function() return { 1, 2, 3, 4, 2, 5, 6, 0, 2, 6, 3, 0 } end,
    box = function() return { 1, 4, 2, 3, 5, 6 } end }
end
local model_ = { mesh = { cylinder = stand_in_mesh(1), plate = stand_in_mesh(-1) } }

local function stand_in_field(side)
  return { x = { 0, 1, 1, 0, 2, 2 }, y = { 0, 0, side, side, 0, side },
    ux = { 0, 0, 0, 0, 0, 0 }, uy = { 0, 0, 0, 0, 0, 0 },
    elements = { 1, 2, 3, 4, 2, 5, 6, 0, 2, 6, 3, 0 }, mises = { 0, 1, 2, 1, 2, 3 },
    sxy = { -1, 0, 1, 0, 1, 2 } }
end
local contact_ = { stress = function()
  return { cylinder = stand_in_field(1), plate = stand_in_field(-1) }
end }

do
  local text = picture_of(function(file) plot.mesh(model_, { file = file }) end)
  has(text, "mesh: 12 nodes, 6 elements", "plot.mesh counts")
  ok(text:find("cylinder") and text:find("plate"), "and draws both bodies")
  text = picture_of(function(file) plot.mesh(model_, { body = "plate", file = file }) end)
  ok(not text:find("cylinder") and text:find("plate"), "or one")
  text = picture_of(function(file) plot.mesh(model_, { zoom = "wear box", file = file }) end)
  has(text, "cylinder", "the wear box")
  plot.mesh(model_, { file = folder .. "/m.gp" })
  local edges = select(2, (read("m.gp") or ""):gsub("[%d%-. ]+\n[%d%-. ]+\n\n", ""))
  ok(edges == 2 * 8, "every edge once (" .. edges .. ")")
  refused(function() plot.mesh(7) end, "expected a model", "no model")
  refused(function() plot.mesh(model_, { zoom = { 5, 6, 5, 6 } }) end, "no element lies in",
    "a part where nothing is")
  refused(function() plot.mesh(model_, { zom = 1 }) end, "did you mean 'zoom'", "a wrong option")
end

do
  local text = picture_of(function(file) plot.stress(contact_, { file = file }) end)
  has(text, "von Mises stress / MPa", "plot.stress draws von Mises' stress unless told otherwise")
  has(text, "2.67 to 3", "its levels")
  text = picture_of(function(file) plot.stress(contact_, { component = "sxy", file = file }) end)
  has(text, "1.56 to 2", "values of both signs: zero in the middle")
  has(text, "-2 to -1.56", "of the levels")
  plot.stress(contact_, { file = folder .. "/stress.png" })
  ok(read("stress.png"), "and in colour")
  text = picture_of(function(file) plot.stress(contact_.stress(), { file = file }) end)
  has(text, "von Mises stress / MPa", "plot.stress takes the field itself")
  text = picture_of(function(file) plot.stress(wear { model = { mesh = { size = 0.04 } } }, { file = file }) end)
  has(text, "von Mises stress / MPa", "and a run, for its contact as it is")
  refused(function() plot.stress({}) end, "expected a contact, its stress() or a run", "but no other table")
  refused(function() plot.stress(material {}) end, "got a material", "a contact is asked for")
  refused(function() plot(material {}) end, "got a material", "objects are named by their kind")
  refused(function() plot.stress(contact_, { component = "misses" }) end, "field 'component'",
    "no such component")
end

-- --- for print -----------------------------------------------------------------------------------

-- Width and height of a png, and where it says so its pixels in a metre.
local function png_size(name)
  local png = read(name) or ""
  if #png < 24 then return 0, 0 end
  return string.unpack(">I4", png, 17), string.unpack(">I4", png, 21)
end

local function script_of(draw)
  draw(folder .. "/s.gp")
  return read("s.gp") or ""
end

do
  plot.style "paper"
  plot { line, file = folder .. "/c.png" }
  local width, height = png_size("c.png")
  ok(width == 2008 and height == 1446, "paper: a column of 85 mm at 600 dpi (" .. width .. ")")
  plot { panels = { { line }, { line } }, layout = { 1, 2 }, file = folder .. "/c.png" }
  ok(png_size("c.png") == 4016, "panels side by side take the page's 170 mm")
  plot.style { width = "page", dpi = 300 }
  plot { line, file = folder .. "/c.png" }
  ok(png_size("c.png") == 2008, "what the style is told later holds from then on")
  plot { line, file = folder .. "/c.png", size = { 1000, 500 } }
  width, height = png_size("c.png")
  ok(width == 1000 and height == 500, "pixels that are asked for are given")
  plot.style { "paper", font = "Serif" }
  plot { line, file = folder .. "/c.pdf" }
  local box_x, box_y = (read("c.pdf") or ""):match("/MediaBox %[ 0 0 (%d+) (%d+) ?%]")
  ok(box_x == "240" and box_y == "173", "a pdf is as large on paper: 240 by 173 pt, whole ones")
  local held = plot.style()
  ok(held.name == "paper" and held.points == 8 and held.font == "Serif", "plot.style() tells")
  plot.style "slides"
  plot { line, file = folder .. "/c.png" }
  ok(png_size("c.png") == 1500, "slides: 254 mm at 150 dpi")
  refused(function() plot.style "poster" end, '"paper", "slides" or "screen"', "no such style")
  refused(function() plot.style { "paper", widht = 3 } end, "did you mean 'width'", "a wrong option")
  refused(function() plot.style { "paper", width = 5 } end, "a number in [20, 1000]", "5 mm")
  refused(function() plot.style { "screen", width = 85 } end, "size in pixels", "mm on the screen")
  plot.style "screen"
  plot { line, file = folder .. "/c.png" }
  ok(png_size("c.png") == 900, "and screen is as before")
end

do
  local curves = {}
  for i = 1, 8 do curves[i] = { x = { 0, 1 }, y = { 0, i }, title = "curve " .. i } end
  local script, dashes = script_of(function(file) curves.file = file plot(curves) end), {}
  local different = 0
  for dash in script:gmatch("dashtype (%S+)") do
    if not dashes[dash] then dashes[dash], different = true, different + 1 end
  end
  ok(different == 7, "eight curves, eight dashes, the first of them full")
  for i = 9, 12 do curves[i] = { x = { 0, 1 }, y = { 0, i }, title = "curve " .. i } end
  script = script_of(function(file) curves.file = file plot(curves) end)
  has(script, "unset key", "more than eight have no key")
  has(script, "set label 12 'curve 12' noenhanced at graph 1.015, graph 1", "but names at their ends")
  ok(not script:find("title 'curve"), "and nowhere else")
  for i = 1, 12 do curves[i].value = i end
  curves.vlabel = "\\alpha"
  script = script_of(function(file) curves.file = file plot(curves) end)
  has(script, "linecolor palette cb 7", "or a scale of colours")
  has(script, "set cblabel 'α'", "that says of what")
  curves.file, curves.size = folder .. "/s.txt", { 100, 40 }
  plot(curves)
  local named = select(2, (read("s.txt") or ""):gsub("curve %d", ""))
  ok(named == 8, "of which characters name eight (" .. named .. ")")
end

do
  local many = {}
  for i = 1, 10 do many[i] = stand_in { alpha = i / 10, stroke = 0.11, load = 100 } end
  many[11] = { file = folder .. "/s.gp" }
  plot.pressure(table.unpack(many))
  has(read("s.gp"), "linecolor palette cb 0.5 ", "many runs that differ in alpha: its scale")
  has(read("s.gp"), "set cblabel 'α'", "named")
  local sp = stand_in { stroke = 0.11, procedure = "SP", cycle = 9 }
  local nsp = stand_in { stroke = 20, procedure = "NSP", cycle = 7 }
  local text = picture_of(function(file) plot.pressure(sp, nsp, { file = file }) end)
  ok(text:find("s = 20 mm") and not text:find("SP") and not text:find("cycles"),
    "a key names what differs, not what follows from it")
  local a, b = stand_in { stroke = 1, cycle = 10 }, stand_in { stroke = 1, cycle = 20 }
  text = picture_of(function(file) plot.pressure(a, b, { file = file }) end)
  has(text, "20 cycles", "unless nothing else differs")
end

-- What a title may say of a run whose load changed on the way.
do
  local changed = stand_in { alpha = 0.5, stroke = 0.11, load = 150 }
  changed.history.load = { 0, 100, 150 }
  local text = picture_of(function(file) plot.pressure(changed, { file = file }) end)
  has(text, "load 100 to 150 N", "a load that has changed is told as a range")
  changed.alpha, changed.load, changed.stroke = 0.9, 10, 0.3
  changed.history.alpha, changed.history.travel = { 0.5, 0.5, 0.5 }, { 0.11, 0.11, 0.11 }
  text = picture_of(function(file) plot.pressure(changed, { file = file }) end)
  has(text, "s = 0.11 mm, α = 0.5, load 100 to 150 N", "what is set for the next update is not told of those before")
  changed.history.load = nil
  local loaded = stand_in { alpha = 0.5, stroke = 0.11, load = 100, loading = {} }
  text = picture_of(function(file) plot.pressure(loaded, { file = file }) end)
  ok(text:find("α = 0.5") and not text:find("0.11") and not text:find("100 N"),
    "a run with a loading has no one stroke and load")
  loaded.history.load, loaded.history.load_low = { 150, 150 }, { 50, 50 }
  loaded.history.load_reference = { 150, 150 }
  text = picture_of(function(file) plot.pressure(loaded, { file = file }) end)
  ok(text:find("load 50 to 150 N", 1, true) and not text:find "under", "loads of a cycle are a range")
  loaded.history.load_reference = { 20, 20 }
  text = picture_of(function(file) plot.pressure(loaded, { file = file }) end)
  has(text, "pressures under 20 N", "with the load of the pressures, where it is another")
end

do
  local script = script_of(function(file)
    plot { panels = { { line, title = "left" }, { line } }, file = file }
  end)
  has(script, "set title '(a) left'", "panels have letters")
  has(script, "set title '(b)'", "without a title too")
  script = script_of(function(file)
    plot { panels = { { line, title = "left" }, { line } }, letters = false, file = file }
  end)
  has(script, "set title 'left'", "or have not")
  script = script_of(function(file)
    plot { line, title = ("a long title of many words, "):rep(6), file = file }
  end)
  ok(script:match("set title '[^\n]+,'%.\"\\n\"%.'a long"), "a long title has lines")
  script = script_of(function(file) plot { x = { 0, 1 }, y = { 0, 7e-4 }, file = file } end)
  has(script, "set format y '%.0t×10^{%T}'", "small numbers as powers of ten")
  script = script_of(function(file) plot { x = { 0, 1 }, y = { 0, 0.7 }, file = file } end)
  has(script, "set format y '%.6g'", "others plain")
end

-- --- measured points, responses -------------------------------------------------------------------

do
  local measured = { x = { 1, 2 }, y = { 2, 5 }, error = { 0.5, 1 }, title = "measured" }
  local script = script_of(function(file) plot { line, points = measured, file = file } end)
  has(script, "using 1:2:3 with yerrorbars", "points have bars")
  has(script, "2 5 1\n", "as long as was said")
  plot { line, file = folder .. "/p.txt" }
  measured.file = folder .. "/q.txt"
  plot.points(measured)
  local text = read("q.txt") or ""
  ok(text:find("squares") and text:find("measured"), "plot.points adds to the last picture")
  ok(not read("p.txt"):find("measured"), "whose own file stays")
  local first = script_of(function(file) plot.points { x = measured.x, y = measured.y, error = measured.error, file = file } end)
  local _, bars = first:gsub("with yerrorbars", "")
  ok(bars == 1, "the same points again, into a file, are drawn once")
  local other = script_of(function(file) plot.points { x = { 1, 2 }, y = { 3, 5 }, error = { 1, 1 }, file = file } end)
  _, bars = other:gsub("with yerrorbars", "")
  ok(bars == 2, "others join them")
  measured.error = { 0.5 }
  refused(function() plot.points(measured) end, "error 1; they must be as many", "a bar is missing")
  measured.error = { 0.5, -1 }
  refused(function() plot.points(measured) end, "error[2] must be a finite number >= 0", "a bar < 0")
  refused(function() plot.points { x = { 1 } } end, "y", "points without y")
  measured.error, measured.panel = nil, 3
  refused(function() plot.points(measured) end, "one of the 1 panels", "no such panel")
end

-- Four cases of two strokes and two alphas; depth = stroke * alpha in mm.
local function sweep(extra)
  local study_, list = { varied = { "alpha", "stroke", extra }, flat = {} }, {}
  for _, stroke in ipairs { 1, 2 } do
    for _, alpha in ipairs { 0.75, 0.25 } do
      local id = #list + 1
      study_.flat[id] = { alpha = alpha, stroke = stroke, k = extra and id }
      list[id] = { id = id, status = "done", last = { depth_plate = stroke * alpha } }
    end
  end
  list[#list + 1] = { id = 5, status = "failed" }
  study_.flat[5] = { alpha = 0.5, stroke = 1 }
  study_.cases = function() return list end
  return study_
end

do
  local script = script_of(function(file)
    plot.response(sweep(), { x = "alpha", y = "depth_plate", by = "stroke", file = file })
  end)
  has(script, "$d0_0 << END\n0.25 250\n0.75 750\nEND", "plot.response: by size of x, in µm")
  has(script, "$d0_1 << END\n0.25 500\n0.75 1500\nEND", "a curve for each value")
  has(script, "title 's = 2 mm'", "that the key names")
  has(script, "set title 'wear depth of the plate'", "the body is named")
  script = script_of(function(file)
    plot.response(sweep(), { x = "alpha", y = "depth_plate", by = "stroke", map = true, file = file })
  end)
  has(script, "set xtics ('0.25' 1, '0.75' 2)", "a map has the values at its sides")
  has(script, "with image", "and colours")
  refused(function() plot.response(sweep(), { x = "alpha", y = "depth_plate", where = { alfa = 0.5 } }) end,
    "field 'where': no case has a setting 'alfa' (did you mean 'alpha'?)", "a misspelt setting")
  refused(function() plot.response(sweep(), { x = "alpha", y = "depth_plate", where = { stroke = 7 } }) end,
    "no finished case", "a value of none")
  local dotted = sweep("model.radius")
  for id = 1, 4 do dotted.flat[id]["model.radius"] = id end
  dotted.flat[2].alpha = 0.75
  refused(function() plot.response(dotted, { x = "alpha", y = "depth_plate", by = "stroke" }) end,
    'where={ ["model.radius"]=1 }', "what to choose, as Lua spells it")
  refused(function() plot.response(sweep(), { x = "alpha", y = "depth_plate" }) end,
    'by="stroke" or where={ stroke=1 }', "what the picture would hide")
  script = script_of(function(file)
    plot.response(sweep(), { x = "alpha", y = "depth_plate", where = { stroke = 2 }, file = file })
  end)
  has(script, "0.25 500\n0.75 1500", "is chosen with where")
  refused(function() plot.response(sweep(), { x = "alfa", y = "depth_plate" }) end,
    "did you mean 'alpha'", "x was not varied")
  refused(function()
    plot.response(sweep(), { x = "alpha", by = "stroke", y = "depth_plat" })
  end, "did you mean 'depth_plate'", "no such result")
  refused(function() plot.response(7) end, "expected a study", "no study")
end

-- --- animation ----------------------------------------------------------------------------------

do
  local steps = 0
  local w = stand_in { alpha = 0.5, distance = 0 }
  local running = setmetatable({}, { __index = function(_, name)
    if name == "distance" then return 10 * math.min(steps, 5) end
    if name == "step" then return function() steps = steps + 1 end end
    return w[name]
  end })
  plot.animate(running, { what = "both", file = folder .. "/run.gif" })
  local gif = read("run.gif") or ""
  ok(gif:sub(1, 6) == "GIF89a", "plot.animate writes a gif")
  ok(steps == 6, "and ends where the run does")
  ok(select(2, gif:gsub("\33\249\4", "")) >= 6, "a picture before and after every step")
  refused(function() plot.animate(running, { file = folder .. "/run.png" }) end, "ends in .gif",
    "only as a gif")
end

-- --- a gnuplot that is not well -----------------------------------------------------------------

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
  ok(problem.code == "MISSING", "with a code of its own")
  fake("dying", "exit 3")
  refused(function() plot { line } end, "exit status 3", "gnuplot dies at its start")
  fake("slow", "sleep 0.5; exec gnuplot \"$@\"")
  has(picture_of(function(file) plot { line, file = file } end), "squares", "a slow start is awaited")
  gnuplot.use("gnuplot")
  has(picture_of(function(file) plot { line, file = file } end), "squares", "and all is well again")
  local version, terminals = gnuplot.about()
  ok(version >= 5.2 and terminals:find(" dumb "), "about() tells version and terminals")
end

os.execute("rm -rf " .. folder)
print("1.." .. number)
os.exit(failed == 0)

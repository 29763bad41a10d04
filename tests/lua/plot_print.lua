-- Tests figures for print: journal style, greys, titles, panels side by side, and typographic details in
-- gnuplot's commands.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local pictures = dofile(here .. "/lib/pictures.lua")
local ok, has, refused = tap.ok, tap.holds, tap.fails
local folder, read, script_of, line = pictures.folder, pictures.read, pictures.script_of, pictures.line

local run = pictures.stand_in { k = 1e-8 }

local function lacks(text, word, what) ok(not text:find(word, 1, true), what) end

-- --- journal style -------------------------------------------------------------------------------

local function png_size(name)
  local png = read(name)
  return string.unpack(">I4", png, 17), string.unpack(">I4", png, 21)
end

do
  local both = { "p_center", "depth_plate" }
  local function history(options)
    return script_of(function(file)
      options.file = file
      plot.history(run, both[1], both[2], options)
    end)
  end
  has(history {}, "history", "on the screen a plot has a default title")
  plot.style "journal"
  local script = history {}
  lacks(script, "history", "in journal style a plot has no title")
  has(history { title = "Mine" }, "Mine", "a title given by the user is drawn")
  lacks(history { title = false }, "history", "title = false draws no title")
  plot.history(run, "p_center", "depth_plate", { file = folder .. "/h.png" })
  local width, height = png_size "h.png"
  ok(width == 4016 and height < 0.5 * width, "two panels side by side on 170 mm")
  plot.style { width = "single" }
  plot.history(run, "p_center", "depth_plate", { file = folder .. "/h.png" })
  width, height = png_size "h.png"
  ok(width == 2008 and height > width, "panels are stacked in a single column")
  ok(plot.style { width = "double" }.width == "page", "the width double means the width of the page")
  plot.style { "journal", width = "page" }
  plot { panels = { { line }, { line } }, layout = { 2, 1 }, file = folder .. "/h.png" }
  width, height = png_size "h.png"
  ok(height < width, "stacked panels on a page are lower than wide")
  plot.style "screen"
end

-- --- greys ---------------------------------------------------------------------------------------

-- Returns true if all colours in a script are greys.
local function is_grey(script)
  for r, g, b in script:gmatch "#%x?%x?(%x%x)(%x%x)(%x%x)'" do
    if r ~= g or g ~= b then return false end
  end
  return script:find "#" ~= nil
end

local function coloured(options)
  return script_of(function(file)
    plot { line, { x = { 1, 2 }, y = { 1, 2 }, colour = "orange" }, file = file, colour = options }
  end)
end

do
  ok(not is_grey(coloured()), "plots have colours by default")
  ok(is_grey(coloured "grey"), 'colour = "grey"')
  ok(is_grey(coloured(false)), "colour = false")
  has(coloured "grey", "#adadad", "a named colour becomes the grey of its luminance")
  plot.style { "journal", colour = "grey" }
  ok(is_grey(coloured()), "greys chosen by the style")
  ok(not is_grey(coloured(true)), "the option of a call overrides the style")
  plot.style "screen"
  local field = script_of(function(file)
    plot { { x = { 0, 1, 1, 0 }, y = { 0, 0, 1, 1 }, value = { 0, 1, 2, 3 } }, file = file, colour = "grey" }
  end)
  ok(is_grey(field:match "set palette[^\n]*"), "the palette of a field is grey")
  refused(function() plot { line, colour = "gray" } end, "grey", "an unknown value of colour")
end

-- --- axes ----------------------------------------------------------------------------------------

local function drawn(options)
  return script_of(function(file)
    options.file = file
    plot(options)
  end)
end

do
  local script = drawn { { x = { 1e-9, 1e-7, 1e-5 }, y = { 3, 4, 40 } }, logx = true, logy = true }
  has(script, "set format x '10^{%T}'", "one number format for all numbers of a logarithmic axis")
  has(script, "set format y '%.6g'", "a logarithmic axis with short numbers shows them plainly")
  local low, high = script:match "set yrange %[(%S+):(%S+)%]"
  ok(math.abs(low / 2 - 1) < 1e-6 and math.abs(high / 50 - 1) < 1e-6,
    "a logarithmic axis ends at 1, 2 or 5 times a power of ten")
  has(script, "5e1", "an axis over few decades has numbers within the decades")
  script = drawn { { x = { 1, 2, 3, 4 }, y = { 0, 0, 5, 0 } }, yrange = { 0 } }
  low = script:match "set yrange %[(%S+):"
  ok(tonumber(low) < 0 and tonumber(low) > -0.5, "the range is extended for a line along its end")
  low = drawn({ { x = { 1, 2, 3, 4 }, y = { 0, 1, 5, 0 } }, yrange = { 0 } }):match "set yrange %[(%S+):"
  ok(tonumber(low) == 0, "the range is not extended for a line that touches its end")
  local top, bottom = drawn({ { x = { 1, 2, 3 }, y = { 0, 4, 0.5 } }, ydown = true, yrange = { 0 } })
    :match "set yrange %[(%S+):(%S+)%] noreverse"
  ok(tonumber(top) > 4 and tonumber(bottom) == 0, "the range is extended below a groove")
  local margin = drawn({ { x = { 0, 2.5e7 }, y = { 0, 1 } } }):match "set rmargin (%S+)"
  ok(tonumber(margin) > 4, "the margin contains half of the last number")
  has(drawn { line, ylabel = "α̃_x" }, 'set ylabel "α̃_{x}"', "a letter with an accent has a subscript")
end

-- --- units ---------------------------------------------------------------------------------------

do
  local function history(distances, depths, options)
    local far = pictures.stand_in {}
    local columns = { distance = distances, depth_plate = depths }
    local long = setmetatable({}, { __index = function(_, name) return name == "history" and columns or far[name] end })
    return script_of(function(file)
      options.file = file
      plot.history(long, "depth_plate", options)
    end)
  end
  local script = history({ 0, 1e6, 2e6 }, { 0, 1e-5, 2e-5 }, {})
  has(script, 'set xlabel "distance / m"', "long distances are drawn in m")
  has(script, 'set ylabel "wear depth / nm"', "small depths are drawn in nm")
  has(script, "\n1000 10\n2000 20\n", "numbers are converted with the unit")
  has(history({ 0, 1e7, 2.5e7 }, { 0, 1e-3, 2e-3 }, {}), 'set xlabel "distance / km"',
    "very long distances are drawn in km")
  script = history({ 0, 1e6, 2e6 }, { 0, 1e-3, 2e-3 }, { xlabel = "distance / mm" })
  has(script, { 'set xlabel "distance / 10⁶ mm"', "\n1 1\n" }, "the label given by the user determines the unit")
  plot.history(run, "depth_plate", { file = folder .. "/p.gp" })
  has(script_of(function(file) plot.points { x = { 10 }, y = { 1 }, file = file } end), "\n10 1\n",
    "points added later are in mm and µm")
end

-- --- marks ---------------------------------------------------------------------------------------

do
  local many = { x = {}, y = {} }
  for i = 1, 100 do many.x[i], many.y[i] = i, i * i end
  has(drawn { line }, "with linespoints", "a curve with few points has marks")
  has(drawn { many }, "with lines ", "a curve with many points has no marks")
  lacks(drawn { line, many }, "linespoints", "few points are not marked beside a curve with many")
  has(drawn { many, xrange = { 1, 10 } }, "with linespoints", "only points in the range shown are counted")
  has(drawn { { x = line.x, y = line.y, style = "lines" } }, "with lines ", 'style = lines draws no marks')
  lacks(drawn { { x = { 0, 1, 1, 0, 0 }, y = { 0, 0, 1, 1, 0 } } }, "linespoints",
    "an outline has no marks at its corners")
end

-- --- choice of the style -------------------------------------------------------------------------

do
  local columns = { distance = { 0, 10, 20, 30 }, alpha = { 0.5, 0.5, 0.5, 0.1 }, jump = { 0, 40, 50, 7 },
    depth_plate = { 0, 1e-3, 2e-3, 3e-3 } }
  local changed = setmetatable({}, { __index = function(_, name) return name == "history" and columns or run[name] end })
  local function history(column, options)
    return script_of(function(file)
      plot.history(changed, column, { file = file, titles = options and { "mine" } })
    end)
  end
  has(history "alpha", "\n20 0.5\n20 0.1", "a setting that changes is drawn as a step")
  lacks(history "jump", "\n30 7\n", "the last update, shortened by the end of the run, is omitted")
  has(history("depth_plate", true), 'title "mine"', "a title given by the user is in the key")
  has(script_of(function(file) plot.pressure(run, { file = file, logy = true }) end), "set logscale y",
    "plot.pressure with the option logy")
  local panels = script_of(function(file)
    plot { { x = { 1, 2 }, y = { 1, 2 }, title = "k = 5e-10 mm²/N" }, file = file }
  end)
  has(panels, "k = 5×10^{-10} mm²/N", "a power of ten is formatted as such")
  lacks(drawn { { x = { 1, 2 }, y = { 1, 2 }, title = "run5e-10" } }, "×",
    "a number in a name is not a power of ten")
end

-- --- stresses, depths, bars ----------------------------------------------------------------------

-- Returns a field of one square element, whose lower edge is at y = low, with von Mises stresses up to
-- `most`.
local function square(low, most)
  return { x = { 0, 1, 1, 0 }, y = { low, low, low + 1, low + 1 }, mises = { 0, most, most, 0 }, elements = { 1, 2, 3, 4 } }
end

local function stressed(upper, lower)
  return script_of(function(file)
    plot.stress({ cylinder = square(0, upper), plate = square(-1, lower) }, { file = file })
  end)
end

do
  local script = stressed(300, 200)
  has(script, "set cbrange [0:300]", "bodies with similar stresses have one scale")
  has(script, 'set cblabel "von Mises stress / MPa"', "label of the colours")
  script = stressed(300, 20)
  has(script, "set cbrange [0:20]", "the scale is chosen for the softer body")
  has(script, "cylinder: up to 300", "the label states the maximum of the other body")
  lacks(script:match "set title[^\n]*", "Mises", "the title does not repeat the label")
end

local function ranges_of(script)
  local ranges = {}
  for range in script:gmatch "set yrange (%b[])" do ranges[#ranges + 1] = range end
  return ranges
end

do
  local other = pictures.stand_in { k = 2e-8 }
  local function profiles(file) plot.profile(run, other, { file = file }) end
  local ranges = ranges_of(script_of(profiles))
  ok(ranges[1] == ranges[2] and ranges[1]:find "^%[2%.0",
    "panels of depths have the same range: " .. tostring(ranges[1]))
  local text = pictures.picture_of(profiles)
  ok((text:find "\n *0%.0 %+" or 1e9) < (text:find "\n *1%.0 |" or 0), "depth increases downwards, also in characters")
  local function panels(label)
    return ranges_of(drawn { panels = { { { x = { 1, 2 }, y = { 3, 90 } }, ylabel = "p" },
      { { x = { 1, 2 }, y = { 0.6, 9 } }, ylabel = label } }, logy = true })
  end
  ranges = panels "p"
  ok(ranges[1] == ranges[2] and ranges[1]:find "^%[0%.4999",
    "panels of one quantity have the same range: " .. tostring(ranges[1]))
  ranges = panels "q"
  ok(ranges[1] ~= ranges[2], "panels of two quantities have different ranges")
end

do
  local indices = { fields = { "k" }, indices = true, of = { "p_max" }, distance = { 5 },
    p_max = { first = { k = { value = { 0.5 } } }, total = { k = { value = { 0.7 } } } } }
  local script = script_of(function(file) plot.tornado(indices, { file = file }) end)
  local heights = {}
  for block in script:gmatch "%$d0_%d << END\n(.-)END" do
    local low, high = math.huge, -math.huge
    for y in block:gmatch "%S+ (%S+)\n" do low, high = math.min(low, tonumber(y)), math.max(high, tonumber(y)) end
    heights[#heights + 1] = { low, high }
  end
  ok(#heights == 2 and heights[2][2] < heights[1][1], "bars of one input are side by side")
end

-- --- defects of figures that a journal would reject ---------------------------------------------

do
  local x, y, bars = {}, {}, {}
  for i = 1, 61 do x[i], y[i], bars[i] = i, i, 0.1 end
  local script = drawn { { x = x, y = y, error = bars, style = "points" } }
  has(script, "using 1:($2-$3):(0):(2*$3) with vectors nohead",
    "error bars of many points are lines behind the points")
  lacks(script, "yerrorbars", "error bars of many points are not drawn by yerrorbars")
  table.remove(x)
  has(drawn { { x = x, y = { table.unpack(y, 1, 60) }, error = { table.unpack(bars, 1, 60) }, style = "points" } }, "with yerrorbars",
    "error bars of few points have end marks")
end

do
  local script = drawn { { x = { 0, 1 }, y = { 5e-9, 3.2e-8 } } }
  has(script, "'0.5×10^{−8}' 5.0000000000000001e-09", "numbers of an axis have one power of ten")
  has(script, "'3.0×10^{−8}'", "the power of ten is that of the largest number")
end

do
  local script = script_of(function(file) plot.history(run, "p_center", "depth_plate", { file = file }) end)
  local left = {}
  for at in script:gmatch "set lmargin at screen (%S+)" do left[#left + 1] = tonumber(at) end
  ok(left[1] < 0.5 and left[2] > 0.5, "two panels are side by side on the screen, too")
end

do
  local contact = contact { load = 60, model = { mesh = { size = 0.05 } },
    worn = { plate = function(at) return math.max(0, 0.03 - at * at / 30) end } }
  local function lowest_of(options)
    local script = script_of(function(file)
      options.file = file
      plot.stress(contact, options)
    end)
    local outline, lowest = script:match "%$d0_0 << END\n(.-)END", math.huge
    for at in outline:gmatch "%S+ (%S+)\n" do lowest = math.min(lowest, tonumber(at)) end
    return lowest
  end
  ok(math.abs(lowest_of {} + 0.03) < 1e-3, "a stress plot shows worn bodies in contact: " .. lowest_of {})
  ok(math.abs(lowest_of { deformed = 0 }) < 1e-9, "deformed = 0 draws the bodies without displacements")
end

do
  local spot = map { x = { -1, -0.5, 0, 0.5, 1 }, z = { -1, -0.5, 0, 0.5, 1 }, y = function(x, z) return x == 0 and z == 0 and 1e-3 or 0 end }
  local script = script_of(function(file) plot.map(spot, { file = file, size = { 200, 150 } }) end)
  local small = select(2, script:match "%$n0 << END\n(.-)END":gsub("\n", ""))
  script = script_of(function(file) plot.map(spot, { file = file, size = { 1200, 900 } }) end)
  local large = select(2, script:match "%$n0 << END\n(.-)END":gsub("\n", ""))
  ok(small < large, ("a small picture has fewer numbers on contour lines: %d, %d"):format(small, large))
end

pictures.remove()

-- Help entries of what stands around the engine: plot, export, help. Form: help.lua.

local columns = {}
for i, column in ipairs(require "archard.settings".columns) do columns[i] = column.name end

return {
  -- --- csv ------------------------------------------------------------------------------------
  { "csv", kind = "object", use = 'csv.read("measured.csv")',
    text = "Tables of numbers from files of others: measured loadings, profiles, coefficients." },
  { "csv.read", kind = "function", use = 'csv.read(path, { t="time [s]", x="position" })',
    text = "Reads a file of columns under a line of names, separated by commas, semicolons or tabs; "
      .. "lines that are empty or begin with # are left out. Returns the columns by their names, as "
      .. "lists: a file with the columns t, x and load can stand as it is, loading = "
      .. "csv.read(path), one with x and h as worn = { plate = csv.read(path) }, and what export.csv "
      .. "wrote comes back. Units behind names, as in h [um] or h (um), are taken off and the numbers "
      .. "brought to mm, N, MPa and s; a column in a unit that means nothing here keeps its whole "
      .. "name. A second argument chooses columns and renames them, by their name in the file or "
      .. "their number. A column is text where its first cell is. Without it also come, after the columns, the units that "
      .. "were taken off by name, and the names in their order." },

  -- --- profile --------------------------------------------------------------------------------
  { "profile", kind = "function", use = "profile{ x=..., z=... }  profile.read(path, { ... })",
    text = "A measured trace across a surface: places x and heights z (upwards out of the body) or depths h, "
      .. "in mm, with what it scatters. To start runs from, worn = { plate = p }, to compare with, "
      .. "plot.profile(w, \"plate\", { measured = p }), and to evaluate. Methods return new "
      .. "profiles. Places without a value (NaN) are left out, places that fall are turned round." },
  { "profile{x}", type = "list", unit = "mm", text = "Places, growing or falling all the way." },
  { "profile{z}", type = "list", unit = "mm", text = "Heights; or else h." },
  { "profile{y}", type = "list", unit = "mm", text = "Heights under the name that sections of maps give them." },
  { "profile{h}", type = "list", unit = "mm", text = "Depths; or else z." },
  { "profile{level}", values = { "line", "circle" },
    text = "Takes off the line or circle that fits best, by least squares of heights; see p:level." },
  { "profile{scar}", type = "table { from, to } in mm", values = { "auto" },
    text = "With level: fits beside what is worn, here or where it finds it." },
  { "profile{filter}", type = "number > 0", unit = "mm",
    text = "Cut-off of a Gaussian filter that takes off shorter waves, after levelling; see p:filter." },
  { "profile{error}", type = "number >= 0", unit = "mm",
    text = "Standard deviation of the instrument's noise; estimated where left out." },
  { "profile.read", kind = "function", takes = "profile", class = "profile",
    use = 'profile.read("trace.csv", { unit="um", level="line" })',
    text = "A profile from a file as csv.read takes them: x from the column x, s, position or distance, heights "
      .. "from z, height or y, depths from h or depth. Units behind names are understood." },
  { "profile.read{x}", type = "string or whole number >= 1", text = "Column of the places, by name or number." },
  { "profile.read{z}", type = "string or whole number >= 1", text = "Column of the heights." },
  { "profile.read{h}", type = "string or whole number >= 1", text = "Column of the depths." },
  { "profile.read{unit}", type = 'string or table { x="mm", z="um" }', default = '"mm"',
    text = "Unit of the columns whose names tell none: mm, um, nm, cm, m or in." },
  { "profile.mean", kind = "function", class = "profile", use = "profile.mean{ p1, p2, ... }",
    text = "Mean of several traces over the stretch they share, at the places of the first, weighted by their "
      .. "noise. Its error is that of the noise or of how much the traces differ, whichever is more." },
  { "profile.x", kind = "field", type = "list", unit = "mm", text = "Places." },
  { "profile.z", kind = "field", type = "list", unit = "mm", text = "Heights; nil of a profile of depths." },
  { "profile.h", kind = "field", type = "list", unit = "mm",
    text = "Depths, below zero where the trace is above its reference; nil of a profile of heights. As worn = "
      .. "{ plate = p } depths above the reference within 5 scatters count as 0, more is refused; heights "
      .. "count from the highest point." },
  { "profile.error", kind = "field", type = "number", unit = "mm",
    text = "Standard deviation of the noise of a point: given, or estimated from how far points are off the line "
      .. "between their neighbours (roughness as short as the steps counts as noise), and what filter, "
      .. "average and mean leave of it." },
  { "profile.correlation", kind = "field", type = "number", unit = "mm",
    text = "Length over which the noise hangs together: the step of raw traces, more of filtered ones." },
  { "profile.form", kind = "field", values = { "line", "circle" }, text = "What was taken off; nil before." },
  { "profile.radius", kind = "field", type = "number", unit = "mm", text = "Radius of the circle that was taken off." },
  { "profile.scar", kind = "field", type = "table { from=, to= }", unit = "mm", text = "What is worn, where that was found." },
  { "profile.scatter", kind = "field", type = "table { deviation=, length= }", unit = "mm",
    text = "Of what is not worn about the line or circle: standard deviation, roughness and noise together, and the "
      .. "length over which it hangs together." },
  { "profile.cutoff", kind = "field", type = "number", unit = "mm", text = "Cut-off of the filter; nil before." },
  { "profile.missing", kind = "field", type = "number", text = "Points that were left out." },
  { "profile.path", kind = "field", type = "string", text = "The file it was read from." },
  { "profile.level", kind = "method", class = "profile", use = 'p:level("circle", "auto")',
    text = "Takes off a line or circle by least squares of heights, instead of one taken off before: over all, or "
      .. "beside a scar { from, to } or \"auto\": to what is further from it than 20 % of its width, so that what is piled "
      .. "up does not count. That scar is looked for from the deepest place outwards until the trace meets the form, "
      .. "which is first fitted to the outer 15 % at either end." },
  { "profile.filter", kind = "method", class = "profile", use = 'p:filter(0.08)  p:filter(0.8, "short")',
    text = "Gaussian filter (ISO 16610-21): the long-wave part, or the short-wave one. A wave as long as the cut-off in mm "
      .. "keeps half of its amplitude in each. Near the ends, where half of the weights are missing, it fits a "
      .. "line under those that are left, so that slopes pass unchanged (ISO 16610-28, moments to order 1); "
      .. "within half a cut-off of an end it follows the trace more closely than elsewhere. Steps must be even." },
  { "profile.average", kind = "method", class = "profile", use = "p:average(0.01)",
    text = "Means over cells of that length in mm, at even steps: fewer points, less noise." },
  { "profile.cut", kind = "method", class = "profile", use = "p:cut(from, to)", text = "The part between two places in mm." },
  { "profile.depth", kind = "method", class = "profile", use = "p:depth()  p:depth(before)",
    text = "Depths h below the line or circle through what is not worn, as p:level finds it, or below the same trace "
      .. "before, levelled by a line. Depths above it, below zero, stay as they are." },
  { "profile.depth{reference}", type = "profile", text = "Heights of the same trace before." },
  { "profile.depth{level}", values = { "line", "circle" }, text = "What to level by; as before, or a line." },
  { "profile.depth{scar}", type = "table { from, to } in mm", values = { "auto" }, default = '"auto"',
    text = "What is worn." },
  { "profile.volume", kind = "method", use = "p:volume()  p:volume{ length = 2 * math.pi * 5 }",
    text = "The scar of p:depth(), or of these depths as they are: area [mm2] of its section and error, its standard "
      .. "deviation, from scatter (of what is there) and level (of the line or circle fitted beside, which carries as far); "
      .. "volume and volume_error [mm3]; from, to, width, depth (largest mean over 1/50 of the width), mean_depth; "
      .. "piled [mm2], what is above the reference within 20 % of the width on either side." },
  { "profile.volume{scar}", type = "table { from, to } in mm", values = { "auto" }, text = "What is worn." },
  { "profile.volume{length}", type = "number > 0", unit = "mm", default = 1,
    text = "Length of the scar across the trace; 2 pi r of a track round a disc." },
  { "profile.roughness", kind = "method", use = "p:roughness{ cutoff=0.8 }",
    text = "Profile parameters by ISO 21920-2 (names of ISO 4287), lengths in mm: Ra, Rq, Rsk, Rku, Rt and the slope Rdq over "
      .. "the whole evaluation length; Rp, Rv, Rz as means over its sections of one cut-off each; RSm, the mean "
      .. "width of elements that are a tenth of Rz high and deep (NaN where there are not two). The mean line is the "
      .. "Gaussian filter's; half a cut-off at either end is left out. noise is p.error: Rq^2 holds its square." },
  { "profile.roughness{cutoff}", type = "number > 0, or false", unit = "mm", default = 0.8,
    text = "Longest waves that count; false for all, Pa, Pq, ... about a straight line." },
  { "profile.roughness{short}", type = "number > 0", unit = "mm", text = "Shortest waves that count; all where left out." },
  { "profile.roughness{sections}", type = "whole number >= 1",
    text = "How many sections; 5, or as many as the trace holds where left out (1 of a P-profile)." },

  -- --- plot -----------------------------------------------------------------------------------
  { "plot", kind = "function", use = "plot{ {x=..., y=..., title=...}, ..., xlabel=..., file=... }",
    text = "Draws curves through gnuplot: in the terminal, in a window, or to a file. The list part "
      .. "holds the curves; numbers that are NaN or infinite break a line. Titles are shown as they "
      .. "are written, but for three forms: \\alpha is the Greek letter, p_H is p with the H lowered, "
      .. "mm^2 has the 2 raised (in files and windows). More than eight curves are named at their ends." },
  { "plot{x}", type = "list", text = "In a curve: its abscissae; 1, 2, 3, ... where left out." },
  { "plot{y}", type = "list", text = "In a curve: its ordinates." },
  { "plot{value}", type = "list",
    text = "In the list part: a field, polygons with four corners each in x, y and value; a "
      .. "triangle repeats its last. In a curve: a number, by which a scale of colours names it." },
  { "plot{error}", type = "list", text = "In a curve: half lengths of error bars in y." },
  { "plot{points}", type = "table { x=, y=, error=, title= }",
    text = "Measured points over the curves, as plot.points takes them." },
  { "plot{title}", type = "string or false", text = "Title of the plot, false for none; in a curve, its name in the key." },
  { "plot{term}", values = require "archard.plot.draw".terms,
    text = "Where to draw. Where left out, the best the terminal can do: a picture where it answers "
      .. "that it shows kitty's or sixel, else curves in Braille dots where it has colours and UTF-8 "
      .. "(not in xterm, whose usual fonts lack them), else characters. dots and dumb ask for these two, window is the first of qt, wxt and x11 "
      .. "that gnuplot has." },
  { "plot{file}", type = "string",
    text = "File to draw to; its ending (png, svg, pdf, eps, gif, txt, or gp for gnuplot's commands) "
      .. "tells the kind. It appears whole or not at all." },
  { "plot{xlabel}", type = "string", text = "Label of the x axis." },
  { "plot{ylabel}", type = "string", text = "Label of the y axis." },
  { "plot{vlabel}", type = "string", text = "Label of the colours of a field." },
  { "plot{xrange}", type = "table { low, high }",
    text = "Range of the x axis; high before low turns it round, one left out is found from the "
      .. "curves." },
  { "plot{yrange}", type = "table { low, high }", text = "Range of the y axis." },
  { "plot{vrange}", type = "table { low, high }", text = "Range of the colours of a field." },
  { "plot{logx}", type = "boolean", default = false, text = "Logarithmic x axis." },
  { "plot{logy}", type = "boolean", default = false, text = "Logarithmic y axis." },
  { "plot{xdown}", type = "boolean", default = false, text = "x grows to the left, whichever end xrange names first." },
  { "plot{ydown}", type = "boolean", default = false, text = "y grows downwards, whichever end yrange names first." },
  { "plot{key}", type = "string or boolean", default = '"below"',
    values = require "archard.gnuplot".keys,
    text = "Place of the key; false for none. Panels share one below where none is named." },
  { "plot{style}", values = require "archard.gnuplot".styles,
    default = '"lines"', text = "How curves are drawn; also of one curve. Left out, lines of 4 to 30 points have "
      .. "them marked in windows and files." },
  { "plot{colour}", type = "string or boolean",
    text = 'In a curve: "#rrggbb" or the name of a colour. Of the plot: "grey" or false for greys in files and '
      .. "no colours in the terminal." },
  { "plot{series}", type = "whole number >= 1",
    text = "In a curve: which of the eight colours and marks; the next one where left out." },
  { "plot{dash}", type = "whole number >= 1",
    text = "In a curve: 1 a full line, 2 to 5 dashed, in a window or file." },
  { "plot{width}", type = "number > 0", default = 1, text = "In a curve: relative line width." },
  { "plot{on}", values = { "pixels", "characters" },
    text = "In a curve: only drawn where the picture is of these; left out, everywhere." },
  { "plot{equal}", type = "boolean", default = false, text = "The same scale on both axes." },
  { "plot{levels}", type = "whole number >= 1", text = "Contour lines of a field." },
  { "plot{size}", type = "table { width, height }",
    text = "Size of the picture: characters in the terminal, pixels in a file. With a plot.style in "
      .. "mm these pixels are spread over its width, and letters and lines grow with them." },
  { "plot{panels}", type = "list of tables",
    text = "Several plots in one picture, each a table as for plot{}; what one leaves out it takes "
      .. "from the whole." },
  { "plot{layout}", type = "table { rows, columns }", text = "The grid of the panels." },
  { "plot{letters}", type = "boolean", default = true,
    text = "Writes (a), (b), ... before the titles of panels." },
  { "plot{xplaces}", type = "table { at=, words= }", text = "Words at these places of the x axis, for numbers." },
  { "plot{yplaces}", type = "table { at=, words= }", text = "The same of the y axis." },
  { "plot.default", kind = "field", type = "table",
    text = "Options where a call does not give them: term, size (of pictures in the terminal and in "
      .. "windows), file_size (in pixels), colour, key. Any other is refused." },
  { "plot.style", kind = "function", values = { "paper", "journal", "slides", "screen" },
    use = 'plot.style{ "paper", width="page" }',
    text = "Sizes of the figures in files from now on. paper: 85 mm wide (170 mm where panels stand "
      .. "side by side), letters of 8 points, png with 600 pixels to an inch; journal: the same without the titles that plots give "
      .. "themselves; slides: 254 mm, 20 points, 150; screen: in "
      .. "pixels, as at the start. Returns what holds." },
  { "plot.style{width}", type = "number in [20, 1000]", unit = "mm", values = { "column", "page", "single", "double" },
    text = "Width of the figure: of a column (single), of the page (double), or in mm." },
  { "plot.style{height}", type = "number in [15, 1000]", unit = "mm", text = "Height of the figure." },
  { "plot.style{font}", type = "string", text = 'Name of the letters: "serif", "sans", or that of a font, such as Helvetica.' },
  { "plot.style{title}", type = "boolean", text = "Whether plots write titles of their own; title= of a call always stands." },
  { "plot.style{colour}", type = "string or boolean", text = '"grey" or false: greys, lines told apart by dashes and marks.' },
  { "plot.style{points}", type = "number in [3, 72]", unit = "pt", text = "Size of the letters." },
  { "plot.style{lines}", type = "number in [0.1, 10]",
    text = "Width of lines and size of marks, relative to the screen's." },
  { "plot.style{dpi}", type = "number in [30, 2400]", text = "Pixels of an inch, for png and gif." },
  { "plot.points", kind = "function", takes = "plot",
    use = "plot.points{ x=..., y=..., error=..., title=... }",
    text = "Draws the last picture again with measured points over its curves, to the terminal or to "
      .. "file=. Takes what a curve of plot{} does." },
  { "plot.points{panel}", type = "whole number >= 1", default = 1, text = "In which panel." },
  { "plot.again", kind = "function", use = "plot.again()",
    text = "Draws the last picture once more in the terminal or window, as large as it is now." },
  { "plot.fit", kind = "function", takes = "plot", use = "plot.fit(f, { curves=true })",
    text = "A fit: data with their errors, the model with its band, residuals below; or what a design "
      .. "of a test lets one expect. Takes the options of plot{} too." },
  { "plot.fit{curves}", type = "boolean", default = false,
    text = "Draws the curves over the distance that were fitted instead, with their bands." },
  { "plot.response", kind = "function", takes = "plot",
    use = 'plot.response(s, { x="alpha", y="depth_cylinder", by="stroke" })',
    text = "What the finished cases of a study came to, against a setting that was varied. Takes the "
      .. "options of plot{} too." },
  { "plot.response{x}", type = "string", text = "The varied setting on the abscissa." },
  { "plot.response{y}", type = "string",
    text = "The result: a column of the history, at its end." },
  { "plot.response{by}", type = "string", text = "Another varied setting, a curve for each value." },
  { "plot.response{map}", type = "boolean", default = false,
    text = "Draws a map of x and by with a field of colour for each case." },
  { "plot.response{where}", type = "table",
    text = "Settings of the cases to draw, such as { k=1e-8 }, where more than x and by were varied." },
  { "plot.pressure", kind = "function", takes = "plot", use = "plot.pressure(w1, w2, ..., { scaled=true })",
    text = "Contact pressure against x, of wear and contact objects. The key names the settings in "
      .. "which they differ. Takes the options of plot{} too." },
  { "plot.pressure{scaled}", type = "boolean", default = false,
    text = "Draws x / a against p / p_H, both of Hertz' contact." },
  { "plot.pressure{body}", values = { "cylinder", "plate" }, default = '"cylinder"',
    text = "Which body's pressure." },
  { "plot.pressure{titles}", type = "list of strings", text = "Names of the curves in the key." },
  { "plot.shear", kind = "function", takes = "plot", use = "plot.shear(c, { body= })",
    text = "Shear traction of a contact with friction against x, between the bounds that friction "
      .. "times pressure sets; where it sticks is shaded. In 3-D a map of its size, or of its part along an axis. Takes the options of plot{} too." },
  { "plot.shear{axis}", values = { "x", "z" }, text = "The part to show in 3-D; left out: the size." },
  { "plot.shear{body}", values = { "cylinder", "plate" }, default = '"cylinder"',
    text = "Which body's nodes." },
  { "plot.slip", kind = "function", takes = "plot", use = "plot.slip(c1, c2, ...)",
    text = "How far the plate's surface has slipped over the cylinder's, in um against x, within the "
      .. "contact. In 3-D, of one contact, a map of its size, or of its part along an axis. Takes the options of plot{} too." },
  { "plot.slip{axis}", values = { "x", "z" }, text = "The part to show in 3-D; left out: the size." },
  { "plot.slip{titles}", type = "list of strings", text = "Names of the curves in the key." },
  { "plot.loop", kind = "function", takes = "plot", use = "plot.loop(w, before, ...)",
    text = "Fretting loops: the force in N that drives the plate over its position in um, in the steady cycle of "
      .. "runs with friction or of what their w:loop() gave before. The key tells the energy of each, and in "
      .. "what several runs differ; far ways are in mm. Takes the options of plot{} too." },
  { "plot.loop{titles}", type = "list of strings", text = "Names of the loops in the key; left out, those of their runs." },
  { "plot.fretting_map", kind = "function", takes = "plot", use = "plot.fretting_map(f)",
    text = "A running condition fretting map, load in N over the amplitude of the motion in um: grounds of stick, partial "
      .. "slip and gross slip, their borders, and a mark for each condition; grounds are left out in characters. "
      .. "Takes the options of plot{} too, such as logx=true." },
  { "plot.profile", kind = "function", takes = "plot", values = { "cylinder", "plate" },
    use = 'plot.profile(w1, ..., "plate")',
    text = "Wear depth in um against x; both bodies where none is named. plot.profile(p1, p2, ...) draws measured "
      .. "profiles: heights, or depths after p:depth(). Takes the options of plot{} too." },
  { "plot.profile{body}", values = { "cylinder", "plate" }, text = "Which body's profile." },
  { "plot.profile{titles}", type = "list of strings", text = "Names of the curves in the key." },
  { "plot.profile{measured}", type = "profile, or table { x=, h= }",
    text = "A measured trace as points over the curves of one body: at most 160 means of neighbouring points; of heights "
      .. "the depth. A trace whose scar lies beside x = 0 is moved to it, and the key says by how much." },
  { "plot.history", kind = "function", takes = "plot", use = 'plot.history(w, "p_center", ...)',
    values = columns,
    text = "Columns of w.history against the travelled distance, a panel for each quantity; distances in m or "
      .. "km and depths in nm or mm where they are so long. Takes the options of plot{} too." },
  { "plot.history{against}", values = { "distance", "cycle", "update" }, default = '"distance"',
    text = "The abscissa." },
  { "plot.history{titles}", type = "list of strings", text = "Names of the objects in the key." },
  { "plot.map", kind = "function", takes = "plot", use = 'plot.map(t)  plot.map(w, "height")  plot.map(t, { levels=12, file="t.png" })',
    text = "A map, one of a run or the pressures of a contact in three dimensions, from above, x to the right and z upwards in equal scales: colours with contours and a scale, in characters in the "
      .. "terminal. Values of both signs are white at zero. Maps of more than 240 points along a side are drawn by means." },
  { "plot.map{body}", type = "string", text = "Of a run in three dimensions: whose map; the upper body's where left out." },
  { "plot.map{what}", values = { "depth", "height", "pressure" }, default = '"depth"', text = "Of a run: which map; of a joint's \"cup\", \"head\", \"cross shear\" or \"pressure\"." },
  { "plot.track", kind = "function", takes = "plot", use = 'plot.track(gait "iso")   plot.track(g, { radius=18 })',
    text = "Paths of points of a joint's head over its cup in a cycle, in mm, azimuthal equal-area about the nominal load: of the head's pole, and of "
      .. "six points at 30 degrees from it. Between increments they are straight: a gait of more shows rounder ones." },
  { "plot.track{radius}", type = "number > 0", unit = "mm", default = "14", text = "Of the head." },
  { "plot.surface", kind = "function", takes = "plot", use = 'plot.surface(t)  plot.surface(t, { exaggeration=100 })',
    text = "A map seen obliquely from the front, coloured by its values, with every fifth of 50 rows as a line. Lengths along x and "
      .. "heights are in scale but for the factor of exaggeration, which stands in the title; lengths along z are halved." },
  { "plot.surface{exaggeration}", type = "number > 0",
    text = "Factor of the heights; where left out, one that makes them about a fifth of the longer side." },
  { "plot.mesh", kind = "function", takes = "plot", use = 'plot.mesh(m, { zoom="wear box" })',
    text = "The elements of a model, or of a run w as they are worn by now, whole or near the contact. "
      .. "Takes the options of plot{} too." },
  { "plot.mesh{zoom}", type = "table { x0, x1, y0, y1 }", values = { "wear box", "all" },
    text = "What part to show." },
  { "plot.mesh{unrolled}", type = "boolean", text = "In a hole: along its surface and across it." },
  { "plot.mesh{body}", values = { "cylinder", "plate" }, text = "One body alone." },
  { "plot.stress", kind = "function", takes = "plot", use = 'plot.stress(c, { component="mises" })',
    text = "A stress inside both bodies in colours, with outlines and lines at the numbers of the scale; of a contact, a "
      .. "run as worn, or a field f = c:stress(). Where one body bears more than three times as much, the scale is the "
      .. "other's, and says so; vrange= chooses. Takes the options of plot{} too." },
  { "plot.stress{component}", values = require "archard.plot.mesh".components,
    default = '"mises"', text = "Which stress; shear is the largest in the plane, principal the largest tension." },
  { "plot.stress{zoom}", type = "table { x0, x1, y0, y1 }", values = { "all" },
    text = "What part to show; three half widths of the contact where left out." },
  { "plot.stress{unrolled}", type = "boolean", text = "In a hole: along its surface and across it." },
  { "plot.stress{body}", values = { "cylinder", "plate" }, text = "One body alone." },
  { "plot.stress{deformed}", type = "number", default = 0,
    text = "Draws the nodes displaced, so many times as far as they are." },
  { "plot.animate", kind = "function", use = "plot.animate(w, { file=\"run.gif\" })",
    text = "Steps a run and draws its profiles again and again: over each other in the terminal, as "
      .. "a moving picture with a file." },
  { "plot.animate{what}", values = { "profile", "pressure", "both" }, default = '"profile"',
    text = "What to draw." },
  { "plot.animate{frames}", type = "whole number >= 1", default = 30,
    text = "How many pictures, about; with every, at most." },
  { "plot.animate{every}", type = "whole number >= 1",
    text = "Updates between two pictures; found from frames where left out." },
  { "plot.animate{delay}", type = "number > 0", unit = "s", default = 0.1,
    text = "Time between two pictures." },
  { "plot.animate{file}", type = "string", text = "A file that ends in gif." },
  { "plot.animate{term}", type = "string", text = "As in plot{term}." },
  { "plot.animate{size}", type = "table { width, height }", text = "As in plot{size}." },
  { "plot.animate{colour}", type = "boolean", text = "As in plot{colour}." },
  { "plot.save", kind = "function", use = 'plot.save("p.png")',
    text = "Writes the last picture to a file, and its data as CSV beside it (p.csv). "
      .. "plot.save{ ..., file= } draws what plot{} would. A second table gives size." },

  -- --- export ---------------------------------------------------------------------------------
  { "export", kind = "object", use = "export.csv  .vtk  .pvd  .vti  .gsf  .inp  .msh  .json",
    text = "Writes files for other tools. A file is complete or not there; a wrong ending is refused, "
      .. "a missing one added." },
  { "export.csv", kind = "function", use = "export.csv(obj, path)",
    text = "Columns of numbers with a line of names and units: the history of a wear run, the pressures "
      .. "of a contact (with friction its shear, and the slip at the cylinder's nodes), a table of lists; tables of ours know their units, others have those of a third argument, { x=\"mm\" }. A "
      .. "stress becomes two files, path-cylinder.csv and path-plate.csv; a map has columns x, z and its name, a line a point. Returns what "
      .. "was written." },
  { "export.vti", kind = "function", use = 'export.vti(t, "t.vti")  export.vti({ depth, pressure }, "t.vti")',
    text = "Maps with the same points for ParaView, as ImageData in the plane y = 0: an array of each map, by its name. Returns "
      .. "what was written. Warp By Scalar along y shows them as surfaces." },
  { "export.gsf", kind = "function", use = 'export.gsf(t, "t.gsf")',
    text = "A map as Gwyddion Simple Field, which programs for topographies read: lengths in m, pressures in Pa, in single precision. "
      .. "Returns what was written." },
  { "export.vtk", kind = "function", use = 'export.vtk(obj, "c.vtu")',
    text = "Meshes and fields for ParaView and others, as .vtu (XML) or .vtk (legacy text). Of a "
      .. "model, a run, a contact or its stress come two files, path-cylinder.vtu and path-plate.vtu, "
      .. "whose names are returned. A .vtu has nodes as worn, displacements, stresses, wear depth and "
      .. "pressure (0 off the surface), with their units; bodies with layers the number of each element's." },
  { "export.pvd", kind = "function", use = 'w:run{ progress = export.pvd(w, "w.pvd", { every=10 }) }',
    text = "A run as it wears, for ParaView: a .vtu for each body and state, and the list of them by "
      .. "travelled distance in w.pvd. Writes the present state and returns a function that adds the "
      .. "next ones: in w:run after each `every` updates and where the distance of its definition ends, "
      .. "and wherever it is called without arguments, as after a run that ended earlier." },
  { "export.pvd{every}", type = "number", default = "1", text = "Updates between two states." },
  { "export.inp", kind = "function", use = "export.inp(obj, path)",
    text = "Input deck of the whole problem of a contact, a run (as worn) or a model (at the usual "
      .. "load): both bodies, supports, contact pair, load, output requests, in the keywords that "
      .. "Abaqus and CalculiX share. CalculiX runs it as it is, ccx path without its ending. The "
      .. "bodies are slabs one element thick, held along z: C3D8, C3D8I where the model has CPE4I, "
      .. "C3D6 for triangles. Where nu nears 1/2 the triangles, all away from the contact, are "
      .. "stiffer there than in the model. For plane strain; of other models one mesh can be written, in CPS4 or CAX4, "
      .. "the latter with radii for x and one half of the section." },
  { "export.msh", kind = "function", use = "export.msh(m, path)",
    text = "A model or a mesh as a Gmsh file (4.1, text, mm), with the physical groups that model{ mesh = "
      .. "path } reads: upper is the cylinder, lower the plate, upper.layer1 its first layer. Coordinates read "
      .. "back to the bit. Without a path its text is the result; model{ mesh = } takes that, too." },
  { "export.json", kind = "function", use = "export.json(w, path)",
    text = "Summary of a wear run: versions, definition with its model, bodies and layers, results, units. NaN and what was not given are null, "
      .. "a function of the user the word \"function\"." },

  -- --- help -----------------------------------------------------------------------------------
  { "help", kind = "function", use = 'help()  help(wear)  help(w.step)  help "jump"',
    text = "Explains: what there is, an object, a method, or anything by its name." },
}

-- Help entries of the tools around the engine: csv, profile, plot, export, help. help/engine.lua explains
-- the form of an entry.

local columns = {}
for i, column in ipairs(require "archard.settings".columns) do columns[i] = column.name end

return {
  -- --- csv ------------------------------------------------------------------------------------
  { "csv", kind = "object", use = 'csv.read("measured.csv")',
    text = "csv.read reads columns of numbers from a text file, whose first line has their names: c = csv.read(path) has the "
      .. "lists c.x, c.h. wear{ loading=csv.read(path) } reads a cycle with columns t (0 to 1), x and load. gait.read reads the motion of a joint, profile.read a trace. To "
      .. 'write a table use export.csv, for example export.csv(w:profile("plate"), "plate.csv").' },
  { "csv.read", kind = "function", use = 'csv.read(path, { t="time [s]", x="position" })',
    text = "Reads (imports) columns of numbers from a text file. The first line has the names of the columns; "
      .. "commas, semicolons or tabs separate the columns. Numbers may have decimal commas if the separator is a "
      .. "semicolon or tab. Empty lines and lines that begin with # are skipped; other lines above the names must "
      .. "be deleted or marked with #. Returns the columns as lists by name: loading = csv.read(path) uses columns "
      .. "t, x and load, and worn = { plate = csv.read(path) } uses x and h. Units after names, as in h [um] or h "
      .. "(um), are removed and values converted to mm, N, MPa and s; with other units, the unit remains in the "
      .. "name. The second argument selects and renames columns, by name or number. A column whose first cell is "
      .. "no number is read as text. Without a second argument, csv.read also returns the units by name and the "
      .. "list of names." },

  -- --- profile --------------------------------------------------------------------------------
  { "profile", kind = "function", use = "profile{ x=..., z=... }  profile.read(path, { ... })",
    text = "A measured trace across a surface, such as the trace of a stylus (w:profile is the computed profile). "
      .. 'p = profile.read(path, { level="line" }) reads it from a file. It has positions x and heights z '
      .. "(positive out of the body) or depths h, in mm, and the standard deviation of its noise. p:depth() "
      .. "computes depths, p:volume() the volume of a scar with its error. worn = { plate = p } uses the profile "
      .. 'as the initial surface, plot.profile(w, "plate", { measured = p }) compares it with a run. Methods '
      .. "return new profiles. Points without a value (NaN) are removed; decreasing positions are reversed." },
  { "profile{x}", type = "list", unit = "mm", text = "Positions, increasing or decreasing." },
  { "profile{z}", type = "list", unit = "mm", text = "Heights; give either z or h." },
  { "profile{y}", type = "list", unit = "mm",
    text = "Heights, instead of z; the field has this name in sections of maps." },
  { "profile{h}", type = "list", unit = "mm", text = "Depths; give either h or z." },
  { "profile{level}", values = { "line", "circle" },
    text = "Form that is subtracted, the best line or circle by least squares of heights; see p:level." },
  { "profile{scar}", type = "table { from, to } in mm", values = { "auto" },
    text = 'With level: range of the worn part, which is excluded from the fit; "auto" searches for the range.' },
  { "profile{filter}", type = "number > 0", unit = "mm",
    text = "Cut-off of a Gaussian low-pass filter, applied after levelling; see p:filter." },
  { "profile{error}", type = "number >= 0", unit = "mm",
    text = "Standard deviation of the instrument's noise. Default: an estimate from neighbouring points." },
  { "profile.read", kind = "function", takes = "profile", class = "profile",
    use = 'profile.read("trace.csv", { unit="um", level="line" })',
    text = "Reads a profile from a file of columns, see csv.read. Positions are in the column x, s, position or "
      .. "distance, heights in z, height or y, depths in h or depth. Units after names are converted." },
  { "profile.read{x}", type = "string or whole number >= 1", text = "Column of the positions, by name or number." },
  { "profile.read{z}", type = "string or whole number >= 1", text = "Column of the heights." },
  { "profile.read{h}", type = "string or whole number >= 1", text = "Column of the depths." },
  { "profile.read{unit}", type = 'string or table { x="mm", z="um" }', default = '"mm"',
    text = "Unit of the columns without a unit after their names: mm, um, nm, cm, m or in." },
  { "profile.mean", kind = "function", class = "profile", use = "profile.mean{ p1, p2, ... }",
    text = "Mean of several traces over their common range, at the positions of the first trace, weighted by their "
      .. "noise. Its error is the larger of two estimates, from the noise and from the scatter of the traces." },
  { "profile.x", kind = "field", type = "list", unit = "mm", text = "Positions of the points." },
  { "profile.z", kind = "field", type = "list", unit = "mm",
    text = "Heights of the points; nil in a profile of depths." },
  { "profile.h", kind = "field", type = "list", unit = "mm",
    text = "Depths of the points, negative above the reference; nil in a profile of heights. In worn = { "
      .. "plate = p }, a point above the reference has the depth 0 if its height is at most 5 times the "
      .. "larger of p.error and p.scatter.deviation; higher points are refused. A profile of heights is "
      .. "converted to depths below its highest point." },
  { "profile.error", kind = "field", type = "number", unit = "mm",
    text = "Standard deviation of the noise of a point. It is set by the user or estimated from the "
      .. "deviation of each point from the line between its neighbours (which includes roughness at the "
      .. "sampling step); filter, average and mean reduce it." },
  { "profile.correlation", kind = "field", type = "number", unit = "mm",
    text = "Correlation length of the noise: the step of a raw trace, larger after filtering." },
  { "profile.form", kind = "field", values = { "line", "circle" }, text = "Form that was subtracted; nil if none "
    .. "was." },
  { "profile.radius", kind = "field", type = "number", unit = "mm",
    text = "Radius of the circle that was subtracted." },
  { "profile.scar", kind = "field", type = "table { from=, to= }", unit = "mm", text = "Range of the worn "
    .. "part, if it is known." },
  { "profile.scatter", kind = "field", type = "table { deviation=, length=, points= }", unit = "mm",
    text = "Deviation of the unworn part from the line or circle: standard deviation (roughness and noise, at "
      .. "least that of the noise), correlation length, and the number of points of the unworn part." },
  { "profile.cutoff", kind = "field", type = "number", unit = "mm",
    text = "Cut-off of the filter that was applied; nil without a filter." },
  { "profile.missing", kind = "field", type = "number", text = "Number of points without a value that were removed." },
  { "profile.path", kind = "field", type = "string", text = "File from which the profile was read." },
  { "profile.level", kind = "method", class = "profile", use = 'p:level("circle", "auto")',
    text = "Subtracts a line or circle, by least squares of heights, instead of the form subtracted before. With a "
      .. 'scar { from, to } or "auto", the fit uses only points farther from the scar than 20 % of its width, '
      .. 'which excludes pile-up. "auto" searches for the scar from the deepest point outwards, with a form fitted '
      .. "to the outer 15 % at both ends." },
  { "profile.filter", kind = "method", class = "profile", use = 'p:filter(0.08)  p:filter(0.8, "short")',
    text = 'Gaussian filter (ISO 16610-21): long waves by default, or "short" waves. The amplitude of a wave of the '
      .. "cut-off length [mm] is halved. Near the ends a line is fitted under the remaining weights, so that slopes "
      .. "are preserved (ISO 16610-28, moments to order 1); within half a cut-off of an end the filter smooths less. "
      .. "Needs a constant step." },
  { "profile.average", kind = "method", class = "profile", use = "p:average(0.01)",
    text = "Replaces the points by means over cells of this length [mm]. The new points have a constant step; "
      .. "their number and their noise are smaller." },
  { "profile.cut", kind = "method", class = "profile", use = "p:cut(from, to)",
    text = "The part of a profile between two positions [mm]." },
  { "profile.center", kind = "method", class = "profile", use = "wear{ worn={ plate=p:center() } }",
    text = "The profile shifted along x so that the centre of its scar is x = 0, where the bodies touch; without a scar, "
      .. "the centre of the trace." },
  { "profile.depth", kind = "method", class = "profile", use = "p:depth()  p:depth(before)",
    text = "Depths h below the line or circle through the unworn part, which is fitted as by p:level, or below a "
      .. "trace measured on the same line before wear. Points above the line, circle or trace have negative "
      .. "depths." },
  { "profile.depth{reference}", type = "profile",
    text = "Trace measured on the same line before wear, with heights." },
  { "profile.depth{level}", values = { "line", "circle" }, text = "Form to subtract. Default: the form that "
    .. "was subtracted before, or a line." },
  { "profile.depth{scar}", type = "table { from, to } in mm", values = { "auto" }, default = '"auto"',
    text = "Range of the worn part, which is excluded from the fit." },
  { "profile.volume", kind = "method", use = "p:volume()  p:volume{ length = 2 * math.pi * 5 }",
    text = "Evaluates the scar. Returns a table with area [mm2], the area of its section, and error, the standard "
      .. "deviation of this area, with its two parts scatter (noise and roughness) and level (the subtracted line "
      .. "or circle); volume and volume_error [mm3]; from, to and width [mm]; depth (the largest mean over 1/50 of "
      .. "the width) and mean_depth [mm]; piled [mm2], the area above the reference within 20 % of the width on "
      .. "both sides. Heights are first converted by p:depth()." },
  { "profile.volume{scar}", type = "table { from, to } in mm", values = { "auto" }, text = "Range of the "
    .. "worn part." },
  { "profile.volume{length}", type = "number > 0", unit = "mm", default = 1,
    text = "Length of the scar across the trace; for a wear track of radius r on a disc, 2 pi r." },
  { "profile.roughness", kind = "method", use = "p:roughness{ cutoff=0.8 }",
    text = "Profile parameters by ISO 21920-2 (names of ISO 4287), in mm: Ra, Rq, Rsk, Rku, Rt and the slope Rdq "
      .. "over the evaluation length; Rp, Rv, Rz as means over sections of one cut-off; RSm, the mean width of "
      .. "the profile elements, each a peak and a valley of more than a tenth of Rz (NaN for fewer than two). The mean "
      .. "line is computed by the Gaussian filter; half a cut-off at both ends is excluded. The field noise is the "
      .. "measurement noise p.error, which is contained in Rq: the surface alone has sqrt(Rq^2 - noise^2)." },
  { "profile.roughness{cutoff}", type = "number > 0, or false", unit = "mm", default = 0.8,
    text = "Cut-off of long waves. false: no cut-off; the results are then Pa, Pq, ... about a straight line." },
  { "profile.roughness{short}", type = "number > 0", unit = "mm", text = "Cut-off of short waves; default: none." },
  { "profile.roughness{sections}", type = "whole number >= 1",
    text = "Number of sections; default: 5, or as many as fit into the trace (1 for a P-profile)." },

  -- --- plot -----------------------------------------------------------------------------------
  { "plot", kind = "function", use = 'plot.profile(w)   plot.history(w, "depth_plate", { file="wear.png" })\n'
    .. "plot{ {x=..., y=..., title=...}, ..., xlabel=..., file=... }",
    text = "plot.profile, plot.history, plot.pressure and others draw results of a run w: the worn profiles, "
      .. "a column of its history against the distance. All accept the fields below, such as file, in a table "
      .. "at the end. plot{} draws curves from lists of x and y, given as the items of its table; NaN and "
      .. "infinite values interrupt a curve. Pictures are drawn with gnuplot in the terminal, a window "
      .. "or a file. In titles \\alpha becomes the Greek letter; in files and windows p_H has a subscript "
      .. "and mm^2 a superscript. With more than eight curves, each is labelled at its end instead of in the "
      .. "legend." },
  { "plot{x}", type = "list", text = "For a curve: list of its abscissae; default: 1, 2, 3, ..." },
  { "plot{y}", type = "list", text = "For a curve: list of its ordinates." },
  { "plot{value}", type = "list",
    text = "An item of the list part with this list is drawn as a coloured field. Its lists x, y and value "
      .. "have four numbers for each polygon, one for each corner; a triangle repeats its last corner. For a "
      .. "curve: a number that selects its colour in the colour scale." },
  { "plot{error}", type = "list", text = "For a curve: list of the half lengths of its error bars in y." },
  { "plot{points}", type = "table { x=, y=, error=, title= }",
    text = "Measured points to draw over the curves, with the fields of plot.points{}." },
  { "plot{title}", type = "string or false",
    text = "Title of the plot; false: no title. For a curve: its name in the key (legend)." },
  { "plot{term}", values = require "archard.plot.draw".terms,
    text = "Output device. Default: pictures if the terminal supports kitty's graphics or sixel; else "
      .. "Braille dots if it has colours and UTF-8 (not in xterm, whose fonts lack them); else characters. "
      .. '"dots" selects Braille dots and "dumb" characters; "window" is the first of qt, wxt and x11 that '
      .. "gnuplot supports." },
  { "plot{file}", type = "string",
    text = "Name of the file for the plot. Its ending selects the format: png, svg, pdf, eps, gif, txt, or gp for "
      .. "gnuplot's commands. An existing file is replaced only when the new one is complete." },
  { "plot{xlabel}", type = "string", text = "Label of the x axis." },
  { "plot{ylabel}", type = "string", text = "Label of the y axis." },
  { "plot{vlabel}", type = "string", text = "Label of the colour scale of a field." },
  { "plot{xrange}", type = "table { low, high }",
    text = "Range of the x axis. { high, low } reverses the axis; an omitted end is automatic." },
  { "plot{yrange}", type = "table { low, high }", text = "Range of the y axis." },
  { "plot{vrange}", type = "table { low, high }", text = "Range of the colour scale of a field." },
  { "plot{logx}", type = "boolean", default = false, text = "If true, the x axis is logarithmic." },
  { "plot{logy}", type = "boolean", default = false, text = "If true, the y axis is logarithmic." },
  { "plot{xdown}", type = "boolean", default = false, text = "If true, x increases to the left, also if "
    .. "xrange is { high, low }." },
  { "plot{ydown}", type = "boolean", default = false, text = "If true, y increases downwards, also if "
    .. "yrange is { high, low }." },
  { "plot{key}", type = "string or boolean", default = '"below"',
    values = require "archard.gnuplot".keys,
    text = "Position of the key (legend); false: no key. By default panels have one common key below them." },
  { "plot{style}", values = require "archard.gnuplot".styles,
    default = '"lines"',
    text = "Style of the curves, or of one curve. Default: lines, with marks at the points in windows and files if "
      .. "a curve has 4 to 30 points." },
  { "plot{colour}", type = "string or boolean",
    text = 'For the whole plot: "grey" or false draws greys in files and no colours in the terminal. For a '
      .. 'curve: "#rrggbb" or the name of a colour.' },
  { "plot{series}", type = "whole number >= 1",
    text = "For a curve: number of its colour, mark and dash pattern, repeated after 8; default: the next number." },
  { "plot{dash}", type = "whole number >= 1",
    text = "For a curve: line type, 1 solid, 2 to 8 dashed, in windows and files." },
  { "plot{width}", type = "number > 0", default = 1, text = "For a curve: relative width of the line." },
  { "plot{on}", values = { "pixels", "characters" },
    text = "For a curve: draws it only in pictures of pixels, or only in pictures of characters; default: in "
      .. "both." },
  { "plot{equal}", type = "boolean", default = false, text = "If true, both axes have the same scale." },
  { "plot{levels}", type = "whole number >= 1", text = "Number of contour lines of a field." },
  { "plot{size}", type = "table { width, height }",
    text = "Size of the picture: characters in the terminal, pixels in a file. If plot.style sets a width in mm, "
      .. "the pixels cover this width, and letters and lines are scaled in proportion." },
  { "plot{panels}", type = "list of tables",
    text = "Several plots in one picture, a list of tables with the fields of plot{}; an omitted option has the "
      .. "value for the whole picture." },
  { "plot{layout}", type = "table { rows, columns }", text = "Number of rows and columns of the panels." },
  { "plot{letters}", type = "boolean", default = true,
    text = "If true, (a), (b), ... are written before the titles of panels." },
  { "plot{xplaces}", type = "table { at=, words= }",
    text = "Labels (the list words) instead of numbers at positions (the list at) of the x axis." },
  { "plot{yplaces}", type = "table { at=, words= }",
    text = "Labels (the list words) instead of numbers at positions (the list at) of the y axis." },
  { "plot.default", kind = "field", type = "table",
    text = "Default options: term, size (in the terminal and in windows), file_size (in pixels), colour, key." },
  { "plot.style", kind = "function", values = { "paper", "journal", "slides", "screen" },
    use = 'plot.style{ "paper", width="page" }',
    text = 'Style of figures for papers and slides, also in greyscale: plot.style{ "paper", colour="grey" }. '
      .. "paper: 85 mm wide (170 mm if panels are side by side), letters of 8 points, png of 600 dpi; journal: as "
      .. "paper, but without automatic titles; slides: 254 mm wide, letters of 20 points, png of 150 dpi; screen, "
      .. "the default: sizes in pixels. The ending of plot{ file= } chooses the format: .pdf, .eps, .svg, .png. "
      .. "Returns the present style." },
  { "plot.style{width}", type = "number in [20, 1000]", unit = "mm", values = { "column", "page", "single", "double" },
    text = 'Width of the figure: a column ("single"), the page ("double"), or a number.' },
  { "plot.style{height}", type = "number in [15, 1000]", unit = "mm", text = "Height of the figure." },
  { "plot.style{font}", type = "string", text = 'Font: "serif", "sans", or a name such as Helvetica.' },
  { "plot.style{title}", type = "boolean", text = "If false, pictures have no automatic titles. A title= in a call "
    .. "is always shown." },
  { "plot.style{colour}", type = "string or boolean",
    text = '"grey" or false: draws in greys, with dashes and marks to distinguish the lines.' },
  { "plot.style{points}", type = "number in [3, 72]", unit = "pt", text = "Size of the letters." },
  { "plot.style{lines}", type = "number in [0.1, 10]",
    text = "Width of lines and size of marks, relative to the style screen." },
  { "plot.style{dpi}", type = "number in [30, 2400]", text = "Resolution of png and gif in pixels per inch." },
  { "plot.points", kind = "function", takes = "plot",
    use = "plot.points{ x=..., y=..., error=..., title=... }",
    text = "Draws the last picture again with measured points over its curves, in the terminal or to a file "
      .. "(file=). Accepts the fields of a curve of plot{}." },
  { "plot.points{panel}", type = "whole number >= 1", default = 1,
    text = "Number of the panel in which the points are drawn." },
  { "plot.again", kind = "function", use = "plot.again()",
    text = "Draws the last picture again at the present size of the terminal or window." },
  { "plot.fit", kind = "function", takes = "plot", use = "plot.fit(f, { curves=true })",
    text = "Draws a fit: data with error bars, the model with its confidence band, and residuals below. For a "
      .. "result of fit.design it draws the expected errors. Accepts the options of plot{}." },
  { "plot.fit{curves}", type = "boolean", default = false,
    text = "If true, draws the identified curves over the distance instead of the data, with their confidence bands." },
  { "plot.response", kind = "function", takes = "plot",
    use = 'plot.response(s, { x="alpha", y="depth_cylinder", by="stroke" })',
    text = "Draws final results of a study against a varied field. Accepts the options of plot{}." },
  { "plot.response{x}", type = "string", text = "Varied field on the abscissa." },
  { "plot.response{y}", type = "string",
    text = "Result on the ordinate: a column of the history, at the end of each case." },
  { "plot.response{by}", type = "string", text = "Another varied field; each of its values has a curve." },
  { "plot.response{map}", type = "boolean", default = false,
    text = "If true, draws a map over the fields x and `by`, with a coloured rectangle for each case." },
  { "plot.response{where}", type = "table",
    text = "Values of other varied fields that select the cases to draw, such as { k=1e-8 }." },
  { "plot.pressure", kind = "function", takes = "plot", use = "plot.pressure(w1, w2, ..., { scaled=true })",
    text = "Draws the contact pressure of runs and contacts against x. The key lists the fields in which "
      .. "they differ. Accepts the options of plot{}." },
  { "plot.pressure{scaled}", type = "boolean", default = false,
    text = "If true, draws p / p_H against x / a, with Hertz' pressure p_H and half width a." },
  { "plot.pressure{body}", values = { "cylinder", "plate" }, default = '"cylinder"',
    text = "Body at whose nodes the pressure is drawn." },
  { "plot.pressure{titles}", type = "list of strings", text = "Names of the curves in the key." },
  { "plot.shear", kind = "function", takes = "plot", use = "plot.shear(c, { body= })",
    text = "Draws the shear traction of a contact with friction against x, with the bounds +- friction "
      .. "times pressure; stick zones are shaded. In 3-D it draws a map of the magnitude or of a component. "
      .. "Accepts the options of plot{}." },
  { "plot.shear{axis}", values = { "x", "z" }, text = "In 3-D: component to draw; default: the magnitude." },
  { "plot.shear{body}", values = { "cylinder", "plate" }, default = '"cylinder"',
    text = "Body at whose nodes the shear traction is drawn." },
  { "plot.slip", kind = "function", takes = "plot", use = "plot.slip(c1, c2, ...)",
    text = "Draws the slip of the plate's surface relative to the cylinder's, in um, against x in the "
      .. "contact. In 3-D it draws a map of the magnitude or of a component, for one contact. Accepts the "
      .. "options of plot{}." },
  { "plot.slip{axis}", values = { "x", "z" }, text = "In 3-D: component to draw; default: the magnitude." },
  { "plot.slip{titles}", type = "list of strings", text = "Names of the curves in the key." },
  { "plot.loop", kind = "function", takes = "plot", use = "plot.loop(w, before, ...)",
    text = "Draws fretting loops of runs with friction or of results of w:loop(): tangential force [N] over the "
      .. "position of the plate [um, or mm for long strokes] in a periodic cycle. The key has the energy of each "
      .. "loop and the fields in which the runs differ. Accepts the options of plot{}." },
  { "plot.loop{titles}", type = "list of strings",
    text = "Names of the loops in the key; default: the names of their runs." },
  { "plot.fretting_map", kind = "function", takes = "plot", use = "plot.fretting_map(f)",
    text = "Draws a running condition fretting map, load [N] over amplitude of motion [um], with areas of stick, "
      .. "partial slip and gross slip, their borders, and a mark for each computed condition. In terminals without "
      .. "pictures the areas are not drawn. Accepts the options of plot{}, such as logx=true." },
  { "plot.profile", kind = "function", takes = "plot", values = { "cylinder", "plate" },
    use = 'plot.profile(w1, w2, "plate", { titles={ "new", "old" } })',
    text = "Draws the wear depths of one or several runs in um against x; default: of both bodies. plot.profile(p1, p2, ...) draws "
      .. "measured profiles: heights, or depths after p:depth(). Accepts the options of plot{}." },
  { "plot.profile{body}", values = { "cylinder", "plate" }, text = "Body whose profiles are drawn." },
  { "plot.profile{titles}", type = "list of strings", text = "Names of the curves in the key." },
  { "plot.profile{section}", type = "table { x= } or { z= }", unit = "mm",
    text = "In 3-D: the section to draw, { x = 0 } across the motion or { z = 0 } along it; default: both." },
  { "plot.profile{measured}", type = "profile, or table { x=, h= }",
    text = "A measured trace to draw as points over the curves of one body. Long traces are reduced to 160 means "
      .. "of neighbouring points; heights are converted to depths. A trace whose scar is not at x = 0 is shifted "
      .. "to x = 0, and the key states the shift." },
  { "plot.history", kind = "function", takes = "plot", use = 'plot.history(w, "p_center", ...)',
    values = columns,
    text = "Draws columns of w.history against the travelled distance, with a panel for each quantity. "
      .. "Units follow the values: distances in mm, m or km, depths in nm, um or mm. Accepts the options of "
      .. "plot{}." },
  { "plot.history{against}", values = { "distance", "cycle", "update" }, default = '"distance"; for joints "cycle"',
    text = "Quantity on the abscissa." },
  { "plot.history{titles}", type = "list of strings", text = "Names of the objects in the key." },
  { "plot.map", kind = "function", takes = "plot", use = 'plot.map(t)  plot.map(w, "height")  plot.map(t, { levels=12, file="t.png" })',
    text = "Draws a map seen from above in equal scales, x to the right and z upwards, in colours with "
      .. "contours: a map{}, a map of a run, or the pressures of a 3-D contact. Zero is white if there are "
      .. "values of both signs. Maps of more than 240 points along a side are averaged." },
  { "plot.map{body}", type = "string", text = "Body of a 3-D run; default: the upper body." },
  { "plot.map{what}", values = { "depth", "height", "pressure" }, default = '"depth"',
    text = 'Quantity of a run to draw; for a joint "cup", "head", "cross shear" or "pressure".' },
  { "plot.track", kind = "function", takes = "plot", use = 'plot.track(w)   plot.track(gait "iso", { radius=18 })',
    text = "Draws the paths of seven points of the head (its pole and six points at 30 degrees from the pole) over "
      .. "the cup of a joint in one cycle, in mm, in azimuthal equal-area projection about the nominal load. The "
      .. "paths are straight between increments; increase the gait's increments for smooth curves." },
  { "plot.track{radius}", type = "number > 0", unit = "mm", default = "14", text = "Radius of the head; for "
    .. "a run the radius of its joint is used." },
  { "plot.surface", kind = "function", takes = "plot", use = 'plot.surface(t)  plot.surface(t, { exaggeration=100 })',
    text = "Draws a map seen obliquely from the front as 50 coloured rows, with a line along every fifth row. The "
      .. "scale of heights is the scale of x multiplied by the exaggeration, which the title shows; lengths along "
      .. "z are drawn at half scale." },
  { "plot.surface{exaggeration}", type = "number > 0",
    text = "Factor on the heights. By default the heights are drawn as about a fifth of the longer side." },
  { "plot.mesh", kind = "function", takes = "plot", use = 'plot.mesh(m, { zoom="wear box" })',
    text = "Draws the elements of a model, or the worn elements of a run, either all elements or only the elements "
      .. "near the contact. Accepts the options of plot{}." },
  { "plot.mesh{zoom}", type = "table { x0, x1, y0, y1 }", values = { "wear box", "all" },
    text = "Part of the mesh to draw." },
  { "plot.mesh{unrolled}", type = "boolean", text = "If true, positions in a hole are drawn along "
    .. "its surface and across it instead of x and y." },
  { "plot.mesh{body}", values = { "cylinder", "plate" }, text = "The only body to draw; default: both bodies." },
  { "plot.stress", kind = "function", takes = "plot", use = 'plot.stress(c, { component="mises" })',
    text = "Draws a stress in colours with contours, for a contact, a worn run, or a field f = c:stress(): inside "
      .. "both bodies, in 3-D on a section of one body (body=; default: the lower one). If the largest value of "
      .. "mises or shear in one body is more than three times the value in the other body, the colour scale covers "
      .. "the body with less stress, and its label has the maximum of the other body; vrange= sets another range. "
      .. "Accepts the options of plot{}." },
  { "plot.stress{section}", type = "table { z= }, { x= } or { y= }", default = "{ z = 0 }",
    text = "In 3-D: a section along (z=) or across (x=) the motion, or the plane at y <= 0 below the surface." },
  { "plot.stress{component}", values = require "archard.plot.mesh".components,
    default = '"mises"', text = "Stress component; shear is the largest in the plane, principal the largest tension." },
  { "plot.stress{zoom}", type = "table { x0, x1, y0, y1 }", values = { "all" },
    text = "Part of the bodies to draw; default: three half widths of the contact." },
  { "plot.stress{unrolled}", type = "boolean", text = "If true, positions in a hole are drawn along "
    .. "its surface and across it instead of x and y." },
  { "plot.stress{body}", values = { "cylinder", "plate" }, text = "The only body to draw; default: both bodies." },
  { "plot.stress{deformed}", type = "number",
    text = "Factor on the displacements of the drawn nodes. By default it is 1, and the upper body is "
      .. "lowered by the approach, so that worn bodies touch." },
  { "plot.animate", kind = "function", use = "plot.animate(w, { file=\"run.gif\" })",
    text = "Continues a run and draws its profiles at regular updates: in the terminal, where each picture "
      .. "replaces the last one, or as an animation in a file." },
  { "plot.animate{what}", values = { "profile", "pressure", "both", "stroke" }, default = '"profile"',
    text = 'Quantity to draw; "stroke": in 3-D, the pressures over a stroke on the present surfaces.' },
  { "plot.animate{frames}", type = "whole number >= 1", default = 30,
    text = "Approximate number of pictures. If `every` is given: largest number of pictures, by default no limit." },
  { "plot.animate{every}", type = "whole number >= 1",
    text = "Number of updates between two pictures; default: computed from `frames`." },
  { "plot.animate{delay}", type = "number > 0", unit = "s", default = 0.1,
    text = "Time between two pictures." },
  { "plot.animate{file}", type = "string", text = "Name of the animation file, with the ending gif." },
  { "plot.animate{term}", type = "string", text = "Output device, see plot{term}." },
  { "plot.animate{size}", type = "table { width, height }", text = "Size of the pictures, see plot{size}." },
  { "plot.animate{colour}", type = "boolean", text = "Colours or greys, see plot{colour}." },
  { "plot.save", kind = "function", use = 'plot.save("p.png")',
    text = "Writes the last picture to a file, and its data to a CSV file of the same name (p.csv). plot.save{ "
      .. "..., file= } is the same as plot{ ..., file= }. A second table sets the size, { size = { width, height } "
      .. "}." },

  -- --- export ---------------------------------------------------------------------------------
  { "export", kind = "object", use = "export.csv  .vtk  .pvd  .vti  .gsf  .inp  .msh  .json",
    text = "Writes files for other programs. An existing file is replaced only when the new one is complete. A "
      .. "wrong ending is refused, and a missing one is appended." },
  { "export.csv", kind = "function", use = "export.csv(obj, path)",
    text = "Writes columns of numbers under a line of names and units: the history of a run, the pressures of a "
      .. 'contact (with friction also shear and slip), the table of a study, or a table of lists, with units in a third argument { x="mm" }. { decimal="," } there writes '
      .. 'decimal commas and semicolons. '
      .. 'For the worn surface of a run use export.csv(w:profile("plate"), path). A stress is written to two files, '
      .. "path-cylinder.csv and path-plate.csv. A map is written with one line per point: x, z and the value. "
      .. "Returns the names of the files." },
  { "export.vti", kind = "function", use = 'export.vti(t, "t.vti")  export.vti({ depth, pressure }, "t.vti")',
    text = "Writes maps on the same points for ParaView, as ImageData in the plane y = 0, with an array for each "
      .. "map under its name. A 3-D run is written to a file for each body, path-ball.vti and path-block.vti, with "
      .. "depth, height and pressure; for a contact the pressure is written. Returns the names of the files. In "
      .. "ParaView, Warp By Scalar along y shows them as surfaces." },
  { "export.gsf", kind = "function", use = 'export.gsf(t, "t.gsf")',
    text = "Writes a map as Gwyddion Simple Field for topography programs: lengths in m, pressures in Pa, single "
      .. "precision. Returns the name of the file." },
  { "export.vtk", kind = "function", use = 'export.vtk(obj, "c.vtu")',
    text = "Writes meshes and fields for ParaView and other programs, as .vtu (XML) or .vtk (legacy text). A "
      .. "model, run, contact or stress becomes two files, path-cylinder.vtu and path-plate.vtu, whose names are "
      .. "returned. A .vtu has worn nodes, displacements, stresses, wear depth and pressure (0 off the surface) "
      .. "with units, and the layer of each element. A joint's run becomes path-head.vtu and path-cup.vtu with "
      .. "wear depth, pressure and cross-shear." },
  { "export.pvd", kind = "function", use = 'w:run{ progress = export.pvd(w, "w.pvd", { every=10 }) }',
    text = "Writes a series of states of a run for ParaView: a .vtu (for maps a .vti) for each body and state, and "
      .. "w.pvd, which lists these files by distance. The call writes the present state and returns a function "
      .. "that writes further states: w:run{ progress= } calls it after each `every` updates and at the end; it "
      .. "can also be called without arguments." },
  { "export.pvd{every}", type = "number", default = "1",
    text = "Number of updates between two written states; 1: every update is written." },
  { "export.inp", kind = "function", use = "export.inp(obj, path)",
    text = "Writes an input deck of a contact, a run (with its worn surfaces) or a model (at its default "
      .. "load) for Abaqus and CalculiX: both bodies, supports, contact pair, load and output requests. "
      .. "CalculiX runs it with ccx path (without ending). The bodies are one element thick and fixed along "
      .. "z. Their elements are C3D8 (C3D8I for CPE4I), and C3D6 for triangles. As nu approaches 1/2, C3D6 "
      .. "is stiffer than the triangles of the model. A pair of bodies needs plane strain. In plane stress and for bodies "
      .. "of revolution, m.mesh.plate:write(path) writes a mesh alone, with CPS4 elements, or with CAX4 elements for "
      .. "one half of the section, with the radius as x." },
  { "export.msh", kind = "function", use = "export.msh(m, path)",
    text = "Writes a model or mesh as a Gmsh file (4.1, text, mm), with the physical groups that model{ mesh = "
      .. "path } reads: upper is the cylinder, lower the plate, upper.layer1 the first layer of the cylinder. "
      .. "Coordinates are exact. Without a path the text is returned, which model{ mesh = } accepts too." },
  { "export.json", kind = "function", use = "export.json(w, path)",
    text = "Writes a summary of a run, also of a joint: versions, definition with model, bodies and layers, "
      .. 'results, units. NaN and omitted values are written as null, functions as the word "function".' },

  -- --- help -----------------------------------------------------------------------------------
  { "help", kind = "function", use = 'help()  help(wear)  help(w.step)  help "jump"',
    text = 'Shows help: help() is the overview, help(wear) explains an object, help(w.step) a method, help "jump" '
      .. 'a name, help "glossary" a topic.' },
}

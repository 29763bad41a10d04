-- Tests measured points over curves, and plot.response.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local pictures = dofile(here .. "/lib/pictures.lua")
local ok, has, refused = tap.ok, tap.holds, tap.fails
local folder, read, script_of, line = pictures.folder, pictures.read, pictures.script_of, pictures.line

-- --- measured points, response plots --------------------------------------------------------------

do
  local measured = { x = { 1, 2 }, y = { 2, 5 }, error = { 0.5, 1 }, title = "measured" }
  local script = script_of(function(file) plot { line, points = measured, file = file } end)
  has(script, "using 1:2:3 with yerrorbars", "points with errors have error bars")
  has(script, "2 5 1\n", "length of the error bars")
  plot { line, file = folder .. "/p.txt" }
  measured.file = folder .. "/q.txt"
  plot.points(measured)
  local text = read("q.txt") or ""
  ok(text:find("squares") and text:find("measured"), "plot.points adds to the last picture")
  ok(not read("p.txt"):find("measured"), "plot.points does not change the file of the last picture")
  local first = script_of(function(file) plot.points { x = measured.x, y = measured.y, error = measured.error, file = file } end)
  local _, bars = first:gsub("with yerrorbars", "")
  ok(bars == 1, "equal points added again are drawn once")
  local other = script_of(function(file) plot.points { x = { 1, 2 }, y = { 3, 5 }, error = { 1, 1 }, file = file } end)
  _, bars = other:gsub("with yerrorbars", "")
  ok(bars == 2, "different points are added to earlier points")
  measured.error = { 0.5 }
  refused(function() plot.points(measured) end, "error has 1: expected equal lengths",
    "fewer errors than points")
  measured.error = { 0.5, -1 }
  refused(function() plot.points(measured) end, "error[2] must be a finite number >= 0", "a negative error")
  refused(function() plot.points { x = { 1 } } end, "y", "points without y")
  measured.error, measured.panel = nil, 3
  refused(function() plot.points(measured) end, "one of the 1 panels",
    "points in a panel that does not exist")
end

-- Returns a study of four cases with two strokes and two alphas, whose depth is stroke * alpha [mm].
local function sweep(extra)
  local study_, list = { varied = { "alpha", "stroke", extra }, flat = {} }, {}
  for _, stroke in ipairs { 1, 2 } do
    for _, alpha in ipairs { 0.75, 0.25 } do
      local id = #list + 1
      study_.flat[id] = { alpha = alpha, stroke = stroke, k = extra and id }
      list[id] = { id = id, status = "done", last = { depth_plate = stroke * alpha, depth_partition = 2e-3 * stroke } }
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
  has(script, "$d0_0 << END\n0.25 0.25\n0.75 0.75\nEND", "plot.response sorts the points by x")
  has(script, "$d0_1 << END\n0.25 0.5\n0.75 1.5\nEND", "plot.response draws a curve for each value")
  has(script, 'title "s = 2 mm"', "the key shows the value of each curve")
  has(script, 'set title "wear depth of the plate"', "the title names the result and the body")
  script = script_of(function(file)
    plot.response(sweep(), { x = "alpha", y = "depth_plate", by = "stroke", map = true, file = file })
  end)
  has(script, 'set xtics ("0.25" 1, "0.75" 2)', "a response map has the values at its axes")
  has(script, "with image", "a response map in colours")
  has(script, 'set cblabel "wear depth / ', "a response map has a label at its colour scale")
  has(script_of(function(file)
    plot.response(sweep(), { x = "alpha", y = "depth_partition", by = "stroke", map = true, file = file })
  end), " / 10⁻³\"", "small values of a response map have a power of ten in the label")
  ok(tonumber(script:match "set rmargin ([%d.]+)") > 9, "the margin contains the scale and its label")
  refused(function() plot.response(sweep(), { x = "alpha", y = "depth_plate", where = { alfa = 0.5 } }) end,
    "field 'where': no case has a setting 'alfa' (did you mean 'alpha'?)", "a misspelt setting in where")
  refused(function() plot.response(sweep(), { x = "alpha", y = "depth_plate", where = { stroke = 7 } }) end,
    "no finished case", "a value in where without a case")
  local dotted = sweep("model.radius")
  for id = 1, 4 do dotted.flat[id]["model.radius"] = id end
  dotted.flat[2].alpha = 0.75
  refused(function() plot.response(dotted, { x = "alpha", y = "depth_plate", by = "stroke" }) end,
    'where={ ["model.radius"]=1 }', "the message suggests a value in the syntax of Lua")
  refused(function() plot.response(sweep(), { x = "alpha", y = "depth_plate" }) end,
    'by="stroke" or where={ stroke=1 }', "the message names the settings that are neither x nor by")
  script = script_of(function(file)
    plot.response(sweep(), { x = "alpha", y = "depth_plate", where = { stroke = 2 }, file = file })
  end)
  has(script, "0.25 0.5\n0.75 1.5", "where selects the cases")
  refused(function() plot.response(sweep(), { x = "alfa", y = "depth_plate" }) end,
    "did you mean 'alpha'", "x is not a varied setting")
  refused(function()
    plot.response(sweep(), { x = "alpha", by = "stroke", y = "depth_plat" })
  end, "did you mean 'depth_plate'", "an unknown result")
  refused(function() plot.response(7) end, "expected a study", "plot.response of a number")
end

pictures.remove()

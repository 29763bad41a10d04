-- Help entries of maps: heights, depths and pressures over a rectangle. Form: help.lua.

return {
  { "map", kind = "function", use = "map{ x=..., z=..., y=... }",
    text = "Values y over a rectangle of points (x, z): x along the motion, z across it, heights y upwards. Points lie "
      .. "at even steps in mm. y is a flat list, x-major: the value at x[i], z[j] is y[(i - 1)*#z + j]. "
      .. "Methods return new maps; t1 - t2 and t1 + t2 take the second between its points where the first has its own, "
      .. "and t - number shifts it." },
  { "map{x}", type = "list of numbers", unit = "mm", text = "Points along the motion, growing in even steps (to a twentieth of one)." },
  { "map{z}", type = "list of numbers", unit = "mm", text = "Points across the motion, likewise." },
  { "map{y}", type = "list or function (x, z)", text = "Values, #x times #z; or a function that computes them." },
  { "map{unit}", type = "string", default = '"mm"', text = "Unit of y: \"MPa\" of pressures." },
  { "map{name}", type = "string", default = '"height"', text = "What y is, for print, pictures and files." },
  { "map.read", kind = "function", class = "map", use = 'map.read("scar.sdf", { level="plane" })',
    text = "A measured map from a file: text of points x y z (.xyz) or a matrix of heights, Surfer .grd (DSAA, DSBB, DSRB), ISO "
      .. "25178-71 .sdf (text and binary), Gwyddion .gsf, Digital Surf .sur, Alicona .al3d. The file's first bytes say which. Its x "
      .. "is x, its y is z, its height z is y; the upper edge of an image has the largest z. Not read: .x3p (a zip archive), "
      .. "compressed .sur, .gwy; save those as .sdf or .gsf. Done in this order: crop, outliers, fill, level." },
  { "map.read{unit}", type = 'string or table { x="mm", y="um" }',
    text = "Unit where the file tells none: mm, um, nm, cm, m or in; x is that of both places, y that of heights. The file's own goes "
      .. "before it. Needed for .grd, and for .xyz without units behind its names." },
  { "map.read{step}", type = "number > 0 or table { along x, along z }", unit = "mm",
    text = "Distance of points of a text matrix, whose rows run along x, the first at the smallest z." },
  { "map.read{crop}", type = "table { x={ from, to }, z={ from, to } }", unit = "mm", text = "The part to keep, as t:crop." },
  { "map.read{outliers}", type = "number > 0",
    text = "Replaces points that are off the median of their eight neighbours by more than so many times what points scatter about "
      .. "it (robustly: 1.48 times the median distance). 20 takes spikes." },
  { "map.read{fill}", type = "true or number in mm",
    text = "What points without a value get: true the mean of their neighbours, a number that height. They are refused where left out." },
  { "map.read{level}", values = { "plane", "sphere" }, text = "Subtracts the best one, as t:level." },
  { "map.read{scar}", type = "table { x0, x1, z0, z1 }", unit = "mm", text = "With level: not fitted there." },
  { "map.x", kind = "field", type = "list", unit = "mm", text = "Points along the motion." },
  { "map.z", kind = "field", type = "list", unit = "mm", text = "Points across the motion." },
  { "map.y", kind = "field", type = "list", text = "Values, x-major: y[(i - 1)*#z + j] at x[i], z[j]." },
  { "map.size", kind = "field", type = "table { nx, nz }", text = "Number of points along x and z." },
  { "map.unit", kind = "field", type = "string", text = "Unit of y." },
  { "map.name", kind = "field", type = "string", text = "What y is." },
  { "map.form", kind = "field", values = { "plane", "sphere" }, text = "What t:level subtracted; nil before." },
  { "map.radius", kind = "field", type = "number", unit = "mm", text = "Radius of the sphere that was subtracted." },
  { "map.missing", kind = "field", type = "number", text = "Points without a value that were filled." },
  { "map.outliers", kind = "field", type = "number", text = "Outliers that were replaced." },
  { "map.path", kind = "field", type = "string", text = "The file it was read from." },
  { "map.at", kind = "method", use = "t:at(x, z)", text = "Value at a point, bilinear between the four around it." },
  { "map.profile", kind = "method", use = "t:profile{ z=0 }  t:profile{ x=0 }",
    text = "Section along x at one z, or along z at one x: { x=, y= }, where x is the position along the section. "
      .. "plot{ line } draws it, profile(line) makes a profile of it." },
  { "map.profile{x}", type = "number", unit = "mm", text = "Position of a section across the motion." },
  { "map.profile{z}", type = "number", unit = "mm", text = "Position of a section along the motion." },
  { "map.level", kind = "method", class = "map", use = 't:level()  t:level("sphere", { -0.3, 0.3, -0.2, 0.2 })',
    text = "Subtracts the plane or sphere that fits best, by least squares of vertical distances; points within "
      .. "{ x0, x1, z0, z1 }, such as a scar, are not fitted. radius is the sphere's." },
  { "map.crop", kind = "method", class = "map", use = "t:crop{ x={ -0.5, 0.5 }, z={ 0 } }", text = "The points within ranges." },
  { "map.crop{x}", type = "table { from, to }", unit = "mm", text = "Range along the motion, one end may be left out." },
  { "map.crop{z}", type = "table { from, to }", unit = "mm", text = "Range across the motion." },
  { "map.resample", kind = "method", class = "map", use = "t:resample(0.01)",
    text = "Points at another step in mm, about the same middle: linear between points for a smaller step, means over "
      .. "cells of the new size for a larger one." },
  { "map.volume", kind = "method", use = "t:volume()  t:volume(-1e-4)",
    text = "above and below a level (0), and net, their difference, in mm3 (of pressures: N); area above it in mm2. Each "
      .. "point stands for a cell of one step by one step." },
}

-- Help entries of maps: heights, depths and pressures over a rectangle. help/engine.lua explains the form
-- of an entry.

return {
  { "map", kind = "function", use = "map{ x=..., z=..., y=... }",
    text = "Values y on a grid of points (x, z) with constant steps: x along the motion, z across it, heights y "
      .. "upwards, in mm. y is a flat list: the value at x[i], z[j] is y[(i - 1)*#z + j]. Methods return new maps. "
      .. "t1 - t2 and t1 + t2 interpolate the second at the points of the first; t - number subtracts it." },
  { "map{x}", type = "list of numbers", unit = "mm",
    text = "Points along the motion, increasing, with a constant step (to within 5 %)." },
  { "map{z}", type = "list of numbers", unit = "mm", text = "Points across the motion, increasing, with a "
    .. "constant step." },
  { "map{y}", type = "list or function (x, z)", text = "#x times #z values, or a function that computes them." },
  { "map{unit}", type = "string", default = '"mm"', text = 'Unit of y, for example "MPa".' },
  { "map{name}", type = "string", default = '"height"', text = "Name of y in printed output, pictures and files." },
  { "map.read", kind = "function", class = "map", use = 'map.read("scar.sdf", { level="plane" })',
    text = "A measured map from a file: text of points x y z (.xyz) or a matrix of heights, Surfer .grd (DSAA, DSBB, "
      .. "DSRB), ISO 25178-71 .sdf (text and binary), Gwyddion .gsf, Digital Surf .sur, Alicona .al3d, recognised by "
      .. "the first bytes. x of the file becomes x, its y becomes z, its height z becomes y; the upper edge of an "
      .. "image has the largest z. Not read: .x3p, compressed .sur, .gwy; save these as .sdf or .gsf. Order of the "
      .. "operations: crop, outliers, fill, level." },
  { "map.read{unit}", type = 'string or table { x="mm", y="um" }',
    text = "Unit of a file without units: mm, um, nm, cm, m or in; in a table x is the unit of both positions, y of "
      .. "heights. Units in the file have priority. Required for .grd, and for .xyz without units after names." },
  { "map.read{step}", type = "number > 0 or table { along x, along z }", unit = "mm",
    text = "Distance between the points of a text matrix. Its rows are along x; the first row has the smallest "
      .. "z." },
  { "map.read{crop}", type = "table { x={ from, to }, z={ from, to } }", unit = "mm",
    text = "Ranges of the points to keep, see t:crop." },
  { "map.read{outliers}", type = "number > 0",
    text = "Replaces points that differ from the median of their eight neighbours by more than this factor times "
      .. "the scatter (1.48 times the median deviation). A value of 20 removes spikes." },
  { "map.read{fill}", type = "true or number in mm",
    text = "Height of missing points: true for the mean of their neighbours, or a number. By default "
      .. "missing points are refused." },
  { "map.read{level}", values = { "plane", "sphere" }, text = "Subtracts the best plane or sphere, see t:level." },
  { "map.read{scar}", type = "table { x0, x1, z0, z1 }", unit = "mm",
    text = "With level: range of the scar, which is excluded from the fit." },
  { "map.x", kind = "field", type = "list", unit = "mm", text = "Points along the motion." },
  { "map.z", kind = "field", type = "list", unit = "mm", text = "Points across the motion." },
  { "map.y", kind = "field", type = "list", text = "Values, x-major: y[(i - 1)*#z + j] at x[i], z[j]." },
  { "map.size", kind = "field", type = "table { nx, nz }", text = "Number of points along x and z." },
  { "map.unit", kind = "field", type = "string", text = "Unit of y." },
  { "map.name", kind = "field", type = "string", text = "Name of y." },
  { "map.form", kind = "field", values = { "plane", "sphere" }, text = "Form subtracted by t:level; nil if none was." },
  { "map.radius", kind = "field", type = "number", unit = "mm", text = "Radius of the subtracted sphere." },
  { "map.missing", kind = "field", type = "number", text = "Number of missing points that were filled." },
  { "map.outliers", kind = "field", type = "number", text = "Number of outliers that were replaced." },
  { "map.path", kind = "field", type = "string", text = "File of the map." },
  { "map.at", kind = "method", use = "t:at(x, z)", text = "Value at a point, by bilinear interpolation between the "
    .. "four points around it." },
  { "map.profile", kind = "method", use = "t:profile{ z=0 }  t:profile{ x=0 }",
    text = "Section along x at one z, or along z at one x: { x=, y= }, where x is the position along the section. "
      .. "plot{ line } draws it, profile(line) converts it to a profile." },
  { "map.profile{x}", type = "number", unit = "mm", text = "Position x of a section across the motion." },
  { "map.profile{z}", type = "number", unit = "mm", text = "Position z of a section along the motion." },
  { "map.level", kind = "method", class = "map", use = 't:level()  t:level("sphere", { -0.3, 0.3, -0.2, 0.2 })',
    text = "Subtracts the best plane or sphere, by least squares of vertical distances; points in { x0, x1, z0, z1 "
      .. "}, such as a scar, are excluded. The field radius of the result is the radius of the sphere." },
  { "map.crop", kind = "method", class = "map", use = "t:crop{ x={ -0.5, 0.5 }, z={ 0 } }",
    text = "The part of the map within ranges of x and z." },
  { "map.crop{x}", type = "table { from, to }", unit = "mm", text = "Range along the motion; an end may be omitted." },
  { "map.crop{z}", type = "table { from, to }", unit = "mm", text = "Range across the motion." },
  { "map.center", kind = "method", class = "map", use = "t:center()",
    text = "The map shifted so that its centre is at x = z = 0, where bodies touch: body.map{ "
      .. "y=map.read(path):center() }." },
  { "map.resample", kind = "method", class = "map", use = "t:resample(0.01)",
    text = "A map with another step [mm] and the same centre. For a smaller step values are interpolated linearly; "
      .. "for a larger step they are means over cells." },
  { "map.volume", kind = "method", use = "t:volume()  t:volume(-1e-4)",
    text = "Returns { above=, below=, net=, area= }: the volumes above and below a level (default 0) and their "
      .. "difference, in mm3 (in N for a map of pressures), and the area above the level in mm2. Each point "
      .. "represents a cell of one step by one step." },
}

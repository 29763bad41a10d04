-- Help entries of maps: heights, depths and pressures over a rectangle. help/engine.lua explains the form
-- of an entry.

return {
  { "body{x}", type = "list of numbers", unit = "mm", text = "Positions of the points of a profile or map along x." },
  { "body{z}", type = "list of numbers", unit = "mm", text = "Positions of the points of a map along z." },
  { "body{y}", type = "function, list of numbers or map", unit = "mm", text = "Heights of a profile or map, positive "
    .. "out of the body: a function of x (of x and z for maps), a list of values, or a measured trace or map." },
  { "map", kind = "function", use = "map{ x=..., z=..., y=... }",
    text = "Values y on a grid of points (x, z) with constant steps: x along the motion, z across it, heights y "
      .. "upwards, in mm. y is a flat list: the value at x[i], z[j] is y[(i - 1)*#z + j]. Methods return new maps. "
      .. "t1 - t2 and t1 + t2 interpolate t2 at the points of t1; t - c subtracts the number c." },
  { "map{x}", type = "list of numbers", unit = "mm",
    text = "Points along the motion, increasing, with a constant step (to within 5 %)." },
  { "map{z}", type = "list of numbers", unit = "mm", text = "Points across the motion, increasing, with a "
    .. "constant step." },
  { "map{y}", type = "list or function (x, z)",
    text = "A list of #x * #z values, or a function that returns the value at (x, z)." },
  { "map{unit}", type = "string", default = '"mm"', text = 'Unit of y, for example "MPa".' },
  { "map{name}", type = "string", default = '"height"', text = "Name of y in printed output, pictures and files." },
  { "map.read", kind = "function", class = "map", use = 'map.read("scar.sdf", { level="plane" })',
    text = "Reads a measured map from a file: text of points x y z (.xyz) or a matrix of heights, Surfer .grd "
      .. "(DSAA, DSBB, DSRB), ISO 25178-71 .sdf (text and binary), Gwyddion .gsf, Digital Surf .sur, Alicona "
      .. ".al3d. The format is recognised by the first bytes of the file. The positions x and y of the file become "
      .. "x and z of the map, its heights z become y; the upper edge of an image has the largest z. Files .x3p, "
      .. "compressed .sur and .gwy are not read; save these as .sdf or .gsf. The map is first cropped, then "
      .. "outliers are replaced, missing points filled, and a form subtracted." },
  { "map.read{unit}", type = 'string or table { x="mm", y="um" }',
    text = "Unit of the lengths in a file without units: mm, um, nm, cm, m or in. In a table, x is the unit of "
      .. "both positions, y the unit of heights. Units in the file have priority. The field is required for .grd, "
      .. "and for .xyz without units after the names of columns." },
  { "map.read{step}", type = "number > 0 or table { along x, along z }", unit = "mm",
    text = "Distance between the points of a text matrix. Its rows are along x; the first row has the smallest "
      .. "z." },
  { "map.read{crop}", type = "table { x={ from, to }, z={ from, to } }", unit = "mm",
    text = "Ranges of x and z outside which points are removed, see t:crop." },
  { "map.read{outliers}", type = "number > 0",
    text = "Replaces points that differ from the median of their eight neighbours by more than this factor times "
      .. "the scatter of these differences (1.48 times their median deviation). The factor 20 removes spikes." },
  { "map.read{fill}", type = "true or number in mm",
    text = "Height set at points without a value: a number, or true for the mean of their neighbours. By "
      .. "default, a file with such points is refused." },
  { "map.read{level}", values = { "plane", "sphere" },
    text = "Form that is subtracted, the best plane or sphere, see t:level." },
  { "map.read{scar}", type = "table { x0, x1, z0, z1 }", unit = "mm",
    text = "Range of the scar, which is excluded from the fit of the field level." },
  { "map.x", kind = "field", type = "list", unit = "mm", text = "Points along the motion." },
  { "map.z", kind = "field", type = "list", unit = "mm", text = "Points across the motion." },
  { "map.y", kind = "field", type = "list",
    text = "Values in a flat list: the value at x[i], z[j] is y[(i - 1)*#z + j]." },
  { "map.size", kind = "field", type = "table { nx, nz }", text = "Number of points along x and z." },
  { "map.unit", kind = "field", type = "string", text = "Unit of the values y." },
  { "map.name", kind = "field", type = "string", text = 'Name of the values y, such as "height".' },
  { "map.form", kind = "field", values = { "plane", "sphere" },
    text = "Form that t:level subtracted; nil without such a form." },
  { "map.radius", kind = "field", type = "number", unit = "mm", text = "Radius of the sphere that was subtracted." },
  { "map.missing", kind = "field", type = "number", text = "Number of points without a value that were filled." },
  { "map.outliers", kind = "field", type = "number", text = "Number of outliers that were replaced." },
  { "map.path", kind = "field", type = "string", text = "File from which the map was read." },
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
    text = "The map shifted so that its centre is at x = z = 0, where the bodies touch: body.map{ "
      .. "y=map.read(path):center() }." },
  { "map.resample", kind = "method", class = "map", use = "t:resample(0.01)",
    text = "A map with another step [mm] and the same centre. For a smaller step, values are interpolated "
      .. "linearly; for a larger step, they are means over cells of the new size." },
  { "map.volume", kind = "method", use = "t:volume()  t:volume(-1e-4)",
    text = "Returns { above=, below=, net=, area= }: the volumes above and below a level (default 0) and their "
      .. "difference, in mm3 (in N for a map of pressures), and the area above the level in mm2. Each point "
      .. "represents a cell of one step by one step." },
}

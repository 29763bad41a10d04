-- Lua function export.vtk for joints: writes the worn surfaces as one .vtu file for the head and one for
-- the cup. Each cell, a quadrilateral, has a wear depth, a pressure and, in the cup, a cross-shear. The
-- head is drawn in its position under the largest load.

local check = require "archard.lib.check"
local files = require "archard.files"
local flat = require "archard.joint.flat"
local joint_file = require "archard.joint.file"
local strict = require "archard.strict"

local sphere = {}

local function direction(theta, phi)
  local s = math.sin(theta)
  return { math.cos(theta), s * math.sin(phi), s * math.cos(phi) }
end

-- Returns the product R n of a 3 x 3 matrix R, stored row by row, and a vector n.
local function turned(R, n)
  local list = {}
  for a = 1, 3 do list[a] = R[3 * a - 2] * n[1] + R[3 * a - 1] * n[2] + R[3 * a] * n[3] end
  return list
end

-- Returns a list of strings, each with the coordinates [mm] of one corner of the lattice. The lattice has
-- `rows` + 1 angles theta and 2 `rows` angles phi. The last argument is a function that rotates a direction
-- into the frame of the cup.
local function corners(rows, radius, place)
  local lines, d = {}, math.pi / rows
  for i = 0, rows do
    for k = 0, 2 * rows - 1 do
      local n = place(direction(i * d, k * d - math.pi))
      lines[#lines + 1] = ("%s %s %s"):format(files.number(radius * n[1]), files.number(radius * n[2]), files.number(radius * n[3]))
    end
  end
  return lines
end

-- Returns a list of the cells whose centre lies on the body, each as { site = index of the cell, corners =
-- string of corner indices }. covered(n): returns true if the body covers the direction n.
local function cells_of(rows, covered)
  local list, d = {}, math.pi / rows
  for i = 0, rows - 1 do
    for k = 0, 2 * rows - 1 do
      local site, next_k = 2 * rows * i + k + 1, (k + 1) % (2 * rows)
      if covered(direction((i + 0.5) * d, (k + 0.5) * d - math.pi)) then
        local first, second = 2 * rows * i, 2 * rows * (i + 1)
        list[#list + 1] = { site = site, corners = ("%d %d %d %d"):format(first + k, first + next_k, second + next_k, second + k) }
      end
    end
  end
  return list
end

local function add_array(lines, name, unit, values)
  lines[#lines + 1] = ('<DataArray type="Float64" Name="%s" format="ascii"><InformationKey name="UNITS_LABEL" location="vtkDataArray">%s</InformationKey>')
    :format(name, unit)
  lines[#lines + 1] = table.concat(values, " ")
  lines[#lines + 1] = "</DataArray>"
end

local function add_whole(lines, name, kind, values)
  lines[#lines + 1] = ('<DataArray type="%s" Name="%s" format="ascii">\n%s\n</DataArray>'):format(kind, name, table.concat(values, "\n"))
end

-- Returns the contents of a .vtu file. arrays: a list of { name, unit, values by cell index }; time: the
-- sliding distance [mm], stored as the time of the data.
local function text_of(points, cells, arrays, time)
  local lines = { '<?xml version="1.0"?>', '<VTKFile type="UnstructuredGrid" version="0.1">', "<UnstructuredGrid>",
    ('<FieldData><DataArray type="Float64" Name="TimeValue" NumberOfTuples="1" format="ascii">%s</DataArray></FieldData>'):format(
      files.number(time)),
    ('<Piece NumberOfPoints="%d" NumberOfCells="%d">'):format(#points, #cells),
    '<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">', table.concat(points, "\n"), "</DataArray></Points>",
    "<Cells>" }
  local connectivity, ends, types = {}, {}, {}
  for i, cell in ipairs(cells) do connectivity[i], ends[i], types[i] = cell.corners, 4 * i, 9 end
  add_whole(lines, "connectivity", "Int64", connectivity)
  add_whole(lines, "offsets", "Int64", ends)
  add_whole(lines, "types", "UInt8", types)
  lines[#lines + 1] = "</Cells>\n<CellData>"
  for _, array in ipairs(arrays) do
    local values = {}
    for i, cell in ipairs(cells) do values[i] = files.number(array[3][cell.site]) end
    add_array(lines, array[1], array[2], values)
  end
  lines[#lines + 1] = "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"
  return table.concat(lines, "\n")
end

local function everywhere() return true end

-- Interpolates a map of the cup at the cell centres of the head and returns the list of values. R: rotation
-- matrix of the head.
local function on_head(rows, values, R)
  local list, d = {}, math.pi / rows
  for i = 0, rows - 1 do
    for k = 0, 2 * rows - 1 do
      list[#list + 1] = flat.sampled(rows, values, turned(R, direction((i + 0.5) * d, (k + 0.5) * d - math.pi)))
    end
  end
  return list
end

local function head_text(run, rows, pressure, R)
  local function place(n) return turned(R, n) end
  return text_of(corners(rows, run.model.head.radius, place), cells_of(rows, everywhere),
    { { "wear_depth", "mm", run:map("head").values }, { "pressure", "MPa", on_head(rows, pressure, R) } }, run.distance)
end

local function cup_text(run, rows, pressure)
  local radius = run.model.head.radius + run.model.cup.clearance
  return text_of(corners(rows, radius, function(n) return n end), cells_of(rows, flat.cover(run.model.cup)),
    { { "wear_depth", "mm", run:map("cup").values }, { "pressure", "MPa", pressure },
      { "cross_shear", "", run:map("cross shear").values } }, run.distance)
end

-- Returns the contents of a .vtu file with the pressure of a joint's contact on the surface of the cup.
local function contact_text(c)
  local joint, rows = c.model, #c.pressure.theta
  return text_of(corners(rows, joint.head.radius + joint.cup.clearance, function(n) return n end), cells_of(rows, flat.cover(joint.cup)),
    { { "pressure", "MPa", c.pressure.values } }, 0)
end

-- Lua function export.vtk(object, path): writes the head and the cup of a joint's run as two files, or the
-- cup of a joint's contact as one file. Returns the paths. archard.files writes all other objects.
function sphere.vtk(object, path)
  local where = "export.vtk"
  local is_contact = strict.is(object, "joint_contact")
  if not is_contact and not joint_file.is_joint(object) then return files.vtk(object, path) end
  local stem = check.file.test(path) and (path:match "^(.*)%.vtu$" or not path:match "%.[^./]*$" and path)
  if not stem then check.refuse(where, "path", "a file name that ends in .vtu", path) end
  if is_contact then
    files.write(where, stem .. ".vtu", contact_text(object))
    return stem .. ".vtu"
  end
  local pressure, instant = object:map("pressure").values, object:heaviest()
  local rows = math.tointeger(math.sqrt(#pressure / 2))
  local R = table.move(object.loading.instants, 15 * instant - 14, 15 * instant - 6, 1, {})
  files.write(where, stem .. "-head.vtu", head_text(object, rows, pressure, R))
  files.write(where, stem .. "-cup.vtu", cup_text(object, rows, pressure))
  return stem .. "-head.vtu", stem .. "-cup.vtu"
end

return sphere

-- Class map: values y over points (x, z) with even steps, in mm. x is along the motion, z across it, and
-- heights point upwards. y is a flat list: the value at x[i], z[j] is y[(i - 1) * #z + j]. Each method
-- returns a new map.

local axis = require "archard.map.axis"
local check = require "archard.lib.check"
local merged = require "archard.lib.merged"
local strict = require "archard.strict"

local methods = {}
local class = { __name = "map", __methods = methods, __fields = { "x", "z", "y", "size", "unit", "name", "form", "radius",
  "missing", "outliers", "path" } }

local map = { class = class, methods = methods }

function map.is(value) return getmetatable(value) == class end

function map.self(where, value)
  if not map.is(value) then
    check.fail(where, "expected a map, called as t:" .. where:match("[^.:]+$") .. "(...), got " .. check.shown(value))
  end
  return value
end

-- --- making ---------------------------------------------------------------------------------------

local function checked_axis(where, name, list)
  if #list < 2 then check.fail(where, ("field '%s': expected at least 2 points, got %d"):format(name, #list)) end
  for i = 1, #list do
    if not check.number.test(list[i]) then
      check.refuse(where, ("%s[%d]"):format(name, i), "a finite number in mm", list[i])
    end
  end
  local at = axis.uneven(list)
  if at then
    check.fail(where, ("field '%s': expected increasing points with even steps of %.6g mm, got %.9g mm after %.9g mm"):format(
      name, math.abs(axis.step(list)), list[at], list[at - 1]))
  end
end

-- Makes a map from lists of coordinates x, z [mm] and values y. about: { unit=, name=, missing=, outliers=,
-- path= }. The lists are checked and used without a copy.
function map.new(where, x, z, y, about)
  checked_axis(where, "x", x)
  checked_axis(where, "z", z)
  if #y ~= #x * #z then
    check.fail(where, ("field 'y': expected %d x %d = %d values, y[(i - 1)*#z + j] at x[i], z[j], got %d"):format(#x, #z,
      #x * #z, #y))
  end
  for k = 1, #y do
    if not check.number.test(y[k]) then
      check.refuse(where, ("y[%d]"):format(k), ("a finite number (at x = %.6g, z = %.6g mm)"):format(x[(k - 1) // #z + 1],
        z[(k - 1) % #z + 1]), y[k])
    end
  end
  local result = merged({ unit = "mm", name = "height", missing = 0, outliers = 0 }, about)
  result.x, result.z, result.y, result.size = x, z, y, { #x, #z }
  return setmetatable(result, class)
end

-- Returns a map with new points and values. changes: other fields to change; the remaining fields are
-- copied from the map t.
function map.derived(t, x, z, y, changes)
  local result = merged(t, changes)
  result.x, result.z, result.y, result.size = x, z, y, { #x, #z }
  return setmetatable(result, class)
end

-- --- values ---------------------------------------------------------------------------------------

local function outside(where, t, name, value)
  local list = t[name]
  check.fail(where, ("field '%s': expected a number in [%.6g, %.6g] mm, got %s"):format(name, list[1], list[#list],
    check.shown(value)))
end

-- Returns the value of a map by bilinear interpolation between the points i, i + 1 along x and j, j + 1
-- along z. u, v: position between these points, as fractions (0 to 1) of the steps.
local function bilinear(t, i, u, j, v)
  local y, n = t.y, #t.z
  local k = (i - 1) * n + j
  return (1 - u) * ((1 - v) * y[k] + v * y[k + 1]) + u * ((1 - v) * y[k + n] + v * y[k + n + 1])
end

local function located(where, t, name, value)
  if not check.number.test(value) then outside(where, t, name, value) end
  local i, share = axis.locate(t[name], value)
  if not i then outside(where, t, name, value) end
  return i, share
end

-- t:at(x, z) returns the value at a position [mm] by bilinear interpolation.
function methods:at(x, z)
  local where = "map:at"
  map.self(where, self)
  local i, u = located(where, self, "x", x)
  return bilinear(self, i, u, located(where, self, "z", z))
end

local line_fields = { x = check.number, z = check.number }

-- t:profile{ z= } or t:profile{ x= } returns the section { x=, y= } of the map along this line.
function methods:profile(given)
  local where = "map:profile"
  map.self(where, self)
  given = check.definition(where, given, line_fields)
  if (given.x == nil) == (given.z == nil) then
    check.fail(where, ("fields 'x' and 'z': expected the position of the section in one of them, got %s"):format(
      given.x and "both" or "none"))
  end
  local along = given.z and self.x or self.z
  local k, share = located(where, self, given.z and "z" or "x", given.z or given.x)
  local line = { x = table.move(along, 1, #along, 1, {}), y = {} }
  for i = 1, #along do
    local a, b = math.min(i, #along - 1), i < #along and 0 or 1
    line.y[i] = given.z and bilinear(self, a, b, k, share) or bilinear(self, k, share, a, b)
  end
  return strict.table(line, where)
end

-- --- cropping and resampling ------------------------------------------------------------------------

-- Returns the part of a map between the indices i0 and i1 along x, and j0 and j1 along z.
local function part(t, i0, i1, j0, j1)
  local y, n = {}, #t.z
  for i = i0, i1 do table.move(t.y, (i - 1) * n + j0, (i - 1) * n + j1, #y + 1, y) end
  return map.derived(t, table.move(t.x, i0, i1, 1, {}), table.move(t.z, j0, j1, 1, {}), y)
end

local function range_of(where, t, name, range)
  local first, last = axis.within(t[name], range or {})
  if not first or last == first then
    check.fail(where, ("field '%s': expected a range with at least 2 of the points from %.6g to %.6g mm, %.4g mm apart, "
      .. "got { %s, %s }"):format(name, t[name][1], t[name][#t[name]], axis.step(t[name]), check.shown(range[1]),
      check.shown(range[2])))
  end
  return first, last
end

local crop_fields = { x = check.range, z = check.range }

-- t:crop{ x={ from, to }, z={ from, to } } returns the part of the map in these ranges [mm].
function methods:crop(given)
  local where = "map:crop"
  map.self(where, self)
  given = check.definition(where, given, crop_fields)
  local i0, i1 = range_of(where, self, "x", given.x)
  return part(self, i0, i1, range_of(where, self, "z", given.z))
end

local function centered(list)
  local middle, result = (list[1] + list[#list]) / 2, {}
  for i, value in ipairs(list) do result[i] = value - middle end
  return result
end

-- t:center() returns the same map with x = z = 0 at its middle.
function methods:center()
  map.self("map:center", self)
  return map.derived(self, centered(self.x), centered(self.z), self.y)
end

-- Returns the values of a resampled map: weighted sums along x, then along z.
local function weighted(t, wx, wz)
  local n, rows, y = #t.z, {}, {}
  for i = 1, #wx do
    for j = 1, n do
      local sum = 0
      for k = 1, #wx[i] do sum = sum + wx[i][k] * t.y[(wx[i].first + k - 2) * n + j] end
      rows[j] = sum
    end
    for j = 1, #wz do
      local sum = 0
      for k = 1, #wz[j] do sum = sum + wz[j][k] * rows[wz[j].first + k - 1] end
      y[#y + 1] = sum
    end
  end
  return y
end

local most = 4096 * 4096 -- largest number of points of a resampled map

-- t:resample(size) returns the map over the same area with the step `size` [mm].
function methods:resample(size)
  local where = "map:resample"
  map.self(where, self)
  local wide, deep = self.x[#self.x] - self.x[1], self.z[#self.z] - self.z[1]
  local least = math.max(math.sqrt(wide * deep / most), wide / most, deep / most)
  if not (check.positive.test(size) and size >= least and size <= math.min(wide, deep)) then
    check.refuse(where, "size", ("a step in mm in [%.3g, %.4g]"):format(least, math.min(wide, deep)), size)
  end
  local x, wx = axis.resampled(self.x, size)
  local z, wz = axis.resampled(self.z, size)
  return map.derived(self, x, z, weighted(self, wx, wz))
end

-- --- sums and differences ---------------------------------------------------------------------------

local function same_points(a, b)
  if #a ~= #b then return false end
  for i = 1, #a do if math.abs(a[i] - b[i]) > 1e-9 * axis.step(a) then return false end end
  return true
end

-- Returns the part of map `a` that overlaps map `b`, and the values of b at the points of this part.
local function shared(where, a, b)
  if same_points(a.x, b.x) and same_points(a.z, b.z) then return a, b.y end
  local i0, i1 = axis.within(a.x, { b.x[1], b.x[#b.x] })
  local j0, j1 = axis.within(a.z, { b.z[1], b.z[#b.z] })
  if not (i0 and j0 and i1 > i0 and j1 > j0) then
    check.fail(where, ("expected overlapping maps, got x %.6g to %.6g, z %.6g to %.6g mm and x %.6g to %.6g, z %.6g to %.6g mm")
      :format(a.x[1], a.x[#a.x], a.z[1], a.z[#a.z], b.x[1], b.x[#b.x], b.z[1], b.z[#b.z]))
  end
  a = part(a, i0, i1, j0, j1)
  local y = {}
  for _, x in ipairs(a.x) do
    local i, u = axis.locate(b.x, x)
    for _, z in ipairs(a.z) do y[#y + 1] = bilinear(b, i, u, axis.locate(b.z, z)) end
  end
  return a, y
end

local function combined(where, a, b, sign)
  if not (map.is(a) and (map.is(b) or check.number.test(b))) then
    check.fail(where, ("expected two maps, or a map and a number, got %s and %s"):format(check.shown(a), check.shown(b)))
  end
  if map.is(b) and a.unit ~= b.unit then
    check.fail(where, ("expected maps with the same unit, got %s and %s"):format(a.unit, b.unit))
  end
  local other, y = nil, {}
  if map.is(b) then a, other = shared(where, a, b) end
  for k = 1, #a.y do y[k] = a.y[k] + sign * (other and other[k] or b) end
  return map.derived(a, a.x, a.z, y)
end

function class.__sub(a, b) return combined("map - map", a, b, -1) end
function class.__add(a, b) return combined("map + map", a, b, 1) end

-- --- volume -----------------------------------------------------------------------------------------

-- t:volume([level]) returns the volumes above and below a level (default 0), their difference, and the area
-- above the level. The cell of each point has the size of one step along each axis.
function methods:volume(level)
  local where = "map:volume"
  map.self(where, self)
  if level ~= nil and not check.number.test(level) then
    check.refuse(where, "level", "a number in " .. self.unit, level)
  end
  local above, below, area = 0, 0, 0
  for _, y in ipairs(self.y) do
    local off = y - (level or 0)
    if off > 0 then above, area = above + off, area + 1 else below = below - off end
  end
  local cell = axis.step(self.x) * axis.step(self.z)
  return strict.table({ above = above * cell, below = below * cell, net = (above - below) * cell, area = area * cell }, where)
end

-- --- printing -----------------------------------------------------------------------------------------

-- Returns the smallest and the largest value of a map.
function map.limits(t)
  local low, high = math.huge, -math.huge
  for _, y in ipairs(t.y) do low, high = math.min(low, y), math.max(high, y) end
  return low, high
end

-- Returns the unit in which values are printed (um for lengths), and the factor from the map's unit to it.
function map.shown_unit(t)
  if t.unit == "mm" then return "um", 1000 end
  return t.unit, 1
end

local function said_axis(name, list)
  return ("%s %.6g to %.6g mm, step %.4g um"):format(name, list[1], list[#list], 1000 * axis.step(list))
end

function class.__tostring(t)
  local low, high = map.limits(t)
  local unit, scale = map.shown_unit(t)
  local lines = { ("map: %s at %d x %d points"):format(t.name, #t.x, #t.z),
    ("  %s; %s"):format(said_axis("x", t.x), said_axis("z", t.z)),
    ("  %.4g to %.4g %s"):format(scale * low, scale * high, unit) }
  if t.form then
    lines[#lines + 1] = ("  minus a %s%s"):format(t.form, t.radius and (" of radius %.6g mm"):format(t.radius) or "")
  end
  if t.missing > 0 then lines[#lines + 1] = ("  %d points without a value were filled"):format(t.missing) end
  if t.outliers > 0 then lines[#lines + 1] = ("  %d outliers were replaced"):format(t.outliers) end
  return table.concat(lines, "\n")
end

return map

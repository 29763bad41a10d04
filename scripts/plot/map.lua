-- plot.map draws a map from above, in colours with contours; plot.surface draws an oblique view of it.

local check = require "archard.lib.check"
local draw = require "archard.plot.draw"
local flat = require "archard.joint.flat"
local merged = require "archard.lib.merged"
local naming = require "archard.plot.naming"
local strict = require "archard.strict"

local pictures = {}

local most = 240 -- largest number of points drawn along the longer side

local function is_map(object)
  local class = type(object) == "table" and getmetatable(object)
  return type(class) == "table" and rawget(class, "__name") == "map"
end

local function check_map(where, object)
  if not is_map(object) then
    check.fail(where, ("expected a map as the first argument, got %s%s"):format(check.shown(object),
      where == "plot.surface" and type(object) == "userdata" and '; w:map("block") is the map of a body in 3-D' or ""))
  end
  return object
end

-- Returns the map, resampled to about `count` points along its longer side if it has more points there.
local function thinned(t, count)
  local longer = math.max(t.x[#t.x] - t.x[1], t.z[#t.z] - t.z[1])
  local finest = math.min((t.x[2] - t.x[1]), (t.z[2] - t.z[1]))
  if longer / finest < count then return t end
  return t:resample(math.min(longer / count, t.x[#t.x] - t.x[1], t.z[#t.z] - t.z[1]))
end

-- Returns the unit in which the values of a map are shown, and the factor to it. Lengths are shown in µm.
local function unit_of(t)
  if t.unit == "mm" then return "µm", 1000 end
  return t.unit, 1
end

local function has_values(t)
  for _, y in ipairs(t.y) do if y ~= 0 then return true end end
  return false
end

local function label_of(t)
  local unit = unit_of(t)
  local name = t.name == "depth" and "wear depth" or t.name:gsub("cross shear", "cross-shear")
  return (unit == "" or unit == "-") and name or ("%s / %s"):format(name, unit)
end

-- Returns the map as a list of coloured quadrilaterals with map points as corners, from the last row to the
-- first. position(i, j): returns x and y of a map point in the picture; covers(x, z, least): returns true if the
-- quadrilateral with this centre and this smallest value is drawn (default: all).
local function field_of(t, position, covers)
  local field, n, nz = { x = {}, y = {}, value = {} }, 0, #t.z
  local _, scale = unit_of(t)
  local function add(i, j)
    n = n + 1
    field.x[n], field.y[n] = position(i, j)
    field.value[n] = scale * t.y[(i - 1) * nz + j]
  end
  local function least_at(i, j)
    local at = (i - 1) * nz + j
    return math.min(t.y[at], t.y[at + 1], t.y[at + nz], t.y[at + nz + 1])
  end
  for j = nz - 1, 1, -1 do
    for i = 1, #t.x - 1 do
      if not covers or covers(0.5 * (t.x[i] + t.x[i + 1]), 0.5 * (t.z[j] + t.z[j + 1]), least_at(i, j)) then
        add(i, j)
        add(i + 1, j)
        add(i + 1, j + 1)
        add(i, j + 1)
      end
    end
  end
  return field
end

local map_options = { body = check.text, what = check.text }
local map_words = check.one_of{ "depth", "height", "pressure" }

local function is_joint_run(object) return strict.is(object, "joint_wear") end
local function is_of_joint(object) return is_joint_run(object) or strict.is(object, "joint_contact") end

-- Returns a function(x, z, least) that returns true if this position of a joint's map is drawn. It must lie on the
-- hemisphere around the load direction and, except on maps of the head, on the cup. Where nothing slides there is
-- no cross-shear; its map is blank there.
local function cover_of(joint, t)
  local covers = t.name == "head" and function() return true end or flat.cover(joint.cup)
  local blank = t.name == "cross shear" and has_values(t)
  return function(x, z, least)
    local n = flat.direction(joint.head.radius, x, z)
    return n ~= nil and covers(n) and not (blank and least == 0)
  end
end

-- Returns the map to draw: the argument itself, the map of a run and a body, or the pressure map of a contact
-- in three dimensions.
local function map_of(where, object, options)
  if is_of_joint(object) then
    return check.as(where, object.flat, object, options.what or options.body or is_joint_run(object) and "cup" or "pressure")
  end
  if options.what and not map_words.test(options.what) then check.refuse(where, "what", map_words.expected, options.what) end
  if type(object) ~= "userdata" then return check_map(where, object) end
  local of_run = naming.get(object, "map")
  if of_run then
    local body = naming.body(where, object, options.body or naming.bodies(object)[1])
    return check.as(where, of_run, object, body, options.what or "depth"), body
  end
  local pressure = naming.get(object, "pressure")
  local fine, t = pcall(pressure or error, object)
  return check_map(where, fine and is_map(t) and t or object)
end

-- Returns the options of plot{} that draw a map from above.
function pictures.panel(t, covers)
  local shown = thinned(t, most)
  local given = { field_of(shown, function(i, j) return shown.x[i], shown.z[j] end, covers) }
  given.xlabel, given.ylabel, given.vlabel, given.title = "x / mm", "z / mm", label_of(t), t.name
  given.xrange, given.yrange = { t.x[1], t.x[#t.x] }, { t.z[1], t.z[#t.z] }
  if not has_values(t) then given.vrange = { 0, 1 } end
  given.equal, given.levels = true, 8 -- no contour at zero, which levelled surfaces cross everywhere
  return given
end

-- Returns the options of plot{} that draw a stress component of a contact in three dimensions, in a plane
-- given by options.section: { x= }, { y= } or { z= } [mm]; default z = 0.
function pictures.stress(where, contact, options, label)
  local cut = merged(options.section or { z = 0 }, { body = options.body })
  local t = check.as(where, contact.stress, contact, cut)[options.component or "mises"]
  if not t then check.refuse(where, "component", '"mises", "sxx", "syy", "szz" or "sxy" with geometry = "3-D"', options.component) end
  local given = pictures.panel(t)
  local axis = cut.x and "x" or cut.y and "y" or "z"
  if axis == "x" then given.xlabel = "z / mm" end
  if axis ~= "y" then given.ylabel = "y / mm" end
  given.vlabel, given.levels = label, 9
  given.title = ("%s of the %s, %s = %.4g mm"):format(label:match "^(.-) /", options.body or naming.bodies(contact)[2], axis, cut[axis])
  return given
end

-- Returns the ranges of x and z that contain all nonzero values, with a margin of a quarter of the longer
-- side. At least one value must be nonzero.
local function ranges_of(t)
  local x, z, nz = { math.huge, -math.huge }, { math.huge, -math.huge }, #t.z
  local function widen(range, at) range[1], range[2] = math.min(range[1], at), math.max(range[2], at) end
  for i, y in ipairs(t.y) do
    if y ~= 0 then
      widen(x, t.x[(i - 1) // nz + 1])
      widen(z, t.z[(i - 1) % nz + 1])
    end
  end
  local margin = math.max(x[2] - x[1], z[2] - z[1]) / 4
  local function within(range, all) return { math.max(all[1], range[1] - margin), math.min(all[#all], range[2] + margin) } end
  return within(x, t.x), within(z, t.z)
end

-- Returns true if a point of a curve is within the ranges of a panel.
local function reaches(curve, panel)
  local x, y = panel.xrange, panel.yrange
  for i = 1, #curve.x do
    if not x or x[1] <= curve.x[i] and curve.x[i] <= x[2] and y[1] <= curve.y[i] and curve.y[i] <= y[2] then return true end
  end
  return false
end

-- plot.map(t, { levels=, vrange=, ... }) draws a map, plot.map(w, "height", { ... }) a map of a run.
function pictures.map(object, options, more)
  local where = "plot.map"
  if type(options) == "string" then
    if more ~= nil and type(more) ~= "table" then
      check.fail(where, "expected a table of options as the last argument, got " .. check.shown(more))
    end
    options = merged(more or {}, { what = options })
  elseif more ~= nil then
    check.fail(where, "expected a string before the table of options, got " .. check.shown(options))
  end
  options = draw.options(where, options, map_options)
  local t, body = map_of(where, object, options)
  local joint = is_of_joint(object) and object.model
  local given = pictures.panel(t, joint and cover_of(joint, t))
  if type(object) == "userdata" and options.what ~= "height" and has_values(t) then given.xrange, given.yrange = ranges_of(t) end
  if body then given.title = naming.title_of(("%s of the %s"):format(t.name, body), { object }, options) end
  if is_joint_run(object) and (t.name == "cup" or t.name == "head") then
    given.vlabel, given.title = "wear depth / " .. unit_of(t), "wear of the " .. t.name
  end
  if joint then
    given.xlabel, given.ylabel = "x (anterior) / mm", "z (flexion axis) / mm"
  end
  local rim = joint and t.name ~= "head" and flat.rim(joint)
  if rim and reaches(rim, given) then
    rim.title, rim.colour, rim.width = "rim", "black", 1
    given[2] = rim
  end
  draw.draw(where, draw.over(given, options))
end

-- --- oblique view -------------------------------------------------------------------------------------

local columns, rows, lean = 150, 50, 1 -- numbers of points along x and z; offset of each row to the right, in columns
local rise = 0.5                       -- vertical length in the picture that represents a unit length along z
local share = 0.2                      -- approximate range of the heights, as a fraction of the longer side

-- Returns the largest number <= value that is 1, 2 or 5 times a power of ten.
local function rounded(value)
  local power = 10 ^ math.floor(math.log(value, 10) + 1e-9)
  for _, digit in ipairs{ 5, 2 } do if digit * power <= value * (1 + 1e-9) then return digit * power end end
  return power
end

-- Returns the map resampled to `columns` by `rows` points, and its smallest and largest value.
local function seen(t)
  local x, z, y, low, high = {}, {}, {}, math.huge, -math.huge
  for i = 1, columns do x[i] = t.x[1] + (t.x[#t.x] - t.x[1]) * (i - 1) / (columns - 1) end
  for j = 1, rows do z[j] = t.z[1] + (t.z[#t.z] - t.z[1]) * (j - 1) / (rows - 1) end
  for i = 1, columns do
    for j = 1, rows do
      local value = t:at(x[i], z[j])
      y[#y + 1], low, high = value, math.min(low, value), math.max(high, value)
    end
  end
  return { x = x, z = z, y = y, unit = t.unit }, low, high
end

-- Returns every fifth row as a line, without the parts hidden by rows in front of it.
local function visible_rows(position)
  local curve, horizon = { x = {}, y = {}, colour = "black", width = 0.4, on = "pixels" }, {}
  for j = 1, rows do
    for i = 1, columns do
      local x, y = position(i, j)
      local column = i + lean * (j - 1)
      local hidden = y < (horizon[column] or -math.huge)
      if (j - 1) % 5 == 0 or j == rows then
        curve.x[#curve.x + 1], curve.y[#curve.y + 1] = hidden and 0 / 0 or x, hidden and 0 / 0 or y
      end
      horizon[column] = math.max(horizon[column] or -math.huge, y)
    end
    curve.x[#curve.x + 1], curve.y[#curve.y + 1] = 0 / 0, 0 / 0
  end
  return curve
end

-- Adds the vertical faces below the front and right edges to the field. The faces extend down to the lowest
-- value.
local function add_walls(field, t, position, foot, low)
  local _, scale = unit_of(t)
  local n = #field.x
  local function add(x, y, value)
    n = n + 1
    field.x[n], field.y[n], field.value[n] = x, y, scale * value
  end
  local function wall(i, j, i2, j2)
    local x, y = position(i, j)
    local x2, y2 = position(i2, j2)
    add(x, foot(j), low)
    add(x2, foot(j2), low)
    add(x2, y2, t.y[(i2 - 1) * rows + j2])
    add(x, y, t.y[(i - 1) * rows + j])
  end
  for j = rows - 1, 1, -1 do wall(columns, j, columns, j + 1) end
  for i = 1, columns - 1 do wall(i, 1, i + 1, 1) end
  return field
end

local surface_options = { exaggeration = check.positive }

-- plot.surface(t, { exaggeration=, ... }) draws an oblique view of a map.
function pictures.surface(t, options)
  local where = "plot.surface"
  check_map(where, t)
  options = draw.options(where, options, surface_options)
  local shown, low, high = seen(thinned(t, columns))
  local wide, deep = t.x[#t.x] - t.x[1], t.z[#t.z] - t.z[1]
  local factor = options.exaggeration or high > low and rounded(share * math.max(wide, deep) / (high - low)) or 1
  local step = wide / (columns - 1)
  local function foot(j) return rise * (shown.z[j] - shown.z[1]) end
  local function position(i, j)
    return shown.x[i] + lean * step * (j - 1), foot(j) + factor * (shown.y[(i - 1) * rows + j] - low)
  end
  local given = { add_walls(field_of(shown, position), shown, position, foot, low), visible_rows(position) }
  local top = rise * deep + factor * (high - low)
  given.xrange = { t.x[1] - 0.02 * wide, t.x[#t.x] + lean * step * (rows - 1) + 0.02 * wide }
  given.yrange = { -0.05 * top, 1.05 * top }
  given.xlabel, given.ylabel, given.vlabel = "x / mm (front edge)", "z / mm", label_of(t)
  given.yplaces = { at = { select(2, position(1, 1)), (select(2, position(1, rows))) },
    words = { ("%.3g"):format(t.z[1]), ("%.3g"):format(t.z[#t.z]) } }
  given.equal = true
  given.title = t.unit == "mm" and ("%s, exaggerated %g times"):format(t.name, factor) or t.name
  draw.draw(where, draw.over(given, options))
end

return pictures

-- Reads and checks the measurements of a fit, and computes the simulated values at the same points. A
-- measurement is a profile of a body after a sliding distance, a friction loop (fit/loop.lua), a depth map
-- of a joint (fit/sphere.lua), or a quantity of the history over the sliding distance. The positions of
-- profiles on their body are fitted too.

local check = require "archard.lib.check"
local columns = require "archard.settings".columns
local keys = require "archard.lib.keys"
local loops = require "archard.fit.loop"
local merged = require "archard.lib.merged"
local maps = require "archard.fit.sphere"
local observe = require "archard.study.observe"
local scar = require "archard.profile.scar"
local statistics = require "archard.lib.statistics"

local data = {}

-- --- quantities of the history --------------------------------------------------------------------

-- Quantities that are computed from columns of the history, as { columns, factor, unit, meaning }: the value
-- is the sum of the columns times the factor.
local made = {
  volume = { { "volume_cylinder", "volume_plate" }, 1, "mm3", "wear volume of both bodies" },
  width = { { "half_width" }, 2, "mm", "contact width" },
}
local quantities = {}
for _, column in ipairs(columns) do
  quantities[column.name] = { { column.name }, 1, column.unit or "", column.text }
end
for name, one in pairs(made) do quantities[name] = one end
data.quantities = quantities

-- Returns { columns, factor, unit, meaning } of a quantity. depth_NAME and volume_NAME are the depth and the
-- volume of the body called NAME.
local function quantity(name)
  return quantities[name] or { { name }, 1, name:match "^depth" and "mm" or "mm3", name:gsub("_", " of the ") }
end

local of_bodies = check.kind("depth_NAME or volume_NAME", function(v)
  return type(v) == "string" and v:match "^%l+_%w+$" ~= nil and (v:match "^depth_" or v:match "^volume_") ~= nil
end)

-- --- kinds of fields -----------------------------------------------------------------------------

local positives = check.list_of(check.positive, "a list of numbers > 0")
local list = check.list_of(check.number, "a list of finite numbers")
local sizes = check.kind("a number > 0, or a list of them", function(v)
  return check.positive.test(v) or positives.test(v)
end, check.positive)
local one_or_more = check.kind("a finite number, or a list of them", function(v)
  return check.number.test(v) or list.test(v)
end, check.number)
local body = check.one_of{ "cylinder", "plate", "head", "cup" }
local profile = check.kind("a profile of depths with lists x and h [mm] (for a profile p of heights, use p:depth())", function(v)
  return (type(v) == "table" or type(v) == "userdata") and v.x ~= nil and v.h ~= nil
end)

local fields = {
  section = check.section,
  loop = loops.kind, map = maps.kind, compliance = check.number, cycle = sizes,
  profile = profile, x = list, h = list, body = body, shift = check.number, tilt = check.number,
  level = check.number, of = check.one_of(keys(quantities), of_bodies), distance = sizes, value = one_or_more,
  error = sizes, relative = check.positive, title = check.text,
}
data.fields = fields
data.kinds = { sizes = sizes, body = body, list = list, section = check.section }

-- --- reading -------------------------------------------------------------------------------------

local function as_list(value, count)
  if type(value) ~= "number" then return table.move(value, 1, #value, 1, {}) end
  local repeated = {}
  for i = 1, count or 1 do repeated[i] = value end
  return repeated
end

local function same_count(where, prefix, name, values, count)
  if #values ~= count then
    check.fail(where, ("field '%s.%s': expected %d numbers, one for each value, got %d")
      :format(prefix, name, count, #values))
  end
  return values
end

-- Returns the list of standard errors of the values, in the unit of the values, or nil if none were given.
-- own: errors stored in the profile, or nil.
local function errors_of(where, prefix, given, own, value)
  local absolute = given.error or own
  if given.error and given.relative then
    check.fail(where, ("fields '%s.error' and '%s.relative': expected one of them, got both"):format(
      prefix, prefix))
  end
  if given.relative then
    local errors = {}
    for i, v in ipairs(value) do errors[i] = given.relative * math.abs(v) end
    if not positives.test(errors) then
      check.fail(where, ("field '%s.relative': a value of 0 has no relative error; use the field 'error' instead")
        :format(prefix))
    end
    return errors
  end
  return absolute and same_count(where, prefix, "error", as_list(absolute, #value), #value)
end

-- Fields that only profiles may have, fields that only loops may have, and the bodies of joints.
local of_profiles = { "profile", "x", "h", "body", "section", "shift", "tilt", "level" }
local of_loops = { "loop", "compliance" }
local of_joints = { head = true, cup = true }

local function refuse_others(where, prefix, given, names, what)
  for _, name in ipairs(names) do
    if given[name] ~= nil then
      check.fail(where, ("field '%s.%s': only allowed for %s"):format(prefix, name, what))
    end
  end
end

local function sorted(x, y, err)
  local order = {}
  for i = 1, #x do order[i] = i end
  table.sort(order, function(a, b) return x[a] < x[b] or x[a] == x[b] and a < b end)
  local function of(values)
    local result = {}
    for i, at in ipairs(order) do result[i] = values[at] end
    return values and result
  end
  return of(x), of(y), err and of(err)
end

local function need_distance(where, prefix, given, what)
  if check.positive.test(given.distance) then return end
  check.refuse(where, prefix .. ".distance", ("the sliding distance of the %s, a number > 0 in mm (or cycle, a number of cycles)"):format(what),
    given.distance)
end

-- Returns the start value of a profile's shift [mm]: the middle of the scar. named: the ends { from, to } of
-- the scar stored with the profile, or nil. Without stored ends, the scar is detected in the depths, and the
-- start value is 0 if no scar is detected or if x = 0 is in the scar or in the margins beside it.
local function start_of(x, h, named)
  if named then return (named.from + named.to) / 2 end
  local heights = {}
  for i = 1, #h do heights[i] = -h[i] end
  local _, from, to = scar.find(x, heights, "line")
  local side = from and scar.margin * (to - from)
  return from and (from - side > 0 or to + side < 0) and (from + to) / 2 or 0
end

-- Returns the three parameters of a profile's unknown position: shift, tilt and level. Each has a unit and a
-- typical magnitude; the shift also has a start value.
local function free_of(x, h, named)
  local deepest, width = 0, x[#x] - x[1]
  for _, value in ipairs(h) do deepest = math.max(deepest, math.abs(value)) end
  return { { kind = "shift", start = start_of(x, h, named), span = width / 10, unit = "mm" },
    { kind = "tilt", span = deepest / width, unit = "mm/mm" },
    { kind = "level", span = deepest, unit = "mm" } }
end

local function name_of(given)
  local line = given.section
  local at = line and (line.x and " across the motion at x = %g mm" or " along the motion at z = %g mm"):format(line.x or line.z) or ""
  return ("profile of the %s%s at %g mm"):format(given.body, at, given.distance)
end

-- Returns a short title of a section for the panel of a plot, or nil for other profiles.
local function brief_of(given)
  local line = given.section
  return line and ("%s, %s = %g, %g mm"):format(given.body, line.x and "x" or "z", line.x or line.z, given.distance)
end

local function read_profile(where, prefix, given)
  local from = given.profile or given
  if not (from.x and from.h) then
    check.fail(where, ("field '%s': expected profile=, or x= and h= [mm], or of=, distance= and "
      .. "value=, or loop=, got none of these"):format(prefix))
  end
  refuse_others(where, prefix, given, of_loops, "loops; this measurement is a profile")
  if given.body == nil or of_joints[given.body] then
    check.refuse(where, prefix .. ".body", '"cylinder" or "plate"; head and cup have maps: map = w:map "cup"', given.body)
  end
  need_distance(where, prefix, given, "profile")
  local x, h = as_list(from.x), as_list(from.h)
  same_count(where, prefix, "h", h, #x)
  local own = given.profile and from.error
  if own and not sizes.test(own) then own = nil end -- an error list with zeros (no noise) is ignored
  local err = errors_of(where, prefix, given, own, h)
  x, h, err = sorted(x, h, err)
  local item = { kind = "profile", body = given.body, surface = observe.surface(given.body, given.section),
    distance = given.distance, x = x, value = h, error = err, unit = "mm", free = free_of(x, h, given.profile and from.scar),
    fixed = { shift = given.shift, tilt = given.tilt, level = given.level },
    title = given.title or name_of(given), brief = given.title or brief_of(given),
    along = given.section and given.section.x and "z" or "x" }
  return item
end

local function read_map(where, prefix, given)
  refuse_others(where, prefix, given, { "profile", "x", "h", "section", "shift", "tilt", "level", "of", "value", "loop", "compliance" },
    "other measurements; this one is a map")
  if not of_joints[given.body] then check.refuse(where, prefix .. ".body", '"head" or "cup"', given.body) end
  need_distance(where, prefix, given, "map")
  return maps.item(given, errors_of(where, prefix, given, nil, given.map.values))
end

local function read_loop(where, prefix, given, by_force)
  refuse_others(where, prefix, given, { "profile", "x", "h", "body", "section", "tilt", "of", "value" },
    "other measurements; this one is a loop { x=, tangential= }")
  need_distance(where, prefix, given, "loop")
  local values = by_force and given.loop.x or given.loop.tangential
  return loops.item(given, errors_of(where, prefix, given, nil, values), by_force)
end

local function read_series(where, prefix, given)
  for _, name in ipairs{ "distance", "value" } do
    if given[name] == nil then check.refuse(where, prefix .. "." .. name, fields[name].expected, nil) end
  end
  local this = (", but this measurement has of=\"%s\""):format(given.of)
  refuse_others(where, prefix, given, of_profiles, "profiles" .. this)
  refuse_others(where, prefix, given, of_loops, "loops" .. this)
  local x, value = as_list(given.distance), as_list(given.value)
  same_count(where, prefix, "value", value, #x)
  local err = errors_of(where, prefix, given, nil, value)
  x, value, err = sorted(x, value, err)
  return { kind = "series", of = given.of, x = x, value = value, error = err,
    unit = quantity(given.of)[3], title = given.title or given.of }
end

-- Replaces the field `cycle` by the field `distance`. path(): returns the sliding distance of one cycle [mm].
local function with_distance(where, prefix, given, path)
  if given.cycle == nil then return given end
  if given.distance ~= nil then
    check.fail(where, ("fields '%s.cycle' and '%s.distance': expected one of them, got both"):format(prefix,
      prefix))
  end
  local cycles = type(given.cycle) == "number" and { given.cycle } or given.cycle
  local distance = {}
  for i = 1, #cycles do distance[i] = cycles[i] * path() end
  return merged(given, { distance = type(given.cycle) == "number" and distance[1] or distance })
end

-- Reads one measurement and returns it as an item of data. prefix: name of the measurement in messages.
-- motion.path(): returns the sliding distance of one cycle [mm]; motion.by_force: true if a tangential force
-- drives the runs.
function data.item(where, prefix, given, motion)
  if type(given) ~= "table" then check.refuse(where, prefix, "a table", given) end
  if check.shown(given.profile) == "a profile object" and given.profile.z then
    check.fail(where, ("field '%s.profile': expected depths, got heights: p:depth() subtracts a line, p:depth{ level = \"circle\" } a circle")
      :format(prefix))
  end
  given = check.fields(where, given, fields, prefix .. ".")
  given = with_distance(where, prefix, given, motion.path)
  if given.map then return read_map(where, prefix, given) end
  if given.loop then return read_loop(where, prefix, given, motion.by_force) end
  return (given.of and read_series or read_profile)(where, prefix, given)
end

-- Returns true if all measurements have standard errors, and false if none has any and all have the same
-- unit. All other cases are refused: without standard errors, data with different units cannot be weighted.
local function check_errors(where, items)
  local given, unit = 0, items[1].unit
  for _, item in ipairs(items) do
    if item.error then given = given + 1 end
    if item.unit ~= unit then unit = nil end
  end
  if given == #items or (given == 0 and unit) then return given > 0 end
  for i, item in ipairs(items) do
    if not item.error then
      check.fail(where, ("field 'data[%d]': expected error [%s] or relative: data with different units "
        .. "are weighted by their errors"):format(i, item.unit))
    end
  end
end

-- Reads all measurements. Returns the list of items, and true if the user gave the errors of the data.
function data.read(where, given, motion)
  if #given == 0 then
    local single = next(given) ~= nil and "a single one: write data = { { ... } }" or "none"
    check.fail(where, "field 'data': expected a list of measurements, got " .. single)
  end
  local items = {}
  for i, one in ipairs(given) do items[i] = data.item(where, ("data[%d]"):format(i), one, motion) end
  local told = check_errors(where, items)
  for _, item in ipairs(told and {} or items) do
    item.error = as_list(1e-3, #item.x) -- equal errors of any size: only their ratios affect the fit
  end
  return items, told
end

-- --- results that a run must record ----------------------------------------------------------------

-- Returns the distances, columns, surfaces and loops that a run must record (see study/observe.lua). Stores
-- in `item.reading` the index of the distance of each value.
function data.required(items)
  local distances, columns_used, surfaces, turns, at = {}, {}, {}, {}, {}
  for _, item in ipairs(items) do
    if item.surface then
      distances[item.distance], surfaces[item.surface] = true, true
    elseif item.kind == "loop" then
      distances[item.distance], turns[item.distance] = true, true
    else
      for _, distance in ipairs(item.x) do distances[distance] = true end
      for _, name in ipairs(quantity(item.of)[1]) do columns_used[name] = true end
    end
  end
  local what = { distances = keys(distances), columns = keys(columns_used), surfaces = keys(surfaces),
    loops = keys(turns) }
  for i, distance in ipairs(what.distances) do at[distance] = i end
  for _, item in ipairs(items) do
    item.reading = {}
    for i = 1, #item.x do item.reading[i] = at[item.distance or item.x[i]] end
  end
  return what
end

-- --- simulated values -----------------------------------------------------------------------------

-- Returns the depth of a surface at x by linear interpolation between the nodes; 0 outside the surface.
local function depth_at(surface, x)
  local at, h, low, high = surface.x, surface.h, 1, #surface.x
  if x < at[1] or x > at[high] then return 0 end
  while high - low > 1 do
    local middle = (low + high) // 2
    if at[middle] <= x then low = middle else high = middle end
  end
  return h[low] + (h[high] - h[low]) * (x - at[low]) / (at[high] - at[low])
end

-- Returns the simulated depths at the points of a measured profile. The simulated surface is shifted by
-- `shift` [mm] to the right, then `tilt` [mm/mm] times x and `level` [mm] are added.
local function profile_values(item, readings, position)
  local surface, values = readings[item.reading[1]][item.surface], {}
  for i, x in ipairs(item.x) do
    values[i] = depth_at(surface, x - position.shift) + position.tilt * x + position.level
  end
  return values
end

local function series_values(item, readings)
  local values, of = {}, quantity(item.of)
  for i = 1, #item.x do
    local sum = 0
    for _, name in ipairs(of[1]) do sum = sum + readings[item.reading[i]][name] end
    values[i] = of[2] * sum
  end
  return values
end

-- Returns true if an item is a width or a pressure. These quantities change in steps, because the edge of the
-- contact moves from node to node.
function data.jumps(item)
  for _, name in ipairs(item.of and quantity(item.of)[1] or {}) do
    if name:match("width") or name:match("^p_") then return true end
  end
  return false
end

-- Returns the simulated values of an item from the recorded results of a run. position: { shift=, tilt=,
-- level= } of a profile or a loop.
function data.values(item, readings, position)
  if item.kind == "loop" then return loops.values(item, readings[item.reading[1]].loop, position) end
  if item.kind == "sphere" then return maps.values(item, readings[item.reading[1]][item.surface]) end
  return (item.kind == "profile" and profile_values or series_values)(item, readings, position)
end

-- Returns the unknown positions of all items as a list of parameters, in the format of fit/unknown.lua.
function data.positions(items)
  local list = {}
  for number, item in ipairs(items) do
    for _, one in ipairs(item.free or {}) do
      if not item.fixed[one.kind] then
        list[#list + 1] = { item = number, kind = one.kind, start = one.start or 0, span = one.span > 0 and one.span or 1e-3,
          name = ("%s of the %s"):format(one.kind, item.title), unit = one.unit }
      end
    end
  end
  return list
end

-- --- implausible units -----------------------------------------------------------------------------

local function guess(ratio) -- returns the probable unit of measured lengths; ratio: measured / simulated
  if ratio < 1e-2 then return ratio < 1e-2 and ratio > 1e-4 and "m" or "other units" end
  return ratio < 1e4 and "um" or "nm"
end

-- Returns the part of an error message that states the largest distance of a series, which may be in a
-- wrong unit.
local function far_of(item)
  if item.kind ~= "series" then return "" end
  return (", distances in mm (up to %g)"):format(item.x[#item.x])
end

local function refuse_size(where, number, name, item, most, expected)
  local ratio = most / expected
  local seems = item.unit == "mm" and (" (are they in %s?)"):format(guess(ratio)) or ""
  check.fail(where, ("field 'data[%d].%s': the largest value is %.3g, the run with the start values gives %.3g "
    .. "%s: expected numbers in %s%s%s, or better start values"):format(number, name, most, expected,
    item.unit, item.unit, seems, far_of(item)))
end

-- Checks that at least 3 points of a profile lie on the fine part of the surface, and that the width of the
-- profile is plausible.
local function check_position(where, number, item, surface, shift)
  local low, high = surface.x[1] + shift, surface.x[#surface.x] + shift
  local inside = 0
  for _, x in ipairs(item.x) do
    if x > low and x < high then inside = inside + 1 end
  end
  local width = item.x[#item.x] - item.x[1]
  if inside < 3 or width < (high - low) / 300 or width > 50 * (high - low) then
    check.fail(where, ("field 'data[%d].x': values from %.3g to %.3g, %d of %d points on the fine part of "
      .. "the surface, from %.3g to %.3g mm: expected x in mm, measured from the contact's centre"):format(number,
      item.x[1], item.x[#item.x], inside, #item.x, low, high))
  end
end

-- Raises an error if the largest values of a measurement and of a run at the start values differ by a factor
-- above 150, since this suggests a wrong unit.
function data.check_sizes(where, items, readings)
  for number, item in ipairs(items) do
    local still = { shift = item.fixed and item.fixed.shift or item.free and item.free[1].start or 0, tilt = 0, level = 0 }
    if item.kind == "profile" then check_position(where, number, item, readings[item.reading[1]][item.surface], still.shift) end
    if item.kind == "loop" then loops.check_position(where, number, item, readings[item.reading[1]].loop) end
    local most = statistics.largest(item.value)
    local expected = statistics.largest(data.values(item, readings, still))
    if most > 0 and expected > 0 and (most > 150 * expected or most < expected / 150) then
      local name = { profile = "h", sphere = "map.values", loop = item.by_force and "loop.x" or "loop.tangential" }
      refuse_size(where, number, name[item.kind] or "value", item, most, expected)
    end
  end
end

return data

-- plot.shear and plot.slip: draw the shear tractions and the slip of a contact with friction.

local check = require "archard.lib.check"
local curves = require "archard.plot.curves"
local draw = require "archard.plot.draw"
local map = require "archard.plot.map"
local naming = require "archard.plot.naming"

local shear = {}

local function bounds_of(pressure, friction)
  local upper, lower, most = {}, {}, 0
  for i, p in ipairs(pressure.p) do
    upper[i], lower[i] = friction * p, -friction * p
    most = math.max(most, upper[i])
  end
  return upper, lower, most
end

-- Adds a filled rectangle from `bottom` to `top` for each stick zone, drawn only on `surface` ("pixels" or
-- "characters"). The first rectangle has the title. It is light, because curves cross it.
local function add_zones(given, contact, bottom, top, surface)
  for i, zone in ipairs(contact.stick) do
    given[#given + 1] = { x = { zone.left, zone.right, zone.right, zone.left, zone.left },
      y = { bottom, bottom, top, top, bottom }, style = "filled", series = 3, on = surface,
      colour = surface == "pixels" and "grey" or nil, title = i == 1 and "sticks" or nil }
  end
end

local function around(contact)
  local edges = contact.edges
  local margin = 0.25 * contact.half_width
  return { edges.left - margin, edges.right + margin }
end

local axes = check.one_of{ "x", "z" }

local function refuse_axis(where, options)
  if options.axis then check.fail(where, "field 'axis': not allowed in two dimensions, where all tractions are along x") end
end

-- Draws a map of the shear traction or slip of a contact in three dimensions, where the bodies touch. The map
-- shows the component along options.axis or, without an axis, the magnitude.
local function draw_map(where, contact, method, options)
  options = draw.options(where, options, { axis = axes })
  local pressure = contact:pressure()
  local given = map.panel(method(contact, options.axis),
    function(x, z) return pressure:at(x, z) > 0 end)
  options.axis = nil
  draw.draw(where, draw.over(given, options))
end

-- plot.shear(c, { body=, ... }) draws the shear tractions of a contact. For a contact in three dimensions,
-- plot.shear(c, { axis=, ... }) draws a map of the tractions.
function shear.shear(contact, options)
  local where = "plot.shear"
  if type(contact) ~= "userdata" or not curves.get(contact, "stick") then
    check.fail(where, "expected a contact, got " .. check.shown(contact))
  end
  if contact.friction == 0 then check.fail(where, "expected a contact with friction, got one with friction 0") end
  if type(contact.stick) == "number" then return draw_map(where, contact, contact.shear, options) end
  options = draw.options(where, options, { body = check.text, axis = axes })
  refuse_axis(where, options)
  local body = naming.body(where, contact, options.body or "upper")
  local q = contact:shear(body)
  local upper, lower, most = bounds_of(contact:pressure(body), contact.friction)
  local given = {}
  add_zones(given, contact, -1.05 * most, 1.05 * most, "pixels")
  -- characters cannot show overlapping areas, so the stick zone is drawn as a narrow bar at the bottom
  add_zones(given, contact, -1.05 * most, -0.95 * most, "characters")
  given[#given + 1] = { x = q.x, y = upper, series = 2, dash = 2, title = "±μp" }
  given[#given + 1] = { x = q.x, y = lower, series = 2, dash = 2 }
  given[#given + 1] = { x = q.x, y = q.q, series = 1, title = "q" }
  given.xlabel, given.ylabel, given.xrange = "x / mm", "shear traction / MPa", around(contact)
  if most > 0 then given.yrange = { -1.05 * most, 1.05 * most } end
  given.title = ("shear: μ = %g, %.4g N on a load of %.4g N"):format(contact.friction,
    contact.tangential, contact.load)
  draw.draw(where, draw.over(given, options))
end

-- Returns the points between the contact edges, with x [mm] and the slip as y [µm].
local function slip_within(contact)
  local slip, edges = contact:slip(), contact.edges
  local x, s = {}, {}
  for i, at in ipairs(slip.x) do
    if at > edges.left and at < edges.right then
      x[#x + 1], s[#s + 1] = at, 1000 * slip.s[i]
    end
  end
  return { x = x, y = s }
end

-- plot.slip(c1, c2, ..., { titles=, ... }) draws the slip of contacts. For a contact in three dimensions,
-- plot.slip(c, { axis=, ... }) draws a map of the slip.
function shear.slip(...)
  local where = "plot.slip"
  local first, second = ...
  if type(first) == "userdata" and type(curves.get(first, "stick")) == "number" then
    if type(second) == "userdata" then check.fail(where, "expected one contact in three dimensions, got several") end
    return draw_map(where, first, first.slip, second)
  end
  local objects, words, options = curves.split(where, "stick", { titles = check.table, axis = axes }, ...)
  refuse_axis(where, options)
  if words[1] then check.fail(where, "expected contacts, got the string " .. check.shown(words[1])) end
  local names = naming.names_of(where, objects, options.titles)
  local given = { xlabel = "x / mm", ylabel = "slip / µm", title = "slip" }
  for i, contact in ipairs(objects) do
    if type(contact) ~= "userdata" then check.fail(where, "expected contacts, got " .. check.shown(contact)) end
    given[i] = slip_within(contact)
    given[i].title = #objects > 1 and names[i] or nil
  end
  draw.draw(where, draw.over(given, options))
end

return shear

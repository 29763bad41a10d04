-- plot.mesh and plot.stress: draw the elements and the stresses of the two bodies.

local check = require "archard.lib.check"
local draw = require "archard.plot.draw"
local map = require "archard.plot.map"
local naming = require "archard.plot.naming"

local mesh = {}

-- --- coordinates along a hole ----------------------------------------------------------------------

-- Returns the radius [mm] of the hole in a pair of bodies, and the side on which the centre of the hole lies:
-- 1 above the first point of contact, -1 below. Returns nil for a pair without a hole.
local function hole_of(object)
  local model = naming.get(object, "model") or naming.get(naming.get(object, "contact"), "model") or object
  for role, side in pairs{ lower = 1, upper = -1 } do
    local body = naming.get(model, role)
    if body and body.kind == "ring" and body.fixed ~= "inner" then return body.inner, side end
  end
end

-- Returns two coordinates [mm] of each node, one along the wall of the hole and one normal to it, and the
-- radius [mm] of the hole.
local function unrolled(where, object, x, y)
  local radius, side = hole_of(object)
  if not radius then check.fail(where, "field 'unrolled': expected a pair with a hole, got one without") end
  local s, z = {}, {}
  for i = 1, #x do
    local to = radius - side * y[i]
    s[i], z[i] = radius * math.atan(x[i], to), side * (radius - math.sqrt(x[i] * x[i] + to * to))
  end
  return s, z, radius
end

local function axes_of(options)
  if options.unrolled then return "along the hole / mm", "across / mm" end
  return "x / mm", "y / mm"
end

-- Returns the elements, except elements that are cut when a round body is unrolled.
local function uncut(elements, s, radius)
  local kept, n = {}, 0
  for e = 1, #elements, 4 do
    local a, b, c = s[elements[e]], s[elements[e + 1]], s[elements[e + 2]]
    local d = s[elements[e + 3]] or c
    if math.max(a, b, c, d) - math.min(a, b, c, d) < radius then
      for k = 0, 3 do kept[n + k + 1] = elements[e + k] end
      n = n + 4
    end
  end
  return kept
end

-- --- elements -----------------------------------------------------------------------------------

-- Returns lists of x and y of all nodes [mm].
local function nodes_of(body)
  local x, y = {}, {}
  for i = 1, body.nodes do x[i], y[i] = body:node(i) end
  return x, y
end

-- Calls f(i, j, uses) for each edge between two nodes i and j. `uses` is the number of elements that share
-- the edge.
local function each_edge(elements, f)
  local uses, order, stride = {}, {}, 2 ^ 26
  for e = 1, #elements, 4 do
    local corners = elements[e + 3] == 0 and 3 or 4
    for k = 0, corners - 1 do
      local i, j = elements[e + k], elements[e + (k + 1) % corners]
      local edge = math.min(i, j) * stride + math.max(i, j)
      if not uses[edge] then order[#order + 1] = edge end
      uses[edge] = (uses[edge] or 0) + 1
    end
  end
  for _, edge in ipairs(order) do
    f(math.tointeger(edge // stride), math.tointeger(edge % stride), uses[edge])
  end
end

-- Returns the edges of the elements as one curve with gaps. If `boundary` is true, only edges on the boundary
-- are included; with a box { x0, x1, y0, y1 }, only edges that overlap the box.
local function edge_curve(x, y, elements, boundary, box)
  local curve, n = { x = {}, y = {} }, 0
  local cx, cy, nan = curve.x, curve.y, 0 / 0
  each_edge(elements, function(i, j, uses)
    if boundary and uses > 1 then return end
    if box and (math.max(x[i], x[j]) < box[1] or math.min(x[i], x[j]) > box[2]
      or math.max(y[i], y[j]) < box[3] or math.min(y[i], y[j]) > box[4]) then return end
    cx[n + 1], cy[n + 1] = x[i], y[i]
    cx[n + 2], cy[n + 2] = x[j], y[j]
    cx[n + 3], cy[n + 3] = nan, nan
    n = n + 3
  end)
  return n > 0 and curve or nil
end

-- Returns the element edges of a body as one curve with gaps. With a box { x0, x1, y0, y1 }, only edges that
-- overlap the box are included.
function mesh.edges(body, box)
  local x, y = nodes_of(body)
  return edge_curve(x, y, body:elements(), false, box)
end

-- --- arguments ----------------------------------------------------------------------------------

-- Returns the names of the bodies to draw, and the names of both bodies.
local function shown_bodies(where, object, options)
  local all = naming.bodies(object)
  return options.body and { naming.body(where, object, options.body) } or all, all
end

-- Returns a box larger than the view, because the picture may show more than the view if both axes have equal
-- scales.
local function around(box)
  if not box then return nil end
  local wide, high = box[2] - box[1], box[4] - box[3]
  local more = math.max(wide, high)
  return { box[1] - more, box[2] + more, box[3] - more, box[4] + more }
end

-- --- mesh ---------------------------------------------------------------------------------------

-- Returns a view that contains both wear boxes. It is 6 times as wide and 4 times as high as the deeper wear
-- box.
local function wear_box_view(where, model)
  local depth = 0
  for _, name in ipairs(naming.bodies(model)) do
    local body = model.mesh[name]
    local nodes = body:box()
    local per_column = body.rows + 1
    local middle = (#nodes // per_column // 2) * per_column
    local _, y0 = body:node(nodes[middle + 1])
    local _, y1 = body:node(nodes[middle + per_column])
    depth = math.max(depth, math.abs(y1 - y0))
  end
  if depth == 0 then check.fail(where, "this model has no wear box") end
  return { -3 * depth, 3 * depth, -2 * depth, 2 * depth }
end

local function view_of(where, model, zoom)
  if zoom == "wear box" then return wear_box_view(where, model) end
  return type(zoom) == "table" and zoom or nil
end

local mesh_options = { body = check.text, unrolled = check.flag, zoom = check.one_of({ "wear box", "all" },
  check.box) }

-- plot.mesh(model or wear, { zoom="wear box" or { x0, x1, y0, y1 }, body=, ... }) draws the elements.
function mesh.mesh(model, options)
  local where = "plot.mesh"
  local meshes = naming.part(model, "mesh")
  if not meshes then
    check.fail(where, "expected a model or a wear run as the first argument, got " .. check.shown(model))
  end
  if not meshes[naming.bodies(model)[1]] then check.fail(where, "expected a model with meshes, got one without") end
  options = draw.options(where, options, mesh_options)
  local box = view_of(where, model, options.zoom)
  local defaults = { equal = true, title = "mesh" }
  defaults.xlabel, defaults.ylabel = axes_of(options)
  local nodes, count = 0, 0
  local shown, all = shown_bodies(where, model, options)
  for series, name in ipairs(all) do
    local body = meshes[name]
    if shown[2] or shown[1] == name then
      local x, y = nodes_of(body)
      local elements = body:elements()
      if options.unrolled then
        local radius
        x, y, radius = unrolled(where, model, x, y)
        elements = uncut(elements, x, radius)
      end
      local curve = edge_curve(x, y, elements, false, around(box))
      nodes, count = nodes + #x, count + #elements // 4
      if curve then
        curve.title, curve.series, curve.dash, curve.width = name, series, 1, 0.5
        defaults[#defaults + 1] = curve
      end
    end
  end
  if not defaults[1] then check.fail(where, "no element lies in the range to be shown") end
  defaults.title = ("mesh: %d nodes, %d elements"):format(nodes, count)
  if box then defaults.xrange, defaults.yrange = { box[1], box[2] }, { box[3], box[4] } end
  draw.draw(where, draw.over(defaults, options))
end

-- --- stress -------------------------------------------------------------------------------------

mesh.components = { "mises", "principal", "shear", "sxx", "syy", "szz", "sxy" }
local labels = { mises = "von Mises stress / MPa", principal = "largest principal stress / MPa",
  shear = "largest shear stress / MPa", sxx = "σx / MPa", syy = "σy / MPa", szz = "σz / MPa", sxy = "τxy / MPa" }

local stress_options = { component = check.one_of(mesh.components), body = check.text, unrolled = check.flag,
  zoom = check.one_of({ "all" }, check.box), deformed = check.number,
  section = check.kind("a table { z= }, { x= } or { y= }", function(v) return type(v) == "table" end) }

-- Returns x and y of the nodes, displaced by `factor` times their displacements.
local function displaced(body, factor)
  if factor == 0 then return body.x, body.y end
  local x, y = {}, {}
  for i = 1, #body.x do
    x[i], y[i] = body.x[i] + factor * body.ux[i], body.y[i] + factor * body.uy[i]
  end
  return x, y
end

-- Returns the approach of the bodies [mm]. The upper body is drawn lower by the approach, so that worn bodies
-- touch in the picture. Returns 0 if the option `deformed` is given, if surfaces are unrolled, or if the load
-- is not along y.
local function lowered(contact, options)
  if options.deformed or options.unrolled or not contact or naming.get(contact, "load_angle") ~= 0 then return 0 end
  return naming.get(contact, "approach") or 0
end

local function moved(y, by)
  local result = {}
  for i = 1, #y do result[i] = y[i] + by end
  return result
end

-- Appends the elements that overlap the box to the field, as polygons with four corners.
local function add_polygons(field, x, y, values, elements, box)
  local fx, fy, fv, n = field.x, field.y, field.value, #field.x
  for e = 1, #elements, 4 do
    local a, b, c, d = elements[e], elements[e + 1], elements[e + 2], elements[e + 3]
    if d == 0 then d = c end
    local seen = not box or (math.max(x[a], x[b], x[c], x[d]) >= box[1]
      and math.min(x[a], x[b], x[c], x[d]) <= box[2]
      and math.max(y[a], y[b], y[c], y[d]) >= box[3]
      and math.min(y[a], y[b], y[c], y[d]) <= box[4])
    for _, i in ipairs(seen and { a, b, c, d } or {}) do
      n = n + 1
      fx[n], fy[n], fv[n] = x[i], y[i], values[i]
    end
  end
end

-- Returns the box to show: the user's box, or a box of three half widths around the contact. Returns nil,
-- to show both bodies completely, if zoom is "all", if there is no contact, or if both bodies are smaller
-- than this box.
local function stress_view(contact, zoom, bodies)
  if type(zoom) == "table" then return zoom end
  local ok, a = pcall(function() return contact.half_width end)
  if zoom == "all" or not ok or not a or a <= 0 then return nil end
  for _, body in ipairs(bodies) do
    for _, x in ipairs(body.x) do
      if math.abs(x) > 3 * a then return { -3 * a, 3 * a, -2.5 * a, 2.5 * a } end
    end
  end
end

-- Returns the stresses of an object and, if known, the contact to which they belong. The object is a contact,
-- a run (its worn state is used), or a table returned by stress().
local function field_of(where, object)
  local run, contact_of = pcall(function() return type(object) == "userdata" and object.contact end)
  if run and contact_of then object = contact_of(object) end
  if naming.part(object, "stress") then return object:stress(), object end
  local both = type(object) == "table"
  for _, name in ipairs(naming.bodies(object)) do
    both = both and type(object[name]) == "table" and object[name].elements ~= nil
  end
  if both then return object, object.contact end
  check.fail(where, "expected a contact, its stress() or a run as the first argument, got "
    .. check.shown(object))
end

-- Returns the contact of a run in three dimensions, or the object itself if it is a contact in three
-- dimensions. Returns nil for other objects.
local function in_space(object)
  local model = type(object) == "userdata" and naming.get(object, "model")
  if not model or naming.get(model, "geometry") ~= "3-D" then return nil end
  local contact = naming.get(object, "contact")
  return contact and contact(object) or object
end

-- Returns the largest value of a stress component of a body within the view.
local function largest_of(body, component, box)
  local most = 0
  for i, value in ipairs(body[component]) do
    local x, y = body.x[i], body.y[i]
    if not box or (x >= box[1] and x <= box[2] and y >= box[3] and y <= box[4]) then most = math.max(most, value) end
  end
  return most
end

local much = 3 -- if the stresses differ by a larger factor, one body would have almost one colour

-- Returns label and range of the colour scale. If the stresses of one body are much larger, the range covers
-- only the stresses of the other body, and the label states the larger maximum.
local function scale_of(bodies, names, component, box, label)
  if #bodies < 2 or not (component == "mises" or component == "shear") then return label end
  local first, second = largest_of(bodies[1], component, box), largest_of(bodies[2], component, box)
  local low, high = math.min(first, second), math.max(first, second)
  if low <= 0 or high <= much * low then return label end
  return ("%s (%s: up to %.3g)"):format(label, names[first > second and 1 or 2], high), { 0, low }
end

-- plot.stress(contact or contact:stress(), { component=, zoom=, body=, deformed=, levels=, ... }) draws a
-- stress component in both bodies, or in one body.
function mesh.stress(object, options)
  local where = "plot.stress"
  local spatial = in_space(object)
  if spatial then
    options = draw.options(where, options, stress_options)
    local given = map.stress(where, spatial, options, labels[options.component or "mises"])
    return draw.draw(where, draw.over(given, options))
  end
  local stress, contact = field_of(where, object)
  options = draw.options(where, options, stress_options)
  if options.section then check.refuse(where, "section", 'no section without geometry = "3-D"', options.section) end
  local shown, names = {}, (shown_bodies(where, stress, options))
  for i, name in ipairs(names) do shown[i] = stress[name] end
  local component, box = options.component or "mises", stress_view(contact, options.zoom, shown)
  local field, defaults = { x = {}, y = {}, value = {} }, {}
  local down = lowered(contact, options)
  for i, body in ipairs(shown) do
    local x, y = displaced(body, options.deformed or (down ~= 0 and 1 or 0))
    if i == 1 and #shown == 2 then y = moved(y, -down) end
    local elements, radius = body.elements, nil
    if options.unrolled then
      x, y, radius = unrolled(where, stress, x, y)
      elements = uncut(elements, x, radius)
    end
    add_polygons(field, x, y, body[component], elements, around(box))
    local outline = edge_curve(x, y, elements, true, around(box))
    if outline then
      outline.colour, outline.width = "black", 0.6
      defaults[#defaults + 1] = outline
    end
  end
  if not field.x[1] then check.fail(where, "no element lies in the range to be shown") end
  table.insert(defaults, 1, field)
  defaults.xlabel, defaults.ylabel = axes_of(options)
  defaults.vlabel, defaults.vrange = scale_of(shown, names, component, box, labels[component])
  defaults.equal, defaults.levels = true, 9
  defaults.title = naming.title_of("stress", { contact or stress }, options)
  if box then defaults.xrange, defaults.yrange = { box[1], box[2] }, { box[3], box[4] } end
  draw.draw(where, draw.over(defaults, options))
end

return mesh

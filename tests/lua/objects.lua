-- Tests material, hertz, model and mesh: values, fields, methods, text.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

-- Tests material{}.
local steel = material{ name = "steel" }
is(steel.E, 200e3, "default E")
is(steel.nu, 0.3, "default nu")
near(steel.E_star, 200e3 / (1 - 0.09), 1e-15, "E_star")
fails(function() return steel.colour end, "material: no field 'colour'", "reading of an unknown field")
fails(function() steel.E = 1 end, "field 'E' cannot be set", "assignment to a field of a material")
holds(tostring(material{ E = 1000, nu = 0.4 }), { "E 1000 MPa", "nu 0.4" }, "print(material)")

-- Tests hertz{}.
local h = hertz{}
near(h.half_width, 0.107641, 1e-5, "Hertz half width of the reference case")
near(h.p_max, 591.431, 1e-5, "Hertz pressure of the reference case")
near(h.E_star, 109890.1, 1e-6, "contact modulus")
is(h.load, 100, "hertz.load")
near(hertz{ load = 400 }.half_width, 2 * h.half_width, 1e-12,
  "the half width is proportional to the square root of the load")
near(hertz{ thickness = 4, load = 400 }.p_max, h.p_max, 1e-12,
  "the pressure depends on the load per thickness")
local soft = hertz{ cylinder = { E = 1000, nu = 0.4 }, plate = steel }
is(soft.cylinder.E, 1000, "a material given as a table")
is(soft.plate.nu, 0.3, "a material given as an object")
ok(soft.half_width > h.half_width, "a soft cylinder makes a wider contact")
holds(tostring(h), { "0.107641 mm", "591.431 MPa" }, "print(hertz)")

-- Tests model{}.
local m = model{ radius = 8, mesh = { size = 0.04, height = 0.05, zone = { plate = 1.6 } },
  cylinder = { E = 100e3, nu = 0.25 } }
is(m.radius, 8, "model.radius")
is(m.thickness, 1, "model.thickness")
is(m.cylinder.E, 100e3, "model.cylinder")
is(m.plate.E, 200e3, "model.plate")
is(m.mesh.size, 0.04, "model.mesh.size")
is(m.mesh.zone.plate, 1.6, "a given zone of the plate")
near(m.mesh.zone.cylinder, 9.29 * hertz{ radius = 8, cylinder = m.cylinder }.half_width, 1e-3,
  "default zone of the cylinder")
is(m.mesh.far, 0.8, "default size of distant elements")
is(m.mesh.element, "auto", "model.mesh.element")
ok(m.seconds > 0, "model.seconds")
ok(m.bytes > 1000, "model.bytes")
holds(tostring(m), { "radius 8 mm", "cylinder", "plate", "nodes" }, "print(model)")
is(model{ mesh = { element = "CPE4I", size = 0.04, height = 0.05 } }.mesh.element, "CPE4I",
  "element type CPE4I")

-- Tests meshes.
for body, mesh in pairs{ cylinder = m.mesh.cylinder, plate = m.mesh.plate } do
  is(mesh.body, body, body .. ": body")
  is(mesh.elements_count, mesh.quads + mesh.triangles, body .. ": number of quadrilaterals and triangles")
  local elements = mesh:elements()
  is(#elements, 4 * mesh.elements_count, body .. ": four node numbers for each element")
  local triangles, lowest, highest = 0, math.huge, 0
  for i, node in ipairs(elements) do
    if node == 0 then
      triangles = triangles + (i % 4 == 0 and 1 or math.huge)
    else
      lowest, highest = math.min(lowest, node), math.max(highest, node)
    end
  end
  is(triangles, mesh.triangles, body .. ": the fourth node number of a triangle is 0")
  is(lowest, 1, body .. ": the first node has number 1")
  is(highest, mesh.nodes, body .. ": the last node number is the number of nodes")
  local surface = mesh:surface()
  local x, y = mesh:node(surface[(#surface + 1) // 2])
  ok(x == 0 and math.abs(y) < 1e-12, body .. ": the middle of the surface is the origin")
  ok(mesh:node(surface[1]) < mesh:node(surface[2]), body .. ": surface nodes are ordered by x")
  is(#mesh:box(), #surface * (mesh.rows + 1), body .. ": wear box nodes are listed in columns")
  is(mesh:box()[1], surface[1], body .. ": each column of the wear box starts at the surface")
  local at = mesh:coordinates()
  is(#at.x, mesh.nodes, body .. ": coordinates of all nodes")
  ok(at.x[surface[1]] == mesh:node(surface[1]), body .. ": coordinates equal those of single nodes")
  local outline, area = mesh:outline(), 0
  for i, node in ipairs(outline) do
    local x1, y1 = mesh:node(node)
    local x2, y2 = mesh:node(outline[i % #outline + 1])
    area = area + (x1 * y2 - x2 * y1) / 2
  end
  near(area, body == "plate" and 2 * 8 * 8 or math.pi * 8 * 8 / 2, 1e-2, body .. ": area of the outline")
  ok(#mesh:fixed() > 2, body .. ": fixed nodes")
  local quality = mesh:quality()
  ok(quality.smallest_angle > 5 and quality.largest_angle < 175, body .. ": limits of the element angles")
  ok(quality.smallest_jacobian > 0, body .. ": Jacobians are positive")
  holds(tostring(mesh), { body, "nodes", "degrees" }, body .. ": print(mesh)")
end

-- Tests the worn mesh, which has the nodes as displaced by wear at the moment of the call.
do
  local w = wear{ k = 1e-7, jump = "auto", distance = 100 }
  w:run()
  local worn = w.mesh
  for _, body in ipairs{ "cylinder", "plate" } do
    local profile, unworn = w:profile(body), w.model.mesh[body]
    local mesh, worst, moved = worn[body], 0, 0
    for i, node in ipairs(mesh:surface()) do
      local x, y = mesh:node(node)
      worst = math.max(worst, math.abs(x - profile.worn_x[i]), math.abs(y - profile.y[i]))
    end
    ok(worst == 0, body .. ": surface nodes of the worn mesh are the nodes of the profile")
    for i = 1, mesh.nodes do
      local x, y = mesh:node(i)
      local x0, y0 = unworn:node(i)
      if x ~= x0 or y ~= y0 then moved = moved + 1 end
    end
    ok(moved > 0 and moved <= #mesh:box(), body .. ": only nodes of the wear box have moved")
    local now, before = mesh:quality().box, unworn:quality().box
    ok(now.smallest_jacobian > 0.5 * before.smallest_jacobian
      and now.smallest_jacobian < before.smallest_jacobian,
      body .. ": elements of the worn wear box are thinner")
    holds(tostring(mesh), { "worn mesh of the " .. body }, body .. ": print(worn mesh)")
  end
  local node = worn.plate:surface()[#worn.plate:surface() // 2]
  local _, y = worn.plate:node(node)
  w:run{ distance = 120 }
  ok(select(2, worn.plate:node(node)) == y, "a worn mesh does not change with the run")
  ok(select(2, w.mesh.plate:node(node)) < y, "a new worn mesh has the later wear")
  w:close()
  collectgarbage()
  ok(worn.plate:quality().aspect > 1, "a worn mesh exists longer than its run")
end
fails(function() m.mesh.plate:node(0) end, "expected a node number from 1 to", "a node with number 0")
fails(function() m.mesh.plate:node("a") end, "expected a node number", "a node given by a text")
fails(function() m.mesh.plate.node(1) end, "called with a colon", "a method called with a dot")

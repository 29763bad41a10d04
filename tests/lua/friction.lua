-- Tests contact with friction: pressing, moving, results, refused input.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

local m = model{ mesh = { size = 0.04, height = 0.05, far = 2, zone = { plate = 1 } } }

-- Tests that moving a contact without friction gives the same result as a new contact at that position.
local smooth = contact{ model = m }
is(smooth.friction, 0, "no friction by default")
is(#smooth.stick, 0, "no stick zone without friction")
local there, direct = smooth:move{ x = 0.1, load = 80 }, contact{ model = m, x = 0.1, load = 80 }
is(there.approach, direct.approach, "a contact moved without friction has the bits of a new contact")
for i, p in ipairs(direct:pressure("plate").p) do
  if there:pressure("plate").p[i] ~= p then ok(false, "its pressures have the same bits") end
end
for _, q in ipairs(smooth:shear().q) do if q ~= 0 then ok(false, "no shear without friction") end end
fails(function() smooth:slip() end, "expected a contact with friction", "no slip without friction")
fails(function() smooth:move{ tangential = 1 } end, { "field 'tangential'", "no friction" },
  "a tangential force without friction")

-- Tests a contact that is pressed but not moved: similar bodies stick everywhere and dissipate no energy.
local c = contact{ model = m, friction = 0.6, load = 100 }
near(c.p_center, smooth.p_center, 1e-3, "similar bodies are pressed as without friction")
near(c.tangential, 0, 1e-6, "pressing causes no tangential force")
is(#c.stick, 1, "a single stick zone")
near(c.stick[1].right, c.edges.right, 1e-12, "the stick zone extends to the edges")
is(c.energy, 0, "pressing dissipates no energy")
-- Tests different materials: the default number of increments is sufficient for the shear after pressing.
local fine = model{ plate = { E = 420e3 }, mesh = { size = 0.005, zone = { cylinder = 0.3, plate = 0.3 } } }
local function shear_left(increments)
  return contact{ model = fine, friction = 0.6, increments = increments }:shear().q
end
local function apart(q, r)
  local sum = 0
  for i = 1, #q do sum = sum + (q[i] - r[i])^2 end
  return math.sqrt(sum / #q) / (0.6 * 600)
end
local many = shear_left(400)
ok(apart(shear_left(), many) < 5e-3,
  ("default increments of pressing: error %.2g of mu p0"):format(apart(shear_left(), many)))
ok(apart(shear_left(20), many) > 8e-3,
  ("20 increments of pressing are too few: error %.2g of mu p0"):format(apart(shear_left(20), many)))
local loose = contact{ model = m, friction = 0.6, press = "frictionless" }
is(loose.p_center, smooth.p_center, "press = frictionless gives the bits of a contact without friction")
for _, q in ipairs(loose:shear().q) do if q ~= 0 then ok(false, "press = frictionless gives no shear") end end

-- Tests a contact in partial slip under a tangential force.
local d = c:move{ tangential = 45 }
near(d.tangential, 45, 1e-9, "the tangential force")
ok(d.x > 1e-3 and d.x < 3e-3, "displacement of the plate")
near(c.tangential, 0, 1e-6, "the original contact is not changed")
is(#d.stick, 1, "a single stick zone in partial slip")
ok(d.stick[1].right < d.edges.right - 0.01, "the surfaces slip at the edges")
ok(d.energy > 0, "energy is dissipated")
local q, p = d:shear(), d:pressure()
for i in ipairs(q.q) do
  if math.abs(q.q[i]) > 0.6 * p.p[i] * (1 + 1e-12) then ok(false, "the shear is at most mu p") end
end
local function sum_of(shear)
  local sum = 0
  for i = 2, #shear.x - 1 do sum = sum + shear.q[i] * (shear.x[i + 1] - shear.x[i - 1]) / 2 end
  return sum
end
near(sum_of(d:shear("cylinder")), 45, 1e-9, "the integral of the shear on the cylinder is the force")
near(sum_of(d:shear("plate")), 45, 1e-9, "the integral of the shear on the plate is the force")
local slip = d:slip()
is(#slip.x, #slip.s, "a slip for each node")
local same = c:move{ x = d.x }
near(same.tangential, 45, 2e-3, "the same displacement needs the same force")
near(same.energy, d.energy, 3e-2, "a displacement and a force dissipate the same energy")
local held = d:move{ load = 110 }
is(held.x, d.x, "a change of load alone does not move the plate")
is(held.load, 110, "the load after the change")
local slid = d:move{ x = 0.1, increments = 5 }
near(slid.tangential, 60, 1e-9, "the force in gross slip is the friction force")
is(#slid.stick, 0, "no stick zone in gross slip")
ok(slid:move{ x = 0.0999 }.tangential < 60, "the contact sticks after a reversal")
local stress = d:stress()
ok(#stress.plate.principal == m.mesh.plate.nodes, "a principal stress for each node")
holds(tostring(d), { "friction  0.6", "tangential force 45 N" }, "print(contact)")
is(d:move{}.tangential, d:move{}.tangential, "repeated calls give the same bits")
near(d:move{}.tangential, 45, 1e-9, "a call without fields changes nothing")

-- Tests that invalid arguments of contact:move are refused.
local err = fails(function() c:move{ tangential = 60 } end, { "field 'tangential'", "less than", "60 N" },
  "a tangential force equal to the friction limit")
is(err.code, "ARGUMENT", "error code of an invalid force")
is(err.where, "contact:move", "the error names the function")
fails(function() c:move{ x = 0, tangential = 1 } end, "fields 'x' and 'tangential'",
  "position and force together")
fails(function() c:move{ load = 0 } end, "field 'load': expected a number > 0", "a load of zero")
fails(function() c:move{ increments = 0 } end, "field 'increments'", "zero increments")
fails(function() c:move{ y = 1 } end, "unknown field 'y'", "another field")
fails(function() c:move{ x = 0 / 0 } end, "field 'x'", "NaN")
fails(function() c:move(1) end, "expected a table", "a number instead of a table")
fails(function() contact{ friction = -0.1 } end, "field 'friction': expected a number >= 0, got -0.1", "negative friction")
fails(function() contact{ press = "hard" } end, "field 'press'", "an unknown value of press")
fails(function() c:move{ x = 5 } end, "zone", "a position beyond the meshed zone")
for _, x in ipairs{ 15, -1e300 } do
  fails(function() c:move{ x = x } end,
    { "field 'x'", "less than 8 mm to either side", "of the plate", "got" },
    "a position beyond the plate")
end
fails(function() contact{ model = m, x = 15 } end, { "field 'x'", "got 15 mm" },
  "a new contact beyond the plate")
fails(function() d:slip("plate") end, { "expected no argument", "cylinder's nodes", '"plate"' },
  "slip of a single body")
is(c.load, 100, "refused calls leave the contact unchanged")

-- Tests that the same motions reproduce a contact with identical bits. Files do not store contacts.
do
  local again = contact{ model = m, friction = 0.6, load = 100 }:move{ tangential = 45 }
  is(again.x, d.x, "the same motions give the same position")
  for _, name in ipairs{ "shear", "pressure", "slip" } do
    local one, other = d[name](d), again[name](again)
    for field, values in pairs(one) do
      for i, value in ipairs(values) do if other[field][i] ~= value then ok(false, name ..
        " is identical to the bit") end end
    end
  end
end

-- Tests the columns of an exported contact with friction.
do
  local file = os.tmpname() .. ".csv"
  export.csv(d, file)
  local read = csv.read(file)
  local shear, slipped = d:shear "plate", d:slip()
  for i, value in ipairs(shear.q) do if read.q_plate[i] ~= value then ok(false, "shear in a file") end end
  for i, value in ipairs(slipped.s) do if read.s_cylinder[i] ~= value then ok(false, "slip in a file") end end
  ok(read.q_cylinder and #shear.q > 0 and #slipped.s > 0, "the file has columns of shear and slip")
  export.csv(smooth, file)
  ok(not io.open(file):read("l"):find("q_", 1, true), "no columns of shear without friction")
  os.remove(file)
end

-- Tests pictures.
local name = os.tmpname()
local function picture(draw)
  draw(name .. ".gp")
  local file = io.open(name .. ".gp")
  local text = file and file:read("a") or ""
  if file then file:close() end
  os.remove(name .. ".gp")
  return text
end
local text = picture(function(file) plot.shear(d, { file = file }) end)
holds(text, { "sticks", "±μp", "45 N on a load of 100 N" }, "plot.shear")
text = picture(function(file) plot.slip(d, slid, { file = file }) end)
holds(text, { "slip / µm", "45 N tangential", "60 N tangential" }, "plot.slip")
fails(function() plot.shear(m) end, "expected a contact", "a model has no shear")
fails(function() plot.shear(smooth) end, "expected a contact with friction", "no shear to draw without friction")
fails(function() plot.slip(d, "plate") end, "expected contacts", "plot.slip with a body's name")
fails(function() plot.slip({ stick = 1, slip = 5 }) end, "expected contacts, got a table", "plot.slip of a table")
os.remove(name)

-- Tests automatic meshes: they are finer with friction, but a zone set by the user has at most 320 elements.
local plain, rubbed = contact{ load = 100 }.model.mesh, contact{ load = 100, friction = 0.3 }.model.mesh
near(rubbed.size, plain.size / 5, 1e-12, "elements are a fifth as wide with friction")
is(rubbed.fineness, 1, "the fineness is 1 with friction")
near(contact{ load = 100, friction = 0.3, model = { mesh = { size = 0.03 } } }.model.mesh.size, 0.03, 1e-12,
  "an element size set by the user is not changed")
near(contact{ load = 100, friction = 0.3, model = { mesh = { zone = { cylinder = 2, plate = 2.4 } } } }.model.mesh.size, 2.4 / 320, 1e-12,
  "the widest zone has 320 elements")
is(rubbed.zone.plate, plain.zone.plate, "friction does not change the zones")
near(contact{ load = 100, friction = 0.5 }:move{ x = 0.3 }.tangential, 50, 1e-9,
  "a plate moved by three half widths of the contact")

-- Tests contact with friction: pressing, moving, results, refused input.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

local m = model{ mesh = { size = 0.04, height = 0.05, far = 2, zone = { plate = 1 } } }

-- Tests that moving a contact without friction gives the same result as a new contact at that position.
local smooth = contact{ model = m }
is(smooth.friction, 0, "no friction by default")
is(#smooth.stick, 0, "nothing sticks")
local there, direct = smooth:move{ x = 0.1, load = 80 }, contact{ model = m, x = 0.1, load = 80 }
is(there.approach, direct.approach, "a motion without friction is the contact there, to the same bits")
for i, p in ipairs(direct:pressure("plate").p) do
  if there:pressure("plate").p[i] ~= p then ok(false, "its pressures too") end
end
for _, q in ipairs(smooth:shear().q) do if q ~= 0 then ok(false, "no shear without friction") end end
fails(function() smooth:slip() end, "expected a contact with friction", "no slip without friction")
fails(function() smooth:move{ tangential = 1 } end, { "field 'tangential'", "no friction" }, "a force without friction")

-- Tests a contact that is pressed but not moved: similar bodies stick everywhere and dissipate no energy.
local c = contact{ model = m, friction = 0.6, load = 100 }
near(c.p_center, smooth.p_center, 1e-3, "similar bodies press as without friction")
near(c.tangential, 0, 1e-6, "no force along x")
is(#c.stick, 1, "all of it sticks")
near(c.stick[1].right, c.edges.right, 1e-12, "to the edges")
is(c.energy, 0, "nothing is dissipated")
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
ok(apart(shear_left(), many) < 5e-3, ("pressed in steps enough: %.2g of mu p0 off"):format(apart(shear_left(), many)))
ok(apart(shear_left(20), many) > 8e-3, ("where 20 are too few: %.2g"):format(apart(shear_left(20), many)))
local loose = contact{ model = m, friction = 0.6, press = "frictionless" }
is(loose.p_center, smooth.p_center, "press = frictionless: the same bits")
for _, q in ipairs(loose:shear().q) do if q ~= 0 then ok(false, "and no shear") end end

-- Tests a contact in partial slip under a tangential force.
local d = c:move{ tangential = 45 }
near(d.tangential, 45, 1e-9, "the force")
ok(d.x > 1e-3 and d.x < 3e-3, "displacement of the plate")
near(c.tangential, 0, 1e-6, "the contact it starts from stays")
is(#d.stick, 1, "partial slip")
ok(d.stick[1].right < d.edges.right - 0.01, "slip at the edges")
ok(d.energy > 0, "energy is dissipated")
local q, p = d:shear(), d:pressure()
for i in ipairs(q.q) do
  if math.abs(q.q[i]) > 0.6 * p.p[i] * (1 + 1e-12) then ok(false, "friction carries no more than mu p") end
end
local function sum_of(shear)
  local sum = 0
  for i = 2, #shear.x - 1 do sum = sum + shear.q[i] * (shear.x[i + 1] - shear.x[i - 1]) / 2 end
  return sum
end
near(sum_of(d:shear("cylinder")), 45, 1e-9, "shear on the cylinder adds up to the force")
near(sum_of(d:shear("plate")), 45, 1e-9, "on the plate too")
local slip = d:slip()
is(#slip.x, #slip.s, "slip at every node")
local same = c:move{ x = d.x }
near(same.tangential, 45, 2e-3, "moved as far, the force is the same")
near(same.energy, d.energy, 3e-2, "energy of the motion equals that of the force")
local held = d:move{ load = 110 }
is(held.x, d.x, "load alone: the base is held")
is(held.load, 110, "under the new load")
local slid = d:move{ x = 0.1, increments = 5 }
near(slid.tangential, 60, 1e-9, "gross slip")
is(#slid.stick, 0, "nothing sticks")
ok(slid:move{ x = 0.0999 }.tangential < 60, "back, it sticks again")
local stress = d:stress()
ok(#stress.plate.principal == m.mesh.plate.nodes, "principal stress at every node")
holds(tostring(d), { "friction  0.6", "tangential force 45 N" }, "print(contact)")
is(d:move{}.tangential, d:move{}.tangential, "the same motion gives the same bits")
near(d:move{}.tangential, 45, 1e-9, "an empty motion changes nothing")

-- Tests that invalid arguments of contact:move are refused.
local err = fails(function() c:move{ tangential = 60 } end, { "field 'tangential'", "less than", "60 N" }, "more than mu L")
is(err.code, "ARGUMENT", "its code")
is(err.where, "contact:move", "the function in the error")
fails(function() c:move{ x = 0, tangential = 1 } end, "fields 'x' and 'tangential'", "both at once")
fails(function() c:move{ load = 0 } end, "field 'load': expected a number > 0", "no load")
fails(function() c:move{ increments = 0 } end, "field 'increments'", "no increments")
fails(function() c:move{ y = 1 } end, "unknown field 'y'", "another field")
fails(function() c:move{ x = 0 / 0 } end, "field 'x'", "NaN")
fails(function() c:move(1) end, "expected a table", "a number for a table")
fails(function() contact{ friction = -0.1 } end, "field 'friction': expected a number >= 0, got -0.1", "negative friction")
fails(function() contact{ press = "hard" } end, "field 'press'", "an unknown value of press")
fails(function() c:move{ x = 5 } end, "zone", "too far")
for _, x in ipairs{ 15, -1e300 } do
  fails(function() c:move{ x = x } end, { "field 'x'", "less than 8 mm to either side", "of the plate", "got" }, "off the plate")
end
fails(function() contact{ model = m, x = 15 } end, { "field 'x'", "got 15 mm" }, "pressed off the plate")
fails(function() d:slip("plate") end, { "expected no argument", "cylinder's nodes", '"plate"' }, "slip of a body")
is(c.load, 100, "refused calls leave the contact unchanged")

-- Tests that the same motions reproduce a contact with identical bits. Files do not store contacts.
do
  local again = contact{ model = m, friction = 0.6, load = 100 }:move{ tangential = 45 }
  is(again.x, d.x, "the same motions give the same position")
  for _, name in ipairs{ "shear", "pressure", "slip" } do
    local one, other = d[name](d), again[name](again)
    for field, values in pairs(one) do
      for i, value in ipairs(values) do if other[field][i] ~= value then ok(false, name .. " too") end end
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
  ok(read.q_cylinder and #shear.q > 0 and #slipped.s > 0, "shear and slip beside the pressures")
  export.csv(smooth, file)
  ok(not io.open(file):read("l"):find("q_", 1, true), "not without friction")
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
fails(function() plot.slip(d, "plate") end, "expected contacts", "a word")
os.remove(name)

-- Tests automatic meshes: they are finer with friction, but a zone set by the user has at most 320 elements.
local plain, rubbed = contact{ load = 100 }.model.mesh, contact{ load = 100, friction = 0.3 }.model.mesh
near(rubbed.size, plain.size / 5, 1e-12, "a fifth as wide with friction")
is(rubbed.fineness, 1, "and still of fineness 1")
near(contact{ load = 100, friction = 0.3, model = { mesh = { size = 0.03 } } }.model.mesh.size, 0.03, 1e-12, "a given size stays")
near(contact{ load = 100, friction = 0.3, model = { mesh = { zone = { cylinder = 2, plate = 2.4 } } } }.model.mesh.size, 2.4 / 320, 1e-12,
  "the widest zone has 320 elements")
is(rubbed.zone.plate, plain.zone.plate, "zones as wide as without friction")
near(contact{ load = 100, friction = 0.5 }:move{ x = 0.3 }.tangential, 50, 1e-9, "a plate moves by three half widths of the contact")

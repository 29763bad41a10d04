-- Tests contact with friction in three dimensions: pressing, moving, results, refused input.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

local function ball_on(lower, mesh)
  return model{ geometry = "3-D", upper = body.ball{ radius = 10 }, lower = lower or body.block{}, mesh = mesh }
end
local m = ball_on(nil, { size = 0.0044 })

-- Tests a contact that is pressed but not moved: it sticks everywhere and dissipates no energy.
local c = contact{ model = m, load = 10, friction = 0.5 }
is(c.stick, 1, "the whole contact sticks")
is(c.energy, 0, "pressing dissipates no energy")
near(c.p_center, contact{ model = m, load = 10 }.p_center, 1e-3,
  "similar bodies are pressed as without friction")
near(contact{ model = ball_on(), load = 10, friction = 0.5 }:shear().x[2] - contact{ model = ball_on(), load = 10, friction = 0.5 }:shear().x[1],
  0.0880442 / 40, 1e-4, "the default grid has 40 cells in the half width")

-- Tests a moved contact against Mindlin's closed form.
local d = c:move{ tangential = 3, increments = 2 }
near(d.tangential, 3, 1e-4, "the given tangential force")
near(d.x, 2.1504e-4, 1e-3, "the displacement under the given force")
near(d.stick, 0.4 ^ (2 / 3), 0.03, "the fraction of the area that sticks")
ok(d.tangential_z == 0 or math.abs(d.tangential_z) < 1e-6, "no force across the motion")
is(c.tangential, 0, "the original contact is not changed")
local e = d:move{ tangential = -3, increments = 2 }
near(2 * (e.energy - d.energy), 1.2829e-4, 5e-3, "energy of a loop by Mindlin")
near(e:move{ x = d.x, increments = 2 }.tangential, 3, 2e-3, "the same displacement needs the same force")
is(d:move{}.x, d.x, "a call without fields changes nothing")
holds(tostring(d), { "friction  0.5", "tangential force 3 N along x, 0 N along z", "of the area sticks" }, "print(contact)")

-- Tests loops and stick zones on the automatic grid against Mindlin's closed form for nu = 0.
do
  local steel = material{ E = 200e3, nu = 0 }
  local pair = { geometry = "3-D", upper = body.ball{ radius = 10, material = steel }, lower = body.block{ material = steel } }
  local start, radius = contact{ model = pair, load = 10, friction = 0.5 }, (3 * 10 * 10 / (4 * 100e3)) ^ (1 / 3)
  for _, share in ipairs{ 0.2, 0.3, 0.6, 0.95 } do
    local there = start:move{ tangential = 5 * share }
    local back = there:move{ tangential = -5 * share }
    local loop = 9 * 25 / (5 * radius) * 2 / 100e3 * (1 - (1 - share) ^ (5 / 3) - 5 * share / 6 * (1 + (1 - share) ^ (2 / 3)))
    near(2 * (back.energy - there.energy), loop, 6e-3, share .. " of full slip: energy of a loop")
    near(there.x, 3 * 5 / (4 * 100e3 * radius) * (1 - (1 - share) ^ (2 / 3)), 1e-3, share .. " of full slip: motion")
    local edge = (there.stick * there.area / math.pi) ^ 0.5
    ok(math.abs(edge - radius * (1 - share) ^ (1 / 3)) < radius / 80, share .. " of full slip: stick zone within half a cell")
  end
end

-- Tests that a motion too large for the slip to be resolved is refused.
for _, axis in ipairs{ "x", "z" } do
  fails(function() c:move{ [axis] = 1e7 } end, "field '" .. axis .. "': expected at most 1e+06 mm, got 1e+07", "a motion of 10 km along " .. axis)
end
fails(function() c:move{ load = 1e6 } end, "cells in the half width, expected at most 512",
  "a load whose contact needs too many cells")

-- Tests the warning that the solution may not be unique. A nearly rigid ball on a body with nu = 0.2 has a
-- Dundurs' parameter beta of 0.375.
do
  local warnings = require "archard.warnings"
  local uneven = model{ geometry = "3-D", upper = body.ball{ radius = 10, material = { E = 1e7, nu = 0.2 } },
    lower = body.block{ material = { E = 3000, nu = 0.2 } }, mesh = { size = 0.04 } }
  for friction, warned in pairs{ [0.6] = false, [1.2] = true } do
    warnings.keep()
    contact{ model = uneven, load = 10, friction = friction, increments = 1 }
    ok((warnings.take() or ""):find("Dundurs' beta 0.3", 1, true) ~= nil == warned,
      "warning about uniqueness at friction " .. friction)
  end
end

-- Tests motions along z, changes of direction and gross slip.
local z = c:move{ tangential_z = 3, increments = 2 }
near(z.z, d.x, 1e-9, "the displacement along z equals the displacement along x")
near(z.energy, d.energy, 1e-9, "the energy of a motion along z equals that along x")
local less, less_z = d:move{ tangential = 2, load = 7 }, z:move{ tangential_z = 2, load = 7 }
near(less_z.z, less.x, 1e-9, "displacements along z and x are equal under a changed load")
near(less_z.energy, less.energy, 1e-9, "energies along z and x are equal under a changed load")
local corner = d:move{ tangential = 3, tangential_z = 2, increments = 2 }
near(corner.tangential_z, 2, 1e-4, "the force along z of a combined force")
ok(corner.energy > d.energy and corner.z > 1e-4, "a changed direction of the force displaces and dissipates")
local slid = c:move{ x = 2e-3 }
near(slid.tangential, 5, 1e-4, "the force in gross slip is friction times load")
is(slid.stick, 0, "no stick zone in gross slip")
ok(slid:move{ x = 1.9e-3 }.stick > 0.3, "the contact sticks after a reversal")

-- Tests a force close to full slip: slip across the force, which Mindlin neglects, increases the displacement by 13 %.
-- The reference is extrapolated from prescribed motions in steps of 5 and 2.5 nm.
near(contact{ model = ball_on(), load = 10, friction = 0.5 }:move{ tangential = 5 * (1 - 1e-4) }.x,
  5.292e-4, 0.01,
  "displacement at 0.9999 of the sliding force")

-- Tests the pressure on the lower body: when the lower body has moved by 0.2 mm along x, the ball presses at
-- x = -0.2 mm of this body.
near(c:move{ x = 0.2 }:pressure "lower":at(-0.2, 0), c.p_center, 0.01, "the pressure on the lower body after a motion")

-- Tests changes of the normal load under a tangential force.
local more = d:move{ load = 15, increments = 2 }
near(more.approach, contact{ model = m, load = 15, friction = 0.5 }.approach, 1e-5,
  "a load that needs a larger window")
near(more.tangential_z, 0, 1e-6, "a change of load causes no force across")
near(d:move{ tangential = 3, load = 8 }.tangential, 3, 1e-4, "a smaller load under the same force")

-- Tests the exchange of bodies. Partial slip does not move the shape of a lower ball; gross slip moves the
-- shape by the motion minus the elastic displacement.
local below = contact{ load = 10, friction = 0.5,
  model = model{ geometry = "3-D", upper = body.block{}, lower = body.ball{ radius = 10 }, mesh = { size = 0.0044 } } }
local other = below:move{ tangential = 3, increments = 2 }:move{ tangential = 2, load = 7 }
is(other.x, less.x, "displacement with the ball as the lower body")
is(other.energy, less.energy, "energy with the ball as the lower body")
local far = below:move{ x = 0.05 }
near(far.tangential, 5, 1e-4, "gross slip of the lower ball")
local section, at = far:pressure{ z = 0 }, 1
for i = 1, #section.x do at = section.p[i] > section.p[at] and i or at end
ok(math.abs(section.x[at] - 0.05) < 0.0045, "the contact moves with the lower ball")
near(far.energy, c:move{ x = 0.05 }.energy, 1e-3, "energy in gross slip of the lower ball")

-- Tests six successive motions in one direction: the window is enlarged by the total motion only.
local legs = below
for i = 1, 6 do legs = legs:move{ x = 0.02 * i } end
near(legs.energy, below:move{ x = 0.12 }.energy, 2e-3, "six motions dissipate as much as one")
ok(#legs:pressure().x < 150 and #legs:pressure().z < 80,
  "size of the window after six motions: " .. #legs:pressure().x .. " x " .. #legs:pressure().z .. " cells")
fails(function() below:move{ z = 0.05 } end, "field 'z': the lower body is not flat",
  "gross slip of a lower ball along z")
near(below:move{ z = 2e-4 }.energy, c:move{ z = 2e-4 }.energy, 1e-9, "partial slip of a lower ball along z")

-- Tests that a motion is refused if the end of a flat or wavy map would reach the contact.
local along = {}
for i = 1, 201 do along[i] = -0.4 + 0.004 * (i - 1) end
for _, height in ipairs{ 0, 2e-4 } do
  local rough = map{ x = along, z = along, y = function(u) return height * math.cos(20 * math.pi * u) end }
  local pressed = contact{ load = 10, friction = 0.5, model = ball_on(body.map{ y = rough }, { size = 0.006 }) }
  ok(pressed:move{ x = 0.1 }.energy > 0.49, "waves of " .. height .. " mm: a motion within the map")
  for _, x in ipairs{ 0.25, 0.5, 1.5 } do
    if height > 0 or x > 0.25 then -- allowed on a flat map, whose contact is narrower
      fails(function() pressed:move{ x = x } end, "reaches the end of the part of a map", "a motion of " .. x .. " mm")
    end
  end
end

-- Tests slender ellipses with nu = 0 along both axes. The displacement is friction times the difference of
-- two approaches: under the whole load, and under the load that the stick zone carries.
for _, radius in ipairs{ 300, 1000, 5000 } do
  local function pressed(load, friction, across)
    local slender = body.ball{ radius = across and radius or 10, radius_z = across and 10 or radius, nu = 0 }
    return contact{ load = load, friction = friction, model = { geometry = "3-D", upper = slender, lower = body.block{ nu = 0 } } }
  end
  local moved = pressed(100, 0.5):move{ tangential = 30, increments = 2 }
  near(moved.x, 0.5 * (pressed(100).approach - pressed(40).approach), 3e-4,
    "radii 10 and " .. radius .. ": displacement")
  near(pressed(100, 0.5, true):move{ tangential_z = 30, increments = 2 }.z, moved.x, 1e-9,
    "displacement with exchanged radii")
end

-- Tests maps and sections of pressure, shear and slip.
local q, s = d:shear{ z = 0 }, d:slip()
local p = d:pressure{ z = 0 }
for i = 1, #q.x do if math.abs(q.q[i]) > 0.5 * p.p[i] * (1 + 1e-12) then ok(false,
  "the shear is at most friction times the pressure") end end
near(d:shear():at(0, 0), d:shear("x"):at(0, 0), 1e-6, "the default component of the shear is along x")
ok(math.abs(d:shear("z"):at(0, 0)) < 1e-3, "no shear across the motion at the centre")
ok(s:at(0, 0) < 1e-9 and s:at(0.085, 0) > 1e-5, "the centre sticks and the edge slips")
is(s.unit, "mm", "the unit of slip is mm")

-- Tests that bodies of different materials slip while they are pressed together.
local soft = contact{ model = ball_on(body.block{ material = { E = 3600, nu = 0.4 } }, { size = 0.0125 }), load = 10, friction = 0.1, increments = 8 }
ok(soft.stick > 0.3 and soft.stick < 0.6, "the edge slips while bodies of different materials are pressed")
is(contact{ model = soft.model, load = 10, friction = 0.1, press = "frictionless" }.energy, 0,
  "frictionless pressing dissipates no energy")

-- Tests plots.
local function picture(draw)
  local name = os.tmpname()
  draw(name .. ".gp")
  local file = io.open(name .. ".gp")
  local text = file and file:read("a") or ""
  if file then file:close() end
  os.remove(name .. ".gp")
  os.remove(name)
  return text
end
holds(picture(function(file) plot.shear(d, { file = file }) end), "shear / MPa", "plot.shear")
holds(picture(function(file) plot.slip(d, { axis = "x", file = file }) end), "slip along x / µm", "plot.slip")
holds(picture(function(file) plot.slip(d, { file = file }) end), "\nNaN NaN",
  "plot.slip draws nothing outside the contact")
do
  local w = wear{ model = { geometry = "3-D", upper = body.ball{ radius = 10 }, lower = body.block{} }, load = 10, stroke = 0.02, k = 1e-6, cycles = 1e4 }
  w:run{ cycles = 100, progress = false }
  local function right_of(options)
    return tonumber((picture(function(file)
      options.file = file
      plot.map(w, options)
    end):match "set xrange %[%S+:(%S+)%]"))
  end
  ok(right_of{} < 0.9 * w:map("block").x[#w:map("block").x], "a map is drawn around the scar, with a margin")
  near(right_of{ xrange = { -0.01, 0.02 } }, 0.02, 1e-6, "plot.map with a given x range")
end

-- Tests that invalid motions are refused.
local err = fails(function() c:move{ tangential = 5 } end, { "field 'tangential'", "less than", "5 N" },
  "a tangential force equal to the friction limit")
is(err.where, "contact:move", "the error names the function")
fails(function() c:move{ tangential = 4, tangential_z = 4 } end, "less than",
  "a resultant force above the friction limit")
fails(function() c:move{ z = 0, tangential_z = 1 } end, "fields 'z' and 'tangential_z'",
  "position and force along z together")
fails(function() c:shear("y") end, '"x", "z"', "shear along an unknown axis")
fails(function() contact{ model = m, load = 10 }:shear() end, "expected a contact with friction", "no shear without friction")
fails(function() contact{ model = m, load = 10 }:move{ z = 1e-4 } end, "field 'z'",
  "a motion along z without friction")
fails(function() contact{ friction = 0.5 }:move{ tangential_z = 1 } end, "field 'tangential_z'",
  "tangential_z of a plane contact")
fails(function()
  contact{ model = ball_on(body.block{ height = 1 }), load = 10, friction = 0.1 }
end, { "field 'friction'", "rigid base" }, "friction on a rigid base")
fails(function() c:stress{ y = 0.05 } end, "expected a contact without friction", "stresses below the surface with friction")

-- Tests that motions are proportional to small forces.
for _, force in ipairs{ 1e-12, 1e-9, 1e-6 } do
  near(c:move{ tangential = force }.x / force, c:move{ tangential = 1e-3 }.x / 1e-3, 1e-9, ("motion under a force of %g N"):format(force))
end

-- Tests a motion along z with a force along x after which all cells slip: the method for such forces did not converge.
do
  local warnings = require "archard.warnings"
  warnings.keep()
  local pair = { geometry = "3-D", upper = body.ball{ radius = 10 }, lower = body.block{ E = 260559.89, nu = 0.355231 },
    mesh = { size = 0.00743888 } }
  local c = contact{ model = pair, load = 8, friction = 0.49114034338108 }
    :move{ z = 1.9131288367154838e-4, tangential = -1.3831544131808344, load = 6.7345258403345856 }
    :move{ z = -3.2060725534892244e-5, x = -6.8311054960034799e-4, load = 9.4304076870461486 }
    :move{ x = -3.051794973335335e-4, tangential_z = -0.51592036964627708, load = 4.5669775822884224 }
    :move{ z = -4.9688497500384042e-4, tangential = -1.4330315702936263, load = 7.2315310253647391 }
  warnings.take()
  near(c.tangential, -1.4330315702936263, 1e-5, "force along x with a motion along z")
  near(c.x, -5.0249e-4, 1e-3, "  its motion")
end

-- Tests friction against closed forms of half-planes: partial slip (Cattaneo and Mindlin), cycles of force
-- and of load and force together (Jaeger), stick under a normal load alone (Goodman), and sliding. Also tests
-- the effect of the bodies' outer boundaries.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local slices = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/slices.lua")
local within, about, below, note, ok = figures.within, figures.about, figures.below, figures.note, figures.ok

local mu, load = 0.6, 100
local exact = hertz{}
local a, p0 = exact.half_width, exact.p_max

local function mesh_of(size) return { size = size, height = 1.25 * size } end
local models = {}
for _, size in ipairs{ 0.02, 0.01, 0.005 } do models[size] = model{ mesh = mesh_of(size) } end

-- --- Cattaneo and Mindlin -----------------------------------------------------------------------

local function circle(x, half_width) return math.sqrt(math.max(0, half_width ^ 2 - x * x)) / a * p0 end

local function exact_shear(x, c) return mu * (circle(x, a) - circle(x, c)) end

-- Returns the root mean square error of the shear over the contact's width, relative to mu p0.
local function shear_error(contact, c)
  local shear, sum = contact:shear(), 0
  for i = 2, #shear.x - 1 do
    local off = shear.q[i] - exact_shear(shear.x[i], c)
    sum = sum + off * off * (shear.x[i + 1] - shear.x[i - 1]) / 2
  end
  return math.sqrt(sum / (2 * a)) / (mu * p0)
end

local function cycle_energy(f)
  return 4 * mu ^ 2 * load ^ 2 / (math.pi * exact.E_star) * ((1 - f) * math.log(1 - f) + f - f * f / 2)
end

local allowed = {
  [0.02] = { shear = 0.06, energy = { 0.1, 0.01, 0.01 } },
  [0.01] = { shear = 0.03, energy = { 0.01, 0.01, 0.01 } },
  [0.005] = { shear = 0.015, energy = { 0.005, 0.005, 0.005 } },
}
local slipping = {}
for _, size in ipairs{ 0.02, 0.01, 0.005 } do
  local pressed = contact{ model = models[size], friction = mu, load = load }
  for i, force in ipairs{ 12, 30, 48 } do
    local label = ("%g um, %g N: "):format(1000 * size, force)
    local c = a * math.sqrt(1 - force / (mu * load))
    local there = pressed:move{ tangential = force }
    local back = there:move{ tangential = -force }
    local again = back:move{ tangential = force }
    figures.ok(#there.stick == 1, label .. "a single stick zone")
    about((there.stick[1].right - there.stick[1].left) / 2, c, size / 2, label ..
      "half width of the stick zone [mm], to half an element")
    below(shear_error(there, c), allowed[size].shear, label .. "shear, root mean square / (mu p0)")
    within(again.energy - there.energy, cycle_energy(force / (mu * load)), allowed[size].energy[i],
      label .. "energy of a cycle [N mm]")
    about(again.tangential, force, 1e-9, label .. "the tangential force is the given force [N]")
    if size == 0.005 and force == 30 then slipping = { pressed = pressed, there = there, back = back } end
  end
end

-- Tests the slip in a half cycle at the nodes in contact against Cattaneo and Mindlin's closed form, 2 mu g.
do
  local c, worst = a * math.sqrt(0.5), 0
  local there, back = slipping.there:slip(), slipping.back:slip()
  for i, x in ipairs(there.x) do
    local t = math.abs(x) / c
    if math.abs(x) < a then
      local g = t > 1 and c * c / 20 * (t * math.sqrt(t * t - 1) - math.log(t + math.sqrt(t * t - 1))) or 0
      worst = math.max(worst, math.abs(back.s[i] - there.s[i] + 2 * mu * g))
    end
  end
  below(worst / (2 * 9.2606e-5), 0.005, "5 um, 30 N: slip of a half cycle, largest error / slip at the edge")
end

-- --- error of the dissipated energy -------------------------------------------------------------

local function energy_off(model, force, each, at, x)
  local f = force / (mu * load)
  at = at or exact
  local there = contact{ model = model, friction = mu, load = each, x = x, press = "frictionless" }
    :move{ tangential = f * mu * each, increments = 1 }
  local back = there:move{ tangential = -f * mu * each, increments = 1 }
  local wanted = 2 * mu ^ 2 * each ^ 2 / (math.pi * at.E_star) * ((1 - f) * math.log(1 - f) + f - f * f / 2)
  return (back.energy - there.energy) / wanted - 1
end

-- Returns the mean, root mean square and largest error of the energy over contacts whose edges move across
-- two elements.
local function energy_errors(model, force, size)
  local sum, squares, most, count = 0, 0, 0, 12
  for i = 1, count do
    local off = energy_off(model, force, load * (1 + (2 * (i - 0.5) / count - 1) * size / a) ^ 2)
    sum, squares, most = sum + off, squares + off * off, math.max(most, math.abs(off))
  end
  return sum / count, math.sqrt(squares / count), most
end

local function n_of(force, size) return a * (1 - math.sqrt(1 - force / (mu * load))) / size end

-- Tests that the error of the energy does not depend on how the bodies were pressed together, on the number
-- of increments or on the cycle. The area of the loop uses displacements without the slip between the nodes,
-- so it scatters more than the energy.
do
  local c = contact{ model = models[0.01], friction = mu }:move{ tangential = 30 }
  local cycle = c:move{ tangential = -30 }:move{ tangential = 30 }
  local later = cycle:move{ tangential = -30, increments = 100 }
  local first, half, start, area = cycle.energy - c.energy, later.energy - cycle.energy, later.x, 0
  for i = -99, 100 do
    local x, force = later.x, later.tangential
    later = later:move{ tangential = 0.3 * i, increments = 1 }
    area = area + (later.x - x) * (later.tangential + force) / 2
  end
  within(first, (1 + energy_off(models[0.01], 30, load)) * cycle_energy(0.5), 1e-3,
    "energy of a cycle, against frictionless pressing and a single increment [N mm]")
  within(2 * half, first, 1e-3, "energy of the second cycle, in 100 increments [N mm]")
  within(2 * area, first, 0.85 / n_of(30, 0.01) ^ 2, "energy against the area of the loop")
  ok(later.x > start, "sense of rotation of the loop")
end

-- Tests the error of the energy over contacts whose edges move across two elements, for two element heights.
-- On elements of 20 um under 12 N the slip annulus is narrower than one element on both sides, and no node
-- slips in half of the contacts.
local rms = { [0.02] = { [12] = 0.08, [30] = 0.0075, [48] = 0.006 }, [0.01] = { [12] = 0.01, [30] = 0.002, [48] = 0.002 },
  [0.005] = { [12] = 0.001, [30] = 0.0005, [48] = 0.001 } }
local scatters = {}
for _, size in ipairs{ 0.02, 0.01, 0.005 } do
  for _, height in ipairs{ 1.25, 0.5 } do
    local bodies = height == 0.5 and model{ mesh = { size = size, height = size / 2 } } or models[size]
    for _, force in ipairs{ 12, 30, 48 } do
      local mean, scatter, most = energy_errors(bodies, force, size)
      local label = ("%g x %g um, %g N, n = %.1f: energy of a cycle, "):format(1e3 * size, 1e3 * size * height, force,
        n_of(force, size))
      note(("%smean %+.3f %%, r.m.s. %.3f %%, at most %.3f %%"):format(label, 100 * mean, 100 * scatter, 100 * most))
      below(scatter, rms[size][force], label .. "r.m.s. error")
      below(most, 2 * rms[size][force], label .. "largest error")
      if force == 30 then scatters[size] = scatter end
    end
  end
end
figures.above(math.log(scatters[0.02] / scatters[0.005], 4), 2,
  "30 N: order of convergence of the energy from 20 to 5 um")

-- Tests that the error does not depend on the position of the plate's nodes between the cylinder's nodes.
for _, row in ipairs{ { 0.01, 12, 0.02 }, { 0.01, 30, 0.004 }, { 0.005, 12, 0.002 }, { 0.005, 48, 0.0015 } } do
  local size, force, most = table.unpack(row)
  local worst = 0
  for _, part in ipairs{ 0.25, 0.37, 0.5, 0.8 } do
    for _, each in ipairs{ 88, 100 } do
      worst = math.max(worst, math.abs(energy_off(models[size], force, each, nil, (part + 2) * size)))
    end
  end
  below(worst, most,
    ("%g um, %g N, plate nodes between the cylinder nodes: energy of a cycle, largest error"):format(1e3 * size, force))
end

-- Tests small forces, under which no node slips and all energy is dissipated between the nodes, and forces
-- close to sliding.
for _, case in ipairs{ { 6, 0.06 }, { 57, 0.005 }, { 59.4, 0.005 } } do
  local force, most = table.unpack(case)
  below(math.abs(energy_off(models[0.01], force, load)), most, ("10 um, %g N: energy of a cycle, error"):format(force))
end

-- --- forces with a mean value ---------------------------------------------------------------------

-- Tests cycles of a force with a mean value. A change D of the force after a reversal dissipates half as much
-- energy as the cycle between -D/2 and D/2. This is checked for each half of each cycle, in one increment or
-- nine, and in the loops of wear. If the force passes an earlier turning point, the earlier branch is
-- continued.
local function way_energy(change) return cycle_energy(change / (2 * mu * load)) / 2 end

for _, row in ipairs{ { 0.02, 0.06 }, { 0.01, 0.015 }, { 0.005, 0.001 } } do
  local size, most = table.unpack(row)
  for _, case in ipairs{ { 10, 45 }, { -20, 45 }, { 0, 55 } } do
    local low, high = table.unpack(case)
    local c, off = contact{ model = models[size], friction = mu }:move{ tangential = high }, {}
    for cycle = 1, 3 do
      for _, force in ipairs{ low, high } do
        local after = c:move{ tangential = force, increments = cycle == 3 and 9 or 1 }
        off[#off + 1] = math.abs((after.energy - c.energy) / way_energy(high - low) - 1)
        c = after
      end
    end
    local label = ("%g um, %g to %g N: "):format(1e3 * size, low, high)
    below(math.max(table.unpack(off)), most, label .. "energy of each half of three cycles, largest error")
    local w = wear{ model = models[size], friction = mu, load = load, k = 1e-9, cycles = 1, jump = 1,
      loading = { tangential = function(t) return (low + high + (high - low) * math.sin(2 * math.pi * t)) / 2 end, load = load,
        increments = 24 } }
    below(math.abs(w:loop().energy / (2 * way_energy(high - low)) - 1), most, label .. "energy of the loop of wear, error")
  end
end

do
  local c = contact{ model = models[0.005], friction = mu }:move{ tangential = 45 }:move{ tangential = -45 }
    :move{ tangential = 10 }:move{ tangential = -20 }
  local worst = 0
  for _, force in ipairs{ 5, 10, 11, 15, 20, 30, 45 } do
    local wanted = force <= 10 and way_energy(force + 20) or way_energy(30) + way_energy(force + 45) - way_energy(55)
    worst = math.max(worst, math.abs((c:move{ tangential = force }.energy - c.energy) / wanted - 1))
  end
  below(worst, 0.003, "5 um, forces 45, -45, 10, -20 N and again beyond 10 N: energy, largest error")
  -- more reversals than the library stores
  for i = 1, 100 do c = c:move{ tangential = (-1) ^ i * (40 - 0.3 * i) } end
  within(c:move{ tangential = -10 }.energy - c.energy, way_energy(20), 0.005,
    "energy of a displacement after 100 nested reversals [N mm]")
  c = c:move{ tangential = -20 }
  within(c:move{ tangential = 10 }.energy - c.energy, way_energy(30), 0.002,
    "energy of a displacement beyond many reversals [N mm]")
end

-- Tests the stick zone after a reversal: after a change D of the force, its half width is a sqrt(1 - D / (2
-- mu L)).
for _, size in ipairs{ 0.02, 0.01, 0.005 } do
  local c, worst = contact{ model = models[size], friction = mu }:move{ tangential = 48 }, 0
  for _, force in ipairs{ 40, 30, 20, 10, 0, -10, -20, -30, -40, -45, -48 } do
    c = c:move{ tangential = force }
    local edge = a * math.sqrt(1 - (48 - force) / (2 * mu * load))
    worst = math.max(worst, math.abs(c.stick[1].right - edge), math.abs(c.stick[1].left + edge))
  end
  below(worst / size, 0.15,
    ("%g um, after a reversal at 48 N: error of the stick zone's edges in elements"):format(1e3 * size))
end

-- Tests the energy of a cycle for other bodies: thin plates, plastics, and the element type CPE4I.
do
  local plastic, fine = { E = 1000, nu = 0.46 }, mesh_of(0.02)
  fine.zone = { cylinder = 1, plate = 1.2 }
  for _, case in ipairs{
    { "plane stress", { geometry = "plane stress", mesh = mesh_of(0.02) }, { geometry = "plane stress" }, 100 },
    { "plastics", { cylinder = plastic, plate = plastic, mesh = fine }, { cylinder = plastic, plate = plastic }, 1 },
    { "CPE4I", { mesh = { size = 0.02, height = 0.025, element = "CPE4I" } }, {}, 100 },
  } do
    local label, bodies, pair, normal = table.unpack(case)
    pair.load = normal
    local off = energy_off(model(bodies), 30, normal, hertz(pair))
    below(math.abs(off), 0.015, label .. ": energy of a cycle, error")
  end
end

-- --- load and force together --------------------------------------------------------------------

-- Returns the compliance of a slice at the load P in Jaeger's superposition, (const - ln P) / (pi E*), without the
-- constant.
local function compliance(normal) return -math.log(normal) / (math.pi * exact.E_star) end

-- Returns the energy dissipated in the second cycle; path(t) returns load and force.
local function jaeger_energy(path, steps)
  local s, energy = slices.new(5000, 200, mu, compliance), 0
  for k = 0, 2 * steps do
    local force, motion = s.force, s.motion
    slices.change(s, path(k / steps))
    if k > steps then energy = energy + (s.force + force) / 2 * (s.motion - motion) end
  end
  return energy
end

within(jaeger_energy(function(t) return load, 30 * math.sin(2 * math.pi * t) end, 1000), cycle_energy(0.5), 2e-3,
  "Jaeger's slices have the energy of Cattaneo and Mindlin [N mm]")

local function engine_energy(path, steps)
  local normal, force = path(0)
  local c = contact{ model = models[0.005], friction = mu, load = normal }:move{ tangential = force }
  local start
  for k = 1, 2 * steps do
    normal, force = path(k / steps)
    c = c:move{ load = normal, tangential = force }
    if k == steps then start = c.energy end
  end
  return c.energy - start
end
for _, phase in ipairs{ 0.25, 0.5 } do
  local function path(t)
    return load * (1 + 0.3 * math.sin(2 * math.pi * t)), 38 * math.sin(2 * math.pi * (t + phase))
  end
  within(engine_energy(path, 80), jaeger_energy(path, 1000), 0.01,
    ("load +-30 %%, force +-38 N, shifted by %g of a cycle: energy [N mm]"):format(phase))
end

-- --- stick and slip under a normal load alone ---------------------------------------------------

local function elliptic(k)
  local x, y = 1, math.sqrt(1 - k * k)
  for _ = 1, 40 do x, y = (x + y) / 2, math.sqrt(x * y) end
  return math.pi / (2 * x)
end

-- Returns the fraction k of the contact width that sticks, from Goodman's equation K(k') / K(k) = |beta| / mu
-- with complete elliptic integrals K. The equation neglects the effect of the shear on the pressure.
local function stuck_share(beta, friction)
  local low, high = 1e-9, 1 - 1e-12
  for _ = 1, 100 do
    local k = (low + high) / 2
    if elliptic(math.sqrt(1 - k * k)) / elliptic(k) > beta / friction then low = k else high = k end
  end
  return low
end

do
  local soft = { E = 70e3, nu = 0.2 }
  local m = model{ plate = soft, mesh = mesh_of(0.01) }
  local function kappa(b) return (1 - 2 * b.nu) * (1 + b.nu) / b.E end
  local h = hertz{ plate = soft }
  local beta = math.abs(h.E_star * (kappa(material{}) - kappa(soft)) / 2)
  note(("beta = %.4f"):format(beta))
  for _, friction in ipairs{ 0.14, 0.16 } do
    local c = contact{ model = m, friction = friction, increments = 60 }
    local wide = stuck_share(beta, friction) * h.half_width
    about((c.stick[1].right - c.stick[1].left) / 2, wide, 0.01,
      ("dissimilar bodies, friction %g: half width of the stick zone [mm], to an element"):format(friction))
    about(c.tangential, 0, 1e-6, "dissimilar bodies: no tangential force [N]")
  end
end

-- --- sliding ------------------------------------------------------------------------------------

do
  local c = contact{ model = models[0.01], friction = mu }:move{ x = 0.05, increments = 20 }
  about(c.tangential, mu * load, 1e-9, "gross slip: tangential force [N]")
  figures.ok(#c.stick == 0, "gross slip: no stick zone")
  local field, surface = c:stress().plate, c.model.mesh.plate:surface()
  local worst, largest = 0, 0
  for _, node in ipairs(surface) do
    local x = field.x[node] / a
    if math.abs(x) < 0.8 then
      local wanted = -p0 * math.sqrt(1 - x * x) + 2 * mu * p0 * x
      worst = math.max(worst, math.abs(field.sxx[node] - wanted))
    end
    largest = math.max(largest, field.principal[node])
  end
  below(worst / p0, 0.02, "gross slip: stress along the plate's surface, |x| < 0.8 a: largest error / p0")
  within(largest, 2 * mu * p0, 0.25,
    "gross slip: largest principal stress, at a cusp at the trailing edge [MPa]")
end

-- Tests the stress along the surface at the nodes within one and a half elements of the contact's edges,
-- where it has cusps of 2 mu p0. The distance of the nodes from the edge differs between the loads.
for _, row in ipairs{ { 0.02, 0.09 }, { 0.01, 0.065 } } do
  local size, worst = row[1], 0
  for normal = 80, 120, 10 do
    local h = hertz{ load = normal }
    local c = contact{ model = models[size], load = normal, friction = mu }:move{ x = 0.05, increments = 5 }
    for body, field in pairs(c:stress()) do
      for _, node in ipairs(c.model.mesh[body]:surface()) do
        local x = field.x[node] / h.half_width
        if math.abs(math.abs(field.x[node]) - h.half_width) < 1.5 * size then
          local root = math.sqrt(math.abs(x * x - 1))
          local pressed, outside = x * x < 1 and -root or 0, x * x > 1 and root or 0
          local pulled = 2 * mu * (x - (x > 0 and outside or -outside))
          local wanted = h.p_max * (pressed + (body == "plate" and pulled or -pulled))
          worst = math.max(worst, math.abs(field.sxx[node] - wanted) / h.p_max)
        end
      end
    end
  end
  below(worst, row[2],
    ("gross slip, %g um: stress along both surfaces near the edges, largest error / p0"):format(1000 * size))
end

-- --- effect of the outer boundaries -------------------------------------------------------------

do
  local pressed = contact{ model = models[0.01], friction = mu }
  within(pressed:move{ x = 1e-6 }.tangential / 1e-6, 23965, 0.01,
    "stiffness while the whole contact sticks [N/mm]")
  local low, high = 2e-3, 3e-3
  for _ = 1, 24 do
    local middle = (low + high) / 2
    if #pressed:move{ x = middle }.stick == 0 then high = middle else low = middle end
  end
  within(low, 2.677e-3, 0.005, "displacement at the start of sliding [mm]")
end

-- --- meshes chosen for a contact with friction ----------------------------------------------------

local function loop_energy(bodies, share)
  local there = contact{ model = bodies, load = load, friction = mu }:move{ tangential = share * mu * load }
  local back = there:move{ tangential = -share * mu * load }
  return back:move{ tangential = share * mu * load }.energy - there.energy
end

for i, share in ipairs{ 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95 } do
  within(loop_energy(nil, share), cycle_energy(share), i == 1 and 0.01 or 0.005,
    ("steel, automatic mesh, %g of full slip: energy of a cycle [N mm]"):format(share))
end
for name, bodies in pairs{ ["aluminium plate"] = { plate = { E = 70e3, nu = 0.33 } },
  ["polymer cylinder"] = { cylinder = { E = 3600, nu = 0.4 } } } do
  local fine = {}
  for key, value in pairs(bodies) do fine[key] = value end
  fine.mesh = { fineness = 14 }
  fine = contact{ model = fine, load = load }.model
  for _, share in ipairs{ 0.2, 0.3, 0.5, 0.7, 0.9 } do
    within(loop_energy(bodies, share), loop_energy(fine, share), share < 0.3 and 0.06 or 0.015,
      ("%s, automatic mesh, %g of full slip: energy of a cycle [N mm]"):format(name, share))
  end
end

-- Tests that the displacement under a force grows with the size of the plate, and the energy of a cycle does not.
local function of_plate(width)
  local m = model{ lower = body.block{ width = width, height = width / 2 }, upper = body.cylinder{ radius = 10 } }
  local w = wear{ model = m, load = load, friction = mu, tangential = 30, cycles = 1 }
  w:step()
  return contact{ model = m, load = load, friction = mu }:move{ tangential = 30 }.x, w.cycle_energy
end
local near, energy = of_plate(20)
local far, same = of_plate(40)
within(far / near, 1.05, 0.01, "displacement with a plate twice as large, over that with the plate")
within(same, energy, 0.001, "energy of a cycle with a plate twice as large [N mm]")

-- Compares the contact of a ball on a flat, unworn and worn, between CalculiX (three-dimensional elements)
-- and archard (half-spaces). `make peer` runs this script.

local deck = dofile(arg[0]:match("^.*/") .. "ball_deck.lua")

local radius, load, E, nu, far = 10, 10, 200e3, 0.3, 10

local function depth_of(map)
  local x, z = map.x[#map.x], map.z[#map.z]
  return function(u, v) return u <= x and v <= z and map:at(u, v) or 0 end
end

local function zero() return 0 end

-- Returns the stress normal to the surface on the axis, in archard and in CalculiX. The stress is compared
-- at the CalculiX node whose depth is nearest to half the contact half width. Surface pressures are not
-- compared, because CalculiX extrapolates them, which is inaccurate on a worn surface.
local function on_axis(c, axis, half, surface)
  local nearest = axis[1]
  for _, node in ipairs(axis) do
    if math.abs(node.y + half / 2) < math.abs(nearest.y + half / 2) then nearest = node end
  end
  return c:stress{ y = nearest.y - surface }.syy:at(0, 0), nearest.syy
end

local function largest(map)
  local most = 0
  for _, value in ipairs(map.y) do most = math.max(most, value) end
  return most
end

-- Solves a contact in both programs. Returns { title=, rows }. ball(x, z) and flat(x, z) return the worn
-- depths [mm].
local function case(ccx, folder, title, c, ball, flat, seconds)
  local half = math.max(c.half_width, c.half_width_z)
  local rim = (10 * half) ^ 2 -- beyond this radius the ball is flat, so that both bodies have a fixed height
  local function height(x, z) return math.min(x * x + z * z, rim) / (2 * radius) + ball(x, z) end
  local ball_nodes, all = deck.write(folder .. "/ball.inp", { upper = height, lower = function(x, z) return -flat(x, z) end, E = E,
    nu = nu, load = load, approach = c.approach, half_width = half, far = far, elements = 4, stiffness = 1e9 })
  local r, said = ccx.solve(folder, "ball", ball_nodes, all)
  if not r then error("CalculiX: " .. said:sub(-1000)) end
  local ours, theirs = on_axis(c, r.axis, half, -flat(0, 0))
  return { title = title, { ours, theirs }, { c.approach, r.approach }, { largest(c:stress{ z = 0 }.mises), r.mises.plate },
    { c.load, 4 * r.force }, seconds = { seconds, r.seconds / r.increments }, nodes = all }
end

local rows = { "stress normal to the surface on the axis, at a depth of half the half width [MPa]", "approach [mm]", "largest von Mises stress, flat [MPa]", "load [N]" }

return function(ccx, folder)
  local m = model{ geometry = "3-D", upper = body.ball{ radius = radius, E = E, nu = nu }, lower = body.block{ E = E, nu = nu } }
  local began = os.clock()
  local w = wear{ model = m, load = load, stroke = 0.1, alpha = 0.5, k = 1e-8, distance = 300 }
  w:run{ progress = false }
  local seconds = (os.clock() - began) / w.solutions
  local cases = { case(ccx, folder, "ball on flat, unworn", contact{ model = m, load = load }, zero, zero, seconds),
    case(ccx, folder, "worn, after 300 mm", w:contact(), depth_of(w:map(w.model.bodies.upper)), depth_of(w:map(w.model.bodies.lower)), seconds) }
  io.write("\n| archard / CalculiX |")
  for _, c in ipairs(cases) do io.write(" ", c.title, " |") end
  io.write("\n|---|", ("---|"):rep(#cases), "\n")
  for i, name in ipairs(rows) do
    io.write("| ", name, " |")
    for _, c in ipairs(cases) do io.write((" %.4g / %.4g (%+.1f %%) |"):format(c[i][1], c[i][2], 100 * (c[i][2] / c[i][1] - 1))) end
    io.write("\n")
  end
  io.write("| CPU seconds per increment |")
  for _, c in ipairs(cases) do io.write((" %.1g / %.0f |"):format(c.seconds[1], c.seconds[2])) end
  io.write(("\n\nCalculiX: a quarter of both bodies, each %g mm high, bricks of 20 nodes, %d nodes; archard: half-spaces, 8 cells over the half "
    .. "width.\n"):format(far, cases[1].nodes))
end

-- Tests the effect of the corrections of element errors (theory.md, "Corrections"). Each quantity is computed
-- with and without the corrections on the default mesh, and compared with closed forms of half-planes or with
-- a stiffness recomputed at every update.
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")

local mu, size = 0.6, 0.02
local usual = model{}

-- Returns the root mean square and the largest absolute value of a list.
local function spread(list)
  local sum, most = 0, 0
  for _, value in ipairs(list) do sum, most = sum + value * value, math.max(most, math.abs(value)) end
  return math.sqrt(sum / #list), most
end

-- Returns loads [N/mm] for which the edges of the contact move across two elements.
local function loads(count)
  local list, a = {}, hertz{}.half_width
  for i = 1, count do list[i] = 100 * (1 + (2 * (i - 0.5) / count - 1) * size / a) ^ 2 end
  return list
end

-- Checks that the error is at most `most` with the corrections and at least `times` as large without them.
local function earns(what, error_of, most, times)
  local with, without = error_of("all"), error_of("none")
  figures.below(with, most, what .. ": with the correction")
  figures.above(without / with, times,
    ("%s: %.3g without the correction, ratio of both errors"):format(what, without))
end

earns("edge law: half width, largest error in elements", function(corrections)
  local off = {}
  for i, load in ipairs(loads(24)) do
    local c = contact{ model = usual, load = load, corrections = corrections }
    off[i] = (c.half_width - hertz{ load = load }.half_width) / size
  end
  return select(2, spread(off))
end, 0.04, 4)

-- Calls each(x, sxx) at the plate's surface nodes, where sxx is the stress along the surface [MPa].
local function along_surface(c, each)
  local field = c:stress().plate
  for _, node in ipairs(usual.mesh.plate:surface()) do each(field.x[node], field.sxx[node]) end
end

earns("edge law: stress along the surface within 1.5 elements of the edge, largest error, fraction of p_max",
  function(corrections)
    local most = 0
    for _, load in ipairs(loads(8)) do
      local h = hertz{ load = load }
      along_surface(contact{ model = usual, load = load, corrections = corrections }, function(x, stress)
        local inside = 1 - (x / h.half_width) ^ 2
        if math.abs(math.abs(x) - h.half_width) < 1.5 * size then
          most = math.max(most, math.abs(stress + h.p_max * math.sqrt(math.max(0, inside))) / h.p_max)
        end
      end)
    end
    return most
  end, 0.03, 3)

earns("cusp: stress along the surface beside the edges in sliding, largest error, fraction of p_max",
  function(corrections)
  local most = 0
  for _, load in ipairs(loads(4)) do
    local h = hertz{ load = load }
    local c = contact{ model = usual, load = load, friction = mu, corrections = corrections }
      :move{ x = 0.05, increments = 20 }
    along_surface(c, function(x, stress)
      local t, side = math.abs(x) / h.half_width, x < 0 and -1 or 1
      if math.abs(t - 1) * h.half_width > 1.5 * size then return end
      local drag = 2 * mu * side * (t - math.sqrt(math.max(0, t * t - 1)))
      local wanted = h.p_max * (drag - math.sqrt(math.max(0, 1 - t * t)))
      most = math.max(most, math.abs(stress - wanted) / h.p_max)
    end)
  end
  return most
end, 0.1, 2.5)

-- Computes a contact under a tangential force of half the friction limit. The closed form of its shear is by
-- Cattaneo and Mindlin.
local function sheared(load, corrections)
  return contact{ model = usual, load = load, friction = mu, press = "frictionless", corrections = corrections }
    :move{ tangential = mu * load / 2 }
end
local function exact_shear(h, x)
  local function circle(half_width) return math.sqrt(math.max(0, half_width ^ 2 - x * x)) / h.half_width end
  return mu * h.p_max * (circle(h.half_width) - circle(h.half_width * math.sqrt(0.5)))
end

earns("levelled shear: root mean square error, fraction of mu p_max", function(corrections)
  local off = {}
  for _, load in ipairs(loads(12)) do
    local h, shear = hertz{ load = load }, sheared(load, corrections):shear()
    for i, x in ipairs(shear.x) do
      if math.abs(x) < h.half_width then
        off[#off + 1] = (shear.q[i] - exact_shear(h, x)) / (mu * h.p_max)
      end
    end
  end
  return (spread(off))
end, 0.03, 1.4)

earns("slip between nodes: energy of a cycle, root mean square error", function(corrections)
  local off = {}
  for i, load in ipairs(loads(12)) do
    local there = sheared(load, corrections)
    local back = there:move{ tangential = -mu * load / 2 }
    local wanted = 2 * mu ^ 2 * load ^ 2 / (math.pi * hertz{}.E_star) * (0.5 * math.log(0.5) + 0.5 - 0.125)
    off[i] = (back.energy - there.energy) / wanted - 1
  end
  return (spread(off))
end, 0.02, 5)

-- Returns for every update the pressures on the cylinder, the centre pressure, and the half width minus 2.5
-- elements (`reach`).
local function pressures(corrections, refresh)
  local w = wear{ model = usual, corrections = corrections, refresh = refresh, alpha = 1, jump = 100, distance = 1320 }
  local list = {}
  while w.distance < 1320 * (1 - 1e-12) do
    w:step()
    list[#list + 1] = { at = w:pressure("cylinder"), centre = w.p_center, reach = w.half_width - 2.5 * size }
  end
  return list
end

earns("followed stiffness: pressures 2.5 elements inside the edges, largest error between two refreshes",
  function(corrections)
    local exact, found, off = pressures(corrections, 0), pressures(corrections), {}
    for u, state in ipairs(found) do
      for i, p in ipairs(state.at.p) do
        if math.abs(state.at.x[i]) < exact[u].reach then off[#off + 1] = (p - exact[u].at.p[i]) / exact[u].centre end
      end
    end
    return select(2, spread(off))
  end, 1e-4, 3)

-- Tests that a stored run contains the choice of corrections, and that a contact on its surfaces can choose
-- other corrections.
local w = wear{ model = usual, corrections = "none", distance = 50 }
w:run{ progress = false }
local file = os.tmpname() .. ".archard"
w:save(file)
figures.ok(wear.open(file).corrections == "none", "the choice of corrections is saved with the run")
os.remove(file)
local unworn = wear{ model = usual, corrections = "none" }
figures.ok(contact{ worn = unworn }.half_width ~= contact{ worn = unworn, corrections = "none" }.half_width,
  "a contact on the surfaces of a run can choose other corrections")

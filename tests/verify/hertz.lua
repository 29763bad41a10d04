-- Tests the unworn contact against Hertz theory: pressure on the default mesh, its convergence, and stresses
-- below the surface.
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, below, above = figures.within, figures.below, figures.above

local exact = hertz{}
within(exact.half_width, 0.107641, 1e-5, "half width by Hertz' formula [mm]")
within(exact.p_max, 591.431, 1e-6, "largest pressure by Hertz' formula [MPa]")

local function hertz_pressure(x, h)
  local t = x / h.half_width
  return math.abs(t) < 1 and h.p_max * math.sqrt(1 - t * t) or 0
end

-- Returns the sum of |p - p_Hertz| over the nodes as a share of the sum of p_Hertz.
local function profile_error(c, h)
  local p = c:pressure("cylinder")
  local off, all = 0, 0
  for i, x in ipairs(p.x) do
    local e = hertz_pressure(x, h)
    off, all = off + math.abs(p.p[i] - e), all + e
  end
  return off / all
end

local c = contact{}
within(c.p_center, exact.p_max, 5e-3, "centre pressure, 20 x 25 um [MPa]")
within(c.half_width, exact.half_width, 0.02, "half width, 20 x 25 um [mm]")
below(profile_error(c, exact), 0.02, "pressure profile, mean error, 20 x 25 um")

-- Returns the error of the centre pressure on a mesh. The error of a single contact depends on the position
-- of its edge between two nodes, so this function computes the root mean square over loads whose edges move
-- across several nodes.
local function centre_error(model)
  local sum, worst, count = 0, 0, 0
  for load = 60, 140, 4 do
    local off = contact{ model = model, load = load }.p_center / hertz{ load = load }.p_max - 1
    sum, worst, count = sum + off * off, math.max(worst, math.abs(off)), count + 1
  end
  return math.sqrt(sum / count), worst
end

local sizes, errors = { 0.04, 0.02, 0.01 }, {}
for i, size in ipairs(sizes) do
  local m = model{ mesh = { size = size, height = 1.25 * size } }
  local worst
  errors[i], worst = centre_error(m)
  figures.note(("%g um: centre pressure over 60 to 140 N off by %.3f %% (r.m.s.), %.3f %% at most")
    :format(1000 * size, 100 * errors[i], 100 * worst))
  if size == 0.02 then below(worst, 5e-3,
    "largest error of the centre pressure over 21 loads, 20 x 25 um") end
end
for i = 2, #sizes do
  local order = math.log(errors[i - 1] / errors[i], 2)
  above(order, 1.6, ("order of convergence from %g to %g um")
    :format(1000 * sizes[i - 1], 1000 * sizes[i]))
end

-- Tests that the element type CPE4I is as accurate as CPE4.
within(contact{ model = { mesh = { element = "CPE4I" } } }.p_center, exact.p_max, 5e-3,
  "centre pressure, CPE4I [MPa]")

local function largest(field, name)
  local most, at = 0, 0
  for i, v in ipairs(field[name]) do
    if v > most then most, at = v, i end
  end
  return most, math.abs(field.y[at]), field.x[at]
end

local stress = c:stress()
for _, body in ipairs{ "cylinder", "plate" } do
  local field = stress[body]
  local mises, deep, x = largest(field, "mises")
  within(mises, 0.5575 * exact.p_max, 0.02, body .. ": largest von Mises stress [MPa]")
  figures.about(deep / exact.half_width, 0.704, 0.13,
    body .. ": depth of the largest von Mises stress / a, to half an element")
  figures.about(x, 0, 1e-9, body .. ": x of the largest von Mises stress [mm]")
  local shear, below_surface = largest(field, "shear")
  within(shear, 0.3003 * exact.p_max, 0.02, body .. ": largest in-plane shear [MPa]")
  figures.about(below_surface / exact.half_width, 0.786, 0.13,
    body .. ": depth of the largest shear / a, to half an element")
end

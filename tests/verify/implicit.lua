-- Tests implicit steps with a tolerance: depths and pressures at every update against explicit updates on the
-- same mesh, the number of solutions, and the continuation of a stored run.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local below, ok, within = figures.below, figures.ok, figures.within

-- Computes two explicit runs: one with updates of at most `jump` cycles, shorter at first when the pressure
-- changes quickly, and one with updates of half that length. The extrapolated limit is twice the finer minus
-- the coarser result.
local function references(fields, jump)
  local pair = {}
  for i = 1, 2 do
    local longest = jump / i
    local copy = {}
    for name, value in pairs(fields) do copy[name] = value end
    copy.jump = function(s) return math.min(longest, longest / 40 + 0.02 * s.cycle / i) end
    pair[i] = wear(copy)
  end
  return pair[1], pair[2]
end

local function largest(values) return math.max(table.unpack(values)) end

-- Returns the largest relative error over the body's nodes deeper than a twentieth of the largest depth.
local function depth_error(w, coarse, fine, body)
  local h, hc, hf, worst = w:profile(body).h, coarse:profile(body).h, fine:profile(body).h, 0
  local deepest = largest(hf)
  if deepest == 0 then return 0 end
  for i, got in ipairs(h) do
    local expected = 2 * hf[i] - hc[i]
    if expected > 0.05 * deepest then worst = math.max(worst, math.abs(got - expected) / deepest) end
  end
  return worst
end

-- Returns the mean error of the pressures divided by the mean pressure. Errors of single nodes at the edge of
-- the contact depend on the mesh, so they are not used.
local function pressure_error(w, coarse, fine)
  local p, pc, pf, sum, all = w:pressure("cylinder").p, coarse:pressure("cylinder").p, fine:pressure("cylinder").p, 0, 0
  for i, got in ipairs(p) do
    sum, all = sum + math.abs(got - 2 * pf[i] + pc[i]), all + got
  end
  return sum / all
end

-- Returns the largest errors over all updates of a run.
local function compare(fields, jump, tolerance)
  local coarse, fine = references(fields, jump)
  fields.scheme, fields.tolerance = "implicit", tolerance
  local w = wear(fields)
  local worst, total = { depth = 0, pressure = 0, p_center = 0, p_max = 0 }, fields.distance or 1320
  while w.distance < total * (1 - 1e-9) do
    w:step()
    coarse:run{ distance = w.distance, progress = false }
    fine:run{ distance = w.distance, progress = false }
    for _, name in ipairs{ "p_center", "p_max" } do
      worst[name] = math.max(worst[name], math.abs(w[name] / (2 * fine[name] - coarse[name]) - 1))
    end
    worst.pressure = math.max(worst.pressure, pressure_error(w, coarse, fine))
    for _, body in ipairs{ "cylinder", "plate" } do
      worst.depth = math.max(worst.depth, depth_error(w, coarse, fine, body))
    end
  end
  return worst, w
end

local function check(what, fields, jump, tolerance)
  local worst, w = compare(fields, jump, tolerance)
  below(worst.depth, 0.6 * tolerance, what .. ": error of the depths over all nodes and updates")
  below(worst.pressure, 10 * tolerance, what .. ": mean error of the pressures, largest over all updates")
  below(worst.p_max, 100 * tolerance, what .. ": error of the largest pressure over all updates")
  below(worst.p_center, 2 * tolerance, what .. ": error of the centre pressure over all updates")
  return w
end

local meshes = {}
local function mesh(um)
  meshes[um] = meshes[um] or model{ mesh = { size = um / 1e3, height = 1.25 * um / 1e3 } }
  return meshes[um]
end

-- --- cases of the paper with several element sizes --------------------------------------------------

-- each row: element size [um], stroke [mm], alpha, longest explicit update, allowed numbers of solutions and
-- of updates
local cases = {
  { 20, 0.11, 0.5, 10, 14e3, 20 }, { 20, 0.22, 0.75, 5, 13e3, 20 }, { 20, 0.44, 0.25, 2.5, 9e3, 15 },
  { 20, 20, 0.5, 0.1, 250, 18 }, { 10, 0.11, 0.5, 10, 21e3, 25 }, { 10, 0.44, 0.75, 2.5, 19e3, 25 },
  { 10, 20, 1, 0.1, 500, 25 }, { 5, 0.11, 0.5, 10, 25e3, 25 }, { 5, 20, 1, 0.1, 950, 28 },
}
for _, case in ipairs(cases) do
  local um, stroke, alpha, jump, most, updates = table.unpack(case)
  local what = ("%g um, s = %g, alpha = %g"):format(um, stroke, alpha)
  local w = check(what, { model = mesh(um), geometry = "frozen", stroke = stroke, alpha = alpha }, jump, 1e-3)
  below(w.solutions, most, what .. ": number of contact solutions")
  below(w.update, updates + 1, what .. ": number of updates")
  within(w.volume.total, 1.32e-3, 1e-9, what .. ": volume [mm3]")
  local off = figures.asymmetry(w:profile("cylinder").h)
  -- with one contact position for the whole stroke the symmetry is exact up to rounding
  local rests = stroke == 20
  ok(off == 0 or rests and off < 1e-9, ("%s: asymmetry %.2g, zero if the contact moves"):format(what, off))
end

-- --- a soft cylinder, moving nodes, a smaller tolerance ----------------------------------------------

check("soft cylinder, moving geometry",
  { model = { radius = 5, cylinder = { E = 3e3, nu = 0.35 } }, load = 8, stroke = 0.3,
  alpha = 0.8, k = 3e-7, distance = 400 }, 2, 1e-3)
check("tolerance 2e-4", { model = mesh(20), geometry = "frozen", stroke = 0.22, alpha = 0.5 }, 2.5, 2e-4)

-- --- a stored run continues with identical bits ------------------------------------------------------

local fields = { stroke = 0.22, scheme = "implicit", tolerance = 1e-3, distance = 300 }
local whole, file = wear(fields):run{ progress = false }, os.tmpname()
os.remove(file)
local half = wear(fields)
for _ = 1, 8 do half:step() end
half:save(file)
local again = wear.open(file):run{ progress = false }
os.remove(file)
ok(again.p_max == whole.p_max and again.update == whole.update,
  "a stored run has the same pressures and number of updates")
local same = true
for i, h in ipairs(whole:profile("plate").h) do same = same and h == again:profile("plate").h[i] end
ok(same, "a stored run has the same depths to the bit")

-- Tests automatic steps: implicit updates with a tolerance, and automatic explicit updates.

-- Long

local at = require "archard.lib.history_at"
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within, below, ok = figures.within, figures.below, figures.ok

local function run(fields) return wear(fields):run() end
local function roughest(w) return math.max(w:roughness("cylinder"), w:roughness("plate")) end

local function asymmetry(w)
  return math.max(figures.asymmetry(w:profile("cylinder").h), figures.asymmetry(w:profile("plate").h))
end

local function depths(w, true_depth, share, what)
  for _, body in ipairs{ "cylinder", "plate" } do
    if true_depth[body] == 0 then
      ok(w.depth[body] == 0, what .. ": no wear of the " .. body)
    else
      within(1000 * w.depth[body], 1000 * true_depth[body], share, ("%s: depth of the %s [um]"):format(what, body))
    end
  end
end

-- Returns the depths for explicit updates, extrapolated to updates of length zero: twice the finer minus the
-- coarser result.
local function extrapolated(fields, jump)
  local depth = {}
  for i, part in ipairs{ 5, 10 } do
    fields.jump = jump / part
    depth[i] = run(fields).depth
  end
  return { cylinder = 2 * depth[2].cylinder - depth[1].cylinder, plate = 2 * depth[2].plate - depth[1].plate }
end

-- --- implicit: the error is within the tolerance, with few steps ---------------------------------------

local cases = { -- each row: stroke [mm], alpha, N-bar of Table 1, largest number of steps
  { 0.11, 0.5, 100, 50 }, { 0.22, 0.25, 40, 50 }, { 0.44, 0.75, 20, 50 }, { 20, 0.5, 1, 50 },
}
for _, case in ipairs(cases) do
  local stroke, alpha, jump, most = table.unpack(case)
  local what = ("s = %g, alpha = %g, tolerance = 1e-3"):format(stroke, alpha)
  local true_depth = extrapolated({ stroke = stroke, alpha = alpha }, jump)
  local w = run{ stroke = stroke, alpha = alpha, scheme = "implicit", tolerance = 1e-3 }
  depths(w, true_depth, 1e-3, what)
  below(w.update, most + 1, what .. ": number of steps")
  within(w.volume.total, 1.32e-3, 1e-9, what .. ": volume [mm3]")
  below(roughest(w), 5e-4, what .. ": roughness")
  below(asymmetry(w), 1e-9, what .. ": asymmetry")
end

-- Tests that implicit steps of first and second order converge to the same result with these orders. apart()
-- compares whole profiles of two runs, because the deepest nodes alone may agree by chance.
local function apart(w, other)
  local h, g, off, all = w:profile("cylinder").h, other:profile("cylinder").h, 0, 0
  for i = 1, #h do off, all = off + (h[i] - g[i]) ^ 2, all + g[i] ^ 2 end
  return math.sqrt(off / all)
end
local fine = run{ scheme = "implicit", jump = 12.5 }
for order = 1, 2 do
  local off = {}
  for i, jump in ipairs{ 400, 200 } do
    local w = run{ scheme = "implicit", order = order, jump = jump }
    off[i] = apart(w, fine)
  end
  figures.above(off[1] / off[2], order == 1 and 1.7 or 3.5,
    ("order %d: ratio of the errors when the step is halved"):format(order))
  below(off[2], order == 1 and 2e-3 or 5e-5, ("order %d, N-bar = 200: error of the depths"):format(order))
end

-- Tests that the error control includes functions of the state, such as running-in.
local function running_in(s) return 1e-8 * (1 + 4 * math.exp(-s.distance / 100)) end
local exact = 1e-6 * (1320 + 400 * (1 - math.exp(-13.2)))
local w = run{ k = running_in, scheme = "implicit", tolerance = 1e-3 }
within(w.volume.total, exact, 1e-3, "running-in k, tolerance = 1e-3: volume [mm3]")
below(w.update, 60, "running-in k: number of steps")
-- the tolerance applies to one step, and errors of the same sign add up
within(run{ k = running_in, scheme = "implicit", tolerance = 1e-4 }.volume.total, exact, 3e-4,
  "running-in k, tolerance = 1e-4: volume [mm3]")

-- --- implicit: stable where explicit updates fail ----------------------------------------------------------

for _, jump in ipairs{ 200, 300, 1000 } do
  for _, order in ipairs{ 1, 2 } do
    w = run{ jump = jump, scheme = "implicit", order = order }
    below(roughest(w), 5e-4, ("N-bar = %d, implicit of order %d: roughness"):format(jump, order))
    below(asymmetry(w), 1e-9, ("N-bar = %d, implicit of order %d: asymmetry"):format(jump, order))
  end
end
local calm = roughest(run{ jump = 100 })
local rough = wear{ jump = 300 }
local ended, problem = pcall(rough.run, rough)
ok(not ended and problem.message:find "ripples" ~= nil,
  "N-bar = 300, explicit: the run ends with an error about ripples")
figures.above(roughest(rough) / calm, 100, "N-bar = 300, explicit: roughness relative to N-bar = 100")

-- --- automatic explicit updates without a given number --------------------------------------------------------

for _, stroke in ipairs{ 0.11, 0.22, 0.44, 20 } do
  for _, alpha in ipairs{ 0, 0.25, 0.5, 0.75, 1 } do
    local what = ("auto, s = %g, alpha = %g"):format(stroke, alpha)
    local auto = run{ stroke = stroke, alpha = alpha, jump = "auto" }
    below(roughest(auto), 2e-4, what .. ": roughness")
    below(asymmetry(auto), 1e-9, what .. ": asymmetry")
    within(auto.volume.total, 1.32e-3, 1e-9, what .. ": volume [mm3]")
  end
end

-- Returns the largest relative error of a column over all stored updates, against explicit updates
-- extrapolated to length zero at the same distance.
local function worst(history, coarse, fine, column)
  local most = 0
  for i = 2, #history.distance do
    local distance = history.distance[i]
    local expected = 2 * at(fine, column, distance) - at(coarse, column, distance)
    most = math.max(most, expected > 0 and math.abs(history[column][i] / expected - 1) or 0)
  end
  return most
end

-- Tests a law with a threshold over all updates. Nodes change repeatedly between wear and no wear, so the
-- steps must be short enough to follow.
for _, case in ipairs{ { 250, 0.22, 0.4, 0.2 }, { 150, 0.11, 0.5, 0.5 }, { 200, 0.44, 0.75, 0.5 } } do
  local p0, stroke, alpha, jump = table.unpack(case)
  local fields = { law = "threshold", law_pressure = p0, stroke = stroke, alpha = alpha, distance = 660, geometry = "frozen" }
  fields.jump = jump
  local fine = run(fields).history
  fields.jump = nil -- the default
  local auto = run(fields).history
  local what = ("threshold %g MPa, s = %g, alpha = %g, auto, whole run: "):format(p0, stroke, alpha)
  for column, most in pairs{ depth_cylinder = 2e-3, depth_plate = 2e-3, p_center = 2e-3 } do
    below(worst(auto, fine, fine, column), most, what .. column .. ": largest error")
  end
end

local aluminium = material{ E = 70e3, nu = 0.33 }
-- each row: name, fields, jump of the coarser reference; the last three cases are not from the paper
local whole_runs = {
  { "s = a, alpha = 0.5", { stroke = 0.11, alpha = 0.5 }, 4 },
  { "s = a, alpha = 0", { stroke = 0.11, alpha = 0 }, 4 },
  { "s = 2a, alpha = 0.25", { stroke = 0.22, alpha = 0.25 }, 2 },
  { "s = 2R, alpha = 0.5", { stroke = 20, alpha = 0.5 }, 0.04 },
  { "E = 70 and 200 GPa, R = 6 mm, 60 N", { model = { radius = 6, cylinder = aluminium, mesh = { size = 0.015, height = 0.02 } },
    load = 60, stroke = 0.17, alpha = 0.35, k = 3e-8, distance = 500 }, 2 },
  { "R = 25 mm, 250 N, s = 0.6 mm, alpha = 0.85", { model = { radius = 25 }, load = 250, stroke = 0.6, alpha = 0.85,
    k = 5e-9, distance = 1000 }, 2 },
  { "a soft plate, alpha = 0.1", { model = { plate = aluminium }, stroke = 0.08, alpha = 0.1, k = 2e-8, distance = 1000 }, 8 },
}
for _, case in ipairs(whole_runs) do
  local name, fields, jump = table.unpack(case)
  fields.geometry, fields.jump = "frozen", jump
  local coarse = run(fields).history
  fields.jump = jump / 2
  local fine = run(fields).history
  fields.jump = "auto"
  local auto = run(fields).history
  below(worst(auto, coarse, fine, "depth_cylinder"), 5e-3,
    name .. ", auto, whole run: error of the cylinder's depth")
  below(worst(auto, coarse, fine, "depth_plate"), 5e-3,
    name .. ", auto, whole run: error of the plate's depth")
  below(worst(auto, coarse, fine, "p_center"), 1e-2,
    name .. ", auto, whole run: error of the centre pressure")
end

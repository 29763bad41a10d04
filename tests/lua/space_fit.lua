-- Tests fits, designs, sensitivities and samples of runs in three dimensions.
-- Ordinary collector settings: even under sanitizers this file is run without continuous garbage collection,
-- which would only slow it down.

-- Long
local tap = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/tap.lua")
local ok, is, near, fails, holds = tap.ok, tap.is, tap.near, tap.fails, tap.holds

local test = { model = { geometry = "3-D", upper = body.ball{ radius = 5 }, lower = body.block{}, mesh = { fineness = 0.5 } }, load = 10,
  stroke = 0.2, distance = 100 }
local function with(changes)
  local all = {}
  for name, value in pairs(test) do all[name] = value end
  for name, value in pairs(changes) do all[name] = value end
  return all
end
local worn = wear(with{ k = 1.3e-8, alpha = 0.4 })
worn:run()
local function trace(name, section, aside)
  local line, x = worn:profile(name, section), {}
  for i, at in ipairs(line.x) do x[i] = at + aside end
  return { x = x, h = line.h, body = name, section = section, distance = 100, error = 1e-5, tilt = 0, level = 0 }
end

-- --- fits ------------------------------------------------------------------------------------------
local data = { trace("cylinder", { z = 0 }, 0.003), trace("cylinder", { x = 0 }, -0.004), trace("plate", { x = 0.05 }, 0),
  { of = "volume_plate", distance = 100, value = worn.volume.block, relative = 0.02 },
  { of = "half_width_z", distance = 100, value = worn.half_width_z, relative = 0.02 } }
local unknown = { k = { start = 1e-8 }, alpha = { start = 0.5 } }
local file = os.tmpname()
os.remove(file)
local f = fit{ base = test, unknown = unknown, data = data, file = file, workers = 2 }
near(f.value.k, 1.3e-8, 5e-3, "k from sections along and across, a volume and a width")
near(f.value.alpha, 0.4, 5e-3, "alpha from sections along and across, a volume and a width")
ok(math.abs(f.value.k - 1.3e-8) < f.error.k, "the error of k is below its standard error")
near(f.data[1].place.shift.value, 0.003, 1e-2, "shift of a section along the motion")
near(f.data[2].place.shift.value, -0.004, 1e-2, "shift of a section across the motion")
holds(tostring(f), { "along the motion at z = 0 mm", "across the motion at x = 0.05 mm" }, "print(f) names the sections")
is(f.mesh, nil, "a fit in 3-D computes no error due to the mesh")
local again = fit{ base = test, unknown = unknown, data = data, file = file, workers = 2 }
is(again.value.k, f.value.k, "a fit with sections is read from its file")
is(again.runs, 0, "a repeated fit needs no run")
os.remove(file)
for section, text in pairs{ [{}] = "section", [{ x = 0, z = 0 }] = "section", [{ y = 0 }] = "section" } do
  local one = trace("plate", { x = 0 }, 0)
  one.section = section
  fails(fit, { base = test, unknown = unknown, data = { one } }, text)
end
local flat = trace("plate", { x = 0 }, 0)
fails(fit, { base = { distance = 100, jump = 100 }, unknown = unknown, data = { flat } }, "sections are of runs")

-- --- designs, sensitivities, samples ------------------------------------------------------------
local design = fit.design{ base = test, unknown = unknown, measure = {
  { profile = "cylinder", section = { x = 0 }, distance = 100, error = 1e-5, width = 0.3 }, { of = "volume", distance = 100, relative = 0.05 } } }
ok(design, "a design with a section")
local s = worn:sensitivity{ of = { "volume_plate" }, to = { "k", "alpha" } }
holds(tostring(s), { "volume_plate", "k", "alpha" }, "sensitivities")
near(s.volume_plate.k.elasticity[1], 1, 1e-3, "the volume is proportional to k")
local cases = study{ base = test, sample = { k = uniform{ 0.8e-8, 1.2e-8 } }, n = 3 }
cases:run{ progress = false, workers = 2, file = file }
for _, case in ipairs(cases:cases()) do near(case.volume.total, case.k * 1000, 1e-9,
  "the volume of each sample is k P d") end
os.remove(file)

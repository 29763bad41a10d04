-- Tests wear laws in three dimensions: powers of pressure, local factors, coefficients that change during the
-- run.

-- Long
local tap = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/tap.lua")
local ok, near = tap.ok, tap.near

local m = model{ geometry = "3-D" }
local function run(changes)
  local all = { model = m, load = 10, stroke = 0.04, alpha = 0.3, distance = 200 }
  for name, value in pairs(changes or {}) do all[name] = value end
  return wear(all)
end

-- --- wear laws, and local factors of the cells ------------------------------------------------------
for _, exponent in ipairs{ 1, -0.5 } do
  local law = { law = "power", law_exponent = exponent, law_pressure = 500, distance = 50 }
  local implicit = run(law)
  implicit:run()
  law.scheme = "explicit"
  local explicit = run(law)
  explicit:run()
  near(implicit.depth.ball, explicit.depth.ball, 3e-3, ("power law, exponent %g: implicit and explicit, ball"):format(exponent))
  near(implicit.volume.total, explicit.volume.total, 1e-3, "volume of implicit and explicit steps")
  law.law, law.scheme = "archard", nil
  law.local_factor = function(_, _, p) return (p / 500) ^ exponent end
  local factors = run(law)
  factors:run()
  near(factors.depth.block, implicit.depth.block, 1e-4, "the power law as a local factor")
end
local stops = run{ law = "threshold", law_pressure = 400, jump = "auto", distance = 20 }
stops:run()
ok(stops.volume.total < 0.99 * 1e-8 * 10 * 20, "cells below the threshold pressure do not wear")
local asked = {}
local sided = run{ distance = 20, local_factor = function(body, x, p, state, z)
  asked[body] = math.max(asked[body] or 0, math.abs(x) * (p > 0 and 1 or math.huge))
  return body == "plate" and state.distance >= 0 and z > 0 and 2 or 1
end }
sided:run()
ok(asked.plate > asked.cylinder, "the local factor is called at a larger |x| for the flat than for the ball")
local h = sided:profile("block", { x = 0 })
ok(h.h[#h.h // 2 - 2] < 0.6 * h.h[#h.h // 2 + 4], "a local factor that depends on z")
local even = run{ distance = 20 }
even:run()
near(sided.volume.ball, even.volume.ball, 1e-12, "the wear of the other body is unchanged")
local both = run{ distance = 20, local_factor = { vector = function(_, xs, ps, _, zs)
  for i = 1, #ps do ps[i] = #zs == #xs and 1 or 0 end
  return ps
end } }
both:run()
near(both.volume.block, even.volume.block, 1e-9, "local factors given as a vector")
local falling = run{ distance = 50, alpha = function(state) return state.distance / 100 end,
  k = { distance = { 0, 50 }, value = { 2e-8, 1e-9 } } }
falling:run()
near(falling.volume.total, 1.05e-8 * 10 * 50, 1e-8,
  "a coefficient that decreases with distance: total volume")
near(falling.volume.ball, 10 * (2e-8 * 50 ^ 2 / 2 - 1.9e-8 / 50 * 50 ^ 3 / 3) / 100, 1e-3,
  "a coefficient that decreases and an alpha that increases: volume of the ball")

-- --- layers with their own wear coefficients ----------------------------------------------------------
local points = {}
for i = 1, 16 do points[i] = (i - 1) / 160 end
local nearly_flat = map{ x = points, z = points, y = function(u) return 1e-9 * math.cos(20 * math.pi * u) end }
local coat = { { thickness = 1e-3, E = 200e3, k = 1e-7 } }
local function evenly(upper, lower)
  local pair = model{ geometry = "3-D", periodic = true, upper = body.map{ y = nearly_flat, layers = upper, k = upper and 1e-8 or 1e-12 },
    lower = body.block{ layers = lower, k = lower and 1e-8 or 1e-12 } }
  local coated = wear{ model = pair, load = 1, stroke = 1, distance = 4000 }
  coated:run()
  return coated
end
local expected = 1e-3 + 1e-8 * (100 * 4000 - 1e-3 / 1e-7)
near(evenly(coat).depth.upper, expected, 1e-6, "uniform wear of an upper body through its coating")
near(evenly(nil, coat).depth.lower, expected, 1e-9, "uniform wear of a lower body through its coating")
local function through(of_coat, of_base, changes)
  local layered = body.block{ k = of_base, layers = { { thickness = 0.006, E = 2e5, k = of_coat } } }
  local all = { model = { geometry = "3-D", upper = body.ball{ k = 1e-12 }, lower = layered, mesh = { size = 0.022 } }, load = 10, stroke = 0.088, distance = 1600 }
  for name, value in pairs(changes or {}) do all[name] = value end
  local coated = wear(all)
  coated:run{ distance = all.distance / 2 }
  coated:save "coat.archard"
  local resumed = wear.open "coat.archard"
  os.remove "coat.archard"
  coated:run()
  resumed:run()
  ok(resumed.depth.block == coated.depth.block, "a worn coat continues from its file with identical bits")
  return coated
end
for what, case in pairs{
  ["soft on hard"] = { 1e-7, 1e-9 }, ["hard on soft"] = { 1e-8, 3e-8, { distance = 13500 } },
  ["a groove through a soft coat"] = { 1e-7, 1e-9, { procedure = "NSP", stroke = 1, distance = 4000 } },
} do
  local changes = case[3] or {}
  local implicit = through(case[1], case[2], changes)
  changes.scheme = "explicit"
  local explicit = through(case[1], case[2], changes)
  ok(implicit.depth.block > 0.006, what .. ": depth below the coating, " .. implicit.depth.block)
  near(implicit.depth.block, explicit.depth.block, 1e-3, what .. ": implicit and explicit depths")
  near(implicit.volume.block, explicit.volume.block, 1e-3, what .. ": implicit and explicit volumes")
end

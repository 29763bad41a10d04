-- Tests of wear laws in three dimensions: powers of pressure, local factors, coefficients that change during the run.
-- Long
local tap = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/tap.lua")
local ok, near = tap.ok, tap.near

local m = model{ geometry = "3-D" }
local function run(changes)
  local all = { model = m, load = 10, stroke = 0.04, alpha = 0.3, distance = 200 }
  for name, value in pairs(changes or {}) do all[name] = value end
  return wear(all)
end

-- --- laws, and factors of cells ---------------------------------------------------------------------
for _, exponent in ipairs{ 1, -0.5 } do
  local law = { law = "power", law_exponent = exponent, law_pressure = 500, distance = 50 }
  local implicit = run(law)
  implicit:run()
  law.jump = "auto"
  local explicit = run(law)
  explicit:run()
  near(implicit.depth.ball, explicit.depth.ball, 3e-3, ("power law, exponent %g: implicit and explicit, ball"):format(exponent))
  near(implicit.volume.total, explicit.volume.total, 1e-3, "volume of implicit and explicit steps")
  law.law, law.jump = "archard", nil
  law.local_factor = function(_, _, p) return (p / 500) ^ exponent end
  local factors = run(law)
  factors:run()
  near(factors.depth.block, implicit.depth.block, 1e-4, "the law as a local factor")
end
local stops = run{ law = "threshold", law_pressure = 400, jump = "auto", distance = 20 }
stops:run()
ok(stops.volume.total < 0.99 * 1e-8 * 10 * 20, "under a threshold the edge does not wear")
local asked = {}
local sided = run{ distance = 20, local_factor = function(body, x, p, state, z)
  asked[body] = math.max(asked[body] or 0, math.abs(x) * (p > 0 and 1 or math.huge))
  return body == "plate" and state.distance >= 0 and z > 0 and 2 or 1
end }
sided:run()
ok(asked.plate > asked.cylinder, "the flat's own positions reach beyond the ball's")
local h = sided:profile("block", { x = 0 })
ok(h.h[#h.h // 2 - 2] < 0.6 * h.h[#h.h // 2 + 4], "a factor across the motion")
local even = run{ distance = 20 }
even:run()
near(sided.volume.ball, even.volume.ball, 1e-12, "the wear of the other body is unchanged")
local both = run{ distance = 20, local_factor = { vector = function(_, xs, ps, _, zs)
  for i = 1, #ps do ps[i] = #zs == #xs and 1 or 0 end
  return ps
end } }
both:run()
near(both.volume.block, even.volume.block, 1e-9, "factors of 1 in one call")
local falling = run{ distance = 50, alpha = function(state) return state.distance / 100 end,
  k = { distance = { 0, 50 }, value = { 2e-8, 1e-9 } } }
falling:run()
near(falling.volume.total, 1.05e-8 * 10 * 50, 1e-8, "a coefficient that falls with the distance: its mean")
near(falling.volume.ball, 10 * (2e-8 * 50 ^ 2 / 2 - 1.9e-8 / 50 * 50 ^ 3 / 3) / 100, 1e-3, "k that decreases and alpha that increases")

-- Tests updates within a cycle on moving surfaces. An update wears the nodes by the forces computed before
-- they are displaced; these forces balance the load. Therefore the volume is k times the load integrated over
-- the sliding distance, and the cylinder's fraction of the volume is alpha.

local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within = figures.within

local function pulsing(t) return 50 + 30 * math.cos(4 * math.pi * t) end
local function sine(t) return 0.11 * math.sin(2 * math.pi * t) end
local pulses = { x = sine, load = pulsing, increments = 8 }

local cases = { -- each row: name, fields, tolerance of the volume (nil if elastic slip contributes to the volume)
  { "explicit, stiffness recomputed at each update", { refresh = 0, jump = 1 }, 1e-12 },
  { "explicit, alpha = 0.25", { refresh = 0, jump = 1, alpha = 0.25 }, 1e-12 },
  { "implicit", { scheme = "implicit", jump = 10 }, 1e-12 },
  { "implicit, the simple rule", { scheme = "implicit", jump = 10, rule = "simple" }, 1e-12 },
  { "a pulsing load", { loading = pulses, jump = 1 }, 1e-12 },
  { "a pulsing load, plate at rest", { loading = pulses, jump = 1, procedure = "NSP", alpha = 1 }, 1e-12 },
  { "slip with its elastic part", { slip = "total", refresh = 0, jump = 1 } },
  { "slip with its elastic part, implicit", { slip = "total", refresh = 0, jump = 3, scheme = "implicit" } },
}
for _, case in ipairs(cases) do
  local what, fields, share = table.unpack(case)
  fields.k, fields.alpha, fields.update, fields.cycles = 1e-6, fields.alpha or 0.5, "increment", 3 * fields.jump
  if not fields.loading then fields.increments, fields.stroke = 8, 0.22 end
  local w = wear(fields):run()
  if share then within(w.volume.total, 1e-6 * w.load_distance, share, what .. ": volume [mm3]") end
  within(w.volume.cylinder, fields.alpha * w.volume.total, 1e-12, what .. ": volume of the cylinder [mm3]")
end

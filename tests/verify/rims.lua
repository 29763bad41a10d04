-- Tests partial slip on the default meshes, whose element sizes follow from the slip annuli: volume, energy
-- and depth after 10000 cycles against meshes of twice the fineness.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within = figures.within

local function worn(case, fineness)
  local bodies = { mesh = { fineness = fineness }, plate = case.plate }
  local w = wear{ model = bodies, friction = 0.6, tangential = case.force, stroke = case.stroke, loading = case.loading, k = 1e-7,
    cycles = 10000, jump = "auto" }
  return w:run{ progress = false }
end

-- Returns a loading with an alternating force and a normal load that lags by a quarter of a cycle.
local function under(swing)
  return { increments = 40, tangential = function(t) return 30 * math.sin(2 * math.pi * t) end,
    load = function(t) return 100 + swing * math.cos(2 * math.pi * t) end }
end

for label, case in pairs{
  ["0.3 mu L"] = { force = 18 }, ["0.7 mu L"] = { force = 42 }, ["0.9 mu L"] = { force = 54 }, ["0.95 mu L"] = { force = 57 },
  ["a plate of 420 GPa"] = { force = 54, plate = { E = 420e3 } }, ["a plate of 3 GPa"] = { force = 30, plate = { E = 3e3, nu = 0.35 } },
  ["a stroke"] = { stroke = 0.002 }, ["a load of 100 + 10 cos"] = { loading = under(10), off = 0.015 },
  ["a load of 100 + 40 cos"] = { loading = under(40) }, ["a plate of 420 GPa, 0.5 mu L"] = { force = 30, plate = { E = 420e3 }, off = 0.02 },
} do
  local usual, fine = worn(case, 1), worn(case, 2)
  within(usual.volume.total, fine.volume.total, case.off or 0.01, label .. ": volume")
  within(usual.energy, fine.energy, case.off or 0.01, label .. ": energy")
  within(usual.depth.plate, fine.depth.plate, 0.02, label .. ": depth")
end

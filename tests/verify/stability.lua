-- Tests the stability limit of explicit updates: a scan determines the number of cycles per update (N-bar) at
-- which a sawtooth grows, and compares it with the limit from the largest eigenvalue. The roughness is the
-- root mean square of the profile's fourth differences divided by 16 (1 for a sawtooth of amplitude 1),
-- relative to the depth, over the middle of the contact.
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")

local function roughest(w) return math.max(w:roughness("cylinder"), w:roughness("plate")) end

local function run(definition)
  local w = wear(definition)
  w:run()
  return w
end

local reference = run{ jump = 100, increments = 100 }
local smooth = roughest(reference)
figures.below(smooth, 1e-4, "s = a, alpha = 0.5, N-bar = 100, n_c = 100: roughness")
figures.below(figures.asymmetry(reference:profile("plate").h), 1e-9,
  "s = a, alpha = 0.5, N-bar = 100: asymmetry of the plate")
local fine = run{ jump = 50, increments = 200 }
figures.within(reference.depth.cylinder, fine.depth.cylinder, 2e-3,
  "s = a, alpha = 0.5: depth against N-bar = 50, n_c = 200 [mm]")
figures.within(reference.p_center, fine.p_center, 5e-3,
  "s = a, alpha = 0.5: pressure against N-bar = 50, n_c = 200 [MPa]")

local unworn = wear{}:stability().jump_limit
local worn = reference:stability().jump_limit
local limit = math.min(unworn, worn)
figures.note(("limit 2 / eigenvalue: N-bar = %.1f unworn, %.1f worn"):format(unworn, worn))

-- Increases N-bar until the roughness of a worn profile exceeds ten times its value at N-bar = 100. The first
-- such N-bar is the start of roughness.
local onset
for share = 0.80, 1.401, 0.05 do
  local jump = share * limit
  local rough = roughest(run{ jump = jump })
  figures.note(("N-bar = %.0f, %.2f of the limit: roughness %.2g"):format(jump, share, rough))
  if rough > 10 * smooth then
    onset = jump
    break
  end
end
figures.ok(onset ~= nil, ("roughness starts at N-bar = %.0f"):format(onset or 0 / 0))
figures.about(onset / limit, 1.05, 0.1501, "N-bar at the start of roughness / limit by the eigenvalue")

-- Tests that the limit of the sliding distance between updates is proportional to the element size, because the
-- shortest ripple, of one element, grows first.
local halved = wear{ model = { mesh = { size = 0.01, height = 0.0125 } } }:stability().jump_limit
figures.within(halved, unworn / 2, 0.02, "limit of N-bar with elements of half the size")

-- With alpha = 1, only the cylinder wears, with the whole coefficient k. Its contact is always in the middle
-- of its surface. The sliding distance between updates must then be below about 40 mm for matched
-- quadrilaterals of 20 x 25 um.
local alone = wear{ alpha = 1 }:stability().jump_limit
figures.note(("alpha = 1: limit N-bar = %.1f, %.1f at alpha = 0.5"):format(alone, unworn))
figures.within(2 * 0.11 * alone, 40, 0.05, "alpha = 1: sliding distance between updates at the limit [mm]")

-- Tests the search for settings: it stays below the limit of all states during the run and evaluates the
-- whole run. At alpha = 0 kinks of the plate's scar move through the contact; the search must not treat them
-- as ripples.
local search = require "archard.study.search"
for _, case in ipairs{ { 0, 0.44, 30 }, { 0, 0.22, 50 }, { 0.5, 0.22, 50 } } do
  local alpha, stroke, table_1 = table.unpack(case)
  local given = { alpha = alpha, stroke = stroke, geometry = "frozen" }
  local found = search(given, function() end)
  local what = ("alpha = %g, s = %g: "):format(alpha, stroke)
  given.jump = found.jump
  local w = wear(given)
  local lowest = w:stability().jump_limit
  while not w.done do
    w:run{ distance = math.min(1320, w.distance + 264) }
    lowest = math.min(lowest, w:stability().jump_limit)
  end
  figures.note(("%sjump %g of %.1f"):format(what, found.jump, lowest))
  figures.ok(found.jump <= lowest, what .. "the jump found does not exceed the stability limit")
  figures.within(found.limit, lowest, 0.02, what .. "the reported stability limit")
  figures.ok(found.jump >= table_1, what .. "the jump found is at least that of Table 1")
  figures.ok(found.judged == w.update, what .. "the whole run is evaluated")
end

-- Tests that the limit is computed again if coefficients increase, alpha changes or the path becomes wider,
-- and that a run below the limit gives no warning. A run with ripples ends before its pressures become
-- meaningless.
local warnings = require "archard.warnings"
warnings.keep()
local function told(fields)
  local w = wear(fields)
  local ended, problem = pcall(w.run, w, { progress = false })
  figures.ok(ended or w.p_max < 2 * w.p_center, "the pressures are meaningful until the end")
  return (warnings.take() or "") .. (ended and "" or tostring(problem))
end
local past = { -- name, fields
  { "k with a step", { stroke = 0.22, jump = 100, distance = 400,
    k = function(s) return s.distance < 271 and 1e-8 or 4e-8 end } },
  { "k that increases linearly", { stroke = 0.22, jump = 100, distance = 400,
    k = { distance = { 0, 660 }, value = { 1e-9, 5e-8 } } } },
  { "k as a function of the volume", { stroke = 0.22, jump = 100, distance = 400,
    k = function(s) return 1e-8 * (1 + s.volume.total / 2e-4) end } },
  { "alpha that increases linearly", { stroke = 0.44, jump = 60, distance = 660,
    alpha = { distance = { 0, 660 }, value = { 0, 1 } } } },
  { "a second block with a longer stroke",
    { jump = 100, loading = { { x = { -0.02, 0.02, -0.02 }, cycles = 1000 },
    { x = { -0.4, 0.4, -0.4 }, cycles = 150 } } } },
  { "a function for jump", { stroke = 0.22, distance = 200, jump = function(s) return s.distance < 99 and 10 or 200 end } },
}
for _, case in ipairs(past) do
  local text = told(case[2])
  figures.ok(text:find("past the stability limit of %d+"),
    case[1] .. ": warning about the stability limit: " .. text:sub(1, 90))
  local _, times = text:gsub("ripples will grow", "")
  figures.ok(times <= 1, case[1] .. ": at most one warning")
end
for name, fields in pairs{
  ["k that decreases"] = { jump = 100, distance = 660,
    k = function(s) return 1e-8 * math.exp(-s.distance / 500) end },
  ["k that increases below the limit"] = { jump = 20, distance = 660,
    k = { distance = { 0, 660 }, value = { 1e-9, 3e-8 } } },
  ["auto"] = { scheme = "explicit", stroke = 0.22, distance = 400, k = { distance = { 0, 660 }, value = { 1e-9, 5e-8 } } },
  ["sliding out of the plane, few increments"] = { slide = "z", stroke = 1, increments = 10, jump = 2,
    distance = 100 },
  ["a law that jumps"] = { law = "threshold", law_pressure = 250, stroke = 0.22, alpha = 0.4, jump = 1000 },
} do
  figures.ok(told(fields) == "", name .. ": no warning")
end

-- Tests random pairs worn with implicit steps until the scar has 1.2 to 12 unworn half widths: depths at four
-- distances against runs with a tenth of the tolerance.
--   ARCHARD_RUNS=300 tests/run verify/random_scars   more runs

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
warn "@off"
math.randomseed(23)

local function between(low, high) return low * (high / low) ^ math.random() end

-- Returns the definition of a random run to a scar of 1.2 to 12 unworn half widths, and true if R > 8 half widths.
local function random_run()
  local radius, load = between(1, 200), between(10, 500)
  local pair = { radius = radius, cylinder = { E = between(3e3, 4e5) }, plate = { E = between(3e3, 4e5) } }
  local half = hertz{ radius = radius, load = load, cylinder = pair.cylinder, plate = pair.plate }.half_width
  local wide, distance = between(1.2, 12), 1320
  return { model = pair, load = load, stroke = half * between(0.1, 8), alpha = math.random(), distance = distance,
    k = 2 / 3 * (wide * half) ^ 3 / radius / (load * distance), slide = math.random() < 0.3 and "z" or "x",
    scheme = "implicit" }, half < radius / 8
end

local function depths(fields, tolerance)
  fields.tolerance = tolerance
  local w, list = wear(fields), {}
  for _, share in ipairs{ 0.02, 0.1, 0.3, 1 } do
    w:run{ distance = share * fields.distance, progress = false }
    list[#list + 1], list[#list + 2] = w.depth.cylinder, w.depth.plate
  end
  return list, w.update
end

local runs, refused, worst, most, longest = 0, 0, 0, 0, 0
while runs < (tonumber(os.getenv "ARCHARD_RUNS") or 12) do
  local fields, flat = random_run()
  local fine, list, updates = false, nil, nil
  local start = os.clock()
  if flat then fine, list, updates = pcall(depths, fields, 1e-3) end
  longest = math.max(longest, os.clock() - start)
  if fine then
    runs = runs + 1
    for i, depth in ipairs((depths(fields, 1e-4))) do
      if depth > 0 then worst = math.max(worst, math.abs(list[i] / depth - 1)) end
    end
    most = math.max(most, updates)
  elseif flat then
    refused = refused + 1
    local why = tostring(list)
    figures.ok(why:find("no larger mesh fits", 1, true) or why:find("the largest number that fits", 1, true),
      "a run is refused only if its scar is wider than the bodies")
  end
end
-- Tests the reference pair, worn to a scar of ten half widths on automatically enlarged meshes.
local wide = { k = 1e-5, distance = 2000, scheme = "implicit" }
local list, updates = depths(wide, 1e-3)
for i, depth in ipairs((depths(wide, 1e-4))) do
  figures.within(list[i], depth, 5e-4, ("reference pair, k = 1e-5: depth %d [mm]"):format(i))
end
figures.below(updates, 100, "reference pair, k = 1e-5: number of updates")

-- Tests grooves of strokes much longer than the contact, in which the depth increases slowly.
for _, k in ipairs{ 1e-6, 1e-5 } do
  local groove = { k = k, alpha = 0, stroke = 2, distance = 400, scheme = "implicit" }
  local few, count = depths(groove, 1e-3)
  for i, depth in ipairs((depths(groove, 1e-4))) do
    if depth > 0 then figures.within(few[i], depth, 5e-4, ("groove, k = %g: depth %d [mm]"):format(k, i)) end
  end
  figures.below(count, 40, ("groove, k = %g: number of updates"):format(k))
end

-- Tests a stroke of one element: long steps of the implicit scheme converge only if each part of the stroke
-- has its own Jacobian.
local _, short = depths({ model = { radius = 42.317, cylinder = { E = 372e3 }, plate = { E = 18114 } }, load = 34.81, stroke = 0.05842,
  alpha = 0.61729, distance = 1320, k = 3.5677e-6, scheme = "implicit" }, 1e-3)
figures.below(short, 60, "a stroke of one element: number of updates")

figures.below(worst, 1e-3, ("largest error of the depths of %d runs at four distances"):format(runs))
figures.below(most, 100, "largest number of updates of a random run")
figures.below(refused, 0.1 * runs, "number of runs refused because the scar is wider than the bodies")
print(("# the longest took %.1f s"):format(longest))

-- Tests runs in three dimensions whose contact becomes much wider than the unworn one, so that their cells are
-- doubled: depths against runs on cells that stay, volumes, files, workers, exchange of bodies.

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local within = figures.within

local ball, flat = body.ball{ radius = 6 }, body.block{}
local half = hertz{ geometry = "3-D", radius = 6, load = 10 }.half_width

local function definition(changes)
  local all = { model = { geometry = "3-D", upper = ball, lower = flat }, load = 10, k = 1e-6, stroke = 0.3, alpha = 0.5,
    distance = 60 }
  for name, value in pairs(changes or {}) do all[name] = value end
  if all.track then all.stroke = nil end
  return all
end

local function run(changes)
  local w = wear(definition(changes))
  w:run{ progress = false }
  return w
end

local function cell(w, axis)
  local at = w:map("upper")[axis]
  return at[2] - at[1]
end

local function on_cells(size) return { geometry = "3-D", upper = ball, lower = flat, mesh = { size = size } } end

-- Cells are doubled across the motion, and along it if the stroke has enough of them.
for _, case in ipairs{
  { "both bodies", {}, 1, 2 }, { "the ball alone", { alpha = 1, distance = 20 }, 2, 2 },
  { "a long stroke", { stroke = 1, distance = 160 }, 2, 2 }, { "a groove", { procedure = "NSP", stroke = 5, distance = 300 }, 2, 2 },
  { "a pin on a disc", { track = 5, distance = 600 }, 4, 4, 2e-3 },
} do
  local name, changes = case[1], case[2]
  local w = run(changes)
  changes.model = on_cells(half / 8)
  local same = run(changes)
  figures.about(cell(w, "x") / half * 8, case[3], 0.1 * case[3], name .. ": cells along the motion, divided by those at the start")
  figures.about(cell(w, "z") / half * 8, case[4], 0.1 * case[4], name .. ": cells across the motion, divided by those at the start")
  for _, side in ipairs{ "upper", "lower" } do
    if same.depth[side] > 0 then within(w.depth[side], same.depth[side], case[5] or 5e-4, name .. ": depth of the " .. side .. " body [mm]") end
  end
  within(w.volume.total, 1e-6 * 10 * w.distance, 1e-12, name .. ": volume [mm3]")
end

-- The surfaces of a run are those of its last update, also if its cells are about to be doubled.
local ended = run{ distance = 20 }
local deepest = 0
for _, y in ipairs(ended:map("upper").y) do deepest = math.max(deepest, y) end
figures.ok(deepest == ended.depth.upper, "the largest depth of the map is that of the run")
within(contact{ model = ended.model, load = 10, worn = ended }.p_max, ended.p_max, 1e-9, "the pressure of a contact of the worn bodies [MPa]")
local along_z = run{ slide = "z", distance = 40 }
figures.ok(tostring(along_z):find "47 x 51 cells of 0.01875 x 0.009375 mm", "the cells of a run along z are printed with those along x first")

-- --- files, workers, exchange of bodies --------------------------------------------------------------
local function same_bits(a, b, what)
  local wrong = a.update == b.update and 0 or 1
  for _, side in ipairs{ "upper", "lower" } do
    local one, other = a:map(side), b:map(side)
    for i = 1, #one.y do if one.y[i] ~= other.y[i] then wrong = wrong + 1 end end
  end
  figures.ok(wrong == 0, what)
end

local stroke = { stroke = 1, distance = 160 }
local whole, parts, file = run(stroke), wear(definition(stroke)), os.tmpname() .. ".archard"
local first = cell(parts, "z")
while parts.update < whole.update do
  parts:save(file)
  parts = wear.open(file)
  parts:step()
end
os.remove(file)
figures.ok(cell(parts, "z") > 1.5 * first and cell(parts, "x") > 1.5 * first, "the cells of this run were doubled")
same_bits(parts, whole, "a run saved and opened before each step has identical bits")
stroke.workers = 2
same_bits(run(stroke), whole, "two workers give identical bits")

local even = { scheme = "implicit", jump = 4, alpha = 0.25, distance = 40 }
local straight = run(even)
even.model, even.alpha = { geometry = "3-D", upper = flat, lower = ball }, 0.75
local turned = run(even)
figures.ok(cell(straight, "z") > 1.5 * half / 8 and cell(turned, "z") > 1.5 * half / 8, "both runs have doubled cells")
within(turned.depth.upper, straight.depth.lower, 1e-9, "exchange of bodies: depth of the flat [mm]")
within(turned.depth.lower, straight.depth.upper, 1e-9, "exchange of bodies: depth of the ball [mm]")

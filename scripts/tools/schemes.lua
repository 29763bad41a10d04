-- Explicit against implicit updates: error of the depths, updates, contact solutions and seconds of
-- four cases at several element sizes, as a Markdown table.
--   archard scripts/tools/schemes.lua [size in um ...]      20, 10 and 5 where none is given
-- The reference of a case is extrapolated from explicit runs with a fifth and a tenth of Table 1's
-- N-bar, scaled with the element size (ripples grow faster on finer meshes).

local paper = require "archard.study.paper"
local cases = {}
for stroke, alpha in ipairs{ 3, 2, 4, 3 } do -- positions in Table 1
  cases[stroke] = { name = ("%s, %g"):format(paper.stroke_names[stroke], paper.alphas[alpha]),
    stroke = paper.strokes[stroke], alpha = paper.alphas[alpha], jump = paper.jumps[alpha][stroke] }
end
local schemes = {
  { "explicit, N-bar of Table 1", function(jump) return { jump = jump } end },
  { 'explicit, jump = "auto"', function() return { jump = "auto" } end },
  { "implicit, tolerance = 1e-3", function() return { scheme = "implicit", tolerance = 1e-3 } end },
}

-- A model for all runs on one mesh: those of one case share it.
local function run(case, size, fields)
  fields.stroke, fields.alpha = case.stroke, case.alpha
  fields.model = { mesh = { size = size, height = 1.25 * size } }
  local w = wear(fields)
  local start = os.clock()
  w:run{ progress = false }
  return w, os.clock() - start
end

-- What explicit updates tend to: linear in their length, so twice the finer minus the coarser.
local function reference(case, size, jump)
  local coarse, fine = run(case, size, { jump = jump / 5 }), run(case, size, { jump = jump / 10 })
  return {
    cylinder = 2 * fine.depth.cylinder - coarse.depth.cylinder,
    plate = 2 * fine.depth.plate - coarse.depth.plate,
    p_center = 2 * fine.p_center - coarse.p_center,
  }
end

local function percent(got, expected) return 100 * math.abs(got / expected - 1) end

local function row(size, case, scheme, true_values)
  local w, seconds = run(case, size, scheme[2](case.jump * size / 0.020))
  local depth = math.max(percent(w.depth.cylinder, true_values.cylinder), percent(w.depth.plate, true_values.plate))
  print(("| %g | %s | %s | %.3f | %.3f | %d | %d | %.2f |"):format(1e3 * size, case.name, scheme[1], depth,
    percent(w.p_center, true_values.p_center), w.update, w.solutions, seconds))
  io.stdout:flush()
end

local sizes = { ... }
if #sizes == 0 then sizes = { 20, 10, 5 } end
print("| element [um] | stroke, alpha | updates | error of the depths [%] | of the centre pressure [%] |"
  .. " number | contact solutions | CPU [s] |")
print("|---|---|---|---|---|---|---|---|")
for _, um in ipairs(sizes) do
  local size = tonumber(um) / 1e3
  for _, case in ipairs(cases) do
    local true_values = reference(case, size, case.jump * size / 0.020)
    for _, scheme in ipairs(schemes) do row(size, case, scheme, true_values) end
  end
end

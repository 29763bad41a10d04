-- Explicit against implicit updates: error of the depths, updates, contact solutions and seconds of
-- four cases at several element sizes, as a Markdown table.
--   archard scripts/tools/schemes.lua [size in um ...]      20, 10 and 5 where none is given
-- Errors are the largest at any stored update, and those at the end. The reference of a case is
-- extrapolated from explicit runs with a fifth and a tenth of Table 1's N-bar, scaled with the element
-- size (ripples grow faster on finer meshes), and interpolated to the distances of the updates.

local at = require "archard.lib.history_at"
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

-- One model for all runs of a case on one mesh.
local function run(case, size, fields)
  fields.stroke, fields.alpha = case.stroke, case.alpha
  fields.model = { mesh = { size = size, height = 1.25 * size } }
  local w = wear(fields)
  local start = os.clock()
  w:run{ progress = false }
  return w, os.clock() - start
end

-- Explicit runs whose errors, linear in the length of their updates, cancel in twice the finer minus the coarser.
local function reference(case, size, jump)
  return { coarse = run(case, size, { jump = jump / 5 }).history, fine = run(case, size, { jump = jump / 10 }).history }
end

-- Errors of a column in percent: the largest at any update, and that at the end.
local function errors(history, column, true_runs)
  local worst, off = 0, 0
  for i = 2, #history.distance do
    local distance = history.distance[i]
    local expected = 2 * at(true_runs.fine, column, distance) - at(true_runs.coarse, column, distance)
    off = 100 * math.abs(history[column][i] / expected - 1)
    worst = math.max(worst, off)
  end
  return worst, off
end

local function row(size, case, scheme, true_runs)
  local w, seconds = run(case, size, scheme[2](case.jump * size / 0.020))
  local history = w.history
  local worst_c, end_c = errors(history, "depth_cylinder", true_runs)
  local worst_p, end_p = errors(history, "depth_plate", true_runs)
  local worst, last = errors(history, "p_center", true_runs)
  print(("| %g um | %s | %s | %.2f %% | %.2f %% | %.3f %% | %.3f %% | %d | %d | %.2f s |"):format(1e3 * size, case.name,
    scheme[1], math.max(worst_c, worst_p), worst, math.max(end_c, end_p), last, w.update, w.solutions, seconds))
  io.stdout:flush()
end

local sizes = { ... }
if #sizes == 0 then sizes = { 20, 10, 5 } end
print("| element | case | updates | worst depth error | worst pressure error | depth at the end | pressure at the end |"
  .. " steps | solutions | CPU |")
print("|---|---|---|---|---|---|---|---|---|---|")
for _, um in ipairs(sizes) do
  local size = tonumber(um) / 1e3
  for _, case in ipairs(cases) do
    local true_runs = reference(case, size, case.jump * size / 0.020)
    for _, scheme in ipairs(schemes) do row(size, case, scheme, true_runs) end
  end
end

-- Compares explicit and implicit updates in the 20 cases of Table 1 of the paper at several element sizes.
-- Prints errors, updates, contact solutions and seconds as a Markdown table. A row contains the five alphas
-- of a stroke.
--
--   archard scripts/tools/schemes.lua [size in um ...]      default: 20, 10 and 5
--
-- A row has the largest errors of its five cases: at any stored update, and at the end. The reference of a
-- case is extrapolated from two explicit runs, with a fifth and a tenth of Table 1's cycles per update, and
-- interpolated at the distances of the updates. The cycles per update are proportional to the element size,
-- because ripples grow faster on finer meshes.

local at = require "archard.lib.history_at"
local paper = require "archard.study.paper"
local schemes = {
  { "explicit, jump of Table 1", function(jump) return { jump = jump } end },
  { "explicit, automatic", function() return { scheme = "explicit" } end },
  { "implicit, tolerance = 1e-3", function() return { scheme = "implicit", tolerance = 1e-3 } end },
}

-- Runs a case. Returns the run and its CPU seconds.
local function run(case, model, fields)
  fields.stroke, fields.alpha, fields.model = case.stroke, case.alpha, model
  local w = wear(fields)
  local start = os.clock()
  w:run{ progress = false }
  return w, os.clock() - start
end

-- Runs a case explicitly with two different cycles per update. The errors are proportional to the cycles per
-- update, so they cancel in twice the finer result minus the coarser result.
local function reference(case, model)
  return { coarse = run(case, model, { jump = case.jump / 5 }).history, fine = run(case, model, { jump = case.jump / 10 }).history }
end

-- Returns two errors of a history column in percent: the largest at any update, and the one at the end.
-- Errors of a body without wear are 0.
local function errors(history, column, true_runs)
  local worst, off = 0, 0
  for i = 2, #history.distance do
    local distance = history.distance[i]
    local expected = 2 * at(true_runs.fine, column, distance) - at(true_runs.coarse, column, distance)
    off = history[column][i] == expected and 0 or 100 * math.abs(history[column][i] / expected - 1)
    worst = math.max(worst, off)
  end
  return worst, off
end

-- Runs a case and adds its results to a row: the largest errors, the range of the numbers of updates and of
-- solutions, and the sum of the seconds.
local function add(row, case, model, scheme, true_runs)
  local w, seconds = run(case, model, scheme[2](case.jump))
  for _, name in ipairs{ "depth_cylinder", "depth_plate", "p_center" } do
    local what = name == "p_center" and "pressure" or "depth"
    local worst, last = errors(w.history, name, true_runs)
    row[what] = math.max(row[what] or 0, worst)
    row[what .. "_end"] = math.max(row[what .. "_end"] or 0, last)
  end
  for name, value in pairs{ updates = w.update, solutions = w.solutions } do
    local range = row[name] or { value, value }
    row[name] = { math.min(range[1], value), math.max(range[2], value) }
  end
  row.seconds = (row.seconds or 0) + seconds
end

local function range(of) return of[1] == of[2] and of[1] or ("%d to %d"):format(of[1], of[2]) end

local sizes = { ... }
if #sizes == 0 then sizes = { 20, 10, 5 } end
print("| element | stroke | scheme | worst depth error | worst pressure error | depth at the end | pressure at the end |"
  .. " updates | solutions | CPU time of five cases |")
print("|---|---|---|---|---|---|---|---|---|---|")
for _, um in ipairs(sizes) do
  local size = tonumber(um) / 1e3
  local model = model{ mesh = { size = size, height = 1.25 * size } }
  for i, stroke in ipairs(paper.strokes) do
    local rows = { {}, {}, {} }
    for _, case in ipairs(paper.cases(size)) do
      if case.stroke == stroke then
        local true_runs = reference(case, model)
        for r, scheme in ipairs(schemes) do add(rows[r], case, model, scheme, true_runs) end
      end
    end
    for r, row in ipairs(rows) do
      print(("| %g um | %s | %s | %.2f %% | %.2f %% | %.3f %% | %.3f %% | %s | %s | %.2f s |"):format(1e3 * size,
        paper.stroke_names[i], schemes[r][1], row.depth, row.pressure, row.depth_end, row.pressure_end,
        range(row.updates), range(row.solutions), row.seconds))
    end
    io.stdout:flush()
  end
end

-- Cases of the paper (Mattei and Di Puccio): Table 1 with its cycles per update, and the runs of the
-- convergence study.

local paper = {}

paper.alphas = { 0, 0.25, 0.5, 0.75, 1 }
paper.strokes = { 0.11, 0.22, 0.44, 20 }
paper.stroke_names = { "a", "2a", "4a", "2R" }
paper.increments = 100

-- Cycles per update, with a row for each alpha and a column for each stroke. The case with alpha 0 and stroke
-- 2R needs no finite elements, so it has no number.
paper.jumps = {
  { 75, 50, 30 },
  { 100, 40, 25, 1 },
  { 100, 50, 30, 1 },
  { 100, 40, 20, 1 },
  { 100, 50, 30, 1 },
}

-- Returns an upper estimate of the depth of the first update [mm], Eq. (28). jump: cycles per update; p:
-- pressure [MPa]; k: wear coefficient [mm²/N]; stroke: [mm]. A cycle has two strokes, or one if the stroke is
-- 2R, the last of paper.strokes.
function paper.first_depth(jump, k, p, stroke)
  local strokes = stroke == paper.strokes[4] and 1 or 2
  return jump * k * p * strokes * stroke
end

-- Element size in the paper. Ripples with the length of an element grow first, so smaller elements need fewer
-- cycles per update: these are reduced in proportion.
local paper_size = 0.020 -- mm

-- Returns the settings of the 20 cases of Table 1 for elements of `size` [mm].
function paper.cases(size)
  local cases, share = {}, math.min(1, (size or paper_size) / paper_size)
  for row, alpha in ipairs(paper.alphas) do
    for column, stroke in ipairs(paper.strokes) do
      cases[#cases + 1] = { alpha = alpha, stroke = stroke, increments = paper.increments,
        jump = share * (paper.jumps[row][column] or 1) }
    end
  end
  return cases
end

-- Element sizes [mm] of paper.mesh_cases(). Its cases have the stroke a and all alpha > 0, and show the
-- influence of the mesh.
paper.sizes = { 0.020, 0.010, 0.005 }

function paper.mesh_cases()
  local cases = {}
  for _, size in ipairs(paper.sizes) do
    for _, case in ipairs(paper.cases(size)) do
      if case.stroke == paper.strokes[1] and case.alpha > 0 then
        case.geometry = "frozen" -- compared with "moving", depths and pressures change by less than 1e-4
        case.model = { mesh = { size = size, height = 1.25 * size } }
        cases[#cases + 1] = case
      end
    end
  end
  return cases
end

-- The runs of Fig. 8 as { increments, jump }. paper.trial_cases() returns them for both integration rules,
-- with stroke a, alpha 0.5 and 1000 cycles.
paper.trials = { { 40, 50 }, { 40, 100 }, { 40, 200 }, { 200, 50 }, { 200, 100 }, { 200, 200 },
  { 16, 100 }, { 100, 100 } }

function paper.trial_cases()
  local cases = {}
  for _, rule in ipairs{ "trapezoid", "simple" } do
    for _, trial in ipairs(paper.trials) do
      cases[#cases + 1] = { alpha = 0.5, stroke = 0.11, cycles = 1000, increments = trial[1],
        jump = trial[2], rule = rule }
    end
  end
  return cases
end

return paper

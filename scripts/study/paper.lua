-- The paper's cases: Table 1 with its cycles per update, and the runs of its convergence example.

local paper = {}

paper.alphas = { 0, 0.25, 0.5, 0.75, 1 }
paper.strokes = { 0.11, 0.22, 0.44, 20 }
paper.stroke_names = { "a", "2a", "4a", "2R" }
paper.increments = 100

-- By alpha, then stroke. The one without a number needs no finite elements.
paper.jumps = {
  { 75, 50, 30 },
  { 100, 40, 25, 1 },
  { 100, 50, 30, 1 },
  { 100, 40, 20, 1 },
  { 100, 50, 30, 1 },
}

-- Eq. (28) [mm]: the depth of the first update, overestimated. p in MPa; a cycle over the whole
-- plate (the last stroke) goes one way only.
function paper.first_depth(jump, k, p, stroke)
  local strokes = stroke == paper.strokes[4] and 1 or 2
  return jump * k * p * strokes * stroke
end

-- The settings of the twenty cases.
function paper.cases()
  local cases = {}
  for row, alpha in ipairs(paper.alphas) do
    for column, stroke in ipairs(paper.strokes) do
      cases[#cases + 1] = { alpha = alpha, stroke = stroke, increments = paper.increments,
        jump = paper.jumps[row][column] or 1 }
    end
  end
  return cases
end

-- Fig. 8: stroke a, alpha 0.5, at 1000 cycles; { increments, jump }.
paper.trials = { { 40, 50 }, { 40, 100 }, { 40, 200 }, { 200, 50 }, { 200, 100 }, { 200, 200 },
  { 16, 100 }, { 100, 100 } }

function paper.trial_cases()
  local cases = {}
  for i, trial in ipairs(paper.trials) do
    cases[i] = { alpha = 0.5, stroke = 0.11, cycles = 1000, increments = trial[1],
      jump = trial[2] }
  end
  return cases
end

return paper

-- A study of nine cases, its table, and the case with the least wear of the plate. A second call reads the
-- results from the run file instead of computing them.
--   archard examples/10_study.lua [run file]
local s = study{
  name = "strokes",
  base = { distance = 660, increments = 40 },
  vary = { alpha = { 0.25, 0.5, 0.75 }, stroke = { 0.11, 0.22, 0.44 } },
}
-- Longer strokes need fewer cycles between updates. The list of cases is therefore replaced.
local cases = {}
for i, case in ipairs(s:cases()) do
  cases[i] = { alpha = case.alpha, stroke = case.stroke, jump = math.floor(11 / case.stroke) }
end
s = study{ name = "strokes", base = { distance = 660, increments = 40 }, cases = cases }

s:run{ file = arg[1] or "strokes.archard" }
print(s:table())

local best
for _, case in ipairs(s:cases()) do
  if not best or case.depth.plate < best.depth.plate then best = case end
end
print(best)
plot.profile(best)

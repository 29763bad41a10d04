-- Runs a study of a few seconds, for tests that interrupt a study. Usage: long_study.lua FILE [WORKERS [JUMP]],
-- where JUMP is the number of cycles per update.
local jump = tonumber(arg[3]) or 2
study{
  base = { geometry = "frozen", increments = 100, jump = jump, distance = 440,
    model = { mesh = { size = 0.04, height = 0.05 } } },
  vary = { alpha = { 0.25, 0.5, 0.75 }, stroke = { 0.11, 0.15, 0.2 }, load = { 80, 100 } },
}:run{ file = arg[1], workers = tonumber(arg[2]) or 2 }

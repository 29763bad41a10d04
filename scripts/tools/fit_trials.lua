-- Fits noisy data many times. Counts how often the true values are in the 95 % ranges, and measures the time
-- of a fit.
--
--   archard scripts/tools/fit_trials.lua [TRIALS]      default: 100
local trial, kinds = dofile("tests/verify/lib/fit_trials.lua")
local count = tonumber(arg[1]) or 100

for _, kind in ipairs(kinds) do
  local hits, longest, total = {}, 0, 0
  for seed = 1, count do
    local inside, seconds = trial(seed, kind)
    for name, is_in in pairs(inside) do hits[name] = (hits[name] or 0) + (is_in and 1 or 0) end
    longest, total = math.max(longest, seconds), total + seconds
  end
  for _, name in ipairs(require "archard.lib.keys"(hits)) do
    print(("%-10s %-17s inside the range in %d of %d fits"):format(kind, name, hits[name], count))
  end
  print(("%-10s a fit takes %.2f s on average, %.2f s at most (processor time)"):format(kind,
    total / count, longest))
end

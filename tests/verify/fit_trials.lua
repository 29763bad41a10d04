-- Tests fits to simulated data with known true values: counts how often the true values are in the 95 %
-- ranges of the fit. Runs a few of the hundred trials of scripts/tools/fit_trials.lua with fixed seeds.

-- Long
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/../lua/lib/tap.lua")
local trial, kinds = dofile(here .. "/lib/fit_trials.lua")

local count = 12

for _, kind in ipairs(kinds) do
  local hits, tried = 0, 0
  for seed = 1, count do
    for _, is_in in pairs((trial(seed, kind))) do hits, tried = hits + (is_in and 1 or 0), tried + 1 end
  end
  tap.note(("%s: %d of %d true values in their 95 %% ranges"):format(kind, hits, tried))
  tap.ok(hits >= 0.85 * tried, kind .. ": most true values are in their ranges")
end

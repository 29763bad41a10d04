-- Cycles per update of the geometry: fixed and automatic numbers, with their errors. A fixed number must be
-- below the stability limit, above which ripples grow. Below the limit, the error increases with the
-- number. By default steps are implicit, and their lengths follow an estimate of the error.
--   archard examples/04_steps.lua

local m = model{}
local exact = wear{ model = m, jump = 5 }
print(("ripples grow past %.0f cycles an update on the unworn surfaces\n"):format(exact:stability().jump_limit))
exact:run{ progress = false }

local choices = {
  { "jump = 200", { jump = 200 } },
  { "jump = 100", { jump = 100 } },
  { "jump = 25", { jump = 25 } },
  { 'scheme = "explicit"', { scheme = "explicit" } },
  { "default: implicit", {} },
}
print(("%-20s %8s %10s %15s %9s"):format("", "updates", "solutions", "plate error", "seconds"))
local chosen, titles = {}, {}
for _, choice in ipairs(choices) do
  local definition = choice[2]
  definition.model = m
  local start = os.clock()
  local w = wear(definition):run{ progress = false }
  print(("%-20s %8d %10d %13.3f %% %8.2f"):format(choice[1], w.update, w.solutions,
    100 * (w.depth.plate / exact.depth.plate - 1), os.clock() - start))
  chosen[#chosen + 1], titles[#titles + 1] = w, choice[1]
end
print()

plot.history(chosen[2], chosen[4], chosen[5], "jump", { titles = { titles[2], titles[4], titles[5] },
  title = "Cycles in one update" })

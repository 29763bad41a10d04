-- Prints the failed cases and the warnings of a study on standard error.

local most_warnings = 3 -- up to this number, each warning has its own line; more warnings share one line

return function(failed, warned)
  local function print_line(text, ...) io.stderr:write("study: ", text:format(...), "\n") end
  for _, case in ipairs(failed) do
    print_line("case %d (%s) failed: %s", case.id, case.label, case.message)
  end
  table.sort(warned, function(a, b) return a.id < b.id end)
  for i = 1, #warned <= most_warnings and #warned or 0 do
    print_line("case %d (%s): warning: %s", warned[i].id, warned[i].label, warned[i].message)
  end
  if #warned <= most_warnings then return end
  local ids = {}
  for i, case in ipairs(warned) do ids[i] = case.id end
  print_line("%d cases (%s) have warnings, for example case %d (%s): %s", #warned, table.concat(ids, ", "),
    warned[1].id, warned[1].label, warned[1].message)
end

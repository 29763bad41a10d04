-- quiet(f, ...) calls f with the engine's warnings switched off and returns the results of f. Searches use
-- it for contacts and runs that the user did not request. After an error of f, the warnings are switched
-- on again too.

return function(f, ...)
  warn "@off"
  local results = table.pack(pcall(f, ...))
  warn "@on"
  if not results[1] then error(results[2], 0) end
  return table.unpack(results, 2, results.n)
end

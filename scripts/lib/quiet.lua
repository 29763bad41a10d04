-- quiet(f, ...) -> results of f: calls f with the engine's warnings switched off, for contacts and runs of a search,
-- whose warnings the user did not cause. They are switched on again also after an error.

return function(f, ...)
  warn "@off"
  local results = table.pack(pcall(f, ...))
  warn "@on"
  if not results[1] then error(results[2], 0) end
  return table.unpack(results, 2, results.n)
end

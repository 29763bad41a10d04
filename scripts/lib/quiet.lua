-- quiet(f, ...) -> what f returns: the engine's warnings are off meanwhile, and on again afterwards, also after
-- an error. For contacts and runs that a search makes by itself, whose warnings the user did not cause.

return function(f, ...)
  warn "@off"
  local results = table.pack(pcall(f, ...))
  warn "@on"
  if not results[1] then error(results[2], 0) end
  return table.unpack(results, 2, results.n)
end

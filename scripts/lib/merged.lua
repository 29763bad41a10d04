-- Returns a new table with the fields of all given tables. Later tables have priority; nil is ignored.
return function(...)
  local all = {}
  for i = 1, select("#", ...) do
    for name, value in pairs((select(i, ...)) or {}) do all[name] = value end
  end
  return all
end

-- (table) -> its keys as a sorted list: texts or numbers, not both. Leans on nothing.
return function(values)
  local keys = {}
  for key in pairs(values) do keys[#keys + 1] = key end
  table.sort(keys)
  return keys
end

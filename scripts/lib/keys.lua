-- (table) -> its keys as a sorted list; the keys must be all strings or all numbers.
return function(values)
  local keys = {}
  for key in pairs(values) do keys[#keys + 1] = key end
  table.sort(keys)
  return keys
end

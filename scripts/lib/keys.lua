-- Returns the keys of a table as a sorted list. The keys must be all strings or all numbers.
return function(values)
  local keys = {}
  for key in pairs(values) do keys[#keys + 1] = key end
  table.sort(keys)
  return keys
end

-- history_at(history, column, distance) returns the value of a column of the history at a distance [mm]. It
-- interpolates by a cubic polynomial through four rows, or fewer if the history is shorter. NaN at the
-- start of a column is ignored (the partition of depths is undefined in the unworn state). For smaller
-- distances, the first number of the column is returned.
return function(history, column, distance)
  local x, y, start = history.distance, history[column], 1
  while start < #x and y[start] ~= y[start] do start = start + 1 end
  if start > 1 and distance <= x[start] then return y[start] end
  local low = start
  while low < #x - 1 and x[low + 1] <= distance do low = low + 1 end
  local first, sum = math.max(start, math.min(low - 1, #x - 3)), 0
  local last = math.min(first + 3, #x)
  for i = first, last do
    local share = 1
    for j = first, last do
      if j ~= i then share = share * (distance - x[j]) / (x[i] - x[j]) end
    end
    sum = sum + share * y[i]
  end
  return sum
end

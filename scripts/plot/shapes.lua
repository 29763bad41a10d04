-- Functions for curves: scale values, and make the filled area between two curves.

local shapes = {}

function shapes.scaled(list, factor)
  if factor == 1 then return list end
  local result = {}
  for i = 1, #list do result[i] = list[i] * factor end
  return result
end

-- Returns the filled area between two curves over x, as a closed curve along `low` and back along `high`. The
-- values of both curves are multiplied by `factor`.
function shapes.area(x, low, high, factor)
  local xs, ys = table.move(x, 1, #x, 1, {}), {}
  for i = 1, #x do ys[i] = low[i] * factor end
  for i = #x, 1, -1 do xs[#xs + 1], ys[#ys + 1] = x[i], high[i] * factor end
  return { x = xs, y = ys, style = "filled", series = 1 }
end

return shapes

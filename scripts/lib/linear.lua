-- linear(a, b, least) solves a x = b for all columns of b by Gauss-Jordan elimination with pivoting. It
-- returns b, which then contains x, or nil if a pivot is below `least`. Both matrices are lists of rows and
-- are overwritten.
return function(a, b, least)
  local n = #a
  for i = 1, n do
    local best = i
    for r = i + 1, n do if math.abs(a[r][i]) > math.abs(a[best][i]) then best = r end end
    a[i], a[best], b[i], b[best] = a[best], a[i], b[best], b[i]
    if not (math.abs(a[i][i]) >= least) then return nil end
    for r = 1, n do
      local share = r ~= i and a[r][i] / a[i][i] or 0
      for c = i, n do a[r][c] = a[r][c] - share * a[i][c] end
      for c = 1, #b[r] do b[r][c] = b[r][c] - share * b[i][c] end
    end
  end
  for i = 1, n do for c = 1, #b[i] do b[i][c] = b[i][c] / a[i][i] end end
  return b
end

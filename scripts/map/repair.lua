-- Replaces missing values and outliers of a measured map.

local noise = require "archard.profile.noise"

local repair = {}

-- Calls f(index) for each neighbour of the point (i, j). A point has up to eight neighbours.
local function each_neighbour(nx, nz, i, j, f)
  for a = math.max(1, i - 1), math.min(nx, i + 1) do
    for b = math.max(1, j - 1), math.min(nz, j + 1) do
      if a ~= i or b ~= j then f((a - 1) * nz + b) end
    end
  end
end

-- Returns the values of the neighbours of a point. Neighbours without a value are omitted.
local function values_around(y, nx, nz, i, j)
  local list = {}
  each_neighbour(nx, nz, i, j, function(k) if y[k] == y[k] then list[#list + 1] = y[k] end end)
  return list
end

local function median(list)
  table.sort(list)
  local middle = #list // 2
  return #list % 2 == 1 and list[middle + 1] or (list[middle] + list[middle + 1]) / 2
end

-- Returns the number of points without a value, and the index of the first one.
function repair.count_missing(y)
  local count, first = 0, nil
  for k = 1, #y do if y[k] ~= y[k] then count, first = count + 1, first or k end end
  return count, first
end

-- Replaces each value that differs from the median of its neighbours by more than `limit` times the scatter
-- of these differences. Returns the number of replaced points.
function repair.outliers(y, nx, nz, limit)
  local middle, off = {}, {}
  for i = 1, nx do
    for j = 1, nz do
      local k = (i - 1) * nz + j
      local around = y[k] == y[k] and values_around(y, nx, nz, i, j) or {}
      middle[k] = #around > 0 and median(around) or y[k]
      if y[k] == y[k] then off[#off + 1] = y[k] - middle[k] end
    end
  end
  local threshold, count = limit * (#off > 0 and noise.robust(off) or 0), 0
  for k = 1, #y do
    if math.abs(y[k] - middle[k]) > threshold then y[k], count = middle[k], count + 1 end
  end
  return count
end

-- Fills missing values with the mean of their neighbours, ring by ring from the edge of each hole. Returns
-- the indices of the filled points.
local function grow(y, nx, nz)
  local holes = {}
  for k = 1, #y do if y[k] ~= y[k] then holes[#holes + 1] = k end end
  local all = table.move(holes, 1, #holes, 1, {})
  while #holes > 0 do
    local left, found = {}, {}
    for _, k in ipairs(holes) do
      local around, sum = values_around(y, nx, nz, (k - 1) // nz + 1, (k - 1) % nz + 1), 0
      for _, value in ipairs(around) do sum = sum + value end
      if #around > 0 then found[k] = sum / #around else left[#left + 1] = k end
    end
    for k, value in pairs(found) do y[k] = value end
    holes = left
  end
  return all
end

local sweeps, most_visits = 400, 2e7 -- limits of sweeps and visits; enough for a hole 20 points wide

-- Fills missing values by iteration, until each is nearly the mean of its four neighbours. At least one
-- point must have a value.
function repair.fill(y, nx, nz)
  local holes = grow(y, nx, nz)
  for _ = 1, math.min(sweeps, most_visits // math.max(1, #holes)) do
    for _, k in ipairs(holes) do
      local i, j, sum, count = (k - 1) // nz + 1, (k - 1) % nz + 1, 0, 0
      if i > 1 then sum, count = sum + y[k - nz], count + 1 end
      if i < nx then sum, count = sum + y[k + nz], count + 1 end
      if j > 1 then sum, count = sum + y[k - 1], count + 1 end
      if j < nz then sum, count = sum + y[k + 1], count + 1 end
      y[k] = sum / count
    end
  end
end

return repair

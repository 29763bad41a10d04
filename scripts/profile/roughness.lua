-- Computes the profile parameters of ISO 21920-2, with the names of ISO 4287. The heights must have even
-- steps.

local roughness = {}

local function mean_power(z, power, middle)
  local sum = 0
  for i = 1, #z do sum = sum + (z[i] - middle) ^ power end
  return sum / #z
end

local function extremes(z, first, last)
  local low, high = math.huge, -math.huge
  for i = first, last do
    low, high = math.min(low, z[i]), math.max(high, z[i])
  end
  return low, high
end

-- Returns Rp and Rv: the largest peak height and the largest valley depth of a section, each averaged over
-- the sections.
local function sections(z, size, count)
  local p, v = 0, 0
  for section = 1, count do
    local low, high = extremes(z, (section - 1) * size + 1, section * size)
    p, v = p + math.max(0, high) / count, v + math.max(0, -low) / count
  end
  return p, v
end

-- Returns the mean width of the profile elements, or nil if there are fewer than two crossings. An element
-- lies between two upward crossings of the mean line and contains a valley and a hill of more than a tenth of
-- Rz.
local function width(z, step, height)
  local limit, state, crossing, first, last, count = height / 10, nil, nil, nil, nil, -1
  for i = 2, #z do
    if z[i - 1] <= 0 and z[i] > 0 then crossing = (i - 1 - z[i - 1] / (z[i] - z[i - 1])) * step end
    if z[i] < -limit then
      state = "valley"
    elseif z[i] > limit and state == "valley" then
      first, last, count, state = first or crossing, crossing, count + 1, "hill"
    end
  end
  return count > 0 and (last - first) / count or nil
end

-- Returns the root mean square slope of the heights, computed by a seven-point formula.
local function slope(z, step)
  local sum = 0
  for i = 4, #z - 3 do
    local rise = z[i + 3] - z[i - 3] - 9 * (z[i + 2] - z[i - 2]) + 45 * (z[i + 1] - z[i - 1])
    sum = sum + (rise / (60 * step)) ^ 2
  end
  return math.sqrt(sum / (#z - 6))
end

-- Returns the parameters Ra, Rq, ... in a table by name, with lengths in mm. z: heights [mm]; step: distance
-- of the points [mm]; size: points per section; count: number of sections; letter: "R" or "P", the first
-- letter of the names.
function roughness.of(z, step, size, count, letter)
  local middle = mean_power(z, 1, 0)
  local heights, a = {}, 0
  for i = 1, #z do
    heights[i] = z[i] - middle
    a = a + math.abs(heights[i]) / #z
  end
  local q = math.sqrt(mean_power(heights, 2, 0))
  local p, v = sections(heights, size, count)
  local low, high = extremes(heights, 1, #heights)
  return { [letter .. "a"] = a, [letter .. "q"] = q, [letter .. "p"] = p, [letter .. "v"] = v,
    [letter .. "z"] = p + v, [letter .. "t"] = high - low,
    [letter .. "sk"] = q > 0 and mean_power(heights, 3, 0) / q ^ 3 or 0,
    [letter .. "ku"] = q > 0 and mean_power(heights, 4, 0) / q ^ 4 or 0,
    [letter .. "Sm"] = width(heights, step, p + v), [letter .. "dq"] = slope(heights, step) }
end

return roughness

-- Tests the points of experimental designs, and the quantiles of distributions.
local here = arg[0]:match("^(.*)/") or "."
local tap = dofile(here .. "/lib/tap.lua")
local ok, is, fails = tap.ok, tap.is, tap.fails
local random = require "archard.random"

-- Divides (0, 1) into `n` equal slices. Returns the smallest and the largest number of points in a slice.
local function slices(column, n)
  local count = {}
  for i = 1, n do count[i] = 0 end
  for _, x in ipairs(column) do
    local slice = math.floor(x * n) + 1
    count[slice] = count[slice] + 1
  end
  return math.min(table.unpack(count)), math.max(table.unpack(count))
end

for _, design in ipairs{ "sobol", "latin", "random" } do
  local points = random.points(design, 64, 3, 7)
  is(#points, 3, design .. ": one list for each axis")
  local inside = true
  for _, column in ipairs(points) do
    for _, x in ipairs(column) do inside = inside and x > 0 and x < 1 end
  end
  ok(inside and #points[3] == 64, design .. ": all points are within (0, 1)")
  is(table.concat(random.points(design, 64, 3, 7)[2], " "), table.concat(points[2], " "), design ..
    ": equal seeds give equal points")
  ok(random.points(design, 64, 3, 8)[2][5] ~= points[2][5], design ..
    ": different seeds give different points")
  if design ~= "random" then
    local least, most = slices(points[3], 64)
    is(least .. " " .. most, "1 1", design .. ": one point in each slice of an axis")
  end
end
fails(function() random.points("grid", 8, 2, 1) end, "design", "an unknown design")
fails(function() random.points("latin", 0, 2, 1) end, "expected 1 to 10000000", "a design without points")
fails(function() random.points("sobol", 8, 41, 1) end, "expected 1 to 40",
  "more axes than the Sobol sequence has")
ok(math.abs(random.normal_share(random.normal_quantile(0.975)) - 0.975) < 1e-12,
  "the quantile function is the inverse of the distribution")
ok(math.abs(random.normal_quantile(0.975) - 1.959963984540054) < 1e-12,
  "the 0.975 quantile of the standard normal distribution")

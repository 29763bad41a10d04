-- Reads maps as text. The text has either points "x y z", one on each line, in any order, or a matrix of
-- heights, one row on each line, starting at the smallest z.

local axis = require "archard.map.axis"
local decoded = require "archard.lib.decoded"
local units = require "archard.lib.csv_units"

local text = {}

local function is_missing(word) return word:lower():find "^[+-]?nan$" or word == "BAD" or word == "---" end

-- Splits a line at blanks, tabs, semicolons and commas. Commas between digits are decimal commas if the line
-- has blanks, tabs or semicolons as separators.
local function words_of(line)
  local inner, words = line:match "^[%s;]*(.*)", {}
  local decimal = inner:find "%d,%d" and inner:find "[%s;]+%S" and not inner:find ",[%s;]" and not inner:find "[%s;],"
  for word in inner:gmatch(decimal and "[^%s;]+" or "[^%s,;]+") do
    words[#words + 1] = decimal and (word:gsub(",", ".")) or word
  end
  return words
end

-- Calls row(words, number) for each line of numbers, with the number of the line, and header(line) for each
-- line of names before them.
local function each_line(source, row, header)
  local number, count = 0, 0
  for line in (decoded(source.text) .. "\n"):gmatch "(.-)\r?\n" do
    number = number + 1
    if line:find "%S" and not line:find "^%s*[#;%%]" then
      local words = words_of(line)
      if count == 0 and not (source.number(words[1]) or is_missing(words[1] or "")) then
        header(line)
      else
        count = count + 1
        row(words, number)
      end
    end
  end
  if count == 0 then source:refuse "expected lines of numbers, got none" end
end

local function number_in(source, word, line)
  local value = source.number(word)
  if value then return source:checked(value, 1, line) end
  if not is_missing(word) then source:refuse("line %d: expected a number, got %q", line, word) end
  return source.missing
end

-- Returns the unit of x and y and the unit of z from a line of names, or nil if the line has no units.
local function header_units(source, line)
  local found = {}
  for unit in line:gmatch "[%[(]%s*([^%])]-)%s*[%])]" do found[#found + 1] = unit end
  if #found == 0 then return nil end
  if #found ~= 3 or found[1] ~= found[2] or not (units.known(found[1]) and units.known(found[3])) then
    source:refuse("expected units of x, y and z, one for x and y, got %q", line)
  end
  return found[1], found[3]
end

-- --- points -----------------------------------------------------------------------------------------

-- Groups values: sorted neighbours are in one group if they differ by at most a third of the largest
-- difference between neighbours. Returns the mean of each group, and a list with the group index of each
-- value.
local function levels(values)
  local order, gap = {}, 0
  for i = 1, #values do order[i] = i end
  table.sort(order, function(a, b)
    if values[a] ~= values[b] then return values[a] < values[b] end
    return a < b
  end)
  for k = 2, #order do gap = math.max(gap, values[order[k]] - values[order[k - 1]]) end
  local means, level, count = {}, {}, 0
  for k, i in ipairs(order) do
    if k == 1 or values[i] - values[order[k - 1]] > gap / 3 then means[#means + 1], count = 0, 0 end
    count = count + 1
    means[#means] = means[#means] + (values[i] - means[#means]) / count
    level[i] = #means
  end
  return means, level
end

local function check_even(source, name, list)
  if #list < 2 then source:refuse("expected points of a rectangular grid, got %d value of %s", #list, name) end
  local at = axis.uneven(list)
  if at then
    source:refuse("expected even steps of %s, got %.9g after %.9g among steps of %.6g", name, list[at], list[at - 1],
      axis.step(list))
  end
end

function text.points(source)
  local px, pz, py, unit_x, unit_y = {}, {}, {}, nil, nil
  each_line(source, function(words, number)
    if #words ~= 3 then
      source:refuse("line %d: expected three numbers x y z, got %d words; for a matrix of heights give step =, the distance "
        .. "between points in mm", number, #words)
    end
    px[#px + 1], pz[#pz + 1] = number_in(source, words[1], number), number_in(source, words[2], number)
    py[#py + 1] = number_in(source, words[3], number)
    if px[#px] ~= px[#px] or pz[#pz] ~= pz[#pz] then source:refuse("line %d: expected x and y, got a missing value", number) end
  end, function(line) unit_x, unit_y = header_units(source, line) end)
  local x, column = levels(px)
  local z, row = levels(pz)
  if #px < #x * #z / 2 then
    source:refuse("expected points of a rectangular grid, got %d points with %d different x and %d different y", #px, #x, #z)
  end
  check_even(source, "x", x)
  check_even(source, "y", z)
  local y, seen = {}, {}
  for k = 1, #x * #z do y[k] = source.missing end
  for i = 1, #px do
    local k = (column[i] - 1) * #z + row[i]
    if seen[k] then source:refuse("expected each point once, got x = %g, y = %g twice", px[i], pz[i]) end
    y[k], seen[k] = py[i], true
  end
  return { x = x, z = z, y = y, unit_x = unit_x, unit_y = unit_y }
end

-- --- matrices ---------------------------------------------------------------------------------------

function text.matrix(source, step)
  local rows, unit = {}, nil
  each_line(source, function(words, number)
    if rows[1] and #words ~= #rows[1] then
      source:refuse("line %d: expected %d numbers as in the first row, got %d", number, #rows[1], #words)
    end
    for i = 1, #words do words[i] = number_in(source, words[i], number) end
    rows[#rows + 1] = words
  end, function(line)
    unit = line:match "[%[(]%s*([^%])]-)%s*[%])]"
    if unit and not units.known(unit) then source:refuse("expected the unit of heights, got %q", line) end
  end)
  local nx, nz, y = source:count(#rows[1], "the numbers of a row"), source:count(#rows, "the number of rows"), {}
  for i = 1, nx do for j = 1, nz do y[#y + 1] = rows[j][i] end end
  return { x = axis.even(0, step[1], nx), z = axis.even(0, step[2], nz), y = y, unit_x = "mm", unit_y = unit }
end

return text

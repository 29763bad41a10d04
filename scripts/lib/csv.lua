-- csv.read: columns of numbers from a text file, for loadings, profiles and coefficients that were
-- measured elsewhere. Leans on check for its errors.

local check = require "archard.lib.check"

local where = "csv.read"
local csv = {}

local function refuse(path, number, text, ...)
  check.fail(where, ("%s%s: %s"):format(path, number and ":" .. number or "", text:format(...)),
    "FORMAT")
end

-- The cells of a line; quoted ones may hold the separator, and a quote written twice.
local function split(line, separator)
  local cells, at = {}, 1
  repeat
    local cell, last
    if line:find('^%s*"', at) then
      local first = line:find('"', at, true)
      last = first
      repeat
        last = (line:find('"', last + 1, true) or #line + 1)
        local twice = line:sub(last + 1, last + 1) == '"'
        if twice then last = last + 1 end
      until not twice
      cell = line:sub(first + 1, last - 1):gsub('""', '"')
    end
    local stop = line:find(separator, (last or at - 1) + 1, true)
    cells[#cells + 1] = cell or line:sub(at, (stop or 0) - 1):match("^%s*(.-)%s*$")
    at = stop and stop + 1
  until not at
  return cells
end

-- The separator is the one that the line of names holds most of.
local function separator_of(header)
  local best, most = ",", 0
  for _, separator in ipairs{ ",", ";", "\t" } do
    local _, count = header:gsub(separator, "")
    if count > most then best, most = separator, count end
  end
  return best
end

-- A number; with semicolons between the cells, a comma may stand for its point.
local function number_in(cell, separator)
  if separator == ";" then cell = cell:gsub(",", ".") end
  return not cell:find("^%s*[+-]?0[xX]") and tonumber(cell) or nil
end

local function names_of(path, number, header, separator)
  local names = split(header, separator)
  local seen = {}
  for i, name in ipairs(names) do
    if name == "" or seen[name] then
      refuse(path, number, "column %d: expected a name of its own, got %q", i, name)
    end
    if tonumber(name) then
      refuse(path, number, "expected a line of names first, got the number %s", name)
    end
    seen[name] = true
  end
  return names
end

-- Lines that count, with their numbers.
local function lines_of(path)
  local file, problem = io.open(path, "r")
  if not file then check.fail(where, problem, "IO") end
  local text, failed = file:read("a")
  file:close()
  if not text then check.fail(where, ("%s: %s"):format(path, failed), "IO") end
  local lines, number = {}, 0
  for line in (text:gsub("^\xEF\xBB\xBF", "") .. "\n"):gmatch("(.-)\r?\n") do
    number = number + 1
    if line:find("%S") and not line:find("^%s*#") then lines[#lines + 1] = { number, line } end
  end
  return lines
end

local function read_columns(path)
  local lines = lines_of(path)
  if not lines[1] then refuse(path, nil, "expected a line of names, the file is empty") end
  local separator = separator_of(lines[1][2])
  local names = names_of(path, lines[1][1], lines[1][2], separator)
  local columns = {}
  for i in ipairs(names) do columns[i] = {} end
  for row = 2, #lines do
    local number, line = lines[row][1], lines[row][2]
    local cells = split(line, separator)
    if #cells ~= #names then refuse(path, number, "expected %d cells, got %d", #names, #cells) end
    for i, cell in ipairs(cells) do
      local value = number_in(cell, separator)
      if not value and type(columns[i][1]) == "number" then
        refuse(path, number, "column %q: expected a number, got %q", names[i], cell)
      end
      columns[i][row - 1] = type(columns[i][1]) ~= "string" and value or cell
    end
  end
  return names, columns
end

local function find(path, names, columns, wanted)
  if type(wanted) == "number" and columns[wanted] then return columns[wanted] end
  for i, name in ipairs(names) do
    if name == wanted then return columns[i] end
  end
  refuse(path, nil, "no column %s; there are %s", type(wanted) == "string" and ("%q"):format(wanted)
    or tostring(wanted), table.concat(names, ", "))
end

function csv.read(path, choice)
  if type(path) ~= "string" then
    check.fail(where, "expected the path of a file, got " .. check.shown(path))
  end
  if choice ~= nil and type(choice) ~= "table" then
    check.fail(where, "expected a table { name = column, ... }, got " .. check.shown(choice))
  end
  local names, columns = read_columns(path)
  local result = {}
  if choice then
    for name, wanted in pairs(choice) do result[name] = find(path, names, columns, wanted) end
  else
    for i, name in ipairs(names) do result[name] = columns[i] end
  end
  return result
end

return csv

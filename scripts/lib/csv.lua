-- csv.read reads columns of numbers from a text file. If the name of a column ends with a known unit, its
-- numbers are converted to mm, N, MPa, s or degrees.

local check = require "archard.lib.check"
local decoded = require "archard.lib.decoded"
local files = require "archard.files"
local units = require "archard.lib.csv_units"
local strict = require "archard.strict"

local where = "csv.read"
local csv = {}

local function refuse(path, number, text, ...)
  check.fail(where, ("%s%s: %s"):format(path, number and ":" .. number or "", text:format(...)),
    "FORMAT")
end

-- Removes blanks at both ends of a text, in linear time.
local function trimmed(text)
  local first = text:find("%S")
  return first and text:match(".*%S", first) or ""
end

-- Splits a line into cells. A quoted cell may contain the separator; two quotes in it mean one quote.
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
    cells[#cells + 1] = cell or trimmed(line:sub(at, (stop or 0) - 1))
    at = stop and stop + 1
  until not at
  return cells
end

-- Returns the most frequent separator in the line of column names.
local function separator_of(header)
  local best, most = ",", 0
  for _, separator in ipairs{ ",", ";", "\t" } do
    local _, count = header:gsub(separator, "")
    if count > most then best, most = separator, count end
  end
  return best
end

-- Returns the number in a cell, or nil if the cell contains no number. If cells are separated by semicolons or
-- tabs, a decimal comma is accepted.
local function number_in(cell, separator)
  if separator ~= "," then cell = cell:gsub(",", ".") end
  if cell:lower():find("^[+-]?nan$") then return 0 / 0 end
  return not cell:find("^%s*[+-]?0[xX]") and tonumber(cell) or nil
end

local function names_of(path, number, header, separator)
  local names = split(header, separator)
  local seen = {}
  for i, name in ipairs(names) do
    if name == "" or seen[name] then
      refuse(path, number, "column %d: expected a unique name, got %q", i, name)
    end
    if tonumber(name) then
      refuse(path, number, "expected a line of names first, got the number %s", name)
    end
    seen[name] = true
  end
  return names
end

-- Returns the lines with data as a list of { line number, text }. Blank lines and comments are omitted.
local function lines_of(path)
  local lines, number = {}, 0
  for line in (decoded(files.read(where, path)) .. "\n"):gmatch("(.-)\r?\n") do
    number = number + 1
    if line:find("%S") and not line:find("^%s*#") then lines[#lines + 1] = { number, line } end
  end
  return lines
end

-- Converts the values of a column from a known unit to mm, N, MPa, s or degrees. The list is overwritten.
local function scale(values, unit)
  for i, value in ipairs(values) do values[i] = units.scaled(value, unit) end
end

-- Returns an empty column. Its name is the header without the unit if the unit is known, else the whole
-- header.
local function column_of(header)
  local name, unit = units.split(header)
  local known = unit and units.known(unit)
  return { header = header, bare = name, name = known and name or header, unit = known and unit or nil, values = {} }
end

local function read_columns(path)
  local lines = lines_of(path)
  if not lines[1] then refuse(path, nil, "expected a line with the names of the columns, but the file is empty") end
  local separator = separator_of(lines[1][2])
  local columns = names_of(path, lines[1][1], lines[1][2], separator)
  for i, header in ipairs(columns) do columns[i] = column_of(header) end
  for row = 2, #lines do
    local number, line = lines[row][1], lines[row][2]
    local cells = split(line, separator)
    if #cells ~= #columns then 
      refuse(path, number, "expected %d cells, as many as names in line %d, got %d; lines before the names need a # in front",
        #columns, lines[1][1], #cells)
    end
    for i, cell in ipairs(cells) do
      local value, values = number_in(cell, separator), columns[i].values
      if value == math.huge or value == -math.huge then
        refuse(path, number, "column %q: expected a number in the range of doubles, got %q", columns[i].header, cell)
      end
      if not value and type(values[1]) == "number" then
        refuse(path, number, "column %q: expected a number, got %q", columns[i].header, cell)
      end
      values[row - 1] = type(values[1]) ~= "string" and value or cell
    end
  end
  for _, column in ipairs(columns) do
    if column.unit and type(column.values[1]) == "number" then scale(column.values, column.unit) end
  end
  return columns
end

-- Returns a table that contains each column under its number, its header and its name without unit. If two
-- names are equal, the first column is used.
local function index_of(columns)
  local index = {}
  for i, column in ipairs(columns) do
    index[i] = column
    index[column.header], index[column.name] = index[column.header] or column, index[column.name] or column
  end
  return index
end

-- Raises the error for a missing column.
local function refuse_column(path, columns, wanted)
  local headers = {}
  for i, column in ipairs(columns) do headers[i] = column.header end
  for _, column in ipairs(columns) do
    if column.bare == wanted then
      refuse(path, nil, "column %q: expected one of the units %s; to read it without conversion, use its whole name",
        column.header, units.list())
    end
  end
  refuse(path, nil, "no column %s; the columns are %s", type(wanted) == "string" and ("%q"):format(wanted)
    or tostring(wanted), table.concat(headers, ", "))
end

-- Returns the values of all columns by name, the known units by name, and the names in the order of the
-- file.
local function all_of(path, columns)
  local result, told, order = {}, {}, {}
  for i, column in ipairs(columns) do
    if result[column.name] then
      refuse(path, nil, "column %d: expected a unique name, got %q again", i, column.name)
    end
    result[column.name], told[column.name], order[i] = column.values, column.unit, column.name
  end
  return strict.table(result, where), told, order
end

function csv.read(path, choice)
  if not check.file.test(path) then
    check.fail(where, "expected the path of a file, got " .. check.shown(path))
  end
  if choice ~= nil and type(choice) ~= "table" then
    check.fail(where, "expected a table { name = column, ... }, got " .. check.shown(choice))
  end
  local columns = read_columns(path)
  if not choice then return all_of(path, columns) end
  local result, index = {}, index_of(columns)
  for name, wanted in pairs(choice) do
    result[name] = (index[wanted] or refuse_column(path, columns, wanted)).values
  end
  return strict.table(result, where)
end

return csv

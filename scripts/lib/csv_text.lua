-- Formats rows of values as CSV text.

local files = require "archard.files"

-- Returns the text of a cell, in quotes if it contains a comma, a quote or a line break. Line
-- breaks become blanks.
local function cell(value)
  if value == nil then return "" end
  if type(value) == "number" then return files.number(value) end
  value = tostring(value)
  if not value:find('[",\r\n]') then return value end
  return '"' .. value:gsub('"', '""'):gsub("[\r\n]+", " ") .. '"'
end

-- Returns the CSV text of rows. columns: number of cells in each line; nil in a row is an empty cell.
return function(rows, columns)
  local lines, cells = {}, {}
  for i, row in ipairs(rows) do
    for c = 1, columns do cells[c] = cell(row[c]) end
    lines[i] = table.concat(cells, ",")
  end
  return table.concat(lines, "\n") .. "\n"
end

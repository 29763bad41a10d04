-- Converts CSV files to decimal commas, with semicolons between the cells, as spreadsheets in many languages expect.

local files = require "archard.files"

-- Returns a list of the cells of a line, with their quotes.
local function cells_of(line)
  local cells, at = {}, 1
  while at <= #line + 1 do
    local quoted = line:match('^"[^"]*"', at)
    while quoted and line:match('^"[^"]*"', at + #quoted) do quoted = quoted .. line:match('^"[^"]*"', at + #quoted) end
    local cell = quoted or line:match("^[^,]*", at)
    cells[#cells + 1] = cell
    at = at + #cell + 1
  end
  return cells
end

local function with_comma(cell)
  if tonumber(cell) then return (cell:gsub("%.", ",")) end
  return cell:find ";" and not cell:find '^"' and '"' .. cell .. '"' or cell
end

-- Rewrites the CSV file `path`.
return function(where, path)
  local text = files.read(where, path):gsub("[^\n]+", function(line)
    local cells = cells_of(line)
    for i, cell in ipairs(cells) do cells[i] = with_comma(cell) end
    return table.concat(cells, ";")
  end)
  files.write(where, path, text)
end

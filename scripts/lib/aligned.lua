-- Formats rows of texts as lines of a table with aligned columns.

local function length_of(text) return utf8.len(text) or #text end

local function widths_of(rows)
  local widths = {}
  for _, row in ipairs(rows) do
    for c, text in ipairs(row) do widths[c] = math.max(widths[c] or 0, length_of(text)) end
  end
  return widths
end

-- Aligns cells to the right, except the last column; with `words`, all to the left.
local function line_of(row, widths, words)
  local cells = {}
  for c, text in ipairs(row) do
    local gap = (" "):rep(widths[c] - length_of(text))
    cells[c] = words and text .. gap or c == #row and text or gap .. text
  end
  return (table.concat(cells, "  "):gsub(" +$", ""))
end

-- (rows [, words]) -> lines, and the widths of the columns
return function(rows, words)
  local widths, lines = widths_of(rows), {}
  for i, row in ipairs(rows) do lines[i] = line_of(row, widths, words) end
  return lines, widths
end

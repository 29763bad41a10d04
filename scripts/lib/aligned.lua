-- Formats rows of texts as lines of a table with aligned columns.

local function length_of(text) return utf8.len(text) or #text end

local function widths_of(rows)
  local widths = {}
  for _, row in ipairs(rows) do
    for c, text in ipairs(row) do widths[c] = math.max(widths[c] or 0, length_of(text)) end
  end
  return widths
end

-- Returns one line of the table: the last column is aligned to the left, the others to the right. With
-- `words`, all columns are aligned to the left.
local function line_of(row, widths, words)
  local cells = {}
  for c, text in ipairs(row) do
    local gap = (" "):rep(widths[c] - length_of(text))
    cells[c] = words and text .. gap or c == #row and text or gap .. text
  end
  return (table.concat(cells, "  "):gsub(" +$", ""))
end

-- Returns the lines of the table, and the widths of the columns in characters. rows: lists of texts; words:
-- true to align all columns to the left.
return function(rows, words)
  local widths, lines = widths_of(rows), {}
  for i, row in ipairs(rows) do lines[i] = line_of(row, widths, words) end
  return lines, widths
end

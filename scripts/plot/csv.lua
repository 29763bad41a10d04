-- Converts a figure of plot/draw.lua to CSV text. The first line contains the column names; each curve has a
-- column of x and a column of y.

local csv_text = require "archard.lib.csv_text"

-- Appends the columns of a panel to the list `columns`, each as { name=, values= }.
local function panel_columns(panel, prefix, columns)
  local function add(name, values)
    columns[#columns + 1] = { name = prefix .. name, values = values }
  end
  for i, curve in ipairs(panel.curves) do
    local title = curve.title and curve.title .. ": " or #panel.curves > 1 and i .. ": " or ""
    add(title .. (panel.x.label or "x"), curve.x)
    add(title .. (panel.y.label or "y"), curve.y)
    if curve.error then add(title .. "error", curve.error) end
  end
  if panel.field then
    add(panel.x.label or "x", panel.field.x)
    add(panel.y.label or "y", panel.field.y)
    add(panel.value.label or "value", panel.field.value)
  end
end

local function columns_of(figure)
  local columns = {}
  for number, panel in ipairs(figure.panels) do
    local name = panel.name or panel.title or ("panel %d"):format(number)
    panel_columns(panel, #figure.panels > 1 and name .. ": " or "", columns)
  end
  return columns
end

-- Returns a figure as CSV text. Cells below the end of a shorter column are empty.
return function(figure)
  local columns, rows = columns_of(figure), { {} }
  for c, column in ipairs(columns) do
    rows[1][c] = column.name
    for i, value in ipairs(column.values) do
      rows[i + 1] = rows[i + 1] or {}
      rows[i + 1][c] = value
    end
  end
  return csv_text(rows, #columns)
end

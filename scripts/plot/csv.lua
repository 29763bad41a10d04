-- The numbers of a figure as CSV: a line of names, then columns, each curve an x and a y. Leans on
-- nothing but the form of a figure that plot/draw.lua makes.

local check = require "archard.lib.check"

local csv = {}

local function quoted(text)
  if text:find('[",\r\n]') then return '"' .. text:gsub('"', '""'):gsub("[\r\n]+", " ") .. '"' end
  return text
end

-- Adds the columns of a panel, each { name=, values= }.
local function panel_columns(panel, place, columns)
  local function add(name, values)
    columns[#columns + 1] = { name = place .. name, values = values }
  end
  for i, curve in ipairs(panel.curves) do
    local title = curve.title and curve.title .. ": " or #panel.curves > 1 and i .. ": " or ""
    add(title .. (panel.x.label or "x"), curve.x)
    add(title .. (panel.y.label or "y"), curve.y)
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
    local place = panel.title or ("panel %d"):format(number)
    panel_columns(panel, #figure.panels > 1 and place .. ": " or "", columns)
  end
  return columns
end

-- Shorter columns end early; every number can be read back to the same bits.
local function cell(value)
  if value == nil then return "" end
  if value ~= value then return "nan" end
  return ("%.17g"):format(value)
end

function csv.text(figure)
  local columns, lines, cells, rows = columns_of(figure), {}, {}, 0
  for i, column in ipairs(columns) do
    cells[i] = quoted(column.name)
    rows = math.max(rows, #column.values)
  end
  lines[1] = table.concat(cells, ",")
  for row = 1, rows do
    for i, column in ipairs(columns) do cells[i] = cell(column.values[row]) end
    lines[row + 1] = table.concat(cells, ",")
  end
  return table.concat(lines, "\n") .. "\n"
end

-- The file is whole or not there.
function csv.write(where, path, figure)
  local part = path .. ".part"
  local file, message = io.open(part, "wb")
  if not file then check.fail(where, "cannot write " .. message, "IO") end
  local written, why = file:write(csv.text(figure))
  local closed, why_not = file:close()
  local moved, reason = written and closed and os.rename(part, path)
  if not moved then
    os.remove(part)
    check.fail(where, ("cannot write '%s': %s"):format(path, why or why_not or reason), "IO")
  end
end

return csv

-- Makes tables of a study's results, as text for the terminal, as CSV or as Markdown.

local aligned = require "archard.lib.aligned"
local check = require "archard.lib.check"
local csv_text = require "archard.lib.csv_text"
local files = require "archard.files"
local measure = require "archard.measure"
local named = require "archard.study.case".named
local number = require "archard.definition.number"
local settings = require "archard.definition.settings"
local term = require "archard.term"
local written = require "archard.lib.written"

local tables = {}

-- --- columns -------------------------------------------------------------------------------------

-- Returns the last row of the history of a finished case, or nil for other cases.
local function last_of(case) return case.status == "done" and case.last or nil end

local function of_last(name, factor)
  return function(case)
    local last = last_of(case)
    return last and last[name] and last[name] * (factor or 1)
  end
end

-- Columns with results, each as { title, unit, format, function(case) that returns the value }.
local measured = {
  { "updates", "", "%d", of_last "update" },
  { "p_center", "MPa", "%.2f", of_last "p_center" },
  { "p_max", "MPa", "%.2f", of_last "p_max" },
  { "p_peak", "MPa", "%.2f", of_last "p_peak" },
  { "half_width", "mm", "%.4f", of_last "half_width" },
  { "depth_cylinder", "um", "%.4f", of_last("depth_cylinder", 1e3) },
  { "depth_plate", "um", "%.4f", of_last("depth_plate", 1e3) },
  { "volume", "mm3", "%.4e", function(case)
    local last = last_of(case)
    return last and last.volume_cylinder + last.volume_plate
  end },
  { "alpha_tilde", "", "%.4f", of_last "depth_partition" },
  { "seconds", "s", "%.2f", function(case) return case.seconds end },
}

-- Returns the names of the bodies in the finished cases of a study. If the cases differ in these names,
-- returns the default names.
local function bodies_of(study)
  local names
  for _, case in ipairs(study:cases()) do
    local its = last_of(case) and measure.bodies(named(case)) or names
    if names and (its.upper ~= names.upper or its.lower ~= names.lower) then return measure.bodies() end
    names = its
  end
  return names or measure.bodies()
end

-- Returns true if a finished case has a value (possibly NaN), or if no case is finished.
local function is_measured(study, value_of)
  local finished = false
  for _, case in ipairs(study:cases()) do
    if last_of(case) and value_of(case) then return true end
    finished = finished or last_of(case) ~= nil
  end
  return not finished
end

-- Returns the columns that have values. Column titles contain the names of the bodies.
local function measured_of(study)
  local list, bodies = {}, bodies_of(study)
  local named = { depth_cylinder = "depth_" .. bodies.upper, depth_plate = "depth_" .. bodies.lower }
  for _, each in ipairs(measured) do
    if is_measured(study, each[4]) then list[#list + 1] = { named[each[1]] or each[1], each[2], each[3], each[4] } end
  end
  return list
end

-- Returns the beginning of a warning without the name of the function, such as "the contact reaches the cup's
-- rim".
local function shortened(warning) return warning:gsub("^[%l_]+:%l+: ", ""):match("^[^:(]*[^:(%s]") or warning end

local function columns_of(study)
  local columns = { { "case", "", "%d", function(case) return case.id end } }
  for _, name in ipairs(study.varied) do
    local setting = number.setting(name)
    columns[#columns + 1] = { name, setting and setting.unit or "", "%s", function(case)
      local value = study.flat[case.id][name]
      return value ~= nil and settings.shown(value) or nil
    end }
  end
  for _, column in ipairs(measured_of(study)) do columns[#columns + 1] = column end
  columns[#columns + 1] = { "status", "", "%s", function(case)
    return case.status .. (case.message and ": " .. case.message or "")
      .. (case.warning and ", warned: " .. shortened(case.warning) or "")
  end }
  return columns
end

local function shown(column, value)
  if value == nil or (type(value) == "number" and value ~= value) then return "-" end
  if column[3] == "%d" then return ("%d"):format(math.floor(value + 0.5)) end
  return column[3]:format(value)
end

-- --- the forms -----------------------------------------------------------------------------------

local function rows_of(study, columns, show)
  local rows = {}
  for i, case in ipairs(study:cases()) do
    rows[i] = {}
    for c, column in ipairs(columns) do rows[i][c] = show(column, column[4](case)) end
  end
  return rows
end

local function heads(columns, with_unit)
  local row = {}
  for c, column in ipairs(columns) do
    row[c] = column[1] .. (with_unit and column[2] ~= "" and " [" .. column[2] .. "]" or "")
  end
  return row
end

-- Short column titles for the terminal, where a separate row contains the units.
local short = { depth_cylinder = "h_cyl", half_width = "half_w",
  alpha_tilde = "a~", seconds = "time", updates = "upd." }

local forms = {}

-- Columns that are omitted on a narrow terminal, in the order of omission.
local spare = { "p_peak", "half_width", "p_max", "seconds", "updates", "volume", "jump" }

local function without(columns, name)
  local kept = {}
  for _, column in ipairs(columns) do
    if column[1] ~= name then kept[#kept + 1] = column end
  end
  return kept
end

-- Returns the columns with a status column that has numbers instead of messages, and the list of these
-- messages, which is complete when the table is made.
local function with_notes(columns)
  local notes, number = {}, {}
  local function mark(message)
    if not message then return "" end
    if not number[message] then
      notes[#notes + 1] = message
      number[message] = #notes
    end
    return (" [%d]"):format(number[message])
  end
  columns = without(columns, "status")
  columns[#columns + 1] = { "status", "", "%s", function(case)
    return case.status .. mark(case.message) .. mark(case.warning and "warning: " .. case.warning)
  end }
  return columns, notes
end

local function text_of(study, columns)
  local head, units = {}, {}
  for c, column in ipairs(columns) do
    head[c] = short[column[1]] or column[1]:gsub("^depth_", "h_")
    units[c] = column[2] ~= "" and "[" .. column[2] .. "]" or ""
  end
  local rows = rows_of(study, columns, shown)
  table.insert(rows, 1, units)
  table.insert(rows, 1, head)
  local lines, widths = aligned(rows)
  local width = -2
  for _, each in ipairs(widths) do width = width + each + 2 end
  return table.concat(lines, "\n"), width
end

function forms.text(study, columns)
  local limit = term.is_terminal("stdout") and term.size("stdout") or 120
  local notes
  columns, notes = with_notes(columns)
  local text, width = text_of(study, columns)
  for _, name in ipairs(spare) do
    if width <= limit then break end
    columns = without(columns, name)
    text, width = text_of(study, columns)
  end
  for i, note in ipairs(notes) do text = ("%s\n[%d] %s"):format(text, i, note) end
  return text
end

function forms.csv(study, columns)
  local rows = rows_of(study, columns, function(_, value)
    if value == value then return value end
  end)
  table.insert(rows, 1, heads(columns, true))
  return (csv_text(rows, #columns):gsub("\n$", ""))
end

function forms.markdown(study, columns)
  local rows = rows_of(study, columns, function(column, value)
    return (shown(column, value):gsub("|", "\\|"))
  end)
  local rule = {}
  for c = 1, #columns do rule[c] = c == #columns and ":--" or "--:" end
  table.insert(rows, 1, rule)
  table.insert(rows, 1, heads(columns, true))
  local lines = {}
  for i, row in ipairs(rows) do lines[i] = "| " .. table.concat(row, " | ") .. " |" end
  return table.concat(lines, "\n")
end

-- --- making --------------------------------------------------------------------------------------

local endings = { csv = "csv", md = "markdown", txt = "text" }
local fields = { format = check.one_of{ "text", "csv", "markdown" }, file = check.file }

-- Returns the table of a study as text for print(). With the option `file`, writes the table to this file and
-- returns the path.
function tables.make(study, options)
  options = options or {}
  options = check.fields("study:table", options, fields)
  local by_ending = options.file and endings[options.file:match("%.(%w+)$") or ""]
  local text = forms[options.format or by_ending or "text"](study, columns_of(study))
  if not options.file then return text end
  files.write("study:table", options.file, text .. "\n")
  return written.returned("study:table", options.file)
end

-- Returns the table for HTML pages as rows of formatted strings, the titles first, without the columns in
-- `omitted`.
function tables.rows(study, omitted)
  local columns = columns_of(study)
  for _, name in ipairs(omitted or {}) do columns = without(columns, name) end
  local rows = rows_of(study, columns, shown)
  table.insert(rows, 1, heads(columns, true))
  return rows
end

return tables

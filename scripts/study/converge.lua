-- Lua function study.converge: searches for the element size, the cycles per update and the increments per
-- cycle that a model needs (study/search.lua). This process searches a single case; the workers of a study
-- search several cases.

local aligned = require "archard.lib.aligned"
local check = require "archard.lib.check"
local merged = require "archard.lib.merged"
local search = require "archard.study.search"
local settings = require "archard.definition.settings"
local strict = require "archard.strict"

local where = "study.converge"

-- --- the fields ----------------------------------------------------------------------------------

local share = check.share
local limit_fields = { pressure = share, smooth = share, symmetric = share, profile = share,
  updates = check.whole(4, 1000), first_depth = check.positive }
local run_fields = { file = check.file, workers = check.count, progress = check.progress }
local own_fields = merged(limit_fields, run_fields, { mesh = check.flag, base = check.table,
  vary = check.table, cases = check.table, name = check.text })

local function pick(given, fields)
  local picked = {}
  for name in pairs(fields) do picked[name] = given[name] end
  return picked
end

-- Splits `given` into two tables: fields that are functions, and all other fields. Functions are allowed only
-- for a single case, because several cases are stored in a run file, which cannot contain functions.
local function without_functions(given)
  local plain, functions = merged(given), {}
  for name, value in pairs(given) do
    if type(value) == "function" then plain[name], functions[name] = nil, value end
  end
  return plain, functions
end

local function flat_cases(study, given)
  local base, functions = without_functions(check.definition(where, given.base or {}, check.anything, nil, "base"))
  local flat = check.as(where, study, { base = base, vary = given.vary, cases = given.cases }).flat
  local name = next(functions)
  if name and #flat > 1 then
    check.fail(where, ("field 'base.%s': a function is allowed for a single case only, because several cases "
      .. "use a run file, which cannot store functions; expected a number or a table over distance"):format(name))
  end
  if name then flat = { merged(flat[1], functions) } end
  return flat
end

-- Reads the arguments: a study object and options, or one table with the fields of both. Returns the flat
-- settings of all cases, the options and the name of the study.
local function read(study, given, options)
  local metatable = type(given) == "table" and getmetatable(given)
  if metatable and metatable.__name == "study" then
    return given.flat, check.fields(where, options or {}, own_fields), given.name
  end
  given = check.definition(where, given, own_fields, "a study or ")
  return flat_cases(study, given), given, given.name or "study"
end

-- --- the mesh ------------------------------------------------------------------------------------

local function find_mesh(flat, options)
  local model = settings.nest(flat).model
  if model and (model.cup or model.head) then
    check.fail(where, 'expected a model{}, got a joint; use study{ vary = { ["mesh.size"] = { 4, 3, 2 } } }')
  end
  local limit = options.pressure or search.limits.pressure
  local steps, good = search.mesh(settings.nest(flat), limit)
  if not good then
    check.fail(where, ("with element sizes down to %g mm the largest pressure does not stay within %g %% of "
      .. "the Hertz pressure"):format(steps[#steps].size, 100 * limit), "NOT_CONVERGED")
  end
  return { steps = steps, limit = limit, size = good.size }
end

local function refuse_loading(flat)
  for name in pairs(flat) do
    if name:find("^loading") then
      check.fail(where, "field 'loading': only reciprocating cases are searched; give a stroke")
    end
  end
end

local function with_mesh(flat, mesh, limits)
  local copy = merged(flat)
  if mesh then
    copy["model.mesh.size"], copy["model.mesh.height"] = mesh.size, 1.25 * mesh.size
  end
  for name, value in pairs(limits) do copy["converge." .. name] = value end
  return copy
end

-- --- searching -----------------------------------------------------------------------------------

local function search_one(flat)
  return { { label = "the only case", status = "done", settings = settings.nest(flat),
    found = check.as(where, search, settings.nest(flat), function() end) } }
end

local function search_many(study, flat, options, name)
  local run = study{ name = name, cases = flat, task = "converge", snapshots = 0 }
  run:run{ file = options.file, workers = options.workers,
    progress = options.progress }
  local rows = {}
  for i, case in ipairs(run:cases()) do
    rows[i] = { label = case.label, status = case.status, message = case.message,
      settings = case.settings, found = case.status == "done" and case.results or nil }
  end
  run:close()
  return rows
end

-- --- showing -------------------------------------------------------------------------------------

local function number(format, value)
  return value and format:format(value) or "-"
end

-- Returns true if value(item) does not increase from item to item of a list.
local function falls(list, value)
  for i = 2, #list do
    if value(list[i]) > value(list[i - 1]) then return false end
  end
  return true
end

local function mesh_lines(mesh)
  local rows = { { "size [mm]", "elements in 2a", "p_max [MPa]", "off Hertz", "change" } }
  for _, step in ipairs(mesh.steps) do
    rows[#rows + 1] = { ("%g"):format(step.size), ("%.1f"):format(step.elements),
      ("%.2f"):format(step.p_max), ("%+.2f %%"):format(100 * step.error),
      step.change and ("%+.2f %%"):format(100 * step.change) or "-" }
  end
  local lines = { ("element size: %g mm is small enough (error of the pressure below %g %% of Hertz, "
    .. "also at half the size)")
    :format(mesh.size, 100 * mesh.limit) }
  for _, line in ipairs(aligned(rows)) do lines[#lines + 1] = "  " .. line end
  if not falls(mesh.steps, function(step) return math.abs(step.error) end) then
    lines[#lines + 1] = "  (the error may rise from one size to the next: it also depends on the position of the "
      .. "contact's edge within its element)"
  end
  return table.concat(lines, "\n")
end

-- Returns the jump as text. A "≥" in front means that no larger jump was tried; notes_of() explains the
-- reason.
local function shown_jump(found)
  return (found.capped and "≥" or "") .. number("%g", found.jump)
end

local function shown_increments(found)
  local most, fewest = search.most_increments, search.fewest_increments
  return (found.increments == most and ">" or found.increments == fewest and "≤" or "")
    .. number("%d", found.increments == most and search.ladder[1] or found.increments)
end

local function case_row(row)
  local found = row.found
  if not found then return { row.label, row.status, "-", "-", "-", "-", "-", row.message or "" } end
  return { row.label, shown_jump(found), number("%.4g", found.limit), shown_increments(found),
    number("%.1e", found.roughness), number("%.1e", found.asymmetry), number("%d", found.judged),
    number("%.2f", found.first_depth and 1e3 * found.first_depth) }
end

local function case_lines(rows)
  local lines = { { "case", "jump", "stable to", "increments", "roughness", "asymmetry", "updates",
    "first depth [um]" } }
  for i, row in ipairs(rows) do lines[i + 1] = case_row(row) end
  return table.concat(aligned(lines), "\n")
end

-- --- limits of the search --------------------------------------------------------------------------

-- Functions by the name of the bound (found.bound) that excluded larger jumps. Each returns a text about this
-- bound.
local bounds = {
  stability = function(found)
    return ("jump %g is the largest value tried below the stability limit of %.4g cycles"):format(found.jump,
      found.limit)
  end,
  cycles = function(found)
    return ("jump %g is the largest value tried; the search stops at a tenth of all cycles"):format(found.jump)
  end,
}

local function add_notes(notes, label, found)
  local function add(text) notes[#notes + 1] = label .. ": " .. text end
  if found.lopsided then
    return add(('profiles are asymmetric by %.1e even with %d increments per cycle, for every jump; '
      .. 'rule = "trapezoid" gives symmetric profiles'):format(found.lopsided, search.most_increments))
  end
  if not found.jump then return add("no jump was small enough, down to 1e-3 of the "
    .. "first guess") end
  if found.capped then add(bounds[found.bound](found)) end
  if found.increments == search.most_increments then
    add(("%d increments are too few, and more than %d were not tried"):format(search.ladder[1],
      search.most_increments))
  elseif found.increments == search.fewest_increments then
    add(("%d increments are enough, and fewer were not tried"):format(found.increments))
  end
  if found.smooth then
    add(("roughness up to %.1e was allowed, as runs with small steps on this mesh have four times "
      .. "this roughness; a finer mesh reduces it"):format(found.smooth))
  end
  if not falls(found.roughnesses, function(value) return value end) then
    add("among the jumps with too rough surfaces, a smaller jump did not always reduce the roughness: once "
      .. "ripples have split the contact, their size does not depend on the jump, and the roughness caused by the "
      .. "mesh appears at different distances in different runs")
  end
end

local function notes_of(rows)
  local notes = {}
  for _, row in ipairs(rows) do
    if row.found then add_notes(notes, row.label, row.found) end
  end
  return notes
end

-- --- Table 1 of the paper --------------------------------------------------------------------------

-- Returns the row with the given alpha and stroke, or nil if there is none.
local function row_of(rows, alpha, stroke)
  for _, row in ipairs(rows) do
    if row.settings.alpha == alpha and row.settings.stroke == stroke then return row end
  end
end

-- Returns Table 1 of the paper as rows of strings. The columns are alpha and, for each stroke, the paper's
-- jump, the computed jump and the computed increments.
local function paper_rows(rows)
  local paper = require "archard.study.paper"
  local result = { { "α" } }
  for _, name in ipairs(paper.stroke_names) do
    for _, head in ipairs{ name .. ": paper", "computed", "n_c" } do
      result[1][#result[1] + 1] = head
    end
  end
  for i, alpha in ipairs(paper.alphas) do
    local line = { ("%g"):format(alpha) }
    for j, stroke in ipairs(paper.strokes) do
      local row = row_of(rows, alpha, stroke)
      local found = row and row.found or {}
      line[#line + 1] = number("%d", paper.jumps[i][j])
      line[#line + 1] = shown_jump(found)
      line[#line + 1] = shown_increments(found)
    end
    result[#result + 1] = line
  end
  return result
end

local methods = {}
local class = { __name = "convergence", __methods = methods, __fields = { "mesh", "cases" } }

-- Returns Table 1 of the paper beside the computed values, as rows of strings. Returns nil if the cases
-- differ from those of the paper.
function methods:table_1()
  if not row_of(self.cases, 0.5, 0.11) or #self.cases < 20 then return nil end
  return paper_rows(self.cases)
end

-- Returns a list of texts about the limits that the searches reached and the roughness that they allowed.
function methods:notes() return notes_of(self.cases) end

function class.__tostring(self)
  local parts = {}
  if self.mesh then parts[1] = mesh_lines(self.mesh) end
  local rows = self:table_1()
  if rows then
    parts[#parts + 1] = "cycles per update (n_c: increments per cycle)\n"
      .. table.concat(aligned(rows), "\n")
  else
    parts[#parts + 1] = case_lines(self.cases)
  end
  local notes = self:notes()
  if notes[1] then parts[#parts + 1] = table.concat(notes, "\n") end
  return table.concat(parts, "\n\n")
end

strict.class(class)

-- Arguments: the study module, a study object or a table of fields, and options. Returns { mesh=, cases= }.
return function(study, given, options)
  local flat, read_options, name = read(study, given, options)
  for _, case in ipairs(flat) do refuse_loading(case) end
  local limits = pick(read_options, limit_fields)
  local mesh = read_options.mesh ~= false and find_mesh(flat[1], read_options) or nil
  local wanted = {}
  for i, case in ipairs(flat) do wanted[i] = with_mesh(case, mesh, limits) end
  local rows = #wanted == 1 and search_one(wanted[1])
    or search_many(study, wanted, read_options, name)
  return setmetatable({ mesh = mesh, cases = rows }, class)
end

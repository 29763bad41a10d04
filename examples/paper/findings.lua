-- Computes the quantities that the paper reports for its twenty cases from the cases of a study
-- (study/case.lua). The figures' texts and the tables of the page contain these quantities.

local measure = require "archard.measure"

local part = ...
local independent = part "independent"
local paper = require "archard.study.paper"

local findings = {}

findings.between = { 0.25, 0.5, 0.75 } -- the values of alpha for which both bodies wear

-- Returns the first finished case with the settings `wanted`, or nil if there is no such case.
function findings.find(cases, wanted)
  for _, case in ipairs(cases) do
    local held = case.status == "done"
    for name, value in pairs(wanted) do
      local is = held and case[name]
      held = held and (is == value or type(is) == "number" and type(value) == "number"
        and math.abs(is - value) <= 1e-9 * math.max(1, math.abs(value)))
    end
    if held then return case end
  end
end

function findings.case(cases, alpha, column)
  return findings.find(cases, { alpha = alpha, stroke = paper.strokes[column] })
end

-- --- one case ------------------------------------------------------------------------------------

-- Returns statistics of the depth partition alpha-tilde = h_c / (h_c + h_p) over the updates: first,
-- last, mean, lowest and highest value, range divided by the mean, and `off`, the largest relative
-- deviation from alpha.
function findings.partition(case)
  local course = case.history.depth_partition -- entry 1 is NaN: no wear yet
  local found = { first = course[2], last = course[#course], low = math.huge, high = -math.huge }
  local sum = 0
  for i = 2, #course do
    sum = sum + course[i]
    found.low, found.high = math.min(found.low, course[i]), math.max(found.high, course[i])
  end
  found.mean = sum / (#course - 1)
  found.range = (found.high - found.low) / found.mean
  found.off = math.max(math.abs(found.low / case.alpha - 1), math.abs(found.high / case.alpha - 1))
  return found
end

-- Returns the largest pressure divided by the pressure at the centre. A value above 1 means
-- pressure peaks, usually at the edges of the scar.
function findings.edge(case) return case.p_max / case.p_center end

-- Returns the relative decrease of the pressure at the centre from the unworn to the final state.
function findings.fall(case) return 1 - case.p_center / case.history.p_center[1] end

-- Returns how much the pressure at the centre, as a function of the distance, deviates from a
-- straight line between its first and last value. The result is the largest deviation divided by
-- the total decrease of the pressure.
function findings.bend(case)
  local p, d, worst = case.history.p_center, case.history.distance, 0
  for i = 1, #p do
    worst = math.max(worst, math.abs(p[i] - p[1] - (p[#p] - p[1]) * d[i] / d[#d]))
  end
  return worst / (p[1] - p[#p])
end

-- Returns the amplitude of the sawtooth ripple of the pressure in the middle of the contact, divided
-- by the pressure at the centre.
function findings.ripple(case)
  local pressure = case:pressure "cylinder"
  return measure.sawtooth(pressure.x, pressure.p, 0.6 * case.half_width) / case.p_center
end

-- --- several cases -------------------------------------------------------------------------------

-- Returns the value `name` of a history at a distance, by linear interpolation between its rows.
local function at(history, name, distance)
  local d, v = history.distance, history[name]
  for i = 2, #d do
    if d[i] >= distance * (1 - 1e-12) then
      return v[i - 1] + (v[i] - v[i - 1]) * (distance - d[i - 1]) / (d[i] - d[i - 1])
    end
  end
  return v[#v]
end

-- Returns the ratio of the largest to the smallest number of a list, minus 1.
local function spread(list)
  return math.max(table.unpack(list)) / math.min(table.unpack(list)) - 1
end

local function over_alphas(cases, column, value)
  local list = {}
  for i, alpha in ipairs(paper.alphas) do list[i] = value(findings.case(cases, alpha, column)) end
  return list
end

-- Returns the relative difference between the largest and the smallest maximum of h_c + h_p among
-- all values of alpha at a stroke.
function findings.sum_spread(cases, column)
  return spread(over_alphas(cases, column, function(case)
    return math.max(table.unpack(case:combined().h))
  end))
end

-- Returns the relative difference between the largest and the smallest final pressure at the centre
-- among all values of alpha at a stroke.
function findings.pressure_spread(cases, column)
  return spread(over_alphas(cases, column, function(case) return case.p_center end))
end

-- Compares the depth of the cylinder for alpha with the depth of the plate for 1 - alpha at ten equally
-- spaced distances. Returns the largest relative difference and the alpha at which it occurs.
function findings.swap(cases, column)
  local worst, where = 0, nil
  for _, alpha in ipairs(paper.alphas) do
    local one, other = findings.case(cases, alpha, column), findings.case(cases, 1 - alpha, column)
    for tenth = alpha > 0 and 1 or 11, 10 do
      local d = tenth / 10 * one.distance
      local off = math.abs(at(one.history, "depth_cylinder", d)
        / at(other.history, "depth_plate", d) - 1)
      if off > worst then worst, where = off, alpha end
    end
  end
  return worst, where
end

-- Returns the alpha in (0, 1] with the highest pressure peak at a stroke, the height of this peak, and
-- the height of the peak for alpha = 1. A height is the result of findings.edge.
function findings.highest_edge(cases, column)
  local best, height = nil, 0
  for _, alpha in ipairs(paper.alphas) do
    local edge = findings.edge(findings.case(cases, alpha, column))
    if alpha > 0 and edge > height then best, height = alpha, edge end
  end
  return best, height, findings.edge(findings.case(cases, 1, column))
end

function findings.complete(cases)
  for _, alpha in ipairs(paper.alphas) do
    for column in ipairs(paper.strokes) do
      if not findings.case(cases, alpha, column) then return false end
    end
  end
  return true
end

-- Returns the largest difference between a worn profile and its mirror image, divided by the depth
-- of the profile.
function findings.asymmetry(case, body)
  local h, worst = case:profile(body).h, 0
  for i = 1, #h // 2 do worst = math.max(worst, math.abs(h[i] - h[#h + 1 - i])) end
  return worst / math.max(table.unpack(h))
end

-- Formats a relative difference: 0.034 as "3.4 %", and values from 1 on as a ratio, such as
-- "54 times" for 53.
function findings.apart(share)
  return share < 1 and ("%.3g %%"):format(100 * share) or ("%.2g times"):format(1 + share)
end

-- --- comparison of the paper, archard and the independent solution -------------------------------

local function percent(value) return ("%.1f %%"):format(100 * value) end
local function um(value) return ("%.4f µm"):format(1e3 * value) end
local function mpa(value) return ("%.1f MPa"):format(value) end
local function three(value) return ("%.3f"):format(value) end
local function two(value) return ("%.2f"):format(value) end

-- Returns the list of compared quantities. Each entry contains the name of the quantity (`text`), the
-- statement of the paper, the function value(cases), the function `form` that formats its result, and
-- the value of the independent solution (`other`) as a text or number.
local function quantities()
  local rows = {}
  local function add(text, said, form, value, other)
    rows[#rows + 1] = { text = text, paper = said, form = form, value = value, other = other }
  end
  local function of(alpha, column, f)
    return function(cases) return f(findings.case(cases, alpha, column)) end
  end
  local hertz, known = independent.hertz.p_max, independent.case
  add("unworn: pressure at the centre", "within 1 % of 591.4 MPa", mpa,
    of(0.5, 1, function(case) return case.history.p_center[1] end), hertz)
  add("total volume, every case (largest off 1.320e-3 mm³)", "1.320e-3 mm³",
    function(v) return ("%.0e of it"):format(v) end, function(cases)
      local worst = 0
      for _, case in ipairs(cases) do
        if case.status == "done" then
          worst = math.max(worst, math.abs(case.volume.total / 1.32e-3 - 1))
        end
      end
      return worst
    end, "0 (Eq. 1)")
  add("s = a, α = 0.5: fall of the pressure at the centre", "about 66 %", percent,
    of(0.5, 1, findings.fall), 1 - known(0.11, 0.5).p_center / hertz)
  for _, body in ipairs{ "cylinder", "plate" } do
    add(("s = a, α = 0.5: depth of the %s"):format(body), "roughly 2 µm", um,
      of(0.5, 1, function(case) return case.depth[body] end),
      1e-3 * known(0.11, 0.5)["depth_" .. body])
  end
  local row = known(0.11, 0.25)
  add("s = a, α = 0.25: mean α̃", "0.266", three,
    of(0.25, 1, function(case) return findings.partition(case).mean end), row.mean)
  add("s = a, α = 0.25: α̃ varies over the distance by", "4.5 %", percent,
    of(0.25, 1, function(case) return findings.partition(case).range end),
    (row.last - row.first) / row.mean)
  for _, alpha in ipairs(findings.between) do
    row = known(0.11, alpha)
    add(("s = a, α = %g: α̃ off α by up to"):format(alpha), "lower than 8 %", percent,
      of(alpha, 1, function(case) return findings.partition(case).off end),
      row and math.max(math.abs(row.first / alpha - 1), math.abs(row.last / alpha - 1)))
  end
  for column, said in ipairs{ false, "up to 1.30", "up to 1.83" } do
    if not said then goto next end
    row = known(paper.strokes[column], 0.25)
    add(("s = %s, α = 0.25: largest α̃ / α"):format(paper.stroke_names[column]), said, two,
      of(0.25, column, function(case) return findings.partition(case).high / 0.25 end),
      math.max(row.first, row.last) / 0.25)
    ::next::
  end
  add("s = 2R: smallest α̃ of all α", "higher than 0.96", three, function(cases)
    local low = 1
    for _, alpha in ipairs(findings.between) do
      low = math.min(low, findings.partition(findings.case(cases, alpha, 4)).low)
    end
    return low
  end, known(20, 0.25).last)
  add("s = a: sum of depths, apart over all α by", "not affected by α", percent,
    function(cases) return findings.sum_spread(cases, 1) end,
    known(0.11, 1).depth_cylinder / known(0.11, 0).depth_plate - 1)
  add("s = a: depth of the cylinder for α against the plate's for 1 - α", "equal", percent,
    function(cases) return (findings.swap(cases, 1)) end)
  add("s = a: pressures at the centre, apart over all α at the end by", "similar", percent,
    function(cases) return findings.pressure_spread(cases, 1) end,
    known(0.11, 0).p_center / known(0.11, 1).p_center - 1)
  add("s = 4a, α = 0: bend of the pressure's fall", "almost linear", percent,
    of(0, 3, findings.bend))
  add("s = 2R, α = 0.25: depth of the plate", "uniform (Eq. 27)", um,
    of(0.25, 4, function(case) return case.depth.plate end), 0.0495e-3)
  for _, alpha in ipairs{ 0.25, 0.5, 0.75, 1 } do
    add(("s = a, α = %g: largest pressure over that at the centre"):format(alpha),
      alpha == 1 and "highest of all α" or "grows with α", two, of(alpha, 1, findings.edge),
      independent.edges[alpha])
  end
  return rows
end

local function shown(form, value)
  if value == nil then return "-" end
  return type(value) == "string" and value or form(value)
end

-- Returns the comparison as rows of texts: a row of column headings, then one row for each quantity.
-- `sets` is a list of { title=, cases= }; each set has its own column.
function findings.compared(sets)
  local rows = { { "", "paper" } }
  for _, set in ipairs(sets) do rows[1][#rows[1] + 1] = set.title end
  rows[1][#rows[1] + 1] = "independent"
  for _, each in ipairs(quantities()) do
    local row = { each.text, each.paper }
    for _, set in ipairs(sets) do row[#row + 1] = each.form(each.value(set.cases)) end
    row[#row + 1] = shown(each.form, each.other)
    rows[#rows + 1] = row
  end
  return rows
end

-- Returns rows of texts that compare final depths and pressures with the independent solution. Each
-- case with an independent solution has three rows.
function findings.finals(sets)
  local rows = { { "s", "α", "" } }
  for _, set in ipairs(sets) do rows[1][#rows[1] + 1] = set.title end
  rows[1][#rows[1] + 1] = "independent"
  local kinds = { { "depth_cylinder", "h_c / µm", 1e3, "%.4f" },
    { "depth_plate", "h_p / µm", 1e3, "%.4f" }, { "p_center", "p at the centre / MPa", 1, "%.1f" } }
  for _, values in ipairs(independent.finals) do
    local known = independent.case(values[1], values[2])
    for k, kind in ipairs(kinds) do
      local column = 0
      for i, stroke in ipairs(paper.strokes) do if stroke == values[1] then column = i end end
      local row = { k == 1 and paper.stroke_names[column] or "",
        k == 1 and ("%g"):format(values[2]) or "", kind[2] }
      for _, set in ipairs(sets) do
        local value = kind[3] * findings.case(set.cases, values[2], column).last[kind[1]]
        local off = known[kind[1]] > 0 and ("  (%+.2f %%)"):format(
          100 * (value / known[kind[1]] - 1)) or ""
        row[#row + 1] = kind[4]:format(value) .. off
      end
      row[#row + 1] = kind[4]:format(known[kind[1]])
      rows[#rows + 1] = row
    end
  end
  return rows
end

-- --- Table 1 -------------------------------------------------------------------------------------

-- Returns rows of texts about how each case was computed: stroke, number of cycles, procedure, cycles
-- per update, contact solutions and computing time [s]. The last two columns are the depth of the
-- first update by Eq. (28) and the computed depth of this update [um].
function findings.table_1(cases)
  local rows = { { "α", "s", "s / mm", "r", "N", "procedure", "N̄", "n_c", "updates",
    "contact solutions", "seconds", "Δh₀ by Eq. (28) / µm", "first h_c + h_p / µm" } }
  for column, stroke in ipairs(paper.strokes) do
    for _, alpha in ipairs(paper.alphas) do
      local case = findings.case(cases, alpha, column)
      local r, history = column == 4 and 1 or 2, case.history
      local procedure = (alpha == 1 or column == 4) and "NSP" or "SP"
      local hertzian = alpha == 0 and column == 4
      rows[#rows + 1] = { ("%g"):format(alpha), paper.stroke_names[column], ("%g"):format(stroke),
        ("%d"):format(r), ("%.0f"):format(case.cycle), hertzian and "closed form" or procedure,
        ("%g"):format(case.jump), procedure == "SP" and ("%d"):format(case.increments) or "-",
        ("%d"):format(case.update), ("%d"):format(case.solutions), ("%.2f"):format(case.seconds),
        ("%.2f"):format(1e3 * paper.first_depth(case.jump, 1e-8, case.hertz.p_max, stroke)),
        ("%.3f"):format(1e3 * (history.depth_cylinder[2] + history.depth_plate[2])) }
    end
  end
  return rows
end

return findings

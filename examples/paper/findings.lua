-- What the paper says of its twenty cases, measured on the cases of a study: the numbers behind the
-- captions and the tables of the page. Leans on cases as study/case.lua has them.

local measure = require "archard.measure"

local part = ...
local independent = part "independent"
local paper = require "archard.study.paper"

local findings = {}

findings.between = { 0.25, 0.5, 0.75 } -- alpha, where both bodies wear

-- The finished case whose settings are these; nil: there is none.
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

-- alpha-tilde after the first update, its mean, at the end; smallest and largest.
function findings.partition(case)
  local course = case.history.depth_partition -- NaN before any wear
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

-- Largest pressure over that at the centre: what stands up at the edges of the scar.
function findings.edge(case) return case.p_max / case.p_center end

-- Share of the pressure at the centre that is lost at the end.
function findings.fall(case) return 1 - case.p_center / case.history.p_center[1] end

-- Bend of the fall of pressure: largest distance from the straight line between its ends, as a share
-- of the fall.
function findings.bend(case)
  local p, d, worst = case.history.p_center, case.history.distance, 0
  for i = 1, #p do
    worst = math.max(worst, math.abs(p[i] - p[1] - (p[#p] - p[1]) * d[i] / d[#d]))
  end
  return worst / (p[1] - p[#p])
end

-- Ripples: the sawtooth in the pressure over the middle of the contact, as a share of that at the
-- centre.
function findings.ripple(case)
  local pressure = case:pressure "cylinder"
  return measure.sawtooth(pressure.x, pressure.p, 0.6 * case.half_width) / case.p_center
end

-- --- several -------------------------------------------------------------------------------------

-- A value linear between the rows of a history.
local function at(history, name, distance)
  local d, v = history.distance, history[name]
  for i = 2, #d do
    if d[i] >= distance * (1 - 1e-12) then
      return v[i - 1] + (v[i] - v[i - 1]) * (distance - d[i - 1]) / (d[i] - d[i - 1])
    end
  end
  return v[#v]
end

-- Largest over smallest of a value of the cases, less 1.
local function spread(list)
  return math.max(table.unpack(list)) / math.min(table.unpack(list)) - 1
end

local function over_alphas(cases, column, value)
  local list = {}
  for i, alpha in ipairs(paper.alphas) do list[i] = value(findings.case(cases, alpha, column)) end
  return list
end

-- How much the deepest of the sum h_c + h_p depends on alpha at a stroke.
function findings.sum_spread(cases, column)
  return spread(over_alphas(cases, column, function(case)
    return math.max(table.unpack(case:combined().h))
  end))
end

-- How far the centre pressures of all alpha at a stroke are apart at the end.
function findings.pressure_spread(cases, column)
  return spread(over_alphas(cases, column, function(case) return case.p_center end))
end

-- How far the depth of the cylinder for alpha is from that of the plate for 1 - alpha, as a share of
-- it, from a tenth of the distance on; the alpha where it is farthest.
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

-- The alpha in (0, 1] with the highest edges at a stroke, how high they are, and those for 1.
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

-- Largest difference of a profile to its mirror image, as a share of its depth.
function findings.asymmetry(case, body)
  local h, worst = case:profile(body).h, 0
  for i = 1, #h // 2 do worst = math.max(worst, math.abs(h[i] - h[#h + 1 - i])) end
  return worst / math.max(table.unpack(h))
end

-- "3.4 %", or "54 times" for how far a largest value is above a smallest.
function findings.apart(share)
  return share < 1 and ("%.3g %%"):format(100 * share) or ("%.2g times"):format(1 + share)
end

-- --- paper, archard, independent -------------------------------------------------------------------

local function percent(value) return ("%.1f %%"):format(100 * value) end
local function um(value) return ("%.4f µm"):format(1e3 * value) end
local function mpa(value) return ("%.1f MPa"):format(value) end
local function three(value) return ("%.3f"):format(value) end
local function two(value) return ("%.2f"):format(value) end

-- What is compared: text, the paper's words, value(cases) and its form, the independent value (as
-- text or as that value).
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

-- Rows of texts: heads, then a line a quantity; `sets` is a list of { title=, cases= }.
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

-- Final values against the independent ones: a line a case that has them.
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

-- --- Table 1 ---------------------------------------------------------------------------------------

-- Each case as it was run: N, stroke, procedure, cycles per update, contact solutions, seconds, the
-- depth of the first update by Eq. (28) and as it came out.
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

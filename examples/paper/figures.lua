-- Draws figures of the paper from the stored results of its cases. Figure 8 (trials.lua) is drawn
-- from the trials. Figures 5 and 6b (setup.lua) and 9 to 14 are drawn from the twenty cases.
-- Each figure is a table: `name` is the file name, `caption` describes the figure and `shows`
-- describes the result. `draw` is a function(cases) that returns the options of plot{}, or nil if
-- cases are missing. `caption` and `shows` are texts or functions of the cases. The functions
-- compute all numbers in their texts from the cases (findings.lua).

local part = ...
local findings = part "findings"
local independent = part "independent"
local paper = require "archard.study.paper"
local parts = require "archard.study.panels"

local stroke_titles = {}
for i, name in ipairs(paper.stroke_names) do stroke_titles[i] = "s = " .. name end

local function alpha_title(alpha) return ("α = %g"):format(alpha) end

-- --- cases of the grid ---------------------------------------------------------------------------

local case_of = findings.case

-- Returns one curve for each wear partition factor alpha in `alphas`, or for every alpha if
-- `alphas` is nil. All curves have the stroke number `column`. Each alpha has its own colour.
local function by_alpha(cases, column, alphas)
  local curves = {}
  for i, alpha in ipairs(paper.alphas) do
    local wanted = not alphas
    for _, each in ipairs(alphas or {}) do wanted = wanted or each == alpha end
    local case = wanted and case_of(cases, alpha, column)
    if case then
      curves[#curves + 1] = { case = case, title = alpha_title(alpha), series = i }
    end
  end
  return curves
end

local function by_stroke(cases, alpha)
  local curves = {}
  for i in ipairs(paper.strokes) do
    local case = case_of(cases, alpha, i)
    if case then curves[#curves + 1] = { case = case, title = stroke_titles[i], series = i } end
  end
  return curves
end

-- Returns three panels for a row: the profile of the cylinder, the profile of the plate, and the
-- pressure.
local function row(curves, title, options)
  return parts.panel("cylinder", curves, { title = title, yrange = options.cylinder,
    reach = options.reach }),
    parts.panel("plate", curves, { title = title, yrange = options.plate,
      reach = options.plate_reach or options.reach }),
    parts.panel("pressure", curves, { title = title, yrange = options.pressure,
      reach = options.reach })
end

local function append(list, ...)
  for _, each in ipairs{ ... } do list[#list + 1] = each end
end

-- --- Fig. 9: the reference case ------------------------------------------------------------------

local function evolution(cases)
  local case = case_of(cases, 0.5, 1)
  if not case or #case:distances() < 3 then return nil end
  local curves = {}
  for i, distance in ipairs(case:distances()) do
    curves[i] = { case = case, distance = distance, series = i,
      title = ("N = %d"):format(math.floor(distance / (2 * paper.strokes[1]) + 0.5)) }
  end
  local panels = { row(curves, nil, { reach = 3 }) }
  panels[1].title, panels[2].title, panels[3].title = "cylinder", "plate", "pressure"
  local one = { { case = case } }
  panels[4] = parts.course("p_center", 1, "p at the centre / MPa", one,
    { title = "pressure", yrange = { 0 } })
  panels[5] = parts.course("depth_cylinder", 1e3, "largest depth / µm", one, { title = "depths" })
  panels[5][1].title = "cylinder"
  local plate = parts.history(case, "depth_plate", 1e3)
  plate.title = "plate"
  panels[5][2] = plate
  panels[6] = { xlabel = "d / mm", ylabel = "volume / 10⁻³ mm³", title = "volumes" }
  for i, body in ipairs{ "cylinder", "plate" } do
    panels[6][i] = parts.history(case, "volume_" .. body, 1e3)
    panels[6][i].title, panels[6][i].dash, panels[6][i].width = body, i, i == 1 and 2.5 or nil -- equal curves
  end
  for i = 1, 6 do panels[i].key = i == 3 and "top right" or i > 4 and "top left" or "none" end
  return { panels = panels, layout = { 2, 3 }, size = { 1500, 840 } }
end

-- --- Figs. 10 to 12 ------------------------------------------------------------------------------

local function effect_of_alpha(cases)
  local panels = {}
  for column, title in ipairs(stroke_titles) do
    local curves = by_alpha(cases, column)
    if #curves == 0 then return nil end
    append(panels, row(curves, title, { reach = 3.4, plate_reach = 5, cylinder = { 0, 8 },
      plate = { -4, 0.5 }, pressure = { 0, 600 } }))
  end
  return { panels = panels, layout = { 4, 3 }, size = { 1260, 1500 } }
end

local function courses(cases)
  local panels = {}
  for _, column in ipairs{ 1, 3 } do
    local curves = by_alpha(cases, column)
    if #curves == 0 then return nil end
    local options = { title = stroke_titles[column], yrange = { 0, 4 } }
    append(panels, parts.course("depth_cylinder", 1e3, "depth of cylinder / µm", curves, options),
      parts.course("depth_plate", 1e3, "depth of plate / µm", curves, options),
      parts.course("p_center", 1, "p at the centre / MPa", curves,
        { title = stroke_titles[column], yrange = { 0, 600 } }))
  end
  return { panels = panels, layout = { 2, 3 }, size = { 1260, 800 } }
end

local function effect_of_stroke(cases)
  local panels = {}
  for _, alpha in ipairs(paper.alphas) do
    local curves = by_stroke(cases, alpha)
    if #curves == 0 then return nil end
    append(panels, row(curves, alpha_title(alpha), { reach = 3.4, plate_reach = 5,
      cylinder = { 0, 8 }, plate = { -4, 0.5 }, pressure = { 0, 600 } }))
  end
  return { panels = panels, layout = { 5, 3 }, size = { 1260, 1860 } }
end

-- --- Figs. 13 and 14 -----------------------------------------------------------------------------

local between = findings.between

local function depth_partition(cases)
  local panels = {}
  for column, title in ipairs(stroke_titles) do
    local curves = by_alpha(cases, column, between)
    if #curves == 0 then return nil end
    panels[column] = parts.course("depth_partition", 1, "α̃", curves,
      { title = title, yrange = column == 4 and { 0.95, 1 } or { 0, 1 } })
  end
  panels[5] = { title = "s = a, along the surface", xlabel = "x / a", ylabel = "α̃_x",
    xrange = { -3, 3 }, yrange = { 0, 1 } }
  for i, curve in ipairs(by_alpha(cases, 1, between)) do
    local share = curve.case:local_partition()
    panels[5][i] = { x = parts.over_a(curve.case, share.x), y = share.value, title = curve.title,
      series = curve.series }
  end
  return { panels = panels, layout = { 2, 3 }, size = { 1260, 800 } }
end

local function sums(cases)
  local panels = {}
  for column, title in ipairs(stroke_titles) do
    local panel = { title = title, xlabel = "x / a", ylabel = "h_c + h_p / µm",
      xrange = { -5, 5 }, yrange = { 0, 4 }, ydown = nil }
    for i, curve in ipairs(by_alpha(cases, column)) do
      local sum, um = curve.case:combined(), {}
      for k, h in ipairs(sum.h) do um[k] = 1e3 * h end
      panel[i] = { x = parts.over_a(curve.case, sum.x), y = um, title = curve.title, series = curve.series }
    end
    if #panel == 0 then return nil end
    panels[column] = panel
  end
  return { panels = panels, layout = { 2, 2 }, size = { 1000, 800 } }
end

-- --- texts about the results ---------------------------------------------------------------------

local function percent(value) return ("%.3g %%"):format(100 * value) end

-- Returns a function that computes the text, or an empty text if one of the twenty cases is missing.
local function if_complete(text)
  return function(cases) return findings.complete(cases) and text(cases) or "" end
end

local function see_reference(cases)
  local case = case_of(cases, 0.5, 1)
  return ("The surfaces grow into each other: the contact widens, the pressure at the centre falls by "
    .. "%s (the paper: about 66 %%). Depths grow ever slower, to %.2f and %.2f µm; volumes grow "
    .. "exactly with the distance, half and half. The plate is at x = 0 in (c) and (d). Over the "
    .. "whole of the last cycle the largest pressure is not %.0f but %.0f MPa: away from x = 0 the "
    .. "flank of a scar meets the edge of the other."):format(percent(findings.fall(case)),
    1e3 * case.depth.cylinder, 1e3 * case.depth.plate, case.p_max, case.p_peak)
end

-- Returns the ratios of largest pressure to pressure at the centre for alpha = 0.25 to 1, such as
-- "1.04, 1.03, 1.30 and 1.00".
local function edges_of(cases, column)
  local list = {}
  for i, alpha in ipairs{ 0.25, 0.5, 0.75, 1 } do
    list[i] = ("%.2f"):format(findings.edge(case_of(cases, alpha, column)))
  end
  return table.concat(list, ", ", 1, 3) .. " and " .. list[4]
end

local function see_edges(cases)
  local known, column_a = {}, edges_of(cases, 1)
  for i, alpha in ipairs{ 0.25, 0.5, 0.75, 1 } do
    known[i] = ("%.2f"):format(independent.edges[alpha])
  end
  local best, height, alone = findings.highest_edge(cases, 1)
  return ("From α = 0 to 1 the wear moves from the plate to the cylinder, whatever the stroke, and "
    .. "the pressure gets flatter in the middle. The paper has the peaks at its edges grow with α up "
    .. "to 1, and with the stroke. Here the largest pressure at x = 0 is, for s = a, %s times that at "
    .. "the centre for α = 0.25, 0.5, 0.75 and 1; by an independent solution %s. The peaks are "
    .. "strongest for α = %g (%.2f), and at 1, where the plate stays flat, %s. With s = 2a the four "
    .. "are %s, with s = 4a %s, with s = 2R %s. How they depend on the mesh: see Meshes."):format(
    column_a, table.concat(known, ", ", 1, 3) .. " and " .. known[4], best, height,
    alone < 1.01 and "there is none" or ("%.2f"):format(alone), edges_of(cases, 2),
    edges_of(cases, 3), edges_of(cases, 4))
end

local function see_courses(cases)
  local apart = findings.apart
  local swap, alpha = findings.swap(cases, 1)
  return ("With s = a the pressures of all α end within %s of the lowest; the paper calls them "
    .. "similar. With s = 4a the highest is %s the lowest: for α = 0 the pressure falls almost in a "
    .. "straight line (bent by %s of its fall), for α = 0.5 steeply at first (%s). The cylinder's "
    .. "depth for α is the plate's for 1 - α, says the paper of s = a: here they are up to %s apart "
    .. "(α = %g), with s = 4a up to %s."):format(apart(findings.pressure_spread(cases, 1)),
    apart(findings.pressure_spread(cases, 3)), percent(findings.bend(case_of(cases, 0, 3))),
    percent(findings.bend(case_of(cases, 0.5, 3))), apart(swap), alpha,
    apart((findings.swap(cases, 3))))
end

local function see_strokes(cases)
  local low, high = math.huge, 0
  for column in ipairs(paper.strokes) do
    local p = case_of(cases, 1, column).p_center
    low, high = math.min(low, p), math.max(high, p)
  end
  return ("A longer stroke spreads the plate's wear wider and thinner, so that the contact stays "
    .. "narrower and the cylinder wears deeper. For α = 1 the stroke makes a difference of %s in the "
    .. "pressure at the centre; for α = 0.25 it increases from %.0f MPa (a) to %.0f MPa (2R), where "
    .. "Hertz' is %.0f MPa."):format(percent(high / low - 1), case_of(cases, 0.25, 1).p_center,
    case_of(cases, 0.25, 4).p_center, independent.hertz.p_max)
end

local function see_partition(cases)
  local parts_of = {}
  for i, alpha in ipairs(between) do
    parts_of[i] = ("%s (α = %g)"):format(percent(findings.partition(case_of(cases, alpha, 1)).off), alpha)
  end
  local low = 1
  for _, alpha in ipairs(between) do
    low = math.min(low, findings.partition(case_of(cases, alpha, 4)).low)
  end
  local wide = findings.partition(case_of(cases, 0.25, 3))
  return ("With s = a, α̃ is off α by at most %s; the paper has less than 8 %%; the independent "
    .. "solution ends at %s for α = 0.25. Longer strokes raise it above α: up to %.2f times for 2a "
    .. "and %.2f times for 4a (α = 0.25), there falling to %.2f. Over the whole plate it is beyond "
    .. "%.3f for every α between 0 and 1."):format(
    table.concat(parts_of, ", "), percent(independent.case(0.11, 0.25).last / 0.25 - 1),
    findings.partition(case_of(cases, 0.25, 2)).high / 0.25, wide.high / 0.25, wide.last / 0.25, low)
end

local function see_sums(cases)
  local apart = {}
  for column, name in ipairs(paper.stroke_names) do
    apart[column] = ("%s (%s)"):format(findings.apart(findings.sum_spread(cases, column)), name)
  end
  local hardest = independent.case(0.11, 1).depth_cylinder / independent.case(0.11, 0).depth_plate - 1
  return ("The deepest of the sum differs over all α by %s. The paper says that for s = a it does not; by "
    .. "the independent solution it does, by %s."):format(table.concat(apart, ", "), percent(hardest))
end

-- --- the list ------------------------------------------------------------------------------------

local setup, trials = part "setup", part "trials"
local list = { trials = trials.trials, ["meshes of the paper"] = trials.meshes }

list.paper = {
  setup[1], setup[2],
  { name = "fig9", title = "Figure 9. A case from beginning to end", draw = evolution,
    caption = "Stroke a, α = 0.5: worn shapes of the cylinder (a) and the plate (b), pressure (c) "
      .. "at equal numbers of cycles; pressure at the centre (d), largest depths (e) and volumes "
      .. "(f) over the travelled distance.", shows = see_reference },
  { name = "fig10", title = "Figure 10. Distribution of wear", draw = effect_of_alpha,
    caption = "Final shapes and pressures of all twenty cases: a row for each stroke, a colour for "
      .. "each α.", shows = if_complete(see_edges) },
  { name = "fig11", title = "Figure 11. Depths and pressure over distance", draw = courses,
    caption = "Largest depth of the cylinder and of the plate, and pressure at the centre (which the "
      .. "paper calls p_max), for the strokes a (top) and 4a (bottom).",
    shows = if_complete(see_courses) },
  { name = "fig12", title = "Figure 12. The same, by stroke", draw = effect_of_stroke,
    caption = "Final shapes and pressures: a row for each α, a colour for each stroke.",
    shows = if_complete(see_strokes) },
  { name = "fig13", title = "Figure 13. Share of the depth", draw = depth_partition,
    caption = "Wear depth partition α̃ = h_c / (h_c + h_p) over distance for each stroke (mind the "
      .. "axis of d), and along the surface for s = a at the end (e).",
    shows = if_complete(see_partition) },
  { name = "fig14", title = "Figure 14. Sum of both depths", draw = sums,
    caption = "Sum of both wear profiles at the end, the bodies aligned, for each stroke.",
    shows = if_complete(see_sums) },
}

return list

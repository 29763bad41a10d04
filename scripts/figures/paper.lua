-- The paper's result figures from the stored results of its cases: 8 from the trials, 9 to 14 from
-- the twenty cases. Each entry: its number, a title, a caption in our own words with what to look
-- at, and a function(cases) -> options of plot{}, or nil where cases are missing.

local paper = require "archard.study.paper"
local parts = require "archard.figures.parts"

local stroke_titles = {}
for i, name in ipairs(paper.stroke_names) do stroke_titles[i] = "s = " .. name end

local function alpha_title(alpha) return ("α = %g"):format(alpha) end

-- --- cases of the grid ---------------------------------------------------------------------------

local function case_of(cases, alpha, column)
  return parts.find(cases, { alpha = alpha, stroke = paper.strokes[column] })
end

-- One curve for each alpha (of `alphas`, all where nil) at a stroke; colours go with alpha.
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

-- Cylinder, plate, pressure side by side.
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

-- --- Fig. 8: the trials --------------------------------------------------------------------------

-- trials: list of { increments, jump }; name tells them apart.
local function trials(chosen, name)
  return function(cases)
    local curves = {}
    for i, trial in ipairs(chosen) do
      local case = parts.find(cases, { increments = trial[1], jump = trial[2], cycles = 1000 })
      if not case then return nil end
      curves[i] = { case = case, title = name(trial), series = i }
    end
    local panels = { row(curves, nil, { reach = 2.6 }) }
    return { panels = panels, layout = { 1, 3 }, size = { 1260, 420 } }
  end
end

local function name_jump(trial) return ("N̄ = %d"):format(trial[2]) end
local function name_increments(trial) return ("n_c = %d"):format(trial[1]) end

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
  panels[1].title, panels[2].title, panels[3].title = "(a) cylinder", "(b) plate", "(c) pressure"
  local one = { { case = case } }
  panels[4] = parts.course("p_center", 1, "p_max / MPa", one, { title = "(d)", yrange = { 0 } })
  panels[5] = parts.course("depth_cylinder", 1e3, "largest depth / µm", one, { title = "(e)" })
  panels[5][1].title = "cylinder"
  local plate = parts.history(case, "depth_plate", 1e3)
  plate.title = "plate"
  panels[5][2] = plate
  panels[6] = { xlabel = "d / mm", ylabel = "volume / 10⁻³ mm³", title = "(f)" }
  for i, body in ipairs{ "cylinder", "plate" } do
    panels[6][i] = parts.history(case, "volume_" .. body, 1e3)
    panels[6][i].title, panels[6][i].dash = body, i
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
      parts.course("p_center", 1, "p_max / MPa", curves,
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

local between = { 0.25, 0.5, 0.75 } -- alpha, where both bodies wear

local function depth_partition(cases)
  local panels = {}
  for column, title in ipairs(stroke_titles) do
    local curves = by_alpha(cases, column, between)
    if #curves == 0 then return nil end
    panels[column] = parts.course("depth_partition", 1, "α̃", curves,
      { title = ("(%s) %s"):format(("abcd"):sub(column, column), title),
        yrange = column == 4 and { 0.95, 1 } or { 0, 1 } })
  end
  panels[5] = { title = "(e) s = a, along the surface", xlabel = "x / a", ylabel = "α̃_x",
    xrange = { -3, 3 }, yrange = { 0, 1 } }
  for i, curve in ipairs(by_alpha(cases, 1, between)) do
    panels[5][i] = parts.local_partition(curve.case)
    panels[5][i].title, panels[5][i].series = curve.title, curve.series
  end
  return { panels = panels, layout = { 2, 3 }, size = { 1260, 800 } }
end

local function sums(cases)
  local panels = {}
  for column, title in ipairs(stroke_titles) do
    local panel = { title = title, xlabel = "x / a", ylabel = "h_c + h_p / µm",
      xrange = { -5, 5 }, yrange = { 0, 4 }, ydown = nil }
    for i, curve in ipairs(by_alpha(cases, column)) do
      panel[i] = parts.sum(curve.case)
      panel[i].title, panel[i].series = curve.title, curve.series
    end
    if #panel == 0 then return nil end
    panels[column] = panel
  end
  return { panels = panels, layout = { 2, 2 }, size = { 1000, 800 } }
end

-- --- the list ------------------------------------------------------------------------------------

local list = {}

list.trials = {
  { name = "fig8a", title = "Figure 8a. Too few increments",
    draw = trials({ { 40, 50 }, { 40, 100 }, { 40, 200 } }, name_jump),
    caption = "Stroke a, α = 0.5 after 1000 cycles with n_c = 40 increments a cycle and 50, 100 or "
      .. "200 cycles between updates: cylinder, plate, pressure.",
    shows = "With 200 cycles between updates the pressure begins to ripple near the edges of the "
      .. "contact. Where the paper sees irregular and lopsided profiles, these are symmetric: the "
      .. "half cycle here is sampled symmetrically, and the coupling of the surfaces conserves "
      .. "forces whatever the position." },
  { name = "fig8b", title = "Figure 8b. Enough increments",
    draw = trials({ { 200, 50 }, { 200, 100 }, { 200, 200 } }, name_jump),
    caption = "The same with n_c = 200 increments a cycle.",
    shows = "More increments change little: what ripples at 200 cycles between updates is the step "
      .. "in wear, not the stroke. With up to 100 the curves are smooth and fall together, as in "
      .. "the paper." },
  { name = "fig8c", title = "Figure 8c. Fewer and fewer increments",
    draw = trials({ { 16, 100 }, { 40, 100 }, { 100, 100 }, { 200, 100 } }, name_increments),
    caption = "100 cycles between updates, with 16, 40, 100 and 200 increments a cycle.",
    shows = "The paper needs 100 increments for symmetric profiles, and its plate suffers first "
      .. "from fewer. Here even 16 give the same curves but for a trace at the edge of the pressure, "
      .. "so that n_c = 100 is on the safe side." },
}

list.paper = {
  { name = "fig9", title = "Figure 9. A case from beginning to end", draw = evolution,
    caption = "Stroke a, α = 0.5: worn shapes of the cylinder (a) and the plate (b), pressure (c) "
      .. "at equal numbers of cycles; pressure at the centre (d), largest depths (e) and volumes "
      .. "(f) over the travelled distance.",
    shows = "The surfaces grow into each other: the contact widens, the pressure flattens and falls "
      .. "by two thirds, peaks at the edges fade. Depths grow ever slower, to about 2 µm each; "
      .. "volumes grow exactly with the distance, half and half." },
  { name = "fig10", title = "Figure 10. Who wears more", draw = effect_of_alpha,
    caption = "Final shapes and pressures of all twenty cases: a row for each stroke, a colour for "
      .. "each α.",
    shows = "From α = 0 to 1 the wear moves from the plate to the cylinder, whatever the stroke. "
      .. "The larger α, the flatter the pressure in the middle; peaks at its edges stand out most "
      .. "for α = 0.75. With "
      .. "s = 2R the pressure is Hertz' for α = 0 and nearly uniform for α = 1." },
  { name = "fig11", title = "Figure 11. Depths and pressure over distance", draw = courses,
    caption = "Largest depth of the cylinder and of the plate, and pressure at the centre, for the "
      .. "strokes a (top) and 4a (bottom).",
    shows = "With s = a the pressures of all α stay close together, and the cylinder's depth for "
      .. "α is the plate's for 1 - α. With s = 4a they part: for α = 0 the pressure falls almost "
      .. "in a straight line, for the others steeply at first. The cylinder wears deeper with the "
      .. "longer stroke, the plate less." },
  { name = "fig12", title = "Figure 12. The same, by stroke", draw = effect_of_stroke,
    caption = "Final shapes and pressures: a row for each α, a colour for each stroke.",
    shows = "A longer stroke spreads the plate's wear wider and thinner, so that the contact stays "
      .. "narrower and the cylinder wears deeper. For α = 1 the stroke makes no difference; for "
      .. "small α and long strokes the pressure stays close to Hertz'." },
  { name = "fig13", title = "Figure 13. Share of the depth", draw = depth_partition,
    caption = "Wear depth partition α̃ = h_c / (h_c + h_p) over distance for each stroke (mind the "
      .. "axis of d), and along the surface for s = a at the end (e).",
    shows = "With s = a, α̃ stays within 8 % of α, at every point of the scar's middle. Longer "
      .. "strokes raise it above α: by up to 1.3 for 2a, and for 4a by more than 1.8 at first, "
      .. "falling with the distance. Over the whole plate it is beyond 0.96 for every α." },
  { name = "fig14", title = "Figure 14. Both depths together", draw = sums,
    caption = "Sum of both wear profiles at the end, the bodies aligned, for each stroke.",
    shows = "With s = a the sum does not depend on α: one simulation tells all. The longer the "
      .. "stroke, the more it does." },
}

return list

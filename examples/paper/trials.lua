-- Draws Figure 8: how the profiles depend on the cycles per update, the increments per cycle and the
-- integration rule. Also draws the study of meshes, for which the paper has no figure.

local part = ...
local findings = part "findings"
local independent = part "independent"
local paper = require "archard.study.paper"
local parts = require "archard.study.panels"

local rules = { { "trapezoid", "Eq. (4)" }, { "simple", "Eq. (5)" } }

local function trial_case(cases, trial, rule)
  return findings.find(cases, { increments = trial[1], jump = trial[2], cycles = 1000, rule = rule })
end

-- Formats an asymmetry as a percentage. Values below 1e-9 are rounding errors and become 0 %.
local function percent(value)
  return value < 1e-9 and "0 %" or value < 1e-6 and ("%.0e"):format(value) or ("%.2g %%"):format(100 * value)
end

-- --- Fig. 8 --------------------------------------------------------------------------------------

-- Returns one curve for each of the chosen trials, or nil if a case is missing. If `body` is given,
-- the title of each curve contains the asymmetry of this body's profile.
local function curves_of(cases, chosen, name, rule, body)
  local curves = {}
  for i, trial in ipairs(chosen) do
    local case = trial_case(cases, trial, rule)
    if not case then return nil end
    local title = name(trial)
    if body then title = ("%s: %s"):format(title, percent(findings.asymmetry(case, body))) end
    curves[i] = { case = case, title = title, series = i }
  end
  return curves
end

-- Positions of the key at which it covers no curve.
local places = { cylinder = "top left", plate = "bottom left", pressure = "top right" }
local heights = { cylinder = { 0, 6 }, plate = { -0.8, 0.05 }, pressure = { 0, 500 } }

-- Returns a function that draws the chosen trials with one row of panels for each integration rule.
-- `chosen` is a list of { increments, jump }. `name` returns the label of a trial.
local function trials(chosen, name)
  return function(cases)
    local panels = {}
    for _, rule in ipairs(rules) do
      for _, kind in ipairs{ "cylinder", "plate", "pressure" } do
        local body = kind ~= "pressure" and kind or nil
        local curves = curves_of(cases, chosen, name, rule[1], body)
        if not curves then return nil end
        panels[#panels + 1] = parts.panel(kind, curves, { reach = 2.6,
          title = ("%s by %s"):format(kind, rule[2]), yrange = heights[kind] })
        panels[#panels].key = places[kind]
      end
    end
    return { panels = panels, layout = { 2, 3 }, size = { 1320, 880 } }
  end
end

local function name_jump(trial) return ("N̄ = %d"):format(trial[2]) end
local function name_increments(trial) return ("n_c = %d"):format(trial[1]) end

-- Returns the largest asymmetry of a body among the chosen trials with an integration rule.
local function worst(cases, chosen, rule, body)
  local most = 0
  for _, trial in ipairs(chosen) do
    most = math.max(most, findings.asymmetry(trial_case(cases, trial, rule), body))
  end
  return most
end

-- Joins a list of texts: "16, 40, 100 and 200".
local function listed(list)
  return table.concat(list, ", ", 1, #list - 1) .. " and " .. list[#list]
end

local few = { { 40, 50 }, { 40, 100 }, { 40, 200 } }
local many = { { 200, 50 }, { 200, 100 }, { 200, 200 } }
local fewer = { { 16, 100 }, { 40, 100 }, { 100, 100 }, { 200, 100 } }

local function ripple(cases, trial)
  return percent(findings.ripple(trial_case(cases, trial, "trapezoid")))
end

local function shows_few(cases)
  return ("The symmetry depends on the integration rule. By Eq. (5), the upper sum, plates "
    .. "are asymmetric by up to %s of their depth, and cylinders by %s at most: what the paper shows. "
    .. "By Eq. (4), the trapezoid that it recommends, all are mirror images to %s. Ripples are another "
    .. "matter: the pressure's sawtooth is %s of the pressure at the centre with 50 cycles between "
    .. "updates, %s with 100, %s with 200, where the paper has numerous irregularities."):format(
    percent(worst(cases, few, "simple", "plate")), percent(worst(cases, few, "simple", "cylinder")),
    percent(math.max(worst(cases, few, "trapezoid", "plate"),
      worst(cases, few, "trapezoid", "cylinder"))),
    ripple(cases, few[1]), ripple(cases, few[2]), ripple(cases, few[3]))
end

local function shows_many(cases)
  return ("With n_c = 200 the asymmetricness by Eq. (5) is down to %s. The pressure's sawtooth for 200 "
    .. "cycles between updates stays (%s with n_c = 40, %s with 200): ripples belong to the step in "
    .. "wear, asymmetry to that along the stroke."):format(
    percent(worst(cases, many, "simple", "plate")), ripple(cases, few[3]), ripple(cases, many[3]))
end

local function shows_fewer(cases)
  local counts, shares = {}, {}
  for i, trial in ipairs(fewer) do
    counts[i] = ("%d"):format(trial[1])
    shares[i] = percent(findings.asymmetry(trial_case(cases, trial, "simple"), "plate"))
  end
  return ("The paper's profiles get symmetric with n_c = 100, its plate's last. That is Eq. (5): the "
    .. "plate's asymmetry is %s for n_c = %s, the cylinder's at most %s. By Eq. (4) it is %s "
    .. "whatever n_c."):format(listed(shares), listed(counts),
    percent(worst(cases, fewer, "simple", "cylinder")),
    percent(worst(cases, fewer, "trapezoid", "plate")))
end

-- --- the study of meshes -------------------------------------------------------------------------

local function mesh_case(cases, alpha, size)
  for _, case in ipairs(cases) do
    if case.status == "done" and case.alpha == alpha
      and math.abs(case.model.mesh.size - size) < 1e-9 then return case end
  end
end

local worn = { 0.25, 0.5, 0.75, 1 }

local function meshes(cases)
  local panels = {}
  for _, alpha in ipairs(worn) do
    local curves = {}
    for i, size in ipairs(paper.sizes) do
      local case = mesh_case(cases, alpha, size)
      if not case then return nil end
      curves[i] = { case = case, series = i,
        title = ("%g µm: %.2f"):format(1e3 * size, findings.edge(case)) }
    end
    panels[#panels + 1] = parts.panel("pressure", curves, { reach = 3,
      title = ("α = %g"):format(alpha), yrange = { 0, 300 } })
    panels[#panels].key = "top right"
  end
  return { panels = panels, layout = { 2, 2 }, size = { 1200, 860 } }
end

local function shows_meshes(cases)
  local off, peaks = 0, {}
  local last, first = paper.sizes[#paper.sizes], paper.sizes[1]
  for _, alpha in ipairs(worn) do
    local fine, coarse = mesh_case(cases, alpha, last), mesh_case(cases, alpha, first)
    off = math.max(off, math.abs(coarse.p_center / fine.p_center - 1))
  end
  for i, size in ipairs(paper.sizes) do
    peaks[i] = ("%.2f"):format(findings.edge(mesh_case(cases, 0.75, size)))
  end
  return ("Pressures at the centre are within %.1f %% of those on the finest mesh. The peaks at the "
    .. "edges of the scar for α = 0.75 are not settled: %s times the centre's pressure on 20, 10 and "
    .. "5 µm; an independent solution with cells of 5 µm has %.2f."):format(100 * off, listed(peaks),
    independent.edges[0.75])
end

-- Returns the results of the study of meshes as rows of texts for the page.
local function mesh_rows(cases)
  local rows = { { "size / µm", "α", "h_c / µm", "h_p / µm", "p at the centre / MPa",
    "largest p / p at the centre", "updates" } }
  for _, size in ipairs(paper.sizes) do
    for _, alpha in ipairs(worn) do
      local case = mesh_case(cases, alpha, size)
      rows[#rows + 1] = { ("%g"):format(1e3 * size), ("%g"):format(alpha),
        ("%.4f"):format(1e3 * case.depth.cylinder), ("%.4f"):format(1e3 * case.depth.plate),
        ("%.2f"):format(case.p_center), ("%.3f"):format(findings.edge(case)),
        ("%d"):format(case.update) }
    end
  end
  return rows
end

-- --- the list ------------------------------------------------------------------------------------

return {
  mesh_rows = mesh_rows,
  trials = {
    { name = "fig8a", title = "Figure 8a. Too few increments", draw = trials(few, name_jump),
      caption = "Stroke a, α = 0.5 after 1000 cycles with n_c = 40 increments a cycle and 50, 100 or "
        .. "200 cycles between updates, by the trapezoid (top) and by the upper sum (bottom). Keys "
        .. "tell the largest difference of a profile to its mirror image, as a share of its depth.",
      shows = shows_few },
    { name = "fig8b", title = "Figure 8b. Enough increments", draw = trials(many, name_jump),
      caption = "The same with n_c = 200 increments a cycle.", shows = shows_many },
    { name = "fig8c", title = "Figure 8c. Fewer and fewer increments",
      draw = trials(fewer, name_increments),
      caption = "100 cycles between updates, with 16, 40, 100 and 200 increments a cycle.",
      shows = shows_fewer },
  },
  meshes = {
    { name = "meshes", title = "Meshes. Worn pressures on smaller elements", draw = meshes,
      caption = "Stroke a at the end of the distance: pressure on elements of 20, 10 and 5 µm, with "
        .. "as many more updates (geometry frozen). The keys show the largest pressure divided by that at the "
        .. "centre.", shows = shows_meshes },
  },
}

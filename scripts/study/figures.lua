-- Lua method study:figures: draws the results of a study. Studies of the paper are drawn like the figures of
-- the paper (examples/paper/figures.lua). Figures of other studies show the final shapes, the pressures and
-- the histories.

local archard = require "archard"
local check = require "archard.lib.check"
local merged = require "archard.lib.merged"
local measure = require "archard.measure"
local named = require "archard.study.case".named
local naming = require "archard.plot.naming"
local panels = require "archard.study.panels"
local style = require "archard.plot.style"

local figures = {}

-- --- figures of any study ------------------------------------------------------------------------

local most_curves = 8 -- largest number of curves in a picture, equal to the number of colours

-- Returns the title of a case, such as "α = 0.25, s = 0.11 mm", if all varied settings are numbers, else the
-- label of the case.
local function title_of(case)
  local parts = {}
  for _, name in ipairs(case.study.varied) do
    local value = case.study.flat[case.id][name]
    if type(value) ~= "number" then return case.label end
    parts[#parts + 1] = naming.value_of(name, value)
  end
  return parts[1] and table.concat(parts, ", ") or case.label
end

local function finished(cases)
  local curves = {}
  for _, case in ipairs(cases) do
    if case.status == "done" and case.last and #curves < most_curves then
      curves[#curves + 1] = { case = case, title = title_of(case), series = #curves + 1 }
    end
  end
  return curves
end

-- Returns a text such as "8 of 9 cases" if some cases are not drawn, else nil.
local function share_of(curves, cases)
  return #curves < #cases and ("%d of %d cases"):format(#curves, #cases) or nil
end

-- Returns half the width of the picture [mm]: the largest half width of the contacts, worn or unworn, and a
-- margin.
local function reach_of(curves, widen)
  local reach = 0
  for _, curve in ipairs(curves) do
    local case = curve.case
    local wide = math.max(case.half_width, case.hertz.half_width)
    if widen then wide = wide + math.min(case.stroke, 10) / 2 end
    reach = math.max(reach, wide)
  end
  return 1.3 * reach
end

-- Returns the figure of final profiles and pressures, and a text if not all cases are drawn. Returns nil for
-- joints, which have no profiles.
local function final_state(cases)
  local curves = finished(cases)
  if #curves == 0 or not curves[1].case.hertz then return nil end
  local reach, share = reach_of(curves), share_of(curves, cases)
  return { title = share, layout = { 1, 3 }, size = { 1260, 460 }, panels = {
    panels.panel("cylinder", curves, { title = "cylinder", reach = reach, mm = true }),
    panels.panel("plate", curves, { title = "plate", reach = reach_of(curves, true), mm = true }),
    panels.panel("pressure", curves, { title = "pressure", reach = reach, mm = true }) } }, share
end

local function histories(cases)
  local curves = finished(cases)
  if #curves == 0 then return nil end
  local share, bodies = share_of(curves, cases), measure.bodies(named(curves[1].case))
  local pressure, of = "p_center", "pressure at the centre / MPa"
  if not curves[1].case.last.p_center then pressure, of = "p_peak", "largest pressure of a cycle / MPa" end
  return { title = share, layout = { 1, 3 }, size = { 1260, 460 }, panels = {
    panels.course("depth_cylinder", 1e3, ("depth of %s / µm"):format(bodies.upper), curves, {}),
    panels.course("depth_plate", 1e3, ("depth of %s / µm"):format(bodies.lower), curves, {}),
    panels.course(pressure, 1, of, curves, { yrange = { 0 } }) } }, share
end

-- The figures of a general study. draw(cases) returns the figure or nil, and a text if not all cases are
-- drawn.
local general = {
  { name = "final", title = "Final state", draw = final_state,
    caption = "Worn shapes and pressures at the end of the runs.", shows = "" },
  { name = "history", title = "Course", draw = histories,
    caption = "Depths and pressure at the centre over the sliding distance.", shows = "" },
}

-- --- drawing -------------------------------------------------------------------------------------

local fields = {
  dir = check.file,
  term = check.kind('"svg", "png", "pdf", "dumb" or a list of them', function(v)
    for _, each in ipairs(type(v) == "table" and v or { v }) do
      if each ~= "svg" and each ~= "png" and each ~= "pdf" and each ~= "dumb" then return false end
    end
    return type(v) == "string" or (type(v) == "table" and #v > 0)
  end),
}

local of_the_paper = { paper = true, trials = true, ["meshes of the paper"] = true }

local function set_of(study)
  if not of_the_paper[study.name] then return general end
  return require "archard.lib.examples_folder".parts("study:figures", "paper")("figures")[study.name]
end

-- Returns the caption of a figure. given: the caption or a function that makes the caption from the drawn
-- cases.
local function words(given, cases)
  return type(given) == "function" and given(cases) or given
end

local function draw_one(options, dir, name, term)
  local file = term ~= "dumb" and ("%s/%s.%s"):format(dir, name, term) or nil
  local copy = merged(options, { file = file })
  if not file or style.in_mm() then copy.size = nil end
  archard.plot(copy)
  return file
end

local function make_folder(dir)
  local fine, why = require "archard.process".make_folder(dir)
  if not fine then check.fail("study:figures", ("%s: %s"):format(dir, why), "IO") end
end

-- figures.draw(study, { dir=, term= }) draws the figures of a study. Returns a list of { name=, title=,
-- caption=, shows=, files= } for the drawn figures.
function figures.draw(study, options)
  options = options or {}
  options = check.fields("study:figures", options, fields)
  local terms = type(options.term) == "table" and options.term or { options.term or "svg" }
  local dir = options.dir or "figures"
  if terms[1] ~= "dumb" then make_folder(dir) end
  local drawn, cases = {}, study:cases()
  for _, figure in ipairs(set_of(study)) do
    local made, share = figure.draw(cases)
    if made then
      local files = {}
      for _, term in ipairs(terms) do files[#files + 1] = draw_one(made, dir, figure.name, term) end
      drawn[#drawn + 1] = { name = figure.name, title = figure.title,
        caption = words(figure.caption, cases) .. (share and " " .. share .. "." or ""),
        shows = words(figure.shows, cases), files = files }
    end
  end
  return drawn
end

return figures

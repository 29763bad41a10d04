-- Draws Figure 5 (the meshes) and Figure 6b (the position of the plate during a cycle) from the
-- cases of the paper's study.

local part = ...
local findings = part "findings"
local paper = require "archard.study.paper"

-- --- Fig. 5 --------------------------------------------------------------------------------------

-- Returns a curve through the deepest node of each column of the wear box.
local function floor_of(body)
  local nodes, per_column = body:box(), body.rows + 1
  local curve = { x = {}, y = {}, title = "end of the wear box", colour = "black", width = 2,
    style = "lines" }
  for at = per_column, #nodes, per_column do
    curve.x[#curve.x + 1], curve.y[#curve.y + 1] = body:node(nodes[at])
  end
  return curve
end

-- Each view has a title, half of its width, its depth in the plate and its height in the cylinder
-- [mm]. A view without sizes shows the whole bodies.
local views = { { "both bodies" }, { "outer partitions", 2.2, 1.6, 1.1 },
  { "inner partitions", 0.65, 0.55, 0.55 }, { "wear boxes", 0.14, 0.1, 0.1 } }

local function view(model, which)
  local title, half, below, above = table.unpack(which)
  local box = half and { -half, half, -below, above }
  local panel = { title = title, xlabel = "x / mm", ylabel = "y / mm", equal = true, key = "none",
    xrange = box and { -half, half }, yrange = box and { -below, above } }
  local handed = half and { -2 * half, 2 * half, -2 * below, 2 * above } -- wider than the view
  for series, name in ipairs{ "cylinder", "plate" } do
    local curve = require "archard.plot.mesh".edges(model.mesh[name], handed)
    curve.series, curve.dash, curve.width = series, 1, half and half < 0.2 and 1 or 0.5
    panel[#panel + 1] = curve
    if half and half < 0.2 then panel[#panel + 1] = floor_of(model.mesh[name]) end
  end
  return panel
end

-- Returns the model of the case with alpha = 0.5 and stroke a, or nil if this case is missing.
local function model_of(cases)
  local case = findings.case(cases, 0.5, 1)
  return case and case:wear().model
end

local function meshes(cases)
  local model = model_of(cases)
  if not model then return nil end
  local panels = {}
  for i, which in ipairs(views) do panels[i] = view(model, which) end
  return { panels = panels, layout = { 2, 2 }, size = { 1300, 1100 } }
end

local function caption_meshes(cases)
  local mesh, nodes, elements = model_of(cases).mesh, 0, 0
  local wanted = findings.case(cases, 0.5, 1).model.mesh
  for _, name in ipairs{ "cylinder", "plate" } do
    nodes, elements = nodes + mesh[name].nodes, elements + #mesh[name]:elements() // 4
  end
  return ("Half cylinder and plate: %d nodes, %d elements, %g x %g µm at the contact. Beyond the "
    .. "black lines (d), away from the contact, nothing moves."):format(nodes, elements, 1e3 * wanted.size,
    1e3 * wanted.height)
end

-- --- Fig. 6b -------------------------------------------------------------------------------------

local function positions(cases)
  local panels = { { title = "reciprocating, r = 2" }, { title = "single pass, r = 1" } }
  for _, panel in ipairs(panels) do
    panel.xlabel, panel.ylabel, panel.xrange = "t / T", "x / mm", { 0, 1 }
  end
  for column, name in ipairs(paper.stroke_names) do
    local case, back = findings.case(cases, 0.5, column), column < 4
    if not case then return nil end
    local s, panel = case.stroke, panels[back and 1 or 2]
    panel[#panel + 1] = { x = back and { 0, 0.5, 1 } or { 0, 1 },
      y = back and { -s / 2, s / 2, -s / 2 } or { -s / 2, s / 2 }, title = "s = " .. name,
      series = column }
  end
  return { panels = panels, layout = { 1, 2 }, size = { 1100, 430 } }
end

return {
  { name = "fig5", title = "Figure 5. Meshes", draw = meshes, caption = caption_meshes,
    shows = "Elements grow from the contact to the far ends of the bodies; each mesh is its own "
      .. "mirror image. Only the three rows of elements at the contact, the wear box, change as the "
      .. "surfaces wear." },
  { name = "fig6b", title = "Figure 6b. Position of the plate", draw = positions,
    caption = "Position of the plate over one cycle of period T.",
    shows = "The strokes a, 2a and 4a go there and back; that of 2R goes over the whole plate one way "
      .. "only. A cycle then slides s instead of 2s, in Eq. (28) too." },
}

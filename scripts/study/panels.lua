-- Makes curves of cases, and panels with these curves, for the figures of studies. Lengths along the surface
-- are in mm or in units of a, the half width of the unworn contact.

local panels = {}

-- --- curves --------------------------------------------------------------------------------------

local function map(list, f)
  local result = {}
  for i = 1, #list do result[i] = f(list[i], i) end
  return result
end

function panels.over_a(case, x)
  local a = case.hertz.half_width
  return map(x, function(value) return value / a end)
end

-- Returns the worn surface of a body as a curve of heights [um], which are the unworn shape minus the wear
-- depth.
function panels.shape(case, body, distance, mm)
  local profile = case:profile(body, distance)
  local radius = case.model.radius
  local y = map(profile.x, function(x, i)
    local unworn = radius - math.sqrt(math.max(0, radius * radius - x * x))
    return 1e3 * (body == "cylinder" and unworn + profile.h[i] or -profile.h[i])
  end)
  return { x = mm and profile.x or panels.over_a(case, profile.x), y = y }
end

function panels.pressure(case, body, distance, mm)
  local pressure = case:pressure(body or "cylinder", distance)
  return { x = mm and pressure.x or panels.over_a(case, pressure.x), y = pressure.p }
end

function panels.history(case, name, factor)
  local history = case.history
  return { x = history.distance, y = map(history[name], function(value) return value * factor end) }
end

-- --- panels --------------------------------------------------------------------------------------

-- Functions that return a panel without curves, by the kind of the panel. reach: half the width of the panel
-- in units of a. Heights are measured from the first point of contact of the unworn surfaces.
local kinds = {
  cylinder = function(reach)
    return { ylabel = "height of cylinder / µm", xlabel = "x / a", xrange = { -reach, reach },
      yrange = { 0, nil } }
  end,
  plate = function(reach)
    return { ylabel = "height of plate / µm", xlabel = "x / a", xrange = { -reach, reach } }
  end,
  pressure = function(reach)
    return { ylabel = "p / MPa", xlabel = "x / a", xrange = { -reach, reach }, yrange = { 0 } }
  end,
}

-- Returns a panel of shapes or pressures. kind: "cylinder", "plate" or "pressure"; curves: list of { case=,
-- title=, distance=, series= }. With options.mm, x and options.reach are in mm.
function panels.panel(kind, curves, options)
  local panel = kinds[kind](options.reach or 3)
  for i, curve in ipairs(curves) do
    local made = kind == "pressure" and panels.pressure(curve.case, options.body, curve.distance,
        options.mm)
      or panels.shape(curve.case, kind, curve.distance, options.mm)
    made.title, made.series, made.dash = curve.title, curve.series, curve.dash
    panel[i] = made
  end
  panel.title = options.title
  panel.xlabel = options.mm and "x / mm" or panel.xlabel
  panel.yrange = options.yrange or panel.yrange
  return panel
end

-- Returns a panel with a history column of several cases over the sliding distance. Values are multiplied by
-- `factor`.
function panels.course(column, factor, label, curves, options)
  local panel = { xlabel = "d / mm", ylabel = label, title = options.title, yrange = options.yrange,
    xrange = options.xrange }
  for i, curve in ipairs(curves) do
    local made = panels.history(curve.case, column, factor)
    made.title, made.series = curve.title, curve.series
    panel[i] = made
  end
  return panel
end

return panels

-- The parts that figures of studies are made of: curves of a case and panels around them, with
-- lengths along the surface in units of the unworn contact's half width a, as the paper has them, or
-- in mm.

local parts = {}

-- --- curves --------------------------------------------------------------------------------------

local function map(list, f)
  local result = {}
  for i = 1, #list do result[i] = f(list[i], i) end
  return result
end

local function over_a(case, x)
  local a = case.hertz.half_width
  return map(x, function(value) return value / a end)
end

-- Height of a worn surface [um]: the unworn shape with the wear depth taken off.
function parts.shape(case, body, distance, mm)
  local profile = case:profile(body, distance)
  local radius = case.model.radius
  local y = map(profile.x, function(x, i)
    local unworn = radius - math.sqrt(math.max(0, radius * radius - x * x))
    return 1e3 * (body == "cylinder" and unworn + profile.h[i] or -profile.h[i])
  end)
  return { x = mm and profile.x or over_a(case, profile.x), y = y }
end

function parts.pressure(case, body, distance, mm)
  local pressure = case:pressure(body or "cylinder", distance)
  return { x = mm and pressure.x or over_a(case, pressure.x), y = pressure.p }
end

function parts.sum(case)
  local sum = case:combined()
  return { x = over_a(case, sum.x), y = map(sum.h, function(h) return 1e3 * h end) }
end

function parts.local_partition(case)
  local share = case:local_partition()
  return { x = over_a(case, share.x), y = share.value }
end

function parts.history(case, name, factor, against)
  local history = case.history
  return { x = history[against or "distance"],
    y = map(history[name], function(value) return value * (factor or 1) end) }
end

-- --- panels --------------------------------------------------------------------------------------

-- `reach`: half the width shown, in a. Heights are those of the worn surfaces above the point where
-- they first touched.
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

-- A panel of shapes or pressures: kind "cylinder", "plate" or "pressure"; curves is a list of
-- { case=, title=, distance=, series= }. options.mm: x, and reach, in mm.
function parts.panel(kind, curves, options)
  local panel = kinds[kind](options.reach or 3)
  for i, curve in ipairs(curves) do
    local made = kind == "pressure" and parts.pressure(curve.case, options.body, curve.distance,
        options.mm)
      or parts.shape(curve.case, kind, curve.distance, options.mm)
    made.title, made.series, made.dash = curve.title, curve.series, curve.dash
    panel[i] = made
  end
  panel.title = options.title
  panel.xlabel = options.mm and "x / mm" or panel.xlabel
  panel.yrange = options.yrange or panel.yrange
  return panel
end

-- A panel of histories: column, its factor, label.
function parts.course(column, factor, label, curves, options)
  local panel = { xlabel = "d / mm", ylabel = label, title = options.title, yrange = options.yrange,
    xrange = options.xrange }
  for i, curve in ipairs(curves) do
    local made = parts.history(curve.case, column, factor)
    made.title, made.series = curve.title, curve.series
    panel[i] = made
  end
  return panel
end

-- --- cases by their settings -----------------------------------------------------------------------

-- The finished case whose settings are these; nil: there is none.
function parts.find(cases, wanted)
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

-- The distance of the look nearest to a share of the whole.
function parts.look(case, share)
  local best
  local wanted = share * case.distance
  for _, distance in ipairs(case:distances()) do
    if not best or math.abs(distance - wanted) < math.abs(best - wanted) then best = distance end
  end
  return best
end

return parts

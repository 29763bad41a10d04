-- plot.fretting_map: draws a running condition fretting map, which shows the regimes stick, partial slip and
-- gross slip over motion amplitude and load.

local check = require "archard.lib.check"
local draw = require "archard.plot.draw"
local naming = require "archard.plot.naming"
local shapes = require "archard.plot.shapes"

local where = "plot.fretting_map"

local regimes = { { name = "stick", series = 3 }, { name = "partial", title = "partial slip", series = 5 },
  { name = "gross", title = "gross slip", series = 2 } }

local function title_of(regime) return regime.title or regime.name end

local function constant(value, count)
  local list = {}
  for i = 1, count do list[i] = value end
  return list
end

-- Returns the filled area of a regime between its left and right border, as a closed curve.
local function ground(map, regime, left, right)
  local area = shapes.area(map.load, left, right, 1)
  local x, y = area.y, area.x
  x[#x + 1], y[#y + 1] = x[1], y[1]
  return { x = x, y = y, style = "filled", series = regime.series, title = title_of(regime), on = "pixels" }
end

local function add_grounds(given, map, partial, gross, from, to)
  local n = #map.load
  local at = { constant(from, n), partial, gross, constant(to, n) }
  for i, regime in ipairs(n > 1 and regimes or {}) do given[i] = ground(map, regime, at[i], at[i + 1]) end
end

-- Returns the computed points of the map that are in a regime, or all points if `regime` is nil.
local function conditions_of(map, regime)
  local curve = { x = {}, y = {}, style = "points" }
  for i, load in ipairs(map.load) do
    for j, motion in ipairs(map.motion) do
      if not regime or map.regime[i][j] == regime.name then
        curve.x[#curve.x + 1], curve.y[#curve.y + 1] = 1000 * motion, load
      end
    end
  end
  return #curve.x > 0 and curve or nil
end

-- Adds the computed points: in black if the regimes are filled areas, else in the colour of their regime.
local function add_conditions(given, map)
  local ground = #map.load > 1
  for _, regime in ipairs(regimes) do
    local curve = conditions_of(map, regime)
    if curve then
      curve.series, curve.title, curve.on = regime.series, title_of(regime), ground and "characters" or nil
      given[#given + 1] = curve
    end
  end
  if not ground then return end
  local all = conditions_of(map)
  all.series, all.colour, all.title, all.on = 1, "black", "computed", "pixels"
  given[#given + 1] = all
end

-- Adds the two borders between the regimes as lines. For a single load each border is a point.
local function add_borders(given, map, partial, gross)
  local style = #map.load > 1 and "lines" or "points"
  given[#given + 1] = { x = partial, y = map.load, style = style, series = 7, dash = 1,
    title = ("%g %% slips"):format(100 * map.annulus) }
  given[#given + 1] = { x = gross, y = map.load, style = style, series = 8, dash = 1, title = "all slips" }
end

-- plot.fretting_map(map, { ... }) draws a result of study.fretting_map{}.
return function(map, options)
  if not naming.get(map, "gross_from") then
    check.fail(where, "expected a result of study.fretting_map{}, got " .. check.shown(map))
  end
  options = draw.options(where, options, {})
  local partial, gross = shapes.scaled(map.partial_from, 1000), shapes.scaled(map.gross_from, 1000)
  local motions = shapes.scaled(map.motion, 1000)
  local most = 1.1 * math.max(motions[#motions], gross[#gross])
  local least = options.logx and math.min(motions[1], partial[1]) / 1.5 or 0
  local given = {}
  add_grounds(given, map, partial, gross, least, most)
  add_borders(given, map, partial, gross)
  add_conditions(given, map)
  local low, high = map.load[1], map.load[#map.load]
  local margin = low < high and 0.05 * (high - low) or low
  given.yrange = { options.logy and low / 1.1 or low - margin, high + margin }
  given.xlabel, given.ylabel, given.xrange = "amplitude of the motion / µm", "load / N", { least, most }
  given.title = ("running condition fretting map: μ = %g"):format(map.friction)
  draw.draw(where, draw.over(given, options))
end

-- study.fretting_map: which loads and motions lead to stick, partial slip and gross slip, from the steady cycle of
-- unworn surfaces; and the borders between, by bisection.

local check = require "archard.lib.check"
local merged = require "archard.lib.merged"
local strict = require "archard.strict"

local where = "study.fretting_map"

local usual_friction, usual_increments = 0.6, 40
local sticks = 0.9 -- of the width: at the very edges every contact slips
local close = 1.01 -- of borders

local growing = check.list_of(check.positive, "a list of increasing numbers > 0", true)

local fields = { load = growing, motion = growing }
for _, setting in ipairs(require "archard.settings".wear) do
  fields[setting.name] = fields[setting.name] or check.any "a field of wear{}"
end
for _, own in ipairs{ "stroke", "tangential", "loading", "distance", "cycles" } do fields[own] = nil end

local function regime_of(given, load, motion)
  local w <close> = check.as(where, wear, merged(given, { load = load, stroke = 2 * motion, cycles = 1 }))
  local loop = check.as(where, w.loop, w)
  if loop.gross then return "gross" end
  return loop.stick_width >= sticks * 2 * w.half_width and "stick" or "partial"
end

local rank = { stick = 1, partial = 2, gross = 3 }

-- The amplitude from which on a regime is at least the one of `name`.
local function border(given, load, name, guess)
  local function reached(motion) return rank[regime_of(given, load, motion)] >= rank[name] end
  local low, high = guess, guess
  while reached(low) do low = low / 2 end
  while not reached(high) do high = 2 * high end
  while high > close * low do
    local middle = math.sqrt(low * high)
    if reached(middle) then high = middle else low = middle end
  end
  return math.sqrt(low * high)
end

-- --- the picture ---------------------------------------------------------------------------------

local function um(list) return require "archard.plot.shapes".scaled(list, 1000) end

local function points_of(self, name)
  local curve = { x = {}, y = {}, style = "points", title = name == "stick" and name or name .. " slip" }
  for i, load in ipairs(self.load) do
    for j, motion in ipairs(self.motion) do
      if self.regime[i][j] == name then
        curve.x[#curve.x + 1], curve.y[#curve.y + 1] = 1000 * motion, load
      end
    end
  end
  return curve
end

local methods = {}
local class = { __name = "fretting_map", __methods = methods,
  __fields = { "load", "motion", "regime", "partial_from", "gross_from" } }

function methods:plot(options)
  local draw = require "archard.plot.draw"
  options = draw.options("fretting_map:plot", options, {})
  local given = { xlabel = "amplitude of the motion / µm", ylabel = "load / N", title = "running condition fretting map" }
  for _, name in ipairs{ "stick", "partial", "gross" } do
    local points = points_of(self, name)
    if #points.x > 0 then given[#given + 1] = points end
  end
  if #self.load > 1 then
    given[#given + 1] = { x = um(self.partial_from), y = self.load, title = "partial slip from here" }
    given[#given + 1] = { x = um(self.gross_from), y = self.load, title = "gross slip from here" }
  end
  draw.draw("fretting_map:plot", draw.over(given, options))
end

function class.__tostring(self)
  local lines = { "   load / N   partial slip from / um   gross slip from / um" }
  for i, load in ipairs(self.load) do
    lines[#lines + 1] = ("%11.4g %24.4f %22.4f"):format(load, 1000 * self.partial_from[i], 1000 * self.gross_from[i])
  end
  return table.concat(lines, "\n")
end

strict.class(class)

return function(given)
  check.definition(where, given, fields)
  for _, name in ipairs{ "load", "motion" } do
    if given[name] == nil then check.refuse(where, name, growing.expected, nil) end
  end
  local base = merged({ friction = usual_friction, increments = usual_increments }, given)
  base.motion = nil
  if not base.model then base.model = model{ mesh = { size = 0.01, height = 0.0125 } } end
  local self = { load = given.load, motion = given.motion, regime = {}, partial_from = {}, gross_from = {} }
  local guess = given.motion[1]
  for i, load in ipairs(given.load) do
    self.regime[i] = {}
    for j, motion in ipairs(given.motion) do self.regime[i][j] = regime_of(base, load, motion) end
    self.partial_from[i] = border(base, load, "partial", guess)
    self.gross_from[i] = border(base, load, "gross", self.partial_from[i])
  end
  return setmetatable(self, class)
end

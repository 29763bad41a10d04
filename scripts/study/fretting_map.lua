-- Lua function study.fretting_map: computes for each load and motion amplitude whether the contact sticks,
-- slips partially or slips grossly, and computes the borders between these regimes. The contact is under an
-- alternating tangential force in periodic cycles. plot/fretting_map.lua draws the map.
--
-- A smooth contact slips at its edges under any tangential force. Therefore partial slip is defined to begin
-- when the slip annulus reaches a given fraction of the contact width. Such a small annulus is usually
-- narrower than one element, so the border is computed by a fit. The width of the stick zone is computed at
-- forces up to sliding, and 1 - (stick width / contact width)^n is fitted by b1 s + b2 s^2, where s is the
-- force divided by the sliding force. For the Hertz contact the fitted expression equals s, with n = 2 for
-- cylinders and 3 for balls (Cattaneo and Mindlin).

local check = require "archard.lib.check"
local merged = require "archard.lib.merged"
local run_counter = require "archard.lib.run_counter"
local strict = require "archard.strict"

local where = "study.fretting_map"

local usual = { friction = 0.6, annulus = 0.1 }
-- levels: number of force levels of the fit; last_level: largest level as a fraction of the sliding force.
local levels, last_level = 18, 0.9
local sliding = 1 - 1e-6
-- Number of increments in half a cycle. Few suffice, because the shear has little effect on the pressure.
local steps = 4

local fields = { load = check.any "a list", motion = check.any "a list", friction = check.positive, annulus = check.share }
for _, setting in ipairs(require "archard.settings".contact) do
  fields[setting.name] = fields[setting.name] or check.any "a field of contact{}"
end
for _, own in ipairs{ "x", "load_angle", "average" } do fields[own] = nil end

-- Raises an error if a field is not a list of increasing positive numbers.
local function check_growing(given, name, unit)
  local list = given[name]
  if not check.list.test(list) or #list == 0 then
    check.refuse(where, name, ("a list of increasing numbers > 0 in %s"):format(unit), list)
  end
  for i, value in ipairs(list) do
    local least = i > 1 and list[i - 1] or 0
    if not (check.positive.test(value) and value > least) then
      check.refuse(where, ("%s[%d]"):format(name, i), ("a number > %g %s"):format(least, unit), value)
    end
  end
end

-- --- steady cycles -------------------------------------------------------------------------------

-- Returns the width of the stick zone at an end of a cycle as a fraction of the contact width. In 3-D this
-- fraction is the square root of the ratio of stick area and contact area. Returns nil if the slip is too
-- narrow for the mesh, which means that all nodes up to an edge stick.
local function share_of(contact)
  local zones, edges, sum = contact.stick, contact.edges, 0
  if type(zones) == "number" then return zones < 1 and math.sqrt(zones) or nil end
  if zones[1] and (zones[1].left <= edges.left or zones[#zones].right >= edges.right) then return nil end
  for _, zone in ipairs(zones) do sum = sum + zone.right - zone.left end
  return sum / (edges.right - edges.left)
end

-- Computes a cycle of the tangential force, whose amplitude is the fraction `share` of the friction limit.
-- Returns the contacts at both ends of the cycle.
local function cycle(pressed, share)
  local force = share * pressed.friction * pressed.load
  local function go(from, to) return check.as(where, from.move, from, { tangential = to, increments = steps }) end
  local back = go(go(pressed, force), -force)
  return back, go(back, force)
end

local function amplitude(pressed, share)
  local back, there = cycle(pressed, share)
  return (there.x - back.x) / 2
end

-- Returns the motion amplitude [mm] from which the whole contact slips. In 3-D, forces are accurate only to
-- 1e-5 of the sliding force. The amplitude is therefore extrapolated from 99 % of the sliding force by
-- Mindlin's 1 - (1 - s)^(2/3).
local function gross_amplitude(pressed)
  if type(pressed.stick) ~= "number" then return amplitude(pressed, sliding) end
  local near = 0.99
  return amplitude(pressed, near) / (1 - (1 - near) ^ (2 / 3))
end

-- --- borders -------------------------------------------------------------------------------------

local function exponent_of(contact) return type(contact.stick) == "number" and 3 or 2 end

-- Adds the contact at one end of a cycle to the normal equations for the coefficients b1 and b2.
local function add_end(sums, share, contact)
  local width = share_of(contact)
  if not width then return end
  for power = 2, 4 do sums[power] = sums[power] + share ^ power end
  for power = 1, 2 do sums.of[power] = sums.of[power] + share ^ power * (1 - width ^ exponent_of(contact)) end
  sums.count = sums.count + 1
end

-- Returns the force at which the slip annulus covers the fraction `annulus` of the contact width, divided
-- by the force at which the contact slides. If the contact slides before, returns `sliding`.
local function partial_share(pressed, annulus)
  local sums = { 0, 0, 0, 0, of = { 0, 0 }, count = 0 }
  for i = 1, levels do
    local share = last_level * i / levels
    local back, there = cycle(pressed, share)
    add_end(sums, share, back)
    add_end(sums, share, there)
  end
  if sums.count < 4 then return sliding end
  local det, target = sums[2] * sums[4] - sums[3] ^ 2, 1 - (1 - annulus) ^ exponent_of(pressed)
  local b1 = (sums.of[1] * sums[4] - sums.of[2] * sums[3]) / det
  local b2 = (sums.of[2] * sums[2] - sums.of[1] * sums[3]) / det
  local under = b1 ^ 2 + 4 * b2 * target
  local share = under >= 0 and 2 * target / (b1 + math.sqrt(under)) or sliding
  return share > 0 and math.min(share, sliding) or sliding
end

local function regime_of(self, i, motion)
  if motion >= self.gross_from[i] then return "gross" end
  return motion >= self.partial_from[i] and "partial" or "stick"
end

-- Computes the transitions and the regimes at one load, and appends them to the map as a row.
local function add_load(self, given, load)
  local i = #self.load + 1
  local pressed = check.as(where, contact, merged(given, { load = load }))
  self.load[i] = load
  self.partial_from[i] = amplitude(pressed, partial_share(pressed, self.annulus))
  self.gross_from[i] = gross_amplitude(pressed)
  self.regime[i] = {}
  for j, motion in ipairs(self.motion) do self.regime[i][j] = regime_of(self, i, motion) end
end

-- --- the map -------------------------------------------------------------------------------------

local class = { __name = "fretting_map", __methods = {},
  __fields = { "load", "motion", "friction", "annulus", "regime", "partial_from", "gross_from" } }

local function row(first, words, partial, gross)
  local cells = { ("%10s"):format(first) }
  for i, word in ipairs(words) do cells[i + 1] = ("%10s"):format(word) end
  cells[#cells + 1] = ("%18s %16s"):format(partial, gross)
  return table.concat(cells)
end

function class.__tostring(self)
  local motions = {}
  for j, motion in ipairs(self.motion) do motions[j] = ("%.4g um"):format(1000 * motion) end
  local lines = { row("load / N", motions, "partial from / um", "gross from / um") }
  for i, load in ipairs(self.load) do
    lines[i + 1] = row(("%.4g"):format(load), self.regime[i], ("%.4g"):format(1000 * self.partial_from[i]),
      ("%.4g"):format(1000 * self.gross_from[i]))
  end
  return table.concat(lines, "\n")
end

strict.class(class)

return function(given)
  given = check.definition(where, given, fields)
  check_growing(given, "load", "N")
  check_growing(given, "motion", "mm")
  local all = merged(usual, given)
  local self = setmetatable({ load = {}, motion = table.move(all.motion, 1, #all.motion, 1, {}), regime = {},
    friction = all.friction, annulus = all.annulus, partial_from = {}, gross_from = {} }, class)
  all.motion, all.annulus = nil, nil
  local counter <close> = run_counter.new(where, #given.load)
  for _, load in ipairs(given.load) do
    add_load(self, all, load)
    counter:ran()
  end
  return self
end

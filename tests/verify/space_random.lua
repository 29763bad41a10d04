-- Tests random histories in three dimensions: radii of 0.5 to 500 mm, ratios of E up to 1000, layers, rigid
-- bases, maps, any alpha, motions along x and z, strokes of 0.1 to 4 contact widths, grooves, tracks, laws
-- and local factors. Each run must end. With Archard's law the volume of both bodies must be k P d, and the
-- upper body's fraction of the volume alpha.
--   ARCHARD_RUNS=500 tests/run verify/space_random   more runs (an hour)

-- Long
local figures = dofile((arg[0]:match("^(.*)/") or ".") .. "/lib/figures.lua")
local below = figures.below
local random = math.random
math.randomseed(27)
local count = tonumber(os.getenv "ARCHARD_RUNS") or 40

local function between(low, high) return low * (high / low) ^ random() end
local function even(from, to, points)
  local list = {}
  for i = 1, points do list[i] = from + (to - from) * (i - 1) / (points - 1) end
  return list
end

-- Returns a lower body for a contact with a ball that has the half widths a (the smaller one) and b [mm].
local function partner(E, a, b, approach)
  local kind = random()
  if kind < 0.2 then return body.block{ E = E, layers = { { thickness = a * between(0.3, 3), E = between(1e3, 1e6) } } } end
  if kind < 0.3 then return body.block{ E = E, height = a * between(0.5, 5) } end
  if kind > 0.4 then return body.block{ E = E, nu = 0.45 * random() } end
  local waves = 0.2 * random() * approach
  return body.map{ E = E, y = map{ x = even(-6 * b, 6 * b, 60), z = even(-6 * b, 6 * b, 60),
    y = function(x, z) return waves * math.sin(7 * x / a) * math.cos(3 * z / a) end } }
end

local function motion(along, widest)
  local kind = random()
  if kind < 0.15 then return { track = between(8, 50) * widest } end
  if kind < 0.25 then return { stroke = between(12, 30) * along, procedure = "NSP" } end
  return { stroke = between(0.1, 4) * along }
end

local function history()
  local radius, E, load = between(0.5, 500), between(1e3, 1e6), between(0.1, 100)
  local radius_z = random() < 0.5 and radius or radius * between(0.3, 3)
  local other = between(1e3, 1e6)
  local h = hertz{ geometry = "3-D", radius = radius, radius_z = radius_z, load = load, cylinder = { E = E }, plate = { E = other } }
  local a, b = math.min(h.half_width, h.half_width_z), math.max(h.half_width, h.half_width_z)
  local slide = random() < 0.3 and "z" or "x"
  local def = motion(slide == "x" and h.half_width or h.half_width_z, b)
  local groove = def.track or def.procedure -- grooves exist only on a flat body
  local ball = body.ball{ radius = radius, radius_z = radius_z, E = E }
  local flat = groove and body.block{ E = other } or partner(other, a, b, h.approach)
  local turned = not groove and random() < 0.15
  def.model = { geometry = "3-D", upper = turned and flat or ball, lower = turned and ball or flat }
  def.load, def.slide, def.alpha = load, slide, ({ 0, 1, 0.5, random() })[random(4)]
  def.distance = between(0.05, 20) * h.approach * math.pi * a * b / (1e-8 * load)
  local law = random()
  if law < 0.15 then
    def.law, def.law_exponent, def.law_pressure = "power", 2 * random() - 0.5, h.p_max
  elseif law < 0.25 then
    def.local_factor = function(_, x, _, _, z) return 1 + 0.5 * math.sin(x / a) * math.cos(z / a) end
  end
  return def
end

local ended, off, share, updates = 0, 0, 0, 0
for i = 1, count do
  local def = history()
  local done, w = pcall(function()
    local made = wear(def)
    made:run{ progress = false }
    return made
  end)
  if done then
    ended, updates = ended + 1, math.max(updates, w.update)
    if not def.law and not def.local_factor then
      off = math.max(off, math.abs(w.volume.total / (1e-8 * def.load * def.distance) - 1))
      share = math.max(share, math.abs(w.volume.upper / w.volume.total - def.alpha))
    end
  else
    figures.note(("history %d: %s"):format(i, tostring(w)))
  end
end
figures.ok(ended == count, ("%d of %d histories end, with at most %d updates"):format(ended, count, updates))
below(off, 1e-9, "largest error of the volumes, fraction of k P d")
below(share, 1e-9, "largest error of the upper body's fraction of the volume")

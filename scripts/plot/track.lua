-- plot.track: draws the paths of points of a joint's head over its cup during a cycle, in an azimuthal
-- equal-area projection centred on the nominal load.

local check = require "archard.lib.check"
local draw = require "archard.plot.draw"
local flat = require "archard.joint.flat"
local given_gait = require "archard.joint.given_gait"
local joint_file = require "archard.joint.file"

-- Returns unit vectors to points of the head: the pole and six points at 30 degrees from it.
local function points()
  local list, s, c = { { 0, 0, 1 } }, math.sin(math.rad(30)), math.cos(math.rad(30))
  for i = 0, 5 do list[i + 2] = { s * math.cos(math.rad(60 * i)), s * math.sin(math.rad(60 * i)), c } end
  return list
end

-- Returns the position of point `m` of the head at instant `i` as a unit vector. The list `instants` has 15
-- numbers for each instant; the first nine are the rotation matrix.
local function turned(instants, i, m)
  local n = {}
  for k = 1, 3 do
    local at = 15 * i + 3 * (k - 1)
    n[k] = instants[at + 1] * m[1] + instants[at + 2] * m[2] + instants[at + 3] * m[3]
  end
  return n
end

-- plot.track(g, { radius=14, ... }) draws the gait g. For a run it draws the current gait, with the run's
-- head radius. radius: head radius [mm].
return function(g, options)
  local where = "plot.track"
  local run = joint_file.is_joint(g) and g
  if run then g = run.loading end
  if not given_gait.is(g) then check.fail(where, "expected a gait or the run of a joint as the first argument, got " .. check.shown(g)) end
  options = draw.options(where, options, { radius = check.positive })
  local radius, count, given = options.radius or run and run.model.head.radius or 14, g.increments, {}
  for number, m in ipairs(points()) do
    local path = flat.curve(radius, function(t) return turned(g.instants, math.floor(t * count + 0.5) % count, m) end, count)
    path.title = number == 1 and "pole" or number == 2 and "30 degrees from the pole" or nil
    path.series = number == 1 and 1 or 2
    given[number] = path
  end
  given.xlabel, given.ylabel, given.equal = "x (anterior) / mm", "z (flexion axis) / mm", true
  given.title = ("%s: paths of points of the head over the cup"):format(g.name)
  draw.draw(where, draw.over(given, options))
end

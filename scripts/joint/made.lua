-- Makes gaits: lists of instants with fifteen numbers each (rotation matrix, rotation vector and load).

local check = require "archard.lib.check"
local sphere = require "archard.sphere"
local strict = require "archard.strict"

local class = { __name = "gait", __fields = { "increments", "instants", "track", "work", "name" } }

function class:__tostring()
  return ("gait: %s, %d increments\n  for a head of 28 mm: track of the load %.4g mm, work %.4g N m per cycle"):format(self.name,
    self.increments, self.track, self.work / 1000)
end

-- Returns the fields from which a run file can make an equal gait.
function class.__settings(g) return { name = g.name, instants = g.instants } end

strict.class(class)

local most_lost = 0.01 -- largest relative error of path or work without a warning

-- Warns if the number of increments is so small that the error of the path or work exceeds `most_lost`. The
-- error with n increments is proportional to 1/n^2, so it is 4/3 of the change from n to 2n.
local function warn_of_few(name, count, track, work, finer)
  local fine_track, fine_work = sphere.path(finer, 14)
  local lost = 4 / 3 * math.max(1 - track / fine_track, math.abs(1 - work / fine_work))
  if lost > most_lost then
    warn(("gait %s: %d increments change its path or work by about %.2g %%; use about %d"):format(name, count, 100 * lost,
      math.ceil(count * math.sqrt(2 * lost / most_lost))))
  end
end

-- Warns if all angles of a gait are constant, since such a gait causes no wear.
local function warn_of_rest(name, instants)
  for i = 1, #instants, 15 do
    if instants[i + 9] ~= 0 or instants[i + 10] ~= 0 or instants[i + 11] ~= 0 then return end
  end
  warn(("gait %s: the head does not move: flexion, adduction and rotation are constant"):format(name))
end

-- Makes a gait. finer: the same gait with twice as many increments, or nil if the gait needs no check.
return function(name, instants, finer)
  if type(name) ~= "string" or type(instants) ~= "table" or #instants < 15 or #instants % 15 ~= 0 then
    check.fail("gait", "expected a name and fifteen numbers for each instant")
  end
  local track, work = sphere.path(instants, 14)
  if finer then warn_of_rest(name, instants) end
  if finer then warn_of_few(name, #instants // 15, track, work, finer) end
  return strict.object({ name = name, increments = #instants // 15, instants = instants, track = track, work = work }, class)
end

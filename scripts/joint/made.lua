-- Gaits, stored as a list of instants with fifteen numbers each.

local check = require "archard.lib.check"
local sphere = require "archard.sphere"

local class = { __name = "gait", __methods = {}, __fields = { "increments", "track", "work", "name" } }

function class:__tostring()
  return ("gait: %s, %d increments\n  for a head of 28 mm: track of the load %.4g mm, work %.4g N m per cycle"):format(self.name,
    self.increments, self.track, self.work / 1000)
end

-- (name, list of numbers) -> gait
return function(name, instants)
  if type(name) ~= "string" or type(instants) ~= "table" or #instants < 15 or #instants % 15 ~= 0 then
    check.fail("gait", "expected a name and fifteen numbers for each instant")
  end
  local track, work = sphere.path(instants, 14)
  return setmetatable({ name = name, increments = #instants // 15, instants = instants, track = track, work = work }, class)
end

-- map{ x=, z=, y= } and map.read: heights, depths or pressures over a rectangle. This module only lists the public
-- functions, of map/made.lua and map/read.lua.

local later = require "archard.lib.later"

local new = later("archard.map.made", "new")

return setmetatable({ read = later("archard.map.read", "read") },
  { __call = function(_, given) return new(given or {}) end })

-- map{ x=, z=, y= } and map.read make maps of heights, depths or pressures over a rectangle. This module
-- only lists the public functions of map/made.lua and map/read.lua.

local lazy = require "archard.lib.lazy"

local new = lazy("archard.map.made", "new")

return setmetatable({ read = lazy("archard.map.read", "read") },
  { __call = function(_, given) return new(given or {}) end })

-- map{ x=, z=, y= }: heights, depths or pressures over a rectangle. Only names what users see; maps are made in
-- map/made.lua.

local new = require "archard.lib.later" ("archard.map.made", "new")

return setmetatable({}, { __call = function(_, given) return new(given or {}) end })

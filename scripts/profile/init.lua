-- profile{ x=, z= } and profile.read: measured traces, to start runs from or to compare with. Only names what
-- users see; they are made in profile/made.lua.

local later = require "archard.lib.later"

local new = later("archard.profile.made", "new")

return setmetatable({ read = later("archard.profile.made", "read"), mean = later("archard.profile.made", "mean") },
  { __call = function(_, given) return new(given or {}) end })

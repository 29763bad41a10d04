-- profile{ x=, z= } and profile.read: measured traces, as start of a run or for comparison. This module only lists the
-- public functions of profile/made.lua.

local later = require "archard.lib.later"

local new = later("archard.profile.made", "new")

return setmetatable({ read = later("archard.profile.made", "read"), mean = later("archard.profile.made", "mean") },
  { __call = function(_, given) return new(given or {}) end })

-- Lua functions profile{ x=, z= } and profile.read: make profiles from measured traces, as the initial
-- surface of a run or for comparison. This module only lists the public functions of profile/made.lua.

local lazy = require "archard.lib.lazy"

local new = lazy("archard.profile.made", "new")

return setmetatable({ read = lazy("archard.profile.made", "read"), mean = lazy("archard.profile.made", "mean") },
  { __call = function(_, given) return new(given or {}) end })

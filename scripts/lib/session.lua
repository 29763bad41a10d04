-- The table session as users see it; the work is in lib/session_file.lua.

local later = require "archard.lib.later"

return { save = later("archard.lib.session_file", "save"), open = later("archard.lib.session_file", "open") }

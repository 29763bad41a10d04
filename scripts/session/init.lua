-- The table session as users see it; the work is in session/file.lua.

local later = require "archard.lib.later"

return { save = later("archard.session.file", "save"), open = later("archard.session.file", "open") }

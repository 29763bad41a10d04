-- The table session as users see it; the work is in session/file.lua.

local lazy = require "archard.lib.lazy"

return { save = lazy("archard.session.file", "save"), open = lazy("archard.session.file", "open") }

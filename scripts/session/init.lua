-- The global table `session`. Its functions are in session/file.lua.

local lazy = require "archard.lib.lazy"

return { save = lazy("archard.session.file", "save"), open = lazy("archard.session.file", "open") }

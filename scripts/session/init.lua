-- The global table `session`; session/file.lua has the functions.

local lazy = require "archard.lib.lazy"

return { save = lazy("archard.session.file", "save"), open = lazy("archard.session.file", "open") }

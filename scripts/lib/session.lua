-- The table session as users see it; the work is in lib/session_file.lua.

local file = require "archard.lib.session_file"

return { save = file.save, open = file.open }

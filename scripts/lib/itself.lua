-- Helps to start this program in a new process: returns the path of archard.so (the module for the stock
-- Lua interpreter) and Lua code that calls a module.

local itself = {}

-- Returns the path of archard.so, or nil if it is not found.
function itself.module() return (package.searchpath("archard", package.cpath)) end

-- Returns Lua code for the option -e, which calls a module with arguments (strings or numbers). In the
-- stock interpreter, the code loads archard.so first.
function itself.chunk(module, ...)
  local list = {}
  for i = 1, select("#", ...) do list[i] = ("%q"):format((select(i, ...))) end
  return ("package.cpath = %q; require 'archard'; require('archard.%s')(%s)"):format(package.cpath,
    module, table.concat(list, ", "))
end

return itself

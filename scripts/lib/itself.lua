-- Where this is, for the stock interpreter: it has to find archard.so before it can call what is in it.
-- Leans on nothing.

local itself = {}

-- (module, argument...) -> the chunk to hand to -e of another process of this program, which calls one
-- of its scripts; the arguments are texts or numbers
function itself.chunk(module, ...)
  local list = {}
  for i = 1, select("#", ...) do list[i] = ("%q"):format((select(i, ...))) end
  return ("package.cpath = %q; require 'archard'; require('archard.%s')(%s)"):format(package.cpath,
    module, table.concat(list, ", "))
end

-- The path of archard.so, or nil.
function itself.module() return (package.searchpath("archard", package.cpath)) end

return itself

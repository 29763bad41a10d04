-- Where the module of the stock interpreter, archard.so, stands, and how another process of this program
-- calls one of its scripts. Leans on nothing.

local itself = {}

-- The path of archard.so, nil where the program is not that.
function itself.module() return (package.searchpath("archard", package.cpath)) end

-- (module, argument...) -> the chunk to hand to -e; the arguments are texts or numbers. The stock
-- interpreter has to find and load archard.so first.
function itself.chunk(module, ...)
  local list = {}
  for i = 1, select("#", ...) do list[i] = ("%q"):format((select(i, ...))) end
  return ("package.cpath = %q; require 'archard'; require('archard.%s')(%s)"):format(package.cpath,
    module, table.concat(list, ", "))
end

return itself

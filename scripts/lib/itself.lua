-- How another process of this program calls one of its scripts: the chunk to hand to -e. The stock
-- interpreter, with archard.so, has to find and load that first. Leans on nothing.

-- (module, argument...) -> text; the arguments are texts or numbers
return function(module, ...)
  local list = {}
  for i = 1, select("#", ...) do list[i] = ("%q"):format((select(i, ...))) end
  return ("package.cpath = %q; require 'archard'; require('archard.%s')(%s)"):format(package.cpath,
    module, table.concat(list, ", "))
end

-- (module [, name]) -> a function that loads the module at its first call and calls its result, or the function `name`
-- in it.
return function(module, name)
  return function(...)
    local found = require(module)
    return (name and found[name] or found)(...)
  end
end

-- lazy(module [, name]) returns a function that loads the module at its first call. Each call is passed on
-- to the function `name` of the module or, without `name`, to the module itself.
return function(module, name)
  return function(...)
    local found = require(module)
    return (name and found[name] or found)(...)
  end
end

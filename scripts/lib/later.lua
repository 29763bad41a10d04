-- (module [, name]) -> a function that calls what the module returns, or the function of that name in
-- it. The module is read at the first call: who never calls it does not pay for it.
return function(module, name)
  return function(...)
    local found = require(module)
    return (name and found[name] or found)(...)
  end
end

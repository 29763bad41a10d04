-- Warns of wear coefficients that are probably in another unit, for functions that are written in Lua. wear{} has the
-- same warning.

local largest = 1e-6 -- [mm2/N] measured coefficients are smaller

-- where: name of the function; k: coefficient [mm2/N]; question: what the user may have meant.
return function(where, k, question)
  if type(k) == "number" and k > largest then
    warn(("%s: k = %.4g mm2/N is %.4g mm3/(N m): %s"):format(where, k, 1e3 * k, question))
  end
end

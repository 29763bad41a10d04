-- Warns of wear coefficients that are probably in another unit, for functions that are written in Lua. wear{} has the
-- same warning.

local largest = 1e-6 -- [mm2/N] measured coefficients are smaller

-- where: name of the function; k: coefficient [mm2/N], or a value of another type; question: what the user may have
-- meant, by default mm3/(N m).
return function(where, k, question)
  if type(k) ~= "number" or k <= largest then return end
  warn(("%s: k = %.4g mm2/N is %.4g mm3/(N m): %s"):format(where, k, 1e3 * k,
    question or ("was %.4g mm3/(N m) meant (k = %.4g)?"):format(k, k / 1000)))
end

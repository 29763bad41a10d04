-- Fields of study{} that are allowed only together with the field `sample`.

local check = require "archard.lib.check"

return { n = check.whole(2, 1000000), design = check.one_of{ "sobol", "latin", "random" },
  seed = check.whole(1, 2 ^ 31 - 1), indices = check.flag }

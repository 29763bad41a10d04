-- plot: curves and the pictures of contact and wear. This module only lists the public functions; plot/draw.lua draws,
-- plot/output.lua chooses the output, plot/style.lua the sizes, plot/units.lua the units, plot/naming.lua titles and
-- keys.

local check = require "archard.lib.check"
local draw = require "archard.plot.draw"
local later = require "archard.lib.later"

local plot = {
  default = draw.default, -- default term, size, colour and key
  pressure = later("archard.plot.curves", "pressure"),
  profile = later("archard.plot.curves", "profile"),
  history = later("archard.plot.curves", "history"),
  loop = later("archard.plot.loop", "loop"),
  shear = later("archard.plot.shear", "shear"),
  slip = later("archard.plot.shear", "slip"),
  map = later("archard.plot.map", "map"),
  surface = later("archard.plot.map", "surface"),
  track = later "archard.plot.track",
  mesh = later("archard.plot.mesh", "mesh"),
  stress = later("archard.plot.mesh", "stress"),
  fretting_map = later "archard.plot.fretting_map",
  animate = later "archard.plot.animate",
  response = later "archard.plot.response",
  bands = later "archard.plot.bands",
  tornado = later "archard.plot.tornado",
  fit = later "archard.plot.fit",
  style = later("archard.plot.style", "choose"),
  points = function(given) draw.points("plot.points", given) end,
  again = function() draw.again("plot.again") end,
  save = function(given, options) draw.save("plot.save", given, options) end,
}

return setmetatable(plot, {
  __call = function(_, given)
    if type(given) ~= "table" then
      check.fail("plot", ("expected a table, plot{ {x=..., y=...}, ... }, got %s"):format(
        check.shown(given)))
    end
    draw.draw("plot", given)
  end,
})

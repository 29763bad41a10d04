-- Defines the public functions of `plot`. Other modules do the work: plot/draw.lua draws, plot/output.lua
-- chooses the output, plot/style.lua sets sizes, plot/units.lua chooses units, plot/naming.lua writes titles.

local check = require "archard.lib.check"
local draw = require "archard.plot.draw"
local lazy = require "archard.lib.lazy"

local plot = {
  default = draw.default, -- defaults of term, size, colour and key
  pressure = lazy("archard.plot.curves", "pressure"),
  profile = lazy("archard.plot.curves", "profile"),
  history = lazy("archard.plot.curves", "history"),
  loop = lazy("archard.plot.loop", "loop"),
  shear = lazy("archard.plot.shear", "shear"),
  slip = lazy("archard.plot.shear", "slip"),
  map = lazy("archard.plot.map", "map"),
  surface = lazy("archard.plot.map", "surface"),
  track = lazy "archard.plot.track",
  mesh = lazy("archard.plot.mesh", "mesh"),
  stress = lazy("archard.plot.mesh", "stress"),
  fretting_map = lazy "archard.plot.fretting_map",
  animate = lazy "archard.plot.animate",
  response = lazy "archard.plot.response",
  bands = lazy "archard.plot.bands",
  tornado = lazy "archard.plot.tornado",
  fit = lazy "archard.plot.fit",
  style = lazy("archard.plot.style", "choose"),
  points = function(given) draw.points("plot.points", given) end,
  again = function() draw.again("plot.again") end,
  save = function(given, options) draw.save("plot.save", given, options) end,
}

return setmetatable(plot, {
  __call = function(_, given)
    if type(given) ~= "table" then
      check.fail("plot", ("expected a table, plot{ {x=..., y=...}, ... }, got %s; help \"plot\" lists the functions "
        .. "that draw objects, such as plot.profile"):format(check.shown(given)))
    end
    draw.draw("plot", given)
  end,
})

-- plot: curves, and the pictures of contact and wear. Only gathers what users see; the work is in
-- plot/draw.lua, plot/curves.lua (pressures, profiles, histories), plot/mesh.lua (meshes, stresses)
-- and plot/animate.lua.

local check = require "archard.lib.check"
local draw = require "archard.plot.draw"
local curves = require "archard.plot.curves"
local mesh = require "archard.plot.mesh"
local animate = require "archard.plot.animate"

local plot = {
  default = draw.default, -- term, size, colour and key where a call does not give them
  pressure = curves.pressure,
  profile = curves.profile,
  history = curves.history,
  mesh = mesh.mesh,
  stress = mesh.stress,
  animate = animate,
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

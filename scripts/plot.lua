-- plot: curves, and the pictures of contact and wear. Only gathers what users see; the work is in
-- plot_draw.lua, plot_curves.lua (pressures, profiles, histories), plot_mesh.lua (meshes, stresses)
-- and plot_animate.lua.

local check = require "archard.plot_check"
local draw = require "archard.plot_draw"
local curves = require "archard.plot_curves"
local mesh = require "archard.plot_mesh"
local animate = require "archard.plot_animate"

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

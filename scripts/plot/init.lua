-- plot: curves, and the pictures of contact and wear. Only gathers what users see; the work is in
-- plot/draw.lua, plot/output.lua (where), plot/style.lua (sizes), plot/naming.lua (titles and keys),
-- plot/curves.lua (pressures, profiles, histories), plot/mesh.lua (meshes, stresses),
-- plot/shear.lua and plot/loop.lua (friction), plot/response.lua, bands.lua, tornado.lua (studies),
-- plot/fit.lua and plot/animate.lua.

local check = require "archard.lib.check"
local draw = require "archard.plot.draw"
local curves = require "archard.plot.curves"
local fit = require "archard.plot.fit"
local mesh = require "archard.plot.mesh"
local loop = require "archard.plot.loop"
local shear = require "archard.plot.shear"
local animate = require "archard.plot.animate"
local response = require "archard.plot.response"
local style = require "archard.plot.style"
local bands = require "archard.plot.bands"
local tornado = require "archard.plot.tornado"

local plot = {
  default = draw.default, -- term, size, colour and key where a call does not give them
  pressure = curves.pressure,
  profile = curves.profile,
  history = curves.history,
  loop = loop.loop,
  shear = shear.shear,
  slip = shear.slip,
  mesh = mesh.mesh,
  stress = mesh.stress,
  animate = animate,
  response = response,
  bands = bands,
  tornado = tornado,
  fit = fit,
  style = style.choose,
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

-- (model or table of its fields, load) -> Hertz' contact of its unworn bodies.
local archard = require "archard"

return function(model, load)
  return archard.hertz{ radius = model.radius, thickness = model.thickness, load = load,
    cylinder = model.cylinder, plate = model.plate }
end

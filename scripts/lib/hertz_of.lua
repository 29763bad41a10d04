-- (model or table of its fields, load) -> Hertz contact of the unworn bodies; rings of revolution count as a line of
-- the length of their circumference.
local archard = require "archard"

return function(model, load)
  local geometry, thickness = model.geometry, model.thickness
  if geometry == "axisymmetric" and (model.axis or 0) > 0 then
    geometry, thickness = "plane strain", 2 * math.pi * model.axis
  end
  return archard.hertz{ radius = model.radius, thickness = thickness, geometry = geometry, load = load,
    cylinder = model.cylinder, plate = model.plate }
end

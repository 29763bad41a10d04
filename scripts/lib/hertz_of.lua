-- hertz_of(model, load) returns the Hertz contact of the unworn bodies. model: a model, or a table of its
-- fields; load: in N. An axisymmetric model with axis > 0 (a ring) is treated as a line contact with the
-- length 2 pi axis.
local archard = require "archard"

return function(model, load)
  local geometry, thickness = model.geometry, model.thickness
  if geometry == "axisymmetric" and (model.axis or 0) > 0 then
    geometry, thickness = "plane strain", 2 * math.pi * model.axis
  end
  return archard.hertz{ radius = model.radius, thickness = thickness, geometry = geometry, load = load,
    cylinder = model.cylinder, plate = model.plate }
end

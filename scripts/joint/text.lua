-- Describes the bodies of a joint.

-- Returns a text such as "CoCr, E 230000 MPa nu 0.3".
local function material_text(m)
  return ("%sE %g MPa nu %g"):format(m.name and m.name .. ", " or "", m.E, m.nu)
end

local function layers_text(layers, core)
  local parts = {}
  for i, layer in ipairs(layers) do parts[i] = ("%g mm of %s"):format(layer.thickness, material_text(layer.material)) end
  if core then parts[#parts + 1] = (#parts > 0 and "a core of " or "") .. material_text(core) end
  return table.concat(parts, ", ")
end

-- Returns a text such as "head of 28 mm, radial clearance 0.06 mm, elastic", with one more line for each
-- body.
return function(joint)
  return ("head of %g mm, radial clearance %g mm, %s\n  head      %s\n  cup       %s"):format(2 * joint.head.radius,
    joint.cup.clearance, joint.foundation, layers_text(joint.head.layers, joint.head.material), layers_text(joint.cup.layers))
end

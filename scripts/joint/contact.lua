-- Contacts of unworn joints: contact{ model=j, load=, direction= }. Lengths are in mm, loads in N, angles
-- in degrees.

local check = require "archard.lib.check"
local flat = require "archard.joint.flat"
local lattice = require "archard.joint.lattice"
local sphere = require "archard.sphere"
local strict = require "archard.strict"

local methods = {}
local class = { __name = "joint_contact", __methods = methods,
  __fields = { "approach", "area", "direction", "half_angle", "iterations", "load", "model", "normal_force", "p_center", "p_max",
    "pressure", "rim_margin" } }

local direction_kind = check.kind("{ x, y, z }, three numbers, not all 0", function(v)
  return type(v) == "table" and check.number.test(v[1]) and check.number.test(v[2]) and check.number.test(v[3])
    and math.max(math.abs(v[1]), math.abs(v[2]), math.abs(v[3])) > 0
end)

-- c:flat() returns the pressure as a flat map, in an azimuthal equal-area projection about the z axis.
function methods:flat(what)
  if what ~= nil and what ~= "pressure" then check.refuse("joint_contact:flat", "what", '"pressure"', what) end
  return flat.map(#self.pressure.theta, self.pressure.values, self.model.head.radius, "pressure", "MPa")
end

function class:__tostring()
  local approach = {}
  for i, along in ipairs(self.approach) do approach[i] = math.abs(along) < 1e-9 and 0 or along end
  return ("contact of a joint: load %.6g N\n  pressure  largest %.4g MPa, centre %.4g MPa\n"
    .. "  area      %.4g mm2, half angle %.3g degrees, %.3g degrees to the rim\n"
    .. "  approach  %.4g, %.4g, %.4g mm (%d iterations)"):format(self.load, self.p_max, self.p_center, self.area, self.half_angle,
    self.rim_margin, approach[1], approach[2], approach[3], self.iterations)
end

strict.class(class)

-- Solves the contact of an unworn joint. given: { load= [N], direction= }. Returns a contact object.
return function(joint, given)
  local where = "joint:contact"
  given = check.definition(where, given or {}, { load = check.positive, direction = direction_kind })
  local load, n = given.load or 3000, given.direction or { 0, 0, 1 }
  local scale = math.max(math.abs(n[1]), math.abs(n[2]), math.abs(n[3])) -- avoids overflow in n^2
  local length = scale * math.sqrt((n[1] / scale) ^ 2 + (n[2] / scale) ^ 2 + (n[3] / scale) ^ 2)
  local result = check.as(where, sphere.press, joint.engine, load * (n[1] / length), load * (n[2] / length), load * (n[3] / length))
  result.model, result.load, result.direction = joint, load, { n[1], n[2], n[3] }
  result.pressure = lattice.map(joint.engine, "pressure")
  lattice.warn_of_rim("contact", joint, result.rim_margin, {})
  lattice.check_cells(where, joint.engine, result.half_angle)
  return strict.object(result, class)
end

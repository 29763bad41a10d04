-- joint{ head=, cup=, foundation=, mesh= }: a ball in a socket; j:contact{}, j:wear{}. Lengths in mm, angles in
-- degrees.

local check = require "archard.lib.check"
local lattice = require "archard.joint.lattice"
local sphere = require "archard.sphere"
local strict = require "archard.strict"

local joint = {}

local methods = {}
local class = { __name = "joint", __index = methods, __methods = methods, __fields = {} }
-- --- definitions --------------------------------------------------------------------------------

local material_kind = check.kind("a material", function(v)
  return type(v) == "userdata" or type(v) == "table" and check.number.test(v.E)
end)
local layers_kind = check.kind("a list of up to 4 tables { thickness=, material= }", function(v)
  return type(v) == "table" and #v <= 4
end)
local layer_fields = { thickness = check.positive, material = material_kind }
local joint_fields = { head = check.table, cup = check.table, mesh = check.table,
  foundation = check.one_of{ "elastic", "winkler", "column" },
  order = check.kind("1 or 2", function(v) return v == 1 or v == 2 end) }
local head_fields = { radius = check.positive, material = material_kind, layers = layers_kind }
local cup_fields = { clearance = check.number, inclination = check.number, cover = check.number, layers = layers_kind }

local function plain(m) return { E = m.E, nu = m.nu } end

local function plain_layers(given, prefix)
  local result = {}
  for i, layer in ipairs(given or {}) do
    check.fields("joint", layer, layer_fields, ("%s[%d]."):format(prefix, i))
    if not layer.thickness or not layer.material then
      check.fail("joint", ("field '%s[%d]': expected thickness and material"):format(prefix, i))
    end
    result[i] = plain(layer.material)
    result[i].thickness = layer.thickness
  end
  return result
end

local function new(given)
  given = check.definition("joint", given or {}, joint_fields)
  local head = check.fields("joint", given.head or {}, head_fields, "head.")
  local cup = check.fields("joint", given.cup or {}, cup_fields, "cup.")
  local mesh = check.fields("joint", given.mesh or {}, { size = check.positive }, "mesh.")
  local cocr = { E = 230e3, nu = 0.3 }
  local usual = { { thickness = 3, material = cocr }, { thickness = 6, material = { E = 1000, nu = 0.4 } },
    { thickness = 2, material = { E = 110e3, nu = 0.3 } } }
  local def = { radius = head.radius or 14, core = plain(head.material or cocr),
    head_layers = plain_layers(head.layers, "head.layers"), cup_layers = plain_layers(cup.layers or usual, "cup.layers"),
    clearance = cup.clearance, inclination = cup.inclination, cover = cup.cover, size = mesh.size,
    foundation = given.foundation, second_order = given.order == 2 }
  local made = setmetatable({ radius = def.radius, clearance = def.clearance or 0.06, foundation = def.foundation or "elastic" },
    class)
  made.def, made.engine = def, sphere.create(def)
  return made
end

function class:__tostring()
  return ("joint: head of %g mm, radial clearance %g mm, %s, %d layers in the cup\n"
    .. "  not in this model: edge loading, microseparation, lubrication, the rim"):format(2 * self.radius, self.clearance,
    self.foundation, #self.def.cup_layers)
end

-- --- contact ------------------------------------------------------------------------------------

local direction_kind = check.kind("{ x, y, z }, three numbers", function(v)
  return type(v) == "table" and check.number.test(v[1]) and check.number.test(v[2]) and check.number.test(v[3])
end)

local function show_contact(c)
  return ("contact of a joint: load %.6g N\n  pressure  largest %.4g MPa, centre %.4g MPa\n"
    .. "  area      %.4g mm2, half angle %.3g degrees, %.3g degrees to the rim\n"
    .. "  approach  %.4g, %.4g, %.4g mm (%d iterations)"):format(c.load, c.p_max, c.p_center, c.area, c.half_angle, c.rim_margin,
    c.approach[1], c.approach[2], c.approach[3], c.iterations)
end

-- j:contact{ load=, direction= }
function methods:contact(given)
  given = check.definition("joint:contact", given or {}, { load = check.positive, direction = direction_kind })
  local load, n = given.load or 3000, given.direction or { 0, 0, 1 }
  local length = math.sqrt(n[1] ^ 2 + n[2] ^ 2 + n[3] ^ 2)
  local result = check.as("joint:contact", sphere.press, self.engine, load * n[1] / length, load * n[2] / length,
    load * n[3] / length)
  result.load = load
  result.pressure = lattice.map(self.engine, "pressure")
  lattice.warn_of_rim("contact", self.def, result.rim_margin)
  lattice.check_cells("joint:contact", self.engine, result.half_angle)
  strict.table(result, "joint:contact")
  local shown = getmetatable(result)
  shown.__tostring, shown.__plain = show_contact, nil
  return result
end

-- --- wear and files -----------------------------------------------------------------------------

-- j:wear{ loading=, k=, alpha=, cycles=, ... }: a run on its own copy of the joint.
function methods:wear(given) return require "archard.joint.run".new(self.def, given) end

-- joint.open(path [, { k = f }]): opens a run saved by w:save(path).
function joint.open(path, functions) return require "archard.joint.file".open(path, functions) end

return setmetatable(joint, { __call = function(_, given) return new(given) end })

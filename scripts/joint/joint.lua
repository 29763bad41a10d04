-- joint{ head=, cup=, foundation=, mesh= } makes a ball in a socket, with the methods j:contact{} and
-- j:wear{}. Lengths are in mm, angles in degrees.

local bodies = require "archard.joint.bodies"
local check = require "archard.lib.check"
local measure = require "archard.measure"
local merged = require "archard.lib.merged"
local sphere = require "archard.sphere"
local strict = require "archard.strict"
local text = require "archard.joint.text"

local joint = {}

local methods = {}
local class = { __name = "joint", __methods = methods,
  __fields = { "head", "cup", "foundation", "order", "mesh", "bodies" } }

-- --- definitions --------------------------------------------------------------------------------

local material_kind = check.kind("a material or its fields { E=, nu= }", function(v)
  return check.shown(v) == "a material object" or type(v) == "table" and v.E ~= nil
end)
local material_fields = { E = check.positive, nu = check.kind("a number in (-1, 0.5)", function(v)
  return check.number.test(v) and v > -1 and v < 0.5
end), name = check.text }
local layers_kind = check.kind("a list of up to 4 tables { thickness=, material= }", function(v)
  return type(v) == "table" and #v <= 4
end)
local layer_fields = { thickness = check.positive, material = material_kind }
local joint_fields = { head = check.table, cup = check.table, mesh = check.table,
  foundation = check.one_of{ "elastic", "winkler", "column" },
  order = check.kind("1 or 2", function(v) return v == 1 or v == 2 end) }
local head_fields = { radius = check.positive, material = material_kind, layers = layers_kind }
local cup_fields = { clearance = check.number, inclination = check.number, cover = check.number, layers = layers_kind }

-- Returns the fields of a material (an object or a table) as a plain table, the form for run files.
local function plain(m, prefix)
  if type(m) == "table" then m = check.fields("joint", m, material_fields, prefix .. "material.") end
  return { E = m.E, nu = m.nu or 0.3, name = m.name ~= "" and m.name or nil }
end

local function plain_layers(given, prefix)
  local result = {}
  for i, layer in ipairs(given or {}) do
    layer = check.fields("joint", layer, layer_fields, ("%s[%d]."):format(prefix, i))
    if not layer.thickness or not layer.material then
      check.fail("joint", ("field '%s[%d]': expected thickness and material"):format(prefix, i))
    end
    result[i] = { thickness = layer.thickness, material = plain(layer.material, ("%s[%d]."):format(prefix, i)) }
  end
  return result
end

-- Returns the fields of a head that may be given as a body.ball{}.
local function head_of(given)
  if given.kind == nil then return given end
  if given.kind ~= "ball" then
    check.fail("joint", ("field 'head': expected a body.ball{} or { radius= }, got a body.%s{}"):format(given.kind))
  end
  local head = merged(given)
  head.kind, head.E, head.nu = nil, nil, nil
  if given.E or given.nu then head.material = { E = given.E or 200e3, nu = given.nu } end
  return head
end

local function new(given)
  given = check.definition("joint", given or {}, joint_fields)
  local head = check.fields("joint", head_of(given.head or {}), head_fields, "head.")
  local cup = check.fields("joint", given.cup or {}, cup_fields, "cup.")
  local mesh = check.fields("joint", given.mesh or {}, { size = check.positive }, "mesh.")
  local cocr = { E = 230e3, nu = 0.3 }
  local usual = { { thickness = 3, material = cocr }, { thickness = 6, material = { E = 1000, nu = 0.4 } },
    { thickness = 2, material = { E = 110e3, nu = 0.3 } } }
  local made = { foundation = given.foundation or "elastic", order = given.order or 1, mesh = { size = mesh.size or 2 },
    head = { radius = head.radius or 14, material = plain(head.material or cocr, "head."), layers = plain_layers(head.layers, "head.layers") },
    cup = { clearance = cup.clearance or 0.06, inclination = cup.inclination or 0, cover = cup.cover or 90,
      layers = plain_layers(cup.layers or usual, "cup.layers") } }
  made.engine = sphere.create(made)
  made.upper, made.lower = bodies.upper, bodies.lower -- names of the bodies in results
  made.bodies = measure.bodies(bodies)
  return strict.object(made, class)
end

-- Returns the fields of joint{} from which an equal joint can be made.
function class.__settings(j)
  return { head = j.head, cup = j.cup, foundation = j.foundation, order = j.order, mesh = j.mesh }
end

function class:__tostring()
  return ("joint: %s\n  not modelled: edge loading, microseparation, lubrication, the rim"):format(text(self))
end

-- --- methods for contacts, wear and files --------------------------------------------------------

-- j:contact{ load=, direction= } solves a contact of the unworn joint.
function methods:contact(given) return require "archard.joint.contact"(self, given) end

-- j:wear{ loading=, k=, alpha=, cycles=, ... } makes a run, which works on its own copy of the joint.
function methods:wear(given) return require "archard.joint.run".new(self, given) end

-- joint.open(path [, { k = f }]) opens a run that was saved by w:save(path).
function joint.open(path, functions) return require "archard.joint.file".open(path, functions) end

strict.class(class)

return setmetatable(joint, { __call = function(_, given) return new(given) end })

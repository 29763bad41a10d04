-- joint{ head=, cup=, foundation=, mesh= }: a ball in a socket; j:contact{}, j:wear{}. Lengths in mm, angles in degrees.

local check = require "archard.lib.check"
local gait = require "archard.joint.gait"
local progress = require "archard.lib.progress"
local sphere = require "archard.sphere"
local strict = require "archard.strict"

local joint = {}

local methods = {}
local class = { __name = "joint", __index = methods, __methods = methods, __fields = {} }
local run_methods = {}
local run_class = { __name = "joint_wear", __index = run_methods, __methods = run_methods, __fields = {} }

local function is_gait(value)
  local of = type(value) == "table" and getmetatable(value)
  return type(of) == "table" and rawget(of, "__name") == "gait"
end

-- --- definitions --------------------------------------------------------------------------------

local material_kind = check.kind("a material", function(v)
  return type(v) == "userdata" or type(v) == "table" and check.number.test(v.E)
end)
local layers_kind = check.kind("a list of up to 4 tables { thickness=, material= }", function(v)
  return type(v) == "table" and #v <= 4
end)
local layer_fields = { thickness = check.positive, material = material_kind }
local joint_fields = { head = check.table, cup = check.table, mesh = check.table,
  foundation = check.one_of{ "elastic", "winkler", "column" } }
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

function joint.new(given)
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
    foundation = given.foundation }
  local made = setmetatable({ radius = def.radius, clearance = def.clearance or 0.06, foundation = def.foundation or "elastic" },
    class)
  made.def, made.engine = def, sphere.create(def)
  return made
end

function class:__tostring()
  return ("joint: head of %g mm, radial clearance %g mm, %s, %d layers in the cup\n"
    .. "  outside this model: edge loading, microseparation, lubrication, the rim"):format(2 * self.radius, self.clearance,
    self.foundation, #self.def.cup_layers)
end

-- --- contact ------------------------------------------------------------------------------------

local function table_map(engine, what)
  local rows, values = sphere.map(engine, what)
  local d = 180 / rows
  local map = { theta = {}, phi = {}, values = values }
  for i = 1, rows do map.theta[i] = (i - 0.5) * d end
  for k = 1, 2 * rows do map.phi[k] = (k - 0.5) * d - 180 end
  return strict.table(map, "map")
end

local direction_kind = check.kind("{ x, y, z }, three numbers", function(v)
  return type(v) == "table" and check.number.test(v[1]) and check.number.test(v[2]) and check.number.test(v[3])
end)

local function show_contact(c)
  return ("contact of a joint: load %.6g N\n  pressure  largest %.4g MPa, centre %.4g MPa\n"
    .. "  area      %.4g mm2, half angle %.3g degrees, %.3g degrees to the rim\n"
    .. "  approach  %.4g, %.4g, %.4g mm (%d iterations)"):format(c.load, c.p_max, c.p_center, c.area, c.half_angle, c.rim_margin,
    c.approach[1], c.approach[2], c.approach[3], c.iterations)
end

-- Nearer to the rim than this the complete spheres are off by more than about 1 %.
local function warn_of_rim(def, margin)
  local liner = def.cup_layers[1]
  local least = liner.E < 1e4 and math.deg(liner.thickness / def.radius) or 25
  if #def.cup_layers > 1 or liner.E < 1e4 then
    if margin < least then
      warn(("contact: it comes within %.3g degrees of the cup's rim; spheres are complete here, which is off by percents below %.3g"):format(
        margin, least))
    end
  end
end

-- j:contact{ load=, direction= }
function methods:contact(given)
  given = check.definition("joint:contact", given or {}, { load = check.positive, direction = direction_kind })
  local load, n = given.load or 3000, given.direction or { 0, 0, 1 }
  local length = math.sqrt(n[1] ^ 2 + n[2] ^ 2 + n[3] ^ 2)
  local result = check.as("joint:contact", sphere.press, self.engine, load * n[1] / length, load * n[2] / length,
    load * n[3] / length)
  result.load = load
  result.pressure = table_map(self.engine, "pressure")
  warn_of_rim(self.def, result.rim_margin)
  strict.table(result, "joint:contact")
  local shown = getmetatable(result)
  shown.__tostring, shown.__plain = show_contact, nil
  return result
end

-- --- wear ---------------------------------------------------------------------------------------

local number_or_function = check.kind("a number from 0 up or a function", function(v)
  return type(v) == "function" or check.number.test(v) and v >= 0
end)
local wear_fields = { loading = check.kind("a gait", is_gait), k = number_or_function,
  alpha = check.kind("a number in [0, 1]", function(v) return check.number.test(v) and v >= 0 and v <= 1 end),
  cycles = check.positive, updates = check.count, scheme = check.one_of{ "sweep", "explicit" } }

-- j:wear{ loading=, k=, alpha=, cycles=, updates=, scheme= }: a run on a joint of its own.
function methods:wear(given)
  given = check.definition("joint:wear", given or {}, wear_fields)
  local run = { def = self.def, engine = sphere.create(self.def), loading = given.loading or gait "iso", k = given.k or 3e-11,
    alpha = given.alpha or 0.5, goal = given.cycles or 1e6, updates = given.updates or 20, scheme = given.scheme or "sweep",
    history = { cycles = { 0 }, volume_head = { 0 }, volume_cup = { 0 }, depth_head = { 0 }, depth_cup = { 0 }, p_peak = { 0 / 0 },
      area = { 0 / 0 } }, record = { cycles = 0, updates = 0 }, cycles = 0, volume = { head = 0, cup = 0 },
    depth = { head = 0, cup = 0 } }
  if run.scheme == "explicit" and type(run.k) == "function" then
    check.fail("joint:wear", "field 'scheme': expected \"sweep\" beside k as a function: its limit of stability is not known")
  end
  return setmetatable(run, run_class)
end

local function largest(list)
  local most = 0
  for i = 1, #list do most = math.max(most, list[i]) end
  return most
end

local function note(run, record)
  local h = run.history
  run.record, run.cycles, run.p_peak, run.area = record, record.cycles, record.p_peak, record.area
  run.volume = { head = record.volume_head, cup = record.volume_cup, total = record.volume_head + record.volume_cup }
  for _, body in ipairs{ "head", "cup" } do
    local _, depth = sphere.map(run.engine, body)
    run.depth[body] = largest(depth)
    h["depth_" .. body][#h.cycles + 1] = run.depth[body]
    h["volume_" .. body][#h.cycles + 1] = run.volume[body]
  end
  run.depth_partition = run.depth.head / (run.depth.head + run.depth.cup)
  h.p_peak[#h.cycles + 1], h.area[#h.cycles + 1] = run.p_peak, run.area
  h.cycles[#h.cycles + 1] = run.cycles
end

-- How many updates cover so many cycles: explicit ones keep below their limit of stability.
local function updates_for(run, cycles)
  if run.scheme ~= "explicit" or run.k == 0 then return run.updates end
  return math.max(run.updates, math.ceil(cycles / sphere.limit(run.engine, run.loading.instants, run.k)))
end

-- What is shown after each update: a bar on a terminal, or what the user's function makes of the run.
local function watcher(run, wanted, goal)
  if wanted == false then return function() end, nil end
  if type(wanted) == "function" then return wanted, nil end
  local bar = progress.new{ total = goal, done = run.cycles, label = "wear", unit = "cycles" }
  return function() bar:update(run.cycles, ("update %d"):format(#run.history.cycles - 1)) end, bar
end

-- w:run{ cycles=, progress= }: up to so many cycles, in updates that grow as N^1.5 (explicit: even ones). What ends it
-- on the way, Ctrl-C too, leaves it after its last whole update.
function run_methods:run(given)
  given = check.definition("joint_wear:run", given or {}, { cycles = check.positive, progress = check.progress })
  local start, goal = self.cycles, given.cycles or self.goal
  local power = self.scheme == "explicit" and 1 or 1.5
  local watch, shown <close> = watcher(self, given.progress, goal)
  local updates = updates_for(self, goal - start)
  for i = 1, updates do
    local to = start + (goal - start) * (i / updates) ^ power
    if to > self.cycles then
      note(self, check.as("joint_wear:run", sphere.update, self.engine, self.loading.instants, self.k, self.alpha,
        to - self.cycles, self.scheme == "explicit", self.record))
      watch(self)
    end
  end
  return self
end

-- w:map "cup" | "head" | "cross shear"
function run_methods:map(what)
  local known = check.one_of{ "cup", "head", "cross shear" }
  if not known.test(what) then check.refuse("joint_wear:map", "what", known.expected, what) end
  return table_map(self.engine, what)
end

-- w:flat "cup": the same as a map in mm, azimuthal equal-area about the load.
function run_methods:flat(what)
  self:map(what)
  return require "archard.joint.flat"(self.engine, self.def.radius, what, what == "cross shear" and "-" or "mm")
end

-- w:penetration(): the head's displacement into the cup under the largest load [mm].
function run_methods:penetration() return self.record.penetration end

function run_class:__tostring()
  local coefficient = type(self.k) == "number" and ("k %.4g mm2/N = %.4g mm3/(N m)"):format(self.k, 1000 * self.k) or "k a function"
  local lines = { ("wear of a joint: %.6g cycles, alpha %g (the head's share), %s"):format(self.cycles, self.alpha, coefficient) }
  if self.cycles > 0 then
    lines[2] = ("  depth head %.4g, cup %.4g um; volume head %.5g, cup %.5g mm3: %.4g mm3 per million cycles"):format(
      1000 * self.depth.head, 1000 * self.depth.cup, self.volume.head, self.volume.cup, self.volume.total / self.cycles * 1e6)
    lines[3] = ("  largest pressure of the last cycle %.4g MPa, contact up to %.4g mm2"):format(self.p_peak, self.area)
  end
  return table.concat(lines, "\n")
end

return joint

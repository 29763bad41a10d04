-- Runs of joints, wear{ model=j, loading=gait "iso" }: steps over blocks of gaits, histories, maps. A step that fails
-- leaves the run unchanged. Lengths in mm.

local check = require "archard.lib.check"
local gait = require "archard.joint.gait"
local progress = require "archard.lib.progress"
local lattice = require "archard.joint.lattice"
local sphere = require "archard.sphere"

local runs = {}

local methods = {}
local class = { __name = "joint_wear", __index = methods, __methods = methods,
  __fields = { "alpha", "area", "creep", "cycles", "depth", "depth_partition", "goal", "history", "k", "limit", "loading", "p_peak",
    "record", "scheme", "tolerance", "updates", "volume" } }

-- --- definitions --------------------------------------------------------------------------------

local function is_gait(value)
  local of = type(value) == "table" and getmetatable(value)
  return type(of) == "table" and rawget(of, "__name") == "gait"
end

local number_or_function = check.kind("a number >= 0 or a function", function(v)
  return type(v) == "function" or check.number.test(v) and v >= 0
end)
local loading_kind = check.kind("a gait, or a list of blocks { gait=, cycles= }", function(v)
  return is_gait(v) or type(v) == "table" and #v > 0
end)
local fields = { loading = loading_kind, k = number_or_function,
  alpha = check.kind("a number in [0, 1] or a function", function(v)
    return type(v) == "function" or check.number.test(v) and v >= 0 and v <= 1
  end),
  creep = check.kind("a function", function(v) return type(v) == "function" end),
  cycles = check.positive, updates = check.count, scheme = check.one_of{ "sweep", "explicit" }, tolerance = check.share,
  worn = check.table }
local block_fields = { gait = check.kind("a gait", is_gait), cycles = check.positive }
local shape_kind = check.kind("a function of theta and phi in degrees, a map of a run, or a list of its values", function(v)
  return type(v) == "function" or type(v) == "table"
end)

-- A list of { gait=, cycles= }; the last block has no end.
local function blocks_of(given)
  if is_gait(given) then return { { gait = given, cycles = math.huge } } end
  local blocks = {}
  for i, block in ipairs(given) do
    if type(block) ~= "table" then check.refuse("joint:wear", ("loading[%d]"):format(i), "{ gait=, cycles= }", block) end
    check.fields("joint:wear", block, block_fields, ("loading[%d]."):format(i))
    if not block.gait or not (block.cycles or i == #given) then
      check.fail("joint:wear", ("field 'loading[%d]': expected a gait and cycles"):format(i))
    end
    blocks[i] = { gait = block.gait, cycles = block.cycles or math.huge }
  end
  return blocks
end

-- The depths on the lattice from a function, a map or a list of the user.
local function depths_of(engine, name, given)
  if not shape_kind.test(given) then check.refuse("joint:wear", "worn." .. name, shape_kind.expected, given) end
  local map = lattice.map(engine, name)
  if type(given) == "table" then
    local values = rawget(given, "values") or given
    if #values ~= #map.values then
      check.fail("joint:wear", ("field 'worn.%s': expected %d depths in mm, one for each cell of w:map, got %d"):format(name,
        #map.values, #values))
    end
    return values
  end
  local list = {}
  for _, theta in ipairs(map.theta) do
    for _, phi in ipairs(map.phi) do
      local depth = given(theta, phi)
      if not check.number.test(depth) then
        check.refuse("joint:wear", ("worn.%s(%g, %g)"):format(name, theta, phi), "a depth in mm", depth)
      end
      list[#list + 1] = depth
    end
  end
  return list
end

local function put_shapes(engine, worn)
  check.fields("joint:wear", worn, { head = shape_kind, cup = shape_kind }, "worn.")
  for _, name in ipairs{ "head", "cup" } do
    if worn[name] ~= nil then check.as("joint:wear", sphere.set, engine, name, depths_of(engine, name, worn[name])) end
  end
end

local columns = { "cycles", "volume_head", "volume_cup", "depth_head", "depth_cup", "p_peak", "area" }
runs.columns = columns

local usual = { k = 3e-11, alpha = 0.5, cycles = 1e6, tolerance = 0.02, updates = 20 }

-- (definition of the joint, fields of the user) -> run
function runs.new(def, given)
  given = check.definition("joint:wear", given or {}, fields)
  local run = { def = def, engine = sphere.create(def), blocks = blocks_of(given.loading or gait "iso"),
    k = given.k or usual.k, alpha = given.alpha or usual.alpha,
    creep = given.creep, goal = given.cycles or usual.cycles,
    updates = given.updates, scheme = given.scheme or "sweep", tolerance = given.tolerance or usual.tolerance,
    history = {}, record = { cycles = 0, updates = 0 }, cycles = 0, volume = { head = 0, cup = 0, total = 0 },
    depth = { head = 0, cup = 0 } }
  run.loading = run.blocks[1].gait
  run.step = run.goal * usual.updates ^ -1.5 -- first step
  for _, name in ipairs(columns) do run.history[name] = { name:find "^[pa]" and 0 / 0 or 0.0 } end
  if run.scheme == "explicit" and type(run.k) == "function" then
    check.fail("joint:wear", "field 'scheme': expected \"sweep\" if k is a function, as its stability limit is unknown")
  end
  if run.updates and given.tolerance then
    check.fail("joint:wear", "field 'updates': expected updates or a tolerance, got both")
  end
  if run.scheme == "explicit" and run.k > 0 then run.limit = sphere.limit(run.engine, run.loading.instants, run.k) end
  setmetatable(run, class)
  if given.worn then
    put_shapes(run.engine, given.worn)
    for _, body in ipairs{ "head", "cup" } do
      run.depth[body] = lattice.deepest(run.engine, body)
      run.history["depth_" .. body][1] = run.depth[body]
    end
  end
  return run
end

-- --- steps --------------------------------------------------------------------------------------

-- The block at the present cycle, and its last cycle.
local function block_at(run)
  local last = 0
  for _, block in ipairs(run.blocks) do
    last = last + block.cycles
    if run.cycles < last * (1 - 1e-12) then return block, last end
  end
  return run.blocks[#run.blocks], math.huge
end

local function largest_load(instants)
  local most, load = 0, nil
  for i = 13, #instants, 15 do
    local x, y, z = instants[i], instants[i + 1], instants[i + 2]
    local size = math.sqrt(x * x + y * y + z * z)
    if size > most then most, load = size, { x, y, z } end
  end
  return load
end

-- Checks the unworn contact under the largest load: refuses cells that are too large, warns if the rim is near.
local function check_contact(run)
  local load = largest_load(run.blocks[1].gait.instants)
  if not load then check.fail("joint_wear:run", "field 'loading': expected a gait with a load above 0") end
  local contact = check.as("joint_wear:run", sphere.press, run.engine, load[1], load[2], load[3])
  lattice.warn_of_rim("joint_wear:run", run.def, contact.rim_margin)
  lattice.check_cells("joint_wear:run", run.engine, contact.half_angle)
end

-- Cycles up to the next of the given number of updates, which end at goal (j/m)^1.5.
local function next_of_updates(run)
  local j = math.floor(run.updates * (run.cycles / run.goal) ^ (2 / 3) + 1e-6) + 1
  return run.goal * (j / run.updates) ^ 1.5 - run.cycles
end

-- Cycles of an explicit update: the stability limit, at most a fixed part of the goal.
local function explicit_cycles(run, instants)
  local most = run.goal / (run.updates or usual.updates)
  if run.k == 0 then return most end
  run.limit = sphere.limit(run.engine, instants, run.k)
  return math.min(most, run.limit)
end

-- Computes one step of at most `most` cycles and returns its record.
local function advance(run, instants, most)
  local function update(cycles)
    return check.as("joint_wear:run", sphere.update, run.engine, instants, run.k, run.alpha, math.min(cycles, most), run.record,
      run.scheme == "explicit", run.creep)
  end
  if run.scheme == "explicit" then return update(explicit_cycles(run, instants)) end
  if run.updates then return update(next_of_updates(run)) end
  local record, step = check.as("joint_wear:run", sphere.advance, run.engine, instants, run.k, run.alpha, most, run.record,
    run.tolerance, run.step, run.creep)
  run.step = step
  return record
end

-- Sets the fields of a run from a record and its maps.
local function read(run, record)
  run.record, run.cycles, run.p_peak, run.area = record, record.cycles, record.p_peak, record.area
  local head, cup = record.volume_head or 0, record.volume_cup or 0
  run.volume = { head = head, cup = cup, total = head + cup }
  for _, body in ipairs{ "head", "cup" } do run.depth[body] = lattice.deepest(run.engine, body) end
  run.depth_partition = run.depth.head / (run.depth.head + run.depth.cup)
end

local function note(run, record)
  local h, n = run.history, #run.history.cycles + 1
  read(run, record)
  for _, body in ipairs{ "head", "cup" } do
    h["depth_" .. body][n] = run.depth[body]
    h["volume_" .. body][n] = run.volume[body]
  end
  h.p_peak[n], h.area[n], h.cycles[n] = run.p_peak, run.area, run.cycles
end

-- Restores a saved run whose maps are already set.
function runs.restore(run, record, history)
  run.history = history
  read(run, record)
  run.loading = block_at(run).gait
end

-- Returns the function called after each step, a progress bar or the user's function, and the bar.
local function watcher(run, given, goal)
  if given == false then return function() end, nil end
  if type(given) == "function" then return given, nil end
  local bar = progress.new{ total = goal, done = run.cycles, label = "wear", unit = "cycles" }
  return function() bar:update(run.cycles, ("update %d"):format(#run.history.cycles - 1)) end, bar
end

-- w:run{ cycles=, progress= }: runs up to a number of cycles. An error or Ctrl-C leaves the run after its last complete
-- step, from which it can be continued with identical results.
function methods:run(given)
  given = check.definition("joint_wear:run", given or {}, { cycles = check.positive, progress = check.progress })
  local goal = given.cycles or self.goal
  local watch, shown <close> = watcher(self, given.progress, goal)
  if self.cycles == 0 then check_contact(self) end
  while self.cycles < goal * (1 - 1e-12) do
    local block, last = block_at(self)
    self.loading = block.gait
    note(self, advance(self, block.gait.instants, math.min(goal, last) - self.cycles))
    watch(self)
  end
  return self
end

-- --- results ------------------------------------------------------------------------------------

-- w:map "cup" | "head" | "cross shear" | "creep" | "pressure"
function methods:map(what)
  local known = check.one_of{ "cup", "head", "cross shear", "creep", "pressure" }
  if not known.test(what) then check.refuse("joint_wear:map", "what", known.expected, what) end
  return lattice.map(self.engine, what)
end

local units = { ["cross shear"] = "-", pressure = "MPa" }

-- w:flat "cup": the same map in mm, in an azimuthal equal-area projection about the load.
function methods:flat(what)
  self:map(what)
  return require "archard.joint.flat".map(self.engine, self.def.radius, what, units[what] or "mm")
end

-- w:penetration(): the head's displacement into the cup under the largest load [mm].
function methods:penetration() return self.record.penetration end

-- w:save(path): saves the run so that it can be continued with identical results.
function methods:save(path) return require "archard.joint.file".save(self, path) end

local function step_words(run)
  if run.scheme == "explicit" then
    return run.limit and ("explicit updates, stable up to %.4g cycles each"):format(run.limit) or "explicit updates"
  end
  if run.updates then return ("%d updates"):format(run.updates) end
  return ("steps within %g"):format(run.tolerance)
end

function class:__tostring()
  local coefficient = type(self.k) == "number" and ("k %.4g mm2/N = %.4g mm3/(N m)"):format(self.k, 1000 * self.k) or "k a function"
  local share = type(self.alpha) == "number" and ("alpha %g"):format(self.alpha) or "alpha a function"
  local lines = { ("wear of a joint: %.6g cycles, %s (the head's share), %s, %s"):format(self.cycles, share, coefficient,
    step_words(self)) }
  if self.cycles > 0 then
    lines[2] = ("  depth head %.4g, cup %.4g um; volume head %.5g, cup %.5g mm3: %.4g mm3 per million cycles"):format(
      1000 * self.depth.head, 1000 * self.depth.cup, self.volume.head, self.volume.cup, self.volume.total / self.cycles * 1e6)
    lines[3] = ("  largest pressure of the last cycle %.4g MPa, contact up to %.4g mm2"):format(self.p_peak, self.area)
  end
  return table.concat(lines, "\n")
end

runs.class = class
return runs

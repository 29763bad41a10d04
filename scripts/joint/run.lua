-- Wear runs of joints, wear{ model=j, loading=gait "iso" }. The loading consists of blocks of cycles with a
-- gait. Computes the steps, the history and the maps. A step that fails does not change the run. Lengths are in mm.

local bodies = require "archard.joint.bodies"
local check = require "archard.lib.check"
local k_doubt = require "archard.lib.k_doubt"
local flat = require "archard.joint.flat"
local gait = require "archard.joint.gait"
local given_gait = require "archard.joint.given_gait"
local lattice = require "archard.joint.lattice"
local measure = require "archard.measure"
local process = require "archard.process"
local progress = require "archard.lib.progress"
local sphere = require "archard.sphere"
local strict = require "archard.strict"
local text = require "archard.joint.text"

local runs = {}

local none = math.abs(0 / 0) -- NaN that is printed without a sign

local methods = {}
local class = { __name = "joint_wear", __methods = methods,
  __fields = { "alpha", "area", "creep", "cycle", "cycles", "depth", "depth_partition", "distance", "done", "functions", "history", "jump", "k",
    "limit", "loading", "model", "p_peak", "record", "saved", "scheme", "tolerance", "total_distance", "update", "updates", "volume" } }

-- --- definitions --------------------------------------------------------------------------------

local number_or_function = check.kind("a number >= 0 or a function", function(v)
  return type(v) == "function" or check.number.test(v) and v >= 0
end)
local loading_kind = check.kind('a gait such as gait "iso", its fields, or a list of blocks { gait=, cycles= }', given_gait.kind.test)
local fields = { loading = loading_kind, k = number_or_function,
  alpha = check.kind("a number in [0, 1] or a function", function(v)
    return type(v) == "function" or check.number.test(v) and v >= 0 and v <= 1
  end),
  creep = check.kind("a function", function(v) return type(v) == "function" end),
  cycles = check.positive, distance = check.positive, updates = check.count,
  jump = check.kind("a number > 0 or a function", function(v) return type(v) == "function" or check.positive.test(v) end), scheme = check.one_of{ "sweep", "explicit" }, tolerance = check.share,
  worn = check.table }
runs.fields = fields
runs.callable = { "k", "alpha", "creep", "jump" } -- settings that may be functions
local block_fields = { gait = given_gait.kind, cycles = check.positive }
local shape_kind = check.kind("a function of theta and phi in degrees, a map of a run, or the list of values of a map", function(v)
  return type(v) == "function" or type(v) == "table"
end)

-- Returns the loading as a list of blocks { gait=, cycles= }. If the last block has no cycles, it continues
-- without end.
local function blocks_of(given)
  if given_gait.is(given) or #given == 0 then return { { gait = given_gait.of(given), cycles = math.huge } } end
  local blocks = {}
  for i, block in ipairs(given) do
    if type(block) ~= "table" then check.refuse("joint:wear", ("loading[%d]"):format(i), "{ gait=, cycles= }", block) end
    block = check.fields("joint:wear", block, block_fields, ("loading[%d]."):format(i))
    if not block.gait or not (block.cycles or i == #given) then
      check.fail("joint:wear", ("field 'loading[%d]': expected a gait and cycles"):format(i))
    end
    blocks[i] = { gait = given_gait.of(block.gait), cycles = block.cycles or math.huge }
  end
  return blocks
end

-- Returns the list of depths [mm] on the lattice, from a function, a map or a list that the user gave.
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
  worn = check.fields("joint:wear", worn, { head = shape_kind, cup = shape_kind }, "worn.")
  for _, name in ipairs{ "head", "cup" } do
    if worn[name] ~= nil then check.as("joint:wear", sphere.set, engine, name, depths_of(engine, name, worn[name])) end
  end
end

local columns = { "update", "cycle", "distance", "jump", "load", "p_peak", "area", "depth_cylinder", "depth_plate", "volume_cylinder",
  "volume_plate", "depth_partition", "solutions" }
runs.columns = columns

-- Returns a history with the given columns, or an empty history if `given` has none. Its bodies are named
-- head and cup.
function runs.history(given)
  local history = {}
  for _, name in ipairs(columns) do history[name] = strict.table(given[name] or {}, "list of numbers") end
  return measure.columns(bodies, history)
end

local usual = { k = 3e-11, alpha = 0.5, cycles = 1e6, tolerance = 0.02, updates = 20 }

local function refuse_two(given, one, other)
  if given[one] and given[other] then
    check.fail("joint:wear", ("field '%s': expected %s or %s, got both"):format(one, one, other))
  end
end

-- Returns the sliding distance of the load over the head [mm] after a given number of cycles.
local function distance_of(run, cycles)
  local sum, first = 0, 0
  for _, block in ipairs(run.blocks) do
    sum = sum + math.max(0, math.min(block.cycles, cycles - first)) * block.gait.track * run.model.head.radius / 14
    first = first + block.cycles
  end
  return sum
end

-- Returns the number of cycles after which the load has moved a given distance [mm] over the head.
local function cycles_of(run, distance)
  local first = 0
  for i, block in ipairs(run.blocks) do
    local path = block.gait.track * run.model.head.radius / 14
    if i == #run.blocks or distance <= block.cycles * path then return first + distance / path end
    first, distance = first + block.cycles, distance - block.cycles * path
  end
end

-- Sets the result fields of a run from a record and from the depths on the bodies.
local function read(run, record)
  run.record, run.cycle, run.p_peak, run.area = record, record.cycles, record.p_peak, record.area
  run.update, run.distance, run.done = math.tointeger(record.updates), distance_of(run, record.cycles), record.cycles >= run.cycles * (1 - 1e-12)
  local head, cup = record.volume_head or 0, record.volume_cup or 0
  run.volume = rawset(measure.by_body(run.model, head, cup, "wear.volume"), "total", head + cup)
  run.depth = measure.by_body(run.model, lattice.deepest(run.engine, "head"), lattice.deepest(run.engine, "cup"), "wear.depth")
  local worn = run.depth.head + run.depth.cup
  run.depth_partition = worn > 0 and run.depth.head / worn or none
end

local function largest_load(instants)
  local most, load, instant = 0, nil, nil
  for i = 13, #instants, 15 do
    local x, y, z = instants[i], instants[i + 1], instants[i + 2]
    local size = math.sqrt(x * x + y * y + z * z)
    if size > most then most, load, instant = size, { x, y, z }, (i + 2) // 15 end
  end
  return load, most, instant
end

-- Sets the fields of a run from a record and appends a row to the history.
local function note(run, record)
  local h, n, before = run.history, #run.history.cycle + 1, run.cycle or 0
  read(run, record)
  local _, load = largest_load(run.loading.instants)
  local row = { update = run.update, cycle = run.cycle, distance = run.distance, jump = run.cycle - before, load = load,
    p_peak = run.p_peak, area = run.area, depth_cylinder = run.depth.head, depth_plate = run.depth.cup,
    volume_cylinder = run.volume.head, volume_plate = run.volume.cup, depth_partition = run.depth_partition,
    solutions = record.solutions }
  for _, name in ipairs(columns) do h[name][n] = row[name] or none end
end

-- Makes a run. model: a joint; given: the user's fields of wear{}.
function runs.new(model, given)
  given = check.definition("joint:wear", given or {}, fields)
  k_doubt("joint:wear", given.k)
  local run = { model = model, engine = sphere.create(model), blocks = blocks_of(given.loading or gait "iso"),
    k = given.k or usual.k, alpha = given.alpha or usual.alpha, creep = given.creep, cycles = given.cycles or usual.cycles,
    updates = given.updates, jump = given.jump, scheme = given.scheme or "sweep", tolerance = given.tolerance or usual.tolerance,
    history = runs.history{}, functions = {}, warned = {} }
  for _, name in ipairs(runs.callable) do
    if type(run[name]) == "function" then table.insert(run.functions, name) end
  end
  run.loading = run.blocks[1].gait
  if given.distance then run.cycles = cycles_of(run, given.distance) end
  run.step = run.cycles * usual.updates ^ -1.5 -- first step
  run.total_distance = distance_of(run, run.cycles)
  if run.scheme == "explicit" and type(run.k) == "function" then
    check.fail("joint:wear", "field 'scheme': expected \"sweep\" if k is a function, as its stability limit is unknown")
  end
  refuse_two(given, "cycles", "distance")
  refuse_two(given, "updates", "tolerance")
  refuse_two(given, "jump", "updates")
  refuse_two(given, "jump", "tolerance")
  if run.scheme == "explicit" and run.k > 0 then run.limit = sphere.limit(run.engine, run.loading.instants, run.k) end
  if given.worn then put_shapes(run.engine, given.worn) end
  note(run, { cycles = 0, updates = 0, solutions = 0 })
  return strict.object(run, class)
end

-- Returns the fields of wear{} from which an equal run can be made. Initial shapes are not included.
function methods:definition()
  local blocks = {}
  for i, block in ipairs(self.blocks) do
    blocks[i] = { gait = block.gait, cycles = block.cycles < math.huge and block.cycles or nil }
  end
  local goal = not (self.updates or self.jump) and self.tolerance or nil
  return { model = self.model, loading = blocks, k = self.k, alpha = self.alpha, creep = self.creep, cycles = self.cycles,
    scheme = self.scheme, updates = self.updates, jump = self.jump, tolerance = goal }
end

-- --- steps --------------------------------------------------------------------------------------

-- Returns the block at the present cycle of the run, and the cycle at which this block ends.
local function block_at(run)
  local last = 0
  for _, block in ipairs(run.blocks) do
    last = last + block.cycles
    if run.cycle < last * (1 - 1e-12) then return block, last end
  end
  return run.blocks[#run.blocks], math.huge
end

-- Returns a to-be-closed value. When it is closed, the joint returns to its present state, so that contacts
-- computed in between do not change the run.
local function unchanged(run)
  local state = sphere.state(run.engine)
  return setmetatable({}, { __close = function() sphere.set_state(run.engine, state) end })
end

-- Computes and returns the contact under the largest load of a gait. Raises an error if the cells are too
-- large, and warns if the contact is near the rim.
local function check_contact(run, gait_of_block)
  local load = largest_load(gait_of_block.instants)
  if not load then check.fail("joint_wear:run", "field 'loading': expected a gait with a load above 0") end
  local contact = check.as("joint_wear:run", sphere.press, run.engine, load[1], load[2], load[3])
  lattice.warn_of_rim("joint_wear:run", run.model, contact.rim_margin, run.warned)
  lattice.check_cells("joint_wear:run", run.engine, contact.half_angle)
  return contact
end

-- Checks the contact at the start of a block of the loading. At the start of the run, the pressure and the
-- area of the contact are written into the first row of the history.
local function begin_block(run, block)
  if run.cycle > 0 then
    local _ <close> = unchanged(run)
    check_contact(run, block.gait)
  else
    local contact = check_contact(run, block.gait)
    run.history.p_peak[1], run.history.area[1] = contact.p_max, contact.area
  end
  run.checked = block
end

-- Returns the number of cycles to the end of the next update if the user set the number m of updates. In a
-- run of n cycles, update j ends at cycle n (j/m)^1.5.
local function next_of_updates(run)
  local j = math.floor(run.updates * (run.cycle / run.cycles) ^ (2 / 3) + 1e-6) + 1
  return run.cycles * (j / run.updates) ^ 1.5 - run.cycle
end

-- Returns the number of cycles of the next update from the field updates or jump; nil if the user set
-- neither.
local function given_cycles(run)
  if run.updates then return next_of_updates(run) end
  if type(run.jump) ~= "function" then return run.jump end
  local cycles = run.jump{ cycle = run.cycle, distance = run.distance, update = run.update }
  if not check.positive.test(cycles) then check.refuse("joint_wear:run", "jump", "a number of cycles > 0 from the function", cycles) end
  return cycles
end

-- Returns the number of cycles of an explicit update: `jump` or, without a jump, a fixed part of the total
-- cycles, but at most the stability limit.
local function explicit_cycles(run, instants)
  local most = run.jump and given_cycles(run) or run.cycles / (run.updates or usual.updates)
  if run.k == 0 then return most end
  run.limit = sphere.limit(run.engine, instants, run.k)
  return math.min(most, run.limit)
end

-- Computes one step of the run, of at most `most` cycles, and returns the record of the step.
local function advance(run, instants, most)
  local function update(cycles)
    return check.as("joint_wear:run", sphere.update, run.engine, instants, run.k, run.alpha, math.min(cycles, most), run.record,
      run.scheme == "explicit", run.creep)
  end
  if run.scheme == "explicit" then return update(explicit_cycles(run, instants)) end
  local cycles = given_cycles(run)
  if cycles then return update(cycles) end
  local record, step = check.as("joint_wear:run", sphere.advance, run.engine, instants, run.k, run.alpha, most, run.record,
    run.tolerance, run.step, run.creep)
  run.step = step
  return record
end

-- Sets the results of a run that was read from a file. The maps of its engine must already be set.
function runs.restore(run, record, history)
  run.history = runs.history(history)
  read(run, record)
  run.loading = block_at(run).gait
end

-- Returns the function that is called after each step (the user's own function, or a function that updates the
-- progress bar), and the bar or nil if none is shown.
local function watcher(run, given, goal)
  if given == false then return function() end, nil end
  if type(given) == "function" then return given, nil end
  local bar = progress.new{ total = goal, done = run.cycle, label = "wear", unit = "cycles" }
  return function() bar:update(run.cycle, ("update %d"):format(run.update)) end, bar
end

local ended = setmetatable({}, { __close = function() process.report "" end })

-- Adds the progress of the run to the error message of Ctrl-C, until the returned to-be-closed value is
-- closed.
local function report(run, goal)
  process.report(("joint_wear:run: %.6g of %.6g cycles are computed and kept, w:run() continues"):format(run.cycle, goal))
  return ended
end

-- w:run{ cycles=, distance=, progress= } runs up to a number of cycles or a sliding distance [mm] of the
-- load. After an error or Ctrl-C, the run is at the end of its last complete step. If it is continued, the
-- results are identical to those of an uninterrupted run.
function methods:run(given)
  if not self.engine then check.fail("joint_wear:run", "expected a run, got a closed one") end
  given = check.definition("joint_wear:run", given or {}, { cycles = check.positive, distance = check.positive,
    progress = check.progress })
  local goal = given.cycles or given.distance and cycles_of(self, given.distance) or self.cycles
  local watch, shown <close> = watcher(self, given.progress, goal)
  local reported <close> = report(self, goal)
  while self.cycle < goal * (1 - 1e-12) do
    local block, last = block_at(self)
    if self.checked ~= block then begin_block(self, block) end
    self.loading = block.gait
    note(self, advance(self, block.gait.instants, math.min(goal, last) - self.cycle))
    lattice.warn_of_rim("joint_wear:run", self.model, self.record.rim_margin, self.warned, 0.5)
    report(self, goal)
    if watch(self) then break end
  end
  return self
end

-- w:close() releases the memory of the run.
function methods:close() self.engine = nil end

class.__close = methods.close

function methods:sensitivity(given) return sphere.sensitivity(self, given) end

-- --- results ------------------------------------------------------------------------------------

-- Returns the number (from 1) of the instant with the largest load.
function methods:heaviest() return (select(3, largest_load(self.loading.instants))) end

-- Solves the contact of the present surfaces at an instant of the cycle, given by its number from 1.
local function press_at(run, instant)
  local list, first = run.loading.instants, 15 * (instant - 1)
  check.as("joint_wear:map", sphere.press, run.engine, list[first + 13], list[first + 14], list[first + 15],
    table.move(list, first + 1, first + 9, 1, {}))
end

local map_kind = check.one_of{ "cup", "head", "cross shear", "creep", "pressure" }

-- w:map "cup" | "head" | "cross shear" | "creep" | "pressure", { instant= } returns a map over theta and
-- phi. The pressure is computed for the present surfaces at an instant of the cycle, by default at the
-- largest load.
function methods:map(what, given)
  if not map_kind.test(what) then check.refuse("joint_wear:map", "what", map_kind.expected, what) end
  local instants = self.loading.increments
  if not self.engine then check.fail("joint_wear:map", "expected a run, got a closed one") end
  given = check.definition("joint_wear:map", given or {}, { instant = check.whole(1, instants) })
  if what ~= "pressure" then return lattice.map(self.engine, what) end
  local _ <close> = unchanged(self)
  press_at(self, given.instant or self:heaviest())
  return lattice.map(self.engine, what)
end

local units = { ["cross shear"] = "-", pressure = "MPa" }

-- w:flat "cup" returns the values of w:map as a flat map over positions in mm (azimuthal equal-area
-- projection about the load).
function methods:flat(what)
  local map = self:map(what)
  return flat.map(#map.theta, map.values, self.model.head.radius, what, units[what] or "mm")
end

-- w:penetration() returns the displacement of the head into the cup under the largest load [mm].
function methods:penetration() return self.record.penetration end

-- w:save(path) saves the run. It can later be continued, with the same results as an uninterrupted run.
function methods:save(path) return require "archard.joint.file".write(self, path) end

local function step_words(run)
  if run.scheme == "explicit" then
    return run.limit and ("explicit updates, stable up to %.4g cycles each"):format(run.limit) or "explicit updates"
  end
  if run.updates then return ("%d updates"):format(run.updates) end
  if run.jump then return type(run.jump) == "number" and ("updates of %g cycles"):format(run.jump) or "updates by a function" end
  return ("steps with the tolerance %g"):format(run.tolerance)
end

function class:__tostring()
  if not self.engine then return "wear of a joint (closed)" end
  local coefficient = type(self.k) == "number" and ("k %.4g mm2/N = %.4g mm3/(N m)"):format(self.k, 1000 * self.k) or "k a function"
  local share = type(self.alpha) == "number" and ("alpha %g"):format(self.alpha) or "alpha a function"
  local lines = { "wear of a joint: " .. text(self.model),
    ("  wears by  %s, %s (the head's share)"):format(coefficient, share),
    ("  loading   %s%s"):format(self.loading.name, #self.blocks > 1 and (" of %d blocks"):format(#self.blocks) or ""),
    ("  done      %.6g of %.6g cycles, %s"):format(self.cycle, math.max(self.cycle, self.cycles), step_words(self)) }
  if self.cycle > 0 then
    lines[#lines + 1] = ("  depth     head %.4g, cup %.4g um\n  volume    head %.5g, cup %.5g mm3: %.4g mm3 per million cycles"):format(
      1000 * self.depth.head, 1000 * self.depth.cup, self.volume.head, self.volume.cup, self.volume.total / self.cycle * 1e6)
    lines[#lines + 1] = ("  pressure  up to %.4g MPa in a cycle, contact up to %.4g mm2"):format(self.p_peak, self.area)
  end
  return table.concat(lines, "\n")
end

strict.class(class)

return runs

-- Class case: a case of a study with its settings and, after its run, its results, which are read from the
-- run file on first use. A case has the methods of a wear object that plots need.

local check = require "archard.lib.check"
local joint_bodies = require "archard.joint.bodies"
local joint_file = require "archard.joint.file"
local hertz_of = require "archard.lib.hertz_of"
local keys = require "archard.lib.keys"
local map = require "archard.map.made"
local measure = require "archard.measure"
local naming = require "archard.plot.naming"
local merged = require "archard.lib.merged"
local settings = require "archard.definition.settings"
local strict = require "archard.strict"
local settable = require "archard.settings".wear

local case = {}

-- --- fields read on first use --------------------------------------------------------------------

local computed = {}

function computed.history(self) return joint_file.history(self.study:store(), self.id) end

function computed.surfaces(self) return joint_file.surfaces(self.study:store(), self.id) end

function computed.definition(self)
  return settings.nest(self.study:store():values(self.id, "definition"))
end

function computed.results(self)
  return settings.nest(self.study:store():values(self.id, "results"))
end

-- Returns the warning that the engine gave for this case, or nil if it gave none.
function computed.warning(self)
  local text = self.study.file and self.study:store():values(self.id, "results").warning
  return text and check.plain(tostring(text))
end

-- Returns the model's definition, from which archard.measure reads the names of the bodies. For a joint,
-- returns the module archard.joint.bodies, so that the joint need not be made.
function case.named(self)
  local model = self.definition.model
  return model and model.cup and joint_bodies or model
end

-- Returns the last row of the history by column name, or nil if there is no history.
function computed.last(self)
  local history = self.history
  if not history then return nil end
  local row = {}
  for name, column in pairs(history) do row[name] = column[#column] end
  return measure.columns(case.named(self), row, "case.last")
end

function computed.depth(self)
  local last = self.last
  return last and measure.by_body(case.named(self), last.depth_cylinder, last.depth_plate, "case.depth")
end

function computed.volume(self)
  local last = self.last
  if not last then return nil end
  local volume = measure.by_body(case.named(self), last.volume_cylinder, last.volume_plate, "case.volume")
  return rawset(volume, "total", last.volume_cylinder + last.volume_plate)
end

function computed.model(self)
  local model = next(self.definition) and self.definition.model
  if model and model.cup then return joint(model) end
  if model then model.bodies = measure.bodies(model) end
  return model
end

function computed.hertz(self)
  local definition = self.definition
  if not next(definition) or definition.model.cup then return nil end
  return hertz_of(definition.model, definition.load)
end

local measures = {}
for name in ("update cycle distance p_center p_max p_peak half_width depth_partition solutions")
  :gmatch("%S+") do
  measures[name] = true
end

-- --- methods -------------------------------------------------------------------------------------

local methods = {}

-- Returns the surface of a body at the last stored distance up to `distance` [mm]. Without `distance`,
-- returns the final surface.
local function surface(self, where, body, distance)
  local names = measure.bodies(self.model)
  local called = rawequal(body, nil) and names.upper or naming.body(where, { model = { bodies = names } }, body)
  body = called == names.upper and "cylinder" or "plate"
  if distance ~= nil and not check.number.test(distance) then
    check.refuse(where, "distance", "a number in mm", distance)
  end
  local found
  for _, each in ipairs(self.surfaces) do
    if each.body == body and (not distance or each.distance <= distance * (1 + 1e-9)) then
      found = each
    end
  end
  if not found then
    check.fail(where, ("case %d (%s) has no surface stored%s; its status is %s"):format(self.id,
      self.label, distance and (" up to a distance of %g mm"):format(distance) or "", self.status))
  end
  return found
end

-- Returns the numbers of rows over x and of columns over z of a stored surface, 1 and 1 for a line.
local function size_of(found)
  if not found.z then return 1, 1 end
  local columns = 1
  while found.x[columns + 1] == found.x[1] do columns = columns + 1 end
  return #found.x // columns, columns
end

-- Returns the given lists of a stored surface and its distance as a table. In 3-D, returns the line along
-- the motion through the middle; for a groove, which does not vary along the motion, the line across it.
local function line(where, found, names)
  local rows, columns = size_of(found)
  local of = { distance = found.distance }
  for _, name in ipairs(names) do
    of[name] = rows == 1 and found[name] or {}
    for i = 1, rows > 1 and rows or 0 do of[name][i] = found[name][(i - 1) * columns + columns // 2 + 1] end
  end
  if found.z and rows == 1 then of.x = found.z end
  return strict.table(of, where)
end

local function profile(self, where, body, distance)
  return line("case:profile", surface(self, where, body, distance), { "x", "h", "y" })
end

function methods:profile(body, distance) return profile(self, "case:profile", body, distance) end

function methods:pressure(body, distance)
  return line("case:pressure", surface(self, "case:pressure", body, distance), { "x", "p" })
end

local quantities = { depth = { "h", "mm" }, height = { "y", "mm" }, pressure = { "p", "MPa" } }

-- Returns a map of a surface of a 3-D run. what: a key of `quantities`, default "depth".
function methods:map(body, what, distance)
  local where = "case:map"
  what = what == nil and "depth" or what
  if not quantities[what] then check.refuse(where, "what", '"depth", "height" or "pressure"', what) end
  local found = surface(self, where, body, distance)
  local rows, columns = size_of(found)
  if rows < 2 or columns < 2 then
    check.fail(where, "expected a surface stored as a map of a 3-D run, got a line: use case:profile()")
  end
  local name, unit = table.unpack(quantities[what])
  local x = {}
  for i = 1, rows do x[i] = found.x[(i - 1) * columns + 1] end
  return map.new{ x = x, z = table.move(found.z, 1, columns, 1, {}), y = found[name], unit = unit, name = what }
end

-- Returns the list of sliding distances [mm] at which surfaces are stored.
function methods:distances()
  local list = {}
  for _, each in ipairs(self.surfaces) do
    if each.body == "cylinder" then list[#list + 1] = each.distance end
  end
  return list
end

-- Returns the sum of both wear depths at each position, Eq. (31). distance: sliding distance [mm]; default:
-- final.
function methods:combined(distance)
  local where = "case:combined"
  return measure.combined(profile(self, where, "cylinder", distance), profile(self, where, "plate", distance))
end

-- Returns the share of the cylinder in the sum of both depths, Eq. (30), at all positions with wear.
function methods:local_partition(distance)
  local where = "case:local_partition"
  return measure.local_partition(profile(self, where, "cylinder", distance), profile(self, where, "plate", distance))
end

-- Restores the run of the case as a wear object. The run can be continued.
function methods:wear() return joint_file.wear(self.study:store(), self.id) end

-- --- the object ----------------------------------------------------------------------------------

-- Names of all fields and methods of a case, including fields without a value.
local own = { id = true, label = true, status = true, message = true, seconds = true, settings = true, study = true }
local known = keys(merged(own, computed, measures, methods))
for _, setting in ipairs(settable) do known[#known + 1] = setting.name end

-- Returns the value of a field. Settings given by the user have priority over the stored definition, which
-- also contains defaults.
function case.__index(self, name)
  local value = methods[name]
  if value ~= nil then return value end
  if computed[name] then
    value = computed[name](self)
  elseif measures[name] then
    value = self.last and self.last[name]
  else
    value = rawget(self, "settings")[name]
    if value == nil and type(name) == "string" and rawget(self, "study").file then
      value = self.definition[name]
    end
  end
  if value == nil then return strict.refuse("case", name, known) end
  if self.status == "done" then rawset(self, name, value) end
  return value
end

case.__name = "case"
case.__methods = methods
strict.methods(case)
case.__fields = keys(merged(own, computed, measures))

function case.__tostring(self)
  local head = ("case %d: %s, %s"):format(self.id, self.label, self.status)
  if self.message then return head .. "\n  " .. self.message end
  if self.warning then head = head .. "\n  warning: " .. self.warning end
  local last = self.status == "done" and self.last
  if not last then return head end
  local pressure = last.p_center and ("p centre %.2f"):format(last.p_center) or ("p peak %.2f"):format(last.p_peak)
  return ("%s\n  %.6g mm, %s MPa, depth %.4f and %.4f um, volume %.4e mm3"):format(head,
    last.distance, pressure, 1e3 * last.depth_cylinder, 1e3 * last.depth_plate,
    last.volume_cylinder + last.volume_plate)
end

-- Makes a case. row: the row of the case in the run file; given: the nested settings of the case.
function case.new(study, row, given)
  row.study, row.settings = study, given
  return setmetatable(row, case)
end

return case

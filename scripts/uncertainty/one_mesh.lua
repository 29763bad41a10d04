-- One mesh for all samples, where the user has given none: that of the case with the middle values.
-- Meshes of their own, finer or coarser with the contact, would make every sample condense two bodies
-- anew, for twice the time of the run itself, and add what meshes differ by to what samples differ by.

local settings = require "archard.definition.settings"

-- What the size of a mesh depends on; and how far contacts may differ from the middle one, as a factor.
local largest_change = 1.5
local function may_change(name) return name == "load" or name:match("^model%.") ~= nil end

local function has_own(flat)
  if flat["model.mesh"] then return true end -- a file
  for _, name in ipairs{ "size", "height", "fineness" } do
    if flat["model.mesh." .. name] then return true end
  end
  return false
end

-- The elements that a case would have [mm].
local function size_of(flat)
  local run <close> = wear(settings.nest(flat))
  return run.model.mesh.size
end

local function with(flat, values)
  return settings.join("study", flat, values)
end

-- How much the elements would change over the samples of a field, as a factor.
local function change_of(flat, middle, size, name)
  local low, high = flat[1][name], flat[1][name]
  for _, case in ipairs(flat) do low, high = math.min(low, case[name]), math.max(high, case[name]) end
  local most = 1
  for _, value in ipairs{ low, high } do
    local ratio = size_of(with(middle, { [name] = value })) / size
    most = math.max(most, ratio, 1 / ratio)
  end
  return most
end

local function find_size(sample, flat)
  local middle, values = flat[1], {}
  for _, field in ipairs(sample.fields) do values[field.name] = field.distribution.value(0.5) end
  middle = with(middle, values)
  local size, change = size_of(middle), 1
  for _, field in ipairs(sample.fields) do
    if may_change(field.name) then change = change * change_of(flat, middle, size, field.name) end
  end
  return change <= largest_change and size or nil
end

-- Sets the size of the elements in the flat settings of all cases; leaves them where a case cannot be
-- made (the run will tell), and where contacts differ too much for one mesh.
return function(sample, flat)
  local matters = false
  for _, field in ipairs(sample.fields) do matters = matters or may_change(field.name) end
  if not matters or has_own(flat[1]) then return end
  local fine, size = pcall(find_size, sample, flat)
  if not fine or not size then return end
  for _, case in ipairs(flat) do case["model.mesh.size"] = size end
end

-- Chooses a common element size for all samples if the user gave none: the automatic size of a case in which
-- all uncertain fields have their medians. A separate mesh for each sample would double the run time, and the
-- results would include differences between meshes.

local settings = require "archard.definition.settings"

-- largest_change: largest factor between the automatic element sizes of the samples and the common size.
-- may_change(name): returns true if a setting can change the automatic size.
local largest_change = 1.5
local function may_change(name) return name == "load" or name:match("^model%.") ~= nil end

local function has_own(flat)
  if flat["model.mesh"] then return true end -- a mesh file
  for _, name in ipairs{ "size", "height", "fineness" } do
    if flat["model.mesh." .. name] then return true end
  end
  return false
end

-- Returns the default element size [mm] of a case.
local function size_of(flat)
  local run <close> = wear(settings.nest(flat))
  return run.model.mesh.size
end

local function with(flat, values)
  return settings.join("study", flat, values)
end

-- Returns the largest factor (>= 1) by which the samples of the field `name` change the element size.
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

-- Sets a common element size in the flat settings of all cases. Changes nothing if the contacts differ too
-- much for one size. If a case is invalid, nothing changes either; its run then reports the error.
return function(sample, flat)
  local matters = false
  for _, field in ipairs(sample.fields) do matters = matters or may_change(field.name) end
  if not matters or has_own(flat[1]) then return end
  local fine, size = pcall(find_size, sample, flat)
  if not fine or not size then return end
  for _, case in ipairs(flat) do case["model.mesh.size"] = size end
end

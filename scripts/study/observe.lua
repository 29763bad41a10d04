-- Records the results that a fit compares with measurements: history columns and profiles at given distances.
-- The fit and its workers use this module. Workers read the list of results to record as text from the run
-- file.

local check = require "archard.lib.check"

local observe = {}

local function text_of(numbers)
  local words = {}
  for i, number in ipairs(numbers) do words[i] = ("%.17g"):format(number) end
  return table.concat(words, " ")
end

-- Returns the key of the profile of a body or, in three dimensions, of its section { x= } or { z= }. Dots are
-- replaced, because the key becomes part of a flat name in run files.
function observe.surface(body, section)
  if not section then return body end
  return (("%s_%s_%.17g"):format(body, section.x and "x" or "z", section.x or section.z):gsub("%.", ","))
end

local function profile_of(run, surface)
  local of_map = surface:match("^map_(%l+)$")
  if of_map then return { x = { 0 }, h = run:map(of_map).values } end
  local body, axis, at = surface:match("^(%l+)_([xz])_(.+)$")
  if not body then return run:profile(surface) end
  return run:profile(body, { [axis] = tonumber((at:gsub(",", "."))) })
end

-- Returns the list of results to record as text. what: { distances = increasing list [mm], columns = names of
-- history columns, surfaces = keys of profiles, loops = distances [mm] at which the friction loop is recorded
-- }.
function observe.text(what)
  return ("%s;%s;%s;%s"):format(text_of(what.distances), table.concat(what.columns, " "),
    table.concat(what.surfaces, " "), text_of(what.loops))
end

function observe.read(text)
  local what, parts = { distances = {}, columns = {}, surfaces = {}, loops = {} }, {}
  for part in (text .. ";"):gmatch("(.-);") do parts[#parts + 1] = part end
  for number in parts[1]:gmatch("%S+") do what.distances[#what.distances + 1] = tonumber(number) end
  for name in parts[2]:gmatch("%S+") do what.columns[#what.columns + 1] = name end
  for name in parts[3]:gmatch("%S+") do what.surfaces[#what.surfaces + 1] = name end
  for number in parts[4]:gmatch("%S+") do what.loops[#what.loops + 1] = tonumber(number) end
  return what
end

local function is_in(list, value)
  for _, one in ipairs(list) do
    if one == value then return true end
  end
  return false
end

local function reading(run, what, distance)
  local found, history = { distance = run.distance }, run.history
  for _, name in ipairs(what.columns) do
    local column = history[name]
    if not column then check.fail("fit", ("field 'of': no column '%s' in the history"):format(name)) end
    found[name] = column[#column]
  end
  for _, surface in ipairs(what.surfaces) do
    local profile = profile_of(run, surface)
    found[surface] = { x = profile.x, h = profile.h }
  end
  if is_in(what.loops, distance) then
    local loop = run:loop()
    found.loop = { x = loop.x, tangential = loop.tangential }
  end
  return found
end

-- Computes the run wear{ given } up to each distance. Returns a list with { distance=, COLUMN=,
-- SURFACE={x=,h=}, loop={x=,tangential=} } for each distance, and the run.
function observe.run(given, what, on_progress)
  local run, last = wear(given), what.distances[#what.distances]
  local readings = {}
  for i, distance in ipairs(what.distances) do
    run:run{ distance = distance, progress = function()
      if on_progress then on_progress(run.distance / last) end
    end }
    readings[i] = reading(run, what, distance)
  end
  return readings, run
end

return observe

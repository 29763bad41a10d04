-- What a fit looks at in a run: columns of the history and profiles at some distances. Used by the
-- fit itself and by workers, who find it as text in the run file. Leans on wear.

local observe = {}

local function text_of(numbers)
  local words = {}
  for i, number in ipairs(numbers) do words[i] = ("%.17g"):format(number) end
  return table.concat(words, " ")
end

-- what: { distances = growing list [mm], columns = list of names, bodies = list of names, loops = those
-- of the distances at which the friction loop is wanted }
function observe.text(what)
  return ("%s;%s;%s;%s"):format(text_of(what.distances), table.concat(what.columns, " "),
    table.concat(what.bodies, " "), text_of(what.loops))
end

function observe.read(text)
  local what, parts = { distances = {}, columns = {}, bodies = {}, loops = {} }, {}
  for part in (text .. ";"):gmatch("(.-);") do parts[#parts + 1] = part end
  for number in parts[1]:gmatch("%S+") do what.distances[#what.distances + 1] = tonumber(number) end
  for name in parts[2]:gmatch("%S+") do what.columns[#what.columns + 1] = name end
  for name in parts[3]:gmatch("%S+") do what.bodies[#what.bodies + 1] = name end
  for number in parts[4]:gmatch("%S+") do what.loops[#what.loops + 1] = tonumber(number) end
  return what
end

local function is_in(list, value)
  for _, one in ipairs(list) do
    if one == value then return true end
  end
  return false
end

local function look(run, what, distance)
  local found, history = { distance = run.distance }, run.history
  for _, name in ipairs(what.columns) do found[name] = history[name][#history[name]] end
  for _, body in ipairs(what.bodies) do
    local profile = run:profile(body)
    found[body] = { x = profile.x, h = profile.h }
  end
  if is_in(what.loops, distance) then
    local loop = run:loop()
    found.loop = { x = loop.x, tangential = loop.tangential }
  end
  return found
end

-- Runs wear{ given } to every distance: a list of { distance=, COLUMN=, BODY={x=,h=}, loop={x=,tangential=} }; and the run.
function observe.run(given, what, on_progress)
  local run, last = wear(given), what.distances[#what.distances]
  local looks = {}
  for i, distance in ipairs(what.distances) do
    run:run{ distance = distance, progress = function()
      if on_progress then on_progress(run.distance / last) end
    end }
    looks[i] = look(run, what, distance)
  end
  return looks, run
end

return observe

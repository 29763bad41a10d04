-- What a fit looks at in a run: columns of the history and profiles at some distances. Used by the
-- fit itself and by workers, who find it as text in the run file. Leans on wear.

local observe = {}

-- what: { distances = growing list [mm], columns = list of names, bodies = list of names }
function observe.text(what)
  local numbers = {}
  for i, distance in ipairs(what.distances) do numbers[i] = ("%.17g"):format(distance) end
  return ("%s;%s;%s"):format(table.concat(numbers, " "), table.concat(what.columns, " "),
    table.concat(what.bodies, " "))
end

function observe.read(text)
  local what, parts = { distances = {}, columns = {}, bodies = {} }, {}
  for part in (text .. ";"):gmatch("(.-);") do parts[#parts + 1] = part end
  for number in parts[1]:gmatch("%S+") do what.distances[#what.distances + 1] = tonumber(number) end
  for name in parts[2]:gmatch("%S+") do what.columns[#what.columns + 1] = name end
  for name in parts[3]:gmatch("%S+") do what.bodies[#what.bodies + 1] = name end
  return what
end

local function look(run, what)
  local found, history = { distance = run.distance }, run.history
  for _, name in ipairs(what.columns) do found[name] = history[name][#history[name]] end
  for _, body in ipairs(what.bodies) do
    local profile = run:profile(body)
    found[body] = { x = profile.x, h = profile.h }
  end
  return found
end

-- Runs wear{ given } to every distance: a list of { distance=, COLUMN=, BODY={x=,h=} }; and the run.
function observe.run(given, what, on_progress)
  local run, last = wear(given), what.distances[#what.distances]
  local looks = {}
  for i, distance in ipairs(what.distances) do
    run:run{ distance = distance, progress = function()
      if on_progress then on_progress(run.distance / last) end
    end }
    looks[i] = look(run, what)
  end
  return looks, run
end

return observe

-- make peer: the exported decks run through CalculiX, side by side with archard. Linear elements of the same kind on the
-- same nodes; CalculiX presses by a penalty, archard without. CPU seconds of one
-- thread; an increment of archard's is one of a run, with its share of wear and of new geometry.

local ccx = dofile(arg[0]:match("^.*/") .. "ccx.lua")

local function largest(values)
  local most = -math.huge
  for _, value in ipairs(values) do most = math.max(most, value) end
  return most
end

local function timed(f)
  local start = os.clock()
  f()
  return os.clock() - start
end

local function ours(c)
  local stress = c:stress()
  return { p_center = c.p_center, p_max = c.p_max,
    mises = { cylinder = largest(stress.cylinder.mises), plate = largest(stress.plate.mises) } }
end

-- What all nodes of the cylinder carry across.
local function force_on(c)
  local x, p = c:pressure("cylinder").x, c:pressure("cylinder").p
  local sum = 0
  for i = 2, #x - 1 do sum = sum + p[i] * (x[i + 1] - x[i - 1]) / 2 end
  return sum * c.model.thickness
end

local function theirs(folder, name, c)
  export.inp(c, ("%s/%s.inp"):format(folder, name))
  local meshes = c.model.mesh
  return assert(ccx.solve(folder, name, meshes.cylinder.nodes, meshes.cylinder.nodes + meshes.plate.nodes))
end

local function line(what, a, b, form)
  io.write(("| %s | %s | %s | %+.2f %% |\n"):format(what, form:format(a), form:format(b), 100 * (b / a - 1)))
end

local function compare(folder, name, title, c, seconds)
  local a, b = ours(c), theirs(folder, name, c)
  line(title .. ": centre pressure [MPa]", a.p_center, b.p_center, "%.4g")
  line("largest pressure [MPa]", a.p_max, b.p_max, "%.4g")
  line("largest von Mises, cylinder [MPa]", a.mises.cylinder, b.mises.cylinder, "%.4g")
  line("plate [MPa]", a.mises.plate, b.mises.plate, "%.4g")
  line("force [N]", force_on(c), b.force, "%.6g")
  io.write(("| seconds an increment | %.2g | %.2g | x %.1e |\n"):format(seconds, b.seconds / b.increments,
    b.seconds / b.increments / seconds))
end

local function main()
  local folder = os.tmpname()
  os.remove(folder)
  assert(os.execute("mkdir " .. folder))
  io.write("| | archard | CalculiX | |\n|---|---|---|---|\n")
  local m = model{}
  local w = wear{ model = m }
  local unworn = contact{ model = m }
  local seconds = timed(function() w:run{ progress = false } end) / w.solutions
  compare(folder, "unworn", "unworn", unworn, seconds)
  compare(folder, "worn", "worn, 1320 mm", w:contact(), seconds)
  local soft = wear{ model = { plate = { E = 1000, nu = 0.46 } }, load = 1, k = 1e-7 }
  seconds = timed(function() soft:run{ distance = 200, progress = false } end) / soft.solutions
  compare(folder, "soft", "soft plate, nu = 0.46, worn", soft:contact(), seconds)
  os.execute("rm -r " .. folder)
end

main()

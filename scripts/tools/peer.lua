-- Solves exported decks in CalculiX and compares the results with those of archard (make peer). Both programs
-- use the same linear elements on the same nodes. CalculiX enforces contact by a penalty, archard exactly.
-- Times are CPU seconds of one thread. The time of an increment in archard is a mean over a wear run and
-- includes wear and geometry updates. ball.lua adds a ball on a flat in three dimensions, with bricks of 20
-- nodes.

local here = arg[0]:match("^.*/")
local ccx = dofile(here .. "ccx.lua")
local ball = dofile(here .. "ball.lua")

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

-- Returns the total normal force on the cylinder [N], integrated from the contact pressure.
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

-- Solves a case in both programs. Returns the title and both results. seconds: time per increment of the wear
-- run in archard.
local function case(folder, title, c, seconds)
  local a, b = ours(c), theirs(folder, "deck", c)
  a.force, a.seconds = force_on(c), seconds
  b.seconds = b.seconds / b.increments
  for _, result in ipairs{ a, b } do
    result.cylinder, result.plate = result.mises.cylinder, result.mises.plate
  end
  return { title = title, ours = a, theirs = b }
end

local rows = { { "p_center", "centre pressure [MPa]" }, { "p_max", "largest pressure [MPa] (*)" },
  { "cylinder", "largest von Mises stress, cylinder [MPa]" }, { "plate", "largest von Mises stress, plate [MPa]" },
  { "force", "force on the cylinder [N]" } }

local function show(cases)
  local head, rule = "| archard / CalculiX |", "|---|"
  for _, c in ipairs(cases) do
    head, rule = head .. " " .. c.title .. " |", rule .. "---|"
  end
  io.write(head, "\n", rule, "\n")
  for _, row in ipairs(rows) do
    io.write("| ", row[2], " |")
    for _, c in ipairs(cases) do
      local a, b = c.ours[row[1]], c.theirs[row[1]]
      io.write((" %.4g / %.4g (%+.1f %%) |"):format(a, b, 100 * (b / a - 1)))
    end
    io.write("\n")
  end
  io.write("| CPU seconds per increment (+) |")
  for _, c in ipairs(cases) do io.write((" %.1g / %.1f |"):format(c.ours.seconds, c.theirs.seconds)) end
  io.write("\n\n(*) CalculiX extrapolates pressures from points within the elements to the nodes; "
    .. "its values are too high at the edge of a scar.\n",
    "(+) archard: mean of a whole run, including wear and geometry updates; CalculiX: mean of two increments, including reading and writing of files.\n")
end

local function run_of(definition)
  local w = wear(definition)
  local seconds = timed(function() w:run{ progress = false } end)
  return w, seconds / w.solutions
end

local function main()
  local folder = os.tmpname()
  os.remove(folder)
  assert(os.execute("mkdir " .. folder))
  local w, seconds = run_of{}
  local soft, soft_seconds = run_of{ model = { plate = { E = 1000, nu = 0.46 } }, load = 1, k = 1e-7, distance = 200 }
  local cases = { case(folder, "unworn", contact{ model = w.model }, seconds),
    case(folder, "worn, after 1320 mm", w:contact(), seconds),
    case(folder, "plate of 1 GPa, nu = 0.46, after 200 mm", soft:contact(), soft_seconds) }
  show(cases)
  ball(ccx, folder)
  os.execute("rm -r " .. folder)
end

main()

-- Measures computing times and memory of archard (make bench). Times are CPU seconds of one thread, memory is
-- the peak reported by the kernel. Arguments: "quick" omits the finer meshes; "sizes" prints and plots how
-- the times grow with the number of surface nodes, down to elements of 2.5 um (some minutes).

local function peak_memory()
  local file = io.open("/proc/self/status")
  local kb = file and file:read("a"):match("VmHWM:%s*(%d+)")
  if file then file:close() end
  return kb and tonumber(kb) / 1024
end

-- Returns the CPU seconds of the calling thread.
local function own_seconds()
  local file <close> = assert(io.open "/proc/thread-self/schedstat")
  return tonumber(file:read("a"):match "^%d+") / 1e9
end

local function timed(f)
  collectgarbage()
  local start = os.clock()
  local result = f()
  return os.clock() - start, result
end

local function line(what, value, unit, goal, note)
  io.write(string.format("  %-52s %9s %-4s %s\n", what, value, unit, goal and ("goal " .. goal) or note or ""))
end

-- Returns the time per contact solution [us] in a long run with frozen geometry, including all overhead.
local function solution_cost(model, finer)
  local w = wear{ model = model, geometry = "frozen", jump = 100 / finer }
  w:run{ distance = 132, progress = false }
  local before = w.solutions
  local seconds = timed(function() w:run{ progress = false } end)
  return 1e6 * seconds / (w.solutions - before)
end

-- Returns the time per increment [us] of a wear run with frozen geometry, the best of five runs.
local function cycle_cost(model, fields)
  local best = math.huge
  for _ = 1, 5 do
    local w = wear{ model = model, geometry = "frozen", jump = 100, cycles = 10000, k = 1e-9,
      friction = fields.friction, tangential = fields.tangential, increments = fields.increments, loading = fields.loading }
    local seconds = timed(function() w:run{ progress = false } end)
    best = math.min(best, 1e6 * seconds / w.solutions)
  end
  return best
end

-- Returns the time per increment [us] of contact:move{} under a tangential force, the best of five trials.
-- increments: number of increments in one call.
local function motion_cost(model, increments)
  local c = contact{ model = model, friction = 0.6 }:move{ tangential = 48 }
  local best, repeats = math.huge, math.ceil(400 / increments)
  for _ = 1, 5 do
    local seconds = timed(function()
      for _ = 1, repeats do c:move{ tangential = -48, increments = increments } end
    end)
    best = math.min(best, 1e6 * seconds / (repeats * increments))
  end
  return best
end

-- Prints the time of increments with friction between similar bodies, and its ratio to the time without
-- friction. The motion is asymmetric, so that no half of a cycle is computed as the mirror image of the
-- other.
local function friction_costs(model)
  local to_and_fro = { x = { -0.025, 0.0251, -0.025 }, increments = 40 }
  local plain = cycle_cost(model, { loading = to_and_fro })
  local function compare(what, cost)
    line(what, string.format("%.1f", cost), "us", nil, string.format("%.1f times the cost without friction", cost / plain))
  end
  line("an increment of a cycle, without friction", string.format("%.1f", plain), "us")
  compare("with friction, a wear run in partial slip", cycle_cost(model, { friction = 0.6, tangential = 30, increments = 40 }))
  compare("with friction, a wear run in gross slip", cycle_cost(model, { friction = 0.6, loading = to_and_fro }))
  compare("c:move under a force, 2000 increments", motion_cost(model, 2000))
  compare("c:move under a force, 20 increments", motion_cost(model, 20))
end

-- Runs the 20 cases of Table 1 of the paper. The cycles per update are divided by `finer`, because ripples
-- grow faster on finer meshes.
local function twenty_cases(model, geometry, finer)
  local solutions = 0
  local seconds = timed(function()
    for _, case in ipairs(require "archard.study.paper".cases()) do
      case.model, case.geometry, case.jump = model, geometry, case.jump / finer
      local w = wear(case)
      w:run{ progress = false }
      solutions = solutions + w.solutions
    end
  end)
  return seconds, solutions
end

local function model_of(size)
  return model{ mesh = { size = size, height = 1.25 * size } }
end

local function measure(size, finer, goals)
  local building, m = timed(function() return model_of(size) end)
  io.write(string.format("\nelements of %g x %g um at the contact (%d in all), cycles per update of Table 1%s\n", 1e3 * size,
    1.25e3 * size, m.mesh.cylinder.elements_count + m.mesh.plate.elements_count, finer > 1 and " / " .. finer or ""))
  line("building the model", string.format("%.3f", building), "s", goals.building)
  line("a contact solution in a long run", string.format("%.1f", solution_cost(m, finer)), "us", goals.solution)
  friction_costs(m)
  local seconds = timed(function() wear{ model = m, jump = 100 / finer }:run{ progress = false } end)
  line("the reference case, moving geometry", string.format("%.3f", seconds), "s")
  for _, geometry in ipairs{ "moving", "frozen" } do
    local took, solutions = twenty_cases(m, geometry, finer)
    line(string.format("20 cases, %s geometry, %d contact solutions", geometry, solutions), string.format("%.2f", took), "s",
      goals[geometry])
  end
  line("peak memory so far", string.format("%.0f", peak_memory() or 0 / 0), "MB", goals.memory)
end

-- Returns one row of the table of sizes: the times of the reference case on a mesh with elements of `size`
-- [mm].
local function cost_at(size)
  local finer = 0.02 / size
  local building, m = timed(function() return model_of(size) end)
  local row = { size = 1e3 * size, building = building, elements = m.mesh.cylinder.elements_count +
    m.mesh.plate.elements_count, nodes = #contact{ model = m }:pressure("plate").x }
  for _, geometry in ipairs{ "frozen", "moving" } do
    local w = wear{ model = m, geometry = geometry, jump = 100 / finer }
    row[geometry] = timed(function() w:run{ progress = false } end)
    row.updates, row.solution = w.update, row.solution or 1e6 * row.frozen / w.solutions
  end
  row.memory = peak_memory() or 0 / 0
  return row
end

-- Returns the exponent with which a time grows with the number of surface nodes, from the two finest meshes.
local function growth(rows, what)
  local a, b = rows[#rows - 1], rows[#rows]
  return math.log(b[what] / a[what]) / math.log(b.nodes / a.nodes)
end

local function sizes()
  local rows, curves = {}, {}
  io.write("\nthe reference case (100 cycles per update at 20 um, proportional to the size)\n\n",
    "   size  plate's   elements   building  a solution    frozen    moving  updates   memory\n",
    "     um    nodes                     s          us         s         s                MB\n")
  for i, size in ipairs{ 0.04, 0.02, 0.01, 0.005, 0.0025 } do
    local r = cost_at(size)
    rows[i] = r
    io.write(string.format("%7g %8d %10d %10.3f %11.1f %9.3f %9.3f %8d %8.0f\n", r.size, r.nodes, r.elements, r.building,
      r.solution, r.frozen, r.moving, r.updates, r.memory))
    io.flush()
  end
  io.write("growth with the number of nodes\n", string.format("%37s%.1f %11.1f %9.1f %9.1f\n\n", "nodes^",
    growth(rows, "building"), growth(rows, "solution"), growth(rows, "frozen"), growth(rows, "moving")))
  for i, what in ipairs{ "building", "frozen", "moving" } do
    local x, y = {}, {}
    for k, r in ipairs(rows) do x[k], y[k] = r.nodes, r[what] end
    curves[i] = { x = x, y = y, title = what, style = "linespoints" }
  end
  curves.term, curves.logx, curves.logy = "dumb", true, true
  curves.title, curves.xlabel, curves.ylabel = "seconds against surface nodes", "nodes of the plate's surface", "s"
  plot(curves)
end

-- Measures the elapsed time of a study with many small cases and one worker per processor.
local function studies()
  local term, workers = require "archard.term", require "archard.process".processors()
  local file, loads = os.tmpname(), {}
  os.remove(file)
  for i = 1, 20 do loads[i] = 60 + 3 * i end
  local s = study{ snapshots = 2, base = { jump = 80, increments = 20,
    model = { mesh = { size = 0.04, height = 0.05 } } },
    vary = { alpha = { 0.1, 0.3, 0.5, 0.7, 0.9 }, stroke = { 0.1, 0.2, 0.4 }, load = loads } }
  local start = term.clock()
  s:run{ file = file, workers = workers, progress = false }
  local minutes = (term.clock() - start) / 60
  s:close()
  os.remove(file)
  io.write("\nstudies of many cases, results stored\n")
  line(string.format("300 cases at 40 um, %d worker%s, elapsed time", workers, workers > 1 and "s" or ""),
    string.format("%.0f", 300 / minutes), "a minute")
end

-- Measures the elapsed time of a sampled study of the reference case, including storage, and the time of its
-- statistics.
local function samples(count, geometry)
  local term, workers = require "archard.term", require "archard.process".processors()
  local file = os.tmpname()
  os.remove(file)
  local s = study{ base = { geometry = geometry }, n = count, sample = {
    k = lognormal{ mean = 1e-8, variation = 0.2 }, alpha = uniform{ 0.3, 0.7 }, load = normal{ 100, 5 } } }
  local start = term.clock()
  s:run{ file = file, workers = workers, progress = false }
  local minutes = (term.clock() - start) / 60
  local asked = timed(function() return s:uncertainty{ of = "depth_cylinder" } end)
  s:close()
  os.remove(file)
  line(string.format("%d samples, %s geometry, %d worker%s, elapsed time", count, geometry, workers,
    workers > 1 and "s" or ""), string.format("%.0f", count / minutes), "a minute", "10000")
  line("bands and quantiles of these samples", string.format("%.2f", asked), "s")
end

-- Measures the time to compute sensitivities from a run and its repetitions with small changes.
local function sensitivities()
  for _, jump in ipairs{ 100, "auto" } do
    local w = wear{ jump = jump }
    w:run{ progress = false }
    local found
    local seconds = timed(function() found = w:sensitivity() end)
    line(("sensitivities to k, alpha and load with jump %s (%d runs)"):format(jump, found.runs), string.format("%.2f", seconds), "s")
  end
end

-- Measures a fit of k and alpha to a pair of computed profiles.
local function fitting()
  local truth, data = wear{ k = 1.3e-8, alpha = 0.4, stroke = 0.22, jump = 50 }, {}
  truth:run{ progress = false }
  for i, body in ipairs{ "cylinder", "plate" } do
    data[i] = { profile = truth:profile(body), body = body, distance = 1320, error = 5e-5 }
  end
  local found
  local seconds = timed(function()
    found = fit{ base = { stroke = 0.22, jump = 50 }, unknown = { k = 1e-8, alpha = 0.5 }, data = data }
  end)
  line(("a fit of k and alpha to a pair of profiles, %d runs"):format(found.runs), string.format("%.2f", seconds), "s", "5")
end

-- Measures the time of McColl's fretting case in gross slip with the published number of cycles.
local function fretting()
  local w = wear{ model = { radius = 6, mesh = { size = 0.01, height = 0.01 } }, friction = 0.9, load = 18.5,
    stroke = 0.05, increments = 40, k_cylinder = 1.9e-8, k_plate = 2.9e-8, cycles = 18000, jump = "auto" }
  local seconds = timed(function() w:run{ progress = false } end)
  io.write("\nfretting with friction\n")
  line(string.format("McColl's 18000 cycles, 10 um, %d increments", w.solutions), string.format("%.2f", seconds), "s", "10")
end

-- Measures the times of runs of the paper's pair of bodies, defined by model{}, by body.cylinder{} and
-- body.block{}, and by a Gmsh file of the same mesh. The Gmsh mesh has no wear box, so its unknowns are
-- eliminated in another order, and no half stroke is computed as a mirror image.
local function general_paths()
  local text = export.msh(model{ radius = 10 })
  model{ radius = 9 } -- replaces the cached model, so that the next one is built completely
  local paths = {
    { name = "model{ radius=10 }", make = function() return model{ radius = 10 } end },
    { name = "body.cylinder on body.block", make = function()
      return model{ upper = body.cylinder{ radius = 10 }, lower = body.block{ width = 20, height = 10 } }
    end },
    { name = "the same mesh from Gmsh", make = function() return model{ radius = 10, mesh = text } end },
  }
  -- Calls f seven times for each definition. The best times are used, because other processes slow some
  -- calls.
  local function best(f)
    for _ = 1, 7 do
      for _, path in ipairs(paths) do f(path) end
    end
  end
  best(function(path)
    path.model = nil -- releases the cached model, so that it is built again
    collectgarbage()
    local seconds, m = timed(path.make)
    path.model, path.building = m, math.min(path.building or math.huge, seconds)
  end)
  best(function(path)
    local w = wear{ model = path.model, geometry = "frozen" }
    local seconds = timed(function() w:run{ progress = false } end)
    path.running, path.run = math.min(path.running or math.huge, seconds), w
  end)
  io.write("\nthe paper's pair of bodies from three definitions, frozen geometry\n")
  local function total(path) return path.building + path.running end
  local first = paths[1]
  for _, path in ipairs(paths) do
    local off = path.run.depth_cylinder / first.run.depth_cylinder - 1
    local same = off == 0 and path.run.p_center == first.run.p_center
    line(("%s: building %.3f, run %.3f"):format(path.name, path.building, path.running), ("%.3f"):format(total(path)), "s")
    line("  time relative to the first definition", ("%.2f"):format(total(path) / total(first)), "")
    line("  relative difference of the depth", same and "none" or ("%.1g"):format(math.abs(off)), "")
  end
end

-- Measures the time of a million cycles of walking with 400 contact solutions, for a metal joint with wear
-- of both bodies and for a joint with wear of the liner.
local function joints()
  io.write("\nball joints, 1e6 cycles of walking\n")
  local function walk(what, goal, definition, k, alpha)
    local j
    local building = timed(function() j = joint(definition) end)
    local seconds = timed(function() wear{ model = j, loading = gait "iso", k = k, alpha = alpha, cycles = 1e6 }:run() end)
    line(what .. ", building the joint", string.format("%.2f", building), "s", "0.2")
    line(what, string.format("%.2f", seconds), "s", goal)
  end
  walk("metal on metal at 2 degrees, both worn", "2", { mesh = { size = 2 } }, 3e-11, 0.5)
  local liner = { head = { material = material{ E = 1e15 } }, mesh = { size = 4 },
    cup = { clearance = 0.1, layers = { { thickness = 8, material = material{ E = 1000, nu = 0.4 } } } } }
  walk("polyethylene liner at 4 degrees", "1.5", liner, 1e-9, 0)
  liner.foundation = "winkler"
  walk("the liner with a Winkler foundation", "0.1", liner, 1e-9, 0)
end

-- Measures half-spaces in three dimensions: the time of contacts that fill most of a square of cells and of
-- increments with friction, and the time and memory of wear runs.
local function half_spaces(quick)
  io.write("\nhalf-spaces in three dimensions\n")
  local half = hertz{ geometry = "3-D", load = 10 }.half_width
  for _, cells in ipairs{ 64, 128, 256, 512 } do
    local m = model{ geometry = "3-D", mesh = { size = 2.3 * half / cells } }
    local best = math.huge
    for _ = 1, 3 do best = math.min(best, (timed(function() contact{ model = m, load = 10 } end))) end
    line(("contact on %d x %d cells, including its kernel"):format(cells, cells), string.format("%.0f", 1e3 * best), "ms")
  end
  for _, row in ipairs{ { 64, "10" }, { 128, "50" } } do
    local cells, goal = table.unpack(row)
    local m = model{ geometry = "3-D", mesh = { size = 2.3 * half / cells } }
    local c, best, each = contact{ model = m, load = 10, friction = 0.5 }, math.huge, 4
    c = c:move{ tangential = 3, increments = each }
    for _ = 1, 3 do
      best = math.min(best, (timed(function() c = c:move{ tangential = -c.tangential, increments = each } end)) / each)
    end
    local window = #c:shear().x
    line(("an increment with friction on %d x %d cells"):format(window, window), string.format("%.0f", 1e3 * best), "ms", goal)
  end
  for _, fineness in ipairs(quick and { 1 } or { 1, 2 }) do
    local m = model{ geometry = "3-D", upper = body.ball{ radius = 5 }, lower = body.block{}, mesh = { fineness = fineness } }
    local width = hertz{ geometry = "3-D", radius = 5, load = 20 }.half_width
    local function run(workers)
      local w, began = wear{ model = m, load = 20, stroke = 2 * width, distance = 6000, workers = workers }, own_seconds()
      local seconds = timed(function() w:run{ progress = false } end)
      return w, seconds, own_seconds() - began
    end
    local w, seconds = run(1)
    line(("R 5 mm, 20 N, stroke 2a, 6000 mm, cells a/%d, %d updates"):format(8 * fineness, w.update), string.format("%.2f", seconds),
      "s", fineness == 1 and "2.5" or "30")
    local shared, _, mine = run(2)
    assert(shared.depth.ball == w.depth.ball and shared.depth.block == w.depth.block, "two threads: results differ")
    line("  speed-up with two threads (calling thread)", ("%.2f"):format(seconds / mine), "", "1.7")
    line("  peak memory so far", string.format("%.0f", peak_memory() or 0 / 0), "MB")
  end
end

-- Measures the time [ms] from the start to the end of the program, the best of ten.
local function starting()
  local term, best = require "archard.term", math.huge
  for _ = 1, 10 do
    local start = term.clock()
    os.execute("'" .. arg[-1]:gsub("'", "'\\''") .. "' -e ''")
    best = math.min(best, 1e3 * (term.clock() - start))
  end
  line("start and end of the program, elapsed time", ("%.1f"):format(best), "ms", "50")
end

local mode = arg and arg[1]
io.write("archard bench: CPU time, one thread\n")
if mode == "sizes" then return sizes() end
starting()
measure(0.020, 1, { moving = "0.3", frozen = "2", solution = "2.5", memory = "300" })
general_paths()
fretting()
studies()
io.write("\nsamples of the reference case, results stored\n")
for _, geometry in ipairs{ "moving", "frozen" } do samples(mode == "quick" and 64 or 10000, geometry) end
sensitivities()
fitting()
joints()
half_spaces(mode == "quick")
io.write("\n10000 cycles of 100 increments, an update at every increment, geometry frozen\n")
package.path = arg[0]:match("^.*/") .. "?.lua"
require "million"(line)
if mode ~= "quick" then
  measure(0.010, 2, {})
  measure(0.005, 4, { building = "1", moving = "10" })
end

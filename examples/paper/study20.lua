-- Runs the paper's study: the twenty cases and the trials of its convergence example. Prints a
-- table of the results and draws the figures.
--   archard examples/paper/study20.lua [--file F] [--workers N] [--figures DIR] [--converge]
--     [--fine] [--shard I/N] [--merge F...] [--no-figures] [--no-trials]
-- Results are stored in the run file, so an interrupted study continues at the next start. With
-- --shard the script computes only share I of the N shares of the cases and draws nothing. --merge
-- joins the run files of the shares.

local usage = [[
usage: archard study20.lua [options]
  --file FILE      run file of the twenty cases (study.archard, in build/ if there is one)
  --workers N      cases at the same time (as many as there are processors)
  --figures DIR    where to draw the figures and index.html (figures, in build/ if there is one)
  --no-figures     draw nothing
  --fine           draw the twenty cases from a mesh of 10 um, and how results depend on the mesh
  --converge       search the largest step and the fewest increments of every case, for Table 1
  --no-trials      leave out the runs of Figure 8
  --shard I/N      compute only the share I of N into the run file
  --merge FILE...  join the run files of all shares first]]

local part = require "archard.lib.examples_folder".parts("study20", "paper")

local function stop(message)
  io.stderr:write(message, "\n", usage, "\n")
  os.exit(2, true)
end

-- Returns the default path of an output. In archard's source folder, outputs are written to build/.
local function usual(name)
  local folder = io.open("build/archard")
  if not folder then return name end
  folder:close()
  return "build/" .. name
end

local function read_options(arguments)
  local options, merged = { file = usual "study.archard", figures = usual "figures",
    trials = true }, nil
  local i = 1
  while i <= #arguments do
    local word = arguments[i]
    local name = word:match("^%-%-(%l+)$")
    if name == "file" or name == "workers" or name == "figures" or name == "shard" then
      i = i + 1
      options[name] = arguments[i] or stop("study20: " .. word .. " needs a value")
    elseif word == "--merge" then
      merged = {}
    elseif word == "--converge" or word == "--fine" then
      options[name] = true
    elseif word == "--no-figures" then
      options.figures = nil
    elseif word == "--no-trials" then
      options.trials = false
    elseif merged and not word:find("^%-") then
      merged[#merged + 1] = word
    else
      stop("study20: unknown option " .. word)
    end
    i = i + 1
  end
  options.merge = merged
  options.workers = options.workers and (math.tointeger(tonumber(options.workers))
    or stop("study20: --workers needs a whole number"))
  return options
end

local function file_beside(file, what)
  return (file:gsub("%.archard$", "") .. "-" .. what .. ".archard")
end

local fine_size = 0.010 -- [mm]; with elements of 20 um, pressure curves are visibly polygons

-- Computes the largest pressure of the unworn contact on successively smaller elements. Returns rows of
-- texts.
local function unworn_meshes()
  local rows = { { "size / µm", "elements across 2a", "largest p / MPa", "off Hertz'", "change" } }
  for _, step in ipairs((require "archard.study.search".mesh({}, 0.01))) do
    rows[#rows + 1] = { ("%.4g"):format(1e3 * step.size), ("%.1f"):format(step.elements),
      ("%.2f"):format(step.p_max), ("%+.2f %%"):format(100 * step.error),
      step.change and ("%+.2f %%"):format(100 * step.change) or "-" }
  end
  return rows
end

-- Returns a sentence about the settings for which the search ended at the limit of its range.
local function ends_of(found)
  local notes = found:notes()
  return notes[1] and "≥ and ≤ mark values at the limit of the search: " .. table.concat(notes, "; ")
    .. "." or ""
end

-- Returns the tables of the page as a list of { title=, text=, rows=, file= }.
local function page_tables(runs, found)
  local tables, findings = require "archard.study.table", part "findings"
  local sets = { { title = "archard, 20 µm", cases = runs.study20:cases() } }
  if runs.fine then
    sets[2] = { title = ("archard, %g µm"):format(1e3 * fine_size), cases = runs.fine:cases() }
  end
  local list = {}
  local function add(title, text, rows, file)
    list[#list + 1] = { title = title, text = text, rows = rows, file = file }
  end
  for _, set in ipairs(sets) do
    if not findings.complete(set.cases) then sets = {} end
  end
  if sets[1] then
    add("The paper, archard, and an independent solution", "What the paper says in numbers or words, "
      .. "what these runs give, and what closed forms or a solution by boundary elements give (two "
      .. "half-planes, cells of 5 µm).", findings.compared(sets))
    add("Final values", "Against the same independent solution, in brackets how far off.",
      findings.finals(sets))
  end
  add("Results", "The state at the end of each case, on the paper's mesh of 20 µm.",
    tables.rows(runs.study20, { "updates", "p_max", "half_width", "seconds", "status" }),
    "results.csv")
  if sets[1] then
    add("Table 1", "The cases as they were run, with the paper's cycles between two updates (N̄). "
      .. "SP slides the plate in n_c increments a cycle, NSP solves one contact an update. Eq. (28) "
      .. "uses the sliding distance 2 s of a cycle; over the whole plate, r = 1, it is s. It overestimates the "
      .. "first depth, as the last column shows.", findings.table_1(runs.study20:cases()))
  end
  if found then
    add("Table 1, from the search", "The paper's cycles between updates, and the most that keep the "
      .. "surfaces smooth and symmetric here, with the fewest increments a cycle (n_c) that give the "
      .. "same profiles. " .. ends_of(found), found:table_1())
  end
  add("Meshes, unworn", "The largest pressure of the unworn contact on elements of half the size each "
    .. "time, until two in a row are within 1 % of Hertz'.", unworn_meshes())
  if runs.meshes then
    add("Meshes, worn", "Stroke a at the end of the distance, on ever smaller elements.",
      part "trials".mesh_rows(runs.meshes:cases()))
  end
  return list
end

local function write_page(dir, runs, found, drawn)
  runs.study20:table{ file = dir .. "/results.csv" }
  part "page".write(dir .. "/index.html", {
    title = "Wear of a cylinder sliding on a plate: twenty cases",
    lead = "Five wear partition factors by four strokes, each over 1320 mm of sliding under 100 N "
      .. "per mm (R = 10 mm, steel on steel, k = 1e-8 mm²/N). Lengths along the surface are in "
      .. "units of a = 0.108 mm, half the width of the unworn contact, whose pressure is 591 MPa. "
      .. (runs.fine and ("Curves of the twenty cases are from a mesh of %g µm, with as many more "
      .. "updates; on the paper's 20 µm pressures are polygons. "):format(1e3 * fine_size) or "")
      .. "Every number on this page is measured on the runs when it is made.",
    tables = page_tables(runs, found), figures = drawn })
end

local function collect(into, drawn, how)
  for _, figure in ipairs(drawn) do
    figure.how = how
    into[#into + 1] = figure
  end
end

local function draw(options, runs, found)
  local terms, drawn = { "svg", "png" }, {}
  local function add(study_of, call)
    if not study_of then return end
    collect(drawn, study_of:figures{ dir = options.figures, term = terms },
      ("s = study.%s:run{ file = %q }\ns:figures{ dir = %q, term = { \"svg\", \"png\" } }"):format(
        call, study_of.file, options.figures))
  end
  add(runs.trials, "trials()")
  add(runs.meshes, "meshes()")
  add(runs.fine, ("paper{ model = { mesh = { size = %g, height = %g } } }"):format(fine_size,
    1.25 * fine_size))
  if not runs.fine then add(runs.study20, "paper()") end
  write_page(options.figures, runs, found, drawn)
  print(("%d figures and index.html are in %s"):format(#drawn, options.figures))
end

-- Runs the studies besides the twenty cases: the trials and, with --fine, the twenty cases on a finer
-- mesh and the study of meshes.
local function run_others(options, runs)
  local function run(name, made)
    runs[name] = made:run{ file = file_beside(options.file, name), workers = options.workers }
  end
  if options.trials then run("trials", study.trials()) end
  if not options.fine then return end
  run("fine", study.paper{ model = { mesh = { size = fine_size, height = 1.25 * fine_size } } })
  run("meshes", study.meshes())
end

local function failures(runs)
  local count = 0
  for _, each in pairs(runs) do count = count + #each.failed end
  return count
end

local function main(options)
  if options.merge then
    options.merge.file = options.file
    study.merge(options.merge)
  end
  local progress = options.shard and "lines" or nil
  local runs = { study20 = study.paper():run{ file = options.file, workers = options.workers,
    shard = options.shard, progress = progress } }
  if options.shard then return failures(runs) end
  print(runs.study20:table())
  run_others(options, runs)
  local found
  if options.converge then
    found = study.converge(study.paper(), { file = file_beside(options.file, "converge"),
      workers = options.workers })
    print(found)
  end
  if options.figures then draw(options, runs, found) end
  return failures(runs)
end

if main(read_options(arg)) > 0 then os.exit(1, true) end

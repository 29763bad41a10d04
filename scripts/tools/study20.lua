-- The paper's study: twenty cases and the trials of its convergence example, table and figures.
--   archard scripts/tools/study20.lua [--file F] [--workers N] [--figures DIR] [--converge]
--     [--shard I/N] [--merge F...] [--no-figures] [--no-trials]
-- Results are kept in the run file; a second start goes on where the first one ended. With --shard
-- only that share is computed, and nothing drawn; --merge joins the files of the shares.

local usage = [[
usage: archard study20.lua [options]
  --file FILE      run file of the twenty cases (study.archard, in build/ if there is one)
  --workers N      cases at the same time (as many as there are processors)
  --figures DIR    where to draw the figures and index.html (figures, in build/ if there is one)
  --no-figures     draw nothing
  --converge       find the best settings of every case, for Table 1
  --no-trials      leave out the runs of Figure 8
  --shard I/N      compute only the share I of N into the run file
  --merge FILE...  join the run files of all shares first]]

local function stop(message)
  io.stderr:write(message, "\n", usage, "\n")
  os.exit(2, true)
end

-- In the source folder what is made goes to build/.
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
    elseif word == "--converge" then
      options.converge = true
    elseif word == "--no-figures" then
      options.figures = nil
    elseif word == "--no-trials" then
      options.trials = false
    elseif merged and not word:find("^%-") then
      merged[#merged + 1] = word
    else
      stop("study20: cannot make sense of " .. word)
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

-- The paper's Table 1 as rows: cycles per update, and the depth of the first one.
local function table_1()
  local paper, p_h = require "archard.study.paper", hertz{}.p_max
  local rows = { { "α" } }
  for _, name in ipairs(paper.stroke_names) do
    rows[1][#rows[1] + 1] = "s = " .. name .. ": N̄"
    rows[1][#rows[1] + 1] = "Δh₀ / µm"
  end
  for i, alpha in ipairs(paper.alphas) do
    local row = { ("%g"):format(alpha) }
    for j, stroke in ipairs(paper.strokes) do
      local jump = paper.jumps[i][j]
      row[#row + 1] = jump and ("%d"):format(jump) or "-"
      row[#row + 1] = jump and ("%.2f"):format(1e3 * paper.first_depth(jump, 1e-8, p_h, stroke)) or "-"
    end
    rows[#rows + 1] = row
  end
  return rows
end

local function write_page(dir, study20, found, drawn)
  local tables = require "archard.study.table"
  study20:table{ file = dir .. "/results.csv" }
  require "archard.figures.page".write(dir .. "/index.html", {
    title = "Wear of a cylinder sliding on a plate: twenty cases",
    lead = "Five wear partition factors by four strokes, each over 1320 mm of sliding under 100 N "
      .. "per mm (R = 10 mm, steel on steel, k = 1e-8 mm²/N). Lengths along the surface are in "
      .. "units of a = 0.108 mm, half the width of the unworn contact, whose pressure is 591 MPa.",
    tables = { { title = "Results", rows = tables.rows(study20, { "updates", "p_max", "half_width", "seconds",
        "status" }), file = "results.csv",
        text = "The state at the end of each case." },
      { title = "Table 1", rows = table_1(),
        text = "Cycles between two updates of the surfaces (N̄), with 100 increments a cycle, and "
          .. "the depth of the first update by Eq. (28), which overestimates it." },
      found and { title = "Table 1, found anew", rows = found:table_1(),
        text = "The paper's cycles between updates, and the most that keep the surfaces smooth and "
          .. "symmetric here, with the fewest increments a cycle (n_c) that give the same profiles." }
    },
    figures = drawn })
end

local function collect(into, drawn, how)
  for _, figure in ipairs(drawn) do
    figure.how = how
    into[#into + 1] = figure
  end
end

local function draw(options, study20, trials, found)
  local terms, drawn = { "svg", "png" }, {}
  local function how(what, file)
    return ("s = study.%s():run{ file = %q }\ns:figures{ dir = %q, term = { \"svg\", \"png\" } }")
      :format(what, file, options.figures)
  end
  if trials then
    collect(drawn, trials:figures{ dir = options.figures, term = terms },
      how("trials", trials.file))
  end
  collect(drawn, study20:figures{ dir = options.figures, term = terms },
    how("paper", study20.file))
  write_page(options.figures, study20, found, drawn)
  print(("%d figures and index.html are in %s"):format(#drawn, options.figures))
end

local function main(options)
  if options.merge then
    options.merge.file = options.file
    study.merge(options.merge)
  end
  local progress = options.shard and "lines" or nil
  local study20 = study.paper():run{ file = options.file, workers = options.workers,
    shard = options.shard, progress = progress }
  if options.shard then return #study20.failed end
  print(study20:table())
  local trials
  if options.trials then
    trials = study.trials():run{ file = file_beside(options.file, "trials"),
      workers = options.workers }
  end
  local found
  if options.converge then
    found = study.converge(study.paper(), { file = file_beside(options.file, "converge"),
      workers = options.workers })
    print(found)
  end
  if options.figures then draw(options, study20, trials, found) end
  return #study20.failed + (trials and #trials.failed or 0)
end

if main(read_options(arg)) > 0 then os.exit(1, true) end

-- Help entries of studies, their cases, and what is made of them. Form: help.lua.

return {
  -- --- study ----------------------------------------------------------------------------------
  { "study", kind = "constructor",
    use = "s = study{ base={...}, vary={ alpha={0, 0.5, 1}, stroke={0.11, 0.22} } }",
    text = "Many wear runs: every combination of the varied fields, each run like wear{} with the "
      .. "fields of base. Results are stored as they come; an interrupted study goes on where it "
      .. "was. Without vary and cases, base is the only case." },
  { "study{base}", type = "table", takes = "wear",
    text = "Fields that all cases share, those of wear{}; functions cannot be stored, and are "
      .. "refused. What a case gives comes first: tables of fields are joined, lists and numbers "
      .. "replaced." },
  { "study{vary}", type = "table of lists", takes = "wear",
    text = "Fields of wear{} and the values each takes; the cases are all combinations, the last "
      .. "name by the alphabet changing fastest. Fields within fields are written nested or as "
      .. '["model.mesh.size"]. Numbers of the model go without its name as well, ["lower.E"] or '
      .. '["pin.radius"] of a body by role, name or kind, ["lower.layer1.thickness"] of a layer, E and nu of '
      .. "both bodies: so in cases, samples, fits and sensitivities too." },
  { "study{cases}", type = "list of tables", takes = "wear",
    text = "The cases one by one, instead of vary; each holds fields of wear{}." },
  { "study{name}", type = "string", default = '"study"',
    text = "Name of the study, for titles and the run file." },
  { "study{looks}", type = "whole number >= 0", default = 6,
    text = "How many times on its way the surfaces of a case are kept, at equal distances, the "
      .. "unworn ones among them; the final ones always are." },
  { "study{task}", values = { "wear", "converge" }, default = '"wear"',
    text = "What is done for each case: to run it, or to find the settings it needs as "
      .. "study.converge does." },
  { "study.name", kind = "field", text = "Name of the study." },
  { "study.file", kind = "field", text = "The run file; nil before the first run." },
  { "study.paper", kind = "function", class = "study", use = "study.paper(base)",
    text = "The 20 cases: alpha 0, 0.25, 0.5, 0.75, 1 by stroke a, 2a, 4a, 2R, with the jump and the "
      .. "increments of Table 1; base holds more fields of wear{} for all of them. On elements smaller than "
      .. "the paper's 20 um the jump is as much smaller, for ripples as short as elements grow first." },
  { "study.trials", kind = "function", class = "study", use = "study.trials(base)",
    text = "The runs of the convergence example (Fig. 8): stroke a, alpha 0.5, 1000 cycles, with "
      .. "several jumps and increments, by Eq. (4) and by Eq. (5)." },
  { "study.meshes", kind = "function", class = "study", use = "study.meshes(base)",
    text = "Stroke a with alpha 0.25 to 1 on elements of 20, 10 and 5 um: how depths and pressures "
      .. "depend on the mesh." },
  { "study.open", kind = "function", class = "study", use = "s = study.open(file)",
    text = "A study as its run file has it, to look at or to go on with." },
  { "study.merge", kind = "function", class = "study",
    use = "study.merge(file, ..., { file = \"study.archard\" })",
    text = "Joins the run files of the shards of one study; refuses missing and double cases." },
  { "study.merge{file}", type = "string", default = '"study.archard"',
    text = "The file that receives all cases." },
  { "study.fretting_map", kind = "function", class = "fretting_map",
    use = "f = study.fretting_map{ load={ 50, 100 }, motion={ 1e-3, 3e-3, 1e-2 } }",
    text = "The running condition fretting map: for each load and each amplitude of motion whether the contact sticks, slips "
      .. "partially or slides (gross slip), and at each load the motions between, from steady cycles between two forces. "
      .. "Any force makes a smooth contact slip at its edges: partial slip begins where a stroke slips on a share of "
      .. "the width (annulus), by Cattaneo and Mindlin under 1 - (1 - annulus)^2 of the force that slides it, 19 % for a "
      .. "tenth. That is followed from wider slip, as meshes seldom resolve it: for a cylinder within 13, 4, 3 and 2 % at a "
      .. "fineness of 1, 2, 4 and 8; gross slip within 0.5 %. Takes the fields of contact{} too (worn=, friction=, "
      .. "model=, which without one is built for each load with a fineness of 2)." },
  { "study.fretting_map{load}", type = "list of numbers", unit = "N", text = "Normal loads, increasing." },
  { "study.fretting_map{motion}", type = "list of numbers", unit = "mm",
    text = "Amplitudes of the plate's motion, half its strokes, increasing." },
  { "study.fretting_map{friction}", type = "number > 0", default = 0.6, text = "Coefficient of friction." },
  { "study.fretting_map{annulus}", type = "number in (0, 1)", default = 0.1,
    text = "Partial slip begins where slip takes this share of the contact's width, both sides together." },
  { "study.converge", kind = "function", class = "convergence",
    use = "c = study.converge{ base={ stroke=0.22 } }",
    text = "Finds the settings that cases need, by trial: the element size whose unworn pressure is "
      .. "within a limit of Hertz', at that size and at half of it, with at least eight elements "
      .. "across the contact; then the largest jump, never past the limit of stability, whose "
      .. "surfaces stay smooth and symmetric to the end of the run, then the fewest increments that give the same profiles. Takes the fields of study{} and "
      .. "those below, or a study and a table of them; many cases are searched by workers. For "
      .. "study.paper() it prints the paper's Table 1 with what was found beside it." },
  { "study.converge{base}", type = "table", text = "As in study{}." },
  { "study.converge{vary}", type = "table of lists", text = "As in study{}." },
  { "study.converge{cases}", type = "list of tables", text = "As in study{}." },
  { "study.converge{name}", type = "string", text = "As in study{}." },
  { "study.converge{mesh}", type = "boolean", default = true,
    text = "Whether the element size is searched, for the first case; all get it then." },
  { "study.converge{pressure}", type = "number", default = 0.01,
    text = "Mesh: how far the largest pressure may be off Hertz', as a share." },
  { "study.converge{smooth}", type = "number", default = 0.005,
    text = "Jump: largest sawtooth in the pressure over the middle of the contact (root mean square "
      .. "of fourth differences), as a share of the centre's, beyond that of a run in small steps: "
      .. "kinks that pass through the contact, and coarse meshes, make it rough by themselves. A "
      .. "quarter of that roughness is allowed, if it is more: the result says so." },
  { "study.converge{symmetric}", type = "number", default = 1e-3,
    text = "Largest difference of a profile to its mirror image, as a share of its depth." },
  { "study.converge{profile}", type = "number", default = 0.005,
    text = "Increments: largest change of a profile against 400 increments, as a share of its depth." },
  { "study.converge{updates}", type = "whole number from 4 to 1000", default = 100,
    text = "How many geometry updates are looked at, at most; fewer where the run ends." },
  { "study.converge{first_depth}", type = "number", unit = "mm", default = 1e-4,
    text = "Twice the depth of the first update, Eq. (28), of the small steps to compare with." },
  { "study.converge{file}", type = "string", default = '"converge.archard"',
    text = "Run file of the search, where there are many cases." },
  { "study.converge{workers}", type = "whole number", text = "As in study.run." },
  { "study.converge{progress}", type = 'function, false or "lines"', text = "As in study.run." },

  { "study.run", kind = "method", use = 's:run{ workers=2, file="study.archard" }',
    text = "Computes the cases that the file does not hold yet, in processes of their own; returns "
      .. "the study. Cases that failed before are tried again. s.failed lists those that failed, "
      .. "with their messages; they cost no other. s.warned lists those that this run warned of, such "
      .. "as a jump past the stability limit; the table marks them." },
  { "study.run{workers}", type = "whole number from 1 to 256",
    text = "Cases that run at the same time; as many as there are processors if left out." },
  { "study.run{file}", type = "string",
    text = "The run file, an SQLite database. Cases that it holds are not computed again. Without a name: the name of "
      .. "the study or else of the script, or study.archard; with a number where a file of that name holds something else." },
  { "study.run{keep}", type = "number > 0 s", default = 60,
    text = "Time after which a case that is still computed is kept in the file as far as it is; after a "
      .. "killed program it goes on from there, to the same bits." },
  { "study.run{shard}", type = 'string "i/n"',
    text = "Computes only the share i of n: cases i, i + n, and so on. One file a share; "
      .. "study.merge joins them." },
  { "study.run{progress}", type = 'function, false or "lines"',
    text = "A function called after each case with { case=, failure=, done=, total= }; false: "
      .. "silence; \"lines\": a line a case. Left out: a display, on a terminal." },
  { "study.submit", kind = "method", use = 's:submit{ engine="slurm", shares=8 }',
    text = "Computes the cases as a job array and returns the study: each share is a process with a "
      .. "run file of its own, that takes every shares-th of the cases still to do. A line shows how "
      .. "far they are; when all have ended they are joined in the run file, and what was cut short is "
      .. "started again. Ctrl-C and the end of this program leave the job alone: submitted again, it is "
      .. "followed, or joined and gone on with. Beside the run file FILE stands the folder FILE.shares "
      .. "until then; its machines must see it, and this program, under the same names. Each share "
      .. "should take minutes: Slurm starts about one a second. Cases that failed are in s.failed, and "
      .. "tried again by the next submit." },
  { "study.submit{engine}", values = { "slurm", "parallel", "local" }, default = '"local"',
    text = "slurm: a job array of Slurm's. parallel: processes of GNU parallel, here or, with "
      .. "--sshlogin, elsewhere. local: as s:run with so many workers." },
  { "study.submit{shares}", type = "whole number from 1 to 1000",
    text = "Into how many parts; as many as this machine has processors if left out." },
  { "study.submit{workers}", type = "whole number from 1 to 256", default = 1,
    text = "Cases that a share computes at the same time: the processors it asks for." },
  { "study.submit{file}", type = "string", text = "As in study.run." },
  { "study.submit{options}", type = "list of strings",
    text = 'More options of sbatch or parallel, such as { "--time=02:00:00", "--mem-per-cpu=500M" } or '
      .. '{ "--sshlogin", "one,two" }.' },
  { "study.submit{tries}", type = "whole number from 1 to 100", default = 3,
    text = "How often shares are started, the first time included, while cases are cut short." },
  { "study.submit{wait}", type = "boolean", default = true,
    text = "false: returns as soon as the job has started." },
  { "study.submit{progress}", type = 'function, false or "lines"',
    text = "A function called with { done=, total= } as cases end; \"lines\": a line instead. Left out: "
      .. "a display, on a terminal." },
  { "study.cases", kind = "method", class = "case", use = "s:cases()",
    text = "The list of all cases, with the results of those that have run." },
  { "study.table", kind = "method", use = 's:table{ format="markdown" }',
    text = "Final depths, pressures and alpha-tilde of every case, one line each, as text. On a "
      .. "narrow terminal some columns are left out." },
  { "study.table{format}", values = { "text", "csv", "markdown" }, default = '"text"',
    text = "Form of the table; by the file's ending where one is named." },
  { "study.table{file}", type = "string",
    text = "File to write it to: .txt, .csv or .md. The name of the file is returned then, not the table." },
  { "study.figures", kind = "method", use = 's:figures{ dir="figures" }',
    text = "Draws from the stored results: the paper's figures (of examples/paper) for study.paper, "
      .. "study.trials and study.meshes, final shapes, pressures and histories of up to eight cases for "
      .. "others. Returns a list of what was drawn." },
  { "study.figures{dir}", type = "string", default = '"figures"', text = "Folder to write them to." },
  { "study.figures{term}", values = { "svg", "png", "pdf", "dumb" }, default = '"svg"',
    text = "Kind of the pictures, or a list of kinds; dumb draws them in the terminal." },
  { "study.store", kind = "method", use = "s:store()",
    text = "The run file as it is, for those who write scripts of their own around it." },
  { "study.close", kind = "method", use = "s:close()",
    text = "Closes the run file; it is opened again when needed." },

  -- --- fretting maps --------------------------------------------------------------------------
  { "fretting_map", kind = "object", use = "f = study.fretting_map{...}",
    text = "What study.fretting_map found; print shows regimes and borders, plot.fretting_map draws them." },
  { "fretting_map.regime", kind = "field", type = "table",
    text = "regime[i][j]: \"stick\", \"partial\" or \"gross\" at load i and motion j." },
  { "fretting_map.partial_from", kind = "field", type = "list of numbers", unit = "mm",
    text = "At each load the amplitude above which it slips partially." },
  { "fretting_map.gross_from", kind = "field", type = "list of numbers", unit = "mm",
    text = "At each load the amplitude above which it slips grossly." },
  { "fretting_map.load", kind = "field", type = "list of numbers", unit = "N", text = "The loads." },
  { "fretting_map.motion", kind = "field", type = "list of numbers", unit = "mm", text = "The amplitudes." },
  { "fretting_map.friction", kind = "field", text = "Coefficient of friction." },
  { "fretting_map.annulus", kind = "field", text = "Share of the width with which partial slip begins." },

  -- --- convergence ----------------------------------------------------------------------------
  { "convergence", kind = "object", use = "c = study.converge{...}",
    text = "What study.converge found; print shows it." },
  { "convergence.mesh", kind = "field",
    text = "The element size that is enough, and the steps to it: { size=, steps=, limit= }." },
  { "convergence.cases", kind = "field",
    text = "A list of { label=, status=, settings=, found= }; found holds jump, limit (that of "
      .. "stability), judged (updates), increments, roughness, asymmetry, smooth (a limit "
      .. "that had to be loosened), change, first_depth, and "
      .. "the lists jumps and roughnesses of what was tried; capped where no larger jump was tried, "
      .. "with bound \"stability\" or \"cycles\" (a tenth of them) as the reason." },
  { "convergence.notes", kind = "method", use = "c:notes()",
    text = "Where the search ended at a bound of its own, as a list of texts." },
  { "convergence.table_1", kind = "method", use = "c:table_1()",
    text = "The paper's Table 1 with what was found beside it, as rows of texts." },

  -- --- calibrate ------------------------------------------------------------------------------
  { "calibrate", kind = "function", class = "calibration", takes = "wear",
    use = "calibrate{ volume={ cylinder={...}, plate={...} }, load=100, distance=1320 }",
    text = "From measured wear to the model's numbers. Volumes give k, k_cylinder, k_plate and alpha "
      .. "(Eq. 12) with the spread of repeated tests, and ranges of the means. Volumes at several "
      .. "distances, calibrate{ distance={...}, volume={ cylinder={...}, plate={...} }, load=100 }, "
      .. "give them as tables for wear{}: w = wear{ k=c.k, alpha=c.alpha } loses the measured volumes. "
      .. "Depths give the k and alpha of the run that makes them: calibrate{ depth={ cylinder=1.2e-3, "
      .. "plate=1.7e-3 }, load=100, distance=1320, stroke=0.44 }, with further fields of wear{}. A k that is "
      .. "given is kept, and refused where both depths together are more than 5 % off." },
  { "calibrate{volume}", type = "table { cylinder=, plate= }", unit = "mm3",
    text = "Worn volumes of both bodies: numbers, or lists of as many tests; the first of one body "
      .. "and the first of the other are of one test. 0 for what is too little to measure. With a list "
      .. "of distances: what is lost since the start up to each, a list, or a list of lists for "
      .. "several tests." },
  { "calibrate{depth}", type = "table { cylinder=, plate= }", unit = "mm",
    text = "Largest wear depths, likewise." },
  { "calibrate{load}", type = "number", unit = "N", text = "Load of the test." },
  { "calibrate{distance}", type = "number or list of numbers", unit = "mm",
    text = "Travelled distance of the test; a list where volumes were measured on the way." },
  { "calibrate{confidence}", type = "number", default = 0.95,
    text = "How sure low and high are to hold the mean between them (Student's distribution)." },
  { "calibrate{error}", type = "number", unit = "mm3",
    text = "Standard deviation of a volume reading, for low and high of a single test." },
  { "calibrate{accuracy}", type = "number", default = 1e-4,
    text = "How near the simulated depths must come: of alpha-tilde, and of the sum as a share of it." },
  { "calibration", kind = "object", use = "calibrate{...}",
    text = "The numbers found or, over a list of distances, tables { distance=, value= } that wear{} "
      .. "takes: constant between two measurements, which tell no more, with jumps at them, so that both "
      .. "measured volumes are met; beyond the last it stays. spread, low and high tell how sure they "
      .. "are. print shows them." },
  { "calibration.alpha", kind = "field", text = "Wear partition factor, or its table." },
  { "calibration.k", kind = "field", unit = "mm2/N", text = "Wear coefficient of the couple, or its table." },
  { "calibration.k_cylinder", kind = "field", unit = "mm2/N", text = "That of the cylinder." },
  { "calibration.k_plate", kind = "field", unit = "mm2/N", text = "That of the plate." },
  { "calibration.low", kind = "field",
    text = "Lower ends of the ranges that hold the means of k, k_cylinder, k_plate and alpha." },
  { "calibration.high", kind = "field", text = "Their upper ends." },
  { "calibration.confidence", kind = "field", text = "How sure these are." },
  { "calibration.band", kind = "field",
    text = "Over a list of distances, by name: { distance=, value=, low=, high= }, the means between "
      .. "two measurements, at the middles." },
  { "calibration.mean", kind = "field",
    text = "Over a list of distances: the numbers over the whole of it, with spread, low and high." },
  { "calibration.points", kind = "field", text = "How many distances were given." },
  { "calibration.depth_partition", kind = "field", text = "The measured alpha-tilde." },
  { "calibration.simulated_depth", kind = "field", unit = "mm",
    text = "Sum of both simulated depths." },
  { "calibration.measured_depth", kind = "field", unit = "mm", text = "Sum of the measured ones." },
  { "calibration.runs", kind = "field", text = "How many simulations it took." },
  { "calibration.measurements", kind = "field", text = "How many repetitions were given." },
  { "calibration.spread", kind = "field",
    text = "Standard deviations of the fields over the tests, pair by pair (alpha to first order); nil "
      .. "for single tests." },

  -- --- case -----------------------------------------------------------------------------------
  { "case", kind = "object", use = "s:cases()[1]",
    text = "A case of a study. It answers like a wear object, from what is stored: plot.pressure, "
      .. "plot.profile and plot.history draw it. Fields of its definition (alpha, stroke, jump, "
      .. "...) are there by name." },
  { "case.id", kind = "field", text = "Its number, from 1." },
  { "case.label", kind = "field", text = "The varied fields and their values, as text." },
  { "case.status", kind = "field", values = { "waiting", "running", "done", "failed" },
    text = "How far it is. One that runs when the program is killed waits again at the next run." },
  { "case.message", kind = "field", text = "Why it failed." },
  { "case.warning", kind = "field", text = "What its run warned of; nil: nothing." },
  { "case.seconds", kind = "field", unit = "s", text = "How long it took." },
  { "case.settings", kind = "field", text = "The fields of wear{} as given." },
  { "case.definition", kind = "field",
    text = "All fields of the run and its model, as the engine had them." },
  { "case.results", kind = "field", text = "What another task than a run has found." },
  { "case.study", kind = "field", class = "study", text = "The study it belongs to." },
  { "case.history", kind = "field", text = "Columns by name, as of wear objects." },
  { "case.last", kind = "field", text = "The last row of the history, by name." },
  { "case.surfaces", kind = "field",
    text = "All stored surfaces: { body=, update=, distance=, x=, h=, y=, p= }." },
  { "case.model", kind = "field", text = "The definition of its model." },
  { "case.hertz", kind = "field", class = "hertz", text = "The unworn contact." },
  { "case.depth", kind = "field", unit = "mm", text = "Final depths: { cylinder=, plate= }." },
  { "case.volume", kind = "field", unit = "mm3",
    text = "Final volumes: { cylinder=, plate=, total= }." },
  { "case.update", kind = "field", text = "Geometry updates done." },
  { "case.cycle", kind = "field", text = "Cycles done." },
  { "case.distance", kind = "field", unit = "mm", text = "Distance travelled." },
  { "case.p_center", kind = "field", unit = "MPa", text = "Final pressure at the centre." },
  { "case.p_max", kind = "field", unit = "MPa", text = "Final largest pressure." },
  { "case.p_peak", kind = "field", unit = "MPa",
    text = "Largest pressure over the last update's cycle, see wear.p_peak." },
  { "case.half_width", kind = "field", unit = "mm", text = "Final half width of the contact." },
  { "case.depth_partition", kind = "field", text = "Final alpha-tilde." },
  { "case.solutions", kind = "field", text = "Contact solutions it took." },
  { "case.profile", kind = "method", use = 'case:profile("cylinder" | "plate", distance)',
    text = "Wear profile { x=, h=, y= } at the last look not after that distance [mm]; at the end "
      .. "where none is given." },
  { "case.pressure", kind = "method", use = 'case:pressure("cylinder" | "plate", distance)',
    text = "Pressure { x=, p= } likewise, with the plate at x = 0." },
  { "case.combined", kind = "method", use = "case:combined(distance)",
    text = "Sum of both profiles { x=, h= }, Eq. (31)." },
  { "case.local_partition", kind = "method", use = "case:local_partition(distance)",
    text = "The cylinder's share of that sum { x=, value= }, Eq. (30)." },
  { "case.distances", kind = "method", use = "case:distances()",
    text = "The distances [mm] at which surfaces are stored." },
  { "case.wear", kind = "method", class = "wear", use = "case:wear()",
    text = "The run as a wear object, that goes on where the case ended." },
}

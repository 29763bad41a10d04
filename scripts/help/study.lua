-- Help entries of studies, their cases, and the results of studies. help/engine.lua explains the form of an
-- entry.

return {
  -- --- study ----------------------------------------------------------------------------------
  { "study", kind = "constructor",
    use = "s = study{ base={...}, vary={ alpha={0, 0.5, 1}, stroke={0.11, 0.22} } }",
    text = "Many wear runs: a case for each combination of the varied fields, all with the fields of base. s:run() "
      .. 'computes the cases, print(s) shows the results, plot.response(s, { x="stroke", y="volume_plate" }) draws '
      .. "a result over a field. Results are stored after each case; an interrupted study continues. Without vary "
      .. "and cases, base is the only case." },
  { "study{base}", type = "table", takes = "wear",
    text = "Fields of wear{} that all cases have in common. Functions are refused because they cannot be stored. "
      .. "Fields of a case override the fields of base: tables of fields are merged, lists and numbers are "
      .. "replaced." },
  { "study{vary}", type = "table of lists", takes = "wear",
    text = "Fields of wear{} with a list of values each. The cases are all combinations; the field with the "
      .. "alphabetically last name changes fastest. A field of an inner table is written nested or as "
      .. '["model.mesh.size"]. There are short names: ["lower.E"] or ["pin.radius"] for a body by its role, '
      .. 'name or kind, ["lower.layer1.thickness"] for a layer, E and nu for both bodies. Cases, samples, '
      .. "fits and sensitivities use the same names." },
  { "study{cases}", type = "list of tables", takes = "wear",
    text = "List of cases instead of vary; each case is a table of fields of wear{}." },
  { "study{name}", type = "string", default = '"study"',
    text = "Name of the study in titles and in the run file." },
  { "study{snapshots}", type = "whole number >= 0", default = 6,
    text = "Number of intermediate surfaces stored for each case, at equally spaced distances, including the "
      .. "unworn surfaces. The final surfaces are always stored." },
  { "study{task}", values = { "wear", "converge" }, default = '"wear"',
    text = '"wear" runs each case; "converge" searches for the mesh size, jump and increments that each '
      .. "case needs, as study.converge does." },
  { "study.name", kind = "field", text = "Name of the study." },
  { "study.file", kind = "field", text = "Path of the run file; nil before the first run." },
  { "study.paper", kind = "function", class = "study", use = "study.paper(base)",
    text = "The 20 cases of the paper: alpha 0, 0.25, 0.5, 0.75, 1 and strokes a, 2a, 4a, 2R (a: unworn half "
      .. "width, R: radius), with the jump and the increments of Table 1. base contains further fields of wear{} "
      .. "for all cases. On elements smaller than the paper's 20 um the jump is reduced in proportion, because "
      .. "shorter ripples become unstable at a smaller jump." },
  { "study.trials", kind = "function", class = "study", use = "study.trials(base)",
    text = "The runs of the paper's convergence example (Fig. 8): stroke a (the unworn half width), alpha "
      .. "0.5, 1000 cycles, with several jumps and numbers of increments, by Eq. (4) and by Eq. (5)." },
  { "study.meshes", kind = "function", class = "study", use = "study.meshes(base)",
    text = "Mesh study: stroke a (the unworn half width), alpha 0.25 to 1, on elements of 20, 10 and 5 um." },
  { "study.open", kind = "function", class = "study", use = "s = study.open(file)",
    text = "Opens the study stored in a run file, to evaluate or continue it." },
  { "study.merge", kind = "function", class = "study",
    use = "study.merge(file, ..., { file = \"study.archard\" })",
    text = "Merges the run files of the parts (shards) of a study, see study.run{shard}. Missing and duplicate "
      .. "cases are refused." },
  { "study.merge{file}", type = "string", default = '"study.archard"',
    text = "File to which all cases are written." },
  { "study.fretting_map", kind = "function", class = "fretting_map",
    use = "f = study.fretting_map{ load={ 50, 100 }, motion={ 1e-3, 3e-3, 1e-2 } }",
    text = "Running condition fretting map: the regime (stick, partial slip or gross slip) for each load and "
      .. "amplitude of motion, and the amplitudes of the transitions at each load, computed by periodic cycles "
      .. "between two forces. Any force causes some slip at the edges of a smooth contact; therefore the regime is "
      .. "called stick until slip covers the fraction `annulus` of the width. For the fraction 0.1, this is at 19 "
      .. "% of the force at which the whole contact slides (Cattaneo, Mindlin). The transition to partial slip has "
      .. "an error of 0.5 % for a cylinder (3 % for different materials, 8 % with mesh.fineness = 0.2) and 1.5 % "
      .. "for a ball. The transition to gross slip has an error of 0.5 % for a cylinder and 0.2 % for a ball. In "
      .. "3-D `annulus` is the width of the slip annulus as a fraction of the radius; for 0.1 partial slip then "
      .. "begins at 27 % of the sliding force. Accepts the fields of contact{} too (worn=, friction=, model=)." },
  { "study.fretting_map{load}", type = "list of numbers", unit = "N", text = "Normal loads, increasing." },
  { "study.fretting_map{motion}", type = "list of numbers", unit = "mm",
    text = "Amplitudes of the plate's motion, which are half the strokes, increasing." },
  { "study.fretting_map{friction}", type = "number > 0", default = 0.6, text = "Coefficient of friction." },
  { "study.fretting_map{annulus}", type = "number in (0, 1)", default = 0.1,
    text = "Fraction of the contact width that slips, at both edges together, at the transition to partial slip." },
  { "study.converge", kind = "function", class = "convergence",
    use = "c = study.converge{ base={ stroke=0.22 } }",
    text = "Mesh and step convergence study: searches for the element size, the jump and the increments at "
      .. "which results no longer change. The element size is small enough if the unworn pressure agrees "
      .. "with Hertz' pressure at this size and at half of it, with at least eight elements across the "
      .. "contact. The jump is the largest one below the stability limit for which the surfaces remain "
      .. "smooth and symmetric. The increments are the fewest that do not change the profiles. The cases "
      .. "are defined by the fields of study{}, beside the fields below, or by a study: study.converge(s, { smooth = 0.01 "
      .. "}). They are distributed to workers. For study.paper() it prints the table of increments and cycle jumps of "
      .. "the paper (\"citation\") next to the computed values." },
  { "study.converge{base}", type = "table", text = "Fields of wear{} that all cases have in common, see "
    .. "study{base}." },
  { "study.converge{vary}", type = "table of lists", text = "Varied fields with their values, see study{vary}." },
  { "study.converge{cases}", type = "list of tables", text = "A list of cases instead of vary, see study{cases}." },
  { "study.converge{name}", type = "string", text = "Name of the search in titles and in the run file." },
  { "study.converge{mesh}", type = "boolean", default = true,
    text = "If true, the element size is searched for with the first case only and used for all cases." },
  { "study.converge{pressure}", type = "number", default = 0.01,
    text = "For the element size: accepted relative difference of the largest unworn pressure from Hertz' "
      .. "pressure." },
  { "study.converge{smooth}", type = "number", default = 0.005,
    text = "For the jump: largest accepted sawtooth, the oscillation of the pressure from node to node in the "
      .. "middle of the contact (root mean square divided by p_center). Kinks and coarse meshes also cause a "
      .. "sawtooth; therefore the sawtooth of a reference run in small steps is subtracted. The accepted value is "
      .. "at least a quarter of the sawtooth of the reference run; if this increases it, the result has a note." },
  { "study.converge{symmetric}", type = "number", default = 1e-3,
    text = "For the jump: accepted difference between a profile and its mirror image, relative to its depth." },
  { "study.converge{profile}", type = "number", default = 0.005,
    text = "For the increments: accepted difference of a profile from the profile with 400 increments, relative to "
      .. "its depth." },
  { "study.converge{updates}", type = "whole number from 4 to 1000", default = 100,
    text = "Largest number of updates of a trial run." },
  { "study.converge{first_depth}", type = "number", unit = "mm", default = 1e-4,
    text = "Depth that determines the first update of the reference run in small steps: this update wears half the "
      .. "depth, Eq. (28)." },
  { "study.converge{file}", type = "string", default = '"converge.archard"',
    text = "Run file of the search, used if there are several cases." },
  { "study.converge{workers}", type = "whole number",
    text = "Number of cases at the same time, see study.run{workers}." },
  { "study.converge{progress}", type = 'function, false or "lines"',
    text = "Display of the progress, see study.run{progress}." },

  { "study.run", kind = "method", use = 's:run{ workers=2, file="study.archard" }',
    text = "Computes the cases not yet in the file, each in its own process, and returns the study. Cases that "
      .. "failed before are tried again. s.failed lists failed cases with their messages; a failure does not "
      .. "affect other cases. s.warned lists cases with warnings, such as a jump above the stability limit; "
      .. "s:table() marks them." },
  { "study.run{workers}", type = "whole number from 1 to 256",
    text = "Number of cases that run at the same time; default: the number of processors." },
  { "study.run{file}", type = "string",
    text = "The run file, an SQLite database. Cases in it are not computed again. Default: the name of the study or "
      .. "of the script, or study.archard, with a number if a file of that name has other contents." },
  { "study.run{keep}", type = "number > 0 s", default = 60,
    text = "Interval in seconds at which the state of a running case is stored. After an interruption the case "
      .. "continues from this state with exactly the same results." },
  { "study.run{shard}", type = 'string "i/n"',
    text = "Computes part i of n of the study: cases i, i + n, i + 2n, and so on. Use a separate file for each "
      .. "part, and merge them with study.merge." },
  { "study.run{progress}", type = 'function, false or "lines"',
    text = 'A function called after each case with { case=, failure=, done=, total= }; "lines": a line per case; '
      .. "false: no output. Default: a display on a terminal." },
  { "study.submit", kind = "method", use = 's:submit{ engine="slurm", shares=8 }',
    text = "Computes the cases as a job array and returns the study. The cases are divided into shares, each "
      .. "computed by a process with its own run file. At the end the files are merged, and interrupted cases are "
      .. "started again. Ctrl-C and the end of this program do not stop the job: submit the study again to follow "
      .. "or merge it. The folder FILE.shares beside the run file and this program must have the same paths on all "
      .. "machines. A share should run for minutes, because Slurm starts only about one share per second. Failed "
      .. "cases are in s.failed; the next submit tries them again." },
  { "study.submit{engine}", values = { "slurm", "parallel", "local" }, default = '"local"',
    text = "Program that starts the processes. slurm: a job array of Slurm. parallel: GNU parallel on this machine "
      .. "or, with --sshlogin, on others. local: s:run on this machine, with `shares` workers." },
  { "study.submit{shares}", type = "whole number from 1 to 1000",
    text = "Number of shares; default: the number of processors of this machine." },
  { "study.submit{workers}", type = "whole number from 1 to 256", default = 1,
    text = "Number of cases that a share computes at the same time. As many processors are requested for the "
      .. "share." },
  { "study.submit{file}", type = "string", text = "Run file of the study, see study.run{file}." },
  { "study.submit{options}", type = "list of strings",
    text = 'Further options of sbatch or parallel, such as { "--time=02:00:00", "--mem-per-cpu=500M" } or { '
      .. '"--sshlogin", "one,two" }.' },
  { "study.submit{tries}", type = "whole number from 1 to 100", default = 3,
    text = "Number of attempts at interrupted cases, including the first." },
  { "study.submit{wait}", type = "boolean", default = true,
    text = "If false, the call returns as soon as the job has started." },
  { "study.submit{progress}", type = 'function, false or "lines"',
    text = 'A function called with { done=, total= } after each case; "lines": prints a line after each case; '
      .. "false: no output. Default: a display on a terminal." },
  { "study.cases", kind = "method", class = "case", use = "s:cases()",
    text = "Returns the list of all cases, with the results of finished cases." },
  { "study.table", kind = "method", use = 's:table{ format="markdown" }',
    text = "Returns the final depths, pressures and alpha-tilde of every case as text, a line per case. Narrow "
      .. "terminals show fewer columns." },
  { "study.table{format}", values = { "text", "csv", "markdown" }, default = '"text"',
    text = "Format of the table. The default format of a file depends on its ending." },
  { "study.table{file}", type = "string",
    text = "File to write: .txt, .csv or .md. The call then returns its name instead of the table." },
  { "study.figures", kind = "method", use = 's:figures{ dir="figures" }',
    text = "Draws figures from the stored results and returns a list of them: the paper's figures for study.paper, "
      .. "study.trials and study.meshes; for other studies final shapes, pressures and histories of up to eight "
      .. "cases." },
  { "study.figures{dir}", type = "string", default = '"figures"', text = "Folder of the figures." },
  { "study.figures{term}", values = { "svg", "png", "pdf", "dumb" }, default = '"svg"',
    text = 'Format of the figures, or a list of formats; "dumb" draws them in the terminal.' },
  { "study.store", kind = "method", use = "s:store()",
    text = "Returns the open run file, for scripts that read it directly." },
  { "study.close", kind = "method", use = "s:close()",
    text = "Closes the run file; it is opened again when needed." },

  -- --- fretting maps --------------------------------------------------------------------------
  { "fretting_map", kind = "object", use = "f = study.fretting_map{...}",
    text = "Result of study.fretting_map. print lists regimes and transitions, plot.fretting_map draws them." },
  { "fretting_map.regime", kind = "field", type = "table",
    text = 'The regimes: regime[i][j] is "stick", "partial" or "gross" at load i and motion j.' },
  { "fretting_map.partial_from", kind = "field", type = "list of numbers", unit = "mm",
    text = "Amplitude of the transition from stick to partial slip, at each load." },
  { "fretting_map.gross_from", kind = "field", type = "list of numbers", unit = "mm",
    text = "Amplitude of the transition from partial to gross slip, at each load." },
  { "fretting_map.load", kind = "field", type = "list of numbers", unit = "N", text = "Normal loads of the map." },
  { "fretting_map.motion", kind = "field", type = "list of numbers", unit = "mm",
    text = "Amplitudes of the motions of the map." },
  { "fretting_map.friction", kind = "field", text = "Coefficient of friction." },
  { "fretting_map.annulus", kind = "field",
    text = "Fraction of the contact width that slips at the transition to partial slip." },

  -- --- convergence ----------------------------------------------------------------------------
  { "convergence", kind = "object", use = "c = study.converge{...}",
    text = "Result of study.converge; print shows it." },
  { "convergence.mesh", kind = "field",
    text = "Result of the search for the element size: { size=, steps= }, the size [mm] and a list of the trials." },
  { "convergence.cases", kind = "field",
    text = "Results of the search for each case, a list of { label=, status=, settings=, found= }. Fields of "
      .. "found: jump, the largest good jump; limit, the stability limit of the jump; judged, the number of "
      .. "updates in the trial of this jump; roughness and asymmetry at this jump; smooth, the accepted "
      .. "roughness if it was increased; increments, the number in a cycle; change, the difference of the "
      .. "profiles from the profiles with the most increments; first_depth [mm]; jumps and roughnesses, "
      .. "lists of all trials. The field capped is true if no larger jump was tried; bound is then the "
      .. 'reason: "stability", or "cycles" (jumps are limited to a tenth of all cycles).' },
  { "convergence.notes", kind = "method", use = "c:notes()",
    text = "Returns a list of texts about the cases whose search ended at a limit." },
  { "convergence.table_1", kind = "method", use = "c:table_1()",
    text = "Returns the paper's Table 1 and the computed values side by side, as rows of texts." },

  -- --- calibrate ------------------------------------------------------------------------------
  { "calibrate", kind = "function", class = "calibration", takes = "wear",
    use = "c = calibrate{ volume={ cylinder={ 0.5, 0.6 }, plate={ 1.1, 1.3 } },\n  load=100, distance=1e6 }\n"
      .. "print(c, c.k, c.low.k, c.high.k)   w = wear{ k=c.k, alpha=c.alpha }",
    text = "Computes wear coefficients (specific wear rates) from measured wear. Divide a mass loss by the "
      .. "density. Use 0 for a body that does not wear or was not measured. Volumes determine k, k_cylinder, "
      .. "k_plate and alpha (Eq. 12), with the scatter of repeated tests and confidence intervals of the "
      .. "means. Volumes at several distances, calibrate{ distance={...}, volume={ cylinder={...}, "
      .. "plate={...} }, load=100 }, determine tables over the distance; wear{ k=c.k, alpha=c.alpha } "
      .. "reproduces the volumes. From depths, k and alpha are computed by simulation: calibrate{ depth={ "
      .. "cylinder=1.2e-3, plate=1.7e-3 }, load=100, distance=1320, stroke=0.44 }, with further fields of "
      .. "wear{}. If k is set, only alpha is identified; it is an error if the simulated sum of both depths "
      .. "then differs by more than 5 % from the measured sum." },
  { "calibrate{volume}", type = "table { cylinder=, plate= }", unit = "mm3",
    text = "Worn volumes of both bodies: numbers, or lists with an item per test, in the same order for both "
      .. "bodies. 0 means too small to measure. With a list of distances, a body has the total volume at each "
      .. "distance: a list, or a list of lists for several tests." },
  { "calibrate{depth}", type = "table { cylinder=, plate= }", unit = "mm",
    text = "Largest wear depths of both bodies: numbers, or lists with an item per test." },
  { "calibrate{load}", type = "number", unit = "N", text = "Load of the test." },
  { "calibrate{distance}", type = "number or list of numbers", unit = "mm",
    text = "Travelled distance of the test; a list if volumes were measured at several distances." },
  { "calibrate{confidence}", type = "number", default = 0.95,
    text = "Confidence level of the interval between the results low and high, for each mean coefficient (Student's t distribution)." },
  { "calibrate{error}", type = "number", unit = "mm3",
    text = "Standard deviation of a volume measurement, from which the intervals of a single test are computed." },
  { "calibrate{accuracy}", type = "number", default = 1e-4,
    text = "Accuracy of the simulated depths: absolute for alpha-tilde, relative for the sum of both depths." },
  { "calibration", kind = "object", use = "calibrate{...}",
    text = "The wear coefficients or, for a list of distances, tables { distance=, value= } for wear{}. The values "
      .. "of a table are constant between two measurements, jump at each measurement, and are constant beyond the "
      .. "last one. print shows the coefficients with spread, low and high." },
  { "calibration.alpha", kind = "field", text = "Wear partition factor. For a list of distances: its values "
      .. "as a table { distance=, value= }." },
  { "calibration.k", kind = "field", unit = "mm2/N",
    text = "Wear coefficient of the couple. For a list of distances: its values as a table { distance=, value= }." },
  { "calibration.k_cylinder", kind = "field", unit = "mm2/N", text = "Wear coefficient of the cylinder." },
  { "calibration.k_plate", kind = "field", unit = "mm2/N", text = "Wear coefficient of the plate." },
  { "calibration.low", kind = "field",
    text = "Lower ends of the confidence intervals of k, k_cylinder, k_plate and alpha." },
  { "calibration.high", kind = "field",
    text = "Upper ends of the confidence intervals of k, k_cylinder, k_plate and alpha." },
  { "calibration.confidence", kind = "field", text = "Confidence level of the intervals." },
  { "calibration.band", kind = "field",
    text = "For a list of distances: confidence ranges band.k, band.alpha and so on. They are tables { distance=, "
      .. "value=, low=, high= } of the mean coefficients between two measurements; distance is in the middle "
      .. "between both." },
  { "calibration.mean", kind = "field",
    text = "For a list of distances: mean coefficients over the whole distance, with spread, low and high." },
  { "calibration.points", kind = "field", text = "Number of distances at which volumes were measured." },
  { "calibration.depth_partition", kind = "field", text = "Measured depth partition factor alpha-tilde." },
  { "calibration.simulated_depth", kind = "field", unit = "mm",
    text = "Sum of both simulated depths." },
  { "calibration.measured_depth", kind = "field", unit = "mm", text = "Sum of both measured depths." },
  { "calibration.conditions", kind = "field",
    text = "Conditions of the simulations, a list of texts: motion and load, bodies, and materials." },
  { "calibration.runs", kind = "field", text = "Number of simulations." },
  { "calibration.measurements", kind = "field", text = "Number of repeated tests." },
  { "calibration.spread", kind = "field",
    text = "Standard deviations of the coefficients over the tests (to first order for alpha); nil for a single "
      .. "test." },

  -- --- case -----------------------------------------------------------------------------------
  { "case", kind = "object", use = "s:cases()[1]",
    text = "A case of a study. It has the fields of a wear object, from stored results; plot.pressure, "
      .. "plot.profile and plot.history draw it. Fields of its definition (alpha, stroke, jump, ...) are available "
      .. "by name." },
  { "case.id", kind = "field", text = "Number of the case, from 1." },
  { "case.label", kind = "field", text = "The varied fields and their values as text." },
  { "case.status", kind = "field", values = { "waiting", "running", "done", "failed" },
    text = 'State of the case. A case that was interrupted is "waiting" again in the next run.' },
  { "case.message", kind = "field", text = "The error message of a failed case." },
  { "case.warning", kind = "field", text = "The warning of the run; nil if there was none." },
  { "case.seconds", kind = "field", unit = "s", text = "Computing time of the case." },
  { "case.settings", kind = "field", text = "The fields of wear{} that the study sets for the case." },
  { "case.definition", kind = "field",
    text = "All fields of the run and of its model, including defaults." },
  { "case.results", kind = "field", text = 'Results of a task other than "wear", such as "converge".' },
  { "case.study", kind = "field", class = "study", text = "The study of the case." },
  { "case.history", kind = "field", text = "Columns of the history by name, see wear.history." },
  { "case.last", kind = "field", text = "The last record of the history: a table with the names of the columns as keys." },
  { "case.surfaces", kind = "field",
    text = "All stored surfaces: { body=, update=, distance=, x=, h=, y=, p= }, lengths in mm, the pressure p in "
      .. "MPa. In 3-D also z=; the lists contain all points, row by row along z." },
  { "case.model", kind = "field", text = "Definition of the model, as a table." },
  { "case.hertz", kind = "field", class = "hertz", text = "Hertz' solution of the unworn contact." },
  { "case.depth", kind = "field", unit = "mm", text = "Final largest wear depths: { cylinder=, plate= }." },
  { "case.volume", kind = "field", unit = "mm3",
    text = "Final wear volumes: { cylinder=, plate=, total= }." },
  { "case.update", kind = "field", text = "Number of geometry updates done." },
  { "case.cycle", kind = "field", text = "Number of cycles done." },
  { "case.distance", kind = "field", unit = "mm", text = "Distance travelled." },
  { "case.p_center", kind = "field", unit = "MPa", text = "Final pressure at the centre." },
  { "case.p_max", kind = "field", unit = "MPa", text = "Final largest pressure." },
  { "case.p_peak", kind = "field", unit = "MPa",
    text = "Largest pressure over the last update's cycle, see wear.p_peak." },
  { "case.half_width", kind = "field", unit = "mm", text = "Final half width of the contact." },
  { "case.depth_partition", kind = "field", text = "Final depth partition factor alpha-tilde." },
  { "case.solutions", kind = "field", text = "Number of contact problems solved." },
  { "case.profile", kind = "method", use = 'case:profile("cylinder" | "plate", distance)',
    text = "Wear profile { x=, h=, y= } in mm of the last surface stored up to this distance [mm]; default: the "
      .. "final surface." },
  { "case.pressure", kind = "method", use = 'case:pressure("cylinder" | "plate", distance)',
    text = "Pressure { x=, p= } in mm and MPa of the last surface stored up to this distance [mm], with the plate "
      .. "at x = 0." },
  { "case.map", kind = "method", result = "map", use = 'case:map("ball", "depth" | "height" | "pressure", distance)',
    text = "In 3-D: a map of a body over x and z, of the last surface stored up to this distance [mm]; default: "
      .. "the final surface. case:profile and case:pressure are its line along the motion through the middle." },
  { "case.combined", kind = "method", use = "case:combined(distance)",
    text = "Sum of both wear profiles { x=, h= } in mm, Eq. (31)." },
  { "case.local_partition", kind = "method", use = "case:local_partition(distance)",
    text = "Wear depth of the cylinder divided by the sum of both depths, { x=, value= }, Eq. (30)." },
  { "case.distances", kind = "method", use = "case:distances()",
    text = "The distances [mm] at which surfaces are stored." },
  { "case.wear", kind = "method", class = "wear", use = "case:wear()",
    text = "The run as a wear object, which continues from the end of the case." },
}

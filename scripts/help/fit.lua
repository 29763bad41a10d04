-- Help entries of fits and of designs of tests. help/engine.lua explains the form of an entry.

return {
  { "fit", kind = "function", class = "fitted",
    use = 'f = fit{ unknown={ k=1e-8, alpha=0.5 }, base={ stroke=0.22, load=100 }, data={\n'
      .. '  { profile=profile.read "c.csv":depth(), body="cylinder", distance=1320 },\n'
      .. '  { of="depth_plate", distance={ 440, 1320 }, value={ 4e-4, 9e-4 },\n    error=5e-5 } } }\nprint(f)  plot.fit(f)',
    text = "Identifies parameters of wear{} and model{} from measured depths, volumes, profiles or loops, with "
      .. "standard errors: print(f), f.value.k, f.low.k and f.high.k (95 % interval). To identify both k and "
      .. "alpha, measure both bodies. calibrate{} is simpler for volumes of repeated tests. The method is weighted "
      .. "nonlinear least squares (Levenberg and Marquardt) of (model - data) / error. Derivatives are finite "
      .. "differences between runs, with steps chosen from the noise of the runs. Data of several kinds need "
      .. "standard errors. For data of one kind they can be omitted and are then estimated from the residuals. "
      .. "Standard errors, correlations and bands are linearised at the result. Intervals also include the error due "
      .. "to the mesh (f.mesh). fit{} refuses too few data, "
      .. "implausible units and an unknown without effect. A fit that does not converge raises an error with the "
      .. "last values; better start values, bounds (low, high) or fewer unknowns can help." },
  { "fit.best", type = "table { value=, chi2=, runs= }",
    text = "Best values of the latest fit by name (value), with chi2 and the number of runs. They remain available "
      .. "if the fit is interrupted by Ctrl-C." },
  { "fit{unknown}", type = "table of tables",
    text = "Parameters to identify, by name, each with its start value: numbers of wear{}, of a model and of its "
      .. 'bodies, such as k, ["model.radius"], ["lower.E"] or ["lower.layer1.thickness"] (the names of study{ '
      .. "vary= })." },
  { "fit{data}", type = "list of tables",
    text = "Measurements. Each is a profile { profile= or x=, h=, body=, distance= }, a list of values of the "
      .. "history { of=, distance=, value= }, or a friction loop { loop={ x=, tangential= }, cycle= or distance= "
      .. "}." },
  { "fit{base}", type = "table", takes = "wear",
    text = "Fields of wear{} that all runs have in common. The runs end at the last measurement." },
  { "fit{model}", type = "model object or table", takes = "model", text = "The two bodies, see wear{model}." },
  { "fit{file}", type = "string",
    text = "Run file. If it is set, worker processes make the runs, results are stored, and an interrupted fit "
      .. "continues. Otherwise all runs are made in this process and not stored." },
  { "fit{workers}", type = "whole number",
    text = "If a file is set: number of runs at the same time, see study.run{workers}." },
  { "fit{progress}", type = 'function, false or "lines"',
    text = "If a file is set: see study.run{progress}. Otherwise: a function that is called with the number of "
      .. "runs and the trial values." },
  { "fit{confidence}", type = "number", default = 0.95, text = "Confidence level of intervals and bands." },
  { "fit{unknown.start}", type = "number or list of numbers",
    text = "Start value, within the bounds. With knots: one value for all knots, or a list." },
  { "fit{unknown.low}", type = "number", text = "Lower bound; default: the lower limit of the field." },
  { "fit{unknown.high}", type = "number", text = "Upper bound; default: the upper limit of the field." },
  { "fit{unknown.knots}", type = "list of increasing numbers", unit = "mm",
    text = "Distances (knots) at which the values of k or alpha are unknown: k or alpha is then a curve over "
      .. "the distance, a monotone cubic between the knots and constant beyond the ends." },
  { "fit{unknown.smooth}", type = 'number >= 0 or "auto"', default = 0,
    text = "Weight of a term that smooths the curves: the squared second differences at the knots, relative to the "
      .. 'plausible range of the field. All curves have the same weight; "auto" chooses the weight by '
      .. "cross-validation. Standard errors do not include the bias due to smoothing." },
  { "fit{data.profile}", type = "profile or table { x=, h=, error= }", unit = "mm",
    text = "A measured surface: wear depth h at x; error is its standard error." },
  { "fit{data.x}", type = "list of numbers", unit = "mm",
    text = "Positions of the measured depths h, from the centre. Give x and h, or profile." },
  { "fit{data.h}", type = "list of numbers", unit = "mm", text = "Measured wear depths at the positions data.x." },
  { "fit{data.body}", values = { "cylinder", "plate" }, text = "Body on which the profile was measured." },
  { "fit{data.section}", type = "table { z= } or { x= }", unit = "mm",
    text = "In 3-D: position of the measured section, { z= } for a section along the motion, { x= } for a section "
      .. "across it. Default: along the motion at z = 0." },
  { "fit{data.distance}", type = "number or list of numbers", unit = "mm",
    text = "Travelled distance at which a profile or loop was measured, or the distance of each value." },
  { "fit{data.cycle}", type = "number or list of numbers", unit = "cycles",
    text = "Number of cycles, instead of distance. It is converted to a distance with the start values of "
      .. "the unknowns." },
  { "fit{data.map}", type = "table { theta=, phi=, values= }", unit = "degree, mm",
    text = "Measured depths of a joint's head or cup (field body): a map with lists theta, phi [degrees] and "
      .. 'values [mm], as w:map "cup" returns it. In values, phi varies fastest.' },
  { "fit{data.loop}", type = "table of lists", unit = "mm and N",
    text = "Motion x and tangential force of one cycle in the order of time, in the form that w:loop() returns; "
      .. "for runs with friction. A loop determines the coefficient of friction. Each half cycle is compared with "
      .. "the same half cycle of the run: forces at the measured positions or, if a force drives the run "
      .. "(tangential=), positions at the measured forces. The standard error is in N for forces, in mm for "
      .. "positions." },
  { "fit{data.compliance}", type = "number", unit = "mm/N", default = 0,
    text = "For a loop: compliance of the test rig, displacement per force. The measured motion x includes the "
      .. "motion due to this compliance." },
  { "fit{data.of}", type = "string",
    text = 'Measured quantity: a column of the history, such as "volume_plate" or "depth_cylinder"; "volume" means '
      .. 'the volume of both bodies, "width" the width of the contact.' },
  { "fit{data.value}", type = "number or list of numbers", text = "Measured values, in the unit of the column." },
  { "fit{data.error}", type = "number or list of numbers", text = "Standard error of the values, in their unit." },
  { "fit{data.relative}", type = "number", text = "Relative standard error of the values, instead of error." },
  { "fit{data.shift}", type = "number", unit = "mm",
    text = "Offset of the profile or loop along x. If it is omitted, it is identified too." },
  { "fit{data.tilt}", type = "number", unit = "mm/mm",
    text = "Tilt of the profile, positive if h increases with x. If it is omitted, it is identified too." },
  { "fit{data.level}", type = "number", unit = "mm; N",
    text = "Offset of the depths of a profile [mm], or of the force of a loop [N]. If it is omitted, it is "
      .. "identified too." },
  { "fit{data.title}", type = "string", text = "Title of the data set in printed output and plots." },

  { "fitted", kind = "object", use = "f = fit{...}",
    text = "Result of a fit. f.value.k and f.error.k are the identified k and its standard error. print(f) shows "
      .. "all values with standard errors and intervals, correlations, the agreement of each data set, and notes; "
      .. "plot.fit(f) draws the result." },
  { "fitted.value", kind = "field",
    text = "Identified values by name, such as f.value.k; for a curve, the list of its values at the knots." },
  { "fitted.error", kind = "field",
    text = "Standard errors by name; infinite for a parameter that is at a bound or not determined by the data. If "
      .. "values change in steps from node to node, residuals above the given errors increase them." },
  { "fitted.low", kind = "field",
    text = "Lower ends of the confidence intervals of the parameters, by name. The intervals include twice the "
      .. "changes f.mesh, or twice their scatter if that is larger." },
  { "fitted.high", kind = "field", text = "Upper ends of the confidence intervals of the parameters, by name." },
  { "fitted.names", kind = "field", text = "Names of the parameters, in the order of f.values." },
  { "fitted.values", kind = "field", text = "Values of the parameters as a list, in the order of f.names." },
  { "fitted.errors", kind = "field", text = "Standard errors as a list, in the order of f.names." },
  { "fitted.margins", kind = "field", text = "Half widths of the confidence intervals as a list, in the order of "
    .. "f.names." },
  { "fitted.mesh", kind = "field",
    text = "Changes of the values if the elements (and a given jump) had half the size, by name, from one more "
      .. "run, several times as long as the others. nil without element sizes (3-D, springs, "
      .. "imported meshes) or if this run fails." },
  { "fitted.correlation", kind = "field",
    text = "Matrix of the correlations of the parameters, f.correlation[i][j]. The unknowns are first, then the "
      .. "identified offsets of the profiles." },
  { "fitted.covariance", kind = "field",
    text = "Matrix of the covariances of the parameters for the given errors, in the order of f.correlation." },
  { "fitted.confidence", kind = "field", text = "Confidence level of intervals and bands." },
  { "fitted.times", kind = "field",
    text = "Half width of a confidence interval, without the effect of the mesh, divided by the standard error: "
      .. "Student's factor, about 2." },
  { "fitted.chi2", kind = "field", text = "Sum of the squares of residual / error over all measured values." },
  { "fitted.freedom", kind = "field", text = "Degrees of freedom: number of measured values minus number of "
    .. "parameters." },
  { "fitted.reduced", kind = "field",
    text = "chi2 divided by the degrees of freedom; about 1 if the errors and the model are correct." },
  { "fitted.told", kind = "field", text = "True if standard errors were given with the data." },
  { "fitted.data", kind = "field",
    text = "A list with a table for each data set. It has the lists value, error, model, low and high (confidence "
      .. "band of the model), residual (divided by the error), and x or distance; for a loop of a run driven by a "
      .. 'force, x is the force. kind is "profile", "loop" or "series". place has the offsets shift, tilt and '
      .. "level, each with value, error and unit." },
  { "fitted.curve", kind = "field",
    text = "Curves of the unknowns with knots, as tables { distance=, value= } for wear{ k= } and wear{ alpha= }." },
  { "fitted.band", kind = "field",
    text = "Confidence intervals of the unknowns with knots, as tables with the ends low and high." },
  { "fitted.notes", kind = "field", text = "Remarks on the result, as a list of texts." },
  { "fitted.iterations", kind = "field", text = "Number of iterations of the fit." },
  { "fitted.runs", kind = "field", text = "Number of runs that the fit made, without the runs read from a file." },
  { "fitted.noise", kind = "field",
    text = "Numerical noise of the runs, relative to the change of their results over the range of the "
      .. "unknowns." },
  { "fitted.smooth", kind = "field", text = "Weight of the smoothing of curves, see fit{unknown.smooth}." },
  { "fitted.wear", kind = "field", class = "wear",
    text = "Run with the identified values, up to the last measurement. It can be continued: f.wear:run{ "
      .. "distance=5000 }." },

  { "fit.design", kind = "function", class = "design",
    use = "d = fit.design{ unknown={ k=1e-8 }, measure={...} }",
    text = "Plans a test: predicts the standard errors that measurements would have, from derivatives at the "
      .. "start values. Errors are computed for each measurement alone, for the measurements added in the "
      .. "best order, and for all together. The errors of a single measurement include the prior knowledge: "
      .. "the start value, or the interval between the bounds. Widths and pressures jump from node to node; "
      .. "their derivatives are slopes over +-60 % of the start value. Prints a table; plot.fit(d) draws "
      .. "it." },
  { "fit.design{unknown}", type = "table of tables", text = "Parameters to identify, see fit{unknown}." },
  { "fit.design{base}", type = "table", takes = "wear",
    text = "Fields of wear{} that all runs have in common, see fit{base}." },
  { "fit.design{model}", type = "model object or table", takes = "model", text = "The two bodies, see wear{model}." },
  { "fit.design{file}", type = "string", text = "Run file of the runs, see fit{file}." },
  { "fit.design{workers}", type = "whole number",
    text = "If a file is set: number of runs at the same time, see study.run{workers}." },
  { "fit.design{progress}", type = 'function, false or "lines"',
    text = "Display of the progress, see fit{progress}." },
  { "fit.design{confidence}", type = "number", text = "Confidence level of intervals, see fit{confidence}. "
    .. "It does not affect standard errors." },
  { "fit.design{best}", type = "whole number", default = 3,
    text = "Number of measurements in the ranking of the best measurements." },
  { "fit.design{measure}", type = "list of tables",
    text = "Measurements that are possible in the test. Each is a table with of= or profile=, distance=, and "
      .. "error= or relative=." },
  { "fit.design{measure.of}", type = "string", text = "Quantity to measure, see fit{data.of}." },
  { "fit.design{measure.profile}", values = { "cylinder", "plate" }, text = "Body whose profile would be measured." },
  { "fit.design{measure.distance}", type = "number or list of numbers", unit = "mm",
    text = "Travelled distance of the measurement; each item of a list is a measurement." },
  { "fit.design{measure.section}", type = "table { z= } or { x= }", unit = "mm",
    text = "In 3-D: position of the section, see fit{data.section}." },
  { "fit.design{measure.error}", type = "number",
    text = "Standard error of a value, in the unit of the value; for a profile in mm." },
  { "fit.design{measure.relative}", type = "number", text = "Relative standard error of a value, instead of error." },
  { "fit.design{measure.x}", type = "list of numbers", unit = "mm",
    text = "Positions of the points of the profile." },
  { "fit.design{measure.points}", type = "whole number", default = 61,
    text = "Number of equally spaced points of the profile, instead of x." },
  { "fit.design{measure.width}", type = "number", unit = "mm", default = 1,
    text = "Width over which the profile is measured, with the centre of the contact in the middle." },
  { "fit.design{measure.shift}", type = "number", unit = "mm",
    text = "Known offset of the profile along x, see fit{data.shift}." },
  { "fit.design{measure.tilt}", type = "number", unit = "mm/mm",
    text = "Known tilt of the profile, see fit{data.tilt}." },
  { "fit.design{measure.level}", type = "number", unit = "mm",
    text = "Known offset of the depths of the profile, see fit{data.level}." },
  { "fit.design{measure.title}", type = "string", text = "Title of the measurement in printed output and plots." },
  { "design", kind = "object", use = "d = fit.design{...}",
    text = "Result of fit.design: the expected standard errors of the parameters." },
  { "design.names", kind = "field", text = "Names of the parameters." },
  { "design.units", kind = "field", text = "Units of the parameters." },
  { "design.start", kind = "field", text = "Start values of the parameters, by name." },
  { "design.prior_error", kind = "field",
    text = "Standard errors of the parameters due to the prior knowledge alone, by name." },
  { "design.alone", kind = "field",
    text = "Standard errors of the parameters from a single measurement, a list with one item { title=, distance=, "
      .. "measure=, error={ k=, alpha= } } for each measurement." },
  { "design.best", kind = "field",
    text = "List of the measurements in the best order. Each item has the standard errors, by name, from this "
      .. "measurement and all measurements before it." },
  { "design.all", kind = "field",
    text = "Standard errors of the parameters from all measurements together, by name." },
  { "design.correlation", kind = "field", text = "Correlations of the parameters from all measurements together." },
  { "design.runs", kind = "field", text = "Number of runs that fit.design made." },
  { "design.table", kind = "method", use = 'd:table{ file="design.csv" }',
    text = "Returns the standard errors from each measurement alone as CSV text." },
  { "design.table{file}", type = "string",
    text = "File to write; the call then returns its name instead of the table." },
}

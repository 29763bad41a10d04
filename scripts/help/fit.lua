-- Help entries of fits and of designs of tests. help/engine.lua explains the form of an entry.

return {
  { "fit", kind = "function", class = "fitted",
    use = 'fit{ unknown={ k=1e-8 }, data={{ of="depth_plate", cycle={}, value={} }} }',
    text = "Identifies parameters of wear{} and model{} from measured depths, volumes, profiles or loops, with "
      .. "standard errors: print(f), f.value.k, f.low.k and f.high.k (95 % interval). k and alpha together need "
      .. "data of both bodies. calibrate{} is simpler for volumes of repeated tests. The method is weighted "
      .. "nonlinear least squares (Levenberg and Marquardt) of (model - data) / error. Derivatives are finite "
      .. "differences between runs, with steps chosen from the noise of the runs. Data of several kinds need "
      .. "standard errors; with one kind they can be omitted and are then estimated from the residuals. Standard "
      .. "errors, correlations and bands are linearised at the result. fit{} refuses too few data, implausible "
      .. "units and an unknown without effect. A fit that does not converge raises an error with the last values; "
      .. "better start values, bounds (low, high) or fewer unknowns can help." },
  { "fit.best", type = "table { value=, chi2=, runs= }",
    text = "After Ctrl-C: the best values of the interrupted fit, by name." },
  { "fit{unknown}", type = "table of tables",
    text = "Parameters to identify, by name: numbers of wear{}, of a model and of its bodies, such as k, "
      .. '["model.radius"], ["lower.E"] or ["lower.layer1.thickness"] (the names of study{ vary= }). A '
      .. "number is the start value." },
  { "fit{data}", type = "list of tables",
    text = "Measurements, each a profile { profile= or x=, h=, body=, distance= }, values of the history { of=, "
      .. "distance=, value= }, or a friction loop { loop={ x=, tangential= }, cycle= or distance= }." },
  { "fit{base}", type = "table", takes = "wear",
    text = "Fields of wear{} that all runs have in common. The distance is extended to the last measurement." },
  { "fit{model}", type = "model object or table", takes = "model", text = "The two bodies, see wear{model}." },
  { "fit{file}", type = "string",
    text = "Run file. If it is given, worker processes make the runs, results are stored, and an interrupted fit "
      .. "continues. Otherwise all runs are made in this process." },
  { "fit{workers}", type = "whole number", text = "With a file: number of runs at the same time, see "
    .. "study.run{workers}." },
  { "fit{progress}", type = 'function, false or "lines"',
    text = "With a file: see study.run{progress}. Without a file: a function called with the number of runs "
      .. "and the trial values." },
  { "fit{confidence}", type = "number", default = 0.95, text = "Confidence level of intervals and bands." },
  { "fit{unknown.start}", type = "number or list of numbers",
    text = "Start value, inside the bounds. With knots: one value for all knots, or a list." },
  { "fit{unknown.low}", type = "number", text = "Lower bound; default: the lower limit of the field." },
  { "fit{unknown.high}", type = "number", text = "Upper bound; default: the upper limit of the field." },
  { "fit{unknown.knots}", type = "list of increasing numbers", unit = "mm",
    text = "Makes k or alpha a curve over the distance, with an unknown value at each of these distances. Between "
      .. "them the curve is a monotone cubic, beyond the ends it is constant." },
  { "fit{unknown.smooth}", type = 'number >= 0 or "auto"', default = 0,
    text = "Weight of a term that smooths the curves: the squared second differences at the knots, relative to the "
      .. 'plausible range of the field. All curves have the same weight; "auto" chooses it by cross-validation. '
      .. "Standard errors treat it as exact." },
  { "fit{data.profile}", type = "profile or table { x=, h=, error= }", unit = "mm",
    text = "A measured surface: wear depth h at x; error is its standard error." },
  { "fit{data.x}", type = "list of numbers", unit = "mm",
    text = "Positions of the measured depths h, from the centre. Give x and h, or profile." },
  { "fit{data.h}", type = "list of numbers", unit = "mm", text = "Measured wear depths at the positions data.x." },
  { "fit{data.body}", values = { "cylinder", "plate" }, text = "Body of the profile." },
  { "fit{data.section}", type = "table { z= } or { x= }", unit = "mm",
    text = "In 3-D: position of the measured section, along the motion at this z or across it at this x. Default: "
      .. "along the motion at z = 0." },
  { "fit{data.distance}", type = "number or list of numbers", unit = "mm",
    text = "Travelled distance of a profile, a loop, or each value." },
  { "fit{data.cycle}", type = "number or list of numbers", unit = "cycles",
    text = "Number of cycles, instead of distance. It is converted to a distance with the motion at the start "
      .. "values." },
  { "fit{data.map}", type = "table { theta=, phi=, values= }", unit = "degree, mm",
    text = "Measured depths of a joint's head or cup (body) in directions theta and phi, where phi varies fastest, "
      .. 'as returned by w:map "cup".' },
  { "fit{data.loop}", type = "table of lists", unit = "mm and N",
    text = "Motion x and tangential force of one cycle in order of time, as returned by w:loop(); for runs with "
      .. "friction. It identifies the coefficient of friction. Each half cycle is compared with the same half "
      .. "cycle of the run: forces at the measured positions or, if a force drives the run (tangential=), "
      .. "positions at the measured forces. error is in N for forces, in mm for positions." },
  { "fit{data.compliance}", type = "number", unit = "mm/N", default = 0,
    text = "For a loop: compliance of the test rig, displacement per force, which the measured motion includes." },
  { "fit{data.of}", type = "string",
    text = 'Measured quantity: a column of the history, such as "volume_plate" or "depth_cylinder", or '
      .. '"volume" (of both bodies) or "width" (of the contact).' },
  { "fit{data.value}", type = "number or list of numbers", text = "Measured values, in the unit of the column." },
  { "fit{data.error}", type = "number or list of numbers", text = "Standard error, in the unit of the values." },
  { "fit{data.relative}", type = "number", text = "Relative standard error, instead of error." },
  { "fit{data.shift}", type = "number", unit = "mm",
    text = "Offset of the profile or loop along x. If omitted, it is identified too." },
  { "fit{data.tilt}", type = "number", unit = "mm/mm",
    text = "Tilt of the profile, positive if h increases with x. If omitted, it is identified too." },
  { "fit{data.level}", type = "number", unit = "mm; N",
    text = "Offset of the depths of a profile, or of the force of a loop. If omitted, it is identified too." },
  { "fit{data.title}", type = "string", text = "Title in printed output and plots." },

  { "fitted", kind = "object", use = "f = fit{...}",
    text = "Result of a fit. f.value.k and f.error.k are the identified k and its standard error. print "
      .. "shows all values with standard errors and intervals, correlations, the agreement of each data "
      .. "set, and notes; plot.fit(f) draws it." },
  { "fitted.value", kind = "field",
    text = "Identified values by name, such as f.value.k; for a curve, the list of its values at the knots." },
  { "fitted.error", kind = "field",
    text = "Standard errors by name; infinite for a parameter that is at a bound or not determined by the data." },
  { "fitted.low", kind = "field", text = "Lower ends of the confidence intervals." },
  { "fitted.high", kind = "field", text = "Upper ends of the confidence intervals." },
  { "fitted.names", kind = "field", text = "Names of the parameters, in the order of f.values." },
  { "fitted.values", kind = "field", text = "Values of the parameters as a list, in the order of f.names." },
  { "fitted.errors", kind = "field", text = "Standard errors as a list, in the order of f.names." },
  { "fitted.correlation", kind = "field",
    text = "Correlations f.correlation[i][j] of the parameters; the offsets of profiles follow the unknowns." },
  { "fitted.covariance", kind = "field", text = "Covariances of the parameters for the given errors, in the order "
    .. "of f.correlation." },
  { "fitted.confidence", kind = "field", text = "Confidence level of intervals and bands." },
  { "fitted.times", kind = "field", text = "Student's factor, about 2: half width of a confidence interval divided by the standard error." },
  { "fitted.chi2", kind = "field", text = "Sum of the squares of residual / error." },
  { "fitted.freedom", kind = "field", text = "Degrees of freedom: number of measured values minus number of "
    .. "parameters." },
  { "fitted.reduced", kind = "field", text = "chi2 / freedom, about 1 if the errors and the model are correct." },
  { "fitted.told", kind = "field", text = "True if standard errors were given with the data." },
  { "fitted.data", kind = "field",
    text = "A table for each data set. It has the lists value, error, model, low and high (confidence band of the "
      .. "model), residual (divided by the error), and x or distance; for a loop of a run driven by a force, x is "
      .. "the force. kind is profile, loop or series. place has shift, tilt and level, each with value, error and "
      .. "unit." },
  { "fitted.curve", kind = "field",
    text = "Unknowns with knots, as tables { distance=, value= } that wear{ k= } and wear{ alpha= } accept." },
  { "fitted.band", kind = "field", text = "Unknowns with knots, as tables with the ends low and high of "
    .. "their confidence intervals." },
  { "fitted.notes", kind = "field", text = "Remarks on the result, as a list of texts." },
  { "fitted.iterations", kind = "field", text = "Number of iterations." },
  { "fitted.runs", kind = "field", text = "Number of runs made; runs read from a file are not counted." },
  { "fitted.noise", kind = "field",
    text = "Noise of the runs, relative to the effect of the unknowns over their range." },
  { "fitted.smooth", kind = "field", text = "Weight of the smoothing of curves, see fit{unknown.smooth}." },
  { "fitted.wear", kind = "field", class = "wear",
    text = "The run with the identified values, at the last measurement, which can be continued: f.wear:run{ "
      .. "distance=5000 }." },

  { "fit.design", kind = "function", class = "design",
    use = "d = fit.design{ unknown={ k=1e-8 }, measure={...} }",
    text = "Plans a test: predicts the standard errors that measurements would give, from derivatives at the start "
      .. "values. Errors are given for each measurement alone, for the measurements added in the best order, and "
      .. "for all together. For a single measurement, the prior knowledge is included: the start value, or the "
      .. "interval between the bounds. Widths and pressures jump from node to node; their derivatives are slopes "
      .. "over +-0.6 times the start value. Prints a table; plot.fit(d) draws it." },
  { "fit.design{unknown}", type = "table of tables", text = "Parameters to identify, see fit{unknown}." },
  { "fit.design{base}", type = "table", takes = "wear",
    text = "Fields of wear{} that all runs have in common, see fit{base}." },
  { "fit.design{model}", type = "model object or table", takes = "model", text = "The two bodies, see wear{model}." },
  { "fit.design{file}", type = "string", text = "Run file of the runs, see fit{file}." },
  { "fit.design{workers}", type = "whole number",
    text = "With a file: number of runs at the same time, see study.run{workers}." },
  { "fit.design{progress}", type = 'function, false or "lines"',
    text = "Display of the progress, see fit{progress}." },
  { "fit.design{confidence}", type = "number", text = "Confidence level of intervals, see fit{confidence}. "
    .. "It does not affect standard errors." },
  { "fit.design{best}", type = "whole number", default = 3, text = "Number of measurements to rank." },
  { "fit.design{measure}", type = "list of tables",
    text = "Possible measurements: of= or profile=, distance=, error= or relative=." },
  { "fit.design{measure.of}", type = "string", text = "Quantity to measure, see fit{data.of}." },
  { "fit.design{measure.profile}", values = { "cylinder", "plate" }, text = "Body of a measured profile." },
  { "fit.design{measure.distance}", type = "number or list of numbers", unit = "mm",
    text = "Distance of the measurement; each item of a list is a measurement." },
  { "fit.design{measure.section}", type = "table { z= } or { x= }", unit = "mm",
    text = "In 3-D: position of the section." },
  { "fit.design{measure.error}", type = "number", text = "Standard error of a value, in its unit; for a profile in "
    .. "mm." },
  { "fit.design{measure.relative}", type = "number", text = "Relative standard error, instead of error." },
  { "fit.design{measure.x}", type = "list of numbers", unit = "mm",
    text = "Positions of the points of the profile." },
  { "fit.design{measure.points}", type = "whole number", default = 61, text = "Number of points, instead of x." },
  { "fit.design{measure.width}", type = "number", unit = "mm", default = 1,
    text = "Width of the measured profile around the centre." },
  { "fit.design{measure.shift}", type = "number", unit = "mm",
    text = "Offset of the profile along x, see fit{data.shift}." },
  { "fit.design{measure.tilt}", type = "number", unit = "mm/mm", text = "Tilt of the profile, see fit{data.tilt}." },
  { "fit.design{measure.level}", type = "number", unit = "mm", text = "Offset of the depths, see fit{data.level}." },
  { "fit.design{measure.title}", type = "string", text = "Title in printed output and plots." },
  { "design", kind = "object", use = "d = fit.design{...}",
    text = "Result of fit.design: expected standard errors." },
  { "design.names", kind = "field", text = "Names of the parameters." },
  { "design.units", kind = "field", text = "Units of the parameters." },
  { "design.start", kind = "field", text = "Start values by name." },
  { "design.prior_error", kind = "field", text = "Standard errors of the prior knowledge, by name." },
  { "design.alone", kind = "field",
    text = "Standard errors with a single measurement: a list with an item { title=, distance=, measure=, error={ "
      .. "k=, alpha= } } per measurement." },
  { "design.best", kind = "field", text = "The measurements in the best order; each item has the errors by "
    .. "name with all measurements up to it." },
  { "design.all", kind = "field", text = "Standard errors by name with all measurements." },
  { "design.correlation", kind = "field", text = "Correlations with all measurements." },
  { "design.runs", kind = "field", text = "Number of runs." },
  { "design.table", kind = "method", use = 'd:table{ file="design.csv" }',
    text = "The errors of each measurement alone as CSV." },
  { "design.table{file}", type = "string",
    text = "File to write; the call then returns its name instead of the table." },
}

-- Help entries of fits and designs of tests. Form: help.lua.

return {
  { "fit", kind = "function", class = "fitted",
    use = "f = fit{ unknown={ k=1e-8, alpha={ start=0.5 } }, data={...} }",
    text = "Values of wear{} and model{} from what was measured, and how sure they are: weighted nonlinear "
      .. "least squares (Levenberg and Marquardt), sum of ((model - data) / error)^2 least. Derivatives are "
      .. "differences of runs, with steps by how noisy runs are. Data of several kinds need their errors; of "
      .. "one kind without errors, equal ones are taken from the residuals. Standard errors, correlations and "
      .. "bands are those of the problem made linear at the result. Errors: too few data, numbers in units "
      .. "that cannot be, an unknown that does nothing, no convergence (NOT_CONVERGED)." },
  { "fit.best", type = "table { value=, chi2=, runs= }",
    text = "Of the last search the best values so far, by name; empty before any. What is left of a fit that Ctrl-C ended." },
  { "fit{unknown}", type = "table of tables",
    text = "What is looked for, by name: numbers of wear{}, or of a model and its bodies as "
      .. "[\"model.radius\"], [\"lower.E\"], [\"lower.layer1.thickness\"], by the names that vary of study{} "
      .. "takes. A number is the start alone." },
  { "fit{data}", type = "list of tables",
    text = "What was measured, each a profile { profile= or x=, h=, body=, distance= }, numbers of the history "
      .. "{ of=, distance=, value= }, or a friction loop { loop={ x=, tangential= }, cycle= or distance= }." },
  { "fit{base}", type = "table", takes = "wear",
    text = "Fields of wear{} of all runs; its distance grows to the last measurement." },
  { "fit{model}", type = "model object or table", takes = "model", text = "The bodies, as in wear{}." },
  { "fit{file}", type = "string",
    text = "Run file: then the runs are those of workers, are kept, and the same fit goes on there where it was "
      .. "interrupted. Without one all runs are made in this process." },
  { "fit{workers}", type = "whole number", text = "With a file: as in study.run." },
  { "fit{progress}", type = 'function, false or "lines"', text = "With a file: as in study.run; without one a "
      .. "function gets the number of runs and the values tried." },
  { "fit{confidence}", type = "number", default = 0.95, text = "Probability of ranges and bands." },
  { "fit{unknown.start}", type = "number or list of numbers",
    text = "Where the search begins, inside the bounds; with knots one for all, or one each." },
  { "fit{unknown.low}", type = "number", text = "Lower bound; without it that of the field." },
  { "fit{unknown.high}", type = "number", text = "Upper bound; without it that of the field." },
  { "fit{unknown.knots}", type = "list of growing numbers", unit = "mm",
    text = "k or alpha as a curve over the distance: its values there are looked for; in between it is a cubic "
      .. "that is monotonic where they are, outside constant." },
  { "fit{unknown.smooth}", type = 'number >= 0 or "auto"', default = 0,
    text = "Weight of the second differences of the knots, over what the field can reasonably change by, in the "
      .. "sum of squares, one for all curves; \"auto\": the one that predicts values left out best "
      .. "(cross-validation). Smoothness is then taken as known by the standard errors." },
  { "fit{data.profile}", type = "profile or table { x=, h=, error= }", unit = "mm",
    text = "A measured surface: wear depth h at x, of which error is the standard error." },
  { "fit{data.x}", type = "list of numbers", unit = "mm", text = "Instead of profile: places from the centre." },
  { "fit{data.h}", type = "list of numbers", unit = "mm", text = "The wear depths there." },
  { "fit{data.body}", values = { "cylinder", "plate" }, text = "Whose profile it is." },
  { "fit{data.section}", type = "table { z= } or { x= }", unit = "mm",
    text = "In three dimensions: the section the profile is of, along the motion at this z or across it at this x; without one "
      .. "along the motion through the middle." },
  { "fit{data.distance}", type = "number or list of numbers", unit = "mm",
    text = "Travelled distance of a profile, of a loop, or of each value." },
  { "fit{data.cycle}", type = "number or list of numbers", unit = "cycles",
    text = "Instead: after how many cycles, of the motion that the search starts with." },
  { "fit{data.loop}", type = "table of lists", unit = "mm and N",
    text = "Motion x and tangential force of one cycle in the order of time, as w:loop() has them; runs with "
      .. "friction only, of which the loop tells the coefficient. Each half of it, to and fro, is held against "
      .. "the same half of the run's: the forces at the places measured, or, where a force drives the runs "
      .. "(tangential=), the places at the forces. error is in N, or then in mm." },
  { "fit{data.compliance}", type = "number", unit = "mm/N", default = 0,
    text = "Of the rig, for a loop: what the motion measured has too much for each N of force." },
  { "fit{data.of}", type = "string",
    text = 'A column of the history, as "volume_plate", "depth_cylinder"; or "volume", of both, or "width".' },
  { "fit{data.value}", type = "number or list of numbers", text = "Its values, in the unit of the column." },
  { "fit{data.error}", type = "number or list of numbers", text = "Standard error, in the unit of the values." },
  { "fit{data.relative}", type = "number", text = "Instead: the standard error as a share of each value." },
  { "fit{data.shift}", type = "number", unit = "mm",
    text = "How far the profile lies to the right of the surface, or x of a loop; without a number it is fitted "
      .. "along." },
  { "fit{data.tilt}", type = "number", unit = "mm/mm",
    text = "How much steeper it lies (h grows with x); without a number fitted along." },
  { "fit{data.level}", type = "number", unit = "mm; N",
    text = "How much deeper it lies, or by how much the force of a loop is off; without a number fitted along." },
  { "fit{data.title}", type = "string", text = "Its name when shown." },

  { "fitted", kind = "object", use = "f = fit{...}",
    text = "What a fit has found. Prints values with standard errors and ranges, correlations, how each set of "
      .. "data fits, and what must be said of it; plot.fit(f) draws it." },
  { "fitted.value", kind = "field", text = "The values found by name, f.value.k; of curves the list at the knots." },
  { "fitted.error", kind = "field",
    text = "Standard errors, likewise; infinite at a bound, and where the data cannot tell." },
  { "fitted.low", kind = "field", text = "Lower ends of the ranges." },
  { "fitted.high", kind = "field", text = "Upper ends of the ranges." },
  { "fitted.names", kind = "field", text = "Names of the parameters, in the order of values." },
  { "fitted.values", kind = "field", text = "Values of the parameters in a list." },
  { "fitted.errors", kind = "field", text = "Standard errors in a list." },
  { "fitted.correlation", kind = "field",
    text = "Correlations, f.correlation[i][j]; positions of profiles stand behind the unknowns." },
  { "fitted.covariance", kind = "field", text = "Covariances with the errors as given, likewise." },
  { "fitted.confidence", kind = "field", text = "Probability of ranges and bands." },
  { "fitted.times", kind = "field", text = "Half a range over the standard error." },
  { "fitted.chi2", kind = "field", text = "Sum of squares of residuals over errors." },
  { "fitted.freedom", kind = "field", text = "Values less parameters." },
  { "fitted.reduced", kind = "field", text = "chi2 over freedom: about 1 where errors and model are right." },
  { "fitted.told", kind = "field", text = "Whether the data came with their errors." },
  { "fitted.data", kind = "field",
    text = "For each set of data the lists value, error, model, low, high (band of the model), residual (over the "
      .. "error), x (of loops the force, where one drives) or distance, kind (profile, loop, series), and "
      .. "place: shift, tilt and level with value, error, unit." },
  { "fitted.curve", kind = "field",
    text = "Unknowns with knots as { distance=, value= }, which wear{} takes as k or alpha." },
  { "fitted.band", kind = "field", text = "The same with the ends of their ranges, low and high." },
  { "fitted.notes", kind = "field", text = "What must be said of the result: a list of texts." },
  { "fitted.iterations", kind = "field", text = "Iterations of the search." },
  { "fitted.runs", kind = "field", text = "Runs made for it, those found in a file not counted." },
  { "fitted.noise", kind = "field", text = "Noise of the runs over what a change of the unknowns by their span does." },
  { "fitted.smooth", kind = "field", text = "Weight of the smoothness of curves." },
  { "fitted.wear", kind = "field", class = "wear", text = "The run with these values, at the last measurement; it "
      .. "goes on: f.wear:run{ distance=5000 }." },

  { "fit.design", kind = "function", class = "design",
    use = "d = fit.design{ unknown={ k=1e-8 }, measure={...} }",
    text = "Before a test is made: the standard errors that measurements would leave, from derivatives at the "
      .. "start. Each alone, beside what is known before (the start itself, or the room between both bounds), the "
      .. "one to begin with and those to add, and all together. Of widths and pressures, which move from node to "
      .. "node, slopes over 0.6 of a start to both sides. Prints a table; plot.fit(d) "
      .. "draws it." },
  { "fit.design{unknown}", type = "table of tables", text = "As in fit." },
  { "fit.design{base}", type = "table", takes = "wear", text = "As in fit." },
  { "fit.design{model}", type = "model object or table", takes = "model", text = "As in fit." },
  { "fit.design{file}", type = "string", text = "As in fit." },
  { "fit.design{workers}", type = "whole number", text = "As in fit." },
  { "fit.design{progress}", type = 'function, false or "lines"', text = "As in fit." },
  { "fit.design{confidence}", type = "number", text = "As in fit; standard errors do not depend on it." },
  { "fit.design{best}", type = "whole number", default = 3, text = "How many measurements are put in order." },
  { "fit.design{measure}", type = "list of tables",
    text = "What could be measured: of= or profile=, distance=, error= or relative=." },
  { "fit.design{measure.of}", type = "string", text = "As in data of fit." },
  { "fit.design{measure.profile}", values = { "cylinder", "plate" }, text = "A profile of this body." },
  { "fit.design{measure.distance}", type = "number or list of numbers", unit = "mm",
    text = "When: each distance is a measurement of its own." },
  { "fit.design{measure.section}", type = "table { z= } or { x= }", unit = "mm", text = "In three dimensions: its section." },
  { "fit.design{measure.error}", type = "number", text = "Standard error of a value, of a profile in mm." },
  { "fit.design{measure.relative}", type = "number", text = "Instead, as a share of the value." },
  { "fit.design{measure.x}", type = "list of numbers", unit = "mm", text = "Places of the profile." },
  { "fit.design{measure.points}", type = "whole number", default = 61, text = "Instead: how many." },
  { "fit.design{measure.width}", type = "number", unit = "mm", default = 1,
    text = "Over what width around the centre." },
  { "fit.design{measure.shift}", type = "number", unit = "mm", text = "As in data of fit." },
  { "fit.design{measure.tilt}", type = "number", unit = "mm/mm", text = "As in data of fit." },
  { "fit.design{measure.level}", type = "number", unit = "mm", text = "As in data of fit." },
  { "fit.design{measure.title}", type = "string", text = "Its name when shown." },
  { "design", kind = "object", use = "d = fit.design{...}", text = "What measurements would tell." },
  { "design.names", kind = "field", text = "Names of the parameters." },
  { "design.units", kind = "field", text = "Their units." },
  { "design.start", kind = "field", text = "Their values by name." },
  { "design.prior_error", kind = "field", text = "What is known of each before, by name." },
  { "design.alone", kind = "field",
    text = "A list of { title=, distance=, measure=, error={ k=, alpha= } }, one a measurement." },
  { "design.best", kind = "field", text = "The same in the order to measure in, errors with all before." },
  { "design.all", kind = "field", text = "Errors by name with all of them." },
  { "design.correlation", kind = "field", text = "Correlations with all of them." },
  { "design.runs", kind = "field", text = "Runs made for it." },
  { "design.table", kind = "method", use = 'd:table{ file="design.csv" }', text = "The errors of each alone as CSV." },
  { "design.table{file}", type = "string", text = "File to write it to; its name is returned then, not the table." },
}

-- Help entries of uncertainties: samples of studies, results of samples, and sensitivities of runs.
-- help/engine.lua explains the form of an entry.

local columns = require "archard.uncertainty.outcomes".columns

return {
  -- --- samples of a study -----------------------------------------------------------------------
  { "study{sample}", type = "table of distributions", takes = "wear",
    text = "Uncertain fields of wear{} instead of vary: sample={ k=lognormal{ mean=1e-8, variation=0.4 }, "
      .. "alpha=uniform{ 0.3, 0.7 }, load=normal{ 100, 5 } }, with the names of vary; each field is one number. "
      .. 'correlated={ {"k", "alpha", -0.5}, ... } sets correlations of the normal scores; the distributions do '
      .. "not change. The smallest and largest value of every field are tried first; a field is refused if the run "
      .. "fails with them or does not depend on it." },
  { "study{n}", type = "whole number >= 2", default = 1024,
    text = "Number of samples n; with indices=true the study has n times (number of fields + 2) cases. Use a power "
      .. "of 2 for Sobol's sequence." },
  { "study{design}", values = { "sobol", "latin", "random" }, default = '"sobol"',
    text = "Design of the samples: Sobol's sequence with random digital shift (at most 40 fields, 20 with indices), "
      .. "Latin hypercube, or random." },
  { "study{seed}", type = "whole number >= 1", default = 1,
    text = "Seed of the random numbers. The same seed gives the same cases, bit by bit, for any number of workers "
      .. "and shares." },
  { "study{indices}", type = "boolean", default = false,
    text = "Adds the cases from which Sobol's indices, shares of the variance, are computed (Saltelli's design). "
      .. "Not for correlated fields." },

  -- --- distributions ----------------------------------------------------------------------------
  { "uniform", kind = "function", class = "distribution", use = "uniform{ low=0.3, high=0.7 }",
    text = "Uniform distribution between two values; short form uniform{ 0.3, 0.7 }." },
  { "uniform{low}", type = "number", text = "Lower end, in the unit of the field." },
  { "uniform{high}", type = "number", text = "Upper end." },
  { "normal", kind = "function", class = "distribution", use = "normal{ mean=100, deviation=5 }",
    text = "Normal distribution; short form normal{ 100, 5 }." },
  { "normal{mean}", type = "number", text = "Mean, in the unit of the field (before truncation)." },
  { "normal{deviation}", type = "number > 0", text = "Standard deviation, in the unit of the field." },
  { "normal{variation}", type = "number > 0",
    text = "Coefficient of variation, deviation / mean, instead of deviation." },
  { "normal{low}", type = "number", text = "Lower limit of a truncated distribution." },
  { "normal{high}", type = "number", text = "Upper limit of a truncated distribution." },
  { "lognormal", kind = "function", class = "distribution",
    use = "lognormal{ mean=1e-8, variation=0.4 }",
    text = "Lognormal distribution, of a positive number such as a wear coefficient, for study{ sample={ "
      .. "k=lognormal{ mean=1e-8, variation=0.4 } } }. A scatter by a factor f, one standard deviation, is the "
      .. "variation sqrt(exp(log(f)^2) - 1): 0.79 for a factor of 2, 1.5 for 3." },
  { "lognormal{mean}", type = "number > 0", text = "Mean of the number itself, in the unit of the field." },
  { "lognormal{deviation}", type = "number > 0", text = "Standard deviation of the number itself, in the "
    .. "unit of the field." },
  { "lognormal{variation}", type = "number > 0",
    text = "Coefficient of variation, deviation / mean, instead of deviation." },
  { "lognormal{low}", type = "number", text = "Lower limit of a truncated distribution." },
  { "lognormal{high}", type = "number", text = "Upper limit of a truncated distribution." },
  { "distribution", kind = "object", use = "uniform{...}  normal{...}  lognormal{...}",
    text = "Distribution of an uncertain number, for study{ sample={...} }." },

  -- --- results of samples -----------------------------------------------------------------------
  { "study.uncertainty", kind = "method", class = "uncertainty",
    use = 's:uncertainty{ of={"depth_cylinder", "p_center"} }',
    text = "Statistics of a sampled study: mean, standard deviation and quantiles of results over the distance, the "
      .. "contribution of each field, and the convergence with the number of samples." },
  { "study.uncertainty{of}", type = "name or list of names", values = columns,
    default = '{ "depth_cylinder", "depth_plate", "p_center" }', text = "Columns of the history." },
  { "study.uncertainty{at}", type = "list of numbers > 0", unit = "mm",
    text = "Distances of the statistics; default: 50 distances up to the end of the shortest case. Results are "
      .. "interpolated between records by cubics." },
  { "study.uncertainty{quantiles}", type = "list of numbers in (0, 1)", default = "{ 0.05, 0.5, 0.95 }",
    text = "Probabilities of the quantiles." },
  { "study.uncertainty{confidence}", type = "number in (0, 1)", default = 0.95,
    text = "Confidence level of the intervals of the estimates." },
  { "study.failure", kind = "method", class = "failure",
    use = 's:failure{ of="depth_cylinder", above=3e-3, before=1000 }',
    text = "Probability that a result exceeds a limit, up to a distance or at any time, with its confidence interval "
      .. "(Clopper and Pearson)." },
  { "study.failure{of}", type = "string", values = columns, text = "A column of the history." },
  { "study.failure{above}", type = "number",
    text = "Upper limit of the result, in the unit of the column (depths in mm)." },
  { "study.failure{below}", type = "number", text = "Lower limit of the result." },
  { "study.failure{before}", type = "number > 0", unit = "mm",
    text = "Distance up to which the limit applies; default: the end of each case." },
  { "study.failure{confidence}", type = "number in (0, 1)", default = 0.95,
    text = "Confidence level of the interval." },
  { "failure", kind = "object", use = "s:failure{...}", text = "A probability of failure; print shows it." },
  { "failure.probability", kind = "field", text = "Fraction of the samples that exceeded the limit." },
  { "failure.low", kind = "field", text = "Lower end of the confidence interval." },
  { "failure.high", kind = "field", text = "Upper end of the confidence interval." },
  { "failure.count", kind = "field", text = "Number of samples that exceeded the limit." },
  { "failure.n", kind = "field", text = "Number of samples." },
  { "failure.failed", kind = "field", text = "Number of failed cases, which are excluded." },
  { "failure.course", kind = "field",
    text = "A list of { n=, probability= } for half of the samples and for all, to check convergence." },
  { "uncertainty", kind = "object", use = "u = s:uncertainty{...}",
    text = "Statistics of a sampled study, s = study{ sample={ k=lognormal{ mean=1e-8, variation=0.4 } }, n=256 "
      .. "}:run(), by the name of the result: u.depth_cylinder.mean[i] at the distance u.distance[i]. Each has "
      .. "mean, mean_error, deviation, quantiles (a list of { share=, value=, low=, high= }), rank (Spearman's "
      .. "correlation with every field at the last distance), convergence (these statistics for increasing numbers "
      .. "n of samples) and, with indices, first and total: by field { value=, error= }, the share of the variance "
      .. "caused by the field alone, and with its interactions. print shows it." },
  { "uncertainty.distance", kind = "field", unit = "mm", text = "Sliding distances at which the statistics are given." },
  { "uncertainty.of", kind = "field", text = "Names of the results, which are columns of the history." },
  { "uncertainty.fields", kind = "field", text = "Names of the uncertain fields." },
  { "uncertainty.n", kind = "field", text = "Number of samples." },
  { "uncertainty.failed", kind = "field", text = "Number of failed cases, which are excluded." },
  { "uncertainty.confidence", kind = "field", text = "Confidence level of the intervals." },
  { "uncertainty.design", kind = "field", text = "Design of the samples." },
  { "uncertainty.seed", kind = "field", text = "Seed of the random numbers." },
  { "uncertainty.indices", kind = "field", text = "True if Sobol's indices were computed." },

  -- --- sensitivities ----------------------------------------------------------------------------
  { "wear.sensitivity", kind = "method", class = "sensitivity",
    use = 'w:sensitivity{ of="depth_cylinder", to={"k", "alpha", "E"} }',
    text = "Derivatives and elasticities (percent per percent) of results with respect to numbers of the "
      .. "definition, over the whole history, each with its error. The run is repeated 16 times per number, with "
      .. "relative changes from 3 % to 4e-7, and the difference quotient that agrees best with the quotients of "
      .. "the neighbouring changes is used. For results that jump from node to node, such as half widths and "
      .. "pressures, the slope of a least-squares line through 17 runs over a wider range is used. Automatic steps "
      .. '(jump = "auto", tolerance) are frozen, then divided into 4 and 8 parts: the results are from 8 parts; '
      .. "the errors include the difference between 4 and 8 parts. With a given jump, the results apply to these "
      .. "steps, and the errors are those of the difference quotient alone." },
  { "wear.sensitivity{of}", type = "name or list of names", values = columns,
    default = '{ "depth_cylinder", "depth_plate", "p_center" }', text = "Columns of the history." },
  { "wear.sensitivity{to}", type = "name or list of names", default = '{ "k", "alpha", "load" }',
    text = 'Numbers of wear{} or model{} whose effect is computed, with the names of study{ vary= }: "cylinder.E", '
      .. '"lower.layer1.k"; "E" and "nu" change both bodies. If bodies have their own coefficients, these replace k and alpha by default.' },
  { "wear.sensitivity{over}", type = "a share of the number from 0 to 0.5", default = "0.24",
    text = "For results that jump: half the range of the slope as a fraction of the number (smaller near the "
      .. "limits of the number). 0: local derivatives, also for results that jump." },
  { "sensitivity", kind = "object", use = "s = w:sensitivity{...}",
    text = "s.depth_cylinder.k has derivative and error (in the unit of the result divided by the unit of the "
      .. "number), elasticity, elasticity_error, and over (half the range of a slope as a fraction of the number; "
      .. "0: a local derivative), each a list over s.distance. print shows the values at the end." },
  { "sensitivity.distance", kind = "field", unit = "mm", text = "Distances at the ends of the steps." },
  { "sensitivity.of", kind = "field", text = "Names of the results, which are columns of the history." },
  { "sensitivity.to", kind = "field", text = "Names of the varied numbers of wear{} or model{}." },
  { "sensitivity.runs", kind = "field", text = "Number of runs." },

  -- --- pictures ---------------------------------------------------------------------------------
  { "plot.bands", kind = "function", takes = "plot", use = 'plot.bands(s, { of="depth_cylinder" })',
    text = "Quantiles of a sampled study, or of the result of s:uncertainty{}, as bands over the distance, with "
      .. "the median as a line. Accepts the options of plot{}." },
  { "plot.bands{of}", type = "name or list of names", values = columns,
    text = "Columns of the history, a panel each." },
  { "plot.tornado", kind = "function", takes = "plot", use = 'plot.tornado(u, { of="depth_cylinder" })',
    text = "Importance of the numbers as bars: Sobol's indices of a sampled study or of s:uncertainty{}, rank "
      .. "correlations if there are no indices, elasticities of a sensitivity. Accepts the options of plot{}." },
  { "plot.tornado{of}", type = "string", values = columns, text = "The result; default: the first one." },
  { "plot.tornado{at}", type = "number > 0", unit = "mm",
    text = "Distance of the results; the nearest available distance is used. Default: the last distance. Rank "
      .. "correlations are those at the last distance." },
}

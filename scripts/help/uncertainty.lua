-- Help entries of uncertainties: samples of studies, results of samples, and sensitivities of runs.
-- help/engine.lua explains the form of an entry.

local columns = require "archard.uncertainty.outcomes".columns

return {
  -- --- samples of a study -----------------------------------------------------------------------
  { "study{sample}", type = "table of distributions", takes = "wear",
    text = "Uncertain fields of wear{} with their distributions, instead of vary: sample={ k=lognormal{ mean=1e-8, "
      .. "variation=0.4 }, alpha=uniform{ 0.3, 0.7 }, load=normal{ 100, 5 } }. The names are the same as in vary; "
      .. 'each field is one number. correlated={ {"k", "alpha", -0.5}, ... } sets correlations of the normal '
      .. "scores and does not change the distributions. Runs with the smallest and the largest value of every "
      .. "field are tried first; a field is refused if such a run fails or does not depend on the field." },
  { "study{n}", type = "whole number >= 2", default = 1024,
    text = "Number of samples n. With indices=true the study has n * (number of fields + 2) cases. Use a power of "
      .. "2 for Sobol's sequence." },
  { "study{design}", values = { "sobol", "latin", "random" }, default = '"sobol"',
    text = "Design of the samples: Sobol's sequence with random digital shift (at most 40 fields, 20 with indices), "
      .. "Latin hypercube, or random." },
  { "study{seed}", type = "whole number >= 1", default = 1,
    text = "Seed of the random numbers. The same seed results in the same cases, to the last bit, for any number "
      .. "of workers and shares." },
  { "study{indices}", type = "boolean", default = false,
    text = "If true, the study has more cases, from which Sobol's indices (shares of the variance) are computed by "
      .. "Saltelli's design. Not available for correlated fields." },

  -- --- distributions ----------------------------------------------------------------------------
  { "uniform", kind = "function", class = "distribution", use = "uniform{ low=0.3, high=0.7 }",
    text = "Uniform distribution between two values; short form uniform{ 0.3, 0.7 }." },
  { "uniform{low}", type = "number", text = "Lower end, in the unit of the field." },
  { "uniform{high}", type = "number", text = "Upper end." },
  { "normal", kind = "function", class = "distribution", use = "normal{ mean=100, deviation=5 }",
    text = "Normal distribution; short form normal{ 100, 5 }." },
  { "normal{mean}", type = "number", text = "Mean of the distribution before truncation, in the unit of the field." },
  { "normal{deviation}", type = "number > 0", text = "Standard deviation, in the unit of the field." },
  { "normal{variation}", type = "number > 0",
    text = "Coefficient of variation, deviation / mean, instead of deviation." },
  { "normal{low}", type = "number", text = "Lower limit of a truncated distribution." },
  { "normal{high}", type = "number", text = "Upper limit of a truncated distribution." },
  { "lognormal", kind = "function", class = "distribution",
    use = "lognormal{ mean=1e-8, variation=0.4 }",
    text = "Lognormal distribution of a positive number such as a wear coefficient, for study{ sample={ "
      .. "k=lognormal{ mean=1e-8, variation=0.4 } } }. If one standard deviation is a scatter by a factor f, the "
      .. "variation is sqrt(exp(log(f)^2) - 1): 0.79 for a factor of 2, 1.5 for 3." },
  { "lognormal{mean}", type = "number > 0",
    text = "Mean of the values (not of their logarithms) before truncation, in the unit of the field." },
  { "lognormal{deviation}", type = "number > 0",
    text = "Standard deviation of the values (not of their logarithms) before truncation, in the unit of the field." },
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
    default = '{ "depth_cylinder", "depth_plate", "p_center" }',
    text = "Results whose statistics are computed, columns of the history." },
  { "study.uncertainty{at}", type = "list of numbers > 0", unit = "mm",
    text = "Distances at which the statistics are computed. Default: 50 distances up to the end of the shortest "
      .. "case. Results are interpolated between records by cubic polynomials." },
  { "study.uncertainty{quantiles}", type = "list of numbers in (0, 1)", default = "{ 0.05, 0.5, 0.95 }",
    text = "Probabilities of the quantiles." },
  { "study.uncertainty{confidence}", type = "number in (0, 1)", default = 0.95,
    text = "Confidence level of the intervals of the estimates." },
  { "study.failure", kind = "method", class = "failure",
    use = 's:failure{ of="depth_cylinder", above=3e-3, before=1000 }',
    text = "Probability that a result exceeds a limit, up to a distance or at any time, with its confidence interval "
      .. "(Clopper and Pearson)." },
  { "study.failure{of}", type = "string", values = columns,
    text = "Result that is compared with the limit, a column of the history." },
  { "study.failure{above}", type = "number",
    text = "Upper limit of the result, in the unit of the column (depths in mm)." },
  { "study.failure{below}", type = "number", text = "Lower limit of the result, in the unit of the column." },
  { "study.failure{before}", type = "number > 0", unit = "mm",
    text = "Distance up to which the limit applies; default: the end of each case." },
  { "study.failure{confidence}", type = "number in (0, 1)", default = 0.95,
    text = "Confidence level of the interval of the probability." },
  { "failure", kind = "object", use = "s:failure{...}",
    text = "Probability of failure, computed by s:failure{}; print shows it." },
  { "failure.probability", kind = "field", text = "Fraction of the samples that exceeded the limit." },
  { "failure.low", kind = "field", text = "Lower end of the confidence interval of the probability." },
  { "failure.high", kind = "field", text = "Upper end of the confidence interval of the probability." },
  { "failure.count", kind = "field", text = "Number of samples that exceeded the limit." },
  { "failure.n", kind = "field", text = "Number of samples." },
  { "failure.failed", kind = "field", text = "Number of failed cases, which are excluded." },
  { "failure.course", kind = "field",
    text = "The probability for half of the samples and for all samples, a list of { n=, probability= }, to check "
      .. "its convergence." },
  { "uncertainty", kind = "object", use = 's = study{ base={ distance=660 }, n=64,\n  sample={ k=lognormal{ mean=1e-8, variation=0.4 } } }\n'
      .. 's:run()  u = s:uncertainty{ of={ "depth_cylinder" } }\nprint(u)  plot.bands(u, { of="depth_cylinder" })',
    text = "Statistics of a sampled study, such as s = study{ sample={ k=lognormal{ mean=1e-8, variation=0.4 "
      .. "} }, n=256 }:run(), by the name of the result: u.depth_cylinder.mean[i] is the mean at the "
      .. "distance u.distance[i]. Each result has mean, mean_error, deviation, quantiles (a list of { "
      .. "share=, value=, low=, high= }), rank (Spearman's correlation with every field at the last "
      .. "distance) and convergence (these statistics for increasing numbers n of samples). With indices it "
      .. "also has tables first and total, { value=, error= } for each field: the share of the variance "
      .. "caused by the field alone, and by the field with its interactions. print(u) shows the "
      .. "statistics." },
  { "uncertainty.distance", kind = "field", unit = "mm",
    text = "Sliding distances at which the statistics are computed." },
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
      .. "relative changes of the number from 3 % to 4e-7; the difference quotient that agrees best with the "
      .. "quotients of the neighbouring changes is used. Results such as half widths and pressures jump from node "
      .. "to node; for these, the slope of a least-squares line through 17 runs over a wider range is used. "
      .. 'Automatic steps (jump = "auto", tolerance) are frozen, then divided into 4 and 8 parts. The results are '
      .. "those with 8 parts; the errors include the difference between 4 and 8 parts. With a given jump, the "
      .. "results apply to these steps, and the errors are due to the difference quotient alone." },
  { "wear.sensitivity{of}", type = "name or list of names", values = columns,
    default = '{ "depth_cylinder", "depth_plate", "p_center" }',
    text = "Results whose sensitivities are computed, columns of the history." },
  { "wear.sensitivity{to}", type = "name or list of names", default = '{ "k", "alpha", "load" }',
    text = 'Numbers of wear{} or model{} whose effect is computed, with the names of study{ vary= }: "cylinder.E", '
      .. '"lower.layer1.k"; "E" and "nu" change both bodies. If the bodies have their own wear coefficients, these '
      .. "coefficients replace k and alpha in the default." },
  { "wear.sensitivity{over}", type = "a share of the number from 0 to 0.5", default = "0.24",
    text = "For results that jump from node to node, whose derivative is the slope of a line: half the range of "
      .. "the line as a fraction of the number (smaller near the limits of the number). 0: local derivatives of "
      .. "all results." },
  { "sensitivity", kind = "object", use = "s = w:sensitivity{...}",
    text = "s.depth_cylinder.k is the sensitivity of the depth to k. Its fields are lists over s.distance: "
      .. "derivative and error (in the unit of the result divided by the unit of the number), elasticity, "
      .. "elasticity_error, and over (half the range of a slope as a fraction of the number; 0: a local "
      .. "derivative). print(s) shows the values at the end." },
  { "sensitivity.distance", kind = "field", unit = "mm", text = "Distances at the ends of the steps." },
  { "sensitivity.of", kind = "field", text = "Names of the results, which are columns of the history." },
  { "sensitivity.to", kind = "field", text = "Names of the varied numbers of wear{} or model{}." },
  { "sensitivity.runs", kind = "field", text = "Number of runs that were made." },

  -- --- pictures ---------------------------------------------------------------------------------
  { "plot.bands", kind = "function", takes = "plot", use = 'plot.bands(s, { of="depth_cylinder" })',
    text = "Draws quantiles of a sampled study, or of the result of s:uncertainty{}, as bands over the distance, "
      .. "with the median as a line. Accepts the options of plot{}." },
  { "plot.bands{of}", type = "name or list of names", values = columns,
    text = "Results to draw, columns of the history, with a panel for each result." },
  { "plot.tornado", kind = "function", takes = "plot", use = 'plot.tornado(u, { of="depth_cylinder" })',
    text = "Draws the importance of the numbers as bars: Sobol's indices of a sampled study or of s:uncertainty{}, "
      .. "rank correlations if there are no indices, elasticities of a sensitivity. Accepts the options of plot{}." },
  { "plot.tornado{of}", type = "string", values = columns,
    text = "Result whose bars are drawn; default: the first result." },
  { "plot.tornado{at}", type = "number > 0", unit = "mm",
    text = "Distance of the results; the nearest available distance is used. Default: the last distance. Rank "
      .. "correlations are those at the last distance." },
}

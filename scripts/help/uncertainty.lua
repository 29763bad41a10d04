-- Help entries of uncertainties: samples of studies, what they tell, sensitivities of runs. Form:
-- help.lua.

local columns = require "archard.uncertainty.outcomes".columns

return {
  -- --- samples of a study -----------------------------------------------------------------------
  { "study{sample}", type = "table of distributions", takes = "wear",
    text = "Uncertain fields of wear{} instead of vary: sample={ k=lognormal{ mean=1e-8, variation=0.4 }, "
      .. "alpha=uniform{ 0.3, 0.7 }, load=normal{ 100, 5 } }; fields within fields nested or as "
      .. '["model.radius"], ["lower.E"], as in vary, but one number each. correlated={ {"k", "alpha", -0.5}, ... } joins fields by the correlation of '
      .. "their normal scores; each keeps its own distribution. Before it starts, the least and the greatest "
      .. "value of every field are tried: one that cannot run, or that does nothing, is refused." },
  { "study{n}", type = "whole number >= 2", default = 1024,
    text = "How many samples; n (fields + 2) cases with indices. Sobol's points lie evenly where n is a "
      .. "power of 2." },
  { "study{design}", values = { "sobol", "latin", "random" }, default = '"sobol"',
    text = "How samples fill the space: Sobol's sequence with digits flipped at random (at most 40 fields, "
      .. "20 with indices), a Latin hypercube, or by chance." },
  { "study{seed}", type = "whole number >= 1", default = 1,
    text = "Of the random numbers. The same seed gives the same cases, bit by bit, for any number of "
      .. "workers and shares." },
  { "study{indices}", type = "boolean", default = false,
    text = "Adds the cases that Sobol's indices need (Saltelli's design). Not with correlated fields." },

  -- --- distributions ----------------------------------------------------------------------------
  { "uniform", kind = "function", class = "distribution", use = "uniform{ low=0.3, high=0.7 }",
    text = "A number anywhere between two ends; uniform{ 0.3, 0.7 } is short for it." },
  { "uniform{low}", type = "number", text = "The lower end, in the unit of the field." },
  { "uniform{high}", type = "number", text = "The upper end." },
  { "normal", kind = "function", class = "distribution", use = "normal{ mean=100, deviation=5 }",
    text = "A number with a normal distribution; normal{ 100, 5 } is short for it." },
  { "normal{mean}", type = "number", text = "The mean, in the unit of the field (before any cut)." },
  { "normal{deviation}", type = "number > 0", text = "The standard deviation, in the same unit." },
  { "normal{variation}", type = "number > 0", text = "deviation / mean, in its place." },
  { "normal{low}", type = "number", text = "Cuts off what is below." },
  { "normal{high}", type = "number", text = "Cuts off what is above." },
  { "lognormal", kind = "function", class = "distribution",
    use = "lognormal{ mean=1e-8, variation=0.4 }",
    text = "A number above 0 whose logarithm has a normal distribution, as wear coefficients have." },
  { "lognormal{mean}", type = "number > 0", text = "The mean of the number itself, in the unit of the field." },
  { "lognormal{deviation}", type = "number > 0", text = "Its standard deviation, in the same unit." },
  { "lognormal{variation}", type = "number > 0", text = "deviation / mean, in its place." },
  { "lognormal{low}", type = "number", text = "Cuts off what is below." },
  { "lognormal{high}", type = "number", text = "Cuts off what is above." },
  { "distribution", kind = "object", use = "uniform{...}  normal{...}  lognormal{...}",
    text = "What is known of an uncertain number, for study{ sample={...} }." },

  -- --- what samples tell ------------------------------------------------------------------------
  { "study.uncertainty", kind = "method", class = "uncertainty",
    use = 's:uncertainty{ of={"depth_cylinder", "p_center"} }',
    text = "Of a sampled study that has run: mean, deviation and quantiles of results over the distance, "
      .. "which field causes how much of it, and how far the estimates have settled." },
  { "study.uncertainty{of}", type = "name or list of names", values = columns,
    default = '{ "depth_cylinder", "depth_plate", "p_center" }', text = "Columns of the history." },
  { "study.uncertainty{at}", type = "list of numbers > 0", unit = "mm",
    text = "The distances; 50 up to where the shortest case ends, if left out. Between rows of a history "
      .. "by cubic interpolation." },
  { "study.uncertainty{quantiles}", type = "list of numbers in (0, 1)", default = "{ 0.05, 0.5, 0.95 }",
    text = "Which quantiles." },
  { "study.uncertainty{confidence}", type = "number in (0, 1)", default = 0.95,
    text = "How sure the ranges of the estimates are to hold what endless samples would give." },
  { "study.failure", kind = "method", class = "failure",
    use = 's:failure{ of="depth_cylinder", above=3e-3, before=1000 }',
    text = "The probability that a result passes a limit, before a distance or at all, with its range "
      .. "(Clopper and Pearson)." },
  { "study.failure{of}", type = "string", values = columns, text = "A column of the history." },
  { "study.failure{above}", type = "number", text = "The limit from above, in the column's unit (depths in mm)." },
  { "study.failure{below}", type = "number", text = "The limit from below." },
  { "study.failure{before}", type = "number > 0", unit = "mm",
    text = "The distance up to which it counts; left out: the whole of each case." },
  { "study.failure{confidence}", type = "number in (0, 1)", default = 0.95, text = "Of the range." },
  { "failure", kind = "object", use = "s:failure{...}", text = "A probability; print shows it." },
  { "failure.probability", kind = "field", text = "The share of the samples that passed the limit." },
  { "failure.low", kind = "field", text = "Lower end of the range that holds the probability." },
  { "failure.high", kind = "field", text = "Its upper end." },
  { "failure.count", kind = "field", text = "How many samples passed the limit." },
  { "failure.n", kind = "field", text = "How many samples there are." },
  { "failure.failed", kind = "field", text = "How many cases failed and are left out." },
  { "failure.course", kind = "field", text = "{ n=, probability= } from half of the samples and from all." },
  { "uncertainty", kind = "object", use = "u = s:uncertainty{...}",
    text = "Estimates by the name of the result: u.depth_cylinder.mean[i] is at the distance u.distance[i]. "
      .. "Each has mean, mean_error, deviation, quantiles (a list of { share=, value=, low=, high= }), rank "
      .. "(Spearman's correlation with every field at the last distance), convergence (the same from ever "
      .. "more samples, n) and, with indices, first and total: by field { value=, error= }, the share of the "
      .. "variance that the field causes by itself, and with all that it takes part in. print shows it." },
  { "uncertainty.distance", kind = "field", unit = "mm", text = "Where the estimates are." },
  { "uncertainty.of", kind = "field", text = "The results, by name." },
  { "uncertainty.fields", kind = "field", text = "The uncertain fields, by name." },
  { "uncertainty.n", kind = "field", text = "How many samples there are." },
  { "uncertainty.failed", kind = "field", text = "How many cases failed and are left out." },
  { "uncertainty.confidence", kind = "field", text = "That of the ranges." },
  { "uncertainty.design", kind = "field", text = "How the samples fill the space." },
  { "uncertainty.seed", kind = "field", text = "Of the random numbers." },
  { "uncertainty.indices", kind = "field", text = "Whether there are Sobol's indices." },

  -- --- sensitivities ----------------------------------------------------------------------------
  { "wear.sensitivity", kind = "method", class = "sensitivity",
    use = 'w:sensitivity{ of="depth_cylinder", to={"k", "alpha", "E"} }',
    text = "How results answer to numbers of the definition, over the whole history: derivatives and "
      .. "elasticities (percent by percent), each with its own error. The run is repeated 16 times for "
      .. "each number, changed by 3 % down to 4e-7; every result keeps the difference that wider and "
      .. "narrower changes confirm best. Half widths and pressures jump a little as the contact's edge goes "
      .. "from node to node: where a result does, its slope by least squares through 17 runs over a wide "
      .. "range is told instead. Steps that chose themselves (jump = \"auto\", tolerance) are taken "
      .. "as they were by all runs, then in 4 and in 8 parts: results are those of 8 parts, and errors have "
      .. "in them what the parts changed. With a given jump the error is that of the difference alone: "
      .. "results are of the run with these very steps." },
  { "wear.sensitivity{of}", type = "name or list of names", values = columns,
    default = '{ "depth_cylinder", "depth_plate", "p_center" }', text = "Columns of the history." },
  { "wear.sensitivity{to}", type = "name or list of names", default = '{ "k", "alpha", "load" }',
    text = "Numbers of wear{} or model{}, by the names that vary of study{} takes: \"cylinder.E\", "
      .. "\"lower.layer1.k\"; \"E\" and \"nu\" stand for both bodies. Where bodies have coefficients of their "
      .. "own, these stand in place of k and alpha." },
  { "wear.sensitivity{over}", type = "a share of the number from 0 to 0.5", default = "0.24",
    text = "Half the wide range, less where a number cannot go so far. 0: local derivatives, even of "
      .. "results that jump." },
  { "sensitivity", kind = "object", use = "s = w:sensitivity{...}",
    text = "s.depth_cylinder.k has derivative, error (in the units of both), elasticity, "
      .. "elasticity_error, and over (half the range of a slope as a share of the number, 0: a local "
      .. "derivative), each a list over s.distance. print shows the last ones." },
  { "sensitivity.distance", kind = "field", unit = "mm", text = "Where the run's steps ended." },
  { "sensitivity.of", kind = "field", text = "The results, by name." },
  { "sensitivity.to", kind = "field", text = "The numbers, by name." },
  { "sensitivity.runs", kind = "field", text = "How many runs it took." },

  -- --- pictures ---------------------------------------------------------------------------------
  { "plot.bands", kind = "function", takes = "plot", use = 'plot.bands(s, { of="depth_cylinder" })',
    text = "Quantiles of a sampled study, or of its uncertainty, as bands over the distance; the middle one "
      .. "as a line. Takes the options of plot{} too." },
  { "plot.bands{of}", type = "name or list of names", values = columns,
    text = "Columns of the history, a panel for each." },
  { "plot.tornado", kind = "function", takes = "plot", use = 'plot.tornado(u, { of="depth_cylinder" })',
    text = "Which number matters most, as bars: Sobol's indices of a sampled study or its uncertainty, rank "
      .. "correlations where there are no indices, elasticities of a sensitivity. Takes the options of "
      .. "plot{} too." },
  { "plot.tornado{of}", type = "string", values = columns, text = "The result; the first one if left out." },
  { "plot.tornado{at}", type = "number > 0", unit = "mm",
    text = "The nearest distance to look at; the last one if left out. Rank correlations are of the last." },
}

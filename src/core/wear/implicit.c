/* Makes implicit updates. At order 1 (backward Euler) the wear follows from the pressures on the
 * geometry at the end of a step. At order 2 (TR-BDF2, L-stable) it follows from the pressures at
 * the start of the step, at an intermediate stage, and at the end. Sites that enter the contact
 * during a step limit its length, because these sites wear only in the last stages. TR-BDF2
 * overestimates the pressures there less than similar methods. The kind of pair solves the stages.
 */
#include "core/base/carve.h"
#include "core/wear/step.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Number of equal implicit steps in an update with error control. All steps use the compliance at
 * the start of the update, so they need only contact solutions. When the edge of the contact
 * crosses a node, the error of a single step jumps, but the largest error of several steps varies
 * less. */
enum { steps_by_tolerance = 4 };

/* Indices of the results of a cycle that are single numbers, not values at sites. */
enum { ENERGY, EVEN, PRESSED, SUMS };
typedef struct sums {
  double of[SUMS];
} sums;

/* Data of one implicit update, shared by its functions. */
typedef struct implicit {
  wear_stage at;
  const update_coefficients *coefficients;
  int n;
  int steps, done; /* number of steps in the update; index of the present step */
  sums mean;       /* mean of the results over the steps so far */
  double worst;    /* largest error of a step divided by the tolerance */
  double *rate[3]; /* [n] wear of a cycle, k times the rate [mm], at the start and at both stages */
  double *defect;  /* [n] estimated error of the depths [mm] */
} implicit;

/* Accepted error of the depths in one step, divided by the tolerance. With the second-order
 * method the errors of the first steps decrease later, because the pressure flattens. The number
 * was determined with the twenty cases of the reference paper (README.md) on elements of 20, 10 and
 * 5 um.
 */
static const double share_per_step = 0.5;
/* Accepted error of pressures, divided by the tolerance. A large error is accepted because
 * pressures follow from the depths, so their errors do not accumulate. */
static const double pressure_share = 60;
static const double gamma2 = 0.29289321881345247560; /* 1 - 1 / sqrt(2) */

/* Computes the friction coefficient at the fraction `share` of a step. Must be called before the
 * stages, because it overwrites the workspace of the depths. */
static arc_status friction_at(implicit *s, double share, double *mu) {
  *mu = s->at.window.mu;
  share = (s->done + share) / s->steps;
  return arc_wear_friction_within(s->at.run, s->coefficients, share, mu, &s->at.error);
}

static arc_status solve(implicit *s, double h, double *rate) {
  return s->at.run->kind->stage(&s->at, h, rate);
}

static sums of_last(const implicit *s) {
  return (sums){{s->at.last.energy, s->at.last.even, s->at.last.pressed}};
}

/* Adds a step to the mean of all steps. The value of a step is its end value plus `part` times two
 * differences: the values at the start and at the middle stage, each minus the end value. Thus
 * equal values remain exactly equal. */
static void add_step(implicit *s, double part, sums start, sums middle) {
  const sums end = of_last(s);
  for (int i = 0; i < SUMS; i++) {
    const double step = end.of[i] + part * ((start.of[i] - end.of[i]) + (middle.of[i] - end.of[i]));
    s->mean.of[i] += (step - s->mean.of[i]) / (s->done + 1);
  }
}

/* Makes a step by backward Euler. Its estimated error, s->defect, is the difference from the
 * trapezoidal rule. */
static arc_status first_order(implicit *s, double cycles) {
  double *defect = s->defect;
  const size_t bytes = (size_t)s->n * sizeof(double);
  memcpy(s->at.known, s->at.z, bytes);
  memcpy(s->rate[2], s->rate[0], bytes);
  arc_status status = friction_at(s, 1, &s->at.window.mu);
  if (status == ARC_OK) status = solve(s, cycles, s->rate[2]);
  for (int i = 0; i < s->n && status == ARC_OK; i++)
    defect[i] = cycles * (s->rate[2][i] - s->rate[0][i]) / 2;
  if (status == ARC_OK) add_step(s, 0, of_last(s), of_last(s));
  return status;
}

/* Makes a step: by the trapezoidal rule up to the fraction 2 gamma of its length, and by BDF2 to
 * the end. Its estimated error, s->defect, is the difference from the quadrature through the start
 * and both stages. */
static arc_status second_order(implicit *s, double cycles) {
  const double g = gamma2, h = g * cycles, c = 2 * g, part = (1 - g) / 2;
  const double b1 = 1 / (6 * c * (1 - c)), b2 = (1 / 3.0 - c / 2) / (1 - c), b0 = 1 - b1 - b2;
  const size_t bytes = (size_t)s->n * sizeof(double);
  double *defect = s->defect, mu[2];
  arc_status status = friction_at(s, c, &mu[0]);
  if (status == ARC_OK) status = friction_at(s, 1, &mu[1]);
  if (status != ARC_OK) return status;
  const sums start = of_last(s);
  for (int i = 0; i < s->n; i++) s->at.known[i] = s->at.z[i] + h * s->rate[0][i];
  memcpy(s->rate[1], s->rate[0], bytes);
  s->at.window.mu = mu[0];
  status = solve(s, h, s->rate[1]);
  if (status != ARC_OK) return status;
  const sums middle = of_last(s);
  for (int i = 0; i < s->n; i++)
    s->at.known[i] += (cycles * part - h) * s->rate[0][i] + cycles * part * s->rate[1][i];
  memcpy(s->rate[2], s->rate[1], bytes);
  s->at.window.mu = mu[1];
  status = solve(s, h, s->rate[2]);
  for (int i = 0; i < s->n && status == ARC_OK; i++)
    defect[i] = cycles * ((b0 - part) * s->rate[0][i] + (b1 - part) * s->rate[1][i] +
                          (b2 - g) * s->rate[2][i]);
  if (status == ARC_OK) add_step(s, part, start, middle);
  return status;
}

/* --- the error -------------------------------------------------------------------------------- */

/* Returns the largest error of the depths of one body divided by the largest depth. Only sites
 * deeper than `counts` times the largest depth are included. */
static double depth_error(const implicit *s, int b) {
  static const double counts =
      0.05; /* smallest depth that is included, as a fraction of the largest depth */
  const arc_wear *w = s->at.run;
  const wear_sites on = w->kind->sites(s->at.window.shape, (arc_body)b);
  const double *depth = sites_from(w, s->at.worn, b), *off = sites_from(w, s->defect, b);
  double deepest = 0, largest = 0;
  for (int i = 0; i < on.count; i++) deepest = fmax(deepest, on.h[i] + depth[i]);
  for (int i = 0; i < on.count; i++)
    if (on.h[i] + depth[i] > counts * deepest) largest = fmax(largest, fabs(off[i]));
  return deepest > 0 ? largest / deepest : 0;
}

/* Returns the estimated error of a step, divided by the tolerance. */
static double share_of_tolerance(implicit *s, double h) {
  const double tolerance = s->at.run->def.tolerance;
  if (tolerance == 0) return 0;
  const double pressure = s->at.run->kind->error(&s->at, h, s->defect);
  if (pressure < 0) return 0;
  const double depth = fmax(depth_error(s, ARC_UPPER), depth_error(s, ARC_LOWER));
  return fmax(depth / (share_per_step * tolerance), pressure / (pressure_share * tolerance));
}

/* Returns the number of implicit steps of an update: steps_by_tolerance with error control, and 1
 * otherwise. An update of a single increment always has one step, because the increment determines
 * the length of this update. */
static int count_steps(const implicit *s) {
  const wear_window *window = &s->at.window;
  const int whole = window->first == 0 && window->last == window->block->count - 1;
  const int chosen = s->at.run->def.tolerance > 0 && window->block->periodic && whole;
  return chosen ? steps_by_tolerance : 1;
}

static arc_status run(implicit *s, wear_depths *depth) {
  arc_status status = s->at.run->kind->start(&s->at, s->rate[0]); /* z = 0 */
  if (status != ARC_OK) return status;
  const int first = s->at.run->def.order == 1;
  s->steps = count_steps(s);
  const double length = s->coefficients->cycles / s->steps;
  for (s->done = 0; s->done < s->steps; s->done++) {
    status = first ? first_order(s, length) : second_order(s, length);
    if (status != ARC_OK) return status;
    s->worst = fmax(s->worst, share_of_tolerance(s, first ? length : gamma2 * length));
    memcpy(s->rate[0], s->rate[2], (size_t)s->n * sizeof(double));
  }
  memcpy(depth->node[0], s->at.z, (size_t)s->n * sizeof(double));
  depth->error = s->worst;
  depth->energy = s->coefficients->cycles * s->mean.of[ENERGY];
  depth->even = s->coefficients->cycles * s->mean.of[EVEN];
  depth->pressed = s->coefficients->cycles * s->mean.of[PRESSED];
  return ARC_OK;
}

static arc_status report(const implicit *s, arc_status status, arc_error *error) {
  if (status != ARC_NOT_CONVERGED) {
    if (status != ARC_OK && error) *error = s->at.error;
    return status;
  }
  const char *why = s->at.error.message;
  return arc_fail(error, status, "the implicit step did not converge for %g cycles%s%s",
                  s->coefficients->cycles, why[0] ? "; last error: " : "", why);
}

static arc_status create(implicit *s) {
  const size_t n = (size_t)s->n;
  const carve_part parts[] = {{&s->at.z, n},    {&s->at.known, n}, {&s->at.worn, n},
                              {&s->rate[0], n}, {&s->rate[1], n},  {&s->rate[2], n},
                              {&s->defect, n}};
  const arc_kind *kind = s->at.run->kind;
  if (!ARC_CARVE(parts)) return ARC_MEMORY;
  return kind->begin_stages ? kind->begin_stages(&s->at) : ARC_OK;
}

arc_status arc_wear_implicit(arc_wear *w, const wear_window *window,
                             const update_coefficients *coefficients, wear_progress *progress,
                             wear_depths *depth, arc_error *error) {
  implicit s = {.at = {.run = w, .window = *window, .progress = progress},
                .coefficients = coefficients};
  s.n = w->nc + w->np;
  for (int b = 0; b < ARC_BODIES; b++) s.at.k[b] = sites_k(w, coefficients->mean.k, b);
  depth->error = 0;
  arc_status status = create(&s);
  if (status != ARC_OK)
    arc_fail(&s.at.error, status, "out of memory for an implicit step");
  else
    status = run(&s, depth);
  depth->even =
      status == ARC_OK && w->manner.even ? coefficients->mean.k[ARC_LOWER] * depth->even : 0;
  depth->peak = s.at.last.peak;
  if (w->kind->end_stages)
    w->kind->end_stages(&s.at, coefficients->cycles, status == ARC_OK ? depth : NULL);
  free(s.at.z);
  return report(&s, status, error);
}

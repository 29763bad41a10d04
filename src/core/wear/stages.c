/* Makes explicit updates in stages, for automatic jumps, by the Runge-Kutta method of second order
 * with s stages and equal weights (SSPRK(s,2)). Each stage is an Euler step over 1 / (s - 1) of the
 * update, and the update uses the mean of all rates. Longer updates have more stages, so stability
 * does not limit their length. All stages use the compliance at the start of the update. Volumes
 * remain exact. */
#include "core/base/carve.h"
#include "core/wear/step.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Parameters of the stages, which depend on the kind of law. */
typedef struct staging {
  int fewest,
      most; /* smallest and largest number of stages; an error estimate needs at least `fewest` */
  double share;  /* length of a stage divided by the limit 2 / eigenvalue */
  int by_thirds; /* 1: the error is estimated from means over thirds of the update, because single
                    rates are noisy */
} staging;

/* Returns the parameters of the stages for the wear law of the run. With a discontinuous law the
 * pressures at nodes oscillate about the discontinuity, and shorter stages reduce this oscillation.
 */
static staging staging_of(const arc_wear *w) {
  static const staging smooth = {3, 14, 0.85, 0}, jumping = {30, 1200, 0.01, 1};
  return arc_law_properties[w->def.law] & ARC_LAW_JUMPS ? jumping : smooth;
}

/* Nodes that are worn by less than this fraction of the largest depth are excluded from the error
 * norm. */
static const double worn = 0.05;

typedef struct staged {
  arc_wear *w;
  wear_window window; /* window that is solved at each stage */
  update_coefficients coefficients;
  wear_rate *rate; /* wear rate of the last stage */
  int n, stages;
  double even, energy;  /* sums over the stages so far: rate of uniform wear, and energy */
  double pressed;       /* sum of wear_rate.pressed so far [N] */
  double peak;          /* largest pressure at the first stage [MPa] */
  double *z, *sum;      /* [n] depths so far [mm]; sum of the rates so far */
  double *first, *bend; /* [n] rate of the first stage; second difference of the sums over thirds of
                           the update */
} staged;

static arc_status staged_create(staged *s) {
  const size_t n = (size_t)s->n;
  const carve_part parts[] = {{&s->z, n}, {&s->sum, n}, {&s->first, n}, {&s->bend, n}};
  if (!ARC_CARVE(parts)) return ARC_MEMORY;
  s->window.depth = s->z;
  return ARC_OK;
}

/* Converts depths computed with the largest wear coefficient to depths with the coefficients of the
 * layers. */
static void go_through_layers(const staged *s, double *depth) {
  const arc_kind *kind = s->w->kind;
  if (kind->through_layers) kind->through_layers(s->window.shape, depth);
}

/* Returns the factor [mm2/N] that converts the mean rate [MPa mm] of site i to its wear depth in
 * the update [mm]. It is 0 for a lower body that wears uniformly or along a track: its sites have
 * no depths of their own, and its depth is computed from the sum `even`. */
static double scale(const staged *s, int i) {
  return s->coefficients.cycles *
         sites_k(s->w, s->coefficients.mean.k, i < s->w->nc ? ARC_UPPER : ARC_LOWER);
}

/* Adds the present rate to the sums and makes an Euler step. */
static void add_stage(staged *s, int stage) {
  const double *rate = s->rate->node[0];
  const double weight = 3 * stage / s->stages == 1 ? -2 : 1;
  s->even += s->rate->even;
  s->energy += s->rate->energy;
  s->pressed += s->rate->pressed;
  for (int i = 0; i < s->n; i++) {
    s->sum[i] += rate[i];
    s->bend[i] += weight * rate[i];
    s->z[i] = scale(s, i) * s->sum[i] / (s->stages - 1);
  }
  go_through_layers(s, s->z);
}

static arc_status run_stages(staged *s, wear_progress *progress, arc_error *error) {
  memcpy(s->first, s->rate->node[0], (size_t)s->n * sizeof *s->first);
  s->peak = s->rate->peak;
  add_stage(s, 0);
  for (int j = 1; j < s->stages; j++) {
    const double share = (double)j / (s->stages - 1);
    arc_status status =
        arc_wear_friction_within(s->w, &s->coefficients, share, &s->window.mu, error);
    if (status == ARC_OK) status = s->w->kind->rate(s->w, &s->window, progress, s->rate, error);
    if (status != ARC_OK) return status;
    add_stage(s, j);
  }
  return ARC_OK;
}

/* Returns the root mean square of the error over the worn part of one body [mm]. The mean is used
 * because the error of single nodes at the edge of a scar does not decrease with the element size.
 */
static double worn_mean(const staged *s, arc_body b, const double *depth, const double *defect,
                        double *deepest) {
  const arc_kind *kind = s->w->kind;
  const wear_sites on = kind->sites(s->window.shape, b);
  double sum = 0, width = 0;
  *deepest = 0;
  for (int i = 0; i < on.count; i++) *deepest = fmax(*deepest, on.h[i] + depth[i]);
  for (int i = 0; i < on.count; i++) {
    if (on.h[i] + depth[i] < worn * *deepest) continue;
    const double w = kind->area(s->window.shape, b, i);
    sum += w * defect[i] * defect[i];
    width += w;
  }
  return width > 0 ? sqrt(sum / width) : 0;
}

/* Returns the error estimate divided by the tolerance. The error is the difference between the mean
 * of all rates and the mean of the first and the last rate, two means with the same order of
 * accuracy. If single rates are noisy, the error is the second difference of the means over thirds
 * of the update. */
static double estimate(staged *s, const wear_depths *depth) {
  const int by_thirds = staging_of(s->w).by_thirds;
  double *defect = s->first, share = 0;
  for (int i = 0; i < s->n; i++)
    defect[i] = by_thirds ? scale(s, i) * s->bend[i] * 9 / 4 / s->stages
                          : scale(s, i) * (defect[i] + s->rate->node[0][i]) / 2 - depth->node[0][i];
  memcpy(s->z, depth->node[0], (size_t)s->n * sizeof *s->z);
  go_through_layers(s, s->z);
  for (int i = 0; i < s->n; i++)
    if (depth->node[0][i] > 0) defect[i] *= s->z[i] / depth->node[0][i];
  for (int b = 0; b < ARC_BODIES; b++) {
    double deepest;
    const double off =
        worn_mean(s, (arc_body)b, sites_from(s->w, s->z, b), sites_from(s->w, defect, b), &deepest);
    if (deepest > 0) share = fmax(share, off / (ARC_STAGED_TOLERANCE * deepest));
  }
  return share;
}

double arc_wear_longest_staged(const arc_wear *w, double eigenvalue) {
  const staging how = staging_of(w);
  return eigenvalue > 0 ? (how.most - 1) * how.share * 2 / eigenvalue : INFINITY;
}

static int stages_for(const arc_wear *w, double cycles, double eigenvalue) {
  const staging how = staging_of(w);
  const double least = 1 + ceil(cycles * eigenvalue / (2 * how.share) * (1 - 1e-9));
  const int stages = (int)fmin(fmax(least, how.fewest), how.most);
  return how.by_thirds ? (stages + 2) / 3 * 3 : stages;
}

arc_status arc_wear_stages(arc_wear *w, const wear_window *window,
                           const update_coefficients *coefficients, double eigenvalue,
                           wear_progress *progress, wear_rate *rate, wear_depths *depth,
                           arc_error *error) {
  staged s = {
      .w = w, .window = *window, .coefficients = *coefficients, .rate = rate, .n = w->nc + w->np};
  s.stages = stages_for(w, coefficients->cycles, eigenvalue);
  arc_status status = staged_create(&s);
  if (status != ARC_OK) return arc_fail(error, status, "out of memory for an update");
  s.window.tangent = NULL;
  status = run_stages(&s, progress, error);
  if (status == ARC_OK) {
    for (int i = 0; i < s.n; i++) depth->node[0][i] = scale(&s, i) * s.sum[i] / s.stages;
    depth->peak = s.peak;
    depth->pressed = coefficients->cycles * s.pressed / s.stages;
    depth->even = w->manner.even
                      ? coefficients->cycles * coefficients->mean.k[ARC_PLATE] * s.even / s.stages
                      : 0;
    depth->energy = coefficients->cycles * s.energy / s.stages;
    depth->error = estimate(&s, depth);
  }
  free(s.z);
  return status;
}

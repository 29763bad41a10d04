/* Common parts of the tests of core/space: balls on half-spaces, positions of a stroke, and wear
 * histories. */
#ifndef TESTS_SPACE_SHARED_H
#define TESTS_SPACE_SHARED_H

#include "check.h"

#include "archard/space.h"

#include <time.h>

static const double steel_modulus =
    200e3 / (2 * (1 - 0.09)); /* contact modulus of two steel bodies [MPa] */

UNUSED static arc_halfspace *make_space(const arc_halfspace_def *def) {
  arc_halfspace *h = NULL;
  check_ok(arc_halfspace_create(def, &h, why));
  return h;
}

/* Returns the definition of a ball on a flat with n x n cells. */
UNUSED static arc_halfspace_def ball(double radius, double size, int n) {
  arc_halfspace_def def = arc_halfspace_default();
  def.body[ARC_UPPER].radius_x = def.body[ARC_UPPER].radius_z = radius;
  def.size_x = def.size_z = size;
  def.nx = def.nz = n;
  return def;
}

UNUSED static double *make_values(size_t count) {
  double *values = calloc(count, sizeof *values);
  assert_non_null(values);
  return values;
}

UNUSED static double sum_of(const double *value, int count) {
  double sum = 0;
  for (int k = 0; k < count; k++) sum += value[k];
  return sum;
}

UNUSED static double largest_of(const double *value, int count) {
  double most = 0;
  for (int k = 0; k < count; k++) most = fmax(most, value[k]);
  return most;
}

/* Result of one contact solution with the plate at x = 0. */
typedef struct solved {
  arc_halfspace *h;
  double *p, approach;
  arc_halfspace_extent extent;
  arc_halfspace_report report;
} solved;

UNUSED static solved solve_space(const arc_halfspace_def *def, double load, double tolerance) {
  solved s = {.h = make_space(def)};
  const arc_halfspace_position at = {.load = load};
  const arc_halfspace_options options = {.tolerance = tolerance};
  s.p = make_values((size_t)(def->nx * def->nz));
  check_ok(arc_halfspace_solve(s.h, NULL, &at, &options, s.p, &s.approach, &s.report, why));
  s.extent = arc_halfspace_contact_extent(s.h, s.p);
  check_share(sum_of(s.p, def->nx * def->nz) * def->size_x * def->size_z, load, 1e-12);
  return s;
}

UNUSED static void free_solved(solved *s) {
  free(s->p);
  s->p = NULL;
  arc_halfspace_destroy(&s->h);
}

/* --- histories -------------------------------------------------------------------------------- */

/* Definition of a reciprocating wear run. Its cycles are so short that wear can be treated as a
 * continuous function of the sliding distance. */
typedef struct history_def {
  arc_halfspace_def space;
  double load, k, alpha, stroke, distance;
  int increments; /* number of increments of the stroke; 0: a single position */
  int steps;
  double first; /* length of the first step [mm]; 0: equal steps */
  double tolerance;
} history_def;

typedef struct history {
  arc_halfspace *h;
  int count;
  arc_halfspace_position *position;
  double *depth[ARC_BODIES], *known[ARC_BODIES], *half[ARC_BODIES], *pressure;
  long applications, iterations, stages, guarded;
  double seconds;
} history;

UNUSED static void make_positions(history *w, const history_def *d) {
  const int m = d->increments;
  w->count = m + 1;
  w->position = calloc((size_t)w->count, sizeof *w->position);
  assert_non_null(w->position);
  for (int i = 0; i <= m; i++) {
    const double share = m > 0 ? (i == 0 || i == m ? 0.5 : 1.0) / m : 1;
    const double x = m > 0 ? (i - m / 2.0) * d->stroke / m : 0;
    w->position[i] = (arc_halfspace_position){.x = x, .load = d->load, .weight = share};
  }
}

UNUSED static history make_history(const history_def *d) {
  history w = {.h = make_space(&d->space)};
  make_positions(&w, d);
  for (int b = 0; b < ARC_BODIES; b++) {
    const size_t n = (size_t)arc_halfspace_sites(w.h, (arc_body)b);
    w.depth[b] = make_values(n);
    w.known[b] = make_values(n);
    w.half[b] = make_values(n);
  }
  w.pressure = make_values((size_t)w.count * (size_t)(d->space.nx * d->space.nz));
  return w;
}

UNUSED static void free_history(history *w) {
  for (int b = 0; b < ARC_BODIES; b++) {
    free(w->depth[b]);
    free(w->known[b]);
    free(w->half[b]);
  }
  free(w->pressure);
  free(w->position);
  arc_halfspace_destroy(&w->h);
}

UNUSED static void run_stage(history *w, const history_def *d, double *const known[ARC_BODIES],
                             double length, int warm, double *const to[ARC_BODIES]) {
  const arc_halfspace_wear wear = {.c = {d->k * d->alpha * length, d->k * (1 - d->alpha) * length}};
  const double *const from[ARC_BODIES] = {known[0], known[1]};
  const arc_halfspace_options options = {.tolerance = d->tolerance, .warm = warm};
  arc_halfspace_report report;
  check_ok(arc_halfspace_stage(w->h, from, &wear, w->position, w->count, &options, w->pressure, to,
                               &report, why));
  w->applications += report.applications;
  w->iterations += report.iterations;
  w->guarded += report.guarded;
  w->stages++;
}

/* Computes one step with the implicit Runge-Kutta method SDIRK2 (gamma = 1 - 1 / sqrt 2), which
 * is L-stable and of second order. */
UNUSED static void run_step(history *w, const history_def *d, double length, int warm) {
  const double gamma = 1 - sqrt(0.5), carry = (1 - gamma) / gamma;
  run_stage(w, d, w->depth, gamma * length, warm, w->half);
  for (int b = 0; b < ARC_BODIES; b++)
    for (int k = 0, n = arc_halfspace_sites(w->h, (arc_body)b); k < n; k++)
      w->known[b][k] = w->depth[b][k] + carry * (w->half[b][k] - w->depth[b][k]);
  run_stage(w, d, w->known, gamma * length, 1, w->depth);
}

/* Returns the ratio of successive step lengths for which `steps` steps, beginning with `first`,
 * add up to the distance. */
UNUSED static double ratio_of(double first, double distance, int steps) {
  double low = 1, high = 4;
  for (int k = 0; k < 100; k++) {
    const double middle = (low + high) / 2, sum = first * (pow(middle, steps) - 1) / (middle - 1);
    if (sum < distance)
      low = middle;
    else
      high = middle;
  }
  return high;
}

UNUSED static history run_history(const history_def *d) {
  history w = make_history(d);
  const double ratio = d->first > 0 ? ratio_of(d->first, d->distance, d->steps) : 1;
  double done = 0, length = d->first > 0 ? d->first : d->distance / d->steps;
  const clock_t begin = clock();
  for (int k = 0; k < d->steps; k++) {
    if (k + 1 == d->steps) length = d->distance - done;
    run_step(&w, d, length, k > 0);
    done += length;
    length *= ratio;
  }
  w.seconds = (double)(clock() - begin) / CLOCKS_PER_SEC;
  return w;
}

UNUSED static double volume_of(const history *w, arc_body body) {
  return sum_of(w->depth[body], arc_halfspace_sites(w->h, body)) *
         arc_halfspace_site_area(w->h, body);
}

/* Returns the wear depth of the body at x = z = 0 [mm]. */
UNUSED static double depth_of(const history *w, arc_body body) {
  return arc_halfspace_scar(w->h, body, w->depth[body], 0.01).center;
}

#endif

/* Newton on the depths of both surfaces. The Jacobian and its factors are kept over the stages of a
 * step, as long as the iteration contracts well; then they are renewed, and at last the exact ones
 * are used in every iteration, with a line search. Leans on rate.c and jacobian.c. */
#include "core/wear/newton.h"
#include "core/base/dense.h"
#include "core/wear/layers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { newton_limit = 15, kept_limit = 8, halvings = 5 };
/* Of the largest depth at hand; with a tolerance, a share of it. */
static const double tight = 1e-8, share_of_tolerance = 5e-3;
/* The kept Jacobian has to reduce the error to this share in each iteration. */
static const double contraction = 0.4;

arc_status arc_newton_create(newton *s) {
  const size_t n = (size_t)s->n;
  double *block = calloc(14 * n + n * n, sizeof *block);
  s->z = block;
  s->pivots = malloc(2 * n * sizeof(int));
  if (!block || !s->pivots) return ARC_MEMORY;
  s->node = s->pivots + n;
  double **member[] = {&s->z,       &s->residual, &s->step,    &s->known,  &s->down,
                       &s->rate[0], &s->rate[1],  &s->rate[2], &s->packed, &s->start,
                       &s->defect,  &s->last,     &s->taken,   &s->worn};
  for (int m = 0; m < 14; m++) *member[m] = block + (size_t)m * n;
  s->matrix = block + 14 * n;
  s->window.trial = &s->trial;
  s->trial = arc_wear_trial_on(s->window.shape, s->worn, s->down);
  const shape_side *plate = &s->window.shape->side[ARC_PLATE];
  s->coarse = 2 * arc_shape_width(plate, plate->n / 2);
  const arc_status status = arc_wear_jacobian_create(&s->jacobian, s->w->nc, s->w->np);
  s->jacobian.width = s->coarse;
  return status;
}

void arc_newton_free(newton *s) {
  free(s->z);
  free(s->pivots);
  arc_wear_jacobian_free(&s->jacobian);
}

static double k_at(const newton *s, int i) {
  return s->dose.k[i < s->w->nc ? ARC_CYLINDER : ARC_PLATE];
}

/* The depths that z comes to. */
static void wear_by_z(newton *s) {
  memcpy(s->worn, s->z, (size_t)s->n * sizeof *s->worn);
  arc_wear_into_layers(s->window.shape, s->worn);
}

double arc_newton_share(const newton *s, int i) {
  const int plate = i >= s->w->nc;
  return arc_wear_layer_share(s->window.shape, plate ? ARC_PLATE : ARC_CYLINDER,
                              plate ? i - s->w->nc : i, s->worn[i]);
}

static double largest_of(const double *v, int n) {
  double largest = 0;
  for (int i = 0; i < n; i++) largest = fmax(largest, fabs(v[i]));
  return largest;
}

/* What a rate takes off one body [mm2]. */
static double area_on(const newton *s, arc_body b, const double *rate) {
  double sum = 0;
  for (int i = 0; i < s->window.shape->side[b].n; i++)
    sum += rate[i] * arc_shape_span(s->window.shape, b, i);
  return sum;
}

/* What a cycle wears off both bodies [mm2]. */
static double area_of(const newton *s, const double *rate) {
  return area_on(s, ARC_CYLINDER, rate) + area_on(s, ARC_PLATE, rate + s->w->nc);
}

arc_status arc_newton_evaluate(newton *s, double *rate, int with_jacobian) {
  wear_rate here = {.node = {rate, rate + s->w->nc}};
  s->window.jacobian = with_jacobian ? &s->jacobian : NULL;
  wear_by_z(s);
  const arc_status status = arc_wear_evaluate(s->w, &s->window, s->watch, &here, &s->error);
  if (status != ARC_OK) return status;
  if (with_jacobian) s->h = 0;
  for (int i = 0; i < s->n; i++) rate[i] *= k_at(s, i);
  s->even = here.even;
  s->peak = here.peak;
  s->pressed = here.pressed;
  s->energy = here.energy;
  s->area = here.energy > 0 ? area_of(s, rate) : 0;
  return ARC_OK;
}

/* --- the linear system --- */

/* Only nodes that wear and were in contact have anything to solve for. */
static arc_status factorise(newton *s, double h) {
  const double *rates = s->jacobian.value;
  int m = 0;
  for (int i = 0; i < s->n; i++)
    if (k_at(s, i) > 0 && rates[dense_at(i, i, s->n)] > 0) s->node[m++] = i;
  for (int j = 0; j < m; j++) {
    double *to = &s->matrix[dense_at(0, j, m)];
    const double by = h * arc_newton_share(s, s->node[j]);
    for (int i = 0; i < m; i++)
      to[i] = by * k_at(s, s->node[i]) * rates[dense_at(s->node[i], s->node[j], s->n)];
    to[j] += 1;
  }
  s->live = m;
  s->h = 0;
  if (arc_dense_factor(m, s->matrix, s->pivots)) return ARC_NUMERIC;
  s->h = h;
  return ARC_OK;
}

arc_status arc_newton_direction(newton *s, double h, double *x) {
  if (s->h != h && factorise(s, h) != ARC_OK) return ARC_NUMERIC;
  for (int i = 0; i < s->live; i++) s->packed[i] = x[s->node[i]];
  arc_dense_factor_solve(s->live, 1, s->matrix, s->pivots, s->packed);
  for (int i = 0; i < s->live; i++) x[s->node[i]] = s->packed[i];
  return ARC_OK;
}

/* --- a stage --- */

/* residual = z - known - h rate; its largest entry. */
static double residual_of(newton *s, double h, const double *rate) {
  for (int i = 0; i < s->n; i++) s->residual[i] = s->z[i] - s->known[i] - h * rate[i];
  return largest_of(s->residual, s->n);
}

static double allowed(const newton *s) {
  const double depth = fmax(arc_shape_depth(s->window.shape, ARC_CYLINDER),
                            arc_shape_depth(s->window.shape, ARC_PLATE));
  const double share = s->w->def.tolerance > 0 ? share_of_tolerance * s->w->def.tolerance : tight;
  return share * (depth + largest_of(s->worn, s->n));
}

static int hopeless(arc_status status) {
  return status == ARC_STOPPED || status == ARC_CALLBACK || status == ARC_MEMORY;
}

/* No node is pulled: the body loses `area` all the same. */
static void push_only(const newton *s, arc_body b, double area, double *rate) {
  const int n = s->window.shape->side[b].n;
  for (int i = 0; i < n; i++) rate[i] = fmax(0, rate[i]);
  const double pushed = area_on(s, b, rate);
  for (int i = 0; i < n && pushed > 0; i++) rate[i] *= area / pushed;
}

/* Takes the last step too. The pressures that belong to it are those of the linear model, whose
 * resultant is the load: volumes stay exact. Where that is not all of the forces, the plate feels
 * those on the cylinder. */
static void take_last(newton *s, double h, double *rate) {
  double *plate = rate + s->w->nc;
  const double *k = s->dose.k;
  for (int i = 0; i < s->n; i++)
    if (k_at(s, i) > 0) rate[i] = (s->z[i] - s->step[i] - s->known[i]) / h;
  const double upper = area_on(s, ARC_CYLINDER, rate), lower = area_on(s, ARC_PLATE, plate);
  const int both = k[ARC_CYLINDER] > 0 && k[ARC_PLATE] > 0 && !s->w->def.local_factor;
  const int counted = both && arc_wear_counts_forces(s->w);
  push_only(s, ARC_CYLINDER, upper, rate);
  push_only(s, ARC_PLATE, counted ? upper * (k[ARC_PLATE] / k[ARC_CYLINDER]) : lower, plate);
}

static double product(const double *a, const double *b, int n) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += a[i] * b[i];
  return sum;
}

/* What a kept Jacobian misses is mostly one mode, that of nodes which have entered the contact
 * since: the secant through the last two iterates (Anderson's, depth 1) takes it out. step becomes
 * the better one; defect is the plain one, of which `last` and `taken` are the previous. */
static void accelerate(newton *s, int it) {
  const size_t bytes = (size_t)s->n * sizeof(double);
  memcpy(s->step, s->defect, bytes);
  if (it > 0) {
    for (int i = 0; i < s->n; i++) s->last[i] = s->defect[i] - s->last[i];
    const double length = product(s->last, s->last, s->n);
    const double share = length > 0 ? product(s->defect, s->last, s->n) / length : 0;
    for (int i = 0; i < s->n; i++) s->step[i] -= share * (s->taken[i] + s->last[i]);
  }
  memcpy(s->last, s->defect, bytes);
  memcpy(s->taken, s->step, bytes);
}

/* With the Jacobian at hand. */
static arc_status solve_kept(newton *s, double h, double *rate) {
  const double least = allowed(s);
  double last = 0, first = 0;
  s->nearer = 0;
  for (int it = 0; it < kept_limit; it++) {
    residual_of(s, h, rate);
    memcpy(s->defect, s->residual, (size_t)s->n * sizeof(double));
    if (arc_newton_direction(s, h, s->defect) != ARC_OK) return ARC_NOT_CONVERGED;
    const double size = largest_of(s->defect, s->n), shrinks = it > 0 ? size / last : 0;
    if (it == 0) first = size;
    s->nearer = size < first;
    if (it > 0 && size <= 0.02 * least) return ARC_OK;
    if (it > 1 && shrinks > contraction) return ARC_NOT_CONVERGED;
    accelerate(s, it);
    if (it > 0 && fmax(shrinks, 0.02) * size <= least) {
      take_last(s, h, rate);
      return ARC_OK;
    }
    for (int i = 0; i < s->n; i++) s->z[i] -= s->step[i];
    const arc_status status = arc_newton_evaluate(s, rate, 0);
    if (status != ARC_OK) {
      s->nearer = 0;
      return hopeless(status) ? status : ARC_NOT_CONVERGED;
    }
    last = size;
  }
  return ARC_NOT_CONVERGED;
}

/* Along the step, halved until the residual falls. A contact that leaves its zone on the way counts
 * as no fall. */
static arc_status line_search(newton *s, double h, double *rate, double *size) {
  const double before = *size;
  double share = 1, last = 0;
  for (int half = 0; half <= halvings; half++, share /= 2) {
    for (int i = 0; i < s->n; i++) s->z[i] -= (share - last) * s->step[i];
    last = share;
    const arc_status status = arc_newton_evaluate(s, rate, 1);
    if (hopeless(status)) return status;
    if (status != ARC_OK) continue;
    *size = residual_of(s, h, rate);
    if (*size < before * (1 - 0.1 * share)) return ARC_OK;
  }
  return ARC_NOT_CONVERGED;
}

/* With the exact Jacobian of every iterate. */
static arc_status solve_exactly(newton *s, double h, double *rate) {
  s->jacobian.width = 0;
  arc_status status = arc_newton_evaluate(s, rate, 1);
  if (status != ARC_OK) return hopeless(status) ? status : ARC_NOT_CONVERGED;
  double size = residual_of(s, h, rate);
  const double least = 0.1 * allowed(s);
  for (int it = 0; it < newton_limit; it++) {
    if (size <= least) return ARC_OK;
    memcpy(s->step, s->residual, (size_t)s->n * sizeof(double));
    if (arc_newton_direction(s, h, s->step) != ARC_OK) return ARC_NOT_CONVERGED;
    if ((status = line_search(s, h, rate, &size)) != ARC_OK) return status;
  }
  return ARC_NOT_CONVERGED;
}

/* The energy goes with the wear: the last step was not evaluated any more. */
static void settle(newton *s, double h, const double *rate) {
  for (int i = 0; i < s->n; i++) s->z[i] = s->known[i] + h * rate[i];
  wear_by_z(s);
  if (s->area > 0) s->energy *= area_of(s, rate) / s->area;
}

/* A new Jacobian, at the iterate that an iteration left or, where that is no nearer, at its start.
 */
static arc_status renew(newton *s, double *rate) {
  if (!s->nearer) memcpy(s->z, s->start, (size_t)s->n * sizeof(double));
  return arc_newton_evaluate(s, rate, 1);
}

arc_status arc_newton_solve(newton *s, double h, double *rate) {
  memcpy(s->start, s->z, (size_t)s->n * sizeof(double));
  arc_status status = solve_kept(s, h, rate);
  if (status == ARC_NOT_CONVERGED) {
    status = renew(s, rate);
    if (status == ARC_OK) status = solve_kept(s, h, rate);
    if (status != ARC_OK && !hopeless(status)) status = ARC_NOT_CONVERGED;
  }
  if (status == ARC_NOT_CONVERGED) {
    if (!s->nearer) memcpy(s->z, s->start, (size_t)s->n * sizeof(double));
    status = solve_exactly(s, h, rate);
  }
  s->jacobian.width = s->coarse;
  if (status == ARC_OK) settle(s, h, rate);
  return status;
}

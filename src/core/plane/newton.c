/* Newton's method for the depths of both surfaces. The Jacobian and its factors are reused by
 * the stages of a step while the iteration converges fast. With a new Jacobian, a step is halved
 * until the residual decreases. */
#include "core/plane/newton.h"
#include "core/base/carve.h"
#include "core/base/dense.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { newton_limit = 15, halvings = 5 };
/* Largest accepted residual, divided by the largest depth. It is `tight` for a run without a
 * tolerance, otherwise the tolerance of the run times share_of_tolerance. */
static const double tight = 1e-8, share_of_tolerance = 5e-3;
/* Largest ratio of successive Newton steps for which the Jacobian is reused. */
static const double contraction = 0.4;

/* Returns the distance between the extreme plate positions in a block of loading [mm]. */
static double length_of(const wear_block *block) {
  double low = block->x[0], high = low;
  for (int i = 1; i < block->count; i++) {
    low = fmin(low, block->x[i]);
    high = fmax(high, block->x[i]);
  }
  return high - low;
}

/* Returns the width [mm] of a group of plate positions: two elements, but at most an eighth of the
 * path. The Jacobian uses one contact solution for the whole group. On a path of one element, the
 * method did not converge with a single group. */
static double group_width(const newton *s) {
  static const double elements = 2, parts = 8;
  const shape_side *plate = &s->at->window.shape->side[ARC_PLATE];
  return fmin(elements * arc_shape_width(plate, plate->n / 2),
              length_of(s->at->window.block) / parts);
}

/* Allocates the workspace for a moving contact. A contact at rest does not need this workspace. */
static arc_status create_moving(newton *s) {
  const size_t n = (size_t)s->n;
  const carve_part parts[] = {{&s->residual, n},  {&s->step, n}, {&s->packed, n},
                              {&s->defect, n},    {&s->last, n}, {&s->taken, n},
                              {&s->matrix, n * n}};
  s->pivots = malloc(2 * n * sizeof(int));
  s->jacobian = arc_tangent_create(s->at->run);
  if (!ARC_CARVE(parts) || !s->pivots || !s->jacobian) return ARC_MEMORY;
  s->node = s->pivots + n;
  s->jacobian->width = group_width(s);
  return ARC_OK;
}

static arc_status create_resting(newton *s) {
  const size_t n = (size_t)s->n;
  const carve_part parts[] = {{&s->residual, n}, {&s->step, n},  {&s->per_force, n},
                              {&s->opening, n},  {&s->moved, n}, {&s->force, n}};
  return ARC_CARVE(parts) ? arc_contact_problem_create(&s->with_wear, s->at->run->model)
                          : ARC_MEMORY;
}

/* Returns true if the depths remain exactly symmetric. With friction they are symmetric only up
 * to rounding errors. */
static int stays_mirrored(const wear_stage *stage) {
  const arc_wear *w = stage->run;
  if (arc_wear_rests_mirrored(w, &stage->window)) return 1;
  return !arc_wear_has_friction(&w->def) && !arc_wear_has_local_factors(w, &stage->window) &&
         arc_wear_is_mirrored(w, &stage->window);
}

arc_status arc_newton_begin(wear_stage *stage) {
  newton *s = stage->own = calloc(1, sizeof *s);
  if (!s) return ARC_MEMORY;
  s->at = stage;
  s->n = stage->run->nc + stage->run->np;
  s->rests = arc_stage_rests(stage);
  stage->window.depth = stage->worn;
  s->mirrored = stays_mirrored(stage);
  return s->rests ? create_resting(s) : create_moving(s);
}

static double k_at(const newton *s, int i) {
  return s->at->k[i < s->at->run->nc ? ARC_CYLINDER : ARC_PLATE];
}

/* Sets the depths of the shape to z, converted with the wear coefficients of the layers. */
static void wear_by_z(newton *s) {
  memcpy(s->at->worn, s->at->z, (size_t)s->n * sizeof *s->at->worn);
  arc_wear_into_layers(s->at->window.shape, s->at->worn);
}

double arc_newton_share(const newton *s, int i) {
  const int plate = i >= s->at->run->nc;
  return arc_wear_layer_share(s->at->window.shape, plate ? ARC_PLATE : ARC_CYLINDER,
                              plate ? i - s->at->run->nc : i, s->at->worn[i]);
}

static double largest_of(const double *v, int n) {
  double largest = 0;
  for (int i = 0; i < n; i++) largest = fmax(largest, fabs(v[i]));
  return largest;
}

/* Returns the cross-sectional area that one body loses per cycle [mm2]. */
static double area_on(const newton *s, arc_body b, const double *rate) {
  double sum = 0;
  for (int i = 0; i < s->at->window.shape->side[b].n; i++)
    sum += rate[i] * arc_shape_span(s->at->window.shape, b, i);
  return sum;
}

/* Returns the cross-sectional area that both bodies lose per cycle [mm2]. */
static double area_of(const newton *s, const double *rate) {
  return area_on(s, ARC_CYLINDER, rate) + area_on(s, ARC_PLATE, rate + s->at->run->nc);
}

arc_status arc_newton_evaluate(newton *s, double *rate, int with_jacobian) {
  wear_rate *here = &s->at->last;
  *here = (wear_rate){.node = {rate, rate + s->at->run->nc}};
  s->at->window.tangent = with_jacobian ? s->jacobian : NULL;
  wear_by_z(s);
  const arc_status status =
      arc_wear_evaluate(s->at->run, &s->at->window, s->at->progress, here, &s->at->error);
  if (status != ARC_OK) return status;
  if (with_jacobian) s->h = 0;
  for (int i = 0; i < s->n; i++) rate[i] *= k_at(s, i);
  s->area = here->energy > 0 ? area_of(s, rate) : 0;
  return ARC_OK;
}

/* --- the linear system ------------------------------------------------------------------------ */

/* Factorises I + h k J. The unknowns are the depths of the nodes that wear and were in contact. */
static arc_status factorise(newton *s, double h) {
  const double *rates = s->jacobian->value;
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

static arc_status direction(newton *s, double h, double *x) {
  if (s->h != h && factorise(s, h) != ARC_OK) return ARC_NUMERIC;
  for (int i = 0; i < s->live; i++) s->packed[i] = x[s->node[i]];
  arc_dense_factor_solve(s->live, 1, s->matrix, s->pivots, s->packed);
  for (int i = 0; i < s->live; i++) x[s->node[i]] = s->packed[i];
  if (s->mirrored) arc_wear_symmetrise(s->at->run, x);
  return ARC_OK;
}

/* --- a stage ---------------------------------------------------------------------------------- */

/* Computes residual = z - known - h rate. Returns the largest absolute value of an entry [mm]. */
double arc_newton_residual(newton *s, double h, const double *rate) {
  for (int i = 0; i < s->n; i++) s->residual[i] = s->at->z[i] - s->at->known[i] - h * rate[i];
  return largest_of(s->residual, s->n);
}

double arc_newton_allowed(const newton *s) {
  const double depth = fmax(arc_shape_depth(s->at->window.shape, ARC_CYLINDER),
                            arc_shape_depth(s->at->window.shape, ARC_PLATE));
  const double share =
      s->at->run->def.tolerance > 0 ? share_of_tolerance * s->at->run->def.tolerance : tight;
  return share * (depth + largest_of(s->at->worn, s->n));
}

int arc_newton_is_hopeless(const newton *s, arc_status status) {
  return (status == ARC_ZONE && arc_wear_has_outgrown(s->at->run, status)) ||
         status == ARC_STOPPED || status == ARC_CALLBACK || status == ARC_MEMORY;
}

/* Sets negative wear of nodes to zero and scales the positive wear to preserve the total `area`. */
static void push_only(const newton *s, arc_body b, double area, double *rate) {
  const int n = s->at->window.shape->side[b].n;
  for (int i = 0; i < n; i++) rate[i] = fmax(0, rate[i]);
  const double pushed = area_on(s, b, rate);
  for (int i = 0; i < n && pushed > 0; i++) rate[i] *= area / pushed;
}

/* Adds the last step to the rate. The worn volumes remain exact, because the linear model
 * preserves the sum of the pressures, which is the load. The wear of the plate is scaled to the
 * wear of the cylinder. Without this scaling the volume of the plate would have a relative error
 * of 2e-9, because the Jacobian uses one solution for several positions. */
static void take_last(newton *s, double h, double *rate) {
  double *plate = rate + s->at->run->nc;
  const double *k = s->at->k;
  for (int i = 0; i < s->n; i++)
    if (k_at(s, i) > 0) rate[i] = (s->at->z[i] - s->step[i] - s->at->known[i]) / h;
  const double upper = area_on(s, ARC_CYLINDER, rate), lower = area_on(s, ARC_PLATE, plate);
  const int both = k[ARC_CYLINDER] > 0 && k[ARC_PLATE] > 0 && !s->at->run->def.local_factor;
  const int alike = both && !s->at->run->manner.even;
  push_only(s, ARC_CYLINDER, upper, rate);
  push_only(s, ARC_PLATE, alike ? upper * (k[ARC_PLATE] / k[ARC_CYLINDER]) : lower, plate);
}

static double product(const double *a, const double *b, int n) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += a[i] * b[i];
  return sum;
}

/* Improves the Newton step. The error of a reused Jacobian is mostly one mode, which is due to
 * nodes that have entered the contact since the Jacobian was computed. A secant through the last
 * two iterates (Anderson's method, depth 1) removes this mode. On input `defect` is the Newton
 * step, `last` the previous Newton step and `taken` the previous accepted step. On return `step`
 * is the improved step. */
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
}

/* Computes the residual of an iterate and the Newton step `defect`. Sets *size to the largest
 * absolute value in the Newton step. */
static arc_status find_defect(newton *s, double h, const double *rate, double *size) {
  arc_newton_residual(s, h, rate);
  memcpy(s->defect, s->residual, (size_t)s->n * sizeof(double));
  const arc_status status = direction(s, h, s->defect);
  *size = largest_of(s->defect, s->n);
  return status;
}

/* Makes the step and halves it until the residual decreases, at most `most` times. If the
 * contact leaves its zone, the step is halved as well. */
static arc_status walk(newton *s, double h, double *rate, int most) {
  const double before = arc_newton_residual(s, h, rate);
  double share = 1, last = 0;
  arc_status status = ARC_NOT_CONVERGED;
  for (int half = 0; half <= most; half++, share /= 2) {
    for (int i = 0; i < s->n; i++) s->at->z[i] -= (share - last) * s->step[i];
    last = share;
    status = arc_newton_evaluate(s, rate, 0);
    if (arc_newton_is_hopeless(s, status)) return status;
    if (status == ARC_OK && arc_newton_residual(s, h, rate) < before * (1 - 0.1 * share)) break;
  }
  for (int i = 0; i < s->n; i++) s->taken[i] = last * s->step[i];
  return status;
}

/* Solves a stage for a moving contact. Iterates with the present Jacobian while the convergence
 * is fast, and then with a new Jacobian. */
static arc_status solve_moving(newton *s, double h, double *rate) {
  double last = 0, size;
  for (int it = 0, since = 0; it < newton_limit; it++, since++) {
    arc_status status = find_defect(s, h, rate, &size);
    if (status == ARC_OK && since > 0 && size > contraction * last) {
      since = 0;
      status = arc_newton_evaluate(s, rate, 1);
      if (status == ARC_OK) status = find_defect(s, h, rate, &size);
    }
    if (status != ARC_OK) return status;
    const double least = arc_newton_allowed(s), shrinks = since > 0 ? size / last : 1;
    if (it > 0 && size <= 0.02 * least) return ARC_OK;
    accelerate(s, since);
    if (since > 0 && fmax(shrinks, 0.02) * size <= least) {
      take_last(s, h, rate);
      return ARC_OK;
    }
    status = walk(s, h, rate, since == 0 ? halvings : 0);
    if (status != ARC_OK) return status;
    last = size;
  }
  return ARC_NOT_CONVERGED;
}

/* Scales the energy and the uniform wear in proportion to the total wear, because the wear is
 * not evaluated again after the last step. */
static void settle(newton *s, double h, const double *rate) {
  for (int i = 0; i < s->n; i++) s->at->z[i] = s->at->known[i] + h * rate[i];
  wear_by_z(s);
  const double share = s->area > 0 ? area_of(s, rate) / s->area : 1;
  s->at->last.energy *= share;
  s->at->last.even *= share;
}

arc_status arc_newton_solve(wear_stage *stage, double h, double *rate) {
  newton *s = stage->own;
  const arc_status status = s->rests ? arc_stage_solve_rest(s, h, rate) : solve_moving(s, h, rate);
  if (status == ARC_OK) settle(s, h, rate);
  return status == ARC_OK || arc_newton_is_hopeless(s, status) ? status : ARC_NOT_CONVERGED;
}

arc_status arc_newton_start(wear_stage *stage, double *rate) {
  newton *s = stage->own;
  return arc_newton_evaluate(s, rate, !s->rests);
}

/* --- the error -------------------------------------------------------------------------------- */

/* Returns the relative change of the contact forces of problem `p` due to the errors `off` of the
 * wear depths of both bodies. */
static double shifted_by(newton *s, contact_problem *p, const double *off) {
  double *below = plane_of(s->at->run)->below;
  arc_contact_problem_to_cylinder(p, off + s->at->run->nc, below);
  for (int k = 0; k < p->active; k++) {
    const int i = p->lo + p->set[k];
    s->packed[k] = off[i] + below[i];
  }
  return arc_stage_forces(p, s->packed);
}

/* Returns the largest relative change of the contact forces due to the errors `off` of the wear
 * depths. It is computed from the last solutions at both ends and in the middle of the path.
 * Returns 0 for runs in closed form, which have no path and in which the pressures do not depend on
 * the depths. */
static double largest_shift(newton *s, const double *off) {
  if (s->at->run->manner.closed) return 0;
  const wear_block *block = path_of(s->at->run)->block;
  const int first = s->at->window.first, last = s->at->window.last;
  const int points[] = {first, first + (last - first) / 2, last};
  double largest = 0;
  for (int i = 0; i < 3; i++) {
    contact_problem *p = &path_of(s->at->run)->problem[block->problem_of[points[i]]];
    if (block->line[points[i]] > 0 && p->active > 0 && !arc_lcp_factorise(p))
      largest = fmax(largest, shifted_by(s, p, off));
  }
  return largest;
}

double arc_newton_error(wear_stage *stage, double h, double *defect) {
  newton *s = stage->own;
  if (s->rests) return arc_stage_rest_error(s, defect);
  if (direction(s, h, defect) != ARC_OK) return -1;
  for (int i = 0; i < s->n; i++) defect[i] *= arc_newton_share(s, i);
  return largest_shift(s, defect);
}

/* --- the end ---------------------------------------------------------------------------------- */

/* Returns the integral of the normal force over the sliding distance, per thickness [N]. The
 * integral is computed from the depths if they determine it, because the last step is not solved
 * again. Otherwise it is the integral of the last evaluation. */
static double pressed_of(const wear_stage *s, double cycles, const wear_depths *depth) {
  const arc_wear_def *d = &s->run->def;
  const int b = s->k[ARC_CYLINDER] > 0 ? ARC_CYLINDER : ARC_PLATE;
  if (!(arc_law_properties[d->law] & ARC_LAW_LINEAR) || d->local_factor || !(s->k[b] > 0))
    return cycles * s->last.pressed;
  double sum = 0;
  for (int i = 0; i < s->window.shape->side[b].n; i++)
    sum += depth->node[b][i] * arc_shape_span(s->window.shape, (arc_body)b, i);
  return sum / s->k[b];
}

void arc_newton_end(wear_stage *stage, double cycles, wear_depths *depth) {
  newton *s = stage->own;
  if (depth) depth->pressed = pressed_of(stage, cycles, depth);
  if (!s) return;
  free(s->residual);
  free(s->pivots);
  arc_contact_problem_free(&s->with_wear);
  if (s->jacobian) arc_tangent_free(&s->jacobian);
  free(s);
}

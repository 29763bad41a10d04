/* Solves for stick and slip over a contact: chooses the sets of sticking and slipping cells and
 * the directions of slip. */
#include "core/space/stick_slip.h"

#include "core/base/callbacks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

arc_status arc_stick_slip_begin(stick_slip_work *w, int cells, arc_error *error) {
  enum { fields = 19 };
  const size_t n = (size_t)cells;
  *w = (stick_slip_work){.block = calloc(fields * n, sizeof *w->block),
                         .state = calloc(n, sizeof *w->state),
                         .site = calloc(n, sizeof *w->site)};
  if (!w->block || !w->state || !w->site) {
    arc_stick_slip_end(w);
    return arc_fail(error, ARC_MEMORY, "out of memory for the shear of %d cells", cells);
  }
  double **const pair[] = {w->q, w->slip, w->tangent,  w->r,       w->z,
                           w->d, w->a,    w->shape[0], w->shape[1]},
                 *at = w->block;
  for (size_t k = 0; k < sizeof pair / sizeof *pair; k++)
    for (int i = 0; i < 2; i++, at += n) pair[k][i] = at;
  w->diagonal = at;
  return ARC_OK;
}

void arc_stick_slip_end(stick_slip_work *w) {
  free(w->block);
  free(w->state);
  free(w->site);
  *w = (stick_slip_work){.block = NULL};
}

/* --- cells ------------------------------------------------------------------------------------ */

static double size_of(double *const v[2], int k) {
  return hypot(v[0][k], v[1][k]);
}

static void scale(stick_slip_work *w, int k, double factor) {
  w->q[0][k] *= factor;
  w->q[1][k] *= factor;
}

/* Scales q of a slipping cell back to the friction circle, and sets the tangent of the cell. */
static void round_cell(stick_slip_work *w, int k, double bound) {
  const double q = size_of(w->q, k);
  if (!(q > 0)) return;
  w->tangent[0][k] = -w->q[1][k] / q;
  w->tangent[1][k] = w->q[0][k] / q;
  scale(w, k, bound / q);
}

/* Sets the initial states of the cells. A cell slips if its shear is outside the friction circle,
 * or if it slipped before, unless the friction limit has more than doubled since then. */
static void start(const stick_slip_problem *p, stick_slip_work *w) {
  static const double least = 0.5;
  for (int k = 0; k < p->h->cells; k++) {
    const double q = size_of(w->q, k), bound = p->bound[k];
    if (bound == 0) {
      w->state[k] = SHEAR_NONE;
      scale(w, k, 0);
    } else if (q > bound || (w->state[k] == SHEAR_SLIP && q > least * bound)) {
      w->state[k] = SHEAR_SLIP;
      round_cell(w, k, bound);
    } else {
      w->state[k] = SHEAR_STICK;
    }
  }
}

/* Returns the ratio |q| / bound above which a cell starts to slip. Under a given force some cells
 * must stick. If all cells are outside the friction circle, only those farthest outside start to
 * slip. */
static double limit_of(const stick_slip_problem *p, const stick_slip_work *w) {
  double least = INFINITY, most = 0;
  for (int k = 0; k < p->h->cells; k++)
    if (w->state[k] == SHEAR_STICK) {
      least = fmin(least, size_of(w->q, k) / p->bound[k]);
      most = fmax(most, size_of(w->q, k) / p->bound[k]);
    }
  const int forced = p->by_force[0] || p->by_force[1];
  return forced && least > 1 && most > 0 ? (least + most) / 2 : 1;
}

/* Sets sticking cells above the friction limit to slip, and marks them in `fresh`. Returns their
 * number. */
static int begin_slip(const stick_slip_problem *p, stick_slip_work *w, char *fresh) {
  const double limit = limit_of(p, w);
  int changes = 0;
  for (int k = 0; k < p->h->cells; k++) {
    fresh[k] = 0;
    if (w->state[k] == SHEAR_NONE) continue;
    const double q = size_of(w->q, k);
    if (w->state[k] == SHEAR_STICK && q <= p->bound[k]) continue;
    if (w->state[k] == SHEAR_STICK && q > limit * p->bound[k]) {
      w->state[k] = SHEAR_SLIP;
      fresh[k] = 1;
      changes++;
    }
    round_cell(w, k, p->bound[k]);
  }
  return changes;
}

/* Computes the slip at the cells of a box from the present q and xi. Returns the largest
 * displacement C q [mm]. */
static double find_slip(const stick_slip_problem *p, const space_box *box, stick_slip_work *w,
                        stick_slip_count *count) {
  double most = 0;
  arc_cerruti_shear_in(p->h, box, (const double *const[2]){w->q[0], w->q[1]}, w->a);
  count->applications++;
  for (int i = 0; i < 2; i++)
    for (int k = 0; k < p->h->cells; k++) {
      most = fmax(most, fabs(w->a[i][k]));
      w->slip[i][k] = p->known[i][k] + w->xi[i] - w->a[i][k];
    }
  return most;
}

/* Sets slipping cells to stick if their slip is opposite to their shear and larger than `nothing`
 * [mm], except cells in `fresh`. Computes the diagonal of the cells that continue to slip. Returns
 * the number of cells changed. */
static int end_slip(const stick_slip_problem *p, stick_slip_work *w, double nothing,
                    const char *fresh) {
  int changes = 0;
  for (int k = 0; k < p->h->cells; k++) {
    if (w->state[k] != SHEAR_SLIP) continue;
    const double along = w->slip[0][k] * w->tangent[1][k] - w->slip[1][k] * w->tangent[0][k];
    if (along < -nothing && !fresh[k]) {
      w->state[k] = SHEAR_STICK;
      changes++;
      continue;
    }
    w->diagonal[k] = fmax(along, 0) / p->bound[k];
  }
  return changes;
}

/* --- active-set iteration --------------------------------------------------------------------- */

/* Computes `missed`, the errors of the given forces along x and z divided by the friction limit.
 * Returns the larger error. */
static double force_error(const stick_slip_problem *p, const stick_slip_work *w, double missed[2]) {
  const double area = p->h->def.size_x * p->h->def.size_z;
  double sum[2] = {0, 0}, carried = 0;
  for (int k = 0; k < p->h->cells; k++) {
    sum[0] += w->q[0][k];
    sum[1] += w->q[1][k];
    carried += p->bound[k];
  }
  for (int i = 0; i < 2; i++)
    missed[i] = p->by_force[i] ? (p->force[i] / area - sum[i]) / carried : 0;
  return fmax(fabs(missed[0]), fabs(missed[1]));
}

static void stick_all(const stick_slip_problem *p, stick_slip_work *w) {
  for (int k = 0; k < p->h->cells; k++) w->state[k] = p->bound[k] > 0 ? SHEAR_STICK : SHEAR_NONE;
}

static arc_status check_forces(const stick_slip_problem *p, arc_error *error) {
  const double area = p->h->def.size_x * p->h->def.size_z;
  const double force = hypot(p->by_force[0] ? p->force[0] : 0, p->by_force[1] ? p->force[1] : 0);
  double carried = 0;
  for (int k = 0; k < p->h->cells; k++) carried += p->bound[k] * area;
  if (force < carried || force == 0) return ARC_OK;
  return arc_fail(error, ARC_ARGUMENT,
                  "field 'tangential': expected less than friction times the load, %g N, got %g N",
                  carried, force);
}

static int carrying(const stick_slip_problem *p) {
  int n = 0;
  for (int k = 0; k < p->h->cells; k++) n += p->bound[k] > 0;
  return n;
}

static arc_status iterate(const stick_slip_problem *p, stick_slip_work *w, char *fresh,
                          stick_slip_count *count, arc_error *error) {
  enum { most_sets = 60, patience = 25 };
  static const double few = 0.03, unsettled = 0.3, settled = 0.01;
  static const double rounding = 1e-14; /* force error that needs no Newton step at all */
  const int cells = carrying(p);
  double missed, each[2];
  for (int pass = 0; pass < most_sets; pass++) {
    const arc_status status = callbacks_check(p->callbacks, error);
    if (status != ARC_OK) return status;
    int changes = begin_slip(p, w, fresh);
    missed = force_error(p, w, each);
    if (!arc_stick_slip_set_forces(p, w)) {
      stick_all(p, w);
      arc_stick_slip_set_forces(p, w);
    }
    const double wanted = p->tolerance * find_slip(p, &w->box, w, count);
    arc_stick_slip_move(p, w);
    changes += end_slip(p, w, wanted, fresh);
    const double residual = arc_stick_slip_residual(p, w);
    const int held = missed <= (pass == 0 ? rounding : p->tolerance);
    const int solved = held && residual <= wanted;
    count->sets++;
    if (changes == 0 && solved) return ARC_OK;
    if (pass >= patience && held && changes <= few * cells) {
      count->flipping++;
      return ARC_OK;
    }
    const double share = changes == 0 ? settled : unsettled;
    arc_stick_slip_newton(p, w, share, wanted / 2, count);
  }
  return arc_fail(
      error, ARC_NOT_CONVERGED,
      "stick and slip did not converge in %d iterations: relative error of the force %.2g",
      most_sets, missed);
}

/* --- iteration for the motion ----------------------------------------------------------------- */

/* Returns the mean displacement along an axis [mm] if the shear of all cells equals the friction
 * limit. The mean is weighted by this limit. */
static double yielding(const stick_slip_problem *p, stick_slip_work *w, int axis) {
  double sum = 0, product = 0;
  for (int k = 0; k < p->h->cells; k++) {
    w->d[axis][k] = p->bound[k];
    w->d[1 - axis][k] = 0;
  }
  arc_cerruti_shear_in(p->h, &w->box, (const double *const[2]){w->d[0], w->d[1]}, w->a);
  for (int k = 0; k < p->h->cells; k++) {
    sum += p->bound[k];
    product += p->bound[k] * w->a[axis][k];
  }
  return product / sum;
}

/* Updates the approximate inverse Hessian by the BFGS formula for a step of the motion and the
 * resulting change of the force error. */
static void update(double inverse[2][2], const double step[2], const double change[2]) {
  const double along = -(step[0] * change[0] + step[1] * change[1]);
  double y[2] = {-change[0], -change[1]}, left[2], curved;
  if (!(along > 0)) return;
  for (int i = 0; i < 2; i++) left[i] = inverse[i][0] * y[0] + inverse[i][1] * y[1];
  curved = 1 + (y[0] * left[0] + y[1] * left[1]) / along;
  for (int i = 0; i < 2; i++)
    for (int j = 0; j < 2; j++)
      inverse[i][j] += (curved * step[i] * step[j] - step[i] * left[j] - left[i] * step[j]) / along;
}

/* Motions along one axis that are known to be too small and too large, because the force increases
 * with the motion. */
typedef struct bracket {
  double low, high;
} bracket;

/* Narrows the bracket by the motion xi, whose force is too small by `missed`. Returns the step from
 * xi to the next motion: the given step, or to the middle of the bracket if this step ends outside
 * it. */
static double step_within(bracket *b, double xi, double missed, double step) {
  if (missed > 0)
    b->low = xi;
  else
    b->high = xi;
  const double next = xi + step;
  if (!(next <= b->low || next >= b->high)) return step;
  return isfinite(b->high - b->low) ? (b->low + b->high) / 2 - xi : step;
}

/* Computes the motion that causes the given forces. The forces are the gradient of a convex
 * function of the motion. This slower method is used for forces near gross slip, where the sets may
 * not converge. */
static arc_status find_motion(const stick_slip_problem *forced, stick_slip_work *w, char *fresh,
                              stick_slip_count *count, arc_error *error) {
  enum { most_motions = 100 };
  static const double finer = 0.1; /* so that the force follows small changes of the motion */
  stick_slip_problem p = *forced;
  double inverse[2][2] = {{yielding(&p, w, 0), 0}, {0, yielding(&p, w, 1)}};
  double before[2] = {0, 0}, missed[2], step[2] = {0, 0};
  const int single = forced->by_force[0] != forced->by_force[1];
  bracket within = {-INFINITY, INFINITY};
  p.by_force[0] = p.by_force[1] = 0;
  p.tolerance *= finer;
  for (int k = 0; k < most_motions; k++) {
    const arc_status status = iterate(&p, w, fresh, count, error);
    if (status != ARC_OK) return status;
    if (force_error(forced, w, missed) <= forced->tolerance) return ARC_OK;
    if (k > 0)
      update(inverse, step, (const double[2]){missed[0] - before[0], missed[1] - before[1]});
    for (int i = 0; i < 2; i++) {
      before[i] = missed[i];
      step[i] = forced->by_force[i] ? inverse[i][0] * missed[0] + inverse[i][1] * missed[1] : 0;
    }
    for (int i = 0; i < 2; i++) {
      if (single && forced->by_force[i])
        step[i] = step_within(&within, w->xi[i], missed[i], step[i]);
      w->xi[i] += step[i];
    }
  }
  return arc_fail(error, ARC_NOT_CONVERGED,
                  "the motion under the tangential force did not converge: the force is off by "
                  "%.2g of friction times the load; near full slip, prescribe a motion instead",
                  fmax(fabs(missed[0]), fabs(missed[1])));
}

/* Chooses the box of the cells that may carry shear. */
static arc_status choose_box(const stick_slip_problem *p, stick_slip_work *w, arc_error *error) {
  space_range x = {0, -1}, z = {0, -1};
  for (int i = 0; i < 2; i++) memset(w->a[i], 0, (size_t)p->h->cells * sizeof *w->a[i]);
  arc_space_find_range(p->h, p->bound, &x, &z);
  w->box = arc_space_box(p->h, x, z, 0, 0);
  return arc_cerruti_in_box(p->h, &w->box, error);
}

arc_status arc_stick_slip_solve(const stick_slip_problem *p, stick_slip_work *w,
                                stick_slip_count *count, arc_error *error) {
  const space_box window = arc_space_window(p->h);
  arc_status status = check_forces(p, error);
  if (status == ARC_OK) status = choose_box(p, w, error);
  if (status != ARC_OK) return status;
  char *fresh = calloc((size_t)p->h->cells, 1);
  if (!fresh) return arc_fail(error, ARC_MEMORY, "out of memory for the shear of a contact");
  const double xi[2] = {w->xi[0], w->xi[1]};
  start(p, w);
  status = iterate(p, w, fresh, count, error);
  if (status == ARC_NOT_CONVERGED && (p->by_force[0] || p->by_force[1])) {
    w->xi[0] = xi[0];
    w->xi[1] = xi[1];
    status = find_motion(p, w, fresh, count, error);
  }
  if (status == ARC_OK) find_slip(p, &window, w, count);
  free(fresh);
  return status;
}

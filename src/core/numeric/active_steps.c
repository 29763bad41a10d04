/* Implements the operations of the active set method: loads, residuals, and conjugate gradients on
 * an active set. */
#include "core/base/dense.h"
#include "core/numeric/active_work.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
  most_steps =
      400 /* largest number of steps of conjugate gradients between two checks of the active set */
};

/* --- workspace -------------------------------------------------------------------------------- */

void arc_active_work_destroy(active_work **work) {
  active_work *w = *work;
  *work = NULL;
  if (!w) return;
  free(w->g);
  free(w->mode);
  free(w->gram);
  free(w->changes);
  free(w->hash);
  free(w);
}

static int has_all(const active_work *w) {
  return w->g && w->mode && w->gram && w->changes && w->hash;
}

active_work *arc_active_work_create(int blocks, int cells, int modes, int preconditioned) {
  const size_t all = (size_t)blocks * (size_t)cells, n = (size_t)blocks, m = (size_t)modes;
  active_work *w = calloc(1, sizeof *w);
  if (!w) return NULL;
  *w = (active_work){.blocks = blocks, .cells = cells, .modes = modes};
  w->g = malloc(all * (5 + (preconditioned ? 1 + m : 0)) * sizeof *w->g);
  w->mode = malloc(2 * (size_t)cells * sizeof *w->mode);
  w->gram = malloc((2 * n * m * m + n * m + 2 * n) * sizeof *w->gram);
  w->changes = malloc(2 * n * sizeof *w->changes);
  w->hash = malloc(n * sizeof *w->hash);
  if (!has_all(w)) {
    arc_active_work_destroy(&w);
    return NULL;
  }
  w->r = w->g + all;
  w->d = w->r + all;
  w->q = w->d + all;
  w->area = w->q + all;
  w->z = preconditioned ? w->area + all : w->r;
  w->y = preconditioned ? w->z + all : NULL;
  w->whole = w->mode + cells;
  for (int k = 0; k < 2 * cells; k++) w->mode[k] = 1;
  w->oblique = w->gram + n * m * m;
  w->delta = w->oblique + n * m * m;
  w->sum = w->delta + n * m;
  w->largest = w->sum + n;
  w->singular = w->changes + n;
  return w;
}

const double *arc_active_set_gaps(const active_work *w) {
  return w->g;
}

void arc_active_run(const pass *s, team_task task) {
  arc_team_run(s->problem->team, s->problem->blocks, task, (void *)s);
}

const double *arc_active_mode(const pass *s, int j) {
  const double *mode = s->problem->mode;
  return mode ? mode + (size_t)j * (size_t)s->problem->cells : s->w->mode;
}

const double *arc_active_areas(const pass *s) {
  return s->problem->area ? s->problem->area : s->w->whole;
}

double arc_active_weight(const active_problem *p, int block) {
  return p->weight ? p->weight[block] : 1;
}

double arc_active_total(const pass *s) {
  double sum = 0;
  for (int b = 0; b < s->problem->blocks; b++)
    sum += arc_active_weight(s->problem, b) * s->w->sum[b];
  return sum;
}

int arc_active_changes(const pass *s) {
  int changes = 0;
  for (int b = 0; b < s->problem->blocks; b++) changes += s->w->changes[b];
  return changes;
}

double arc_active_gap(const pass *s, int block, int cell) {
  const active_work *w = s->w;
  const int m = s->problem->modes;
  double gap = w->g[active_at(s, block) + (size_t)cell];
  for (int i = 0; i < m; i++) gap -= w->delta[block * m + i] * arc_active_mode(s, i)[cell];
  return gap;
}

/* --- small systems of the rigid unknowns ------------------------------------------------------ */

enum { square = ARC_MOST_MODES * ARC_MOST_MODES };

/* Computes the inverse of a positive definite matrix a [m x m], and overwrites `a`. Returns a
 * non-zero value if `a` is singular. */
static int invert(int m, double *a, double *inverse) {
  if (m == 1) {
    inverse[0] = 1 / a[0];
    return !(a[0] > 0);
  }
  if (arc_dense_cholesky(m, a, m)) return 1;
  arc_dense_cholesky_invert(m, a, inverse);
  return 0;
}

/* Computes x = inverse b. */
static void times(int m, const double *inverse, const double *b, double *x) {
  for (int i = 0; i < m; i++) {
    x[i] = 0;
    for (int j = 0; j < m; j++) x[i] += inverse[dense_at(i, j, m)] * b[j];
  }
}

/* Computes the inverse of the matrix N' y, with sums over the cells weighted by `area`. y is
 * [modes][cells]; if y is NULL, the modes N replace it. Returns a non-zero value if the matrix is
 * singular. */
static int invert_gram(const pass *s, const double *area, const double *y, double *inverse) {
  const int m = s->problem->modes, n = s->problem->cells;
  double a[square];
  for (int i = 0; i < m; i++)
    for (int j = 0; j < m; j++) {
      const double *other = y ? y + (size_t)j * (size_t)n : arc_active_mode(s, j);
      a[dense_at(i, j, m)] = arc_cells_dot3(n, area, arc_active_mode(s, i), other);
    }
  return invert(m, a, inverse);
}

/* Computes x = inverse N' v. The sums over the cells are weighted by `area`. */
static void fit_modes(const pass *s, const double *area, const double *inverse, const double *v,
                      double *x) {
  const int m = s->problem->modes;
  double b[ARC_MOST_MODES];
  for (int i = 0; i < m; i++)
    b[i] = arc_cells_dot3(s->problem->cells, area, arc_active_mode(s, i), v);
  times(m, inverse, b, x);
}

static size_t gram_at(const pass *s, int block) {
  return (size_t)(block * s->problem->modes * s->problem->modes);
}

void arc_active_restore_load(void *context, int block, int worker) {
  const pass *s = context;
  const int m = s->problem->modes, n = s->problem->cells;
  double *p = s->p + active_at(s, block), miss[ARC_MOST_MODES], x[ARC_MOST_MODES];
  double a[square], inverse[square];
  (void)worker;
  for (int i = 0; i < m; i++) {
    const double *mode = arc_active_mode(s, i);
    miss[i] = s->problem->load[block * m + i] - arc_cells_dot3(n, arc_active_areas(s), mode, p);
    for (int j = 0; j < m; j++)
      a[dense_at(i, j, m)] = arc_cells_dot4(n, arc_active_areas(s), mode, arc_active_mode(s, j), p);
  }
  s->w->singular[block] = invert(m, a, inverse);
  if (s->w->singular[block]) return;
  times(m, inverse, miss, x);
  for (int k = 0; k < n; k++) {
    double share = 1;
    for (int i = 0; i < m; i++) share += x[i] * arc_active_mode(s, i)[k];
    p[k] *= share > 0 ? share : 0;
  }
}

/* --- tasks of one block ----------------------------------------------------------------------- */

void arc_active_mark(void *context, int block, int worker) {
  const pass *s = context;
  const double *p = s->p + active_at(s, block);
  double *area = s->w->area + active_at(s, block);
  (void)worker;
  for (int k = 0; k < s->problem->cells; k++) area[k] = p[k] > 0 ? arc_active_areas(s)[k] : 0;
}

/* Returns the rounding error of the gaps on the active set. Iterations cannot reduce the residual
 * below this value. */
static double rounding_of(const pass *s, size_t o) {
  const double *gap = s->problem->gap + o, *area = s->w->area + o;
  double largest = 0;
  for (int k = 0; k < s->problem->cells; k++)
    if (area[k] > 0) largest = fmax(largest, fabs(gap[k]));
  return 16 * DBL_EPSILON * largest;
}

/* Adds `gap` to g, which contains A p before the call. Stores the largest displacement |A p| in
 * w->largest. The stored value has a lower limit, so that the tolerance of gaps is never below the
 * rounding error. */
static void add_gap(void *context, int block, int worker) {
  const pass *s = context;
  const size_t o = active_at(s, block);
  (void)worker;
  const double moved = arc_cells_add_gap(s->problem->cells, s->problem->gap + o, s->w->g + o);
  s->w->largest[block] = fmax(moved, rounding_of(s, o) / s->problem->tolerance);
}

void arc_active_factor(void *context, int block, int worker) {
  const pass *s = context;
  active_work *w = s->w;
  const size_t o = active_at(s, block), m = (size_t)s->problem->modes, g = gram_at(s, block);
  (void)worker;
  w->singular[block] = invert_gram(s, w->area + o, NULL, w->gram + g);
  if (w->y && !w->singular[block])
    w->singular[block] = invert_gram(s, w->area + o, w->y + m * o, w->oblique + g);
}

void arc_active_residual(void *context, int block, int worker) {
  const pass *s = context;
  active_work *w = s->w;
  const int n = s->problem->cells;
  const size_t o = active_at(s, block);
  double *delta = w->delta + (size_t)(block * s->problem->modes);
  (void)worker;
  fit_modes(s, w->area + o, w->gram + gram_at(s, block), w->g + o, delta);
  if (!s->problem->mode) {
    w->sum[block] = arc_cells_residual(n, w->area + o, w->g + o, delta[0], w->r + o);
    return;
  }
  for (int k = 0; k < n; k++)
    w->r[o + (size_t)k] = w->area[o + (size_t)k] > 0 ? arc_active_gap(s, block, k) : 0;
  w->sum[block] = arc_cells_dot3(n, w->area + o, w->r + o, w->r + o);
}

void arc_active_project(const pass *s, int block, double *x) {
  const int m = s->problem->modes, n = s->problem->cells;
  const double *area = s->w->area + active_at(s, block);
  double share[ARC_MOST_MODES];
  fit_modes(s, area, s->w->gram + gram_at(s, block), x, share);
  for (int k = 0; k < n; k++) {
    for (int i = 0; i < m; i++) x[k] -= share[i] * arc_active_mode(s, i)[k];
    if (area[k] == 0) x[k] = 0;
  }
}

static void mask(void *context, int block, int worker) {
  const pass *s = context;
  const size_t o = active_at(s, block);
  (void)worker;
  for (size_t k = o; k < o + (size_t)s->problem->cells; k++)
    if (s->w->area[k] == 0) s->w->z[k] = 0;
}

/* Subtracts a combination of y from z, the preconditioned residual, so that z does not change the
 * loads. Stores the product r z in w->sum. */
static void project_oblique(void *context, int block, int worker) {
  const pass *s = context;
  active_work *w = s->w;
  const int m = s->problem->modes, n = s->problem->cells;
  const size_t o = active_at(s, block);
  double share[ARC_MOST_MODES];
  mask(context, block, worker);
  fit_modes(s, w->area + o, w->oblique + gram_at(s, block), w->z + o, share);
  for (int i = 0; i < m; i++)
    arc_cells_add(n, -share[i], w->y + (size_t)m * o + (size_t)i * (size_t)n, w->z + o);
  w->sum[block] = arc_cells_dot3(n, w->area + o, w->r + o, w->z + o);
}

static void turn(void *context, int block, int worker) {
  const pass *s = context;
  const size_t o = active_at(s, block);
  (void)worker;
  if (s->factor == 0) memset(s->w->d + o, 0, (size_t)s->problem->cells * sizeof(double));
  arc_cells_turn(s->problem->cells, s->factor, s->w->z + o, s->w->d + o);
}

void arc_active_curvature(void *context, int block, int worker) {
  const pass *s = context;
  const size_t o = active_at(s, block);
  (void)worker;
  s->w->sum[block] =
      arc_cells_dot3(s->problem->cells, arc_active_areas(s), s->w->d + o, s->w->q + o);
}

static void advance(void *context, int block, int worker) {
  const pass *s = context;
  const int n = s->problem->cells;
  const size_t o = active_at(s, block);
  arc_cells_add(n, s->factor, s->w->d + o, s->p + o);
  arc_cells_add(n, s->factor, s->w->q + o, s->w->g + o);
  arc_active_residual(context, block, worker);
}

/* --- all blocks ------------------------------------------------------------------------------- */

arc_status arc_active_apply(const pass *s, const double *from, double *to, active_count *count) {
  count->applications++;
  return s->problem->apply(s->problem->context, from, to);
}

arc_status arc_active_check(const pass *s, arc_error *error) {
  for (int b = 0; b < s->problem->blocks; b++)
    if (s->w->singular[b])
      return arc_fail(error, ARC_NUMERIC, "position %d: the contact cannot carry its load", b + 1);
  return ARC_OK;
}

arc_status arc_active_gaps(const pass *s, double *limit, active_count *count, arc_error *error) {
  const active_work *w = s->w;
  double largest = 0;
  arc_active_run(s, arc_active_restore_load);
  arc_status status = arc_active_check(s, error);
  if (status == ARC_OK) status = arc_active_apply(s, s->p, w->g, count);
  if (status != ARC_OK) return status;
  arc_active_run(s, add_gap);
  for (int b = 0; b < s->problem->blocks; b++) largest = fmax(largest, w->largest[b]);
  *limit = s->problem->tolerance * largest;
  return isfinite(largest) ? ARC_OK : arc_fail(error, ARC_NUMERIC, "the pressures are not finite");
}

/* Applies the preconditioner to the modes on the active set. The result is y, which is zero outside
 * the set. */
static arc_status precondition_modes(const pass *s) {
  active_work *w = s->w;
  const int m = s->problem->modes, n = s->problem->cells, blocks = s->problem->blocks;
  for (int i = 0; i < m; i++) {
    for (int b = 0; b < blocks; b++)
      for (int k = 0; k < n; k++) {
        const size_t c = active_at(s, b) + (size_t)k;
        w->q[c] = w->area[c] > 0 ? arc_active_mode(s, i)[k] : 0;
      }
    const arc_status status = s->problem->precondition(s->problem->context, w->q, w->z);
    if (status != ARC_OK) return status;
    arc_active_run(s, mask);
    for (int b = 0; b < blocks; b++)
      memcpy(w->y + (size_t)m * active_at(s, b) + (size_t)i * (size_t)n, w->z + active_at(s, b),
             (size_t)n * sizeof *w->y);
  }
  return ARC_OK;
}

arc_status arc_active_begin(const pass *s, arc_error *error) {
  arc_status status = s->w->y ? precondition_modes(s) : ARC_OK;
  if (status != ARC_OK) return status;
  arc_active_run(s, arc_active_factor);
  status = arc_active_check(s, error);
  if (status == ARC_OK) arc_active_run(s, arc_active_residual);
  return status;
}

double arc_active_rms(const pass *s) {
  const int n = s->problem->cells;
  double area = 0;
  for (int b = 0; b < s->problem->blocks; b++)
    area += arc_active_weight(s->problem, b) * arc_cells_sum(n, s->w->area + active_at(s, b));
  return sqrt(arc_active_total(s) / area);
}

/* Computes the preconditioned residual z from the residual r. Stores the inner product of both in
 * *product. */
static arc_status precondition(const pass *s, double *product) {
  if (s->w->y) {
    const arc_status status = s->problem->precondition(s->problem->context, s->w->r, s->w->z);
    if (status != ARC_OK) return status;
    arc_active_run(s, project_oblique);
  }
  *product = arc_active_total(s);
  return ARC_OK;
}

static arc_status step(pass *s, double *product, active_count *count, arc_error *error) {
  double now;
  arc_status status = precondition(s, &now);
  if (status != ARC_OK) return status;
  s->factor = *product > 0 ? now / *product : 0;
  *product = now;
  arc_active_run(s, turn);
  status = arc_active_apply(s, s->w->d, s->w->q, count);
  if (status != ARC_OK) return status;
  arc_active_run(s, arc_active_curvature);
  const double curvature = arc_active_total(s);
  if (!(curvature > 0) || !isfinite(now / curvature))
    return arc_fail(error, ARC_NUMERIC, "the compliance is not positive definite");
  s->factor = now / curvature;
  arc_active_run(s, advance);
  count->iterations++;
  return ARC_OK;
}

arc_status arc_active_relax(pass *s, double wanted, double *product, active_count *count,
                            arc_error *error) {
  arc_status status = ARC_OK;
  for (int k = 0; k < most_steps && status == ARC_OK && arc_active_rms(s) > wanted; k++)
    status = step(s, product, count, error);
  return status;
}

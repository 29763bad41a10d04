/* Implements Polonsky and Keer's method of conjugate gradients for contact, which is used if the
 * active set method does not converge. Every step sets negative pressures to 0 and decreases the
 * energy, so that no active set repeats. A step needs two applications of the compliance A. */
#include "core/numeric/active_work.h"

#include <math.h>
#include <string.h>

enum { most_steps = 20000 };

/* Computes the next search direction, which does not change the loads: the negative residual plus
 * a multiple of the last direction, on the cells in contact. */
static void turn(void *context, int block, int worker) {
  const pass *s = context;
  active_work *w = s->w;
  const size_t o = active_at(s, block);
  const int n = s->problem->cells;
  (void)worker;
  if (s->factor == 0) memset(w->d + o, 0, (size_t)n * sizeof *w->d);
  arc_cells_turn(n, s->factor, w->r + o, w->d + o);
  arc_active_project(s, block, w->d + o);
  w->sum[block] = -arc_cells_dot3(n, w->area + o, w->r + o, w->d + o);
}

/* Changes p by the step and sets negative pressures to 0. Cells without pressure whose gap is
 * negative receive a pressure; their number is stored in w->changes. */
static void clip(void *context, int block, int worker) {
  const pass *s = context;
  int entered = 0;
  (void)worker;
  for (int k = 0; k < s->problem->cells; k++) {
    const size_t c = active_at(s, block) + (size_t)k;
    const double gap = arc_active_gap(s, block, k);
    s->p[c] += s->factor * s->w->d[c];
    if (s->p[c] > 0) continue;
    s->p[c] = gap < 0 ? -s->factor * gap : 0;
    entered += gap < 0;
  }
  s->w->changes[block] = entered;
}

static void find_overlap(void *context, int block, int worker) {
  const pass *s = context;
  const double *area = s->w->area + active_at(s, block);
  double overlap = 0;
  (void)worker;
  for (int k = 0; k < s->problem->cells; k++)
    if (area[k] == 0) overlap = fmax(overlap, -arc_active_gap(s, block, k));
  s->w->largest[block] = overlap;
}

static double overlap_of(const pass *s) {
  double overlap = 0;
  arc_active_run(s, find_overlap);
  for (int b = 0; b < s->problem->blocks; b++) overlap = fmax(overlap, s->w->largest[b]);
  return overlap;
}

/* Computes the active set, the gaps and the residual for the present p. */
static arc_status look(pass *s, active_count *count, arc_error *error) {
  arc_active_run(s, arc_active_mark);
  arc_status status = arc_active_gaps(s, &s->limit, count, error);
  if (status != ARC_OK) return status;
  arc_active_run(s, arc_active_factor);
  status = arc_active_check(s, error);
  if (status == ARC_OK) arc_active_run(s, arc_active_residual);
  return status;
}

static arc_status move(pass *s, active_count *count, arc_error *error) {
  arc_active_run(s, turn);
  const double slope = arc_active_total(s);
  const arc_status status = arc_active_apply(s, s->w->d, s->w->q, count);
  if (status != ARC_OK) return status;
  arc_active_run(s, arc_active_curvature);
  s->factor = slope / arc_active_total(s);
  if (!(s->factor > 0) || !isfinite(s->factor))
    return arc_fail(error, ARC_NUMERIC, "the compliance is not positive definite");
  arc_active_run(s, clip);
  count->guarded++;
  return ARC_OK;
}

arc_status arc_active_guard(pass *s, active_count *count, arc_error *error) {
  double before = 0;
  int entered = 1;
  for (int k = 0; k < most_steps; k++) {
    arc_status status = look(s, count, error);
    if (status != ARC_OK) return status;
    const double now = arc_active_total(s);
    if (arc_active_rms(s) < s->limit && overlap_of(s) < s->limit) return ARC_OK;
    s->factor = entered || !(before > 0) ? 0 : now / before;
    before = now;
    status = move(s, count, error);
    if (status != ARC_OK) return status;
    entered = arc_active_changes(s) > 0;
  }
  return arc_fail(error, ARC_NOT_CONVERGED, "the contact did not converge in %d steps", most_steps);
}

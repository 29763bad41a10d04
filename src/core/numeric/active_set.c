/* Implements the primal-dual active set method. Conjugate gradients reduce the residual on the
 * active set, and then the set is revised. This is repeated until the set does not change and the
 * residual is small. */
#include "core/numeric/active_work.h"

#include <math.h>
#include <string.h>

enum {
  most_sets = 30 /* largest number of active sets before Polonsky and Keer's method starts */
};

/* The active set is revised when conjugate gradients have reduced the residual by this factor. */
static const double fall = 0.3;

/* Revises the active set: cells with p < 0 leave it, and cells whose surfaces overlap by more than
 * the limit enter it. */
static void change_set(void *context, int block, int worker) {
  const pass *s = context;
  active_work *w = s->w;
  const size_t o = active_at(s, block);
  unsigned long long hash = 14695981039346656037ull; /* FNV-1a hash of the active set */
  int changes = 0;
  (void)worker;
  for (int k = 0; k < s->problem->cells; k++) {
    const size_t c = o + (size_t)k;
    const int was = w->area[c] > 0,
              is = was ? s->p[c] >= 0 : arc_active_gap(s, block, k) < -s->limit;
    hash = (hash ^ (unsigned long long)is) * 1099511628211ull;
    if (is == was) continue;
    changes++;
    w->area[c] = is ? arc_active_areas(s)[k] : 0;
    if (!is) s->p[c] = 0;
  }
  w->changes[block] = changes;
  w->hash[block] = hash;
}

static unsigned long long hash_of(const pass *s) {
  unsigned long long hash = 0;
  for (int b = 0; b < s->problem->blocks; b++) hash = hash * 1000003ull + s->w->hash[b];
  return hash;
}

/* Stores the gaps in w->g and the rigid unknowns in `delta`. First restores the loads, which
 * rounding errors of many projections have changed. */
static void finish(const pass *s, double *delta) {
  active_work *w = s->w;
  arc_active_run(s, arc_active_restore_load);
  for (int b = 0; b < s->problem->blocks; b++)
    for (int k = 0; k < s->problem->cells; k++)
      w->g[active_at(s, b) + (size_t)k] = arc_active_gap(s, b, k);
  memcpy(delta, w->delta, (size_t)(s->problem->blocks * s->problem->modes) * sizeof *delta);
}

/* Revises the active set until it does not change and the residual is small, and then sets *done to
 * true. If sets repeat, or after most_sets sets, *done remains false, and Polonsky and Keer's
 * method must be started. */
static arc_status revise_sets(pass *s, int *done, active_count *count, arc_error *error) {
  unsigned long long seen[2] = {0, 0};
  double product = 0, share = fall;
  arc_active_run(s, arc_active_mark);
  arc_status status = arc_active_gaps(s, &s->limit, count, error);
  if (status == ARC_OK) status = arc_active_begin(s, error);
  /* On periodic surfaces the initial pressures may cause no displacement. Then the limit of the
   * gaps, which is relative to the displacement, would be 0, so a limit relative to the residual is
   * used. */
  if (status == ARC_OK) s->limit = fmax(s->limit, s->problem->tolerance * arc_active_rms(s));
  for (int sets = 0; sets < most_sets && status == ARC_OK;) {
    const double wanted = fmax(s->limit / 2, share * arc_active_rms(s));
    status = arc_active_relax(s, wanted, &product, count, error);
    if (status != ARC_OK) return status;
    arc_active_run(s, change_set);
    if (arc_active_changes(s) == 0) {
      *done = arc_active_rms(s) < s->limit;
      if (*done) return ARC_OK;
      if (wanted > s->limit / 2) continue;
    }
    const unsigned long long now = hash_of(s);
    if (now == seen[0] && share == 0) return ARC_OK;
    if (now == seen[0])
      share = 0; /* the set repeats, so from now on it is revised only when the residual is small */
    seen[0] = seen[1];
    seen[1] = now;
    sets++;
    count->sets++;
    product = 0;
    status = arc_active_gaps(s, &s->limit, count, error);
    if (status == ARC_OK) status = arc_active_begin(s, error);
  }
  return status;
}

arc_status arc_active_set_solve(const active_problem *problem, active_work *work, double *p,
                                double *delta, active_count *count, arc_error *error) {
  pass s = {.problem = problem, .w = work, .p = p};
  int done = 0;
  arc_status status = revise_sets(&s, &done, count, error);
  if (status == ARC_OK && !done) status = arc_active_guard(&s, count, error);
  if (status == ARC_OK) finish(&s, delta);
  return status;
}

/* Sets the active set to {p > 0}, the gaps in the workspace to problem->gap, and dp to 0. */
static void start_tangent(const pass *s, const double *p) {
  const size_t all = (size_t)s->problem->blocks * (size_t)s->problem->cells;
  for (size_t c = 0; c < all; c++)
    s->w->area[c] = p[c] > 0 ? arc_active_areas(s)[c % (size_t)s->problem->cells] : 0;
  memcpy(s->w->g, s->problem->gap, all * sizeof(double));
  memset(s->p, 0, all * sizeof(double));
}

arc_status arc_active_set_tangent(const active_problem *problem, active_work *work, const double *p,
                                  double *dp, active_count *count, arc_error *error) {
  pass s = {.problem = problem, .w = work, .p = dp};
  double product = 0;
  start_tangent(&s, p);
  arc_status status = arc_active_begin(&s, error);
  if (status != ARC_OK) return status;
  return arc_active_relax(&s, problem->tolerance * arc_active_rms(&s), &product, count, error);
}

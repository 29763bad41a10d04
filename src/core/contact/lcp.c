/* Solves the contact problem for the nodal forces f and the gaps g under load: f >= 0, g = gap -
 * approach + A f >= 0, f'g = 0, sum f = line, the load per thickness. On polar charts (pins in
 * holes) the component `down` of a unit force along the load differs from 1: g = gap - approach
 * down + A f and sum down f = line. A primal-dual active set method (semismooth Newton) begins with
 * the last active set and needs one factorisation if this set is still correct. If this method does
 * not converge because sets repeat, a primal active-set method solves the equivalent convex
 * problem, min f'A f / 2 + gap'f. Its objective decreases with every set, so no set repeats. */
#include "core/base/dense.h"
#include "core/contact/contact_problem.h"

#include <math.h>
#include <string.h>

enum { newton_limit = 30 };

/* Returns true if the factor of A belongs to the present active set. */
static int is_made(const contact_problem *p) {
  return p->factored && p->of == p->active &&
         memcmp(p->made, p->set, (size_t)p->of * sizeof *p->made) == 0;
}

int arc_lcp_factorise(contact_problem *p) {
  if (is_made(p)) return 0;
  const int n = p->active;
  p->factored = 0;
  for (int c = 0; c < n; c++)
    for (int r = c; r < n; r++)
      p->factor[dense_at(r, c, n)] = p->a[dense_at(p->set[r], p->set[c], p->count)];
  if (arc_dense_cholesky(n, p->factor, n)) return 1;
  for (int k = 0; k < n; k++) p->ones[k] = p->down[p->set[k]];
  arc_dense_cholesky_solve(n, 1, p->factor, n, p->ones, n);
  memcpy(p->made, p->set, (size_t)n * sizeof *p->made);
  p->of = n;
  p->factored = 1;
  return 0;
}

/* Returns the sum of value [active] over the active set, weighted by `down`, the component of a
 * unit force along the load. */
static double along_load(const contact_problem *p, const double *value) {
  double sum = 0;
  for (int k = 0; k < p->active; k++) sum += p->down[p->set[k]] * value[k];
  return sum;
}

/* Corrects approach and forces so that the forces balance the load. If gaps are far larger than the
 * deformation, their rounding errors change the sum of the forces by more than its tolerance. */
static void restore_load(contact_problem *p, double line, double total, double *fs) {
  static const double rounding = 1e-12; /* relative tolerance; the sum over a usual active set has a
                                           relative error below 1e-14 */
  const double missing = line - along_load(p, fs);
  if (fabs(missing) <= rounding * line) return;
  p->approach += missing / total;
  for (int k = 0; k < p->active; k++) fs[k] += missing / total * p->ones[k];
}

/* Solves for the approach, and for the forces fs [active] that close the gaps of the active set
 * under the load `line`. Returns non-zero if A is not positive definite. */
static int solve_on_set(contact_problem *p, double line, double *fs) {
  if (arc_lcp_factorise(p)) return 1;
  for (int k = 0; k < p->active; k++) fs[k] = p->gap[p->set[k]];
  arc_dense_cholesky_solve(p->active, 1, p->factor, p->active, fs, p->active);
  const double total = along_load(p, p->ones);
  p->approach = (line + along_load(p, fs)) / total;
  for (int k = 0; k < p->active; k++) fs[k] = p->approach * p->ones[k] - fs[k];
  restore_load(p, line, total, fs);
  return 0;
}

/* Writes the forces fs of the active set to f by candidate, and computes the gaps outside this
 * set. */
static void spread(contact_problem *p, const double *fs) {
  for (int k = 0; k < p->count; k++) {
    p->f[k] = 0;
    p->open[k] = p->gap[k] - p->approach * p->down[k];
  }
  for (int s = 0, first = 0; s <= p->active; s++) {
    const int last = s < p->active ? p->set[s] : p->count;
    if (last > first)
      arc_dense_add_columns(first, last, p->active, p->set, p->a, p->count, fs, p->open);
    first = last + 1;
  }
  for (int s = 0; s < p->active; s++) {
    p->f[p->set[s]] = fs[s];
    p->open[p->set[s]] = 0;
  }
}

/* Computes the new active set: active nodes with f > 0, and inactive nodes that penetrate. Returns
 * 1 if the set has changed. */
static int update_set(contact_problem *p) {
  int n = 0, same = 1;
  for (int k = 0, s = 0; k < p->count; k++) {
    const int was = s < p->active && p->set[s] == k;
    const int is = was ? p->f[k] > 0 : p->open[k] < 0;
    s += was;
    same = same && was == is;
    if (is) p->joined[n++] = k;
  }
  if (same) return 0;
  memcpy(p->set, p->joined, (size_t)n * sizeof *p->set);
  p->active = n;
  return 1;
}

static void all_active(contact_problem *p) {
  p->active = p->count;
  for (int k = 0; k < p->count; k++) p->set[k] = k;
}

/* Runs the primal-dual method. Returns 1 if solved, 0 if it does not converge, -1 if A is not
 * positive definite. */
static int newton(contact_problem *p, double line, double *fs) {
  if (p->active == 0) all_active(p);
  for (int i = 0; i < newton_limit; i++) {
    p->iterations++;
    if (solve_on_set(p, line, fs)) return -1;
    spread(p, fs);
    if (!update_set(p)) return 1;
    if (p->active == 0) return 0;
  }
  return 0;
}

static void insert(contact_problem *p, int candidate) {
  int at = p->active++;
  for (; at > 0 && p->set[at - 1] > candidate; at--) p->set[at] = p->set[at - 1];
  p->set[at] = candidate;
}

static void drop(contact_problem *p, int at) {
  p->active--;
  memmove(&p->set[at], &p->set[at + 1], (size_t)(p->active - at) * sizeof *p->set);
}

/* Changes the feasible forces f towards the solution fs on the set until a force becomes 0, and
 * removes its node from the set. Returns 1 for a full step, 0 if a node was removed, -1 if A is not
 * positive definite. */
static int advance(contact_problem *p, double line, double *f, double *fs) {
  if (solve_on_set(p, line, fs)) return -1;
  double step = 1;
  int blocking = -1;
  for (int s = 0; s < p->active; s++) {
    if (fs[s] > 0 || fs[s] == f[p->set[s]]) continue;
    const double share = f[p->set[s]] / (f[p->set[s]] - fs[s]);
    if (share < step || blocking < 0) step = share, blocking = s;
  }
  for (int s = 0; s < p->active; s++) f[p->set[s]] += step * (fs[s] - f[p->set[s]]);
  if (blocking < 0) return 1;
  f[p->set[blocking]] = 0;
  drop(p, blocking);
  return 0;
}

static int most_penetrating(const contact_problem *p) {
  int worst = -1;
  double least = 0;
  for (int k = 0; k < p->count; k++)
    if (p->open[k] < least) least = p->open[k], worst = k;
  return worst;
}

static int descend(contact_problem *p, double line, double *fs) {
  double *f = p->step + p->nc;
  int start = 0;
  for (int k = 1; k < p->count; k++)
    if (p->gap[k] * p->down[start] < p->gap[start] * p->down[k]) start = k;
  memset(f, 0, (size_t)p->count * sizeof *f);
  f[start] = line / p->down[start];
  p->active = 0;
  insert(p, start);
  for (int guard = 0; guard < 100 * p->count; guard++) {
    p->iterations++;
    int moved;
    while ((moved = advance(p, line, f, fs)) == 0) p->iterations++;
    if (moved < 0) return -1;
    spread(p, fs);
    const int worst = most_penetrating(p);
    if (worst < 0 || p->open[worst] > -1e-14 * fabs(p->approach)) return 1;
    insert(p, worst);
  }
  return 0;
}

arc_status arc_lcp_solve(contact_problem *p, double line) {
  double *fs = p->step;
  p->iterations = 0;
  int solved = newton(p, line, fs);
  if (solved == 0) solved = descend(p, line, fs);
  return solved == 1 ? ARC_OK : ARC_NUMERIC;
}

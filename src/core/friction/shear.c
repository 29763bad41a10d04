/* Computes shear forces within given bounds, which is a symmetric problem with box constraints. The
 * solver is a primal-dual active-set method (semismooth Newton) over the states stick, slip along x
 * and slip against x, and begins with the last states. If it does not converge, or if no node
 * sticks that could balance a given force, a primal active-set method is used instead. Its
 * objective decreases with every set, so no set repeats. */
#include "core/base/dense.h"
#include "core/friction/friction.h"

#include <math.h>
#include <string.h>

enum { newton_limit = 20 };

/* Computes pulled = A_tt t, by candidate, at all candidates from the first to the last node in
 * contact. */
static void pull(shear_problem *s, const double *t) {
  const int first = s->at[0], last = s->at[s->n - 1] + 1;
  memset(&s->pulled[first], 0, (size_t)(last - first) * sizeof *s->pulled);
  arc_dense_add_columns(first, last, s->n, s->at, s->a, s->ld, t, s->pulled);
}

/* Lists the nodes that stick in s->list and s->pick. Returns 1 if the list is unchanged. */
static int list_stuck(shear_problem *s) {
  int n = 0, same = 1;
  for (int i = 0; i < s->n; i++) {
    if (s->direction[i] != 0) continue;
    same = same && n < s->stuck && s->list[n] == s->at[i];
    s->list[n] = s->at[i];
    s->pick[n++] = i;
  }
  same = same && n == s->stuck;
  s->stuck = n;
  return same;
}

int arc_shear_factorise(shear_problem *s) {
  if (list_stuck(s) && s->factored) return 0;
  const int n = s->stuck;
  s->factored = 0;
  for (int c = 0; c < n; c++)
    for (int r = c; r < n; r++)
      s->factor[dense_at(r, c, n)] = s->a[dense_at(s->list[r], s->list[c], s->ld)];
  if (arc_dense_cholesky(n, s->factor, n)) return 1;
  for (int k = 0; k < n; k++) s->ones[k] = 1;
  arc_dense_cholesky_solve(n, 1, s->factor, n, s->ones, n);
  s->factored = 1;
  return 0;
}

/* Computes the plate displacement `shift` for which the nodes that stick carry the rest of the
 * given force. */
static void find_shift(shear_problem *s) {
  double rest = s->total, sum = 0;
  for (int i = 0; i < s->n; i++)
    if (s->direction[i] != 0) rest -= s->direction[i] * s->bound[i];
  for (int k = 0; k < s->stuck; k++) {
    rest -= s->target[k];
    sum += s->ones[k];
  }
  s->shift = rest / sum;
}

/* Writes to target [stuck] the forces that prevent slip of the nodes that stick. The other nodes
 * are at their bounds. Returns 1 if solved, 0 if a force is given and no node sticks, -1 if A_tt is
 * not positive definite. */
static int solve_stuck(shear_problem *s) {
  if (arc_shear_factorise(s)) return -1;
  s->shift = 0;
  if (s->stuck == 0) return !s->by_force;
  for (int j = 0; j < s->n; j++) s->held[j] = s->direction[j] * s->bound[j];
  pull(s, s->held);
  for (int k = 0; k < s->stuck; k++) s->target[k] = s->drive[s->pick[k]] - s->pulled[s->list[k]];
  arc_dense_cholesky_solve(s->stuck, 1, s->factor, s->stuck, s->target, s->stuck);
  if (!s->by_force) return 1;
  find_shift(s);
  for (int k = 0; k < s->stuck; k++) s->target[k] += s->shift * s->ones[k];
  return 1;
}

static void take_target(shear_problem *s) {
  for (int i = 0; i < s->n; i++) s->t[i] = s->direction[i] * s->bound[i];
  for (int k = 0; k < s->stuck; k++) s->t[s->pick[k]] = s->target[k];
}

/* Computes the slip of the nodes that slip; the slip of all other nodes is 0. */
static void measure_slip(shear_problem *s) {
  pull(s, s->t);
  for (int i = 0; i < s->n; i++)
    s->slip[i] = s->direction[i] != 0 ? s->drive[i] + s->shift - s->pulled[s->at[i]] : 0;
}

/* Updates the state of each node (stick or direction of slip). Returns true if a state changed. */
static int update_directions(shear_problem *s) {
  int changed = 0;
  for (int i = 0; i < s->n; i++) {
    int direction = s->direction[i];
    if (direction != 0)
      direction = direction * s->slip[i] < 0 ? 0 : direction;
    else if (fabs(s->t[i]) > s->bound[i])
      direction = s->t[i] > 0 ? 1 : -1;
    changed = changed || direction != s->direction[i];
    s->direction[i] = direction;
  }
  return changed;
}

static int newton(shear_problem *s) {
  for (int i = 0; i < newton_limit; i++) {
    s->iterations++;
    const int solved = solve_stuck(s);
    if (solved <= 0) return solved;
    take_target(s);
    measure_slip(s);
    if (!update_directions(s)) return 1;
  }
  return 0;
}

/* Sets all nodes to stick. Their forces are within the bounds and have the given sum. */
static void start_inside(shear_problem *s) {
  double all = 0;
  for (int i = 0; i < s->n; i++) all += s->bound[i];
  for (int i = 0; i < s->n; i++) {
    s->direction[i] = 0;
    s->t[i] = s->by_force ? s->bound[i] * (s->total / all) : 0;
  }
}

/* Changes the forces towards the target as far as the bounds allow. A node that reaches its bound
 * slips from then on. Returns 1 for a full step, 0 if a node reached its bound, -1 if A_tt is not
 * positive definite. */
static int advance(shear_problem *s) {
  const int solved = solve_stuck(s);
  if (solved <= 0) return solved < 0 ? -1 : 1;
  double step = 1;
  int blocking = -1;
  for (int k = 0; k < s->stuck; k++) {
    const int i = s->pick[k];
    if (fabs(s->target[k]) <= s->bound[i]) continue;
    const double limit = copysign(s->bound[i], s->target[k]);
    const double share = (limit - s->t[i]) / (s->target[k] - s->t[i]);
    if (share < step || blocking < 0) step = share, blocking = k;
  }
  for (int k = 0; k < s->stuck; k++) {
    double *t = &s->t[s->pick[k]];
    *t += step * (s->target[k] - *t);
  }
  if (blocking < 0) return 1;
  const int i = s->pick[blocking];
  s->direction[i] = s->target[blocking] > 0 ? 1 : -1;
  s->t[i] = s->direction[i] * s->bound[i];
  return 0;
}

/* Returns the node with the largest slip in the direction opposite to its force, or -1 if there is
 * none. */
static int most_wrong(const shear_problem *s) {
  int worst = -1;
  double most = 0;
  for (int i = 0; i < s->n; i++) most = fmax(most, fabs(s->drive[i] + s->shift));
  double least = -1e-14 * most;
  for (int i = 0; i < s->n; i++)
    if (s->direction[i] * s->slip[i] < least) least = s->direction[i] * s->slip[i], worst = i;
  return worst;
}

static int descend(shear_problem *s) {
  start_inside(s);
  for (int guard = 0; guard < 100 * (s->n + 1); guard++) {
    s->iterations++;
    const int free_way = advance(s);
    if (free_way < 0) return -1;
    if (free_way == 0) continue;
    measure_slip(s);
    const int worst = most_wrong(s);
    if (worst < 0) return 1;
    s->direction[worst] = 0;
  }
  return 0;
}

/* Solves the shear problem if all bounds are zero, so that all nodes slip. Returns 0 for other
 * problems. */
static int is_free(shear_problem *s) {
  for (int i = 0; i < s->n; i++)
    if (s->bound[i] > 0) return 0;
  for (int i = 0; i < s->n; i++) s->t[i] = 0, s->direction[i] = 1;
  s->shift = 0;
  measure_slip(s);
  return 1;
}

int arc_shear_solve(shear_problem *s) {
  if (is_free(s)) return 1;
  const int solved = newton(s);
  return solved == 0 ? descend(s) : solved;
}

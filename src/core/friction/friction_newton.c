/* Solves for pressures and shear of an increment together, by a semismooth Newton method over the
 * states of the nodes (no contact, stick, slip along x, slip against x). The matrix is not
 * symmetric, since shear is proportional to pressure where nodes slip. The method converges fast if
 * the initial states are nearly correct, but it may fail; friction.c then continues with sweeps.
 * The unknowns are the normal forces of the nodes in contact, then the shear forces of the nodes
 * that stick. The approach, and the plate's motion under a given tangential force, follow from the
 * load and the tangential force. */
#include "core/base/dense.h"
#include "core/friction/friction.h"

#include <math.h>
#include <string.h>

enum { newton_limit = 10, right_hand_sides = 3 };

typedef struct newton_system {
  friction_task *k;
  int na, ns, n;          /* numbers of nodes in contact, nodes that stick, and unknowns */
  int *direction, *stuck; /* [nc] state of each candidate node (0: sticks; 1, -1: slips); [ns]
                             candidates that stick */
  double *a, *b; /* matrix [n x n]; solutions [n x 3]: without rigid motion, per unit of approach,
                    and per unit displacement of the plate */
} newton_system;

static void set_workspace(newton_system *c) {
  friction_workspace *w = c->k->w;
  const size_t n = 2 * (size_t)w->nc;
  c->a = w->coupled;
  c->b = w->coupled + n * n;
  c->direction = w->pivots + n;
  c->stuck = c->direction + w->nc;
}

static void list_sets(newton_system *c) {
  const contact_problem *p = c->k->p;
  c->na = p->active;
  c->ns = 0;
  for (int i = 0; i < p->active; i++)
    if (c->direction[p->set[i]] == 0) c->stuck[c->ns++] = p->set[i];
  c->n = c->na + c->ns;
}

static double slope_at(const newton_system *c, int candidate) {
  return c->k->p->slope[c->k->p->lo + candidate];
}

/* Returns the shear force per normal force at a node: mu or -mu if the node slips, 0 if it
 * sticks. */
static double pull_at(const newton_system *c, int candidate) {
  return c->direction[candidate] * c->k->step->mu;
}

/* Computes the matrix column of the normal force at candidate `from`: the gaps of the nodes in
 * contact, then the tangential displacements of the nodes that stick. */
static void fill_force(newton_system *c, int column, int from) {
  const contact_problem *p = c->k->p;
  const tangential_compliance *g = c->k->g;
  const double pull = pull_at(c, from);
  double *a = &c->a[dense_at(0, column, c->n)];
  for (int i = 0; i < c->na; i++)
    a[i] = p->a[dense_at(p->set[i], from, p->count)] +
           pull * g->nt[dense_at(p->set[i], from, p->count)];
  for (int i = 0; i < c->ns; i++)
    a[c->na + i] = g->nt[dense_at(from, c->stuck[i], p->count)] +
                   pull * g->tt[dense_at(c->stuck[i], from, p->count)];
}

static void fill_shear(newton_system *c, int column, int from) {
  const contact_problem *p = c->k->p;
  const tangential_compliance *g = c->k->g;
  double *a = &c->a[dense_at(0, column, c->n)];
  for (int i = 0; i < c->na; i++) a[i] = g->nt[dense_at(p->set[i], from, p->count)];
  for (int i = 0; i < c->ns; i++) a[c->na + i] = g->tt[dense_at(c->stuck[i], from, p->count)];
}

static void fill_sides(newton_system *c) {
  const friction_task *k = c->k;
  double *base = c->b, *approach = base + c->n, *motion = approach + c->n;
  for (int i = 0; i < c->na; i++) {
    const int at = k->p->set[i];
    base[i] = -k->w->gap[at];
    approach[i] = 1;
    motion[i] = -slope_at(c, at);
  }
  for (int i = 0; i < c->ns; i++) {
    const int at = c->stuck[i];
    base[c->na + i] = k->dx + k->w->before[at] - slope_at(c, at) * k->approach;
    approach[c->na + i] = slope_at(c, at);
    motion[c->na + i] = 1;
  }
}

/* Computes the contribution of an unknown with the value 1 to the load and to the tangential
 * force. */
static void share_of(const newton_system *c, int unknown, double *load, double *tangential) {
  const int shear = unknown >= c->na;
  const int at = shear ? c->stuck[unknown - c->na] : c->k->p->set[unknown];
  const double m = slope_at(c, at), pull = pull_at(c, at);
  *load = shear ? m : 1 + m * pull;
  *tangential = shear ? 1 : pull - m;
}

/* Computes the approach rigid[0] and the motion of the plate rigid[1] from the given load and
 * tangential force. Returns 0 if the equations do not determine them. */
static int find_rigid(newton_system *c, double rigid[2]) {
  double sum[right_hand_sides][2] = {{0}};
  for (int u = 0; u < c->n; u++) {
    double share[2];
    share_of(c, u, &share[0], &share[1]);
    for (int s = 0; s < right_hand_sides; s++)
      for (int d = 0; d < 2; d++) sum[s][d] += c->b[dense_at(u, s, c->n)] * share[d];
  }
  const double load = c->k->step->line - sum[0][0], side = c->k->step->tangential - sum[0][1];
  rigid[1] = 0;
  rigid[0] = load / sum[1][0];
  if (!c->k->by_force) return isfinite(rigid[0]);
  const double det = sum[1][0] * sum[2][1] - sum[2][0] * sum[1][1];
  rigid[0] = (load * sum[2][1] - side * sum[2][0]) / det;
  rigid[1] = (side * sum[1][0] - load * sum[1][1]) / det;
  return isfinite(rigid[0]) && isfinite(rigid[1]);
}

static int solve_on_sets(newton_system *c) {
  friction_task *k = c->k;
  contact_problem *p = k->p;
  friction_workspace *w = k->w;
  double rigid[2];
  if (c->na == 0) return 0;
  for (int i = 0; i < c->na; i++) fill_force(c, i, p->set[i]);
  for (int i = 0; i < c->ns; i++) fill_shear(c, c->na + i, c->stuck[i]);
  fill_sides(c);
  if (arc_dense_factor(c->n, c->a, w->pivots)) return 0;
  arc_dense_factor_solve(c->n, right_hand_sides, c->a, w->pivots, c->b);
  if (!find_rigid(c, rigid)) return 0;
  for (int u = 0; u < c->n; u++)
    c->b[u] += rigid[0] * c->b[c->n + u] + rigid[1] * c->b[2 * c->n + u];
  p->approach = rigid[0];
  w->shear.shift = rigid[1];
  return 1;
}

/* Computes the forces and gaps of all candidates from the solution, and w->dragged, from which the
 * slip follows. */
static void spread(newton_system *c) {
  const contact_problem *p = c->k->p;
  tangential_compliance *g = c->k->g;
  friction_workspace *w = c->k->w;
  memset(p->f, 0, (size_t)p->count * sizeof *p->f);
  memset(w->t, 0, (size_t)p->count * sizeof *w->t);
  for (int i = 0; i < c->na; i++) {
    p->f[p->set[i]] = c->b[i];
    w->t[p->set[i]] = pull_at(c, p->set[i]) * c->b[i];
  }
  for (int i = 0; i < c->ns; i++) w->t[c->stuck[i]] = c->b[c->na + i];
  arc_tangential_gaps(g, w->t, w->sheared);
  arc_tangential_drag_all(g, p->f, w->t, w->dragged);
  for (int i = 0; i < p->count; i++) {
    p->gap[i] = w->gap[i] + slope_at(c, i) * w->shear.shift + w->sheared[i];
    p->open[i] = p->gap[i] - p->approach;
  }
  arc_dense_add_columns(0, p->count, c->na, p->set, p->a, p->count, c->b, p->open);
}

/* Returns the state (stick or direction of slip) of a node in contact. */
static int next_direction(const newton_system *c, int at) {
  friction_workspace *w = c->k->w;
  const int direction = c->direction[at];
  if (direction != 0) return direction * w->slip[at] < 0 ? 0 : direction;
  if (fabs(w->t[at]) <= c->k->step->mu * c->k->p->f[at]) return 0;
  return w->t[at] > 0 ? 1 : -1;
}

/* Updates the sets of nodes that stick, slip or have no contact. Returns true if a set changed. */
static int update_sets(newton_system *c) {
  contact_problem *p = c->k->p;
  int n = 0, changed = 0;
  for (int i = 0, s = 0; i < p->count; i++) {
    const int was = s < p->active && p->set[s] == i, is = was ? p->f[i] > 0 : p->open[i] < 0;
    s += was;
    const int direction = was && is ? next_direction(c, i) : 0;
    changed = changed || is != was || (is && direction != c->direction[i]);
    c->direction[i] = direction;
    if (is) p->joined[n++] = i;
  }
  if (!changed) return 0;
  memcpy(p->set, p->joined, (size_t)n * sizeof *p->set);
  p->active = n;
  return 1;
}

static int iterate(newton_system *c) {
  const contact_problem *p = c->k->p;
  friction_workspace *w = c->k->w;
  for (int i = 0; i < newton_limit; i++) {
    list_sets(c);
    if (!solve_on_sets(c)) return 0;
    spread(c);
    for (int s = 0; s < p->active; s++)
      w->slip[p->set[s]] = c->direction[p->set[s]] != 0 ? arc_friction_slip(c->k, p->set[s]) : 0;
    w->iterations++;
    if (!update_sets(c)) return 1;
  }
  return 0;
}

/* Saves shear, slip and active set. If the iteration fails, they are restored and the sweeps
 * continue. */
static void save(const newton_system *c, double *t, double *slip, int *set) {
  memcpy(t, c->k->w->t, (size_t)c->k->g->count * sizeof *t);
  memcpy(slip, c->k->w->slip, (size_t)c->k->g->count * sizeof *slip);
  memcpy(set, c->k->p->set, (size_t)c->k->p->active * sizeof *set);
}

int arc_friction_newton(friction_task *k) {
  tangential_compliance *g = k->g;
  friction_workspace *w = k->w;
  contact_problem *p = k->p;
  newton_system c = {.k = k};
  double *t = w->work, *slip = t + g->nc, *sheared = slip + g->nc;
  const double shift = w->shear.shift;
  const int active = p->active;
  set_workspace(&c);
  int *set = w->pivots + 4 * (size_t)g->nc;
  save(&c, t, slip, set);
  memcpy(sheared, w->sheared, (size_t)g->count * sizeof *sheared);
  for (int i = 0; i < g->count; i++) c.direction[i] = (w->slip[i] > 0) - (w->slip[i] < 0);
  w->newton = iterate(&c);
  if (w->newton) return 1;
  memcpy(w->t, t, (size_t)g->count * sizeof *t);
  memcpy(w->slip, slip, (size_t)g->count * sizeof *slip);
  memcpy(w->sheared, sheared, (size_t)g->count * sizeof *sheared);
  memcpy(p->set, set, (size_t)active * sizeof *set);
  p->active = active;
  w->shear.shift = shift;
  return 0;
}

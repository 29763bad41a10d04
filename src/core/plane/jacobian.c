/* Computes the Jacobian of the wear in a cycle with respect to the depths of both surfaces. It is
 * computed from the active sets of the contact solutions.
 *
 * On the active set let C = A^-1 - A^-1 1 1' A^-1 / (1' A^-1 1), where A is the compliance matrix
 * and 1 a vector of ones. If the depths of cylinder and plate increase by h_c and h_p, the forces
 * of a contact problem change by -C (h_c + B h_p), where B interpolates from the plate's nodes to
 * the cylinder's nodes. C hardly differs between neighbouring problems with the same active set. A
 * group of such problems therefore uses the matrix C of one problem, the head of the group. The
 * matrices B of the group differ; their mean couples the two surfaces. Groups are symmetric about x
 * = 0, so symmetric runs remain symmetric. */
#include "core/base/dense.h"
#include "core/plane/cycle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct jacobian_group {
  contact_problem *head; /* solved contact problem of point `at`, which represents the group */
  int at, m;             /* index of the head's point; number of nodes in its active set */
  int *node;             /* surface nodes of the active set */
  int *from, *to; /* for each cylinder node, first plate node in its row of B, and last node + 1 */
  int low, high;  /* first plate node of the active set, and last node + 1 */
  int points;     /* number of problems in the group */
  double total;   /* sum of the weights `share` of the group's problems [mm] */
  const double *wc, *wp; /* tributary widths of the nodes, equal for all problems [mm] */
  double *scale;         /* sum of share * dq/dp over the group, for each surface node */
  double *c;             /* matrix C of the head */
  double *own, *mean;    /* transpose B' for the head; sum of share * B' over the group */
  double *cb;            /* workspace for C B */
} jacobian_group;

wear_tangent *arc_tangent_create(const arc_wear *w) {
  const size_t c = (size_t)w->nc, p = (size_t)w->np, n = c + p;
  wear_tangent *j = calloc(1, sizeof *j);
  jacobian_group *g = calloc(1, sizeof *g);
  double *value = malloc(n * n * sizeof(double));
  int *node = calloc(3 * c, sizeof(int));
  double *scale = calloc(n + c * c + 3 * c * p, sizeof(double));
  if (!j || !g || !value || !node || !scale) {
    free(j), free(g), free(value), free(node), free(scale);
    return NULL;
  }
  *g = (jacobian_group){.node = node,
                        .from = node + c,
                        .to = node + 2 * c,
                        .scale = scale,
                        .c = scale + n,
                        .own = scale + n + c * c,
                        .mean = scale + n + c * c + c * p,
                        .cb = scale + n + c * c + 2 * c * p};
  *j = (wear_tangent){.nc = w->nc, .np = w->np, .value = value, .group = g};
  return j;
}

void arc_tangent_free(wear_tangent **tangent) {
  wear_tangent *j = *tangent;
  if (!j) return;
  free(j->group->node);
  free(j->group->scale);
  free(j->group);
  free(j->value);
  free(j);
  *tangent = NULL;
}

size_t arc_tangent_bytes(const arc_wear *w) {
  const size_t c = (size_t)w->nc, p = (size_t)w->np, n = c + p;
  return (n * n + n + c * c + 3 * c * p) * sizeof(double);
}

/* Empties the group: sets all its sums to zero. */
static void empty(wear_tangent *j) {
  jacobian_group *g = j->group;
  g->points = 0;
  g->total = 0;
  memset(g->scale, 0, (size_t)(j->nc + j->np) * sizeof(double));
  for (int i = 0; i < j->nc; i++) {
    const size_t rows = g->to[i] > g->from[i] ? (size_t)(g->to[i] - g->from[i]) : 0;
    if (rows > 0) memset(&g->mean[dense_at(g->from[i], i, j->np)], 0, rows * sizeof(double));
    g->from[i] = j->np, g->to[i] = 0;
  }
}

void arc_wear_jacobian_clear(wear_tangent *j) {
  const size_t n = (size_t)(j->nc + j->np);
  memset(j->value, 0, n * n * sizeof(double));
  empty(j);
}

/* --- a group ---------------------------------------------------------------------------------- */

static void fill_c(const contact_problem *p, double *c) {
  const int m = p->active;
  double total = 0;
  for (int s = 0; s < m; s++) total += p->down[p->set[s]] * p->ones[s];
  arc_dense_cholesky_invert(m, p->factor, c);
  for (int t = 0; t < m; t++)
    for (int s = 0; s < m; s++) c[dense_at(s, t, m)] -= p->ones[s] * p->ones[t] / total;
}

/* Computes the matrices C and B of the head. Returns 0 if A is not positive definite, which is
 * impossible for a solved problem. */
static int take_head(wear_tangent *j) {
  jacobian_group *g = j->group;
  contact_problem *p = g->head;
  if (arc_lcp_factorise(p)) return 0;
  g->m = p->active;
  g->wc = p->wc;
  g->wp = p->wp;
  fill_c(p, g->c);
  for (int s = 0; s < g->m; s++) {
    const int k = p->set[s], i = g->node[s] = p->lo + k;
    memset(&g->own[dense_at(0, i, j->np)], 0, (size_t)j->np * sizeof(double));
    for (int q = 0; q < p->width && p->first[k] + q < p->np; q++)
      g->own[dense_at(p->first[k] + q, i, j->np)] = p->b[k * p->width + q];
  }
  return 1;
}

static void join(const arc_wear *w, const contact_problem *p, const wear_point *point, double share,
                 double *const sliding[ARC_BODIES], wear_tangent *j) {
  jacobian_group *g = j->group;
  g->points++;
  g->total += share;
  for (int b = 0; b < ARC_BODIES; b++) {
    const int n = b == ARC_CYLINDER ? j->nc : j->np;
    double *scale = b == ARC_CYLINDER ? g->scale : g->scale + j->nc;
    for (int i = 0; i < n; i++)
      scale[i] +=
          (sliding ? sliding[b][i] : share) * arc_wear_law_slope(w, point->p[b][i], point->q[b][i]);
  }
  for (int k = 0; k < p->count; k++) {
    const int i = p->lo + k, first = p->first[k];
    const int end = first + p->width < p->np ? first + p->width : p->np;
    for (int l = first; l < end; l++)
      g->mean[dense_at(l, i, j->np)] += share * p->b[k * p->width + l - first];
    if (first < g->from[i]) g->from[i] = first;
    if (end > g->to[i]) g->to[i] = end;
  }
}

/* --- contribution of a group to the Jacobian */

/* Computes C B for the plate nodes from `low` to `high` - 1. `b` contains the transpose of B. */
static void times_rows(const wear_tangent *j, const double *b) {
  const jacobian_group *g = j->group;
  memset(g->cb, 0, (size_t)g->m * (size_t)(g->high - g->low) * sizeof(double));
  for (int s = 0; s < g->m; s++)
    for (int l = g->from[g->node[s]]; l < g->to[g->node[s]]; l++) {
      const double weight = b[dense_at(l, g->node[s], j->np)], *c = &g->c[dense_at(0, s, g->m)];
      double *to = &g->cb[dense_at(0, l - g->low, g->m)];
      if (weight == 0) continue;
      for (int r = 0; r < g->m; r++) to[r] += weight * c[r];
    }
}

static void add_cylinder(wear_tangent *j) {
  const jacobian_group *g = j->group;
  for (int t = 0; t < g->m; t++)
    for (int s = 0; s < g->m; s++) {
      const int i = g->node[s];
      j->value[dense_at(i, g->node[t], j->nc + j->np)] +=
          g->scale[i] / g->wc[i] * g->c[dense_at(s, t, g->m)];
    }
}

static void add_coupling(wear_tangent *j) {
  const jacobian_group *g = j->group;
  const int n = j->nc + j->np;
  times_rows(j, g->mean);
  for (int l = g->low; l < g->high; l++) {
    const double plate = g->scale[j->nc + l] / g->wp[l] / g->total;
    for (int s = 0; s < g->m; s++) {
      const int i = g->node[s];
      const double cb = g->cb[dense_at(s, l - g->low, g->m)];
      j->value[dense_at(i, j->nc + l, n)] += g->scale[i] / g->wc[i] / g->total * cb;
      j->value[dense_at(j->nc + l, i, n)] += plate * cb;
    }
  }
}

static void add_plate(wear_tangent *j) {
  const jacobian_group *g = j->group;
  const int n = j->nc + j->np;
  times_rows(j, g->own);
  for (int t = g->low; t < g->high; t++) {
    double *column = &j->value[dense_at(j->nc, j->nc + t, n)];
    const double *cb = &g->cb[dense_at(0, t - g->low, g->m)];
    for (int s = 0; s < g->m; s++)
      for (int i = g->node[s], l = g->from[i]; l < g->to[i]; l++)
        column[l] += g->scale[j->nc + l] / g->wp[l] * g->own[dense_at(l, i, j->np)] * cb[s];
  }
}

static void find_range(jacobian_group *g, int np) {
  g->low = np;
  g->high = 0;
  for (int s = 0; s < g->m; s++) {
    const int i = g->node[s];
    if (g->from[i] < g->low) g->low = g->from[i];
    if (g->to[i] > g->high) g->high = g->to[i];
  }
}

void arc_wear_jacobian_finish(wear_tangent *j) {
  jacobian_group *g = j->group;
  if (g->points > 0 && g->total > 0 && take_head(j)) {
    find_range(g, j->np);
    add_cylinder(j);
    add_coupling(j);
    add_plate(j);
  }
  empty(j);
}

/* --- choice of the group ---------------------------------------------------------------------- */

static int bin_of(const wear_tangent *j, const wear_block *block, int at) {
  const double x = block->problem_x[at];
  return j->width > 0 ? (x < 0 ? -1 : 1) * (int)ceil(fabs(x) / j->width - 1e-9) : at;
}

static double off_centre(const wear_tangent *j, const wear_block *block, int at) {
  const double centre = (abs(bin_of(j, block, at)) - 0.5) * j->width;
  return fabs(fabs(block->problem_x[at]) - centre);
}

static int same_set(const contact_problem *a, const contact_problem *b) {
  return a->lo == b->lo && a->active == b->active &&
         memcmp(a->set, b->set, (size_t)a->active * sizeof *a->set) == 0;
}

/* Returns true if a point belongs to the present group. The positions must be close, and the
 * load and the active set must equal those of the head. */
static int belongs(const wear_tangent *j, const wear_block *block, int at,
                   const contact_problem *p) {
  const jacobian_group *g = j->group;
  const int to = g->at;
  return g->points > 0 && block->line[at] == block->line[to] &&
         block->angle[at] == block->angle[to] && bin_of(j, block, at) == bin_of(j, block, to) &&
         same_set(p, g->head);
}

/* Returns true if a point is nearer to the centre of its group than the head. Of two points at
 * equal distance, the point farther from x = 0 is preferred. */
static int is_better_head(const wear_tangent *j, const wear_block *block, int at) {
  static const double even = 1e-9;
  const int head = j->group->at;
  const double nearer = off_centre(j, block, head) - off_centre(j, block, at);
  if (fabs(nearer) > even * j->width) return nearer > 0;
  return fabs(block->problem_x[at]) > fabs(block->problem_x[head]);
}

void arc_wear_jacobian_add(const arc_wear *w, const wear_window *window, int at, double share,
                           double *const sliding[ARC_BODIES]) {
  wear_tangent *j = window->tangent;
  const wear_block *block = path_of(w)->block;
  contact_problem *p = &path_of(w)->problem[block->problem_of[at]];
  const int joins = belongs(j, block, at, p);
  if (!joins) arc_wear_jacobian_finish(j);
  if (!joins || is_better_head(j, block, at)) j->group->head = p, j->group->at = at;
  join(w, p, &path_of(w)->point[at % 2], share, sliding, j);
}

/* --- the largest eigenvalue ------------------------------------------------------------------- */

static double normalise(int n, double *v) {
  double sum = 0;
  for (int i = 0; i < n; i++) sum += v[i] * v[i];
  const double length = sqrt(sum);
  for (int i = 0; i < n && length > 0; i++) v[i] /= length;
  return length;
}

/* Computes the largest eigenvalue of the Jacobian by power iteration. Row i is multiplied by the
 * wear coefficient k of node i. The vectors are stored in arrays of the group. */
double arc_tangent_eigenvalue(const arc_wear *w, const double k_both[ARC_BODIES],
                              wear_tangent *tangent, const arc_callbacks *callbacks) {
  (void)callbacks;
  const double k[ARC_BODIES] = {sites_k(w, k_both, ARC_UPPER), sites_k(w, k_both, ARC_LOWER)};
  const int n = tangent->nc + tangent->np;
  double *v = tangent->group->own, *image = v + n, value = 0;
  /* initial vector: a sawtooth plus a linear trend, neither symmetric nor antisymmetric */
  for (int i = 0; i < n; i++) v[i] = (i % 2 ? 1.0 : -1.0) * (1 + (double)i / n);
  for (int it = 0; it < 1000; it++) {
    const double before = value;
    if (normalise(n, v) == 0) return 0;
    arc_dense_multiply(n, 1, n, 1, tangent->value, n, v, n, 0, image, n);
    value = 0;
    for (int i = 0; i < n; i++) {
      v[i] = k[i < w->nc ? ARC_CYLINDER : ARC_PLATE] * image[i];
      value += v[i] * v[i];
    }
    value = sqrt(value);
    if (value == 0 || fabs(value - before) < 1e-6 * value) break;
  }
  return value;
}

/* Computes the energy correction: the dissipated energy that is missing in the sum over nodes,
 * because slip between the nodes is not resolved. Consider a plate that is pushed in one direction
 * under a constant load, on surfaces without shear. The nodes begin to slip one by one, from the
 * edge of the contact inwards. Node j begins to slip when the force has risen by D_j; from then on
 * the tangential compliance is larger by C_j. Up to a rise D of the force the nodes dissipate sum_j
 * D_j C_j (D - D_j). Real surfaces slip continuously, so this sum approximates an integral. By the
 * Euler-Maclaurin formula its error depends only on its two ends, the edge of the contact and the
 * edge of the stick zone, and on their positions between nodes. These positions are measured by
 * changes of force. The node inside the stick zone will slip after a change r / e, where r is its
 * reserve (missing shear force) and e its fraction of the force. The node outside began to slip a
 * change s / c ago, where s is its slip and c its slip per force. Beyond the edge of the contact,
 * the friction coefficient times the gap replaces s, because slip depends on force as the gap
 * depends on load. Terms of fourth order in the element size are neglected.
 *
 * A motion after a reversal equals twice a first motion of half the change of force
 * (friction_hysteresis.c). The ends of the sum are therefore known for any history of forces. If
 * the materials of the bodies differ, pressures depend on shear, and nodes may slip in another
 * order. The correction is then less accurate, but still an improvement. */
#include "core/friction/friction.h"
#include "core/base/dense.h"

#include <math.h>
#include <string.h>

/* One end of the sum over nodes: the lower end is the set of all edges of the contact, the upper
 * end the set of all edges of stick zones. */
typedef struct sum_ends {
  friction_task *k;
  double unit; /* force per unit of motion on the nodes that stick [N/mm2] */
  friction_terms terms;
} sum_ends;

/* Returns the slip of a candidate node per tangential force on the nodes that stick [mm2/N]. */
static double slip_rate(const sum_ends *e, int at) {
  const shear_problem *h = &e->k->w->shear;
  const double *column = &h->a[dense_at(0, at, h->ld)];
  double held = 0;
  for (int q = 0; q < h->stuck; q++) held += column[h->list[q]] * h->ones[q];
  return fabs(1 - held) / e->unit;
}

/* Returns the slip [mm] of a neighbour of a node in contact. If the neighbour is not in contact,
 * the friction coefficient times its gap is added. */
static double slipped(const sum_ends *e, int in, int side) {
  const shear_problem *h = &e->k->w->shear;
  const int next = in + side, out = h->at[in] + side;
  const double *column = &h->a[dense_at(0, out, h->ld)];
  if (next >= 0 && next < h->n && h->at[next] == out) return h->direction[next] * h->slip[next];
  double slip = h->shift;
  for (int i = 0; i < h->n; i++) slip -= column[h->at[i]] * h->t[i];
  return slip + e->k->step->mu * e->k->p->open[out];
}

/* Returns the change of the tangential force [N/mm] at which the q-th sticking node begins to
 * slip. */
static double until_slip(const sum_ends *e, int q) {
  const shear_problem *h = &e->k->w->shear;
  const int in = h->pick[q];
  return (h->bound[in] - h->t[in]) * e->unit / h->ones[q];
}

/* Returns the fraction of the correction that is applied: 1 for smooth contacts, less at kinks of
 * the surfaces, and 0 at edges of scars. After the outer node, the inner node begins to slip when
 * the force has changed by `step` [N/mm], and the node after it when the force has changed further
 * by `next`. In smooth contacts of three to forty nodes the ratio next / step was 1.2 to 1.9, at
 * any position of the edges between nodes, and up to 2.7 with the plate's nodes halfway between the
 * cylinder's. */
static double is_smooth(double step, double next) {
  return fmax(0, fmin(1, fmin(2 * next / step - 1, 4 - next / step)));
}

/* Adds the error terms of the edge of the stick zone on one side (-1 or 1) of the q-th sticking
 * node. */
static void add_end(sum_ends *e, int q, int side) {
  const shear_problem *h = &e->k->w->shear;
  const int out = h->list[q] + side, before = q - side;
  if (out < 0 || out >= e->k->p->count || before < 0 || before >= h->stuck) return;
  const double share = h->ones[q] / e->unit, rate = slip_rate(e, out);
  const double since = slipped(e, h->pick[q], side) / rate, until = until_slip(e, q),
               step = since + until;
  if (!(share > 0 && since >= 0 && until >= 0 && step > 0)) return;
  const double phase = since / step, smooth = is_smooth(step, until_slip(e, before) - until);
  const double weight = smooth * share * rate * step;
  e->terms.even += weight * (phase * (phase - 1) + 1.0 / 6) / 2;
  e->terms.odd += weight * step * phase * (phase - 0.5) * (phase - 1) / 3;
}

/* Adds the error terms of both edges of every stick zone in the present solution of the shear
 * problem. Returns 0 if the matrix of the nodes that stick is not positive definite. */
static int find_terms(friction_task *k, friction_terms *terms) {
  shear_problem *h = &k->w->shear;
  sum_ends e = {.k = k};
  if (arc_shear_factorise(h)) return 0;
  for (int q = 0; q < h->stuck; q++) e.unit += h->ones[q];
  for (int q = 0; q < h->stuck; q++) {
    if (q == 0 || h->list[q - 1] != h->list[q] - 1) add_end(&e, q, -1);
    if (q + 1 == h->stuck || h->list[q + 1] != h->list[q] + 1) add_end(&e, q, 1);
  }
  *terms = e.terms;
  return 1;
}

/* Solves the shear problem for a force along x [N/mm] on surfaces without shear, under the present
 * pressures. The iteration begins with the nodes that slip in the solution of the increment.
 * Returns 1 if solved, else 0. */
static int shear_unsheared(friction_task *k, double force) {
  shear_problem *h = &k->w->shear;
  double carried = 0;
  h->n = k->p->active;
  h->at = k->p->set;
  h->by_force = 1;
  h->total = force;
  for (int i = 0; i < h->n; i++) {
    h->bound[i] = k->step->mu * k->p->f[h->at[i]];
    h->drive[i] = 0;
    h->direction[i] = force > 0 && k->w->slip[h->at[i]] != 0;
    carried += h->bound[i];
  }
  if (force < (1 - 1e-9) * carried) return arc_shear_solve(h) == 1;
  for (int i = 0; i < h->n; i++) h->direction[i] = 1;
  return 1;
}

/* Computes *energy [N], the error of the sum over nodes for a rise of the tangential force by
 * `rise` [N/mm] at the present pressures. Returns 1 on success, else 0. */
static int sum_error(friction_task *k, double rise, double *energy) {
  friction_terms start, end;
  if (!shear_unsheared(k, 0) || !find_terms(k, &start)) return 0;
  if (!shear_unsheared(k, rise) || !find_terms(k, &end)) return 0;
  *energy = rise * (start.even + end.even) + start.odd - end.odd;
  return 1;
}

/* Returns the direction of slip (1 or -1) of the nearest slipping node on one side of a candidate
 * and writes its distance in nodes to *apart. Returns 0 if the contact ends before such a node. */
static int slip_beside(const friction_task *k, int from, int side, int *apart) {
  const double *slip = k->w->slip, *f = k->p->f;
  int c = from;
  while (c >= 0 && c < k->p->count && f[c] > 0 && slip[c] == 0) c += side;
  *apart = side * (c - from);
  return c < 0 || c >= k->p->count || f[c] == 0 ? 0 : slip[c] > 0 ? 1 : -1;
}

/* Estimates the reserves of the nodes for an unknown history of motion. A reserve is the friction
 * bound minus the shear force in the slip direction of the nearest slipping node or, if no node
 * slips, minus the magnitude of the shear force. */
static void guess_reserve(friction_task *k) {
  const double mu = k->step->mu;
  const friction_workspace *w = k->w;
  for (int c = 0; c < k->p->count; c++) {
    int left, right, apart[2];
    left = slip_beside(k, c, -1, &apart[0]);
    right = slip_beside(k, c, 1, &apart[1]);
    const int direction = apart[0] < apart[1] ? left : right;
    const double against = direction != 0 ? direction * w->t[c] : fabs(w->t[c]);
    w->reserve[c] = w->slip[c] == 0 ? fmax(0, mu * k->p->f[c] - against) : 0;
  }
}

/* Computes the reserves of the nodes from the last solution of the shear problem. */
static void take_reserve(friction_task *k) {
  const shear_problem *h = &k->w->shear;
  memset(k->w->reserve, 0, (size_t)k->p->count * sizeof *k->w->reserve);
  for (int i = 0; i < h->n; i++)
    if (h->direction[i] == 0) k->w->reserve[h->at[i]] = h->bound[i] - h->t[i];
}

/* Adds the error of the sum over nodes to the energy. The error is computed for a motion on
 * surfaces without shear, and doubled after a reversal. */
static void add_sum_error(friction_task *k, friction_state *s) {
  friction_memory *m = &s->memory;
  const int first = m->count == 1;
  double energy;
  if (!sum_error(k, arc_friction_rise(m, s->tangential), &energy)) return;
  take_reserve(k);
  if (!(first && m->fresh)) energy *= 2;
  const double more = first && !m->fresh ? 0 : energy - m->energy;
  s->between += more;
  s->energy += more;
  m->energy = energy;
}

void arc_friction_between(friction_task *k, friction_state *s) {
  guess_reserve(k);
  if (s->memory.sense == 0 || !shape_is_corrected(k->p->shape)) return;
  arc_friction_close_loops(s);
  add_sum_error(k, s);
}

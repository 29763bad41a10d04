/* The energy that slip dissipates between the nodes.
 *
 * Where a plate is pushed further and further under one load, nodes come to slip one by one, from
 * the edge of the contact inwards: node j once the force has risen by D_j since the plate turned.
 * From then on the plate gives way by C_j more per force. Up to a rise of D they dissipate
 *
 *   sum_j (mu / kappa) D_j C_j (D - D_j)
 *
 * with kappa f the shear that a node can take from there on, 2 mu f where it had slipped the other
 * way. Surfaces slip steadily: that sum should be an integral, and by Euler's and Maclaurin's
 * formula what it is off comes of its two ends alone, the edge of the contact and that of the zone
 * that sticks, and of where between two nodes each of them is. Measured by the force between one
 * node's slip and the next one's, that is known well: the inner node slips once its reserve r is
 * gone, by r / e at a share e of the force, and the outer one slips, by s at a rate of c per force,
 * since s / c. Beyond the edge of the contact kappa times the gap stands for s, as what normal load
 * is to pressures and gaps, force is to shear and slip. What is left are terms of fourth order in
 * the element. Bodies unlike each other have neither one pressure under one load nor shear that was
 * at its bound all around before: there the sum is left as it is. */
#include "core/contact/friction.h"
#include "core/base/dense.h"

#include <math.h>
#include <string.h>

/* Ends of the sum, on all sides: those it starts at, or those it has come to. */
typedef struct sum_ends {
  friction_task *k;
  const friction_state *s;
  int start;
  double unit; /* what a unit of motion takes to hold the nodes that stick [N/mm2] */
  friction_terms terms;
} sum_ends;

/* Slip of a candidate per force on the nodes that stick [mm2/N]. */
static double slip_rate(const sum_ends *e, int at) {
  const shear_problem *h = &e->k->w->shear;
  const double *column = &h->a[dense_at(0, at, h->ld)];
  double held = 0;
  for (int q = 0; q < h->stuck; q++) held += column[h->list[q]] * h->ones[q];
  return fabs(1 - held) / e->unit;
}

/* Slip of the node outside since the plate turned, with the gap there in terms of slip [mm]. */
static double slipped(const sum_ends *e, int out) {
  const pose *p = e->k->p;
  const friction_stretch *on = &e->s->stretch;
  const int at = p->lo + out;
  const double apart = p->f[out] > 0 ? 0 : on->kappa * p->open[out];
  return apart + (e->start ? 0 : on->sense * (e->s->way[at] - e->s->stood[at]));
}

/* Shear that the node inside has left [N/mm]. */
static double reserve(const sum_ends *e, int in) {
  const pose *p = e->k->p;
  const friction_stretch *on = &e->s->stretch;
  const int at = p->lo + in;
  const double had = on->kappa * p->f[in];
  return had - (e->start ? 0 : on->sense * (e->s->t[at] - e->s->held[at]));
}

/* Force until the q-th of the nodes that stick slips [N/mm]. */
static double until_slip(const sum_ends *e, int q) {
  const shear_problem *h = &e->k->w->shear;
  return reserve(e, h->list[q]) * e->unit / h->ones[q];
}

/* Whether nodes follow each other as they do where surfaces meet smoothly, by the steps from here
 * to the next node and to the one after that: their ratio is 1.2 to 1.8 for contacts of three nodes
 * or forty, wherever between nodes they end. 1, less at kinks of the surfaces, 0 at scars' edges.
 */
static double is_smooth(double step, double next) {
  return fmax(0, fmin(1, fmin(2 * next / step - 1, 3 - next / step)));
}

/* The end on one side of the q-th of the nodes that stick. */
static void add_end(sum_ends *e, int q, int side) {
  const shear_problem *h = &e->k->w->shear;
  const int out = h->list[q] + side, before = q - side;
  if (out < 0 || out >= e->k->p->count || before < 0 || before >= h->stuck) return;
  const double share = h->ones[q] / e->unit, rate = slip_rate(e, out);
  const double since = slipped(e, out) / rate, until = until_slip(e, q), step = since + until;
  if (!(share > 0 && since >= 0 && until >= 0 && step > 0)) return;
  const double phase = since / step, smooth = is_smooth(step, until_slip(e, before) - until);
  const double weight = smooth * e->k->step->mu / e->s->stretch.kappa * share * rate * step;
  e->terms.even += weight * (phase * (phase - 1) + 1.0 / 6) / 2;
  e->terms.odd += weight * step * phase * (phase - 0.5) * (phase - 1) / 3;
}

/* Both sides of every zone that sticks, by the ways of the shear problem. */
static friction_terms terms_of(friction_task *k, const friction_state *s, int start) {
  shear_problem *h = &k->w->shear;
  sum_ends e = {.k = k, .s = s, .start = start};
  if (arc_shear_factorise(h)) return e.terms;
  for (int q = 0; q < h->stuck; q++) e.unit += h->ones[q];
  for (int q = 0; q < h->stuck; q++) {
    if (q == 0 || h->list[q - 1] != h->list[q] - 1) add_end(&e, q, -1);
    if (q + 1 == h->stuck || h->list[q + 1] != h->list[q] + 1) add_end(&e, q, 1);
  }
  return e.terms;
}

/* The shear problem's ways: those of the solution, or none before anything slips. */
static void set_ways(friction_task *k, int start) {
  shear_problem *h = &k->w->shear;
  h->n = k->p->active;
  h->at = k->p->set;
  for (int i = 0; i < h->n; i++) h->way[i] = !start && k->w->slip[h->at[i]] != 0;
}

/* Which way the plate goes under a load that stays; 0: not known. */
static int sense_of(const friction_task *k, const friction_state *s) {
  static const double rounding = 1e-12;
  const double way = k->dx + k->w->shear.shift;
  if (k->step->mu == 0 || k->step->line != s->line) return 0;
  if (fabs(way) <= rounding * fabs(k->p->approach)) return s->stretch.sense;
  return way > 0 ? 1 : -1;
}

/* Whether the surfaces are not sheared, but for little. */
static int is_free(const friction_state *s, double mu) {
  static const double little = 0.1;
  double sum = 0;
  for (int i = 0; i < s->nc; i++) sum += fabs(s->t[i]);
  return sum <= little * mu * s->line;
}

void arc_friction_turn(friction_task *k, friction_state *s) {
  const double mu = k->step->mu;
  const int sense = sense_of(k, s), before = s->stretch.sense;
  if (sense == before) return;
  s->stretch =
      (friction_stretch){.sense = sense, .kappa = before ? 2 * mu : mu, .from = s->tangential};
  if (!k->g->alike || (!before && !is_free(s, mu))) s->stretch.kappa = 0;
  if (sense == 0 || s->stretch.kappa == 0) return;
  memcpy(s->held, s->t, (size_t)s->nc * sizeof *s->t);
  memcpy(s->stood, s->way, (size_t)s->nc * sizeof *s->way);
  set_ways(k, 1);
  s->stretch.start = terms_of(k, s, 1);
}

void arc_friction_between(friction_task *k, friction_state *s) {
  friction_stretch *on = &s->stretch;
  if (on->sense == 0 || on->kappa == 0) return;
  set_ways(k, 0);
  const friction_terms end = terms_of(k, s, 0);
  const double rise = on->sense * (s->tangential - on->from);
  const double energy = rise * (on->start.even + end.even) + on->start.odd - end.odd;
  s->energy += energy - on->energy;
  s->between += energy - on->energy;
  on->energy = energy;
}

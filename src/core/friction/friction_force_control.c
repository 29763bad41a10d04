/* Computes the displacement of the plate for a given tangential force. If all nodes slip at
 * constant pressures, many displacements have the same force. On inclined surfaces the pressures
 * change with the displacement, so the solution is unique. The force increases with the
 * displacement, so the solution can be bracketed. */
#include "core/base/dense.h"
#include "core/friction/friction.h"

#include <math.h>

enum { sweeps = 1000, doublings = 60, halvings = 200 };

/* Tolerance of the tangential force, relative to the load. */
static const double close_enough = 1e-13;

/* Sets the displacement of the plate to `dx` [mm] and updates the gaps of inclined surfaces. */
static void move_to(friction_task *k, double dx) {
  for (int c = 0; c < k->p->count; c++) k->w->gap[c] += k->p->slope[k->p->lo + c] * (dx - k->dx);
  k->dx = dx;
}

/* Returns the tangential force at a displacement dx [mm] minus the given force [N/mm]; NaN if the
 * sweeps fail. */
static double excess(friction_task *k, double dx) {
  double sum = -k->step->tangential;
  move_to(k, dx);
  if (arc_friction_sweeps(k, sweeps) != 1) return NAN;
  for (int c = 0; c < k->p->count; c++) sum += k->w->t[c] - k->p->slope[k->p->lo + c] * k->p->f[c];
  return sum;
}

typedef struct range {
  double x[2], off[2]; /* displacements [mm] at which the force is too small and too large; force
                          errors [N/mm] */
} range;

/* Brackets the displacement: doubles the distance from the initial displacement until the given
 * force lies between the forces of the last two trials. Returns 0 on failure. */
static int enclose(friction_task *k, range *r) {
  const contact_problem *p = k->p;
  const double from = k->dx, off = excess(k, from);
  if (isnan(off)) return 0;
  double step = 1e-3 * fabs(p->approach - p->gap[p->set[p->active / 2]]);
  const int side = off < 0;
  r->x[!side] = from;
  r->off[!side] = off;
  for (int i = 0; i < doublings; i++, step *= 2) {
    r->x[side] = from + (side ? step : -step);
    r->off[side] = excess(k, r->x[side]);
    if (isnan(r->off[side])) return 0;
    if ((r->off[side] > 0) == side) return 1;
    r->x[!side] = r->x[side];
    r->off[!side] = r->off[side];
  }
  return 0;
}

/* Narrows the bracket by secant steps, and by bisection in every third step. Returns 1 if the force
 * has converged, else 0. */
static int narrow(friction_task *k, range *r) {
  const double enough = close_enough * k->step->line;
  for (int i = 1; i <= halvings; i++) {
    const double share = i % 3 ? r->off[0] / (r->off[0] - r->off[1]) : 0.5;
    const double x = r->x[0] + share * (r->x[1] - r->x[0]), off = excess(k, x);
    if (isnan(off)) return 0;
    if (fabs(off) <= enough || x == r->x[0] || x == r->x[1]) return 1;
    r->x[off > 0] = x;
    r->off[off > 0] = off;
  }
  return 0;
}

int arc_friction_bracket(friction_task *k) {
  const double base = k->dx;
  range r;
  move_to(k, base + k->shift);
  k->w->shear.shift = 0;
  k->by_force = 0;
  k->w->bracketed = 1;
  const int found = enclose(k, &r) && narrow(k, &r);
  k->by_force = 1;
  k->over = 0;
  k->w->shear.shift = k->dx - base;
  move_to(k, base);
  return found;
}

/* One increment of Coulomb friction: pressures with shear held, shear with its bounds held, by
 * turns until gaps no longer change; each is a symmetric problem with a solver that always ends.
 * For similar bodies that is quick; where the coupling is strong coupled.c is tried in between. */
#include "core/contact/friction.h"
#include "core/base/dense.h"

#include <math.h>
#include <string.h>

enum { sweep_limit = 1000, limit_by_force = 50, first_newton = 4 };

/* Gaps may be off by this share of the elastic displacement. */
static const double settled = 1e-13;

/* --- the shear problem of an increment ----------------------------------------------------------
 */

/* More than friction carries is cut back, as it may be only on the way that it is too much. */
static void set_total(friction_task *k) {
  shear_problem *s = &k->g->shear;
  double carried = 0;
  s->total = k->step->tangential;
  for (int i = 0; i < s->n; i++) {
    carried += s->bound[i];
    s->total += k->p->slope[k->p->lo + s->at[i]] * k->p->f[s->at[i]];
  }
  k->over = fabs(s->total) >= carried;
  if (k->over) s->total = copysign((1 - 1e-9) * carried, s->total);
}

void arc_friction_set_shear(friction_task *k) {
  const pose *p = k->p;
  shear_problem *s = &k->g->shear;
  s->n = p->active;
  s->at = p->set;
  s->a = k->g->tt;
  s->ld = p->count;
  s->by_force = k->by_force;
  for (int i = 0; i < s->n; i++) {
    const int at = p->set[i];
    const double up = p->slope[p->lo + at] * (p->approach - k->approach);
    s->bound[i] = k->step->mu * p->f[at];
    s->drive[i] = k->dx + up + k->g->before[at] - arc_grip_dragged(k->g, p, at);
    s->way[i] = (k->g->slip[at] > 0) - (k->g->slip[at] < 0);
  }
  k->over = 0;
  if (s->by_force) set_total(k);
}

void arc_friction_take_shear(friction_task *k) {
  grip *g = k->g;
  memset(g->t, 0, (size_t)g->count * sizeof *g->t);
  memset(g->slip, 0, (size_t)g->count * sizeof *g->slip);
  for (int i = 0; i < g->shear.n; i++) {
    g->t[g->shear.at[i]] = g->shear.t[i];
    g->slip[g->shear.at[i]] = g->shear.way[i] != 0 ? g->shear.slip[i] : 0;
  }
}

/* --- sweeps ----------------------------------------------------------------------------------- */

/* The part of the load that the slopes' shear carries [N/mm]. */
static double carried_by_shear(const friction_task *k) {
  double sum = 0;
  for (int i = 0; i < k->p->count && !k->g->flat; i++)
    sum += k->p->slope[k->p->lo + i] * k->g->t[i];
  return sum;
}

static void set_gaps(friction_task *k) {
  for (int i = 0; i < k->p->count; i++)
    k->p->gap[i] = k->g->gap[i] + k->p->slope[k->p->lo + i] * k->shift + k->g->sheared[i];
}

/* The largest change of gaps in contact, by the displacement that pressures cause there. */
static double changed(const friction_task *k, const double *sheared) {
  double most = 0, all = 0;
  for (int i = 0; i < k->p->active; i++) {
    const int at = k->p->set[i];
    const double up = k->p->slope[k->p->lo + at] * (k->g->shear.shift - k->shift);
    most = fmax(most, fabs(sheared[at] - k->g->sheared[at] + up));
    all = fmax(all, fabs(k->p->approach - k->p->gap[at]));
  }
  return most / all;
}

/* The next sweep's shear: the new one or, where sweeps come back to where they were, on the way
 * there. */
static void take_over(friction_task *k, const double *sheared, double held) {
  const double share = k->g->sweeps < 20 ? 1 : k->g->sweeps < 100 ? 0.5 : 0.1;
  for (int i = 0; i < k->p->count; i++) k->g->sheared[i] += share * (sheared[i] - k->g->sheared[i]);
  k->shift += share * (k->g->shear.shift - k->shift);
  k->held += share * (held - k->held);
}

/* One sweep. Returns 1 where nothing changed any more, 0 where something did, -1 on breakdown. */
static int sweep(friction_task *k) {
  grip *g = k->g;
  double *sheared = g->work;
  set_gaps(k);
  if (arc_lcp_solve(k->p, k->step->line - k->held) != ARC_OK) return -1;
  arc_friction_set_shear(k);
  g->shear.iterations = 0;
  if (arc_shear_solve(&g->shear) != 1) return -1;
  g->iterations += k->p->iterations + g->shear.iterations;
  arc_friction_take_shear(k);
  arc_grip_gaps(g, k->p, g->t, sheared);
  const double held = carried_by_shear(k), change = changed(k, sheared);
  if (change <= settled && fabs(held - k->held) <= settled * k->step->line) return 1;
  take_over(k, sheared, held);
  return 0;
}

int arc_friction_sweeps(friction_task *k, int limit) {
  int trial = first_newton;
  k->g->newton = k->g->sweeps = 0;
  arc_grip_gaps(k->g, k->p, k->g->t, k->g->sheared);
  k->held = carried_by_shear(k);
  k->shift = k->g->shear.shift;
  while (k->g->sweeps < limit) {
    const int done = sweep(k);
    k->g->sweeps++;
    if (done != 0) return done;
    if (k->g->sweeps < trial) continue;
    trial *= 2;
    if (!k->over && arc_friction_newton(k)) return 1;
  }
  return 0;
}

static int solve(friction_task *k) {
  const int solved = arc_friction_sweeps(k, k->by_force ? limit_by_force : sweep_limit);
  return solved == 0 && k->by_force ? arc_friction_bracket(k) : solved;
}

/* As in pose.c: once more with what the drift of the compliance adds under the forces found. */
static int add_drift(friction_task *k) {
  pose *p = k->p;
  const size_t bytes = (size_t)p->count * sizeof *p->gap;
  double *gap = k->g->work;
  memcpy(gap, p->gap, bytes);
  memcpy(p->gap, k->g->gap, bytes);
  const int drifts = arc_pose_add_drift(p);
  memcpy(k->g->gap, p->gap, bytes);
  memcpy(p->gap, gap, bytes);
  return drifts;
}

/* --- increments ------------------------------------------------------------------------------- */

/* The approach at which the bodies touch [mm]. */
static double touch(const pose *p) {
  double least = p->gap[0];
  for (int c = 1; c < p->count; c++) least = fmin(least, p->gap[c]);
  return least;
}

/* A pose that has no solution yet starts from the nodes that touched. */
static void set_of(pose *p, const friction_state *s) {
  for (int c = 0; c < p->count; c++)
    if (s->f[p->lo + c] > 0) p->set[p->active++] = c;
}

static void begin(friction_task *k) {
  pose *p = k->p;
  grip *g = k->g;
  const double at = k->step->by_force ? k->from->x : k->step->x;
  arc_grip_update(g, p);
  if (p->active == 0) set_of(p, k->from);
  arc_grip_relative(p, k->from->u, g->work, g->before);
  for (int i = 0; i < p->count; i++) {
    g->gap[i] = p->gap[i] + p->slope[p->lo + i] * (at - p->x);
    g->t[i] = k->from->t[p->lo + i];
    g->slip[i] = k->from->slip[p->lo + i];
  }
  k->by_force = k->step->by_force;
  k->dx = at - k->from->x;
  k->approach = k->from->line > 0 ? k->from->approach : touch(p);
  g->shear.shift = 0;
  g->iterations = 0;
}

/* Slip of the candidates that do not touch. */
static void slip_of_open(friction_task *k) {
  const pose *p = k->p;
  grip *g = k->g;
  for (int c = 0, s = 0; c < p->count; c++) {
    if (s < p->active && p->set[s] == c) {
      s++;
      continue;
    }
    const double up = p->slope[p->lo + c] * (p->approach - k->approach);
    double slip = k->dx + g->shear.shift + up + g->before[c] - arc_grip_dragged(g, p, c);
    for (int i = 0; i < p->active; i++)
      slip -= g->tt[dense_at(p->set[i], c, p->count)] * g->t[p->set[i]];
    g->slip[c] = slip;
  }
}

static void take_forces(const friction_task *k, friction_state *s) {
  const pose *p = k->p;
  const grip *g = k->g;
  const size_t bytes = (size_t)s->nc * sizeof *s->f;
  double *before = k->g->work;
  memcpy(before, s->f, bytes);
  memset(s->f, 0, bytes);
  memset(s->t, 0, bytes);
  memset(s->slip, 0, bytes);
  s->tangential = 0;
  for (int c = 0; c < p->count; c++) {
    const int i = p->lo + c;
    s->f[i] = p->f[c];
    s->t[i] = g->t[c];
    s->slip[i] = g->slip[c];
    s->way[i] += g->slip[c];
    s->tangential += g->t[c] - p->slope[i] * p->f[c];
    s->energy += k->step->mu * (before[i] + p->f[c]) / 2 * fabs(g->slip[c]);
  }
}

static void commit(friction_task *k, friction_state *s) {
  slip_of_open(k);
  take_forces(k, s);
  s->x += k->dx + k->g->shear.shift;
  if (!k->step->by_force) s->x = k->step->x;
  s->approach = k->p->approach;
  s->line = k->step->line;
  arc_grip_displace(k->p, k->g->flat, s->f, s->t, s->u, k->g->work);
}

/* Nothing touches any more. */
static void lift(friction_task *k, friction_state *s) {
  pose *p = k->p;
  memset(p->f, 0, (size_t)p->count * sizeof *p->f);
  memset(k->g->t, 0, (size_t)p->count * sizeof *k->g->t);
  memset(k->g->slip, 0, (size_t)p->count * sizeof *k->g->slip);
  p->approach = touch(p);
  for (int c = 0; c < p->count; c++) p->open[c] = p->gap[c] - p->approach;
  memset(s->f, 0, 3 * (size_t)s->nc * sizeof *s->f);
  memset(s->u[ARC_CYLINDER], 0, 2 * (size_t)(s->nc + s->np) * sizeof(double));
  s->line = s->tangential = 0;
  s->approach = p->approach;
  if (!k->step->by_force) s->x = k->step->x;
}

static arc_status slides(const friction_task *k, arc_error *error) {
  return arc_fail(error, ARC_ARGUMENT,
                  "friction does not carry the tangential force: %g N/mm under %g N/mm with a "
                  "coefficient of %g; the plate would slide without end",
                  k->step->tangential, k->step->line, k->step->mu);
}

arc_status arc_friction_solve(pose *p, grip *g, const friction_step *step, friction_state *s,
                              arc_error *error) {
  friction_task k = {.p = p, .g = g, .step = step, .from = s};
  if (step->line == 0 && (!step->by_force || step->tangential == 0)) {
    arc_grip_update(g, p);
    lift(&k, s);
    return ARC_OK;
  }
  if (step->by_force && step->line == 0) return slides(&k, error);
  begin(&k);
  int solved = solve(&k);
  if (solved == 1 && add_drift(&k)) solved = solve(&k);
  if (solved != 1) return arc_pose_broke_down(p, error);
  if (k.over) return slides(&k, error);
  const arc_status status = arc_pose_check_zone(p, error);
  if (status == ARC_OK) commit(&k, s);
  return status;
}

void arc_friction_follow(const pose *p, grip *g, friction_state *s) {
  arc_grip_update(g, p);
  arc_grip_displace(p, g->flat, s->f, s->t, s->u, g->work);
}

/* Solves one increment of Coulomb friction by sweeps. Each sweep solves for the pressures at
 * constant shear, and then for the shear at the friction bounds of these pressures. Sweeps are
 * repeated until the gaps no longer change. Both problems are symmetric, and their solvers always
 * terminate. The sweeps converge quickly for bodies of similar materials. If the coupling is
 * strong, the method of friction_newton.c is tried between sweeps. */
#include "core/friction/friction.h"
#include "core/base/dense.h"

#include <math.h>
#include <string.h>

enum { sweep_limit = 1000 };

/* Tolerance for changes of the gaps in a sweep, relative to the elastic displacement. */
static const double settled = 1e-13;

/* --- the shear problem of an increment -------------------------------------------------------- */

/* Sets the tangential force of the shear problem, capped at the limit of friction, which is the sum
 * of all bounds. Sets k->over if the force reaches this limit, which is an error only after
 * convergence. */
static void set_total(friction_task *k) {
  shear_problem *s = &k->w->shear;
  double carried = 0;
  s->total = k->step->tangential;
  for (int i = 0; i < s->n; i++) {
    carried += s->bound[i];
    s->total += k->p->slope[k->p->lo + s->at[i]] * k->p->f[s->at[i]];
  }
  k->over = fabs(s->total) >= carried;
  if (k->over) s->total = copysign((1 - 1e-9) * carried, s->total);
}

/* Sets up the shear problem for the present normal forces. The signs of w->slip are the initial
 * directions of slip (0: stick). */
static void set_shear(friction_task *k) {
  const contact_problem *p = k->p;
  shear_problem *s = &k->w->shear;
  s->n = p->active;
  s->at = p->set;
  s->a = k->g->tt;
  s->ld = p->count;
  s->by_force = k->by_force;
  arc_tangential_drag(k->g, p->f, p->set[0], p->set[p->active - 1] + 1, k->w->dragged);
  for (int i = 0; i < s->n; i++) {
    const int at = p->set[i];
    const double up = p->slope[p->lo + at] * (p->approach - k->approach);
    s->bound[i] = k->step->mu * p->f[at];
    s->drive[i] = k->dx + up + k->w->before[at] - k->w->dragged[at];
    s->direction[i] = (k->w->slip[at] > 0) - (k->w->slip[at] < 0);
  }
  k->over = 0;
  if (s->by_force) set_total(k);
}

/* Copies the solution of the shear problem to w->t and w->slip, by candidate. */
static void take_shear(friction_task *k) {
  tangential_compliance *g = k->g;
  friction_workspace *w = k->w;
  memset(w->t, 0, (size_t)g->count * sizeof *w->t);
  memset(w->slip, 0, (size_t)g->count * sizeof *w->slip);
  for (int i = 0; i < w->shear.n; i++) {
    w->t[w->shear.at[i]] = w->shear.t[i];
    w->slip[w->shear.at[i]] = w->shear.direction[i] != 0 ? w->shear.slip[i] : 0;
  }
}

/* --- sweeps ----------------------------------------------------------------------------------- */

/* Returns the part of the load that shear on inclined surfaces carries [N/mm]. */
static double carried_by_shear(const friction_task *k) {
  double sum = 0;
  for (int i = 0; i < k->p->count && !k->g->flat; i++)
    sum += k->p->slope[k->p->lo + i] * k->w->t[i];
  return sum;
}

static void set_gaps(friction_task *k) {
  for (int i = 0; i < k->p->count; i++)
    k->p->gap[i] = k->w->gap[i] + k->p->slope[k->p->lo + i] * k->shift + k->w->sheared[i];
}

/* Returns the largest change [-] of the gaps of nodes in contact in this sweep, relative to the
 * largest displacement caused by pressures. */
static double changed(const friction_task *k, const double *sheared) {
  double most = 0, all = 0;
  for (int i = 0; i < k->p->active; i++) {
    const int at = k->p->set[i];
    const double up = k->p->slope[k->p->lo + at] * (k->w->shear.shift - k->shift);
    most = fmax(most, fabs(sheared[at] - k->w->sheared[at] + up));
    all = fmax(all, fabs(k->p->approach - k->p->gap[at]));
  }
  return most / all;
}

/* Sets the shear of the next sweep: the new shear, or after 20 sweeps a weighted mean of the old
 * and the new shear, which damps oscillations. */
static void take_over(friction_task *k, const double *sheared, double held) {
  const double share = k->w->sweeps < 20 ? 1 : k->w->sweeps < 100 ? 0.5 : 0.1;
  for (int i = 0; i < k->p->count; i++) k->w->sheared[i] += share * (sheared[i] - k->w->sheared[i]);
  k->shift += share * (k->w->shear.shift - k->shift);
  k->held += share * (held - k->held);
}

/* Makes one sweep. Returns 1 if the gaps have converged, 0 if not, -1 if the solver for pressures
 * or shear fails. */
static int sweep(friction_task *k) {
  tangential_compliance *g = k->g;
  friction_workspace *w = k->w;
  double *sheared = w->work;
  set_gaps(k);
  if (arc_lcp_solve(k->p, k->step->line - k->held) != ARC_OK) return -1;
  if (k->p->active == 0) return -1; /* on steep slopes the shear can carry more than the load */
  set_shear(k);
  w->shear.iterations = 0;
  if (arc_shear_solve(&w->shear) != 1) return -1;
  w->iterations += k->p->iterations + w->shear.iterations;
  take_shear(k);
  arc_tangential_gaps(g, w->t, sheared);
  const double held = carried_by_shear(k);
  k->change = changed(k, sheared);
  if (k->change <= settled && fabs(held - k->held) <= settled * k->step->line) return 1;
  take_over(k, sheared, held);
  return 0;
}

/* Returns true if the sweeps converge quickly, as they do for similar materials once the active
 * sets are correct. */
static int is_closing_in(const friction_task *k, double before) {
  static const double quick = 0.02;
  return k->change < quick * before;
}

int arc_friction_sweeps(friction_task *k, int limit) {
  int trial = k->w->sweeps_before_newton;
  k->w->newton = k->w->sweeps = 0;
  arc_tangential_gaps(k->g, k->w->t, k->w->sheared);
  k->held = carried_by_shear(k);
  k->shift = k->w->shear.shift;
  k->change = 0;
  while (k->w->sweeps < limit) {
    const double before = k->change;
    const int done = sweep(k);
    k->w->sweeps++;
    if (done != 0) return done;
    if (k->w->sweeps < trial || is_closing_in(k, before)) continue;
    trial *= 2;
    if (!k->over && arc_friction_newton(k)) return 1;
  }
  return 0;
}

static int solve(friction_task *k) {
  const int solved = arc_friction_sweeps(k, k->by_force ? k->w->by_force : sweep_limit);
  return solved == 0 && k->by_force ? arc_friction_bracket(k) : solved;
}

/* Corrects w->gap, the gaps without shear, by the forces times the change of the compliance since
 * the last condensation. Returns 0 if the compliance has not changed. */
static int add_compliance_change(friction_task *k) {
  contact_problem *p = k->p;
  const size_t bytes = (size_t)p->count * sizeof *p->gap;
  double *gap = k->w->work;
  memcpy(gap, p->gap, bytes);
  memcpy(p->gap, k->w->gap, bytes);
  const int changed = arc_contact_problem_add_compliance_change(p);
  memcpy(k->w->gap, p->gap, bytes);
  memcpy(p->gap, gap, bytes);
  return changed;
}

/* --- increments ------------------------------------------------------------------------------- */

/* Returns the approach at which the bodies touch [mm]. */
static double touch(const contact_problem *p) {
  double least = p->gap[0];
  for (int c = 1; c < p->count; c++) least = fmin(least, p->gap[c]);
  return least;
}

/* Initialises the active set with the nodes that were in contact before the increment. */
static void set_of(contact_problem *p, const friction_state *s) {
  for (int c = 0; c < p->count; c++)
    if (s->f[p->lo + c] > 0) p->set[p->active++] = c;
}

/* Updates the tangential matrices. The factor of the shear problem is reused only if the matrices
 * have not changed. */
static void reuse_factor(tangential_compliance *g, const contact_problem *p,
                         friction_workspace *w) {
  arc_tangential_update(g, p, w->work);
  if (w->compliance != g || w->version != g->version || w->x != g->x) w->shear.factored = 0;
  w->compliance = g;
  w->version = g->version;
  w->x = g->x;
}

static void begin(friction_task *k) {
  contact_problem *p = k->p;
  tangential_compliance *g = k->g;
  friction_workspace *w = k->w;
  const double at = k->step->by_force ? k->from->x : k->step->x;
  reuse_factor(g, p, w);
  if (p->active == 0) set_of(p, k->from);
  arc_tangential_relative(p, k->from->u, w->work, w->before);
  for (int i = 0; i < p->count; i++) {
    w->gap[i] = p->gap[i] + p->slope[p->lo + i] * (at - p->x);
    w->t[i] = k->from->t[p->lo + i];
    w->slip[i] = k->from->slip[p->lo + i];
  }
  k->by_force = k->step->by_force;
  k->dx = at - k->from->x;
  k->approach = k->from->line > 0 ? k->from->approach : touch(p);
  w->shear.shift = 0;
  w->iterations = w->bracketed = 0;
}

double arc_friction_slip(const friction_task *k, int candidate) {
  const contact_problem *p = k->p;
  const double up = p->slope[p->lo + candidate] * (p->approach - k->approach);
  return k->dx + k->w->shear.shift + up + k->w->before[candidate] - k->w->dragged[candidate];
}

/* Computes the slip of the candidates that are not in contact. */
static void slip_of_open(friction_task *k) {
  const contact_problem *p = k->p;
  friction_workspace *w = k->w;
  arc_tangential_drag_all(k->g, p->f, w->t, w->dragged);
  for (int c = 0, s = 0; c < p->count; c++) {
    const int touches = s < p->active && p->set[s] == c;
    s += touches;
    if (!touches) w->slip[c] = arc_friction_slip(k, c);
  }
}

static void take_forces(const friction_task *k, friction_state *s) {
  const contact_problem *p = k->p;
  friction_workspace *w = k->w;
  const size_t bytes = (size_t)s->nc * sizeof *s->f;
  double *before = k->w->work;
  memcpy(before, s->f, bytes);
  memset(s->f, 0, bytes);
  memset(s->t, 0, bytes);
  memset(s->slip, 0, bytes);
  s->tangential = 0;
  for (int c = 0; c < p->count; c++) {
    const int i = p->lo + c;
    s->f[i] = p->f[c];
    s->t[i] = w->t[c];
    s->slip[i] = w->slip[c];
    s->slip_path[i] += w->slip[c];
    s->tangential += w->t[c] - p->slope[i] * p->f[c];
    s->energy += k->step->mu * (before[i] + p->f[c]) / 2 * fabs(w->slip[c]);
  }
}

static void commit(friction_task *k, friction_state *s) {
  slip_of_open(k);
  arc_friction_turn(k, s);
  take_forces(k, s);
  s->x += k->dx + k->w->shear.shift;
  if (!k->step->by_force) s->x = k->step->x;
  s->approach = k->p->approach;
  s->line = k->step->line;
  arc_friction_between(k, s);
  arc_tangential_displace(k->p, k->g->flat, s->f, s->t, s->u, k->w->work);
}

/* Sets the solution and the state for bodies that are apart. */
static void lift(friction_task *k, friction_state *s) {
  contact_problem *p = k->p;
  memset(p->f, 0, (size_t)p->count * sizeof *p->f);
  memset(k->w->t, 0, (size_t)p->count * sizeof *k->w->t);
  memset(k->w->slip, 0, (size_t)p->count * sizeof *k->w->slip);
  p->approach = touch(p);
  for (int c = 0; c < p->count; c++) p->open[c] = p->gap[c] - p->approach;
  memset(s->f, 0, 3 * (size_t)s->nc * sizeof *s->f);
  memset(s->u[ARC_CYLINDER], 0, 2 * (size_t)(s->nc + s->np) * sizeof(double));
  s->line = s->tangential = 0;
  s->memory = (friction_memory){0};
  s->approach = p->approach;
  if (!k->step->by_force) s->x = k->step->x;
}

static arc_status slides(const friction_task *k, arc_error *error) {
  return arc_fail(
      error, ARC_ARGUMENT,
      "friction does not carry the tangential force: %g N/mm under a load of %g N/mm with "
      "a coefficient of %g; the plate would slide freely",
      k->step->tangential, k->step->line, k->step->mu);
}

arc_status arc_friction_solve(contact_problem *p, tangential_compliance *g, friction_workspace *w,
                              const friction_step *step, friction_state *s, arc_error *error) {
  friction_task k = {.p = p, .g = g, .w = w, .step = step, .from = s};
  if (step->line == 0 && (!step->by_force || step->tangential == 0)) {
    arc_tangential_update(g, p, w->work);
    lift(&k, s);
    return ARC_OK;
  }
  if (step->by_force && step->line == 0) return slides(&k, error);
  begin(&k);
  int solved = solve(&k);
  if (solved == 1 && add_compliance_change(&k)) solved = solve(&k);
  if (solved != 1) return arc_contact_problem_fail(p, error);
  if (k.over) return slides(&k, error);
  const arc_status status = arc_contact_problem_check_zone(p, error);
  if (status == ARC_OK) commit(&k, s);
  return status;
}

void arc_friction_forces_on(const contact_problem *p, friction_workspace *w, arc_body body,
                            double *force) {
  double *fx = w->work, *fy = fx + p->nc;
  memset(fx, 0, 2 * (size_t)p->nc * sizeof *fx);
  for (int k = 0; k < p->count; k++) {
    const double m = p->slope[p->lo + k];
    fx[p->lo + k] = w->t[k] - m * p->f[k];
    fy[p->lo + k] = p->f[k] + m * w->t[k];
  }
  if (body == ARC_CYLINDER) {
    memcpy(force, fx, 2 * (size_t)p->nc * sizeof *fx);
    return;
  }
  arc_contact_problem_to_plate(p, fx, force);
  arc_contact_problem_to_plate(p, fy, &force[p->np]);
  for (int l = 0; l < 2 * p->np; l++) force[l] *= -1;
}

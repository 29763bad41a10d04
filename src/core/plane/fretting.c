/* Wear of a cycle with friction. The bodies are pressed together on the present surfaces. Then the
 * cycle is solved with stick and slip, and repeated until it is periodic. The wear is computed from
 * the last repetition.
 *
 * Each computation starts with separated bodies. In the periodic cycle, the shear force at a node
 * that slips depends only on the cycle; at a node that never slips, it also depends on the
 * pressing. Therefore no shear forces are stored between updates, an update of the shape causes no
 * slip, and a stored run continues with identical results.
 *
 * The work, pressure times slip, is computed at the nodes of the cylinder, including nodes that are
 * in contact only at the start or the end of an increment. The mortar coupling transfers the same
 * work to the plate (Eq. 15 of the reference paper). */
#include "core/base/callbacks.h"
#include "core/base/carve.h"
#include "core/plane/cycle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { most_cycles = 40 };

/* Tolerance for a periodic cycle, as a fraction of the largest load. The differences of normal
 * force and shear force between start and end are summed over all nodes. */
static const double steady = 1e-6;

typedef struct fretting {
  arc_wear *w;
  const wear_window *window;
  wear_progress *progress;
  wear_rate *rate;
  arc_loop *loop;    /* fretting loop to record, or NULL */
  double *start;     /* [2 nc] normal forces on the cylinder nodes at the start of the cycle, then
                        shear forces [N/mm] */
  double *least;     /* [nc] smallest normal force on each cylinder node in the cycle [N/mm] */
  double *slid;      /* [nc] sum of |slip| of each cylinder node in the cycle [mm] */
  double *work, *on; /* [nc], [np] workspace for nodal values of the cylinder and of the plate */
  double between;    /* friction_state.between at the start of the cycle [N] */
} fretting;

static arc_status fretting_create(fretting *r) {
  const size_t nc = (size_t)r->w->nc, np = (size_t)r->w->np;
  const carve_part parts[] = {
      {&r->start, 2 * nc}, {&r->least, nc}, {&r->slid, nc}, {&r->work, nc}, {&r->on, np}};
  return ARC_CARVE(parts) ? ARC_OK : ARC_MEMORY;
}

static void fretting_free(fretting *r) {
  free(r->start);
}

/* --- one increment ---------------------------------------------------------------------------- */

/* Solves the increment that ends at point `at`. Errors: those of arc_friction_solve, and
 * ARC_STOPPED if a callback requests a stop. */
static arc_status advance(fretting *r, int at, const friction_step *step, arc_error *error) {
  wear_path *path = path_of(r->w);
  const int shared = path->block->problem_of[at];
  arc_status status = callbacks_check(r->progress->callbacks, error);
  if (status == ARC_OK) status = arc_wear_prepare(r->w, r->window, at, error);
  if (status != ARC_OK) return status;
  r->progress->solutions++;
  return arc_friction_solve(&path->problem[shared], &path->compliance[shared], &path->workspace,
                            step, &path->state, error);
}

/* Solves the increment that ends at point `at` and computes the wear rate at this point. */
static arc_status go_to(fretting *r, int at, arc_error *error) {
  arc_wear *w = r->w;
  wear_path *path = path_of(w);
  const wear_block *b = path->block;
  const friction_step step = {.mu = r->window->mu,
                              .line = b->line[at],
                              .by_force = b->tangential && r->window->mu > 0,
                              .x = b->tangential ? path->state.x : b->x[at],
                              .tangential = b->tangential ? b->tangential[at] : 0};
  wear_point *point = &path->point[at % 2];
  const arc_status status = advance(r, at, &step, error);
  if (status != ARC_OK) return status;
  return arc_wear_take(w, r->window, &path->problem[b->problem_of[at]], point, error);
}

/* Copies the last point of a cycle to point 0, the start of the next cycle. */
static void wrap(fretting *r) {
  wear_path *path = path_of(r->w);
  const int last = path->block->count - 1;
  if (last % 2 != 0) arc_path_copy(path, &path->point[1], &path->point[0]);
}

/* Returns true if pressing the bodies together causes shear. Half-planes of the same material do
 * not shear each other. Bodies of finite size do. Where Hertz' formulas apply, this shear is
 * neglected, because it changes the energy of a cycle by less than 1e-4 of its value. */
static int shear_when_pressed(const arc_wear *w) {
  const arc_model_def *model = arc_model_definition(w->model);
  return arc_contact_mismatch(model->geometry, model->material) != 0 ||
         !arc_model_is_hertzian(model);
}

/* Applies the load of point b->press of the cycle to separated bodies. With friction, the number of
 * increments is the default of arc_contact_solve. Without friction it is 1. */
static arc_status press(fretting *r, arc_error *error) {
  const wear_block *b = path_of(r->w)->block;
  const int has_friction = r->w->def.press == ARC_PRESS_FRICTION && shear_when_pressed(r->w);
  const int count = has_friction ? arc_friction_press_increments(r->w->model, b->load) : 1,
            at = b->press;
  const friction_step to = {
      .mu = has_friction ? r->window->mu : 0, .line = b->line[at], .x = b->x[at]};
  arc_status status = ARC_OK;
  for (int i = 1; i <= count && status == ARC_OK; i++) {
    const friction_step step = arc_friction_pressing(&to, i, count);
    status = advance(r, at, &step, error);
  }
  return status;
}

/* Separates the bodies, presses them together at point b->press, and solves the points from there
 * to the end of the cycle. If b->press is 0, only point 0 is solved. */
static arc_status approach(fretting *r, arc_error *error) {
  wear_path *path = path_of(r->w);
  friction_state *s = &path->state;
  const wear_block *b = path->block;
  for (int i = 0; i < path->problems; i++) path->problem[i].active = 0;
  path->workspace.shear.factored = 0;
  arc_friction_reset(s, b->x[b->press]);
  arc_status status = press(r, error);
  for (int at = b->press; at < b->count && b->press > 0 && status == ARC_OK; at++)
    status = go_to(r, at, error);
  if (b->press == 0 && status == ARC_OK) status = go_to(r, 0, error);
  if (b->press > 0) wrap(r);
  return status;
}

/* --- wear */

/* Adds the wear of both bodies, and the dissipated energy, for the pressures at one end of the
 * increment. `at` is the point at this end, and `share` is its weight. */
static void add_end(fretting *r, int at, double share) {
  const arc_wear *w = r->w;
  const wear_block *b = path_of(w)->block;
  const wear_point *point = &path_of(w)->point[at % 2];
  const contact_problem *p = &path_of(w)->problem[b->problem_of[at]];
  const double *slip = path_of(w)->state.slip;
  if (b->line[at] == 0) return; /* bodies are separated */
  for (int i = 0; i < w->nc; i++) {
    const double pressure = point->p[ARC_CYLINDER][i], sliding = share * b->repeat * fabs(slip[i]);
    r->work[i] = 0;
    if (pressure == 0 || sliding == 0) continue;
    r->work[i] = sliding * arc_wear_law_rubbed(w, pressure, r->window->mu);
    r->rate->energy += r->window->mu * pressure * p->wc[i] * sliding;
  }
  arc_wear_share(w, p, point, r->work, r->on, r->rate);
}

/* Returns true if all nodes in contact slip. Sets *most to the largest slip [mm]. */
static int slips_everywhere(const friction_state *s, double *most) {
  int touching = 0, stuck = 0;
  *most = 0;
  for (int i = 0; i < s->nc; i++) {
    if (!(s->f[i] > 0)) continue;
    touching++;
    stuck += s->slip[i] == 0;
    *most = fmax(*most, fabs(s->slip[i]));
  }
  return touching > 0 && stuck == 0;
}

/* Adds the contribution of point `at` to the Jacobian. The sliding distance of a plate node is the
 * work that the coupling transfers to the node, divided by the wear rate q of the node. `most` is
 * the largest slip of the increment [mm]. */
static void add_to_jacobian(fretting *r, int at, double most) {
  arc_wear *w = r->w;
  double *const sliding[ARC_BODIES] = {r->work, r->on};
  const double repeat = path_of(w)->block->repeat;
  const wear_point *point = &path_of(w)->point[at % 2];
  for (int i = 0; i < w->nc; i++)
    r->work[i] = fabs(path_of(w)->state.slip[i]) * point->q[ARC_CYLINDER][i];
  arc_contact_problem_transfer(&path_of(w)->problem[path_of(w)->block->problem_of[at]], r->work,
                               r->on);
  for (int i = 0; i < w->nc; i++) r->work[i] = repeat * fabs(path_of(w)->state.slip[i]);
  for (int l = 0; l < w->np; l++)
    r->on[l] = point->q[ARC_PLATE][l] > 0 ? repeat * r->on[l] / point->q[ARC_PLATE][l] : 0;
  arc_wear_jacobian_add(w, r->window, at, repeat * most, sliding);
}

static void note_increment(fretting *r, int at) {
  const arc_wear *w = r->w;
  const friction_state *s = &path_of(w)->state;
  wear_rate *rate = r->rate;
  double most;
  if (slips_everywhere(s, &most) && r->window->mu > 0) rate->gross = 1;
  rate->shear = fmax(rate->shear, fabs(s->tangential));
  const double *p = path_of(w)->point[at % 2].p[ARC_CYLINDER];
  for (int i = 0; i < s->nc; i++) {
    if (s->f[i] < r->least[i]) r->least[i] = s->f[i];
    if (p[i] > rate->peak) rate->peak = p[i];
    r->slid[i] += fabs(s->slip[i]);
  }
  if (r->window->tangent && s->line > 0) add_to_jacobian(r, at, most);
}

static void note_loop(fretting *r, int at) {
  if (!r->loop) return;
  ((double *)(size_t)r->loop->x)[at] = path_of(r->w)->state.x;
  ((double *)(size_t)r->loop->tangential)[at] = path_of(r->w)->state.tangential;
}

static arc_status add_increment(fretting *r, int at, arc_error *error) {
  const int mean = r->w->def.rule == ARC_TRAPEZOID;
  const arc_status status = go_to(r, at, error);
  if (status != ARC_OK) return status;
  if (mean) add_end(r, at - 1, 0.5);
  add_end(r, at, mean ? 0.5 : 1);
  note_increment(r, at);
  note_loop(r, at);
  return ARC_OK;
}

/* --- the cycle -------------------------------------------------------------------------------- */

static void begin_cycle(fretting *r) {
  const friction_state *s = &path_of(r->w)->state;
  const size_t nc = (size_t)s->nc;
  arc_wear_rate_clear(r->rate, s->nc + s->np);
  memcpy(r->start, s->f, nc * sizeof *s->f);
  memcpy(r->start + nc, s->t, nc * sizeof *s->t);
  memcpy(r->least, s->f, nc * sizeof *s->f);
  memset(r->slid, 0, nc * sizeof *r->slid);
  r->between = s->between;
  if (r->window->tangent) arc_wear_jacobian_clear(r->window->tangent);
  note_loop(r, 0);
}

/* Returns true if the nodal forces at the start and at the end of the cycle agree within the
 * tolerance `steady`. */
static int has_closed(const fretting *r) {
  const friction_state *s = &path_of(r->w)->state;
  const wear_block *b = path_of(r->w)->block;
  double off = 0;
  for (int i = 0; i < s->nc; i++)
    off += fabs(s->f[i] - r->start[i]) + fabs(s->t[i] - r->start[s->nc + i]);
  return off * arc_model_definition(r->w->model)->thickness <= steady * b->load;
}

/* Computes the stick width: the total width of the nodes that never slip, at most the contact
 * width. Nodes whose slip is a rounding error count as sticking. They occur if the tangential force
 * just reaches its earlier maximum. */
static void find_stick(fretting *r) {
  const wear_block *b = path_of(r->w)->block;
  static const double rounding = 1e-9;
  const shape_side *cylinder = &r->w->shape->side[ARC_CYLINDER];
  double most = 0;
  for (int i = 0; i < r->w->nc; i++) most = fmax(most, r->slid[i]);
  for (int i = 0; i < r->w->nc; i++)
    if (r->least[i] > 0 && r->slid[i] <= rounding * most)
      r->rate->stick += arc_shape_width(cylinder, i);
  double edges[2];
  arc_contact_problem_edges(&path_of(r->w)->problem[b->problem_of[b->count - 1]], r->window->shape,
                            edges);
  r->rate->stick = fmin(r->rate->stick, edges[1] - edges[0]);
}

/* Multiplies the wear rates, the Jacobian and the energy of the cycle by `share`. */
static void scale_rate(fretting *r, double share) {
  const size_t n = (size_t)(r->w->nc + r->w->np);
  for (size_t i = 0; i < n; i++) r->rate->node[ARC_CYLINDER][i] *= share;
  for (size_t i = 0; i < n * n && r->window->tangent; i++) r->window->tangent->value[i] *= share;
  r->rate->energy *= share;
}

/* Adds `energy`, which is dissipated between the nodes, and its wear: half at each of the two
 * outermost nodes in contact. */
static void add_edges(fretting *r, double energy) {
  const arc_wear *w = r->w;
  const int at = path_of(w)->block->count - 1;
  const wear_point *point = &path_of(w)->point[at % 2];
  const contact_problem *p = &path_of(w)->problem[path_of(w)->block->problem_of[at]];
  if (p->active == 0) return;
  memset(r->work, 0, (size_t)w->nc * sizeof *r->work);
  for (int side = 0; side < 2; side++) {
    const int i = p->lo + p->set[side ? p->active - 1 : 0];
    const double pressure = point->p[ARC_CYLINDER][i];
    if (pressure == 0) continue;
    const double force = r->window->mu * pressure * p->wc[i];
    r->work[i] += energy / 2 / force * arc_wear_law_rubbed(w, pressure, r->window->mu);
    r->rate->energy += energy / 2;
  }
  arc_wear_share(w, p, point, r->work, r->on, r->rate);
}

/* Distributes the energy that was dissipated between the nodes (see slip_energy.c), with its wear.
 * Each node receives a part in proportion to the energy dissipated at the node, at most equal to
 * that energy. The two outermost nodes in contact receive the remainder. */
static void add_between(fretting *r) {
  const double energy = path_of(r->w)->block->repeat * (path_of(r->w)->state.between - r->between);
  const double own = r->rate->energy, shared = fmin(energy, own);
  if (own + energy <= 0) return;
  if (own > 0) scale_rate(r, 1 + shared / own);
  if (energy > shared) add_edges(r, energy - shared);
}

static arc_status run_cycles(fretting *r, arc_error *error) {
  const wear_block *b = path_of(r->w)->block;
  arc_status status = approach(r, error);
  for (int cycle = 0; cycle < most_cycles && status == ARC_OK; cycle++) {
    if (cycle > 0) wrap(r);
    begin_cycle(r);
    for (int at = 1; at < b->count && status == ARC_OK; at++) status = add_increment(r, at, error);
    if (status != ARC_OK || !has_closed(r)) continue;
    find_stick(r);
    if (r->window->tangent) arc_wear_jacobian_finish(r->window->tangent);
    add_between(r);
    return ARC_OK;
  }
  if (status != ARC_OK) return status;
  return arc_fail(error, ARC_NOT_CONVERGED,
                  "the cycle of stick and slip is not periodic after %d repetitions", most_cycles);
}

static arc_status evaluate(fretting *r, arc_error *error) {
  arc_status status = fretting_create(r);
  if (status != ARC_OK)
    arc_fail(error, status, "out of memory for a cycle with friction");
  else
    status = run_cycles(r, error);
  fretting_free(r);
  return status;
}

arc_status arc_wear_fret(arc_wear *w, const wear_window *window, wear_progress *progress,
                         wear_rate *rate, arc_error *error) {
  fretting r = {.w = w, .window = window, .progress = progress, .rate = rate};
  return evaluate(&r, error);
}

/* --- the loop --------------------------------------------------------------------------------- */

/* Multiplies the forces of the loop by the thickness, and sets its energy, stick width and gross
 * slip. `rate` contains `repeat` times the energy of the loop, per thickness. */
static void finish_loop(arc_loop *loop, double repeat, double thickness, const wear_rate *rate) {
  double *tangential = (double *)(size_t)loop->tangential;
  for (size_t i = 0; i < loop->count; i++) tangential[i] *= thickness;
  loop->energy = rate->energy / repeat * thickness;
  loop->stick_width = rate->stick;
  loop->gross = rate->gross != 0;
}

arc_status arc_wear_fret_loop(arc_wear *w, const wear_window *window, wear_progress *progress,
                              arc_loop **loop, arc_error *error) {
  arc_status status = arc_path_enter(path_of(w), window->block, w->model, error);
  if (status != ARC_OK) return status;
  fretting r = {.w = w, .window = window, .progress = progress, .rate = &w->work.rate};
  status = arc_loop_create((size_t)window->block->count, &r.loop, error);
  if (status == ARC_OK) status = evaluate(&r, error);
  if (status == ARC_OK)
    finish_loop(*loop = r.loop, window->block->repeat, w->manner.thickness, r.rate);
  else
    free(r.loop);
  return status;
}

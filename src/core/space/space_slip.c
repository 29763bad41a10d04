/* Computes the slip of a steady cycle with friction. In gross slip each site begins to slip after
 * an elastic displacement, and no solver is needed. In partial slip each increment is solved for
 * stick and slip. Each evaluation begins with separated bodies, so it does not depend on earlier
 * evaluations. */
#include "core/base/carve.h"
#include "core/space/slip_cycle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t row_of(const slip_cycle *c, int at) {
  return (size_t)c->path->of[at] * (size_t)c->cells;
}

/* --- sums over a cycle ------------------------------------------------------------------------ */

static void clear(slip_cycle *c) {
  memset(c->path->slip, 0, (size_t)c->path->count * (size_t)c->cells * sizeof *c->path->slip);
  memset(c->total, 0, (size_t)c->cells * sizeof *c->total);
  c->whole = 0;
}

static void add_to(const slip_cycle *c, int at, double share) {
  double *slip = c->path->slip + row_of(c, at);
  for (int k = 0; k < c->cells; k++) slip[k] += share * c->slid[k];
}

/* Adds the slip of an increment, c->slid, multiplied by `times`, to the slip of the position at its
 * end. With the trapezoidal rule, adds half of it to each of the positions at both ends. */
static void add_increment(slip_cycle *c, int at, double times) {
  const double *p = c->pressure + row_of(c, at);
  const double share = times * c->block->repeat;
  int sticks = 0;
  if (c->w->def.rule == ARC_TRAPEZOID) {
    add_to(c, at - 1, share / 2);
    add_to(c, at, share / 2);
  } else {
    add_to(c, at, share);
  }
  for (int k = 0; k < c->cells; k++) {
    c->total[k] += c->slid[k];
    sticks += p[k] > 0 && c->slid[k] == 0;
  }
  if (sticks == 0) c->whole = 1;
}

/* --- gross slip ------------------------------------------------------------------------------- */

/* Computes for every position the elastic displacement under full friction [mm]. */
static void find_lags(const slip_cycle *c) {
  for (int j = 0; j < c->path->count; j++) {
    double *lag = c->lag + (size_t)j * (size_t)c->cells;
    arc_cerruti_along(c->h, 0, c->pressure + (size_t)j * (size_t)c->cells, lag);
    for (int k = 0; k < c->cells; k++) lag[k] *= c->v->mu;
  }
}

/* Computes the slip of each site in the increment to point `at`: the motion minus the change of the
 * elastic displacement. */
static void follow(const slip_cycle *c, int at) {
  const double motion = c->block->x[at] - c->block->x[at - 1], *lag = c->lag + row_of(c, at);
  for (int k = 0; k < c->cells; k++) {
    const double strain = fmax(-lag[k], fmin(c->strain[k] + motion, lag[k]));
    c->slid[k] = fabs(motion - (strain - c->strain[k]));
    c->strain[k] = strain;
  }
}

/* Returns true if every site in contact slips at some point of the cycle. */
static int all_slip(const slip_cycle *c) {
  for (int j = 0; j < c->path->count; j++)
    for (int k = 0; k < c->cells; k++)
      if (c->pressure[(size_t)j * (size_t)c->cells + (size_t)k] > 0 && c->total[k] == 0) return 0;
  return 1;
}

/* Computes the gaps due to the shear of gross slip, which is proportional to the elastic
 * displacement. */
static void add_gap(slip_cycle *c, int at) {
  const size_t from = row_of(c, at);
  const double *p = c->pressure + from, *lag = c->lag + from;
  double *gap = c->path->gap + from, *q = c->slid, most = 0, change = 0;
  for (int k = 0; k < c->cells; k++)
    q[k] = lag[k] > 0 ? c->v->mu * p[k] * c->strain[k] / lag[k] : 0;
  double *none = calloc((size_t)c->cells, sizeof *none),
         *now = calloc((size_t)c->cells, sizeof *now);
  if (none && now) {
    arc_cerruti_add_gap(c->h, (const double *const[2]){q, none}, now);
    for (int k = 0; k < c->cells; k++) {
      change = fmax(change, fabs(now[k] - gap[k]));
      most = fmax(most, fabs(now[k]));
      gap[k] = now[k];
    }
  }
  free(none);
  free(now);
  if (most > 0) c->path->unsteady = fmax(c->path->unsteady, change / most);
}

static void slide(slip_cycle *c) {
  find_lags(c);
  memset(c->strain, 0, (size_t)c->cells * sizeof *c->strain);
  for (int round = 0; round < 2; round++) {
    clear(c);
    for (int at = 1; at < c->block->count; at++) {
      follow(c, at);
      if (round == 0) continue;
      add_increment(c, at, 1);
    }
  }
  c->path->unsteady = 0;
  for (int at = 1; at < c->block->count && c->unlike; at++) {
    follow(c, at);
    add_gap(c, at);
  }
}

/* --- partial slip ----------------------------------------------------------------------------- */

arc_status arc_slip_solve(const slip_cycle *c, const arc_halfspace_increment *to,
                          arc_halfspace_friction *state, arc_error *error) {
  const arc_halfspace_options options = {.callbacks = c->progress->callbacks};
  c->progress->solutions++;
  return arc_halfspace_slide(c->h, c->depth, to, &options, state, NULL, error);
}

double arc_slip_reference(const wear_block *b) {
  return b->press > 0 ? (b->x[0] + b->x[(b->count - 1) / 2]) / 2 : b->x[0];
}

arc_status arc_slip_press(const slip_cycle *c, arc_halfspace_friction *state, arc_error *error) {
  enum { increments = 4 };
  const int rubs = c->unlike && c->w->def.press == ARC_PRESS_FRICTION, n = rubs ? increments : 1;
  arc_status status = ARC_OK;
  for (int i = 1; i <= n && status == ARC_OK; i++) {
    arc_halfspace_increment to = {.friction = rubs ? c->v->mu : 0,
                                  .pressure = c->unlike ? NULL : c->pressure + row_of(c, 0)};
    to.position =
        (arc_halfspace_position){.x = c->block->problem_x[0], .load = c->block->line[0] * i / n};
    status = arc_slip_solve(c, &to, state, error);
  }
  return status;
}

arc_halfspace_increment arc_slip_conditions(const slip_cycle *c, int at, double share) {
  const wear_block *b = c->block;
  const int from = at > 0 ? at - 1 : 0;
  const double left = 1 - share;
  arc_halfspace_increment to = {.friction = c->v->mu,
                                .by_force = {b->tangential && c->v->mu > 0, 0},
                                .pressure = c->unlike ? NULL : c->pressure + row_of(c, at)};
  to.position.x = left * b->problem_x[from] + share * b->problem_x[at];
  to.position.load = left * b->line[from] + share * b->line[at];
  to.xi[0] = left * b->x[from] + share * b->x[at] - arc_slip_reference(b);
  if (b->tangential) to.force[0] = left * b->tangential[from] + share * b->tangential[at];
  return to;
}

static void take_slip(slip_cycle *c, const arc_halfspace_friction *state) {
  for (int k = 0; k < c->cells; k++)
    c->slid[k] = state->stick[k] > 0 ? 0 : hypot(state->moved[0][k], state->moved[1][k]);
}

/* Copies the pressures of a state, and the gaps due to its shear, to point `at`. Does nothing
 * for like bodies, whose pressures do not depend on shear. */
static void take_pressures(const slip_cycle *c, int at, const arc_halfspace_friction *state) {
  if (!c->unlike) return;
  double *gap = c->path->gap + row_of(c, at);
  memcpy(c->pressure + row_of(c, at), state->pressure, (size_t)c->cells * sizeof *c->pressure);
  memset(gap, 0, (size_t)c->cells * sizeof *gap);
  arc_cerruti_add_gap(c->h, (const double *const[2]){state->q[0], state->q[1]}, gap);
}

/* Solves the increment to point `at` with the last solution at this point as initial guess, and
 * stores the new solution. */
static arc_status solve_again(const slip_cycle *c, int at, arc_halfspace_increment *to,
                              arc_halfspace_friction *state, arc_error *error) {
  to->guess = arc_space_guess_at(c->path, at);
  const arc_status status = arc_slip_solve(c, to, state, error);
  if (status == ARC_OK) arc_space_remember(c->path, at, state, c->cells);
  return status;
}

/* Solves the increment to point `at`, and adds its slip multiplied by `times`. */
static arc_status go_to(slip_cycle *c, int at, double times, arc_halfspace_friction *state,
                        arc_error *error) {
  arc_halfspace_increment to = arc_slip_conditions(c, at, 1);
  const arc_status status = solve_again(c, at, &to, state, error);
  if (status != ARC_OK) return status;
  take_slip(c, state);
  take_pressures(c, at, state);
  c->rate->shear = fmax(c->rate->shear, fabs(state->force[0]));
  if (at > 0) add_increment(c, at, times);
  return ARC_OK;
}

/* Returns true if the slip in the second half of a cycle is the reverse of the slip in the first
 * half. This is the case for like bodies under a constant load in a symmetric motion. */
static int returns(const slip_cycle *c) {
  const wear_block *b = c->block;
  const double *drive = b->tangential ? b->tangential : b->x;
  const int last = b->count - 1;
  if (c->unlike || last % 2 != 0) return 0;
  for (int i = 1; i <= last / 2; i++)
    if (b->line[i] != b->line[0] || b->line[last - i] != b->line[0] ||
        drive[i] != drive[last - i] || (drive[i] - drive[i - 1]) * (drive[last / 2] - drive[0]) < 0)
      return 0;
  return drive[0] == drive[last];
}

/* Returns the change of shear between two cycles, divided by the friction limit. */
static double change_of(const slip_cycle *c, const double *before,
                        const arc_halfspace_friction *state) {
  double change = 0, carried = 0;
  for (int k = 0; k < c->cells; k++) {
    change += fabs(state->q[0][k] - before[k]) + fabs(state->q[1][k] - before[c->cells + k]);
    carried += c->v->mu * state->pressure[k];
  }
  return carried > 0 ? change / carried : 0;
}

/* Repeats the cycle from point 0 until the shear no longer changes from cycle to cycle. */
static arc_status repeat(slip_cycle *c, arc_halfspace_friction *state, arc_error *error) {
  enum { most_cycles = 40 };
  static const double steady = 1e-4;
  const size_t bytes = (size_t)c->cells * sizeof(double);
  double *before = c->lag;
  for (int round = 0; round < most_cycles; round++) {
    arc_status status = ARC_OK;
    clear(c);
    for (int i = 0; i < 2; i++) memcpy(before + i * c->cells, state->q[i], bytes);
    for (int at = 1; at < c->block->count && status == ARC_OK; at++)
      status = go_to(c, at, 1, state, error);
    if (status != ARC_OK || change_of(c, before, state) <= steady) return status;
  }
  return arc_fail(error, ARC_NOT_CONVERGED,
                  "the cycle of stick and slip is not periodic after %d repetitions", most_cycles);
}

/* Returns an error if all cells slip under a force below the friction limit. The motion then
 * depends on how the directions of slip turn, which one increment does not resolve. */
static arc_status check_stick(const slip_cycle *c, arc_error *error) {
  if (!c->whole || !(c->v->mu > 0)) return ARC_OK;
  return arc_fail(
      error, ARC_ARGUMENT,
      "field 'tangential': expected a force under which some of the contact sticks, got "
      "%.8g N, %.6g of friction times the load; for gross slip give a stroke",
      c->rate->shear, c->rate->shear / (c->v->mu * c->block->line[1]));
}

/* Computes a cycle of bodies of equal elasticity with one increment per leg. The first increment is
 * half of a leg. Shear and slip are proportional to the motion or force, so those of a whole leg
 * are twice as large. */
static arc_status single(slip_cycle *c, arc_halfspace_friction *state, arc_error *error) {
  const wear_block *b = c->block;
  arc_halfspace_increment to = arc_slip_conditions(c, 1, 1);
  if (b->tangential) to.force[0] = (b->tangential[1] - b->tangential[0]) / 2;
  to.xi[0] = (b->x[1] - b->x[0]) / 2;
  memcpy(state->pressure, to.pressure, (size_t)c->cells * sizeof *state->pressure);
  const arc_status status = solve_again(c, 1, &to, state, error);
  if (status != ARC_OK) return status;
  take_slip(c, state);
  for (int i = 0; b->tangential && i < 2; i++)
    c->rate->shear = fmax(c->rate->shear, fabs(b->tangential[i]));
  if (!b->tangential) c->rate->shear = fabs(state->force[0]);
  add_increment(c, 1, 4);
  return b->tangential ? check_stick(c, error) : ARC_OK;
}

/* Computes a cycle from separated bodies. Initial guesses are used only from one repetition of the
 * cycle to the next. */
static arc_status several(slip_cycle *c, arc_halfspace_friction *state, arc_error *error) {
  arc_space_forget(c->path);
  arc_status status = arc_slip_press(c, state, error);
  if (status == ARC_OK) status = go_to(c, 0, 0, state, error);
  if (status != ARC_OK) return status;
  if (!returns(c)) return repeat(c, state, error);
  for (int at = 1; at <= (c->block->count - 1) / 2 && status == ARC_OK; at++)
    status = go_to(c, at, 2, state, error);
  return status;
}

static arc_status stick(slip_cycle *c, arc_error *error) {
  arc_halfspace_friction state;
  arc_status status = arc_halfspace_friction_begin(c->h, &state, error);
  if (status != ARC_OK) return status;
  c->path->unsteady = 0;
  clear(c);
  status =
      returns(c) && c->block->count == 3 ? single(c, &state, error) : several(c, &state, error);
  arc_halfspace_friction_end(&state);
  return status;
}

/* --- results ---------------------------------------------------------------------------------- */

static void average(double *a, double *b) {
  *a = *b = (*a + *b) / 2;
}

/* If the bodies are symmetric, averages the field of each position with its mirror image across the
 * motion, so that the bodies remain symmetric. If both bodies are also alike and the cycle has only
 * the middle position, averages with the mirror image along the motion, too. */
static void make_even(const slip_cycle *c, double *value) {
  const int nx = arc_halfspace_definition(c->h)->nx, nz = arc_halfspace_definition(c->h)->nz;
  const space_shape *s = space_shape_of(c->v->shape);
  const double *const depth[] = {s->depth[ARC_UPPER], s->depth[ARC_LOWER]};
  const int middle = !c->unlike && c->path->count == 1 && c->path->position[0].x == 0;
  const int evenly = !c->w->def.local_factor;
  const int across = evenly && arc_space_are_even(c->h, depth, 1),
            along = evenly && middle && arc_space_are_even(c->h, depth, 0);
  for (int i = 0; i < c->path->count * nx && across; i++)
    for (int k = 0; k < nz / 2; k++) average(&value[i * nz + k], &value[i * nz + nz - 1 - k]);
  for (int i = 0; i < nx / 2 && along; i++)
    for (int k = 0; k < nz; k++) average(&value[i * nz + k], &value[(nx - 1 - i) * nz + k]);
}

/* Returns the width of the stick zone [mm]. The shape of the zone is assumed to be similar to
 * that of the contact. */
static double stick_width(const slip_cycle *c) {
  const double *p = c->pressure + row_of(c, c->block->count - 1);
  const arc_halfspace_extent e = arc_halfspace_contact_extent(c->h, p);
  int stuck = 0, on = 0;
  for (int k = 0; k < c->cells; k++) {
    on += p[k] > 0;
    stuck += p[k] > 0 && c->total[k] == 0;
  }
  return on > 0 ? 2 * e.half_width * sqrt((double)stuck / on) : 0;
}

static double energy_of(const slip_cycle *c) {
  const size_t all = (size_t)c->path->count * (size_t)c->cells;
  double sum = 0;
  for (size_t k = 0; k < all; k++) sum += c->pressure[k] * c->path->slip[k];
  return c->v->mu * sum * arc_halfspace_site_area(c->h, ARC_UPPER);
}

static void finish(slip_cycle *c) {
  c->rate->gross = c->whole && c->v->mu > 0;
  c->rate->stick = stick_width(c);
  c->rate->energy = energy_of(c);
  for (int j = 0; j < c->path->count; j++) {
    double *slip = c->path->slip + (size_t)j * (size_t)c->cells;
    for (int k = 0; k < c->cells; k++) slip[k] /= c->path->position[j].weight;
  }
}

static int begin(slip_cycle *c) {
  const size_t n = (size_t)c->cells, fields = (size_t)(c->path->count > 2 ? c->path->count : 2);
  const carve_part parts[] = {
      {&c->slid, n}, {&c->lag, fields * n}, {&c->strain, n}, {&c->total, n}};
  c->rate->shear = 0;
  return ARC_CARVE(parts) != NULL;
}

/* Computes slip and shear of the cycle. Gross slip is tried if the motion is longer than a cell; if
 * it does not occur, the increments are solved. */
static arc_status run(slip_cycle *c, arc_error *error) {
  const wear_block *b = c->block;
  const double cell = arc_space_reach(arc_model_definition(c->w->model), b->load);
  if (b->travel > cell && !b->tangential) {
    slide(c);
    for (int at = 0; at < b->count; at++)
      c->rate->shear = fmax(c->rate->shear, c->v->mu * b->line[at]);
    if (all_slip(c)) return ARC_OK;
    c->rate->shear = 0;
  }
  return stick(c, error);
}

slip_cycle arc_slip_cycle(arc_wear *w, const wear_window *v, const double *const depth[ARC_BODIES],
                          space_path *path, double *pressure, wear_progress *progress,
                          wear_rate *rate) {
  const space_shape *s = space_shape_of(v->shape);
  return (slip_cycle){.w = w,
                      .v = v,
                      .block = v->block,
                      .h = s->grid->h,
                      .depth = depth,
                      .path = path,
                      .pressure = pressure,
                      .progress = progress,
                      .rate = rate,
                      .cells = space_sites(s, ARC_UPPER),
                      .unlike = path->gap != NULL};
}

arc_status arc_space_slip(arc_wear *w, const wear_window *v, const double *const depth[ARC_BODIES],
                          space_path *path, double *pressure, wear_progress *progress,
                          wear_rate *rate, arc_error *error) {
  const space_shear_kernels *kernels;
  slip_cycle c = arc_slip_cycle(w, v, depth, path, pressure, progress, rate);
  arc_status status = arc_cerruti_kernels(c.h, &kernels, error);
  if (status != ARC_OK) return status;
  make_even(&c, pressure);
  if (begin(&c))
    status = run(&c, error);
  else
    status = arc_fail(error, ARC_MEMORY, "out of memory for a cycle with friction");
  if (status == ARC_OK) {
    make_even(&c, path->slip);
    finish(&c);
  }
  free(c.slid);
  return status;
}

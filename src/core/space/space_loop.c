/* Traces the loop of a steady cycle with friction: tangential force against motion. */
#include "core/space/slip_cycle.h"

#include <stdlib.h>

enum { points_of_loop = 40 };

/* Returns true if the motion reverses at the start of an increment of a cycle in gross slip. The
 * force may then change sign within a motion that is much shorter than the increment. */
static int reverses(const slip_cycle *c, int at) {
  const double *x = c->block->x;
  return c->rate->gross != 0 && (at == 1 || (x[at] - x[at - 1]) * (x[at - 1] - x[at - 2]) <= 0);
}

/* Returns the number of parts into which an increment is divided: `parts`, or more after a
 * reversal. */
static int parts_of(const slip_cycle *c, int at, int parts) {
  enum { after_reversal = 16 };
  return reverses(c, at) && parts < after_reversal ? after_reversal : parts;
}

/* Returns load and motion at the end of part number `part` of an increment. After a reversal each
 * part is longer than the last one; elsewhere all are equal. The pressures at this point are known
 * only under a constant load. */
static arc_halfspace_increment part_of(const slip_cycle *c, int at, int part, int parts) {
  const double share = (double)part / parts;
  arc_halfspace_increment to = arc_slip_conditions(c, at, reverses(c, at) ? share * share : share);
  if (part < parts && c->block->line[at] != c->block->line[at - 1]) to.pressure = NULL;
  return to;
}

/* Computes one cycle with each increment divided into at least `least` parts. Stores the points of
 * the loop in *loop unless `loop` is NULL. */
static arc_status trace(const slip_cycle *c, int least, arc_halfspace_friction *state,
                        arc_loop *loop, arc_error *error) {
  double *x = loop ? (double *)(size_t)loop->x : NULL;
  double *force = loop ? (double *)(size_t)loop->tangential : NULL;
  size_t i = 0;
  for (int at = 1; at < c->block->count; at++) {
    const int parts = loop ? parts_of(c, at, least) : least;
    for (int part = at > 1; part <= parts; part++) {
      const arc_halfspace_increment to = part_of(c, at, part, parts);
      const arc_status status = part > 0 ? arc_slip_solve(c, &to, state, error) : ARC_OK;
      if (status != ARC_OK) return status;
      if (!loop) continue;
      x[i] = state->xi[0] + arc_slip_reference(c->block);
      force[i++] = state->force[0];
    }
  }
  return ARC_OK;
}

static arc_status trace_steady(const slip_cycle *c, int parts, arc_loop *loop, arc_error *error) {
  arc_halfspace_friction state;
  arc_status status = arc_halfspace_friction_begin(c->h, &state, error);
  if (status != ARC_OK) return status;
  const arc_halfspace_increment first = arc_slip_conditions(c, 0, 1);
  status = arc_slip_press(c, &state, error);
  if (status == ARC_OK) status = arc_slip_solve(c, &first, &state, error);
  if (status == ARC_OK) status = trace(c, 1, &state, NULL, error);
  if (status == ARC_OK) status = trace(c, parts, &state, loop, error);
  arc_halfspace_friction_end(&state);
  return status;
}

/* Computes the loop of a cycle from its slip solution. */
static arc_status draw(slip_cycle *c, arc_loop **loop, arc_error *error) {
  const int increments = c->block->count - 1;
  const int parts = increments < points_of_loop ? (points_of_loop - 1) / increments + 1 : 1;
  int points = 1;
  for (int at = 1; at <= increments; at++) points += parts_of(c, at, parts);
  arc_loop *made;
  arc_status status = arc_loop_create((size_t)points, &made, error);
  if (status != ARC_OK) return status;
  made->energy = c->rate->energy / c->block->repeat;
  made->stick_width = c->rate->stick;
  made->gross = c->rate->gross != 0;
  status = trace_steady(c, parts, made, error);
  if (status == ARC_OK)
    *loop = made;
  else
    free(made);
  return status;
}

arc_status arc_space_loop(arc_wear *w, const wear_window *v, wear_progress *progress,
                          arc_loop **loop, arc_error *error) {
  const space_shape *s = space_shape_of(v->shape);
  const double *const depth[] = {s->depth[ARC_UPPER], s->depth[ARC_LOWER]};
  const size_t cells = (size_t)space_sites(s, ARC_UPPER);
  space_path path;
  wear_rate *rate = &w->work.rate;
  arc_wear_rate_clear(rate, w->nc + w->np);
  arc_status status = arc_space_path(w, v, &path, error);
  if (status != ARC_OK) return status;
  double *pressure = calloc((size_t)path.count * cells + 1, sizeof *pressure);
  if (pressure)
    status = arc_space_solve_path(w, v, depth, &path, progress, pressure, rate, error);
  else
    status = arc_fail(error, ARC_MEMORY, "out of memory for a loop");
  slip_cycle c = arc_slip_cycle(w, v, depth, &path, pressure, progress, rate);
  if (status == ARC_OK) status = draw(&c, loop, error);
  free(pressure);
  arc_space_end_path(&path);
  return status;
}

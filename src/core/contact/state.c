/* Worn surfaces as they are stored, and from what was stored, which may be anybody's numbers: they
 * are checked before a node is put where they say. Leans on shape.c. */
#include "core/contact/shape.h"

#include <math.h>
#include <string.h>

arc_surface_state arc_shape_state(const arc_shape *shape, arc_body body) {
  const shape_side *side = &shape->side[body];
  return (arc_surface_state){side->n, side->own.n > 0, side->even,
                             side->h, side->xy,        side->settled};
}

/* --- checks ----------------------------------------------------------------------------------- */

static arc_status refuse(const shape_side *side, int node, const char *expected, double value,
                         arc_error *error) {
  return arc_fail(error, ARC_ARGUMENT, "the %s's surface node %d: expected %s, got %g",
                  arc_body_name(side->body->mesh->body), node, expected, value);
}

/* Wear even and local. */
static arc_status check_depths(const shape_side *side, const arc_surface_state *state,
                               arc_error *error) {
  for (int i = 0; i < side->n; i++)
    if (!(state->h[i] >= 0 && state->h[i] <= ARC_SHAPE_DEEPEST))
      return refuse(side, i, "a wear depth in mm", state->h[i], error);
  for (int i = 0; i < side->n; i++)
    if (!(state->even >= 0 && state->even <= state->h[i] * (1 + 1e-9) + 1e-12))
      return refuse(side, i, "an even wear of no more than its depth", state->even, error);
  return ARC_OK;
}

/* Nodes in order along x; none is farther from its unworn place than its way was long, but for what
 * the passage to other meshes blurs. */
static arc_status check_nodes(const shape_side *side, const arc_surface_state *state,
                              const double *xy, arc_error *error) {
  for (int i = 0; i < side->n; i++) {
    const double *top = arc_body_top(side->body, i), *at = &xy[2 * i];
    const double reach = 2 * (state->h[i] - state->even) + side->body->mesh->def.size;
    const double way = hypot(at[0] - top[0], at[1] - top[1]);
    if (!(way <= reach)) return refuse(side, i, "a place within its wear", way, error);
    if (i > 0 && !(at[0] > at[-2]))
      return refuse(side, i, "a place right of the node before", at[0], error);
  }
  return ARC_OK;
}

static arc_status check_state(const arc_shape *shape, const shape_side *side,
                              const arc_surface_state *state, arc_error *error) {
  if (state->count != side->n)
    return arc_fail(error, ARC_ARGUMENT, "%s: expected a state of %d surface nodes, got %d",
                    arc_body_name(side->body->mesh->body), side->n, state->count);
  arc_status status = check_depths(side, state, error);
  if (status == ARC_OK) status = check_nodes(side, state, state->xy, error);
  if (status == ARC_OK) status = check_nodes(side, state, state->settled, error);
  if (status != ARC_OK || shape->geometry == ARC_FROZEN) return status;
  status = arc_shape_check_box(shape, side, state->xy, error);
  return status == ARC_OK ? arc_shape_check_box(shape, side, state->settled, error) : status;
}

/* --- restoring -------------------------------------------------------------------------------- */

static arc_status restore_side(arc_shape *shape, arc_body body, const arc_surface_state *state,
                               arc_error *error) {
  shape_side *side = &shape->side[body];
  const size_t n = (size_t)side->n * sizeof(double);
  memcpy(side->h, state->h, n);
  memcpy(side->xy, state->xy, 2 * n);
  memcpy(side->settled, state->settled, 2 * n);
  shape->version = arc_model_next_version(shape->model);
  side->even = state->even;
  arc_shape_read_nodes(side);
  if (shape->geometry == ARC_MOVING) arc_shape_drift(side);
  return state->condensed ? arc_shape_condense(side, side->settled, &side->own, error) : ARC_OK;
}

arc_status arc_shape_restore(arc_model *model, arc_geometry geometry, double refresh,
                             const arc_surface_state state[ARC_BODIES], arc_shape **result,
                             arc_error *error) {
  arc_status status = arc_shape_create(model, geometry, refresh, result, error);
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    status = check_state(*result, &(*result)->side[b], &state[b], error);
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    status = restore_side(*result, (arc_body)b, &state[b], error);
  if (status != ARC_OK) arc_shape_destroy(result);
  return status;
}

/* Writes the state of worn surfaces to arrays, and restores surfaces from such arrays after checks
 * of all numbers. */
#include "core/contact/shape.h"

#include <math.h>
#include <string.h>

/* Pointers to the arrays in the state of one body. */
typedef struct surface_state {
  const double *h, *xy, *settled, *even, *condensed;
} surface_state;

/* List of the arrays of a body with n surface nodes: X(name, number of rows, numbers per row). */
#define ARRAYS(X)                                                                                  \
  X(h, n, 1)                                                                                       \
  X(xy, n, 2)                                                                                      \
  X(settled, n, 2)                                                                                 \
  X(even, 1, 1)                                                                                    \
  X(condensed, 1, 1)

void arc_shape_state(const arc_shape *shape, arc_array state[ARC_SHAPE_STATE]) {
  static const double flag[] = {0, 1};
  for (int b = 0; b < ARC_BODIES; b++) {
    const shape_side *side = &shape->side[b];
    const size_t n = (size_t)side->n;
    const surface_state all = {side->h, side->xy, side->settled, &side->even,
                               &flag[side->own.n > 0]};
#define PUT(name, rows, columns)                                                                   \
  *state++ = (arc_array){#name, (arc_body)b, 0, 0, {rows, columns}, all.name};
    ARRAYS(PUT)
#undef PUT
  }
}

/* --- checks ----------------------------------------------------------------------------------- */

static arc_status refuse(const shape_side *side, int node, const char *expected, double value,
                         arc_error *error) {
  return arc_fail(error, ARC_ARGUMENT, "the %s's surface node %d: expected %s, got %g",
                  arc_body_name(side->body->mesh->body), node, expected, value);
}

/* Checks that depths are valid and not less than the even wear. */
static arc_status check_depths(const shape_side *side, const surface_state *state,
                               arc_error *error) {
  for (int i = 0; i < side->n; i++)
    if (!(state->h[i] >= 0 && state->h[i] <= ARC_SHAPE_DEEPEST))
      return refuse(side, i, "a wear depth in mm", state->h[i], error);
  for (int i = 0; i < side->n; i++)
    if (!(*state->even >= 0 && *state->even <= state->h[i] * (1 + 1e-9) + 1e-12))
      return refuse(side, i, "an even wear of at most the wear depth", *state->even, error);
  return ARC_OK;
}

/* Checks that x increases from node to node, and that no node has moved farther than twice its wear
 * depth plus an element size, which allows for remeshed surfaces. */
static arc_status check_nodes(const shape_side *side, const surface_state *state, const double *xy,
                              arc_error *error) {
  for (int i = 0; i < side->n; i++) {
    const double *top = arc_body_top(side->body, i), *at = &xy[2 * i];
    const double reach = 2 * (state->h[i] - *state->even) + side->body->mesh->def.size;
    const double distance = hypot(at[0] - top[0], at[1] - top[1]);
    if (!(distance <= reach))
      return refuse(side, i, "a displacement consistent with its wear depth", distance, error);
    if (i > 0 && !(at[0] > at[-2]))
      return refuse(side, i, "x larger than at the previous node", at[0], error);
  }
  return ARC_OK;
}

static arc_status check_state(const arc_shape *shape, const shape_side *side,
                              const surface_state *state, arc_error *error) {
  arc_status status = check_depths(side, state, error);
  if (status == ARC_OK) status = check_nodes(side, state, state->xy, error);
  if (status == ARC_OK) status = check_nodes(side, state, state->settled, error);
  if (status != ARC_OK || shape->geometry == ARC_FROZEN) return status;
  status = arc_shape_check_box(shape, side, state->xy, error);
  return status == ARC_OK ? arc_shape_check_box(shape, side, state->settled, error) : status;
}

/* --- restoring -------------------------------------------------------------------------------- */

static arc_status restore_side(arc_shape *shape, arc_body body, const surface_state *state,
                               arc_error *error) {
  shape_side *side = &shape->side[body];
  const size_t n = (size_t)side->n * sizeof(double);
  memcpy(side->h, state->h, n);
  memcpy(side->xy, state->xy, 2 * n);
  memcpy(side->settled, state->settled, 2 * n);
  shape->version = arc_model_next_version(shape->handle.model);
  side->even = *state->even;
  arc_shape_read_nodes(side);
  arc_shape_find_compliance_change(shape, side);
  return *state->condensed != 0 ? arc_shape_condense(side, side->settled, &side->own, error)
                                : ARC_OK;
}

static arc_status find_array(const arc_array *state, size_t count, arc_body body, const char *name,
                             size_t rows, size_t columns, const double **values, arc_error *error) {
  const arc_array *found = arc_array_find(state, count, body, name);
  if (!found || found->size[0] != rows || found->size[1] != columns)
    return arc_fail(error, ARC_ARGUMENT, "the %s's state: expected %zu x %zu numbers '%s', got %zu",
                    arc_body_name(body), rows, columns, name, found ? arc_array_count(found) : 0);
  *values = found->values;
  return ARC_OK;
}

static arc_status find_state(const arc_array *state, size_t count, const shape_side *side,
                             surface_state *found, arc_error *error) {
  const arc_body body = side->body->mesh->body;
  const size_t n = (size_t)side->n;
  arc_status status = ARC_OK;
#define FIND(name, rows, columns)                                                                  \
  if (status == ARC_OK)                                                                            \
    status = find_array(state, count, body, #name, rows, columns, &found->name, error);
  ARRAYS(FIND)
#undef FIND
  return status;
}

arc_status arc_shape_restore(arc_model *model, arc_geometry geometry, double refresh,
                             const arc_array *state, size_t count, arc_shape **result,
                             arc_error *error) {
  surface_state found[ARC_BODIES];
  arc_status status = arc_shape_create(model, geometry, refresh, result, error);
  if (status == ARC_OK && count != ARC_SHAPE_STATE)
    status = arc_fail(error, ARC_ARGUMENT, "expected a state of %d arrays, got %zu",
                      ARC_SHAPE_STATE, count);
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    status = find_state(state, count, &(*result)->side[b], &found[b], error);
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    status = check_state(*result, &(*result)->side[b], &found[b], error);
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
    status = restore_side(*result, (arc_body)b, &found[b], error);
  if (status != ARC_OK) arc_shape_destroy(result);
  return status;
}

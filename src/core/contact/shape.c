/* Wears surfaces: moves nodes along their normals, moves the wear box with them, and recomputes the
 * compliance when necessary. */
#include "core/contact/shape.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static arc_status out_of_memory(arc_error *error) {
  return arc_fail(error, ARC_MEMORY, "out of memory for a worn shape");
}

/* Number of doubles per node in the arrays of a side. */
enum { side_arrays = 14 + ARC_THINNING_SPAN };

static arc_status allocate_side(shape_side *side, const elastic_body *body) {
  const size_t n = (size_t)body->mesh->surface;
  side->body = body;
  side->n = body->mesh->surface;
  side->h = calloc(side_arrays * n, sizeof(double)); /* one block for all arrays of a side */
  if (!side->h) return ARC_MEMORY;
  side->x0 = side->h + n;
  side->y = side->x0 + n;
  side->xy = side->y + n;
  side->settled = side->xy + 2 * n;
  side->level = side->settled + 2 * n;
  side->x = side->level + n;
  side->shift = side->x + n;
  side->compliance_change = side->shift + n;
  side->work = side->compliance_change + ARC_THINNING_SPAN * n;
  return ARC_OK;
}

void arc_shape_read_nodes(shape_side *side) {
  for (int i = 0; i < side->n; i++) {
    const double *now = &side->xy[2 * i], *top = arc_body_top(side->body, i);
    double chord[2];
    shape_chord(side->xy, side->n, i, chord);
    side->level[i] = now[1] - (now[0] - side->settled[2 * i]) * chord[1] / chord[0];
    side->x[i] = now[0];
    side->y[i] = now[1] + shape_inward(side) * side->even;
    side->shift[i] = hypot(now[0] - top[0], side->y[i] - top[1]);
  }
}

static void fill_unworn(shape_side *side) {
  for (int i = 0; i < side->n; i++) {
    const double *node = arc_body_top(side->body, i);
    side->x0[i] = node[0];
    memcpy(&side->xy[2 * i], node, 2 * sizeof(double));
  }
  memcpy(side->settled, side->xy, 2 * (size_t)side->n * sizeof(double));
  arc_shape_read_nodes(side);
}

static arc_status check_geometry(const arc_model *model, arc_geometry geometry, arc_error *error) {
  if (geometry == ARC_FROZEN || !arc_model_is_given(model)) return ARC_OK;
  return arc_fail(
      error, ARC_ARGUMENT,
      "field 'geometry': expected \"frozen\" on an imported mesh, got \"%s\": such a mesh has no "
      "wear box whose nodes could move with the surface",
      arc_geometry_names[geometry]);
}

arc_status arc_meshed_create(arc_model *model, arc_geometry geometry, double refresh,
                             arc_shape **result, arc_error *error) {
  *result = NULL;
  if (!(refresh >= 0))
    return arc_fail(error, ARC_ARGUMENT, "field 'refresh': expected a number >= 0, got %g",
                    refresh);
  const arc_status status = check_geometry(model, geometry, error);
  if (status != ARC_OK) return status;
  arc_shape *shape = calloc(1, sizeof *shape);
  if (!shape) return out_of_memory(error);
  shape->handle.model = arc_model_retain(model);
  shape->geometry = geometry;
  shape->refresh = refresh;
  shape->version = ARC_UNWORN_VERSION;
  for (int b = 0; b < ARC_BODIES; b++) {
    if (allocate_side(&shape->side[b], arc_model_body(model, (arc_body)b)) != ARC_OK) {
      arc_shape_destroy(&shape);
      return out_of_memory(error);
    }
    fill_unworn(&shape->side[b]);
  }
  *result = shape;
  return ARC_OK;
}

arc_status arc_meshed_copy(const arc_shape *shape, arc_shape **result, arc_error *error) {
  arc_shape *copy;
  const arc_status status =
      arc_shape_create(shape->handle.model, shape->geometry, shape->refresh, &copy, error);
  for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++) {
    const shape_side *from = &shape->side[b];
    shape_side *to = &copy->side[b];
    memcpy(to->h, from->h, side_arrays * (size_t)from->n * sizeof(double));
    to->even = from->even;
    to->compliance_changed = from->compliance_changed;
    to->own = arc_compliance_share(&from->own);
  }
  if (status == ARC_OK) copy->version = shape->version;
  if (status == ARC_OK) copy->corrections = shape->corrections;
  *result = copy;
  return status;
}

void arc_meshed_discard(arc_shape **shape) {
  if (!shape || !*shape) return;
  for (int b = 0; b < ARC_BODIES; b++) {
    free((*shape)->side[b].h);
    arc_compliance_free(&(*shape)->side[b].own);
  }
  arc_model_release(&(*shape)->handle.model);
  free(*shape);
  *shape = NULL;
}

/* Computes the position of node k of the wear box. The displacements in a column decrease from the
 * displacement of the surface to zero at the bottom. In a mesh without a wear box only the surface
 * nodes move. */
static void box_node_at(const shape_side *side, const double *surface_xy, double even, int k,
                        double xy[2]) {
  const arc_mesh *mesh = side->body->mesh;
  const int column = k / (mesh->rows + 1), row = k % (mesh->rows + 1);
  const double *top = arc_body_top(side->body, column);
  /* nodes at the sides of the box also belong to far elements, which do not move */
  const int side_column = column == 0 || column == side->n - 1;
  const double pull = mesh->rows > 0 ? arc_body_pull(side->body, column, row) : 1;
  const double share = side_column ? 0 : pull;
  for (int d = 0; d < 2; d++)
    xy[d] = side->body->box_at[2 * k + d] + share * (surface_xy[2 * column + d] - top[d]);
  if (!side_column && mesh->rows > 0 && arc_body_layers(&mesh->solid) > 0) {
    const double in = shape_inward(side), sunk = in * (surface_xy[2 * column + 1] - top[1]);
    xy[1] = side->body->box_at[2 * k + 1] + in * arc_shape_sink(side, sunk, even, column, row);
  }
}

void arc_shape_box(const shape_side *side, const double *surface_xy, double even, double *box_xy) {
  for (int k = 0; k < side->body->box_count; k++)
    box_node_at(side, surface_xy, even, k, &box_xy[2 * k]);
}

/* Returns the remaining thickness of the exposed layer at node i [mm]. */
static double left_of_layer(const shape_side *side, int i) {
  double end = 0;
  for (int n = 0; end <= side->h[i]; n++) end = arc_body_stratum(side->body, i, n).end;
  return end - side->h[i];
}

/* Returns true if node i has moved too far since the last condensation. Limit in depth: `share`
 * times the element's height or a fifth of the remaining layer thickness, whichever is smaller.
 * Limit along the surface: `share` / 100 times the element's width. Both limits have similar
 * effects on the pressure at the edge of a scar. */
static int gone_too_far(const shape_side *side, const double *xy, int i, double share) {
  const arc_mesh *mesh = side->body->mesh;
  const double *bottom = arc_body_bottom(side->body, i);
  const double height =
      fmin(fabs(bottom[1] - xy[2 * i + 1]) / mesh->rows, left_of_layer(side, i) / 5);
  const double along = fabs(xy[2 * i] - side->settled[2 * i]),
               across = fabs(xy[2 * i + 1] - side->settled[2 * i + 1]);
  return across > share * height || along > share / 100 * mesh->def.size;
}

/* Returns true if the slope at node i of the plate has changed by more than `limit` since the last
 * condensation. To first order the relative change of the pressures is the change of slope times
 * Dundurs' beta, which is 0 for equal materials. */
static int turned_too_far(const shape_side *side, const double *xy, int i, double limit) {
  double now[2], then[2];
  shape_chord(xy, side->n, i, now);
  shape_chord(side->settled, side->n, i, then);
  return fabs(now[1] / now[0] - then[1] / then[0]) > limit;
}

static int refresh_is_due(const arc_shape *shape, const shape_side *side, const double *xy) {
  static const double turn =
      0.002; /* accepted relative change of the pressure, divided by `refresh` */
  if (shape->geometry == ARC_FROZEN) return 0;
  /* `beta` is the relative change of the pressure per change of slope */
  const arc_model_def *def = arc_model_definition(shape->handle.model);
  const double beta = fabs(arc_contact_mismatch(def->geometry, def->material));
  const int inclines = side->body->mesh->body == ARC_PLATE && beta > 0 && !side->body->chart.polar;
  for (int i = 0; i < side->n; i++) {
    if (gone_too_far(side, xy, i, shape->refresh)) return 1;
    if (inclines && turned_too_far(side, xy, i, turn * shape->refresh / beta)) return 1;
  }
  return 0;
}

static int is_unworn(const shape_side *side) {
  for (int i = 0; i < side->n; i++)
    if (memcmp(&side->xy[2 * i], arc_body_top(side->body, i), 2 * sizeof(double))) return 0;
  return 1;
}

/* Sets the slopes of the surface in a compliance and, unless all slopes are zero, computes the
 * response along the normals. On polar charts (pins in holes) slopes remain 0: pressures act along
 * the radius on any worn surface. A pin that sinks into a hole rotates relative to the surfaces, so
 * slopes from its total displacement would not be more accurate, and they would change suddenly at
 * a condensation. */
static void incline(const shape_side *side, const double *xy, compliance *c) {
  int flat = 1;
  if (side->body->chart.polar) return;
  for (int i = 0; i < c->n; i++) {
    double chord[2];
    shape_chord(xy, c->n, i, chord);
    c->slope[i] = chord[1] / chord[0];
    flat = flat && c->slope[i] == 0;
  }
  if (!flat) arc_compliance_incline(c);
}

arc_status arc_shape_condense(const shape_side *side, const double *xy, compliance *result,
                              arc_error *error) {
  double *box = malloc(2 * (size_t)side->body->box_count * sizeof *box);
  arc_status status = box ? arc_compliance_create(result, side->n) : ARC_MEMORY;
  if (status != ARC_OK) {
    out_of_memory(error);
  } else {
    const double even = arc_shape_even_stiffening(side);
    arc_shape_box(side, xy, even, box);
    status = arc_body_condense(side->body, box, even, result, error);
    if (status == ARC_OK) incline(side, xy, result);
    if (status != ARC_OK) arc_compliance_free(result);
  }
  free(box);
  return status;
}

static void commit(shape_side *side, const double *depth, const double *xy) {
  for (int i = 0; i < side->n; i++) side->h[i] += depth[i];
  memcpy(side->xy, xy, 2 * (size_t)side->n * sizeof *xy);
  arc_shape_read_nodes(side);
}

static void settle(arc_shape *shape, shape_side *side, compliance renewed, const double *xy) {
  arc_compliance_free(&side->own);
  side->own = renewed;
  memcpy(side->settled, xy, 2 * (size_t)side->n * sizeof(double));
  arc_shape_read_nodes(side);
  shape->version = arc_model_next_version(shape->handle.model);
}

arc_status arc_shape_wear(arc_shape *shape, arc_body body, const double *depth, arc_error *error) {
  shape_side *side = &shape->side[body];
  double *xy = malloc(2 * (size_t)side->n * sizeof *xy);
  if (!xy) return out_of_memory(error);
  arc_shape_move(side, shape->geometry, depth, xy);
  arc_status status = shape->geometry == ARC_MOVING ? arc_shape_check_box(shape, side, xy, error)
                                                    : arc_shape_check_depth(side, depth, error);
  compliance renewed = {0};
  const int due = status == ARC_OK && !side->ahead && refresh_is_due(shape, side, xy);
  if (due) status = arc_shape_condense(side, xy, &renewed, error);
  if (status == ARC_OK) {
    commit(side, depth, xy);
    side->ahead = 0;
    if (due) settle(shape, side, renewed, side->xy);
    arc_shape_find_compliance_change(shape, side);
  }
  free(xy);
  return status;
}

arc_status arc_shape_look_ahead(arc_shape *shape, arc_body body, const double *depth,
                                arc_error *error) {
  shape_side *side = &shape->side[body];
  double *xy = malloc(2 * (size_t)side->n * sizeof *xy);
  if (!xy) return out_of_memory(error);
  arc_shape_move(side, shape->geometry, depth, xy);
  compliance renewed = {0};
  arc_status status = ARC_OK;
  const int due =
      refresh_is_due(shape, side, xy) && arc_shape_check_box(shape, side, xy, NULL) == ARC_OK;
  if (due) status = arc_shape_condense(side, xy, &renewed, error);
  if (due && status == ARC_OK) {
    settle(shape, side, renewed, xy);
    arc_shape_find_compliance_change(shape, side);
  }
  side->ahead = 1;
  free(xy);
  return status;
}

/* Computes the compliance of one body for a geometry. *renewed is empty (n = 0) if the unworn
 * compliance applies. */
static arc_status compliance_for(const arc_shape *shape, const shape_side *side,
                                 arc_geometry geometry, compliance *renewed, arc_error *error) {
  *renewed = (compliance){0};
  if (geometry == ARC_FROZEN || (is_unworn(side) && arc_shape_even_stiffening(side) == 0))
    return ARC_OK;
  const arc_status status = arc_shape_check_box(shape, side, side->xy, error);
  return status == ARC_OK ? arc_shape_condense(side, side->xy, renewed, error) : status;
}

arc_status arc_shape_set_geometry(arc_shape *shape, arc_geometry geometry, double refresh,
                                  arc_error *error) {
  compliance renewed[ARC_BODIES] = {{0}};
  arc_status status = check_geometry(shape->handle.model, geometry, error);
  if (status != ARC_OK) return status;
  if (geometry != shape->geometry) {
    for (int b = 0; b < ARC_BODIES && status == ARC_OK; b++)
      status = compliance_for(shape, &shape->side[b], geometry, &renewed[b], error);
    if (status != ARC_OK) {
      for (int b = 0; b < ARC_BODIES; b++) arc_compliance_free(&renewed[b]);
      return status;
    }
    for (int b = 0; b < ARC_BODIES; b++) {
      settle(shape, &shape->side[b], renewed[b], shape->side[b].xy);
      shape->side[b].compliance_changed = 0;
    }
  }
  shape->geometry = geometry;
  shape->refresh = refresh;
  return ARC_OK;
}

void arc_shape_set_corrections(arc_shape *shape, arc_corrections corrections) {
  if (corrections == shape->corrections) return;
  shape->corrections = corrections;
  for (int b = 0; b < ARC_BODIES; b++) arc_shape_find_compliance_change(shape, &shape->side[b]);
}

arc_status arc_shape_put(arc_shape *shape, arc_body body, const double *shift_x,
                         const double *shift_y, const double *h, double even, arc_error *error) {
  shape_side *side = &shape->side[body], put = *side;
  compliance renewed = {0};
  put.xy = malloc(2 * (size_t)side->n * sizeof *put.xy);
  if (!put.xy) return out_of_memory(error);
  for (int i = 0; i < side->n; i++) {
    const double *top = arc_body_top(side->body, i);
    put.xy[2 * i] = top[0] + shift_x[i];
    put.xy[2 * i + 1] = top[1] + shift_y[i];
  }
  const arc_status status = compliance_for(shape, &put, shape->geometry, &renewed, error);
  if (status == ARC_OK) {
    memcpy(side->xy, put.xy, 2 * (size_t)side->n * sizeof *put.xy);
    side->even = even;
    for (int i = 0; i < side->n; i++) side->h[i] = h[i] + even;
    settle(shape, side, renewed, side->xy);
  }
  free(put.xy);
  return status;
}

/* Adds even wear to a body. A body with layers is condensed at every change of its even wear, so
 * the even wear at the last condensation is not stored. */
arc_status arc_shape_wear_evenly(arc_shape *shape, arc_body body, double depth, arc_error *error) {
  shape_side *side = &shape->side[body];
  shape_side worn = *side;
  compliance renewed = {0};
  worn.even += depth;
  const int felt = shape->geometry == ARC_MOVING && arc_shape_even_stiffening(&worn) > 0;
  const arc_status status = felt ? arc_shape_condense(&worn, side->xy, &renewed, error) : ARC_OK;
  if (status != ARC_OK) return status;
  side->even = worn.even;
  for (int i = 0; i < side->n; i++) side->h[i] += depth;
  if (felt) {
    settle(shape, side, renewed, side->xy);
    arc_shape_find_compliance_change(shape, side);
  } else {
    arc_shape_read_nodes(side);
  }
  return ARC_OK;
}

arc_profile arc_meshed_profile(const arc_shape *shape, arc_body body) {
  const shape_side *side = &shape->side[body];
  return (arc_profile){side->n, side->x0, side->h, side->y, side->x, side->shift};
}

double arc_meshed_depth(const arc_shape *shape, arc_body body) {
  const shape_side *side = &shape->side[body];
  double depth = side->h[0];
  for (int i = 1; i < side->n; i++) depth = fmax(depth, side->h[i]);
  return depth;
}

double arc_shape_risen(const arc_shape *shape, arc_body body) {
  return shape->geometry == ARC_MOVING ? arc_shape_even_stiffening(&shape->side[body]) : 0;
}

void arc_shape_nodes(const arc_shape *shape, arc_body body, double *xy) {
  const shape_side *side = &shape->side[body];
  const arc_mesh *mesh = side->body->mesh;
  const double even = arc_shape_risen(shape, body);
  memcpy(xy, mesh->xy, 2 * (size_t)mesh->nodes * sizeof *xy);
  for (int k = 0; k < side->body->box_count; k++) {
    double at[2];
    box_node_at(side, side->xy, even, k, at);
    arc_chart_to_space(&side->body->chart, 1, at, &xy[2 * mesh->box_node[k]]);
  }
}

size_t arc_shape_bytes(const arc_shape *shape) {
  size_t bytes = sizeof *shape;
  for (int b = 0; b < ARC_BODIES; b++) {
    const size_t n = (size_t)shape->side[b].n, own = (size_t)shape->side[b].own.n;
    bytes += side_arrays * n * sizeof(double) + (own > 0 ? arc_compliance_bytes((int)own) : 0);
  }
  return bytes;
}

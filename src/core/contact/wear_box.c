/* Checks that the elements of the wear box stay valid under worn surfaces, and computes the sizes
 * of deeper wear boxes. */
#include "core/contact/shape.h"

#include <math.h>
#include <stdio.h>

/* Fraction of the wear box's depth that must remain under each node. */
static const double thinnest = 0.1;

double arc_shape_box_depth(const shape_side *side) {
  const int middle = side->n / 2;
  return fabs(arc_body_bottom(side->body, middle)[1] - arc_body_top(side->body, middle)[1]);
}

/* Returns the number of rows of a wear box that is `needed` [mm] deep, or as deep as the bodies
 * allow. Returns 0 if the box cannot become deeper. */
static int deeper_rows(const arc_shape *shape, const arc_mesh *mesh, double needed) {
  if (arc_model_is_given(shape->handle.model)) return 0;
  const arc_model_def *def = arc_model_definition(shape->handle.model);
  const double height = mesh->def.height;
  const double rows = fmin(ceil(needed / height), floor(arc_model_deepest_box(def) / height));
  return rows > mesh->rows ? (int)rows : 0;
}

/* --- wear box with layers */

/* Returns the number of rows down to a depth [mm] in a column of the unworn box. */
static int rows_above(const elastic_body *body, const double *column, double depth) {
  int rows = 0;
  while (rows < body->mesh->rows && fabs(column[2 * rows + 3] - column[1]) <= depth * (1 + 1e-9))
    rows++;
  return rows;
}

double arc_shape_sink(const shape_side *side, double sunk, double even, int i, int row) {
  static const double thinnest_row =
      0.02; /* smallest height of a row in a worn layer, relative to mesh.height */
  const elastic_body *body = side->body;
  const arc_mesh *mesh = body->mesh;
  const double *column = arc_body_top(body, i);
  const double depth = fabs(column[2 * row + 1] - column[1]),
               bottom = fabs(column[2 * mesh->rows + 1] - column[1]);
  const int layers = arc_body_layers(&mesh->solid);
  double above = 0, sunk_above = sunk;
  for (int l = 0; l < layers; l++) {
    const double end = arc_body_interface(&mesh->solid, l);
    if (end > bottom - mesh->def.height / 2) break;
    const double left = rows_above(body, column, end) * thinnest_row * mesh->def.height;
    const double here = sunk - fmin(sunk + even, fmax(0, end - left));
    if (depth <= end * (1 + 1e-9))
      return sunk_above + (here - sunk_above) * (depth - above) / (end - above);
    above = end;
    sunk_above = here;
  }
  return sunk_above * (bottom - depth) / (bottom - above);
}

/* Returns the total thickness of the layers [mm]. */
static double depth_of_layers(const arc_mesh *mesh) {
  return arc_body_interface(&mesh->solid, arc_body_layers(&mesh->solid) - 1);
}

static int reaches_below_layers(const shape_side *side) {
  const arc_mesh *mesh = side->body->mesh;
  return arc_shape_box_depth(side) > depth_of_layers(mesh) + mesh->def.height / 2;
}

double arc_shape_even_stiffening(const shape_side *side) {
  const arc_mesh *mesh = side->body->mesh;
  const int moves = mesh->rows > 0 && depth_of_layers(mesh) > 0 && reaches_below_layers(side);
  return moves ? side->even : 0;
}

int arc_shape_layer_rows(const arc_shape *shape, arc_body body) {
  static const double noticed =
      0.01; /* even wear up to this fraction of the layers' thickness is neglected */
  const shape_side *side = &shape->side[body];
  const arc_mesh *mesh = side->body->mesh;
  const double deep = depth_of_layers(mesh);
  if (shape->geometry == ARC_FROZEN || side->even <= noticed * deep || reaches_below_layers(side))
    return 0;
  /* tolerance: where cells are coarse, the depth of a row on an interface may be off by a tenth */
  const int rows = deeper_rows(shape, mesh, 1.1 * deep + mesh->def.height);
  const int most = rows < ARC_SHAPE_MOST_ROWS ? rows : ARC_SHAPE_MOST_ROWS;
  return most > mesh->rows ? most : 0;
}

static arc_status refuse_wear(const arc_shape *shape, const shape_side *side, int i, double left,
                              double box, arc_error *error) {
  const arc_mesh *mesh = side->body->mesh;
  const int rows = deeper_rows(shape, mesh, 1.5 * fmax(box - left, box));
  char help[64] = "", size[64];
  if (arc_body_layers(&mesh->solid) > 0)
    snprintf(size, sizeof size, "%d rows, %.4g mm in all", mesh->rows, box);
  else
    snprintf(size, sizeof size, "%d rows of %g mm", mesh->rows, mesh->def.height);
  if (rows > 0) snprintf(help, sizeof help, "mesh.rows = %d, higher elements or ", rows);
  return arc_fail(
      error, ARC_GEOMETRY,
      "the %s's wear at x = %.4g mm leaves %.3g mm of its wear box of %s%s; use %ssmaller steps",
      arc_body_name(mesh->body), side->x0[i], left, size,
      rows > 0 ? ""
               : ", the largest number "
                 "that fits",
      help);
}

arc_status arc_shape_check_box(const arc_shape *shape, const shape_side *side, const double *xy,
                               arc_error *error) {
  const double box = arc_shape_box_depth(side);
  for (int i = 0; i < side->n; i++) {
    const double *bottom = arc_body_bottom(side->body, i);
    const double left = (bottom[1] - xy[2 * i + 1]) * shape_inward(side);
    if (left > thinnest * box && (i == 0 || xy[2 * i] > xy[2 * i - 2])) continue;
    return refuse_wear(shape, side, i, left, box, error);
  }
  return ARC_OK;
}

arc_status arc_shape_check_depth(const shape_side *side, const double *depth, arc_error *error) {
  for (int i = 0; i < side->n; i++) {
    const double deep = side->h[i] - side->even + depth[i];
    if (!(deep <= ARC_SHAPE_DEEPEST))
      return arc_fail(error, ARC_GEOMETRY,
                      "the %s's wear at x = %.4g mm is %g mm, at most %g mm are allowed",
                      arc_body_name(side->body->mesh->body), side->x0[i], deep, ARC_SHAPE_DEEPEST);
  }
  return ARC_OK;
}

/* Whether worn surfaces leave the wear boxes their elements, and what helps where they do not;
 * whether they are surfaces at all. */
#include "core/contact/shape.h"

#include <math.h>
#include <stdio.h>

/* An element of the wear box may lose this share of its height before the mesh counts as used up.
 */
static const double thinnest = 0.1;

double arc_shape_box_depth(const shape_side *side) {
  const int middle = side->n / 2;
  return fabs(arc_body_bottom(side->body, middle)[1] - arc_body_top(side->body, middle)[1]);
}

/* The rows of a deeper wear box, as far as the bodies have room; 0 where there is no deeper one. */
static int deeper_rows(const arc_shape *shape, const arc_mesh *mesh, double needed) {
  if (arc_model_is_given(shape->model)) return 0;
  const arc_model_def *def = arc_model_definition(shape->model);
  const double height = mesh->def.height;
  const double rows = fmin(ceil(needed / height), floor(arc_model_deepest_box(def) / height));
  return rows > mesh->rows ? (int)rows : 0;
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
      arc_body_name(mesh->body), side->x0[i], left, size, rows > 0 ? "" : ", the most that fit",
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
                      "the %s's wear at x = %.4g mm is %g mm, the most is %g mm",
                      arc_body_name(side->body->mesh->body), side->x0[i], deep, ARC_SHAPE_DEEPEST);
  }
  return ARC_OK;
}

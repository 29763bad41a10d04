/* Geometry of a worn surface: normals, lengths and areas. */
#include "core/contact/shape.h"

#include <math.h>
#include <string.h>

/* Returns the tributary width of node i of a surface [2 n] [mm]; for bodies of revolution the area
 * of its ring [mm2]. */
static double width_at(const shape_side *side, const double *xy, int i) {
  const revolution *r = &side->body->chart.revolved;
  const int a = i > 0 ? i - 1 : 0, b = i + 1 < side->n ? i + 1 : i;
  return (arc_revolution_area(r, xy[2 * b]) - arc_revolution_area(r, xy[2 * a])) / 2;
}

double arc_shape_width(const shape_side *side, int i) {
  return width_at(side, side->settled, i);
}

/* Computes the inward unit normal at a node; with frozen geometry it is vertical. */
static void normal_at(const shape_side *side, arc_geometry geometry, int i, double normal[2]) {
  const double in = shape_inward(side);
  normal[0] = 0;
  normal[1] = in;
  if (geometry == ARC_FROZEN) return;
  double chord[2];
  shape_chord(side->xy, side->n, i, chord);
  const double length = hypot(chord[0], chord[1]);
  normal[0] = -in * chord[1] / length;
  normal[1] = in * chord[0] / length;
}

double arc_shape_span(const arc_shape *shape, arc_body body, int i) {
  const shape_side *side = &shape->side[body];
  if (shape->geometry == ARC_FROZEN) return arc_shape_width(side, i);
  double chord[2];
  shape_chord(side->xy, side->n, i, chord);
  const double length = hypot(chord[0], chord[1]);
  if (!side->body->chart.revolved.on) return length / 2;
  return width_at(side, side->xy, i) * (length / chord[0]);
}

/* Returns turn_i of arc_shape_conserve, the cross product n_i x n_i+1 of the normals at
 * neighbouring nodes. Its sign is chosen so that it is twice the area between both nodes that unit
 * depths remove in addition to the areas h_i span_i. */
static double turn_after(const shape_side *side, arc_geometry geometry, int i) {
  double here[2], next[2];
  if (i + 1 == side->n) return 0;
  normal_at(side, geometry, i, here);
  normal_at(side, geometry, i + 1, next);
  return -shape_inward(side) * (here[0] * next[1] - here[1] * next[0]);
}

/* Corrects the depths by iteration, so that the polygon loses the area depth times span at each
 * node. If the nodes move by the depths h_i along their inward normals, the polygon loses sum (h_i
 * span_i + t_i / 2), where t_i = h_i h_i+1 turn_i. Half of t_i / 2 is assigned to node i, the other
 * half to node i + 1. */
void arc_shape_conserve(arc_shape *shape, arc_body body, double *depth) {
  enum { sweeps = 4 }; /* each sweep multiplies the error by about depth / radius of curvature */
  const shape_side *side = &shape->side[body];
  if (shape->geometry == ARC_FROZEN || side->body->chart.revolved.on) return;
  const int n = side->n;
  double *span = side->work, *area = span + n, *turn = area + n, *before = turn + n;
  for (int i = 0; i < n; i++) {
    span[i] = arc_shape_span(shape, body, i);
    area[i] = depth[i] * span[i];
    turn[i] = turn_after(side, shape->geometry, i);
  }
  for (int sweep = 0; sweep < sweeps; sweep++) {
    memcpy(before, depth, (size_t)n * sizeof *depth);
    for (int i = 0; i < n; i++) {
      const double left = i > 0 ? turn[i - 1] * before[i - 1] : 0;
      const double right = i + 1 < n ? turn[i] * before[i + 1] : 0;
      depth[i] = area[i] / (span[i] + (left + right) / 4);
    }
  }
}

void arc_shape_downward(const arc_shape *shape, arc_body body, double *down) {
  const shape_side *side = &shape->side[body];
  for (int i = 0; i < side->n; i++) {
    double normal[2];
    normal_at(side, shape->geometry, i, normal);
    down[i] = 1 / fabs(normal[1]);
  }
}

void arc_shape_move(const shape_side *side, arc_geometry geometry, const double *depth,
                    double *xy) {
  for (int i = 0; i < side->n; i++) {
    double normal[2];
    normal_at(side, geometry, i, normal);
    xy[2 * i] = side->xy[2 * i] + depth[i] * normal[0];
    xy[2 * i + 1] = side->xy[2 * i + 1] + depth[i] * normal[1];
  }
}

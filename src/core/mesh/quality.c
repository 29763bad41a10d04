/* Computes measures of the quality of elements: angles, aspect ratio and Jacobians. */
#include "archard/mesh.h"

#include <math.h>

static double length(const double *p, const double *q) {
  return hypot(q[0] - p[0], q[1] - p[1]);
}

/* Returns twice the signed area of the triangle p-q-r, which is four times the Jacobian of a
 * bilinear quadrilateral at corner q. */
static double corner_jacobian(const double *p, const double *q, const double *r) {
  return (r[0] - q[0]) * (p[1] - q[1]) - (r[1] - q[1]) * (p[0] - q[0]);
}

static void add_element(arc_quality *worst, const double *xy, const int *element) {
  const int corners = element[3] < 0 ? 3 : 4;
  double shortest = INFINITY, longest = 0, least = INFINITY, most = -INFINITY;
  for (int c = 0; c < corners; c++) {
    const double *p = &xy[2 * element[(c + corners - 1) % corners]];
    const double *q = &xy[2 * element[c]], *r = &xy[2 * element[(c + 1) % corners]];
    const double to_p = length(q, p), to_r = length(q, r), jacobian = corner_jacobian(p, q, r);
    const double cosine =
        ((p[0] - q[0]) * (r[0] - q[0]) + (p[1] - q[1]) * (r[1] - q[1])) / (to_p * to_r);
    const double angle = acos(fmax(-1, fmin(1, cosine))) * 180 / acos(-1);
    worst->smallest_angle = fmin(worst->smallest_angle, angle);
    worst->largest_angle = fmax(worst->largest_angle, angle);
    shortest = fmin(shortest, to_r);
    longest = fmax(longest, to_r);
    least = fmin(least, jacobian);
    most = fmax(most, jacobian);
  }
  worst->aspect = fmax(worst->aspect, longest / shortest);
  worst->smallest_jacobian = fmin(worst->smallest_jacobian, least);
  if (corners == 4) worst->jacobian_ratio = fmin(worst->jacobian_ratio, least / most);
}

static arc_quality quality_of(const arc_mesh *mesh, const double *xy, int elements) {
  arc_quality worst = {.smallest_angle = 180, .jacobian_ratio = 1, .smallest_jacobian = INFINITY};
  for (int e = 0; e < elements; e++) add_element(&worst, xy ? xy : mesh->xy, &mesh->element[4 * e]);
  return worst;
}

arc_quality arc_mesh_quality(const arc_mesh *mesh, const double *xy) {
  return quality_of(mesh, xy, mesh->elements);
}

arc_quality arc_mesh_box_quality(const arc_mesh *mesh, const double *xy) {
  return quality_of(mesh, xy, mesh->box_elements);
}

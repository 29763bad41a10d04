/* Mortar coupling: a dual basis psi on the cylinder's segments, biorthogonal to the cylinder's hat
 * functions, is integrated exactly against the plate's hat functions phi over the overlaps. Row i
 * of B is (1 / w_i) integral psi_i phi_l dx, with the width w_i of node i. Surfaces of revolution
 * are integrated over their area as seen from above, dA = 2 pi r dx, instead of x: widths are
 * areas, and forces act on whole rings.
 *
 * Pressures act along the common normal of both surfaces, which is the normal of the plate's
 * surface with slope m. A surface element ds = dx / cos, with the cosine of the slope angle,
 * carries p ds along the normal, which is p dx along y and -m p dx along x. The unknown f_k = p_k
 * w_k, with the width w_k along x, therefore represents the force f_k (-m_k, 1) on the cylinder.
 * The opposite forces act on the plate, distributed by B'. The gap is measured along y at a fixed x
 * and is 1 / cos times the gap along the normal. A displacement u changes the gap by u_y - m u_x,
 * which is the work of the force (-m, 1), so A is symmetric. With m_k = (B m)_k forces along x
 * balance as well, except for rounding errors. */
#include "core/contact/contact_problem.h"
#include "core/base/dense.h"
#include "core/base/wide.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Returns the coordinate x of node i; for surfaces of revolution the area from the axis to the
 * node. */
static double at(const contact_problem *p, const double *xy, int i) {
  return arc_revolution_area(p->revolved, xy[2 * i]);
}

/* Determines the cylinder nodes whose two segments lie completely over the plate's candidate
 * zone. */
static void find_candidates(contact_problem *p, const double *cyl, double plate_left,
                            double plate_right) {
  int lo = 1, hi = p->nc - 2;
  while (lo <= hi && cyl[2 * (lo - 1)] < plate_left) lo++;
  while (hi >= lo && cyl[2 * (hi + 1)] > plate_right) hi--;
  p->lo = lo;
  p->count = hi - lo + 1;
}

/* Returns the index l of the plate segment [l, l + 1] around x (in the cylinder's frame). */
static int plate_segment(const contact_problem *p, const double *plate, double x) {
  int low = 0, high = p->np - 2;
  while (low < high) {
    const int middle = (low + high + 1) / 2;
    if (at(p, plate, middle) + p->x <= x)
      low = middle;
    else
      high = middle - 1;
  }
  return low;
}

/* Adds the integrals of psi phi over the part [u, v] of the plate segment [left, right] to entry[0]
 * and entry[1], for the hat functions phi of the segment's two ends. The dual function psi is
 * linear over [a, b], from at_a to at_b. */
static void add_overlap(double left, double right, double a, double b, double at_a, double at_b,
                        double u, double v, double *entry) {
  static const double gauss = 0.57735026918962576451;
  for (int g = -1; g <= 1; g += 2) {
    const double x = (u + v) / 2 + g * gauss * (v - u) / 2;
    const double psi = at_a + (at_b - at_a) * (x - a) / (b - a);
    const double phi = (x - left) / (right - left), weight = (v - u) / 2 * psi;
    entry[0] += weight * (1 - phi);
    entry[1] += weight * phi;
  }
}

/* Adds to `row` the integrals over [a, b], one of the two segments beside a candidate node, where
 * the node's dual function psi is linear from at_a to at_b. */
static void add_segment(const contact_problem *p, const double *plate, double a, double b,
                        double at_a, double at_b, int first, double *row) {
  for (int l = plate_segment(p, plate, a); l < p->np - 1 && at(p, plate, l) + p->x < b; l++) {
    const double left = at(p, plate, l) + p->x, right = at(p, plate, l + 1) + p->x;
    const double u = fmax(a, left), v = fmin(b, right);
    if (v > u) add_overlap(left, right, a, b, at_a, at_b, u, v, &row[l - first]);
  }
}

/* Returns the length of the longest row of B: the largest number of plate nodes whose segments
 * overlap the two segments of one candidate. */
static int row_width(const contact_problem *p, const double *cyl, const double *plate) {
  int width = 2;
  for (int i = p->lo; i < p->lo + p->count; i++) {
    const int a = plate_segment(p, plate, at(p, cyl, i - 1));
    const int b = plate_segment(p, plate, at(p, cyl, i + 1)) + 1;
    if (b - a + 1 > width) width = b - a + 1;
  }
  return width;
}

static arc_status reserve_rows(contact_problem *p, int width) {
  if (width > p->width) {
    double *grown = realloc(p->b, (size_t)p->nc * (size_t)width * sizeof *grown);
    if (!grown) return ARC_MEMORY;
    p->b = grown;
    p->width = width;
  }
  memset(p->b, 0, (size_t)p->nc * (size_t)p->width * sizeof *p->b);
  return ARC_OK;
}

static void fill_row(contact_problem *p, int k, const double *cyl, const double *plate) {
  const int i = p->lo + k;
  const double a = at(p, cyl, i - 1), b = at(p, cyl, i), c = at(p, cyl, i + 1);
  double *row = &p->b[k * p->width];
  /* rows of B that would extend beyond the last plate node begin at an earlier node */
  int first = plate_segment(p, plate, a);
  if (first > p->np - p->width) first = p->np - p->width;
  if (first < 0) first = 0;
  p->first[k] = first;
  add_segment(p, plate, a, b, -1, 2, first, row);
  add_segment(p, plate, b, c, 2, -1, first, row);
  for (int q = 0; q < p->width; q++) row[q] /= p->wc[i];
}

void arc_contact_problem_compute_down(contact_problem *p, const arc_shape *shape) {
  const shape_side *cylinder = &shape->side[ARC_CYLINDER];
  const chart *c = &cylinder->body->chart;
  const double under = c->radius * p->angle;
  for (int k = 0; k < p->count; k++) {
    double along[2], across[2];
    arc_chart_axes(c, cylinder->settled[2 * (p->lo + k)] - under, along, across);
    p->down[k] = c->polar ? across[1] : 1;
  }
  p->aimed = 1;
}

arc_status arc_contact_problem_couple(contact_problem *p, const arc_shape *shape, double x,
                                      arc_error *error) {
  const double *cyl = shape->side[ARC_CYLINDER].settled, *plate = shape->side[ARC_PLATE].settled;
  p->x = x;
  p->revolved = &shape->side[ARC_CYLINDER].body->chart.revolved;
  const int lo = p->lo, count = p->count;
  find_candidates(p, cyl, plate[0] + x, plate[2 * p->np - 2] + x);
  if (p->lo != lo || p->count != count) p->active = 0;
  if (p->count < 3)
    return arc_fail(
        error, ARC_ZONE,
        "plate position x = %g mm: the candidate zones of cylinder (%g mm) and plate (%g mm) do "
        "not overlap there; mesh.zone.plate must be wider",
        x, cyl[2 * p->nc - 2] - cyl[0], plate[2 * p->np - 2] - plate[0]);
  if (reserve_rows(p, row_width(p, cyl, plate)) != ARC_OK)
    return arc_fail(error, ARC_MEMORY, "out of memory for the contact");
  for (int i = 0; i < p->nc; i++) p->wc[i] = arc_shape_width(&shape->side[ARC_CYLINDER], i);
  for (int l = 0; l < p->np; l++) p->wp[l] = arc_shape_width(&shape->side[ARC_PLATE], l);
  for (int k = 0; k < p->count; k++) fill_row(p, k, cyl, plate);
  arc_contact_problem_to_cylinder(p, shape_compliance(&shape->side[ARC_PLATE])->slope, p->slope);
  p->aimed = 0;
  return ARC_OK;
}

void arc_contact_problem_to_cylinder(const contact_problem *p, const double *v, double *result) {
  memset(result, 0, (size_t)p->nc * sizeof *result);
  for (int k = 0; k < p->count; k++) {
    const double *row = &p->b[k * p->width], *from = &v[p->first[k]];
    double sum = 0;
    for (int q = 0; q < p->width; q++) sum += row[q] * from[q];
    result[p->lo + k] = sum;
  }
}

void arc_contact_problem_to_plate(const contact_problem *p, const double *v, double *result) {
  memset(result, 0, (size_t)p->np * sizeof *result);
  for (int k = 0; k < p->count; k++) {
    const double *row = &p->b[k * p->width], at = v[p->lo + k];
    if (at == 0) continue;
    double *to = &result[p->first[k]];
    for (int q = 0; q < p->width; q++) to[q] += row[q] * at;
  }
}

/* Computes to[r] for r >= k, the displacement of candidate r of the cylinder along its normal under
 * a unit force along the normal at candidate k. */
static inline void cylinder_responses(const contact_problem *p, const compliance *c, int k,
                                      double *to) {
  const size_t at = dense_at(p->lo, p->lo + k, c->n);
  const double *yy = &c->yy[at], *xy = &c->xy[at], *yx = &c->yx[at], *xx = &c->xx[at];
  const double *m = &p->slope[p->lo], mk = m[k];
#pragma omp simd
  for (int r = k; r < p->count; r++) to[r] = yy[r] - m[r] * xy[r] - mk * yx[r] + m[r] * mk * xx[r];
}

/* Computes column = F_p b_k, where b_k is row k of B. Rows before the first non-zero entry of b_k
 * are omitted, as later columns do not use them. */
static inline void plate_responses(const contact_problem *p, const double *fp, int k,
                                   double *column) {
  const int low = p->first[k];
  for (int l = low; l < p->np; l++) column[l] = 0;
  for (int q = 0; q < p->width && low + q < p->np; q++) {
    const double weight = p->b[k * p->width + q];
    const double *from = &fp[dense_at(0, low + q, p->np)];
    if (weight == 0) continue;
#pragma omp simd
    for (int l = low; l < p->np; l++) column[l] += weight * from[l];
  }
}

/* Computes column k of A from the diagonal down. */
ARC_WIDE static void stiffen_column(const contact_problem *p, const compliance *c, const double *fp,
                                    int k) {
  double *column = p->column, *a = &p->a[dense_at(0, k, p->count)];
  plate_responses(p, fp, k, column);
  cylinder_responses(p, c, k, a);
  for (int r = k; r < p->count; r++) {
    const double *row = &p->b[r * p->width], *from = &column[p->first[r]];
    double sum = a[r];
    for (int q = 0; q < p->width; q++) sum += row[q] * from[q];
    a[r] = sum;
  }
}

/* Copies the lower triangle of a [n x n] to the upper one, tile by tile. */
static void mirror(int n, double *a) {
  enum { tile = 16 };
  for (int left = 0; left < n; left += tile)
    for (int top = left; top < n; top += tile)
      for (int k = left; k < left + tile && k < n; k++)
        for (int r = top > k ? top : k; r < top + tile && r < n; r++)
          a[dense_at(k, r, n)] = a[dense_at(r, k, n)];
}

/* Computes A = F_c + B F_p B' along normals. The lower triangle is computed and then mirrored, so
 * that A is exactly symmetric. */
void arc_contact_problem_assemble(contact_problem *p, const arc_shape *shape) {
  const compliance *c = shape_compliance(&shape->side[ARC_CYLINDER]);
  const double *fp = shape_compliance(&shape->side[ARC_PLATE])->along;
  for (int k = 0; k < p->count; k++) stiffen_column(p, c, fp, k);
  mirror(p->count, p->a);
  p->factored = 0;
}

/* Converts gaps of a pin that touches the hole at the arc length s = 0 to gaps of a pin that has
 * rotated about its centre and touches the hole in the direction of the load. */
static void rest(contact_problem *p, const arc_shape *shape) {
  const shape_side *cylinder = &shape->side[ARC_CYLINDER];
  const chart *c = &cylinder->body->chart;
  const double moved = c->side < 0 ? p->x : 0;
  if (!c->polar || (p->angle == 0 && moved == 0)) return;
  for (int k = 0; k < p->count; k++) {
    const double s = cylinder->settled[2 * (p->lo + k)];
    p->gap[k] += arc_chart_rest(c, s - moved, 0) - arc_chart_rest(c, s, p->angle);
  }
}

void arc_contact_problem_update_gaps(contact_problem *p, const arc_shape *shape) {
  const double *cyl = shape->side[ARC_CYLINDER].level, *plate = shape->side[ARC_PLATE].level;
  for (int k = 0; k < p->count; k++) {
    const double *row = &p->b[k * p->width], *at = &plate[p->first[k]];
    const int width = p->np - p->first[k] < p->width ? p->np - p->first[k] : p->width;
    double below = 0;
    for (int q = 0; q < width; q++) below += row[q] * at[q];
    p->gap[k] = cyl[p->lo + k] - below;
  }
  rest(p, shape);
}

/* Measured topographies: surfaces through points over x and z, for half-spaces in 3-D models. */
#include "core/mesh/body_shape.h"

#include <math.h>

static const char *const fields[] = {"radius", "radius_z", "y", "x", "z", NULL};

enum { LEAST = 4 /* smallest number of points along an axis */ };

static arc_status check_axis(const char *path, const char *name, const arc_series *s,
                             arc_error *error) {
  static const double uneven = 1e-4; /* tolerance of each spacing, relative to the mean spacing */
  const double *v = s->value;
  if (s->count < LEAST)
    return arc_fail(error, ARC_ARGUMENT, "field '%s%s': expected at least %d points, got %d", path,
                    name, LEAST, s->count);
  const double step = (v[s->count - 1] - v[0]) / (s->count - 1);
  for (int i = 0; i < s->count; i++)
    if (!(step > 0) || !(fabs(v[i] - (v[0] + i * step)) <= uneven * step))
      return arc_fail(error, ARC_ARGUMENT,
                      "field '%s%s': expected increasing, evenly spaced points, got %g mm at point "
                      "%d of %d from %g to %g mm",
                      path, name, v[i], i + 1, s->count, v[0], v[s->count - 1]);
  return ARC_OK;
}

static arc_status check(const arc_body_def *b, const char *path, arc_error *error) {
  arc_status status = check_axis(path, "x", &b->x_series, error);
  if (status == ARC_OK) status = check_axis(path, "z", &b->z_series, error);
  if (status != ARC_OK) return status;
  const arc_series *y = &b->y_series;
  if ((double)b->x_series.count * b->z_series.count != y->count)
    return arc_fail(error, ARC_ARGUMENT,
                    "field '%sy': expected %d x %d heights, z varying fastest, got %d", path,
                    b->x_series.count, b->z_series.count, y->count);
  for (int i = 0; i < y->count; i++)
    if (!isfinite(y->value[i]))
      return arc_fail(error, ARC_ARGUMENT, "field '%sy': expected finite numbers, got %g", path,
                      y->value[i]);
  return ARC_OK;
}

static void resolve(arc_body_def *b, double radius) {
  (void)radius;
  if (b->radius_z == 0) b->radius_z = b->radius;
}

static double radius(const arc_body_def *b) {
  return b->radius > 0 ? b->radius : INFINITY;
}

/* Returns infinite limits, because bodies of 3-D models have no mesh. */
static body_limits limits(const arc_body_def *b) {
  (void)b;
  return (body_limits){.zone = INFINITY, .zone_text = "any", .outer = INFINITY, .reach = INFINITY};
}

const body_shape arc_body_shape_map = {fields, FORM_MAP, 0,    resolve, radius, arc_body_height,
                                       limits, NULL,     NULL, check,   NULL};

/* --- heights ---------------------------------------------------------------------------------- */

/* Computes the weights of four neighbouring points for a position between the second and the
 * third point. The interpolation is a cubic convolution, which is exact for parabolas. Returns
 * the index of the first point. */
static int weigh(const arc_series *axis, double at, double weight[4]) {
  const double first = axis->value[0], last = axis->value[axis->count - 1];
  const double u = (fmin(fmax(at, first), last) - first) / (last - first) * (axis->count - 1);
  const int i = (int)fmin(fmax(floor(u), 1), axis->count - 3);
  const double t = u - i;
  weight[0] = t * (-1 + t * (2 - t)) / 2;
  weight[1] = 1 + t * t * (3 * t - 5) / 2;
  weight[2] = t * (1 + t * (4 - 3 * t)) / 2;
  weight[3] = t * t * (t - 1) / 2;
  if (t >= 0 && t <= 1) return i - 1;
  /* In the first and the last interval, the interpolation is the parabola through the three
   * points at that end. s is the position relative to the middle point of these three. */
  const int k = t < 0 ? 0 : 1;
  const double s = t - k;
  weight[0] = weight[1] = weight[2] = weight[3] = 0;
  weight[k] = s * (s - 1) / 2;
  weight[k + 1] = 1 - s * s;
  weight[k + 2] = s * (s + 1) / 2;
  return i - 1;
}

double arc_body_map_height(const arc_body_def *b, double x, double z) {
  double wx[4], wz[4], sum = 0;
  const int i = weigh(&b->x_series, x, wx), j = weigh(&b->z_series, z, wz);
  const double *y = b->y_series.value;
  for (int k = 0; k < 4; k++)
    for (int l = 0; l < 4; l++)
      if (wx[k] != 0 && wz[l] != 0) sum += wx[k] * wz[l] * y[(i + k) * b->z_series.count + j + l];
  return sum;
}

void arc_body_map_extent(const arc_body_def *b, double *half_x, double *half_z, double *step) {
  const arc_series *x = &b->x_series, *z = &b->z_series;
  *half_x = fmin(-x->value[0], x->value[x->count - 1]);
  *half_z = fmin(-z->value[0], z->value[z->count - 1]);
  *step = fmax(x->value[1] - x->value[0], z->value[1] - z->value[0]);
}

/* Returns the curvature [1/mm] of a parabola that is fitted to the heights along one axis by
 * least squares. It is positive for a convex surface. On a regular grid the squares of x and z,
 * minus their means, are orthogonal. */
static double curvature(const arc_body_def *b, int along_z) {
  const arc_series *axis = along_z ? &b->z_series : &b->x_series;
  const int nz = b->z_series.count, n = axis->count;
  const double middle = (axis->value[0] + axis->value[n - 1]) / 2;
  double mean = 0, above = 0, below = 0;
  for (int i = 0; i < n; i++) mean += pow(axis->value[i] - middle, 2) / n;
  for (int k = 0; k < b->y_series.count; k++) {
    const double square = pow(axis->value[along_z ? k % nz : k / nz] - middle, 2) - mean;
    above += square * b->y_series.value[k];
    below += square * square;
  }
  return -2 * above / below;
}

void arc_body_map_curvature(const arc_body_def *b, double *along_x, double *along_z) {
  *along_x = curvature(b, 0);
  *along_z = curvature(b, 1);
}

/* Computes the extents of contacts and wear scars, interpolated between cells. */
#include "core/space/halfspace.h"

#include <math.h>
#include <stdlib.h>

/* Values of the cells. The position between two cells where the value equals `level` is found by
 * linear interpolation of value^power. */
typedef struct field {
  const double *value;
  int rows, columns, power;
  double level;
} field;

static double at(const field *f, int i, int j) {
  if (i < 0 || j < 0 || i >= f->rows || j >= f->columns) return 0;
  const double v = f->value[(size_t)i * (size_t)f->columns + (size_t)j];
  return f->power == 2 ? v * v : v;
}

/* Returns the largest value in row i (along = 0) or in column i (along = 1). */
static double largest_of(const field *f, int along, int i) {
  double most = 0;
  for (int j = 0, n = along ? f->rows : f->columns; j < n; j++)
    most = fmax(most, along ? at(f, j, i) : at(f, i, j));
  return most;
}

/* Returns the position, in rows or columns, at which the largest value of a row or column falls
 * below the level. The position is interpolated if the next row or column has values above 0.
 * Otherwise it is extrapolated with the slope inside. */
static double edge(const field *f, int along, int from, int step) {
  const double inside = largest_of(f, along, from), before = largest_of(f, along, from - step),
               outside = largest_of(f, along, from + step);
  if (outside > 0) return from + step * (inside - f->level) / (inside - outside);
  const double slope = before - inside;
  return from + step * (slope > 0 ? fmin((inside - f->level) / slope, 1) : 0.5);
}

static void find_extent(const field *f, int along, double size, double *half, double *center) {
  const int n = along ? f->columns : f->rows;
  int low = n, high = -1;
  for (int i = 0; i < n; i++)
    if (largest_of(f, along, i) > f->level) {
      if (low == n) low = i;
      high = i;
    }
  *half = *center = 0;
  if (high < 0) return;
  const double from = edge(f, along, low, -1), to = edge(f, along, high, 1);
  *half = (to - from) / 2 * size;
  *center = ((from + to) / 2 - (n - 1) / 2.0) * size;
}

/* Returns the value at the middle of the field, averaged over the middle cells. */
static double middle(const field *f) {
  const int i = (f->rows - 1) / 2, j = (f->columns - 1) / 2, k = f->rows / 2, l = f->columns / 2;
  const double *v = f->value;
  const int n = f->columns;
  return (v[i * n + j] + v[k * n + j] + v[i * n + l] + v[k * n + l]) / 4;
}

/* Computes extent, area and values of a field. size_x is the cell size along the motion [mm]. */
static arc_halfspace_extent extent_of(const arc_halfspace_def *d, const field *f, double size_x) {
  arc_halfspace_extent e = {0};
  int inside = 0;
  for (int i = 0; i < f->rows; i++)
    for (int j = 0; j < f->columns; j++) {
      e.largest = fmax(e.largest, f->value[(size_t)i * (size_t)f->columns + (size_t)j]);
      inside += at(f, i, j) > f->level;
    }
  e.area = inside * size_x * d->size_z;
  e.center = middle(f);
  find_extent(f, d->turned, d->turned ? d->size_z : size_x, &e.half_width, &e.center_x);
  find_extent(f, !d->turned, d->turned ? size_x : d->size_z, &e.half_width_z, &e.center_z);
  return e;
}

arc_halfspace_extent arc_halfspace_contact_extent(const arc_halfspace *h, const double *pressure) {
  const arc_halfspace_def *d = &h->def;
  const field f = {.value = pressure, .rows = d->nx, .columns = d->nz, .power = 2};
  return extent_of(d, &f, d->size_x);
}

arc_halfspace_extent arc_halfspace_scar(const arc_halfspace *h, arc_body body, const double *depth,
                                        double share) {
  const arc_halfspace_def *d = &h->def;
  const int rows = body == ARC_UPPER ? d->nx : h->rows;
  field f = {.value = depth, .rows = rows, .columns = d->nz, .power = 1};
  for (int k = 0; k < rows * d->nz; k++) f.level = fmax(f.level, share * depth[k]);
  return extent_of(d, &f, arc_halfspace_site_area(h, body) / d->size_z);
}

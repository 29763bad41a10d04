/* Compliance on a window of the lattice. It is a convolution over longitude, and for each wave
 * number a dense matrix over latitude. The part proportional to 1/chord (chord: the distance of two
 * points) is integrated over near cells. The smooth remainder is interpolated from a table over the
 * angle between two points. */
#include "core/sphere/sphere.h"

#include "core/base/dense.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Largest degree of the sums, number of table entries per cell, and largest distance in cells at
 * which the part 1/chord is integrated. */
enum { degrees = 3000, fine = 8, near = 8 };

static const double pi = 3.14159265358979323846;

/* Computes the table of the remainder: the sum over the degrees l of (2l+1)/(4 pi) weight_l (C_l -
 * A/(l+1/2)) P_l, with the compliance C_l and the Legendre polynomial P_l. A is the limit of (l +
 * 1/2) C_l, and weight_l is the mean of P_l over a cap with the area of a cell. */
double *arc_sphere_remainder(const arc_joint_def *def, int rows, int *numeric) {
  const double d = pi / rows, c = 1 - d * d / (2 * pi), A = arc_sphere_limit(def, rows);
  const int entries = fine * rows + 4;
  double *table = calloc((size_t)entries, sizeof *table);
  double *share = malloc((degrees + 1) * sizeof *share);
  *numeric = 0;
  double before = 1, now = c; /* P_{l-1}, P_l at the edge of the cap */
  for (int l = 0; l <= degrees && table && share; l++) {
    const double C =
        arc_joint_compliance(def, ARC_UPPER, l) + arc_joint_compliance(def, ARC_LOWER, l);
    const double after = l == 0 ? c : ((2 * l + 1) * c * now - l * before) / (l + 1);
    const double weight = l == 0 ? 1 : (before - after) / ((2 * l + 1) * (1 - c));
    share[l] = (2 * l + 1) / (4 * pi) * weight * (C - A / (l + 0.5));
    if (!isfinite(share[l])) *numeric = 1;
    if (l > 0) before = now, now = after;
  }
  for (int i = 0; i < entries && table && share; i++) {
    const double x = cos(i * d / fine);
    double low = 1, high = x, sum = share[0];
    for (int l = 1; l <= degrees; l++) {
      sum += share[l] * high;
      const double next = ((2 * l + 1) * x * high - l * low) / (l + 1);
      low = high;
      high = next;
    }
    table[i] = sum;
  }
  free(share);
  if (share && !*numeric) return table;
  free(table);
  return NULL;
}

/* Interpolates the table at an angle [rad] by a cubic polynomial. The table is an even function of
 * the angle. */
static double read_table(const arc_joint *j, double angle) {
  const double at = angle / j->d * fine;
  const int i = (int)at;
  const double t = at - i, *y = j->remainder + i, first = i > 0 ? y[-1] : y[1];
  return y[0] + t / 2 *
                    (y[1] - first +
                     t * (2 * first - 5 * y[0] + 4 * y[1] - y[2] +
                          t * (3 * (y[0] - y[1]) + y[2] - first)));
}

/* Returns the integral of 1/r over the rectangle [0, x] x [0, y], with the distance r from the
 * origin. The integral is odd in x and y. */
static double corner(double x, double y) {
  return x * asinh(y / fabs(x)) + y * asinh(x / fabs(y));
}

/* Returns the mean of 1/r over a rectangle a x b centred at (x, y). */
static double mean_inverse(double x, double y, double a, double b) {
  const double l = x - a / 2, r = x + a / 2, d = y - b / 2, u = y + b / 2;
  return (corner(r, u) - corner(l, u) - corner(r, d) + corner(l, d)) / (a * b);
}

/* Returns the displacement at a cell of `row` under unit pressure on a source cell, divided by
 * the source's solid angle. `lag` is the distance of the cells in columns. */
static double influence(const arc_joint *j, int row, int source, int lag) {
  const double d = j->d, here = (row + 0.5) * d, there = (source + 0.5) * d;
  const double s = sqrt(sin(here) * sin(there));
  const double x = 2 * sin((here - there) / 2), y = 2 * s * sin(lag * d / 2);
  const double chord = sqrt(x * x + y * y);
  const int is_near = abs(row - source) <= near && lag <= near;
  const double inverse = is_near ? mean_inverse(x, y, d, s * d) : 1 / chord;
  return j->limit / (2 * pi) * inverse + read_table(j, 2 * asin(fmin(1, chord / 2)));
}

static void fill(const arc_joint *j, sphere_kernel *k) {
  const int first = j->rows / 2 - k->size / 2;
  double *values = k->product; /* workspace: `product` has more than size * box values */
  for (int row = 0; row < k->size; row++) {
    memset(values, 0, (size_t)k->size * (size_t)k->box * sizeof *values);
    for (int source = 0; source < k->size; source++)
      for (int lag = 0; lag < k->size; lag++) {
        double *to = values + (size_t)source * (size_t)k->box;
        to[lag] = influence(j, first + row, first + source, lag);
        if (lag > 0) to[k->box - lag] = to[lag];
      }
    arc_rows_forward(k->rows, values, k->spectrum);
    for (int source = 0; source < k->size; source++) {
      const double angle = (first + source) * j->d;
      const double solid = (cos(angle) - cos(angle + j->d)) * j->d / k->box;
      for (int w = 0; w < k->waves; w++)
        k->symbol[((size_t)w * (size_t)k->size + (size_t)source) * (size_t)k->size + (size_t)row] =
            solid * k->spectrum[2 * ((size_t)source * (size_t)k->waves + (size_t)w)];
    }
  }
}

void arc_sphere_kernel_free(sphere_kernel **kernel) {
  sphere_kernel *k = *kernel;
  *kernel = NULL;
  if (!k) return;
  arc_rows_destroy(&k->rows);
  free(k->symbol);
  free(k->spectrum);
  free(k->product);
  free(k);
}

sphere_kernel *arc_sphere_kernel(const arc_joint *j, int size) {
  sphere_kernel *k = calloc(1, sizeof *k);
  if (!k) return NULL;
  k->size = size;
  k->box = arc_transform_length(2 * size);
  k->waves = k->box / 2 + 1;
  const size_t n = (size_t)size, pairs = n * (size_t)k->waves;
  k->rows = arc_rows_create(size, k->box);
  k->symbol = malloc(n * pairs * sizeof *k->symbol);
  k->spectrum = malloc(4 * pairs * sizeof *k->spectrum);
  k->product = malloc(4 * pairs * sizeof *k->product);
  if (!k->rows || !k->symbol || !k->spectrum || !k->product)
    arc_sphere_kernel_free(&k);
  else
    fill(j, k);
  return k;
}

void arc_sphere_kernel_apply(sphere_kernel *k, const double *p, double *u) {
  const size_t n = (size_t)k->size, waves = (size_t)k->waves, box = (size_t)k->box;
  double *values = k->product, *turned = k->spectrum + 2 * n * waves;
  memset(values, 0, n * box * sizeof *values);
  for (size_t i = 0; i < n; i++) memcpy(values + i * box, p + i * n, n * sizeof *p);
  arc_rows_forward(k->rows, values, k->spectrum);
  for (size_t w = 0; w < waves; w++)
    for (size_t i = 0; i < n; i++) {
      turned[2 * w * n + i] = k->spectrum[2 * (i * waves + w)];
      turned[(2 * w + 1) * n + i] = k->spectrum[2 * (i * waves + w) + 1];
    }
  for (size_t w = 0; w < waves; w++)
    arc_dense_multiply(k->size, 2, k->size, 1, k->symbol + w * n * n, k->size, turned + 2 * w * n,
                       k->size, 0, k->product + 2 * w * n, k->size);
  for (size_t w = 0; w < waves; w++)
    for (size_t i = 0; i < n; i++) {
      k->spectrum[2 * (i * waves + w)] = k->product[2 * w * n + i];
      k->spectrum[2 * (i * waves + w) + 1] = k->product[(2 * w + 1) * n + i];
    }
  arc_rows_back(k->rows, k->spectrum, k->product);
  for (size_t i = 0; i < n; i++) memcpy(u + i * n, k->product + i * box, n * sizeof *u);
}

/* Implements loops over cell values, compiled for processors with wide vector registers. */
#include "core/numeric/cells.h"

#include "core/base/wide.h"

#include <math.h>

enum { lanes = 8 };

static double total(const double *s) {
  return ((s[0] + s[1]) + (s[2] + s[3])) + ((s[4] + s[5]) + (s[6] + s[7]));
}

ARC_WIDE static double add_up(int n, const double *a) {
  double s[lanes] = {0};
  int k = 0;
  for (; k + lanes <= n; k += lanes)
#pragma omp simd
    for (int l = 0; l < lanes; l++) s[l] += a[k + l];
  for (; k < n; k++) s[0] += a[k];
  return total(s);
}

ARC_WIDE static double dot3(int n, const double *a, const double *b, const double *c) {
  double s[lanes] = {0};
  int k = 0;
  for (; k + lanes <= n; k += lanes)
#pragma omp simd
    for (int l = 0; l < lanes; l++) s[l] += a[k + l] * b[k + l] * c[k + l];
  for (; k < n; k++) s[0] += a[k] * b[k] * c[k];
  return total(s);
}

ARC_WIDE static double dot4(int n, const double *a, const double *b, const double *c,
                            const double *d) {
  double s[lanes] = {0};
  int k = 0;
  for (; k + lanes <= n; k += lanes)
#pragma omp simd
    for (int l = 0; l < lanes; l++) s[l] += a[k + l] * b[k + l] * (c[k + l] * d[k + l]);
  for (; k < n; k++) s[0] += a[k] * b[k] * (c[k] * d[k]);
  return total(s);
}

ARC_WIDE static void add(int n, double factor, const double *x, double *y) {
#pragma omp simd
  for (int k = 0; k < n; k++) y[k] += factor * x[k];
}

ARC_WIDE static void turn(int n, double factor, const double *z, double *d) {
#pragma omp simd
  for (int k = 0; k < n; k++) d[k] = factor * d[k] - z[k];
}

ARC_WIDE static double add_gap(int n, const double *gap, double *g) {
  double most[lanes] = {0};
  int k = 0;
  for (; k + lanes <= n; k += lanes)
#pragma omp simd
    for (int l = 0; l < lanes; l++) {
      const double size = fabs(g[k + l]);
      most[l] = size > most[l] ? size : most[l];
      g[k + l] += gap[k + l];
    }
  for (; k < n; k++) {
    most[0] = fmax(most[0], fabs(g[k]));
    g[k] += gap[k];
  }
  for (int l = 1; l < lanes; l++) most[0] = fmax(most[0], most[l]);
  return most[0];
}

ARC_WIDE static double residual(int n, const double *area, const double *g, double level,
                                double *r) {
  double s[lanes] = {0};
  int k = 0;
  for (; k + lanes <= n; k += lanes)
#pragma omp simd
    for (int l = 0; l < lanes; l++) {
      const double v = area[k + l] > 0 ? g[k + l] - level : 0;
      r[k + l] = v;
      s[l] += area[k + l] * v * v;
    }
  for (; k < n; k++) {
    r[k] = area[k] > 0 ? g[k] - level : 0;
    s[0] += area[k] * r[k] * r[k];
  }
  return total(s);
}

/* Functions for other files. These files cannot directly call a function that is compiled for
 * several processors. */
double arc_cells_sum(int n, const double *a) {
  return add_up(n, a);
}

double arc_cells_dot3(int n, const double *a, const double *b, const double *c) {
  return dot3(n, a, b, c);
}

double arc_cells_dot4(int n, const double *a, const double *b, const double *c, const double *d) {
  return dot4(n, a, b, c, d);
}

void arc_cells_add(int n, double factor, const double *x, double *y) {
  add(n, factor, x, y);
}

void arc_cells_turn(int n, double factor, const double *z, double *d) {
  turn(n, factor, z, d);
}

double arc_cells_add_gap(int n, const double *gap, double *g) {
  return add_gap(n, gap, g);
}

double arc_cells_residual(int n, const double *area, const double *g, double level, double *r) {
  return residual(n, area, g, level, r);
}

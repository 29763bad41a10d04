/* Computes an initial guess of the pressures under a load. */
#include "core/space/halfspace.h"

#include <math.h>

static double least_of(int n, const double *gap) {
  double least = INFINITY;
  for (int k = 0; k < n; k++) least = fmin(least, gap[k]);
  return least;
}

/* Returns the estimated load for an approach: the load of a Hertz contact whose area is the area in
 * which gaps are smaller than half the approach. */
static double load_at(const arc_halfspace *h, const double *gap, double least, double approach) {
  const arc_halfspace_def *d = &h->def;
  int inside = 0;
  for (int k = 0; k < h->cells; k++) inside += gap[k] - least < approach / 2;
  return 4 / (3 * sqrt(acos(-1)) * arc_space_surface_compliance(d)) *
         sqrt(inside * d->size_x * d->size_z) * approach;
}

static double approach_of(const arc_halfspace *h, const double *gap, double least, double load) {
  double low = 0, high = 1e-9;
  while (load_at(h, gap, least, high) < load) high *= 2;
  for (int k = 0; k < 50; k++) {
    const double middle = (low + high) / 2;
    if (load_at(h, gap, least, middle) < load)
      low = middle;
    else
      high = middle;
  }
  return high;
}

/* The approach ends at the gap of the last cell that enters. Such a cell, whose pressure would be
 * the square root of a rounding error, has none. */
void arc_space_guess(const arc_halfspace *h, const double *gap, double load, double *pressure) {
  static const double entered = 1e-6;
  const double least = least_of(h->cells, gap);
  const double half = h->def.periodic ? INFINITY : approach_of(h, gap, least, load) / 2;
  double sum = 0;
  for (int k = 0; k < h->cells; k++) {
    const double inside = half - (gap[k] - least);
    pressure[k] = h->def.periodic ? 1 : inside > entered * half ? sqrt(inside) : 0;
    sum += pressure[k];
  }
  const double scale = load / (sum * h->def.size_x * h->def.size_z);
  for (int k = 0; k < h->cells; k++) pressure[k] *= scale;
}

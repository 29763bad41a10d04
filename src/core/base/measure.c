/* Computes measures of worn profiles from plain arrays. */
#include "archard/measure.h"

#include <math.h>

double arc_measure_interpolate(const double *x, const double *y, size_t n, double at,
                               double outside) {
  if (n == 0 || at < x[0] || at > x[n - 1]) return outside;
  size_t low = 0, high = n - 1;
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    if (x[middle] <= at)
      low = middle;
    else
      high = middle;
  }
  if (x[high] <= at) return y[high];
  return y[low] + (y[high] - y[low]) * (at - x[low]) / (x[high] - x[low]);
}

double arc_measure_sawtooth(const double *x, const double *y, size_t n, double from, double to) {
  double sum = 0;
  int count = 0;
  for (size_t i = 2; i + 2 < n; i++) {
    if (x[i] < from || x[i] > to) continue;
    const double saw = (y[i - 2] - 4 * y[i - 1] + 6 * y[i] - 4 * y[i + 1] + y[i + 2]) / 16;
    sum += saw * saw;
    count++;
  }
  return count > 0 ? sqrt(sum / count) : 0;
}

double arc_depth_partition(double cylinder, double plate) {
  return cylinder + plate > 0 ? cylinder / (cylinder + plate) : (double)NAN;
}

static double depth_at(arc_depths profile, double x) {
  return arc_measure_interpolate(profile.x, profile.h, profile.count, x, 0);
}

void arc_measure_combined(arc_depths cylinder, arc_depths plate, double *sum) {
  for (size_t i = 0; i < plate.count; i++) sum[i] = depth_at(cylinder, plate.x[i]) + plate.h[i];
}

size_t arc_measure_local_partition(arc_depths cylinder, arc_depths plate, double *x,
                                   double *share) {
  size_t worn = 0;
  for (size_t i = 0; i < plate.count; i++) {
    const double own = depth_at(cylinder, plate.x[i]), sum = own + plate.h[i];
    if (sum <= 0) continue;
    x[worn] = plate.x[i];
    share[worn++] = own / sum;
  }
  return worn;
}

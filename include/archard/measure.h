/* archard/measure.h - measures of worn profiles, computed from arrays. The functions cannot fail
 * and allocate no memory. */
#ifndef ARCHARD_MEASURE_H
#define ARCHARD_MEASURE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Returns the value at x = `at` of the polyline through `n` points (x, y) with increasing x, or
 * `outside` beyond its ends. */
double arc_measure_interpolate(const double *x, const double *y, size_t n, double at,
                               double outside);

/* Returns the amplitude of the sawtooth (oscillation from point to point) in `n` values y, in
 * their unit. It is the root mean square of the fourth differences of y divided by 16, over the
 * points with from <= x <= to; 0 if there are none. For a pure sawtooth of amplitude 1 it is 1. */
double arc_measure_sawtooth(const double *x, const double *y, size_t n, double from, double to);

/* Returns the depth partition factor alpha-tilde (Eq. 29 of the reference paper) [-]: the
 * cylinder's share of the sum of both depths. Returns NaN if neither body is worn. */
double arc_depth_partition(double cylinder, double plate);

/* A measured or simulated depth profile. The caller owns the arrays. */
typedef struct arc_depths {
  size_t count;
  const double *x; /* [count] positions [mm], increasing */
  const double *h; /* [count] depths [mm] */
} arc_depths;

/* Computes the sum of the depths of both bodies (Eq. 31 of the reference paper) at the points of
 * the plate, with the plate at x = 0. The result `sum` [mm] has plate.count values. Beyond its
 * last points the cylinder is unworn. */
void arc_measure_combined(arc_depths cylinder, arc_depths plate, double *sum);

/* Computes the cylinder's share of the sum of both depths (Eq. 30 of the reference paper) at those
 * points of the plate where the sum is > 0. Writes their positions to `x` and the shares to
 * `share`, both of size plate.count. Returns the number of points. */
size_t arc_measure_local_partition(arc_depths cylinder, arc_depths plate, double *x, double *share);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

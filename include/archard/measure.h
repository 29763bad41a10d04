/* archard/measure.h - measures of profiles and depths, computed from arrays of runs or files. The
 * functions neither fail nor allocate. */
#ifndef ARCHARD_MEASURE_H
#define ARCHARD_MEASURE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Returns the value at x = `at` of the polyline through (x, y) [n] with increasing x, or `outside`
 * beyond its ends. */
double arc_measure_interpolate(const double *x, const double *y, size_t n, double at,
                               double outside);

/* Returns the sawtooth part of y [n] in the units of y: root mean square of the fourth differences
 * divided by 16, at the points with from <= x <= to. A pure sawtooth of amplitude 1 gives 1.
 * Returns 0 if there are no such points. */
double arc_measure_sawtooth(const double *x, const double *y, size_t n, double from, double to);

/* Returns the wear depth partition factor alpha-tilde (Eq. 29) [-], the cylinder's share of the sum
 * of both depths. Returns NaN if neither body is worn. */
double arc_depth_partition(double cylinder, double plate);

/* A measured or simulated depth profile. The caller owns the arrays. */
typedef struct arc_depths {
  size_t count;
  const double *x; /* [count] positions [mm], increasing */
  const double *h; /* [count] depths [mm] */
} arc_depths;

/* Writes the sum of both depths (Eq. 31) at the points of the plate, with the plate at x = 0, to
 * sum [plate.count] [mm]. Beyond its points the cylinder counts as unworn. */
void arc_measure_combined(arc_depths cylinder, arc_depths plate, double *sum);

/* Writes the cylinder's share of the sum of both depths (Eq. 30) at the worn points of the plate to
 * x and share [plate.count]. Returns the number of these points. */
size_t arc_measure_local_partition(arc_depths cylinder, arc_depths plate, double *x, double *share);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

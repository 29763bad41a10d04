/* archard/measure.h - measures of profiles and depths, for arrays of runs or files. The functions
 * do not fail or allocate. */
#ifndef ARCHARD_MEASURE_H
#define ARCHARD_MEASURE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* Value at `at` of the broken line through (x, y) [n], x increasing; `outside` beyond its ends. */
double arc_measure_interpolate(const double *x, const double *y, size_t n, double at,
                               double outside);

/* Sawtooth part of y [n]: fourth differences over 16 (a pure sawtooth of amplitude 1 gives 1), root
 * mean square over the points with from <= x <= to, in the units of y; 0 without points. */
double arc_measure_sawtooth(const double *x, const double *y, size_t n, double from, double to);

/* Wear depth partition factor alpha-tilde (Eq. 29) [-], the cylinder's share of both depths; NaN
 * before any wear. */
double arc_depth_partition(double cylinder, double plate);

/* A measured or simulated depth profile, borrowed. */
typedef struct arc_depths {
  size_t count;
  const double *x; /* [count] [mm], increasing */
  const double *h; /* [count] [mm] */
} arc_depths;

/* Writes the sum of both depths (Eq. 31) at the points of the plate, with the plate at x = 0, to
 * sum [plate.count] [mm]; the cylinder is unworn beyond its points. */
void arc_measure_combined(arc_depths cylinder, arc_depths plate, double *sum);

/* Writes the cylinder's share of that sum (Eq. 30) at the worn points of the plate to x and share
 * [plate.count]. Returns their number. */
size_t arc_measure_local_partition(arc_depths cylinder, arc_depths plate, double *x, double *share);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

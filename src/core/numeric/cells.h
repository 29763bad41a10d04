/* Declares loops over the values of n cells. Each sum is computed from eight partial sums, so that
 * the result does not depend on the width of the processor's vector registers. */
#ifndef NUMERIC_CELLS_H
#define NUMERIC_CELLS_H

/* arc_cells_sum returns the sum of a over n cells, arc_cells_dot3 the sum of a b c, and
 * arc_cells_dot4 the sum of a b c d. */
double arc_cells_sum(int n, const double *a);
double arc_cells_dot3(int n, const double *a, const double *b, const double *c);
double arc_cells_dot4(int n, const double *a, const double *b, const double *c, const double *d);
/* Computes y = y + factor * x. */
void arc_cells_add(int n, double factor, const double *x, double *y);
/* Computes d = factor * d - z. */
void arc_cells_turn(int n, double factor, const double *z, double *d);
/* Adds `gap` to g. Returns the largest |g| before the addition. */
double arc_cells_add_gap(int n, const double *gap, double *g);
/* Computes the residual r, which is g - level in cells with area > 0 and 0 in other cells. Returns
 * the sum of area r^2. */
double arc_cells_residual(int n, const double *area, const double *g, double level, double *r);

#endif

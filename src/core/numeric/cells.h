/* Loops over cell values. Sums have eight partial sums, for any width of the registers. */
#ifndef NUMERIC_CELLS_H
#define NUMERIC_CELLS_H

/* Return the sums over n cells of a, of a b c, and of a b c d. */
double arc_cells_sum(int n, const double *a);
double arc_cells_dot3(int n, const double *a, const double *b, const double *c);
double arc_cells_dot4(int n, const double *a, const double *b, const double *c, const double *d);
/* y += factor x */
void arc_cells_add(int n, double factor, const double *x, double *y);
/* d := factor d - z */
void arc_cells_turn(int n, double factor, const double *z, double *d);
/* Adds `gap` to g; returns the largest |g| before the addition. */
double arc_cells_add_gap(int n, const double *gap, double *g);
/* r := g - level where area > 0, else 0; returns sum area r^2. */
double arc_cells_residual(int n, const double *area, const double *g, double level, double *r);

#endif

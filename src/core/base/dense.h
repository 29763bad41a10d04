/* Small dense linear algebra, column-major. Only dense.c calls LAPACK and BLAS. */
#ifndef BASE_DENSE_H
#define BASE_DENSE_H

#include <stddef.h>

/* a := L with a = L L', in the lower triangle of a [n x n, leading dimension ld]. Returns 0, or k >
 * 0 if the leading k x k block is not positive definite. */
int arc_dense_cholesky(int n, double *a, int ld);
/* b := (L L')^-1 b, b [n x count, leading dimension ldb]. */
void arc_dense_cholesky_solve(int n, int count, const double *l, int ld, double *b, int ldb);
/* b := L^-1 b (forward half of the solve). */
void arc_dense_forward(int n, int count, const double *l, int ld, double *b, int ldb);

/* The same two operations for a band matrix with `band` sub-diagonals in lower band storage: a[(i -
 * j) + j * (band + 1)]. */
int arc_dense_band_cholesky(int n, int band, double *a);
/* x := A^-1 x for ARC_DENSE_BAND_SIDES right-hand sides, x[i * sides + c], of which only rows *from
 * .. *to - 1 differ from zero. x points to row 0 of an array with `band` additional rows before and
 * after. Sets *from and *to to the rows of the solution above rounding; all other rows are zero. */
enum { ARC_DENSE_BAND_SIDES = 16 };
void arc_dense_band_solve(int n, int band, const double *l, double *x, int *from, int *to);

/* c := beta c + alpha a' b, a [k x m], b [k x n], c [m x n]. */
void arc_dense_multiply_transposed(int m, int n, int k, double alpha, const double *a, int lda,
                                   const double *b, int ldb, double beta, double *c, int ldc);
/* c := beta c + alpha a b, a [m x k], b [k x n], c [m x n]. */
void arc_dense_multiply(int m, int n, int k, double alpha, const double *a, int lda,
                        const double *b, int ldb, double beta, double *c, int ldc);
/* y += a x in rows first .. last - 1. x [n] belongs to the columns at[0] .. at[n - 1], or to the
 * first n if at is NULL. */
void arc_dense_add_columns(int first, int last, int n, const int *at, const double *a, int lda,
                           const double *x, double *y);
/* c := a a', lower triangle; a [n x k], c [n x n]. */
void arc_dense_square(int n, int k, const double *a, int lda, double *c, int ldc);
/* c += a' a, lower triangle; a [k x n], c [n x n]. */
void arc_dense_add_square(int n, int k, const double *a, int lda, double *c, int ldc);
/* A general matrix in two steps. The first replaces a [n x n] by its factors, with pivots [n], and
 * returns 0, or k > 0 if it is singular. The second computes b := a^-1 b, b [n x count], any number
 * of times. */
int arc_dense_factor(int n, double *a, int *pivots);
void arc_dense_factor_solve(int n, int count, const double *a, const int *pivots, double *b);
/* inverse := (L L')^-1, the full matrix; l and inverse [n x n]. */
void arc_dense_cholesky_invert(int n, const double *l, double *inverse);

/* Returns the index of (i, j) in a column-major matrix of leading dimension ld. */
static inline size_t dense_at(int i, int j, int ld) {
  return (size_t)i + (size_t)j * (size_t)ld;
}

#endif

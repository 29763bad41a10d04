/* Declares linear algebra with small dense matrices, stored column by column. Only dense.c calls
 * LAPACK and BLAS. */
#ifndef BASE_DENSE_H
#define BASE_DENSE_H

#include <stddef.h>

/* Computes the Cholesky factor L of the matrix a [n x n, leading dimension ld], a = L L'. L
 * replaces the lower triangle of a. Returns 0, or k > 0 if the leading k x k block is not positive
 * definite. */
int arc_dense_cholesky(int n, double *a, int ld);
/* Replaces b [n x count, leading dimension ldb] by (L L')^-1 b. */
void arc_dense_cholesky_solve(int n, int count, const double *l, int ld, double *b, int ldb);
/* Replaces b [n x count, leading dimension ldb] by L^-1 b (forward substitution only). */
void arc_dense_forward(int n, int count, const double *l, int ld, double *b, int ldb);

/* Replaces a band matrix by its Cholesky factor. The matrix has `band` sub-diagonals in lower band
 * storage: entry (i, j) is a[(i - j) + j * (band + 1)]. Returns 0, or k > 0 as arc_dense_cholesky
 * does. */
int arc_dense_band_cholesky(int n, int band, double *a);
/* Replaces x by A^-1 x for ARC_DENSE_BAND_SIDES right-hand sides, where A is the band matrix with
 * the factor l. Row i of right-hand side c is x[i * ARC_DENSE_BAND_SIDES + c]. On entry, all rows
 * except *from .. *to - 1 must be zero. On return, rows *from .. *to - 1 contain all values of the
 * solution above rounding errors, and all other rows are zero. */
enum { ARC_DENSE_BAND_SIDES = 16 };
void arc_dense_band_solve(int n, int band, const double *l, double *x, int *from, int *to);

/* Replaces c by beta c + alpha a' b, with a [k x m], b [k x n], c [m x n]. */
void arc_dense_multiply_transposed(int m, int n, int k, double alpha, const double *a, int lda,
                                   const double *b, int ldb, double beta, double *c, int ldc);
/* Replaces c by beta c + alpha a b, with a [m x k], b [k x n], c [m x n]. */
void arc_dense_multiply(int m, int n, int k, double alpha, const double *a, int lda,
                        const double *b, int ldb, double beta, double *c, int ldc);
/* Adds n columns of a, each multiplied by its factor, to y. Only rows first .. last - 1 are added.
 * x[k], k < n, is the factor of column at[k], or of column k if `at` is NULL. */
void arc_dense_add_columns(int first, int last, int n, const int *at, const double *a, int lda,
                           const double *x, double *y);
/* Computes the lower triangle of c = a a', with a [n x k], c [n x n]. */
void arc_dense_square(int n, int k, const double *a, int lda, double *c, int ldc);
/* Adds a' a to the lower triangle of c, with a [k x n], c [n x n]. */
void arc_dense_add_square(int n, int k, const double *a, int lda, double *c, int ldc);
/* Solve equations with a general matrix a in two steps. arc_dense_factor replaces a [n x n] by its
 * LU factors and writes pivots [n]; it returns 0, or k > 0 if the matrix is singular.
 * arc_dense_factor_solve, which may be called repeatedly, replaces b [n x count] by a^-1 b. */
int arc_dense_factor(int n, double *a, int *pivots);
void arc_dense_factor_solve(int n, int count, const double *a, const int *pivots, double *b);
/* Computes inverse = (L L')^-1 as a full matrix, with l and inverse [n x n]. */
void arc_dense_cholesky_invert(int n, const double *l, double *inverse);

/* Returns the index of (i, j) in a column-major matrix of leading dimension ld. */
static inline size_t dense_at(int i, int j, int ld) {
  return (size_t)i + (size_t)j * (size_t)ld;
}

#endif

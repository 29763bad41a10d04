/* Implements linear algebra with small dense matrices. LAPACK and BLAS are called by their Fortran
 * names, so that any implementation can be used. */
#include "core/base/dense.h"
#include "core/base/wide.h"

#include <math.h>
#include <string.h>

void dpotrf_(const char *uplo, const int *n, double *a, const int *lda, int *info);
void dpotrs_(const char *uplo, const int *n, const int *nrhs, const double *a, const int *lda,
             double *b, const int *ldb, int *info);
void dpbtrf_(const char *uplo, const int *n, const int *kd, double *ab, const int *ldab, int *info);
void dgetrf_(const int *m, const int *n, double *a, const int *lda, int *ipiv, int *info);
void dgetrs_(const char *trans, const int *n, const int *nrhs, const double *a, const int *lda,
             const int *ipiv, double *b, const int *ldb, int *info);
void dpotri_(const char *uplo, const int *n, double *a, const int *lda, int *info);
void dtrsm_(const char *side, const char *uplo, const char *transa, const char *diag, const int *m,
            const int *n, const double *alpha, const double *a, const int *lda, double *b,
            const int *ldb);
void dsyrk_(const char *uplo, const char *trans, const int *n, const int *k, const double *alpha,
            const double *a, const int *lda, const double *beta, double *c, const int *ldc);
void dgemm_(const char *transa, const char *transb, const int *m, const int *n, const int *k,
            const double *alpha, const double *a, const int *lda, const double *b, const int *ldb,
            const double *beta, double *c, const int *ldc);

int arc_dense_cholesky(int n, double *a, int ld) {
  int info = 0;
  if (n > 0) dpotrf_("L", &n, a, &ld, &info);
  return info;
}

/* Subtracts four columns of L, multiplied by by[0] .. by[3], from `to`. Processing four columns at
 * once reduces memory accesses, which limit the speed of the loop. */
static void subtract_columns(int n, const double *l, int ld, const double by[4], double *to) {
  const double *l1 = l + ld, *l2 = l1 + ld, *l3 = l2 + ld;
#pragma omp simd
  for (int i = 0; i < n; i++)
    to[i] -= (l[i] * by[0] + l1[i] * by[1]) + (l2[i] * by[2] + l3[i] * by[3]);
}

/* Replaces b [count] by l^-1 b for a diagonal block l of L with at most four rows. The divisions
 * are made first, because independent divisions are faster. */
static inline void forward_block(const double *l, int ld, double *b, int count) {
  double scale[4];
  for (int j = 0; j < count; j++) scale[j] = 1 / l[dense_at(j, j, ld)];
  for (int j = 0; j < count; j++) {
    b[j] *= scale[j];
    for (int i = j + 1; i < count; i++) b[i] -= l[dense_at(i, j, ld)] * b[j];
  }
}

static inline void backward_block(const double *l, int ld, double *b, int count) {
  double scale[4];
  for (int j = 0; j < count; j++) scale[j] = 1 / l[dense_at(j, j, ld)];
  for (int j = count - 1; j >= 0; j--) {
    for (int i = j + 1; i < count; i++) b[j] -= l[dense_at(i, j, ld)] * b[i];
    b[j] *= scale[j];
  }
}

/* Subtracts the scalar products of four columns of L with b [n] from the four values from[0] ..
 * from[3]. Even and odd rows are summed separately, which is faster. */
static void subtract_products(int n, const double *l, int ld, const double *b, double from[4]) {
  double sum[4][2] = {{0}};
  for (int i = 0; i + 2 <= n; i += 2)
    for (int q = 0; q < 4; q++)
      for (int c = 0; c < 2; c++) sum[q][c] += l[dense_at(i + c, q, ld)] * b[i + c];
  for (int q = 0; q < 4; q++) {
    if (n % 2) sum[q][0] += l[dense_at(n - 1, q, ld)] * b[n - 1];
    from[q] -= sum[q][0] + sum[q][1];
  }
}

/* Replaces b by (L L')^-1 b for one right-hand side. For the matrix sizes of contact problems it is
 * twice as fast as dtrsm. */
static void solve_one(int n, const double *l, int ld, double *b) {
  const int blocks = n - n % 4;
  for (int j = 0; j < blocks; j += 4) {
    forward_block(&l[dense_at(j, j, ld)], ld, &b[j], 4);
    subtract_columns(n - j - 4, &l[dense_at(j + 4, j, ld)], ld, &b[j], &b[j + 4]);
  }
  forward_block(&l[dense_at(blocks, blocks, ld)], ld, &b[blocks], n - blocks);
  backward_block(&l[dense_at(blocks, blocks, ld)], ld, &b[blocks], n - blocks);
  for (int j = blocks - 4; j >= 0; j -= 4) {
    subtract_products(n - j - 4, &l[dense_at(j + 4, j, ld)], ld, &b[j + 4], &b[j]);
    backward_block(&l[dense_at(j, j, ld)], ld, &b[j], 4);
  }
}

void arc_dense_cholesky_solve(int n, int count, const double *l, int ld, double *b, int ldb) {
  int info = 0;
  if (count == 1)
    solve_one(n, l, ld, b);
  else if (n > 0)
    dpotrs_("L", &n, &count, l, &ld, b, &ldb, &info);
}

void arc_dense_forward(int n, int count, const double *l, int ld, double *b, int ldb) {
  const double one = 1;
  if (n > 0) dtrsm_("L", "L", "N", "N", &n, &count, &one, l, &ld, b, &ldb);
}

int arc_dense_band_cholesky(int n, int band, double *a) {
  const int ld = band + 1;
  int info = 0;
  if (n > 0) dpbtrf_("L", &n, &band, a, &ld, &info);
  return info;
}

/* `sides` right-hand sides are solved together; LAPACK would solve them one by one. Row i of
 * right-hand side c is x[sides * i + c]. Solutions decay within a few band widths outside the
 * nonzero rows of the right-hand sides. Values below `negligible` times the largest value count as
 * zero. */
enum { sides = ARC_DENSE_BAND_SIDES };
static const double negligible = 1e-16;

static int least(int a, int b) {
  return a < b ? a : b;
}

/* Returns the largest absolute value in rows `from` to `to` - 1 of x. */
ARC_WIDE static double row_peak(int from, int to, const double *x) {
  double most[sides] = {0}, largest = 0;
  for (int j = from; j < to; j++)
    for (int c = 0; c < sides; c++) {
      const double size = fabs(x[(size_t)sides * (size_t)j + (size_t)c]);
      most[c] = size > most[c] ? size : most[c];
    }
  for (int c = 0; c < sides; c++) largest = most[c] > largest ? most[c] : largest;
  return largest;
}

/* Returns true if rows `from` to `to` - 1 of x are negligible relative to *peak, the largest value
 * so far. First updates *peak. */
static int fades(int from, int to, const double *x, double *peak) {
  const double largest = row_peak(from, to, x);
  *peak = fmax(*peak, largest);
  return largest <= negligible * *peak;
}

/* Solves row j of a triangular band system. `row` is row j of x, and `others` the `count` rows that
 * are already solved, `step` doubles apart, the farthest first. `l` are their entries of the
 * factor, `stride` apart. All sums of a row remain in registers. */
static inline void solve_row(int count, const double *l, ptrdiff_t stride, const double *others,
                             ptrdiff_t step, double scale, double *row) {
  double v[sides];
  ARC_UNROLL for (int c = 0; c < sides; c++) v[c] = row[c];
  for (int i = 0; i < count; i++, l += stride, others += step) {
    ARC_UNROLL for (int c = 0; c < sides; c++) v[c] -= *l * others[c];
  }
  ARC_UNROLL for (int c = 0; c < sides; c++) row[c] = v[c] * scale;
}

ARC_WIDE static void band_forward(int from, int to, int band, const double *l, double *x) {
  for (int j = from; j < to; j++) {
    const int count = least(band, j);
    solve_row(count, &l[dense_at(count, j - count, band + 1)], band, &x[sides * (j - count)], sides,
              1 / l[dense_at(0, j, band + 1)], &x[sides * j]);
  }
}

ARC_WIDE static void band_backward(int from, int to, int n, int band, const double *l, double *x) {
  for (int j = to - 1; j >= from; j--) {
    const double *column = &l[dense_at(0, j, band + 1)];
    const int count = least(band, n - 1 - j);
    solve_row(count, &column[count], -1, &x[sides * (j + count)], -sides, 1 / column[0],
              &x[sides * j]);
  }
}

/* Solves by forward and backward substitution in blocks of `band` + 1 rows. Each substitution ends
 * when all values of a block are negligible. */
void arc_dense_band_solve(int n, int band, const double *l, double *x, int *from, int *to) {
  int j = *from, over = 0;
  for (double peak = 0; j < n && !over;) {
    const int end = least(j + band + 1, n);
    band_forward(j, end, band, l, x);
    over = fades(j, end, x, &peak) && end >= *to;
    j = end;
  }
  *to = j;
  over = 0;
  for (double peak = 0; j > 0 && !over;) {
    const int start = j - least(j, band + 1);
    band_backward(start, j, n, band, l, x);
    over = fades(start, j, x, &peak) && start <= *from;
    j = start;
  }
  *from = j;
}

/* Adds columns of a, multiplied by x, to y, four columns at a time. */
ARC_WIDE static void add_columns(int first, int last, int n, const int *at, const double *a,
                                 int lda, const double *x, double *y) {
  int s = 0;
  for (; s + 4 <= n; s += 4) {
    const double *a0 = &a[dense_at(0, at ? at[s] : s, lda)];
    const double *a1 = &a[dense_at(0, at ? at[s + 1] : s + 1, lda)];
    const double *a2 = &a[dense_at(0, at ? at[s + 2] : s + 2, lda)];
    const double *a3 = &a[dense_at(0, at ? at[s + 3] : s + 3, lda)];
    const double x0 = x[s], x1 = x[s + 1], x2 = x[s + 2], x3 = x[s + 3];
#pragma omp simd
    for (int k = first; k < last; k++)
      y[k] += (a0[k] * x0 + a1[k] * x1) + (a2[k] * x2 + a3[k] * x3);
  }
  for (; s < n; s++) {
    const double *column = &a[dense_at(0, at ? at[s] : s, lda)];
#pragma omp simd
    for (int k = first; k < last; k++) y[k] += column[k] * x[s];
  }
}

void arc_dense_add_columns(int first, int last, int n, const int *at, const double *a, int lda,
                           const double *x, double *y) {
  add_columns(first, last, n, at, a, lda, x, y);
}

void arc_dense_multiply_transposed(int m, int n, int k, double alpha, const double *a, int lda,
                                   const double *b, int ldb, double beta, double *c, int ldc) {
  dgemm_("T", "N", &m, &n, &k, &alpha, a, &lda, b, &ldb, &beta, c, &ldc);
}

void arc_dense_multiply(int m, int n, int k, double alpha, const double *a, int lda,
                        const double *b, int ldb, double beta, double *c, int ldc) {
  dgemm_("N", "N", &m, &n, &k, &alpha, a, &lda, b, &ldb, &beta, c, &ldc);
}

void arc_dense_square(int n, int k, const double *a, int lda, double *c, int ldc) {
  const double one = 1, zero = 0;
  if (n > 0) dsyrk_("L", "N", &n, &k, &one, a, &lda, &zero, c, &ldc);
}

void arc_dense_add_square(int n, int k, const double *a, int lda, double *c, int ldc) {
  const double one = 1;
  if (n > 0 && k > 0) dsyrk_("L", "T", &n, &k, &one, a, &lda, &one, c, &ldc);
}

int arc_dense_factor(int n, double *a, int *pivots) {
  int info = 0;
  if (n > 0) dgetrf_(&n, &n, a, &n, pivots, &info);
  return info;
}

void arc_dense_factor_solve(int n, int count, const double *a, const int *pivots, double *b) {
  int info = 0;
  if (n > 0) dgetrs_("N", &n, &count, a, &n, pivots, b, &n, &info);
}

void arc_dense_cholesky_invert(int n, const double *l, double *inverse) {
  int info = 0;
  if (n == 0) return;
  memcpy(inverse, l, (size_t)n * (size_t)n * sizeof *l);
  dpotri_("L", &n, inverse, &n, &info);
  for (int j = 0; j < n; j++)
    for (int i = 0; i < j; i++) inverse[dense_at(i, j, n)] = inverse[dense_at(j, i, n)];
}

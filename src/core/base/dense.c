/* Small dense linear algebra on LAPACK and BLAS, through their Fortran symbols (any implementation
 * will do). */
#include "core/base/dense.h"

void dpotrf_(const char *uplo, const int *n, double *a, const int *lda, int *info);
void dpotrs_(const char *uplo, const int *n, const int *nrhs, const double *a, const int *lda,
             double *b, const int *ldb, int *info);
void dpbtrf_(const char *uplo, const int *n, const int *kd, double *ab, const int *ldab, int *info);
void dpbtrs_(const char *uplo, const int *n, const int *kd, const int *nrhs, const double *ab,
             const int *ldab, double *b, const int *ldb, int *info);
void dgesv_(const int *n, const int *nrhs, double *a, const int *lda, int *ipiv, double *b,
            const int *ldb, int *info);
void dtrsm_(const char *side, const char *uplo, const char *transa, const char *diag, const int *m,
            const int *n, const double *alpha, const double *a, const int *lda, double *b,
            const int *ldb);
void dgemm_(const char *transa, const char *transb, const int *m, const int *n, const int *k,
            const double *alpha, const double *a, const int *lda, const double *b, const int *ldb,
            const double *beta, double *c, const int *ldc);

int arc_dense_cholesky(int n, double *a, int ld) {
  int info = 0;
  if (n > 0) dpotrf_("L", &n, a, &ld, &info);
  return info;
}

void arc_dense_cholesky_solve(int n, int count, const double *l, int ld, double *b, int ldb) {
  int info = 0;
  if (n > 0) dpotrs_("L", &n, &count, l, &ld, b, &ldb, &info);
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

void arc_dense_band_solve(int n, int band, int count, const double *l, double *b, int ldb) {
  const int ld = band + 1;
  int info = 0;
  if (n > 0) dpbtrs_("L", &n, &band, &count, l, &ld, b, &ldb, &info);
}

void arc_dense_multiply_transposed(int m, int n, int k, double alpha, const double *a, int lda,
                                   const double *b, int ldb, double beta, double *c, int ldc) {
  dgemm_("T", "N", &m, &n, &k, &alpha, a, &lda, b, &ldb, &beta, c, &ldc);
}

void arc_dense_multiply(int m, int n, int k, double alpha, const double *a, int lda,
                        const double *b, int ldb, double beta, double *c, int ldc) {
  dgemm_("N", "N", &m, &n, &k, &alpha, a, &lda, b, &ldb, &beta, c, &ldc);
}

int arc_dense_solve(int n, double *a, int *pivots, double *x) {
  const int one = 1;
  int info = 0;
  if (n > 0) dgesv_(&n, &one, a, &n, pivots, x, &n, &info);
  return info;
}

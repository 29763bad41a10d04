/* Limits BLAS and OpenMP to one thread. OpenBLAS is called through weak symbols, so that any BLAS
 * can be used. */
#include "archard/base.h"

#include "core/base/dense.h"

#include <omp.h>

extern void openblas_set_num_threads(int count) __attribute__((weak));
extern char *openblas_get_config(void) __attribute__((weak));

const char *arc_single_threaded(void) {
  omp_set_max_active_levels(0);
  if (openblas_set_num_threads) openblas_set_num_threads(1);
  return openblas_get_config ? openblas_get_config() : NULL;
}

/* Makes BLAS allocate its workspace, by calls of routines that need this workspace even for small
 * matrices. */
void arc_reserve_blas(void) {
  enum { N = 64 };
  double a[N * N] = {0}, b[N * N] = {0}, c[N * N] = {0};
  for (int i = 0; i < N; i++) a[i * N + i] = 1;
  arc_dense_multiply(N, N, N, 1, a, N, b, N, 0, c, N);
  arc_dense_cholesky(N, a, N);
}

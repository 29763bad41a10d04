/* One thread for BLAS and OpenMP. OpenBLAS is reached through weak symbols: any BLAS will do. */
#include "archard/base.h"

#include <omp.h>

extern void openblas_set_num_threads(int count) __attribute__((weak));
extern char *openblas_get_config(void) __attribute__((weak));

const char *arc_single_threaded(void) {
  omp_set_max_active_levels(0);
  if (openblas_set_num_threads) openblas_set_num_threads(1);
  return openblas_get_config ? openblas_get_config() : NULL;
}

/* Allocates several arrays of doubles in one block of memory. */
#include "core/base/carve.h"

#include <stdlib.h>

double *arc_carve(const carve_part *part, size_t parts) {
  size_t total = 1;
  for (size_t i = 0; i < parts; i++) total += part[i].count;
  double *block = calloc(total, sizeof *block), *next = block;
  for (size_t i = 0; i < parts; i++) {
    *part[i].at = next;
    if (next) next += part[i].count;
  }
  return block;
}

/* Arrays of doubles in one block of memory. */
#ifndef BASE_CARVE_H
#define BASE_CARVE_H

#include <stddef.h>

/* One array: pointer to set, and length. */
typedef struct carve_part {
  double **at;
  size_t count;
} carve_part;

/* Allocates all parts, in this order and zeroed, as one block that is freed by the first. NULL: out
 * of memory, and all pointers are NULL. */
double *arc_carve(const carve_part *part, size_t parts);
#define ARC_CARVE(part) arc_carve(part, sizeof(part) / sizeof *(part))

#endif

/* Arrays of doubles in one block of memory. */
#ifndef BASE_CARVE_H
#define BASE_CARVE_H

#include <stddef.h>

/* One array: where its address goes, and its length. */
typedef struct carve_part {
  double **at;
  size_t count;
} carve_part;

/* All parts, in this order, zeroed, as one block that is freed by the address of the first. NULL:
 * out of memory, and the addresses are NULL. */
double *arc_carve(const carve_part *part, size_t parts);
#define ARC_CARVE(part) arc_carve(part, sizeof(part) / sizeof *(part))

#endif

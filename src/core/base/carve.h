/* Declares a function that allocates several arrays of doubles in one block of memory. */
#ifndef BASE_CARVE_H
#define BASE_CARVE_H

#include <stddef.h>

/* One array to allocate: the address of its pointer, and its number of doubles. */
typedef struct carve_part {
  double **at;
  size_t count;
} carve_part;

/* Allocates all arrays, in the given order, as one block of zeros. Returns the address of the block
 * and of the first array, which the caller frees. If out of memory, returns NULL and sets all
 * pointers to NULL. */
double *arc_carve(const carve_part *part, size_t parts);
#define ARC_CARVE(part) arc_carve(part, sizeof(part) / sizeof *(part))

#endif

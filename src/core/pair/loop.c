/* Allocates fretting loops. */
#include "core/pair/cycle.h"

#include <stdlib.h>

arc_status arc_loop_create(size_t count, arc_loop **loop, arc_error *error) {
  arc_loop *made = malloc(sizeof *made + 2 * count * sizeof(double));
  if (!made) return arc_fail(error, ARC_MEMORY, "out of memory for a loop");
  double *numbers = (double *)(void *)(made + 1);
  *made = (arc_loop){.count = count, .x = numbers, .tangential = numbers + count};
  *loop = made;
  return ARC_OK;
}

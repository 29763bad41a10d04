/* Enlarges the arrays into which the rows of a query are read, and reads the ids of cases. Arrays
 * grow during reading, because the number of rows may change between a count and the query. */
#include "store/store.h"

#include <limits.h>
#include <stdint.h>
#include <stdlib.h>

void *arc_store_grown(void *block, size_t count, size_t size) {
  enum { LEAST = 16 };
  const int has_capacity = count < LEAST ? count > 0 : (count & (count - 1)) != 0;
  if (has_capacity) return block;
  const size_t capacity = count < LEAST ? LEAST : 2 * count;
  return capacity <= SIZE_MAX / size ? realloc(block, capacity * size) : NULL;
}

arc_status arc_store_id(arc_store *store, query *q, int *id, arc_error *error) {
  const long long whole = arc_query_whole(q, 0);
  if (whole < 1 || whole > INT_MAX)
    return arc_fail(error, ARC_FORMAT,
                    "%s: the file is damaged: expected case numbers from 1, got %lld", store->path,
                    whole);
  *id = (int)whole;
  return ARC_OK;
}

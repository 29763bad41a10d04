/* archard/array.h - named arrays of values at the sites (nodes or cells) of a surface. Runs and
 * run files store profiles, maps and states as such arrays. Their names depend on the kind of
 * model (arc_model_kind_name). Code that stores or compares arrays does not depend on the names. */
#ifndef ARCHARD_ARRAY_H
#define ARCHARD_ARRAY_H

#include "archard/mesh.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* One array of one body after one update. The member `size` is { sites, 1 } for one value at each
 * site, { sites, 2 } for pairs of values, and { 1, 1 } for a single number. */
typedef struct arc_array {
  const char *name; /* name of the array: letters, digits and _, such as "h" */
  arc_body body;
  double update, distance; /* number of the update, and sliding distance [mm] after it */
  size_t size[2];          /* number of rows, and number of values in a row */
  const double *values;    /* [size[0] * size[1]] values, stored row by row; NaN is not allowed */
} arc_array;

/* Returns the number of values of an array. */
size_t arc_array_count(const arc_array *array);

/* Searches `count` arrays for the first one with this body and name. Returns NULL if there is
 * none. */
const arc_array *arc_array_find(const arc_array *arrays, size_t count, arc_body body,
                                const char *name);

/* Copies arrays with their names and values to one block of memory, which the caller frees with
 * free(). Returns NULL if out of memory. */
arc_array *arc_arrays_copy(const arc_array *arrays, size_t count);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

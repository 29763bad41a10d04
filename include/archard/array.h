/* archard/array.h - named arrays over the sites of a surface, as a run hands them out and a run
 * file keeps them: what a profile or a map shows, and the state to go on from. Which names there
 * are is the matter of the kind of body pair; whoever stores, restores or compares them need not
 * know.
 */
#ifndef ARCHARD_ARRAY_H
#define ARCHARD_ARRAY_H

#include "archard/mesh.h"

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

/* One array of one body at one moment. Of sites along a line size is { sites, 1 }, of pairs of
 * numbers at them { sites, 2 }, of a map { sites along z, sites along x }, of a single number { 1,
 * 1 }. */
typedef struct arc_array {
  const char *name; /* "h": a word of letters, digits and _ */
  arc_body body;
  double update, distance; /* when: updates so far, travelled distance [mm] */
  size_t size[2];          /* rows, and numbers in a row; 0 of none */
  const double *values;    /* [size[0] * size[1]], row by row; NaN is no value of any */
} arc_array;

/* How many values it has. */
size_t arc_array_count(const arc_array *array);

/* The array of a body and a name, the first of `count`; NULL: there is none. */
const arc_array *arc_array_find(const arc_array *arrays, size_t count, arc_body body,
                                const char *name);

/* The arrays with their names and values in one block, to be freed with free(); NULL: out of
 * memory. */
arc_array *arc_arrays_copy(const arc_array *arrays, size_t count);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif
#endif

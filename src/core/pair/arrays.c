/* Copies and searches lists of named arrays. */
#include "archard/array.h"

#include <stdlib.h>
#include <string.h>

size_t arc_array_count(const arc_array *array) {
  return array->size[0] * array->size[1];
}

const arc_array *arc_array_find(const arc_array *arrays, size_t count, arc_body body,
                                const char *name) {
  for (size_t i = 0; i < count; i++)
    if (arrays[i].body == body && strcmp(arrays[i].name, name) == 0) return &arrays[i];
  return NULL;
}

/* Copies the arrays to one block: first the list, then the values, then the names, each aligned. */
arc_array *arc_arrays_copy(const arc_array *arrays, size_t count) {
  size_t values = 0, letters = 1;
  for (size_t i = 0; i < count; i++) {
    values += arc_array_count(&arrays[i]);
    letters += strlen(arrays[i].name) + 1;
  }
  arc_array *block = malloc(count * sizeof *block + values * sizeof(double) + letters);
  if (!block) return NULL;
  double *value = (double *)(void *)(block + count);
  char *letter = (char *)(value + values);
  for (size_t i = 0; i < count; i++) {
    const size_t n = arc_array_count(&arrays[i]);
    block[i] = arrays[i];
    block[i].name = strcpy(letter, arrays[i].name);
    block[i].values = n > 0 ? memcpy(value, arrays[i].values, n * sizeof *value) : value;
    letter += strlen(letter) + 1;
    value += n;
  }
  return block;
}

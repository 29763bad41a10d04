/* Implements lists whose memory grows as items are added. */
#include "core/base/list.h"

#include <stdlib.h>
#include <string.h>

void *arc_list_add(item_list *list, size_t size) {
  if (list->count == list->capacity) {
    const int capacity = list->capacity > 0 ? 2 * list->capacity : 64;
    void *more = realloc(list->data, (size_t)capacity * size);
    if (!more) return NULL;
    list->data = more;
    list->capacity = capacity;
  }
  void *item = (char *)list->data + (size_t)list->count++ * size;
  return memset(item, 0, size);
}

void arc_list_sort(item_list *list, size_t size, int (*compare)(const void *, const void *)) {
  if (list->count > 0) qsort(list->data, (size_t)list->count, size, compare);
}

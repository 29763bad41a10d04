/* Declares lists whose memory grows as items are added. */
#ifndef BASE_LIST_H
#define BASE_LIST_H

#include <stddef.h>

/* A list of items of equal size. The caller frees `data`. */
typedef struct item_list {
  void *data;
  int count, capacity;
} item_list;

/* Appends an item of `size` zero bytes and returns its address, or NULL if out of memory. */
void *arc_list_add(item_list *list, size_t size);
void arc_list_sort(item_list *list, size_t size, int (*compare)(const void *, const void *));

#endif

/* Memory: how much there is, and release of arrays that are const to their readers. */
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H

/* Memory [bytes] available to this process by machine, control group and limits; INFINITY if
 * unknown. */
double arc_memory_free(void);

/* free() for an allocated array that a public struct shows as const; for its owner alone. */
void arc_memory_release(const void *array);

#endif

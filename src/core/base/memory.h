/* Available memory, and release of arrays that are const to their readers. */
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H

/* Returns the memory [bytes] available to this process by machine, control group and limits;
 * INFINITY if it is unknown. */
double arc_memory_free(void);

/* Frees an allocated array that a public struct shows as const; only its owner calls this. */
void arc_memory_release(const void *array);

#endif

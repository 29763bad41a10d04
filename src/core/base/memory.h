/* Available memory, and release of arrays that are const to their readers. */
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H

/* Returns the memory [bytes] that is available to this process: the smallest value of the machine,
 * the control group and the process limits, or INFINITY if all are unknown. */
double arc_memory_free(void);

/* Frees an allocated array that a public struct shows as const; only its owner calls this. */
void arc_memory_release(const void *array);

#endif

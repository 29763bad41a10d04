/* Declares functions that return the available memory and free const arrays. */
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H

/* Returns the memory [bytes] that is available to this process: the smallest of the values for the
 * machine, the control group and the process limits, or INFINITY if all are unknown. */
double arc_memory_free(void);

/* Frees an allocated array to which a public struct has a const pointer. Only the owner of the
 * array may call this function. */
void arc_memory_release(const void *array);

#endif

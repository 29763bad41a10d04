/* How much memory there is to take. */
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H

/* Bytes that this process can still have: of the machine, of its control group, of its limits.
 * INFINITY where nothing tells. */
double arc_memory_free(void);

#endif

/* Limits the memory that this process and its children may map. The children's parts are subtracted
 * from the limit of this process while they run. */
#ifndef SYSTEM_MEMORY_LIMIT_H
#define SYSTEM_MEMORY_LIMIT_H

#include <sys/resource.h>
#include <sys/types.h>

/* Sets the limit to the present size of this process plus `bytes`. Without it the functions below
 * have no effect. */
void arc_memory_limit_set(double bytes);

/* Data [bytes] of this process when the limit was set: buffers of its libraries (128 MiB of
 * OpenBLAS), which a child needs as well. */
rlim_t arc_memory_limit_base(void);

/* Reserves a share of the memory left for a child that is about to start. Returns bytes + 1; 0:
 * no limit. */
rlim_t arc_memory_limit_reserve(double part);

/* Assigns a reservation to a started child; child 0: none was started, so it is released. */
void arc_memory_limit_assign(rlim_t bytes, pid_t child);
/* Releases the reservation of a child that has ended. */
void arc_memory_limit_release(pid_t child);

#endif

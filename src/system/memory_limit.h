/* Limits the memory that this process and its children may map. While a child runs, its part is
 * subtracted from the limit of this process. */
#ifndef SYSTEM_MEMORY_LIMIT_H
#define SYSTEM_MEMORY_LIMIT_H

#include <sys/resource.h>
#include <sys/types.h>

/* Sets the limit to the present size of this process plus `bytes`. Without this call the functions
 * below have no effect. */
void arc_memory_limit_set(double bytes);

/* Returns the size of this process's data when the limit was set [bytes]. It includes buffers of
 * libraries (128 MiB of OpenBLAS), which a child needs as well. */
rlim_t arc_memory_limit_base(void);

/* Reserves a fraction of the remaining memory for a child that is about to start. Returns the
 * reserved bytes plus 1, or 0 if there is no limit. */
rlim_t arc_memory_limit_reserve(double part);

/* Assigns a reservation to a started child. If `child` is 0, no child was started and the
 * reservation is released. */
void arc_memory_limit_assign(rlim_t bytes, pid_t child);
/* Releases the reservation of a child that has ended. */
void arc_memory_limit_release(pid_t child);

#endif

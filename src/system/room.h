/* system/room.h - memory that this process and its children have together. */
#ifndef SYSTEM_ROOM_H
#define SYSTEM_ROOM_H

#include <sys/resource.h>
#include <sys/types.h>

/* From now on this process may map so many bytes more, and what it lends to children is taken from
 * them. Before, and without it, nothing here does anything. */
void arc_room_limit(double bytes);

/* Data [bytes] that this process had when its limit began: its libraries' buffers (128 MiB of
 * OpenBLAS), which a child needs as well. */
rlim_t arc_room_own(void);

/* Takes a part of what is left, for a child that is about to start; 0: without limit. */
rlim_t arc_room_take(double part);

/* The child that has got it, or 0 where none was started; and that it has ended. */
void arc_room_lend(rlim_t bytes, pid_t child);
void arc_room_return(pid_t child);

#endif

/* archard/lock.h - how programs that share a file keep out of each other's way, also on disks
 * without locks. */
#ifndef ARCHARD_LOCK_H
#define ARCHARD_LOCK_H

#include "archard/base.h"

#include <sys/types.h>

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

typedef enum arc_lock_kind {
  ARC_LOCK_SYSTEM,  /* the system's locks */
  ARC_LOCK_BY_NAME, /* the disk has none (NFS without its lock daemon, Lustre as usual): FILE.lock
                     */
  ARC_LOCK_NONE     /* nor can a file be made beside it: to be read as it stands */
} arc_lock_kind;

/* What a file can be locked with. Messages call it `name`. ARC_IO: the disk does not answer. */
arc_status arc_lock_look(const char *path, const char *name, arc_lock_kind *kind, arc_error *error);

/* A lock by its name: a link to nothing, which says in its text whose it is. One whose program was
 * killed, on this system, is taken over. As mkdir and rmdir: 0, or -1 and errno. */
int arc_lock_take(const char *lock, mode_t ignored);
int arc_lock_leave(const char *lock);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif

/* archard/lock.h - locks for files shared by several programs, also on disks without file locks. */
#ifndef ARCHARD_LOCK_H
#define ARCHARD_LOCK_H

#include "archard/base.h"

#include <sys/types.h>

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

typedef enum arc_lock_kind {
  ARC_LOCK_SYSTEM,  /* locks of the operating system */
  ARC_LOCK_BY_NAME, /* a lock file FILE.lock, because the disk supports no locks (NFS without a lock
                       daemon, Lustre by default) */
  ARC_LOCK_NONE     /* no lock, because the disk supports no locks and the folder is read-only */
} arc_lock_kind;

/* Determines the kind of lock that the disk of a file supports. `path` is absolute; `name` is used
 * in messages. ARC_IO: the disk does not respond. */
arc_status arc_lock_look(const char *path, const char *name, arc_lock_kind *kind, arc_error *error);

/* The first function creates a lock file, and the second removes it. The lock file is a symbolic
 * link whose target is the name of the program that owns the lock. A lock of a killed program on
 * this computer is replaced. Like mkdir and rmdir, both functions return 0, or -1 and set errno. */
int arc_lock_take(const char *lock, mode_t ignored);
int arc_lock_leave(const char *lock);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif

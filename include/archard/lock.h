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
  ARC_LOCK_BY_NAME, /* a file FILE.lock, as the disk has no locks (NFS without lock daemon, Lustre
                       by default) */
  ARC_LOCK_NONE     /* no lock, as the disk has no locks and the folder is read-only */
} arc_lock_kind;

/* Determines the kind of lock that the disk of a file supports. `path` is absolute; `name` is used
 * in messages. ARC_IO: the disk does not respond. */
arc_status arc_lock_look(const char *path, const char *name, arc_lock_kind *kind, arc_error *error);

/* Create and remove a lock file. It is a symbolic link whose target is a text that identifies the
 * program that owns the lock. The lock of a killed program of this system is replaced. Like mkdir
 * and rmdir, the functions return 0, or -1 and set errno. */
int arc_lock_take(const char *lock, mode_t ignored);
int arc_lock_leave(const char *lock);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif

/* system/jail.h - restrictions of this process and its children by the operating system. */
#ifndef SYSTEM_JAIL_H
#define SYSTEM_JAIL_H

/* A folder in which files may be read, a folder in which files may be written, and a program that
 * may be run in addition to this program. Each is a path or NULL. */
typedef struct arc_jail {
  const char *read, *write, *program;
  double largest_file; /* limit of the size of a file [bytes] */
} arc_jail;

/* Restrictions that a jail guarantees, as flags. */
enum {
  ARC_JAIL_FILES = 1,    /* no other files are opened, created, renamed, removed or run */
  ARC_JAIL_CALLS = 2,    /* no connections, access to other processes, mounts or new rights */
  ARC_JAIL_PROCESSES = 4 /* at most a few hundred processes and threads */
};

/* Restricts the calling thread and all its later children. arc_child_again must be called
 * afterwards, because existing threads are not restricted. Returns the flags of the restrictions
 * that this system cannot guarantee. */
int arc_jail_enter(const arc_jail *jail);

/* Limits a resource (RLIMIT_...) of the process to `most`, also the hard limit, so that the process
 * cannot raise it again. Returns true on success. Writes only to the stack. */
int arc_jail_limit(int resource, double most);

/* Prevents the calling thread, and the program that it executes, from starting processes and from
 * access to its parent; it can still start threads. Returns 1, or 0 if the system has no such
 * filter. Writes only to the stack. */
int arc_jail_alone(void);

#endif

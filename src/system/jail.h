/* system/jail.h - restrictions of this process and its children by the operating system. */
#ifndef SYSTEM_JAIL_H
#define SYSTEM_JAIL_H

/* Folders where files may be read and written, and programs that may be run in addition to this
 * one: a path, or NULL. */
typedef struct arc_jail {
  const char *read, *write, *program;
  double largest_file; /* [bytes] */
} arc_jail;

/* Guarantees of a jail. */
enum {
  ARC_JAIL_FILES = 1, /* no other file is opened, created, renamed, removed or run */
  ARC_JAIL_CALLS = 2, /* no connections, no access to other processes, no mounts, no new rights */
  ARC_JAIL_PROCESSES = 4 /* no more than some hundred processes and threads */
};

/* Restricts the calling thread and all its later children. Call arc_child_again afterwards, since
 * existing threads are not restricted. Returns the guarantees that this system cannot keep. */
int arc_jail_enter(const arc_jail *jail);

/* The calling thread, and the program it executes, can start threads but no processes from now on.
 * Returns 1, or 0 if the system has no such filter. Writes only to the stack. */
int arc_jail_alone(void);

#endif

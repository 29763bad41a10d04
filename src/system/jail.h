/* system/jail.h - what the system itself keeps this process, and all that it starts, from. */
#ifndef SYSTEM_JAIL_H
#define SYSTEM_JAIL_H

/* Where files may be read and written, and what else may be run than this program: a path, or NULL.
 */
typedef struct arc_jail {
  const char *read, *write, *program;
  double largest_file; /* [bytes] */
} arc_jail;

/* What a jail promises. */
enum {
  ARC_JAIL_FILES = 1, /* no other file is opened, made, renamed, removed or run */
  ARC_JAIL_CALLS =
      2, /* no connections, no looking into other processes, no mounts, no new rights */
  ARC_JAIL_PROCESSES = 4 /* no more than some hundred processes and threads */
};

/* Closes the jail around the calling thread and all that it starts from now on: to be followed by
 * arc_child_again, since threads that are there already stay outside. Returns the promises that
 * this system cannot keep. */
int arc_jail_enter(const arc_jail *jail);

#endif
